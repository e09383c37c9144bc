// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <span>

namespace palmer::iso230_4 {

/// A point as seen from a centre.
struct PolarPoint {
    double angle = 0;    ///< radians, −π … π
    double distance = 0; ///< mm
};

[[nodiscard]] PolarPoint polarPoint(Point point, Point centre);

/// Distance of a closed path at an angle, interpolated; `path` sorted by angle and not empty.
[[nodiscard]] double distanceAt(std::span<const PolarPoint> path, double angle);

/// max |r_first − r_second| about a centre over the angles of all points, mm; between the points of the other
/// path r is interpolated. No path is empty.
[[nodiscard]] double largestDifference(PointsView first, PointsView second, Point centre);

} // namespace palmer::iso230_4
