// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/drift.h"

#include "kernel/numerics/studentt.h"

#include <algorithm>
#include <cmath>

namespace palmer {

bool DriftStatistic::significant() const {
    return std::abs(t) > critical;
}

std::optional<DriftStatistic> driftStatistic(const ReadingsView &readings,
                                             std::span<const TargetStatistics> statistics) {
    const std::size_t n = std::max(readings.positiveRuns(), readings.negativeRuns());
    if (n < 3)
        return std::nullopt;

    DriftStatistic result;
    result.means.resize(n);
    double rounding = 0;
    for (std::size_t run = 0; run < n; ++run) {
        double sum = 0;
        int count = 0;
        const auto add = [&](std::span<const double> table,
                             DirectionStatistics TargetStatistics::*direction) {
            if ((run + 1) * readings.targets > table.size())
                return;
            for (std::size_t i = 0; i < readings.targets; ++i) {
                const double d = table[run * readings.targets + i] - (statistics[i].*direction).mean;
                if (std::isnan(d))
                    continue;
                rounding = std::max(rounding, 1e-14 * std::abs(table[run * readings.targets + i]));
                sum += d;
                ++count;
            }
        };
        add(readings.positive, &TargetStatistics::positive);
        add(readings.negative, &TargetStatistics::negative);
        if (count == 0)
            return std::nullopt; // a run without readings has no place on the line
        result.means[run] = sum / count;
    }

    const auto count = static_cast<double>(n);
    const double middle = (count - 1) / 2;
    double mean = 0;
    for (const double g : result.means)
        mean += g / count;
    double across = 0;
    double along = 0;
    for (std::size_t run = 0; run < n; ++run) {
        const double j = static_cast<double>(run) - middle;
        along += j * j;
        across += j * (result.means[run] - mean);
    }
    // Means that differ only by rounding errors have no slope.
    const bool flat = std::ranges::all_of(result.means, [&](double g) { return std::abs(g) <= rounding; });
    const double slope = flat ? 0 : across / along;
    double residuals = 0;
    for (std::size_t run = 0; run < n; ++run) {
        const double r = result.means[run] - mean - slope * (static_cast<double>(run) - middle);
        residuals += r * r;
    }
    const double error = std::sqrt(residuals / (count - 2) / along);
    result.change = slope * (count - 1);
    result.t = slope == 0 ? 0 : slope / error;
    result.critical = studentQuantile975(static_cast<int>(n) - 2);
    return result;
}

} // namespace palmer
