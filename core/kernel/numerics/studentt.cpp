// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/studentt.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace palmer {

namespace {

/// Returns A(t|ν), the probability of |T| < t.
double centralProbability(double t, int degrees) {
    const double theta = std::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double sine = std::sin(theta);
    const double cosine = std::cos(theta);
    if (degrees % 2 != 0) {
        double sum = 0;
        double term = cosine;
        for (int k = 1; k <= degrees - 2; k += 2) {
            sum += term;
            term *= cosine * cosine * (k + 1) / (k + 2);
        }
        return 2 / std::numbers::pi * (theta + sine * sum);
    }
    double sum = 0;
    double term = 1;
    for (int k = 0; k <= degrees - 2; k += 2) {
        sum += term;
        term *= cosine * cosine * (k + 1) / (k + 2);
    }
    return sine * sum;
}

} // namespace

double studentQuantile(double probability, int degrees) {
    if (degrees < 1)
        return std::numeric_limits<double>::infinity();
    const double central = 2 * probability - 1;
    double low = 0;
    double high = 2;
    while (centralProbability(high, degrees) < central) {
        low = high;
        high *= 2;
    }
    while (high - low > 1e-13 * high) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high)
            break;
        (centralProbability(middle, degrees) < central ? low : high) = middle;
    }
    return (low + high) / 2;
}

double studentQuantile975(int degrees) {
    constexpr double probability = 0.975;
    return studentQuantile(probability, degrees);
}

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
