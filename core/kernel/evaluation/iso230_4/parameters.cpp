// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/parameters.h"

#include "kernel/evaluation/iso230_4/circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace palmer::iso230_4 {

namespace {

std::optional<double> width(const CircularCase &test, CircleOf of) {
    const CircleResult *circle = test.results.circle(of, test.measurement.referenceCircle);
    return circle ? std::optional(circle->width) : std::nullopt;
}

/// Smallest and largest distance from the centre F is measured about, mm.
std::optional<Interval> distances(const CircularCase &test, const EvaluatedPath &path) {
    if (test.notCalibrated() || path.source.empty())
        return std::nullopt;
    if (test.measurement.centring == Centring::leastSquares) {
        const CircleResult *circle = test.results.circle(circleOf(path.sense), ReferenceCircle::leastSquares);
        if (!path.fullCircle || !circle)
            return std::nullopt;
        return Interval{circle->innerRadius, circle->outerRadius};
    }
    const auto &deviations = test.measurement.arcs[path.arc].radialDeviations;
    Interval result{deviations[path.source.front()], deviations[path.source.front()]};
    for (const std::size_t i : path.source) {
        result.from = std::min(result.from, deviations[i]);
        result.to = std::max(result.to, deviations[i]);
    }
    return Interval{test.measurement.nominalRadius + result.from, test.measurement.nominalRadius + result.to};
}

double corrected(const CircularCase &test, double radius) {
    return radius - test.measurement.nominalRadius + test.results.correction.value_or(0);
}

struct PolarPoint {
    double angle = 0;    ///< radians, −π … π
    double distance = 0; ///< mm
};

std::vector<PolarPoint> polar(const Points &points, Point centre) {
    std::vector<PolarPoint> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points.x[i] - centre.x;
        const double y = points.y[i] - centre.y;
        result.push_back({std::atan2(y, x), std::hypot(x, y)});
    }
    std::ranges::sort(result, {}, &PolarPoint::angle);
    return result;
}

/// Distance of a closed path at an angle, interpolated; `path` sorted by angle and not empty.
double distanceAt(const std::vector<PolarPoint> &path, double angle) {
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

double largestDifference(const std::vector<PolarPoint> &from, const std::vector<PolarPoint> &to) {
    double result = 0;
    for (const PolarPoint &point : from)
        result = std::max(result, std::abs(point.distance - distanceAt(to, point.angle)));
    return result;
}

} // namespace

std::optional<double> deviationOfPath(const CircularCase &test, const EvaluatedPath *path) {
    return width(test, circleOf(path->sense));
}

std::optional<double> deviationOfPair(const CircularCase &test, const EvaluatedPath *) {
    return width(test, CircleOf::both);
}

std::optional<double> largestRadialDeviation(const CircularCase &test, const EvaluatedPath *path) {
    const auto found = distances(test, *path);
    return found ? std::optional(corrected(test, found->to)) : std::nullopt;
}

std::optional<double> smallestRadialDeviation(const CircularCase &test, const EvaluatedPath *path) {
    const auto found = distances(test, *path);
    return found ? std::optional(corrected(test, found->from)) : std::nullopt;
}

std::optional<double> meanRadialDeviation(const CircularCase &test, const EvaluatedPath *) {
    const CircleResult *circle = test.results.circle(CircleOf::both, ReferenceCircle::leastSquares);
    if (!circle || !test.twoFullCircles() || test.notCalibrated())
        return std::nullopt;
    return corrected(test, circle->radius);
}

std::optional<double> hysteresis(const CircularCase &test, const EvaluatedPath *) {
    const CircleResult *circle = test.results.circle(CircleOf::both, ReferenceCircle::leastSquares);
    if (!circle || !test.twoFullCircles())
        return std::nullopt;
    const auto first = polar(test.results.paths[0].points, circle->centre);
    const auto second = polar(test.results.paths[1].points, circle->centre);
    return std::max(largestDifference(first, second), largestDifference(second, first));
}

} // namespace palmer::iso230_4
