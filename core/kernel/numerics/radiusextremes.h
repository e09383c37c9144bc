// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <cstddef>

namespace palmer {

/// Extremes of the squared distances of a run of points from a centre, mm².
struct SquaredRange {
    double least;
    double greatest;
    double sum; ///< Not finite if a coordinate is not.
};

/// Returns extremes and sum of d = ((x − x_o) − x_c)² + ((y − y_o) − y_c)² of `size` points. Subtracting a
/// nearby origin first keeps the centre finer than the step of large coordinates. All code that computes d as
/// `squaredDistance` gets the same bits. Without points: least is +∞, greatest −∞, sum 0.
[[nodiscard]] SquaredRange squaredRange(const double *x, const double *y, std::size_t size, Point origin,
                                        Point centre);

[[nodiscard]] inline double squaredDistance(double x, double y, Point origin, Point centre) {
    const double dx = (x - origin.x) - centre.x;
    const double dy = (y - origin.y) - centre.y;
    return dx * dx + dy * dy;
}

/// Returns the index of the first point whose squared distance is exactly `value`; `size` if there is none.
[[nodiscard]] std::size_t findSquaredDistance(const double *x, const double *y, std::size_t size,
                                              Point origin, Point centre, double value);

/// Smallest and greatest distance of points from a centre, mm, with the first point at each.
struct RadiusExtremes {
    double inner = 0;
    double outer = 0;
    std::size_t nearest = 0;
    std::size_t farthest = 0;
    bool finite = true; ///< False: a coordinate is not finite, the numbers are meaningless.
};

/// Returns min and max of r = |P − (origin + centre)|; `origin` only improves precision (see squaredRange).
/// All zero without points.
[[nodiscard]] RadiusExtremes radiusExtremes(PointsView points, Point centre, Point origin = {});

} // namespace palmer
