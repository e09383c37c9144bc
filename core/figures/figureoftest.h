// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// The figure that a test of its kind is looked at by: deviations over the targets, both senses of a circle,
/// drift over time. `evaluation` is that of the test.
[[nodiscard]] Figure figureOfTest(const Test &test, const TestEvaluation &evaluation,
                                  const Language &language);

} // namespace palmer
