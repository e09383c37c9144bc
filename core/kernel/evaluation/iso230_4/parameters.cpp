// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/parameters.h"

#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/hysteresis.h"

#include <algorithm>
#include <span>

namespace palmer::iso230_4 {

namespace {

std::optional<double> width(const CircularCase &test, CircleOf of) {
    const CircleResult *circle = test.results.circle(of, test.measurement.referenceCircle);
    return circle ? std::optional(circle->width) : std::nullopt;
}

/// Range of the values at the places. Precondition: places is not empty.
Interval extremes(std::span<const double> values, std::span<const std::size_t> places) {
    Interval result{values[places.front()], values[places.front()]};
    for (const std::size_t place : places)
        result = {std::min(result.from, values[place]), std::max(result.to, values[place])};
    return result;
}

/// Returns the smallest and largest distance from the centre of F, mm.
std::optional<Interval> distances(const CircularCase &test, const EvaluatedPath &path) {
    if (test.notCalibrated() || path.source.empty())
        return std::nullopt;
    if (test.measurement.centring == Centring::leastSquares) {
        const CircleResult *circle = test.results.circle(circleOf(path.sense), ReferenceCircle::leastSquares);
        if (!path.fullCircle || !circle)
            return std::nullopt;
        return Interval{circle->innerRadius, circle->outerRadius};
    }
    const Interval result = extremes(test.measurement.arcs[path.arc].radialDeviations, path.source);
    return Interval{test.measurement.nominalRadius + result.from, test.measurement.nominalRadius + result.to};
}

double corrected(const CircularCase &test, double radius) {
    return radius - test.measurement.nominalRadius + test.results.correction.value_or(0);
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
    return largestDifference(test.results.paths[0].points.view(), test.results.paths[1].points.view(),
                             circle->centre);
}

} // namespace palmer::iso230_4
