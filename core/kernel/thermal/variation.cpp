// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/thermal/variation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

namespace palmer {

std::optional<Variation> variation(std::span<const double> times, std::span<const double> values,
                                   std::optional<double> duration) {
    std::vector<std::size_t> rows; // with a value
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isnan(values[i]))
            rows.push_back(i);
    }
    if (rows.size() < 2)
        return std::nullopt;
    const double begin = times[rows.front()];
    const double end = times[rows.back()];
    Variation best;
    best.recorded = end - begin;
    for (std::size_t i = 1; i < rows.size(); ++i)
        best.largestGap = std::max(best.largestGap, times[rows[i]] - times[rows[i - 1]]);
    constexpr double rounding = 1e-9;
    constexpr double largestGapShare = 0.1;
    const double reach =
        duration ? *duration + rounding * best.recorded : std::numeric_limits<double>::infinity();
    best.isLowerBound = duration && (best.recorded + rounding * best.recorded < *duration ||
                                     best.largestGap > largestGapShare * *duration);
    // Rows of the window that may become its smallest or largest value, in order of time.
    std::deque<std::size_t> smallest;
    std::deque<std::size_t> largest;
    best.value = -1;
    std::size_t first = 0;
    for (const std::size_t row : rows) { // the window ends at this row
        while (!smallest.empty() && values[smallest.back()] >= values[row])
            smallest.pop_back();
        smallest.push_back(row);
        while (!largest.empty() && values[largest.back()] <= values[row])
            largest.pop_back();
        largest.push_back(row);
        while (times[row] > times[rows[first]] + reach) {
            if (smallest.front() == rows[first])
                smallest.pop_front();
            if (largest.front() == rows[first])
                largest.pop_front();
            ++first;
        }
        const double low = values[smallest.front()];
        const double high = values[largest.front()];
        if (high - low > best.value) {
            best.value = high - low;
            best.low = low;
            best.high = high;
            best.from = times[rows[first]];
            best.to = times[row];
        }
    }
    if (best.recorded <= reach) { // also if the range is reached before the end
        best.from = begin;
        best.to = end;
    }
    return best;
}

} // namespace palmer
