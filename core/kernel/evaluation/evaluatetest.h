// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

namespace palmer {

/// Returns the edition a test is evaluated under: `asked` if it is for the test's kind, otherwise the test's
/// own; null for drift tests.
[[nodiscard]] const Edition *editionFor(const Test &test, const Edition *asked);

/// Evaluates a test under its own edition, or under `asked` of the same kind (a view: results, no verdicts).
/// Pure and total. Statistics → correction to 20 °C → parameters → requirements → limits.
[[nodiscard]] TestEvaluation evaluateTest(const Test &test, const Surroundings &surroundings,
                                          const Edition *asked = nullptr);

/// Evaluates a positioning test. Precondition: `test.measurement` holds a PositioningMeasurement and
/// `edition` is one of ISO 230-2 or related standards.
[[nodiscard]] TestEvaluation evaluatePositioning(const Test &test, const Surroundings &surroundings,
                                                 const Edition &edition);

/// Evaluates a circular test. Precondition: `test.measurement` holds a CircularMeasurement and `edition` is
/// one of ISO 230-4.
[[nodiscard]] TestEvaluation evaluateCircular(const Test &test, const Surroundings &surroundings,
                                              const Edition &edition);

} // namespace palmer
