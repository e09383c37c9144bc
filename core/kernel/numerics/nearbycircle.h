// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/rays.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The least squares circle of points on rays that stay near a reference, with equal weight per set of rays.
///
/// Relative to the least squares centre c₀ of the reference, a point has at c = c₀ + δ the distance
///     r = (r₀ + a) + b²/(2·r₀) + …,   a = t·(u·w) − δ·w,   b = t·(u × w) + δ × w,
/// t being the change of its ρ, w its direction from c₀: no root, no division, and w, u·w, u × w, 1/r₀ are
/// constants of the reference. Two Newton steps with the second derivatives of the reference solve for the
/// zero of the gradient, which leastSquaresCircle does in some seven passes with a root and a division per
/// point. The first step is linear in the changes: two sums. Its error is of second order in change/r₀, that
/// of the second step of third order, like the terms neglected. The result agrees with leastSquaresCircle to
/// rounding, some 1e-14·R.
class NearbyCircle {
public:
    /// `centre`: c₀.
    NearbyCircle(std::span<const Rays *const> sets, Point centre);

    struct Fit {
        Point centre;
        double radius = 0;
    };
    /// Fits looks at the same sets. Null if the neglected terms could exceed 1e-14·R.
    [[nodiscard]] std::optional<Fit> fit(std::span<const Rays::Look *const> looks) const;

private:
    struct Set {
        std::vector<double> wx;
        std::vector<double> wy;
        std::vector<double> along;    ///< u·w
        std::vector<double> across;   ///< component of u across w
        std::vector<double> residual; ///< r₀ − mean r₀
        std::vector<double> inverse;  ///< 1/r₀
        std::vector<double> stepX;    ///< first step per unit change
        std::vector<double> stepY;
    };
    /// Weighted means: f = r − mean r₀, whose derivatives with respect to the centre are −u.
    struct Means {
        double f = 0, ux = 0, uy = 0, fx = 0, fy = 0;

        [[nodiscard]] Point gradient() const { return {fx - f * ux, fy - f * uy}; }
    };
    [[nodiscard]] Means means(std::span<const Rays::Look *const> looks, Point delta) const;
    [[nodiscard]] Point firstStep(std::span<const Rays::Look *const> looks) const;
    [[nodiscard]] Point step(const Means &means) const;

    std::vector<Set> m_sets;
    Point m_centre;
    double m_radius = 0; ///< mean r₀
    double m_xx = 0;     ///< inverse of half the second derivatives
    double m_xy = 0;
    double m_yy = 0;
    double m_least = 0;    ///< smallest r₀
    double m_residual = 0; ///< largest |residual|
    double m_across = 0;   ///< largest |across|
};

} // namespace palmer
