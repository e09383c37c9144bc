// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/targetstrip.h"

#include "figures/curvefield.h"
#include "figures/ticks.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/readingsaside.h"
#include "language/decimals.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double mostParts = 6;
constexpr double spanMargin = 0.06; ///< fraction of the span, on either side
constexpr double mostStretch = 3;   ///< factor by which the scale may grow to include the origin
constexpr double leastSpan = 1e-6;  ///< mm or degrees

StripLane laneOf(Direction direction, const PositioningMeasurement &measurement,
                 const PositioningResults &results, std::size_t target, double scale) {
    StripLane lane;
    lane.role = direction == Direction::positive ? CurveRole::up : CurveRole::down;
    const double correction = target < results.corrections.size() ? results.corrections[target] : 0;
    const ReadingsAside aside(measurement);
    for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
        const Run &run = measurement.runs[j];
        if (run.approach != direction || target >= run.deviations.size())
            continue;
        const ExcludedReading *excluded = aside.at(j, target);
        if (const auto &value = run.deviations[target])
            lane.readings.push_back({(*value + correction) * scale, j});
        else if (excluded)
            lane.readings.push_back({(excluded->value + correction) * scale, j, true});
    }
    return lane;
}

void addStatistics(StripLane &lane, const DirectionStatistics &s, double c, double scale) {
    if (!std::isfinite(s.mean))
        return;
    lane.mean = s.mean * scale;
    if (std::isfinite(s.s) && c > 0) {
        lane.lower = (s.mean - c * s.s) * scale;
        lane.upper = (s.mean + c * s.s) * scale;
    }
}

/// Range of the values and limits of the lanes, in their unit.
Interval rangeOf(const std::vector<StripLane> &lanes) {
    Bounds bounds;
    for (const StripLane &lane : lanes) {
        for (const auto &reading : lane.readings)
            bounds.include(reading.value);
        if (lane.lower && lane.upper) {
            bounds.include(*lane.lower);
            bounds.include(*lane.upper);
        }
    }
    const auto [least, most] = bounds;
    if (!(least <= most))
        return {-1, 1};
    // Include the origin for comparison unless it would squeeze the readings.
    const bool withOrigin = std::max(most, 0.0) - std::min(least, 0.0) < mostStretch * (most - least);
    return withOrigin ? Interval{std::min(least, 0.0), std::max(most, 0.0)} : Interval{least, most};
}

} // namespace

TargetStrip targetStrip(const Test &test, const TestEvaluation &evaluation, std::size_t target,
                        const Language &language) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    const PositioningResults &results = resultsOf(measurement, evaluation);
    const double scale = unitScale(deviationQuantity(measurement.axis), language.units());
    const double c = evaluation.edition ? evaluation.edition->c : 0;

    TargetStrip strip;
    if (results.upward)
        strip.lanes.push_back(laneOf(Direction::positive, measurement, results, target, scale));
    if (results.downward)
        strip.lanes.push_back(laneOf(Direction::negative, measurement, results, target, scale));
    if (target < results.targets.size()) {
        for (StripLane &lane : strip.lanes)
            addStatistics(lane,
                          lane.role == CurveRole::up ? results.targets[target].positive
                                                     : results.targets[target].negative,
                          c, scale);
    }
    if (strip.lanes.size() == 2 && strip.lanes[0].mean && strip.lanes[1].mean)
        strip.reversal = QStringLiteral("B ") + language.number(results.targets[target].reversal(),
                                                                deviationQuantity(measurement.axis),
                                                                statisticDecimals(measurement));
    const Interval range = rangeOf(strip.lanes);
    const double span = std::max(range.to - range.from, leastSpan * scale);
    setRange(strip.axis, range.from - spanMargin * span, range.to + spanMargin * span, mostParts,
             TickSteps::values, language);
    strip.axis.unit = language.unit(deviationQuantity(measurement.axis));
    return strip;
}

} // namespace palmer
