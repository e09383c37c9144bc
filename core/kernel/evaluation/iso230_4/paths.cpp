// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/paths.h"

#include "kernel/numerics/angles.h"
#include "kernel/numerics/centringerror.h"
#include "kernel/numerics/runinbackground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <utility>

namespace palmer::iso230_4 {

namespace {

constexpr double largestClosing = 2; ///< times the largest inner step
constexpr double largestStep = 4;    ///< times the median step; larger ones are holes
constexpr double mostHoles = 90;     ///< degrees, of a full circle

/// Angles and distances from the programmed centre of the evaluated part of an arc.
struct Selection {
    std::vector<double> angles;    ///< degrees
    std::vector<double> distances; ///< mm
    std::vector<std::size_t> source;

    [[nodiscard]] CommandedArc commanded() const { return {angles, distances}; }
};

Selection selection(const Arc &arc, double nominalRadius) {
    Selection result;
    const auto range = evaluatedRange(arc);
    if (!range)
        return result;
    result.angles.reserve(arc.angles.size());
    result.distances.reserve(arc.angles.size());
    for (std::size_t i = 0; i < arc.angles.size(); ++i) {
        if (arc.angles[i] < range->from || arc.angles[i] > range->to)
            continue;
        result.angles.push_back(arc.angles[i]);
        result.distances.push_back(nominalRadius + arc.radialDeviations[i]);
        result.source.push_back(i);
    }
    return result;
}

/// Returns the degrees of a circle not covered by points.
double holes(std::vector<double> steps) {
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    const double largest = largestStep * *middle;
    double sum = 0;
    for (const double step : steps)
        sum += step > largest ? step : 0;
    return sum;
}

void measureExtent(EvaluatedPath &path, std::vector<double> angles) {
    if (angles.size() > 1 && angles.back() < angles.front())
        std::ranges::reverse(angles);
    if (!std::ranges::is_sorted(angles)) // usually sorted: avoids n·log n
        std::ranges::sort(angles);
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    if (angles.size() < 2)
        return;
    const double span = angles.back() - angles.front();
    const double closing = fullTurn - span;
    std::vector<double> steps; // the inner steps, then the closing one
    steps.reserve(angles.size());
    for (std::size_t i = 1; i < angles.size(); ++i)
        steps.push_back(angles[i] - angles[i - 1]);
    const double largest = *std::ranges::max_element(steps);
    steps.push_back(std::max(closing, 0.0));
    path.fullCircle = closing <= largestClosing * largest && holes(std::move(steps)) <= mostHoles;
    path.extent = path.fullCircle ? fullTurn : span;
}

EvaluatedPath pathOf(const CircularMeasurement &measurement, std::size_t k, Selection selection,
                     const std::optional<Point> &centringError) {
    const Arc &arc = measurement.arcs[k];
    EvaluatedPath path;
    path.arc = k;
    path.sense = arc.sense;
    path.index = axisIndex(measurement.plane, arc.sense);
    path.evaluated = evaluatedRange(arc).value_or(Interval{});
    const bool rebuilt = arc.angleReference == AngleReference::commanded && centringError;
    path.points = rebuilt ? rebuildPoints(selection.commanded(), *centringError)
                          : polarPoints(selection.angles, selection.distances);
    measureExtent(path, std::move(selection.angles));
    path.source = std::move(selection.source);
    return path;
}

} // namespace

std::optional<Interval> evaluatedRange(const Arc &arc) {
    if (arc.angles.empty())
        return std::nullopt;
    if (arc.evaluated)
        return arc.evaluated;
    const auto [low, high] = std::ranges::minmax(arc.angles);
    if (high - low <= fullTurn)
        return Interval{low, high};
    const double middle = (low + high) / 2;
    return Interval{middle - fullTurn / 2, middle + fullTurn / 2};
}

std::string axisIndex(const Plane &plane, Sense sense) {
    return sense == Sense::counterclockwise ? plane.first + plane.second : plane.second + plane.first;
}

Paths paths(const CircularMeasurement &measurement) {
    Paths result;
    std::vector<Selection> selections;
    selections.reserve(measurement.arcs.size());
    for (const Arc &arc : measurement.arcs)
        selections.push_back(selection(arc, measurement.nominalRadius));

    std::vector<CommandedArc> commanded;
    for (std::size_t k = 0; k < selections.size(); ++k) {
        if (measurement.arcs[k].angleReference == AngleReference::commanded)
            commanded.push_back(selections[k].commanded());
    }
    if (!commanded.empty()) {
        const CentringError error = centringError(commanded);
        if (error.valid())
            result.centringError = error.e;
    }

    // Sine and cosine of 10⁶ points take 20 ms each: compute the paths in parallel.
    constexpr std::size_t many = 50'000;
    std::vector<std::future<EvaluatedPath>> made;
    std::array<bool, 2> seen{};
    for (std::size_t k = 0; k < selections.size(); ++k) {
        const Arc &arc = measurement.arcs[k];
        bool &before = seen[arc.sense == Sense::clockwise];
        if (before) {
            result.repetitions.push_back(k);
            continue;
        }
        before = true;
        made.push_back(runInBackground(made.empty() && selections[k].angles.size() > many, [&, k] {
            return pathOf(measurement, k, std::move(selections[k]), result.centringError);
        }));
    }
    for (auto each = made.rbegin(); each != made.rend(); ++each) // wait for the one on its own thread last
        each->wait();
    for (std::future<EvaluatedPath> &each : made)
        result.evaluated.push_back(each.get());
    return result;
}

EvaluatedPath evaluatedPath(const CircularMeasurement &measurement, std::size_t arc,
                            const std::optional<Point> &centringError) {
    return pathOf(measurement, arc, selection(measurement.arcs[arc], measurement.nominalRadius),
                  centringError);
}

} // namespace palmer::iso230_4
