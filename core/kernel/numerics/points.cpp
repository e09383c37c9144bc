// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/points.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace palmer {

void Points::append(PointsView more) {
    x.insert(x.end(), more.x.begin(), more.x.end());
    y.insert(y.end(), more.y.begin(), more.y.end());
}

Point direction(double degrees) {
    // Reduced to ±45° before the conversion, so that the rounding of π is never multiplied by a large angle.
    int quarter = 0;
    const double rest = std::remquo(degrees, 90, &quarter) * (std::numbers::pi / 180);
    const double c = std::cos(rest);
    const double s = std::sin(rest);
    switch (static_cast<unsigned>(quarter) % 4U) { // remquo returns the last bits in two's complement
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

Points polarPoints(std::span<const double> degrees, std::span<const double> radii) {
    assert(degrees.size() == radii.size());
    Points points;
    points.x.reserve(degrees.size());
    points.y.reserve(degrees.size());
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const Point u = direction(degrees[i]);
        points.x.push_back(radii[i] * u.x);
        points.y.push_back(radii[i] * u.y);
    }
    return points;
}

} // namespace palmer
