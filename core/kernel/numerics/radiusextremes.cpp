// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/radiusextremes.h"

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace palmer {

SquaredRange squaredRange(const double *x, const double *y, std::size_t size, Point origin, Point centre) {
    // Four at a time in two registers each: the compiler keeps the extremes out of memory, and both chains of
    // comparisons run in parallel.
    using Lanes = Eigen::Array<double, 4, 1>;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Lanes least = Lanes::Constant(infinity);
    Lanes greatest = Lanes::Constant(-infinity);
    Lanes sum = Lanes::Zero();
    std::size_t i = 0;
    for (; i + 4 <= size; i += 4) {
        const Lanes dx = (Eigen::Map<const Lanes>(x + i) - origin.x) - centre.x;
        const Lanes dy = (Eigen::Map<const Lanes>(y + i) - origin.y) - centre.y;
        const Lanes d = dx * dx + dy * dy;
        least = least.min(d);
        greatest = greatest.max(d);
        sum += d;
    }
    SquaredRange range{least.minCoeff(), greatest.maxCoeff(), sum.sum()};
    for (; i < size; ++i) {
        const double d = squaredDistance(x[i], y[i], origin, centre);
        range.least = std::min(range.least, d);
        range.greatest = std::max(range.greatest, d);
        range.sum += d;
    }
    return range;
}

std::size_t findSquaredDistance(const double *x, const double *y, std::size_t size, Point origin,
                                Point centre, double value) {
    std::size_t i = 0;
    while (i < size && squaredDistance(x[i], y[i], origin, centre) != value)
        ++i;
    return i;
}

RadiusExtremes radiusExtremes(PointsView points, Point centre, Point origin) {
    assert(points.x.size() == points.y.size());
    RadiusExtremes extremes;
    if (points.size() == 0)
        return extremes;
    // The index is searched once, in the block that contains the extreme.
    constexpr std::size_t block = 1024;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    double sum = 0;
    std::size_t leastBlock = 0;
    std::size_t greatestBlock = 0;
    for (std::size_t begin = 0; begin < points.size(); begin += block) {
        const std::size_t size = std::min(block, points.size() - begin);
        const SquaredRange range =
            squaredRange(points.x.data() + begin, points.y.data() + begin, size, origin, centre);
        if (range.least < least) {
            least = range.least;
            leastBlock = begin;
        }
        if (range.greatest > greatest) {
            greatest = range.greatest;
            greatestBlock = begin;
        }
        sum += range.sum;
    }
    if (!std::isfinite(sum)) {
        extremes.finite = false;
        return extremes;
    }
    const auto find = [&](std::size_t begin, double value) {
        const std::size_t size = std::min(block, points.size() - begin);
        return begin + findSquaredDistance(points.x.data() + begin, points.y.data() + begin, size, origin,
                                           centre, value);
    };
    extremes.inner = std::sqrt(least);
    extremes.outer = std::sqrt(greatest);
    extremes.nearest = find(leastBlock, least);
    extremes.farthest = find(greatestBlock, greatest);
    return extremes;
}

} // namespace palmer
