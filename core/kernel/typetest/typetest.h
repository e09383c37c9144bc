// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The statement of an upper tolerance limit: at least `content` of all values lie below it, and a limit made
/// this way is right with probability `confidence`. Both in (0, 1).
struct Tolerance {
    double content = 0.95;
    double confidence = 0.95;

    bool operator==(const Tolerance &) const = default;
};

/// Returns k of the one-sided tolerance limit mean + k·s of `count` ≥ 2 normal values:
/// k = t'_γ(count − 1; z_p·√count)/√count, t' the quantile of the noncentral t distribution (Boost.Math).
[[nodiscard]] double toleranceFactor(std::size_t count, const Tolerance &tolerance);

/// How the values of a type are distributed: their logarithms, or they themselves, normally.
enum class TypeDistribution { logNormal, normal };

/// The Shapiro–Francia test of a normal distribution. Sources: S. S. Shapiro, R. S. Francia, Journal of the
/// American Statistical Association 67 (1972), 215–216; P. Royston, Statistics in Medicine 12 (1993), 181–184
/// (the approximation of its distribution).
struct Normality {
    double w = 0;           ///< W': squared correlation of the sorted values with normal scores
    double probability = 0; ///< of a W' as small with normal values
    bool doubtful = false;  ///< probability < 0.05

    bool operator==(const Normality &) const = default;
};

/// The statistics of a type, from the values of one parameter of several of its machines.
struct TypeStatistics {
    std::vector<double> sorted; ///< ascending
    double mean = 0;
    double s = 0;
    double median = 0;
    double factor = 0;                    ///< k of both limits
    std::optional<double> normalLimit;    ///< mean + k·s; null without scatter
    std::optional<double> logNormalLimit; ///< exp(m + k·s) of the logarithms; null if a value is not > 0
    double confidenceOfLargest = 0; ///< that `content` of the type lies below the largest value: 1 − p^N
    std::optional<Normality> normality; ///< of the values; null below `fewestForNormality` or without scatter
    std::optional<Normality> logNormality; ///< of their logarithms

    [[nodiscard]] std::optional<double> limit(TypeDistribution distribution) const {
        return distribution == TypeDistribution::logNormal ? logNormalLimit : normalLimit;
    }
};

inline constexpr std::size_t fewestMachines = 3;
inline constexpr std::size_t fewestForNormality = 8;

/// Returns the statistics of at least `fewestMachines` finite values; null with fewer.
[[nodiscard]] std::optional<TypeStatistics> typeStatistics(std::span<const double> values,
                                                           const Tolerance &tolerance);

/// Returns the normal score of the sorted value `index` (from 0) of `count`: Φ⁻¹((i − 0.375)/(N + 0.25)).
[[nodiscard]] double normalScore(std::size_t index, std::size_t count);

} // namespace palmer
