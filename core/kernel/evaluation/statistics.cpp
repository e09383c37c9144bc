#include "kernel/evaluation/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// d_2 of normal samples as ISO 230-2:1988 tabulates it, n = 2 … 10.
constexpr std::array rangeFactors{1.128, 1.693, 2.059, 2.326, 2.534, 2.704, 2.847, 2.970, 3.078};

/// One column of a run-by-run table: `values` starts at the target, rows are `stride` apart.
DirectionStatistics columnStatistics(const double *values, std::size_t runs, std::size_t stride) {
    DirectionStatistics result{0, undefined, undefined, undefined};
    double sum = 0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    int n = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        const double x = values[run * stride];
        if (std::isnan(x))
            continue;
        sum += x;
        low = std::min(low, x);
        high = std::max(high, x);
        ++n;
    }
    result.n = n;
    if (n == 0)
        return result;
    double mean = sum / n;
    double rest = 0;
    double squares = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        const double d = values[run * stride] - mean;
        if (std::isnan(d))
            continue;
        rest += d;
        squares += d * d;
    }
    // The mean was rounded: its error is rest/n, and it must leave the squares too.
    result.mean = mean + rest / n;
    result.range = high - low;
    if (n > 1)
        result.s = std::sqrt(std::max(0.0, squares - rest * rest / n) / (n - 1));
    return result;
}

void columns(std::span<const double> table, std::size_t targets, std::span<TargetStatistics> result,
             DirectionStatistics TargetStatistics::*direction) {
    const std::size_t runs = targets ? table.size() / targets : 0;
    for (std::size_t i = 0; i < targets; ++i)
        result[i].*direction = columnStatistics(table.data() + i, runs, targets);
}

void useRangeMethod(DirectionStatistics &direction) {
    const auto factor = rangeFactor(direction.n);
    direction.s = factor ? direction.range / *factor : undefined;
}

} // namespace

Readings readings(const PositioningMeasurement &measurement, std::span<const double> corrections) {
    Readings result;
    result.targets = measurement.targets.size();
    const auto runsOf = [&](Direction direction) {
        return static_cast<std::size_t>(std::ranges::count(measurement.runs, direction, &Run::approach));
    };
    result.positive.reserve(runsOf(Direction::positive) * result.targets);
    result.negative.reserve(runsOf(Direction::negative) * result.targets);
    for (const Run &run : measurement.runs) {
        auto &table = run.approach == Direction::positive ? result.positive : result.negative;
        for (std::size_t i = 0; i < result.targets; ++i) {
            const auto reading = i < run.deviations.size() ? run.deviations[i] : std::nullopt;
            const double correction = i < corrections.size() ? corrections[i] : 0.0;
            table.push_back(reading ? *reading + correction : undefined);
        }
    }
    return result;
}

void statistics(const ReadingsView &readings, DeviationMethod method, std::span<TargetStatistics> result) {
    columns(readings.positive, readings.targets, result, &TargetStatistics::positive);
    columns(readings.negative, readings.targets, result, &TargetStatistics::negative);
    if (method == DeviationMethod::range) {
        for (TargetStatistics &target : result) {
            useRangeMethod(target.positive);
            useRangeMethod(target.negative);
        }
    }
}

std::optional<double> rangeFactor(int n) {
    if (n < 2 || n > 10)
        return std::nullopt;
    return rangeFactors[static_cast<std::size_t>(n - 2)];
}

double repeatability(const TargetStatistics &target, double c) {
    const double up = target.positive.s;
    const double down = target.negative.s;
    const double both = c * up + c * down + std::abs(target.reversal());
    if (std::isnan(both))
        return undefined;
    return std::max({both, 2 * c * up, 2 * c * down});
}

} // namespace palmer
