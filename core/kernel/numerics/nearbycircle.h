// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/rays.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The least squares circle of points on rays that stay near a reference, each set of rays with equal weight.
///
/// About the least squares centre c₀ of the reference a point at c = c₀ + δ has the distance
///     r = (r₀ + a) + b²/(2·r₀) + …,   a = t·(u·w) − δ·w,   b = t·(u × w) + δ × w,
/// t the change of its ρ, w its direction from c₀: no root, no quotient, and w, u·w, u × w, 1/r₀ are those of
/// the reference. Two Newton steps with the second derivatives of the reference make the derivative of the
/// sum of squares vanish, as leastSquaresCircle does with some seven looks and a root and a quotient a point.
/// The first step is linear in the changes: two sums. It leaves an error of second order in change/r₀, the
/// second step one of third. What is left out is of third order too: agreement with the plain way is its
/// rounding, some 1e-14·R.
class NearbyCircle {
public:
    /// `centre`: c₀.
    NearbyCircle(std::span<const Rays *const> sets, Point centre);

    struct Fit {
        Point centre;
        double radius = 0;
    };
    /// Looks at the same sets. Null where what is left out could exceed 1e-14·R: the plain way tells then.
    [[nodiscard]] std::optional<Fit> fit(std::span<const Rays::Look *const> looks) const;

private:
    struct Set {
        std::vector<double> wx;
        std::vector<double> wy;
        std::vector<double> along;    ///< u·w
        std::vector<double> across;   ///< the part of u across w
        std::vector<double> residual; ///< r₀ − mean r₀
        std::vector<double> inverse;  ///< 1/r₀
        std::vector<double> stepX;    ///< the first step by a change of 1
        std::vector<double> stepY;
    };
    /// Weighted means: f = r − mean r₀, and its derivatives by the centre are −u.
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
    double m_least = 0;    ///< of r₀
    double m_residual = 0; ///< largest |residual|
    double m_across = 0;   ///< largest |across|
};

} // namespace palmer
