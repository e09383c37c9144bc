// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/typetest/typetest.h"

#include "kernel/numerics/normalquantile.h"

#include <boost/math/distributions/non_central_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palmer {

namespace {

struct Spread {
    double mean = 0;
    double s = 0;
};

Spread spreadOf(std::span<const double> values) {
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (n - 1))};
}

std::optional<Normality> normalityOf(std::span<const double> sorted) {
    const std::size_t count = sorted.size();
    if (count < fewestForNormality || sorted.front() == sorted.back())
        return std::nullopt;
    const double mean = spreadOf(sorted).mean;
    double xx = 0;
    double xz = 0;
    double zz = 0;
    for (std::size_t i = 0; i < count; ++i) { // the mean of the scores is 0
        const double x = sorted[i] - mean;
        const double z = normalScore(i, count);
        xx += x * x;
        xz += x * z;
        zz += z * z;
    }
    const double w = xz * xz / (xx * zz);
    const double l = std::log(static_cast<double>(count));
    const double u = std::log(l);
    const double z =
        (std::log1p(-std::min(w, 1.0)) + 1.2725 - 1.0521 * (u - l)) / (1.0308 - 0.26758 * (u + 2 / l));
    constexpr double doubtfulBelow = 0.05;
    const double probability = std::erfc(z / std::sqrt(2.0)) / 2;
    return Normality{w, probability, probability < doubtfulBelow};
}

} // namespace

double toleranceFactor(std::size_t count, const Tolerance &tolerance) {
    const auto n = static_cast<double>(count);
    const boost::math::non_central_t distribution(n - 1, normalQuantile(tolerance.content) * std::sqrt(n));
    return boost::math::quantile(distribution, tolerance.confidence) / std::sqrt(n);
}

double normalScore(std::size_t index, std::size_t count) {
    return normalQuantile((static_cast<double>(index) + 1 - 0.375) / (static_cast<double>(count) + 0.25));
}

std::optional<TypeStatistics> typeStatistics(std::span<const double> values, const Tolerance &tolerance) {
    if (values.size() < fewestMachines)
        return std::nullopt;
    TypeStatistics result;
    result.sorted.assign(values.begin(), values.end());
    std::ranges::sort(result.sorted);
    const std::size_t count = values.size();
    const Spread spread = spreadOf(result.sorted);
    result.mean = spread.mean;
    result.s = spread.s;
    result.median = (result.sorted[(count - 1) / 2] + result.sorted[count / 2]) / 2;
    result.factor = toleranceFactor(count, tolerance);
    result.confidenceOfLargest = 1 - std::pow(tolerance.content, static_cast<double>(count));
    result.normality = normalityOf(result.sorted);
    if (result.sorted.front() == result.sorted.back())
        return result;
    result.normalLimit = spread.mean + result.factor * spread.s;
    if (result.sorted.front() > 0) {
        std::vector<double> logarithms(count);
        std::ranges::transform(result.sorted, logarithms.begin(),
                               [](double value) { return std::log(value); });
        const Spread ofLogarithms = spreadOf(logarithms);
        result.logNormalLimit = std::exp(ofLogarithms.mean + result.factor * ofLogarithms.s);
        result.logNormality = normalityOf(logarithms);
    }
    return result;
}

} // namespace palmer
