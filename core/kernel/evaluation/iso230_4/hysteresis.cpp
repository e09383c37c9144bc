// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/hysteresis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace palmer::iso230_4 {

namespace {

std::vector<PolarPoint> polar(PointsView points, Point centre) {
    std::vector<PolarPoint> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(polarPoint(points[i], centre));
    std::ranges::sort(result, {}, &PolarPoint::angle);
    return result;
}

double largestDifference(const std::vector<PolarPoint> &from, const std::vector<PolarPoint> &to) {
    double result = 0;
    for (const PolarPoint &point : from)
        result = std::max(result, std::abs(point.distance - distanceAt(to, point.angle)));
    return result;
}

} // namespace

PolarPoint polarPoint(Point point, Point centre) {
    const double x = point.x - centre.x;
    const double y = point.y - centre.y;
    return {std::atan2(y, x), std::hypot(x, y)};
}

double distanceAt(std::span<const PolarPoint> path, double angle) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto above = std::ranges::lower_bound(path, angle, {}, &PolarPoint::angle);
    PolarPoint next = above == path.end() ? path.front() : *above;
    PolarPoint before = above == path.begin() ? path.back() : *(above - 1);
    if (above == path.end())
        next.angle += turn;
    if (above == path.begin())
        before.angle -= turn;
    const double step = next.angle - before.angle;
    const double part = step > 0 ? (angle - before.angle) / step : 1;
    return before.distance + part * (next.distance - before.distance);
}

double largestDifference(PointsView first, PointsView second, Point centre) {
    const auto one = polar(first, centre);
    const auto other = polar(second, centre);
    return std::max(largestDifference(one, other), largestDifference(other, one));
}

} // namespace palmer::iso230_4
