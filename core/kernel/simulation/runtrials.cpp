// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/runtrials.h"

#include <array>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr int pictureIntervals = 64;
constexpr double pictureReach = 4; ///< u on either side

} // namespace

CoverageInterval shortestInterval(const FineCounts &fine, std::span<const long long> counts) {
    if (fine.width == 0)
        return {fine.from, fine.from};
    long long all = 0;
    for (const long long count : counts)
        all += count;
    const double needed = coverageProbability * static_cast<double>(all);
    const auto fewest = static_cast<long long>(std::ceil(needed)); // whole numbers are added faster
    CoverageInterval best;
    double shortest = std::numeric_limits<double>::infinity();
    long long held = 0;    // sum over the intervals from `left` to before `right`
    std::size_t right = 0; // first interval not included
    for (std::size_t left = 0; left < counts.size(); ++left) {
        while (right < counts.size() && held + counts[right] < fewest)
            held += counts[right++];
        if (right == counts.size())
            break; // too few values remain
        const auto next = static_cast<double>(counts[right]);
        const double part = next > 0 ? (needed - static_cast<double>(held)) / next : 0;
        const double length = static_cast<double>(right - left) + part;
        if (length < shortest) {
            shortest = length;
            best = {fine.from + fine.width * static_cast<double>(left),
                    fine.from + fine.width * (static_cast<double>(right) + part)};
        }
        held -= counts[left];
    }
    return best;
}

Histogram histogram(const FineCounts &fine, std::span<const long long> counts) {
    Histogram result;
    result.counts.resize(pictureIntervals);
    constexpr int skipped =
        static_cast<int>(0.5 * FineCounts::count * (1 - pictureReach / FineCounts::reach));
    constexpr int together = (FineCounts::count - 2 * skipped) / pictureIntervals;
    result.from = fine.from + skipped * fine.width;
    result.width = together * fine.width;
    for (int k = 0; k < FineCounts::count; ++k) {
        const int interval = std::clamp((k - skipped) / together, 0, pictureIntervals - 1);
        result.counts[static_cast<std::size_t>(interval)] += counts[static_cast<std::size_t>(k)];
    }
    return result;
}

std::optional<double> errorOfAverage(std::span<const double> blocks) {
    const auto h = static_cast<double>(blocks.size());
    if (h < 2)
        return std::nullopt;
    double mean = 0;
    for (const double value : blocks)
        mean += value / h;
    double squares = 0;
    for (const double value : blocks)
        squares += (value - mean) * (value - mean);
    return std::sqrt(squares / (h * (h - 1)));
}

bool BlockAverages::stable(double tolerance) const {
    constexpr double rounding = 1e-12; // mm or degrees: for values that differ only in the last digits
    return std::ranges::all_of(std::array{&means, &u, &low, &high, &expanded},
                               [&](const std::vector<double> *averages) {
                                   const auto error = errorOfAverage(*averages);
                                   return error && 2 * *error <= std::max(tolerance, rounding);
                               });
}

} // namespace palmer
