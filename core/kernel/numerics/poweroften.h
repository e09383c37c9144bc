// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace palmer {

/// 10^exponent, correctly rounded and so the same on every system, which std::pow is not.
[[nodiscard]] inline double powerOfTen(int exponent) {
    constexpr int mostExact = 22; // larger powers are no doubles
    const int size = exponent < 0 ? -exponent : exponent;
    if (size > mostExact)
        return std::pow(10.0, exponent);
    double power = 1;
    for (int i = 0; i < size; ++i)
        power *= 10;
    return exponent < 0 ? 1 / power : power;
}

} // namespace palmer
