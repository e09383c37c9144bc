// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palmer {

/// A part of the uncertainty of a value that it shares with others, e.g. the same device or the same α of the
/// machine. The errors of all values with one source are the same multiple of their `u`.
struct SharedPart {
    std::string source;
    double u = 0; ///< standard uncertainty with the sign of its effect, in the unit of the value

    bool operator==(const SharedPart &) const = default;
};

/// A value of a parameter at a time.
struct TrendPoint {
    double time = 0; ///< years
    double value = 0;
    double own = 0; ///< r: standard uncertainty of this value alone, ≥ 0
    std::vector<SharedPart> shared = {};

    bool operator==(const TrendPoint &) const = default;
};

/// A straight line through values over time, with its uncertainty. Values in their own unit, times in years.
struct TrendLine {
    std::size_t points = 0;
    double first = 0;  ///< time of the first point
    double last = 0;   ///< time of the last point
    double centre = 0; ///< time at which `level` holds: the mean of the times
    double level = 0;
    double slope = 0; ///< per year
    double levelVariance = 0;
    double slopeVariance = 0;
    double covariance = 0;                 ///< of level and slope
    double scatter = 0;                    ///< s: scatter of the values beyond their uncertainties
    std::optional<double> chi2PerDof = {}; ///< with s = 0; null: a value has no own part
    double twoSided = 0;                   ///< t(0.975; n − 2) if s > 0, else 1.96
    double oneSided = 0;                   ///< t(0.95; n − 2) if s > 0, else 1.645

    [[nodiscard]] double at(double time) const;
    /// Returns the standard uncertainty of the line at a time: of the level, not of the next value.
    [[nodiscard]] double uncertaintyAt(double time) const;
    [[nodiscard]] double slopeUncertainty() const;
    /// True if a trend is shown: |slope| ≥ t·u(slope).
    [[nodiscard]] bool isShown() const;
};

inline constexpr std::size_t fewestTrendPoints = 4;

/// Generalised least squares: u_i² = r_i² + Σ c_ik², V = diag(r² + s²) + Σ_k c_k c_kᵀ, X = (1, t); b =
/// (XᵀV⁻¹X)⁻¹XᵀV⁻¹y with Cov = (XᵀV⁻¹X)⁻¹; s² ≥ 0 from (y − Xb)ᵀV⁻¹(y − Xb) = n − 2, 0 if the left side is
/// already smaller. V is never inverted: the shared errors z_k of variance 1 are unknowns of an ordinary
/// least-squares problem with the rows z_k = 0, solved by QR. Null with fewer than `fewestTrendPoints`
/// points, if all have the same time, or if a number is not finite.
[[nodiscard]] std::optional<TrendLine> trendLine(std::span<const TrendPoint> points);

} // namespace palmer
