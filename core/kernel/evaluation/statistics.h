// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/numerics/lanes.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The readings of one direction as a flat table, row by row (run by run); NaN = no reading.
/// A view: it owns nothing. values.size() = runs · targets; mm, rotary: degrees.
struct ReadingsView {
    std::span<const double> positive;
    std::span<const double> negative;
    std::size_t targets = 0;

    [[nodiscard]] std::size_t positiveRuns() const { return targets ? positive.size() / targets : 0; }
    [[nodiscard]] std::size_t negativeRuns() const { return targets ? negative.size() / targets : 0; }
};

/// Owner of the tables behind a ReadingsView.
struct Readings {
    std::vector<double> positive;
    std::vector<double> negative;
    std::size_t targets = 0;

    [[nodiscard]] ReadingsView view() const { return {positive, negative, targets}; }
};

/// Returns the readings of a measurement in the order of its runs; adds `corrections` (one per target, mm).
[[nodiscard]] Readings readings(const PositioningMeasurement &measurement,
                                std::span<const double> corrections = {});

/// Statistics of one target in one direction. NaN = undefined: mean and range need n ≥ 1, s needs n ≥ 2. NaN
/// stays inside the kernel: parameters and outputs use null. `Value` is double, or Lanes for several tests at
/// once with the same readings missing.
template <class Value>
struct DirectionStatisticsOf {
    int n = 0;       ///< existing readings
    Value mean = 0;  ///< x̄_i↑ or x̄_i↓, mm
    Value s = 0;     ///< estimator of the standard deviation, mm
    Value range = 0; ///< W = max − min, mm
};
using DirectionStatistics = DirectionStatisticsOf<double>;

template <class Value>
struct TargetStatisticsOf {
    DirectionStatisticsOf<Value> positive; ///< ↑
    DirectionStatisticsOf<Value> negative; ///< ↓

    [[nodiscard]] Value mean() const { return (positive.mean + negative.mean) / 2; } ///< x̄_i
    [[nodiscard]] Value reversal() const { return positive.mean - negative.mean; } ///< B_i = x̄_i↑ − x̄_i↓
};
using TargetStatistics = TargetStatisticsOf<double>;

/// Computes the statistics of all targets: mean and s by the corrected two-pass algorithm (both corrected for
/// the rounding error of the mean, Chan, Golub, LeVeque 1983), or s = W/k(n) by the range method of ISO
/// 230-2:1988, 2.9 (undefined outside n = 2 … 10). `result` has one element per target. No allocation.
void statistics(const ReadingsView &readings, DeviationMethod method, std::span<TargetStatistics> result);

/// The same for four tests at once, bit for bit: the tables have the form of a ReadingsView; a reading
/// missing in one test is missing in all four.
void statistics(std::span<const Lanes> positive, std::span<const Lanes> negative, std::size_t targets,
                DeviationMethod method, std::span<TargetStatisticsOf<Lanes>> result);

/// k(n) of the range method for n = 2 … 10: 1.128 … 3.078; null outside.
[[nodiscard]] std::optional<double> rangeFactor(int n);

/// R_i↑ or R_i↓ = 2c·s.
template <class Value>
[[nodiscard]] Value repeatability(const DirectionStatisticsOf<Value> &direction, double c) {
    return 2 * c * direction.s;
}

/// R_i = max(c·s_i↑ + c·s_i↓ + |B_i|; R_i↑; R_i↓); NaN if one of them is.
template <class Value>
[[nodiscard]] Value repeatability(const TargetStatisticsOf<Value> &target, double c) {
    const Value up = target.positive.s;
    const Value down = target.negative.s;
    const Value both = c * up + c * down + magnitude(target.reversal());
    if (isMissing(both))
        return both;
    return larger(larger(both, 2 * c * up), 2 * c * down);
}

} // namespace palmer
