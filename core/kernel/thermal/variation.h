// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace palmer {

/// The environmental temperature variation error of a record over a duration: the largest range of values
/// within any window of that duration. Times in s, values in their own unit.
struct Variation {
    double value = 0; ///< E_VE(T)
    double from = 0;  ///< times of the first and last value of the window
    double to = 0;
    double low = 0; ///< smallest and largest value of the window
    double high = 0;
    double recorded = 0;       ///< last time − first time with a value
    double largestGap = 0;     ///< between neighbouring values within the record
    bool isLowerBound = false; ///< the record is shorter than T, or a gap longer than T/10

    bool operator==(const Variation &) const = default;
};

/// Returns E_VE(T), the largest max − min over samples with t_i ≤ t ≤ t_i + T (+ 1e-9 of the record); without
/// `duration` over the whole record, which is no lower bound. NaN: no value. Any steps, ascending times.
/// O(n). Null with fewer than two values.
[[nodiscard]] std::optional<Variation>
variation(std::span<const double> times, std::span<const double> values, std::optional<double> duration);

} // namespace palmer
