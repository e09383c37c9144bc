// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/chisquare.h"

#include <cmath>
#include <numbers>

namespace palmer {

double chiSquareExceeded(double value, double degrees) {
    if (!(degrees > 0) || !(value > 0))
        return 1;
    const double spread = 2 / (9 * degrees);
    const double z = (std::cbrt(value / degrees) - (1 - spread)) / std::sqrt(spread);
    return std::erfc(z / std::numbers::sqrt2) / 2;
}

double normalExceeded(double z) {
    return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

} // namespace palmer
