// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace palmer {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// d_2 of normal samples as ISO 230-2:1988 tabulates it, n = 2 … 10.
constexpr std::array rangeFactors{1.128, 1.693, 2.059, 2.326, 2.534, 2.704, 2.847, 2.970, 3.078};

/// One column of a run-by-run table: `values` starts at the target, rows are `stride` apart. `ranges`: W too.
template <bool ranges, class Value>
void columnStatistics(const Value *values, std::size_t runs, std::size_t stride,
                      DirectionStatisticsOf<Value> &result) {
    Value sum = 0;
    Value low = infinity;
    Value high = -infinity;
    int n = 0;
    const auto add = [&](const Value &x) {
        sum += x;
        if constexpr (ranges) {
            low = smaller(x, low);
            high = larger(x, high);
        }
        ++n;
    };
    for (std::size_t run = 0; run < runs; ++run)
        add(values[run * stride]);
    if (isMissing(sum)) { // seldom: a reading is missing
        sum = 0;
        low = infinity;
        high = -infinity;
        n = 0;
        for (std::size_t run = 0; run < runs; ++run) {
            if (const Value x = values[run * stride]; !isMissing(x))
                add(x);
        }
    }
    result.n = n;
    if (n == 0) {
        result.mean = result.range = result.s = undefined;
        return;
    }
    const Value mean = sum / n;
    Value rest = 0;
    Value squares = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        const Value d = values[run * stride] - mean;
        if (n < static_cast<int>(runs) && isMissing(d))
            continue;
        rest += d;
        squares += d * d;
    }
    // The mean was rounded: its error is rest/n, and the squares must be corrected for it, too.
    const Value correction = rest / n;
    result.mean = mean + correction;
    if constexpr (ranges)
        result.range = high - low;
    else
        result.range = undefined;
    result.s = n > 1 ? squareRoot(larger(squares - rest * correction, 0.0) / (n - 1)) : Value(undefined);
}

template <bool ranges, class Value>
void columns(std::span<const Value> table, std::size_t targets, std::span<TargetStatisticsOf<Value>> result,
             DirectionStatisticsOf<Value> TargetStatisticsOf<Value>::*direction) {
    const std::size_t runs = targets ? table.size() / targets : 0;
    for (std::size_t i = 0; i < targets; ++i)
        columnStatistics<ranges>(table.data() + i, runs, targets, result[i].*direction);
}

template <class Value>
void useRangeMethod(DirectionStatisticsOf<Value> &direction) {
    const auto factor = rangeFactor(direction.n);
    direction.s = factor ? direction.range / *factor : undefined;
}

template <class Value>
void targetStatistics(std::span<const Value> positive, std::span<const Value> negative, std::size_t targets,
                      DeviationMethod method, std::span<TargetStatisticsOf<Value>> result) {
    const auto bothDirections = [&]<bool ranges>() {
        columns<ranges>(positive, targets, result, &TargetStatisticsOf<Value>::positive);
        columns<ranges>(negative, targets, result, &TargetStatisticsOf<Value>::negative);
    };
    // For several tests at once only the range method uses W.
    if (std::is_same_v<Value, double> || method == DeviationMethod::range)
        bothDirections.template operator()<true>();
    else
        bothDirections.template operator()<false>();
    if (method == DeviationMethod::range) {
        for (TargetStatisticsOf<Value> &target : result) {
            useRangeMethod(target.positive);
            useRangeMethod(target.negative);
        }
    }
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
    targetStatistics(readings.positive, readings.negative, readings.targets, method, result);
}

void statistics(std::span<const Lanes> positive, std::span<const Lanes> negative, std::size_t targets,
                DeviationMethod method, std::span<TargetStatisticsOf<Lanes>> result) {
    targetStatistics(positive, negative, targets, method, result);
}

std::optional<double> rangeFactor(int n) {
    if (n < 2 || n > 10)
        return std::nullopt;
    return rangeFactors[static_cast<std::size_t>(n - 2)];
}

} // namespace palmer
