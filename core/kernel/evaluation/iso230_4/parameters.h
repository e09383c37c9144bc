// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <optional>

/// Computation of the results of a circular test from its circles. Values in mm; null if unavailable.
namespace palmer::iso230_4 {

/// G of a path: width of its minimum zone circles, or range about its least squares circle, as chosen.
std::optional<double> deviationOfPath(const CircularCase &test, const EvaluatedPath *path);
/// G(b): the same for the points of both paths about one centre.
std::optional<double> deviationOfPair(const CircularCase &test, const EvaluatedPath *);
/// Fmax = max(r) − R + C about the chosen centre: of the set-up, or of the path's least squares circle (full
/// circles only). Refused if the reference length is not calibrated.
std::optional<double> largestRadialDeviation(const CircularCase &test, const EvaluatedPath *path);
std::optional<double> smallestRadialDeviation(const CircularCase &test, const EvaluatedPath *path); ///< Fmin
/// D = R_LSC(both paths with equal weight) − R + C; full circles only. Refused like F.
std::optional<double> meanRadialDeviation(const CircularCase &test, const EvaluatedPath *);
/// H (1996) = max over θ of |r_ccw − r_cw| about the common least squares centre; r is interpolated between
/// the points of the other path.
std::optional<double> hysteresis(const CircularCase &test, const EvaluatedPath *);

} // namespace palmer::iso230_4
