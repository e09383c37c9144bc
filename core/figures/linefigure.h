// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// The temperatures of the sensors with a series over time (h, from the first of all values; °C). Several
/// sensors are numbered in the order of the test. No lines where no sensor has a series of two values. Of
/// long series the first, least, greatest and last value of each of 500 parts of the time are kept.
[[nodiscard]] LineFigure temperatureFigure(const std::vector<Sensor> &sensors, const Language &language);

/// The means of each direction as measured, and over them as a compensation is predicted to leave them.
/// `before` and `after` are evaluations of `test` and of the same test with the compensation applied; both
/// hold PositioningResults. Targets without a mean are left out.
[[nodiscard]] LineFigure compensationFigure(const Test &test, const TestEvaluation &before,
                                            const TestEvaluation &after, const Language &language);

} // namespace palmer
