// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// Curve of a drift test: deviations at rest (µm; rotary: arc seconds) over time (s; from 10 minutes min,
/// from 10 hours h), with E_VE = max − min as a dimension between the two readings that define it. `test`
/// holds a DriftMeasurement and `evaluation` is its evaluation; otherwise throws std::bad_variant_access.
/// Without readings an empty figure.
[[nodiscard]] CurveFigure driftFigure(const Test &test, const TestEvaluation &evaluation,
                                      const Language &language);

} // namespace palmer
