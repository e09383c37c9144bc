#pragma once

#include "kernel/measurement/positioning.h"

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

/// Owner of the table behind a ReadingsView.
struct Readings {
    std::vector<double> positive;
    std::vector<double> negative;
    std::size_t targets = 0;

    [[nodiscard]] ReadingsView view() const { return {positive, negative, targets}; }
};

/// The readings of a measurement in the order of its runs; `corrections` (one a target, mm) are added.
[[nodiscard]] Readings readings(const PositioningMeasurement &measurement,
                                std::span<const double> corrections = {});

/// Statistics of one target in one direction. NaN = undefined: mean and range need n ≥ 1, s needs n ≥ 2.
/// The NaN stay inside the kernel: parameters and outputs have null.
struct DirectionStatistics {
    int n = 0;        ///< readings that exist
    double mean = 0;  ///< x̄_i↑ or x̄_i↓, mm
    double s = 0;     ///< estimator of the standard deviation, mm
    double range = 0; ///< W = max − min, mm
};

struct TargetStatistics {
    DirectionStatistics positive; ///< ↑
    DirectionStatistics negative; ///< ↓

    [[nodiscard]] double mean() const { return (positive.mean + negative.mean) / 2; } ///< x̄_i
    [[nodiscard]] double reversal() const { return positive.mean - negative.mean; } ///< B_i = x̄_i↑ − x̄_i↓
};

/// Statistics of all targets: mean and s by the corrected two-pass algorithm (the rounding error of the mean
/// is taken out of both, Chan, Golub, LeVeque 1983), or s = W/k(n) by the range method of ISO 230-2:1988, 2.9
/// (undefined outside n = 2 … 10). `result` has one element a target. No allocation.
void statistics(const ReadingsView &readings, DeviationMethod method, std::span<TargetStatistics> result);

/// k(n) of the range method for n = 2 … 10: 1.128 … 3.078; null outside.
[[nodiscard]] std::optional<double> rangeFactor(int n);

/// R_i↑ or R_i↓ = 2c·s.
[[nodiscard]] inline double repeatability(const DirectionStatistics &direction, double c) {
    return 2 * c * direction.s;
}

/// R_i = max(c·s_i↑ + c·s_i↓ + |B_i|; R_i↑; R_i↓); NaN where one of them is.
[[nodiscard]] double repeatability(const TargetStatistics &target, double c);

} // namespace palmer
