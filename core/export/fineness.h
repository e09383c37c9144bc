// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace palmer {

/// Positions of a compensation table are rounded to this fraction of a mm or degree.
inline constexpr double positionFineness = 1e6;

/// Rounds to multiples of 1/parts; never −0.
[[nodiscard]] inline double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0;
}

} // namespace palmer
