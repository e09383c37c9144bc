// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/studentt.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace palmer {

double studentQuantile(double probability, int degrees) {
    if (degrees < 1)
        return std::numeric_limits<double>::infinity();
    return boost::math::quantile(boost::math::students_t(degrees), probability);
}

double studentQuantile975(int degrees) {
    constexpr double probability = 0.975;
    return studentQuantile(probability, degrees);
}

double chiSquareExceeded(double value, double degrees) {
    if (!(degrees > 0) || !(value > 0))
        return 1;
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), value));
}

double normalExceeded(double z) {
    return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

} // namespace palmer
