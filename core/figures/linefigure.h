// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// Temperatures of the sensors that have a series, over time (h, from the first of all values; °C). Several
/// sensors are numbered in the order of the test. No lines if no sensor has two values. Long series keep the
/// first, least, greatest and last value of each of 500 parts of the time.
[[nodiscard]] LineFigure temperatureFigure(const std::vector<Sensor> &sensors, const Language &language);

/// Means of each direction as measured, overlaid by the prediction after compensation. `before` and `after`
/// evaluate `test` and the same test with the compensation applied; both hold PositioningResults. Targets
/// without a mean are left out.
[[nodiscard]] LineFigure compensationFigure(const Test &test, const TestEvaluation &before,
                                            const TestEvaluation &after, const Language &language);

} // namespace palmer
