#include "kernel/numerics/studentt.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace palmer {

namespace {

/// A(t|ν) = probability of |T| < t.
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

double studentQuantile975(int degrees) {
    if (degrees < 1)
        return std::numeric_limits<double>::infinity();
    double low = 1.9; // the normal distribution has 1.96
    double high = 12.8;
    while (high - low > 1e-13 * high) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high)
            break;
        (centralProbability(middle, degrees) < 0.95 ? low : high) = middle;
    }
    return (low + high) / 2;
}

} // namespace palmer
