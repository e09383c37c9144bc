// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace palmer {

// Common parts of the axes of curve and line figures.

inline constexpr double mostPositionTicks = 6.5;
inline constexpr double valueMargin = 0.07; ///< above and below the values, fraction of their span

/// Minimum and maximum of the included values; infinite and reversed while there are none.
struct Bounds {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void include(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    /// The range with a margin, its span at least `least`; 0 … 1 if nothing was included.
    [[nodiscard]] Bounds widened(double margin, double least) const {
        if (!(lowest <= highest))
            return {0, 1};
        const double span = std::max(highest - lowest, least);
        const double middle = (lowest + highest) / 2;
        return {middle - span * (0.5 + margin), middle + span * (0.5 + margin)};
    }
};

} // namespace palmer
