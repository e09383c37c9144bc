#include "figures/targetstrip.h"

#include "figures/ticks.h"
#include "language/decimals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr double mostParts = 6;
constexpr double margin = 0.06;    ///< of the span, on either side
constexpr double mostStretch = 3;  ///< of the scale, to show the origin
constexpr double leastSpan = 1e-6; ///< mm or degrees

} // namespace

TargetStrip targetStrip(const Test &test, const TestEvaluation &evaluation, std::size_t target,
                        const Language &language) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    const auto &results = std::get<PositioningResults>(evaluation.results);
    const double scale = unitScale(deviationQuantity(measurement.axis), language.units());
    const double c = evaluation.edition ? evaluation.edition->c : 0;

    TargetStrip strip;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    const auto include = [&](double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    };
    for (const Direction direction : {Direction::positive, Direction::negative}) {
        if (!(direction == Direction::positive ? results.upward : results.downward))
            continue;
        StripLane lane;
        lane.role = direction == Direction::positive ? CurveRole::up : CurveRole::down;
        for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
            const Run &run = measurement.runs[j];
            if (run.approach != direction || target >= run.deviations.size() || !run.deviations[target])
                continue;
            const double correction = target < results.corrections.size() ? results.corrections[target] : 0;
            lane.readings.push_back({(*run.deviations[target] + correction) * scale, j});
            include(lane.readings.back().value);
        }
        if (target < results.targets.size()) {
            const DirectionStatistics &s = direction == Direction::positive
                                               ? results.targets[target].positive
                                               : results.targets[target].negative;
            if (std::isfinite(s.mean))
                lane.mean = s.mean * scale;
            if (std::isfinite(s.mean) && std::isfinite(s.s) && c > 0) {
                lane.lower = (s.mean - c * s.s) * scale;
                lane.upper = (s.mean + c * s.s) * scale;
                include(*lane.lower);
                include(*lane.upper);
            }
        }
        strip.lanes.push_back(std::move(lane));
    }
    if (strip.lanes.size() == 2 && strip.lanes[0].mean && strip.lanes[1].mean)
        strip.reversal = QStringLiteral("B ") + language.number(results.targets[target].reversal(),
                                                                deviationQuantity(measurement.axis),
                                                                statisticDecimals(measurement));
    if (!(least <= most)) {
        least = -1;
        most = 1;
    }
    // The origin is there to compare with unless it would squeeze the readings.
    if (std::max(most, 0.0) - std::min(least, 0.0) < mostStretch * (most - least)) {
        least = std::min(least, 0.0);
        most = std::max(most, 0.0);
    }
    const double span = std::max(most - least, leastSpan * scale);
    setRange(strip.axis, least - margin * span, most + margin * span, mostParts, TickSteps::values, language);
    strip.axis.unit = language.unit(deviationQuantity(measurement.axis));
    return strip;
}

} // namespace palmer
