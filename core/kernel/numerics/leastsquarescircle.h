// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <cstddef>
#include <span>

namespace palmer {

struct LeastSquaresCircleOptions {
    /// Sizes of consecutive groups of points with equal total weight whatever their size: a point has the
    /// weight w_i = 1/(N_g·groups), N_g being the points in its group. Empty: one group, w_i = 1/N. The sizes
    /// add up to the number of points; a group of size 0 is ignored.
    std::span<const std::size_t> groups;
    double tolerance = 1e-15; ///< Stop if |Δc| ≤ tolerance·R.
    int maxIterations = 100;
};

/// The least squares circle: centre c and radius R that minimise Σ w_i·(r_i − R)², r_i = |P_i − c|.
///
/// Method: algebraic fit (minimise Σ w_i·(r_i² − R²)²) on points about their mean, then Gauss–Newton on the
/// geometric sum with R eliminated: with u_i = (P_i − c)/r_i, f_i = r_i − R̄ and bars for weighted means,
///     [mean(u·uᵀ) − ū·ūᵀ]·Δc = mean(u·f) − ū·f̄,    R = mean(r);
/// a step that would increase the sum is halved, none is longer than R, and if steps shrink slowly the second
/// derivatives, mean(f/r·(1 − u·uᵀ)), are added to the matrix (Newton). A Newton step guaranteed to end at
/// the minimum within the tolerance is the last; for deviations of machines it is the first, and the whole
/// fit takes three passes over the points (moments, directions, extremes). For short arcs with residuals as
/// large as their bend the sum has several minima: steps start from each one visible on a grid of centres (36
/// directions, distances by √2 up to 3 000 extents of the points), and the best circle is taken; if none
/// leads to a circle, steps start from the best centre across the line through the points.
/// Validity: any position of the points, full circles and arcs. Bad input gives a status and zeros, never
/// NaN.
///
/// Sources: I. Kåsa, IEEE Trans. Instrum. Meas. 25 (1976), 8–14 (start); A. B. Forbes, Least-squares best-fit
/// geometric elements, NPL Report DITC 140/89 (1989) (finish).
struct LeastSquaresCircle {
    enum class Status {
        converged,
        notConverged, ///< maxIterations reached: no circle.
        tooFewPoints, ///< Fewer than 3 distinct points.
        collinear,    ///< On a straight line (to rounding), or no circle fits better than a line to seven
                      ///< digits.
        notFinite,    ///< A coordinate is not finite, or too large to be squared.
    };

    Status status = Status::tooFewPoints;
    Point centre;             ///< c, mm
    double radius = 0;        ///< R, mm
    double innerRadius = 0;   ///< min r_i, mm
    double outerRadius = 0;   ///< max r_i, mm
    double rms = 0;           ///< √(Σ w_i·(r_i − R)²), mm
    std::size_t nearest = 0;  ///< Index of the first point with min r_i.
    std::size_t farthest = 0; ///< Index of the first point with max r_i.
    int iterations = 0;

    /// max r_i − min r_i, mm
    [[nodiscard]] double range() const { return outerRadius - innerRadius; }
    /// True if a circle was found.
    [[nodiscard]] bool valid() const { return status == Status::converged; }

    bool operator==(const LeastSquaresCircle &) const = default;
};

[[nodiscard]] LeastSquaresCircle leastSquaresCircle(PointsView points,
                                                    const LeastSquaresCircleOptions &options = {});

} // namespace palmer
