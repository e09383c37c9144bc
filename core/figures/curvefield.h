// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace palmer {

// What the fields of curve and line figures have in common.

inline constexpr double mostPositionTicks = 6.5;
inline constexpr double valueMargin = 0.07; ///< above and below the values, part of their span

/// The least and the greatest of what is included; none before.
struct Bounds {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void include(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    /// With a margin; a range of its own where nothing or one value was included.
    [[nodiscard]] Bounds widened(double margin, double least) const {
        if (!(lowest <= highest))
            return {0, 1};
        const double span = std::max(highest - lowest, least);
        const double middle = (lowest + highest) / 2;
        return {middle - span * (0.5 + margin), middle + span * (0.5 + margin)};
    }
};

} // namespace palmer
