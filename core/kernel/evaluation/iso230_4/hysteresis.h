// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <span>

namespace palmer::iso230_4 {

/// A point in polar coordinates about a centre.
struct PolarPoint {
    double angle = 0;    ///< radians, −π … π
    double distance = 0; ///< mm
};

[[nodiscard]] PolarPoint polarPoint(Point point, Point centre);

/// Returns the interpolated distance of a closed path. Precondition: `path` sorted by angle, not empty.
[[nodiscard]] double distanceAt(std::span<const PolarPoint> path, double angle);

/// Returns max |r_first − r_second| about a centre over the angles of all points, mm; r is interpolated
/// between the points of the other path. Precondition: no path is empty.
[[nodiscard]] double largestDifference(PointsView first, PointsView second, Point centre);

} // namespace palmer::iso230_4
