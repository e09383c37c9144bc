// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/leastsquarescircle.h"

#include "kernel/numerics/columnsums.h"
#include "kernel/numerics/radiusextremes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace palmer {

namespace {

using Status = LeastSquaresCircle::Status;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double lineMargin = 1e-9; ///< relative to the sum: a circle no better than a line
constexpr double quick = 10;        ///< shrinkage of steps that need no second derivatives

constexpr std::size_t block = 512; ///< points summed before being added to the total

/// Returns weighted means of K sums over the points; `sums(begin, size)` gives those of up to `block` points.
/// Summing in blocks keeps the rounding error from growing with n.
template <std::size_t K, class Sums>
std::array<double, K> weightedMean(std::span<const std::size_t> groups, const Sums &sums) {
    const auto counting = std::count_if(groups.begin(), groups.end(), [](std::size_t n) { return n > 0; });
    std::array<double, K> mean{};
    std::size_t begin = 0;
    for (const std::size_t size : groups) {
        std::array<double, K> group{};
        for (const std::size_t end = begin + size; begin < end;) {
            const std::size_t count = std::min(block, end - begin);
            const std::array<double, K> part = sums(begin, count);
            for (std::size_t k = 0; k < K; ++k)
                group[k] += part[k];
            begin += count;
        }
        for (std::size_t k = 0; k < K && size > 0; ++k)
            mean[k] += group[k] / (static_cast<double>(size) * static_cast<double>(counting));
    }
    return mean;
}

/// Returns the smallest weight of a point.
double leastWeight(std::span<const std::size_t> groups) {
    const auto counting = std::count_if(groups.begin(), groups.end(), [](std::size_t n) { return n > 0; });
    return 1 / (static_cast<double>(counting) * static_cast<double>(std::ranges::max(groups)));
}

bool threeDistinct(PointsView points) {
    std::size_t second = 1;
    while (second < points.size() && points[second] == points[0])
        ++second;
    for (std::size_t i = second + 1; i < points.size(); ++i)
        if (points[i] != points[0] && points[i] != points[second])
            return true;
    return false;
}

/// Moments about the mean.
struct Scatter {
    Point mean;
    double xx, xy, yy, xz, yz; // z = x² + y²

    /// Variance across the straight line through the points, i.e. the mean square distance from it, which
    /// circles can approach arbitrarily closely.
    [[nodiscard]] double across() const { return (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy); }
};

// NOLINTBEGIN(modernize-avoid-c-arrays): rows as columnsums::sumUp makes them

/// x, y, x², xy, y², xz, yz about an origin.
struct MomentTerms {
    static constexpr std::size_t number = 7;
    static constexpr std::size_t columns = 2;
    const double *column[columns]{}; ///< abscissae, ordinates
    Point origin;

    template <class Value>
    [[gnu::always_inline]] inline void of(const Value (&c)[columns], Value (&values)[number]) const {
        const Value x = c[0] - origin.x;
        const Value y = c[1] - origin.y;
        const Value z = x * x + y * y;
        values[0] = x;
        values[1] = y;
        values[2] = x * x;
        values[3] = x * y;
        values[4] = y * y;
        values[5] = x * z;
        values[6] = y * z;
    }
};

// NOLINTEND(modernize-avoid-c-arrays)

/// Returns an evenly spaced subset of the points, enough to choose a start.
Points thinned(PointsView points) {
    constexpr std::size_t most = 1000;
    const std::size_t every = (points.size() + most - 1) / most;
    Points some;
    for (std::size_t i = 0; i < points.size(); i += every) {
        some.x.push_back(points.x[i]);
        some.y.push_back(points.y[i]);
    }
    return some;
}

Point middleOf(const Points &points) {
    const auto count = static_cast<double>(points.size());
    return {std::accumulate(points.x.begin(), points.x.end(), 0.0) / count,
            std::accumulate(points.y.begin(), points.y.end(), 0.0) / count};
}

/// Mean and moments, usually in one pass instead of two: about a point near the mean, then shifted to the
/// mean, which is accurate if the two are close; otherwise repeated about the mean.
Scatter scatterOf(PointsView points, std::span<const std::size_t> groups) {
    Point origin = middleOf(thinned(points));
    Scatter s{};
    for (int look = 0; look < 2; ++look) {
        const auto m = weightedMean<MomentTerms::number>(groups, [&](std::size_t begin, std::size_t size) {
            return columnsums::sumsOf(MomentTerms{{&points.x[begin], &points.y[begin]}, origin}, size);
        });
        const double square = m[0] * m[0] + m[1] * m[1];
        s.mean = {origin.x + m[0], origin.y + m[1]};
        s.xx = m[2] - m[0] * m[0];
        s.xy = m[3] - m[0] * m[1];
        s.yy = m[4] - m[1] * m[1];
        const double z = m[2] + m[4];
        s.xz = m[5] - 2 * (m[0] * m[2] + m[1] * m[3]) - m[0] * z + 2 * m[0] * square;
        s.yz = m[6] - 2 * (m[0] * m[3] + m[1] * m[4]) - m[1] * z + 2 * m[1] * square;
        constexpr double near = 0.01; // of the variance
        if (!(square > near * (s.xx + s.yy)))
            break;
        origin = s.mean;
    }
    return s;
}

/// Returns the unit normal of the straight line through the points.
Point normalOf(const Scatter &s) {
    const double angle = std::atan2(2 * s.xy, s.xx - s.yy) / 2;
    return {-std::sin(angle), std::cos(angle)};
}

/// True if collinear to coordinate rounding: r.m.s. distance from the principal axis of a few ulp.
bool collinear(PointsView points, std::span<const std::size_t> groups, const Scatter &s) {
    const Point normal = normalOf(s);
    const double length = std::sqrt(s.xx + s.yy);
    const double few = 4 * epsilon * (length + std::abs(s.mean.x) + std::abs(s.mean.y));
    // Moments suffice if they show a width far above their own rounding: no pass over the points.
    constexpr double rounding = 1e-11;
    if (s.across() > rounding * (s.xx + s.yy) + 4 * few * few)
        return false;
    const auto [square] = weightedMean<1>(groups, [&](std::size_t begin, std::size_t size) {
        std::array<double, 1> sum{};
        for (std::size_t i = begin; i < begin + size; ++i) {
            const double d = normal.x * (points.x[i] - s.mean.x) + normal.y * (points.y[i] - s.mean.y);
            sum[0] += d * d;
        }
        return sum;
    });
    return std::sqrt(square) <= few;
}

/// Weighted means at a centre (relative to the mean of the points), with R close to mean r.
struct Linearised {
    double R;
    double ux, uy, uxx, uxy, uyy; // u
    double f, fx, fy, ff;         // f = r − R, f·u, f²
    double bxx, bxy, byy;         // f/r·(1 − u·uᵀ): curvature of the circles about the points

    [[nodiscard]] double radius() const { return R + f; }
    [[nodiscard]] double variance() const { return std::max(0.0, ff - f * f); }
};

/// Terms of the sums for a block of points.
struct Directions {
    std::array<double, block> ux, uy, f, bend; // u, r − R, f/r
};

/// A plain loop, so that the compiler can vectorise it for the function it is inlined into.
[[gnu::always_inline]] inline void directions(const double *x, const double *y, std::size_t size,
                                              Point origin, Point c, double R, Directions &into) {
    constexpr double tiny = std::numeric_limits<double>::min(); // a point at c has no effect
    for (std::size_t i = 0; i < size; ++i) {
        const double dx = (x[i] - origin.x) - c.x;
        const double dy = (y[i] - origin.y) - c.y;
        const double r = __builtin_sqrt(dx * dx + dy * dy);
        const double inverse = 1 / (r > tiny ? r : tiny);
        const double f = r - R;
        into.ux[i] = dx * inverse;
        into.uy[i] = dy * inverse;
        into.f[i] = f;
        into.bend[i] = f * inverse;
    }
}

// NOLINTBEGIN(modernize-avoid-c-arrays): rows as columnsums::sumUp makes them

/// In the order of the members of Linearised.
struct LinearTerms {
    static constexpr std::size_t number = 12;
    static constexpr std::size_t columns = 4;
    const double *column[columns]{}; ///< the columns of Directions

    template <class Value>
    [[gnu::always_inline]] inline void of(const Value (&c)[columns], Value (&values)[number]) const {
        const Value &ux = c[0];
        const Value &uy = c[1];
        const Value &f = c[2];
        const Value &bend = c[3];
        values[0] = ux;
        values[1] = uy;
        values[2] = ux * ux;
        values[3] = ux * uy;
        values[4] = uy * uy;
        values[5] = f;
        values[6] = f * ux;
        values[7] = f * uy;
        values[8] = f * f;
        values[9] = bend * uy * uy;
        values[10] = -bend * ux * uy;
        values[11] = bend * ux * ux;
    }
};

// NOLINTEND(modernize-avoid-c-arrays)

Linearised linearise(PointsView points, std::span<const std::size_t> groups, Point mean, Point c, double R) {
    Directions of; // NOLINT(cppcoreguidelines-pro-type-member-init): what is read is written before
    const auto m = weightedMean<LinearTerms::number>(groups, [&](std::size_t begin, std::size_t size) {
        inAvailableRegisters([&](auto) __attribute__((always_inline)) {
            directions(&points.x[begin], &points.y[begin], size, mean, c, R, of);
        });
        return columnsums::sumsOf(LinearTerms{{of.ux.data(), of.uy.data(), of.f.data(), of.bend.data()}},
                                  size);
    });
    return {R, m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]};
}

/// Returns the smaller eigenvalue of half the second derivatives of the variance of r.
double leastCurvature(const Linearised &at) {
    const double xx = at.uxx - at.ux * at.ux + at.bxx;
    const double xy = at.uxy - at.ux * at.uy + at.bxy;
    const double yy = at.uyy - at.uy * at.uy + at.byy;
    return (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
}

/// Returns the step to the minimum of a quadratic model of the variance of r in c: from products of first
/// derivatives only (Gauss–Newton), or with second derivatives (Newton). Null if the model has no minimum.
std::optional<Point> step(const Linearised &at, bool secondDerivatives) {
    const double xx = at.uxx - at.ux * at.ux + (secondDerivatives ? at.bxx : 0);
    const double xy = at.uxy - at.ux * at.uy + (secondDerivatives ? at.bxy : 0);
    const double yy = at.uyy - at.uy * at.uy + (secondDerivatives ? at.byy : 0);
    const double gx = at.fx - at.ux * at.f;
    const double gy = at.fy - at.uy * at.f;
    const double det = xx * yy - xy * xy;
    if (!(det > 0) || !(xx > 0))
        return std::nullopt;
    const Point result{(gx * yy - gy * xy) / det, (gy * xx - gx * xy) / det};
    return std::isfinite(result.x + result.y) ? std::optional(result) : std::nullopt;
}

/// Returns a step guaranteed to end at the minimum within the tolerance, so that no further pass is needed;
/// otherwise null. Along it the second derivatives of half the variance, D²φ, change by at most |D³φ|·|Δ|,
///     D³φ = 3·cov(Dr, D²r) + cov(f, D³r),   |D³φ| ≤ 3/r + 1.2·max|f|/r² < 5/r,   r the least distance,
/// i.e. by the fraction q = 5·|Δ|/(r·λ) of their least eigenvalue λ; for q ≤ ½ the step misses the minimum by
/// at most q·|Δ|. No point is farther from the circle R than √(mean f²/least weight).
std::optional<Point> lastStep(const Linearised &at, double leastWeight, double tolerance) {
    const std::optional<Point> move = step(at, true);
    const double curvature = leastCurvature(at);
    if (!move || !(curvature > 0))
        return std::nullopt;
    const double length = std::hypot(move->x, move->y);
    const double nearest = at.R - std::sqrt(at.ff / leastWeight) - length;
    const double part = 5 * length / (nearest * curvature);
    if (!(nearest > at.R / 2) || !(part <= 0.5) || !(part * length <= tolerance * at.R))
        return std::nullopt;
    return move;
}

/// State after the last step: r falls by u·Δ, and half the variance by half of its slope times Δ.
Linearised moved(Linearised at, Point by) {
    const double gx = at.fx - at.ux * at.f;
    const double gy = at.fy - at.uy * at.f;
    const double variance = std::max(0.0, at.variance() - (gx * by.x + gy * by.y));
    at.f -= at.ux * by.x + at.uy * by.y;
    at.ff = variance + at.f * at.f;
    return at;
}

struct Fit {
    Status status = Status::notConverged;
    Point c; ///< relative to the mean of the points
    Linearised at{};
    int iterations = 0;
};

/// Returns collinear if the radius reaches the largest at which the points are not a line.
Status statusAt(double radius, double largestRadius) {
    return radius < largestRadius ? Status::converged : Status::collinear;
}

/// Iterates from a start with Gauss–Newton, and with Newton near the end.
Fit fitFrom(Point c, double R, PointsView points, std::span<const std::size_t> groups, Point mean,
            double largestRadius, const LeastSquaresCircleOptions &options) {
    Fit fit{Status::notConverged, c, linearise(points, groups, mean, c, R)};
    double before = std::numeric_limits<double>::infinity(); // length of the step
    const double weight = leastWeight(groups);
    while (fit.iterations < options.maxIterations) {
        ++fit.iterations;
        const Linearised at = fit.at;
        const double radius = at.radius();
        if (const auto last = lastStep(at, weight, options.tolerance)) {
            fit.c = {fit.c.x + last->x, fit.c.y + last->y};
            fit.at = moved(at, *last);
            fit.status = statusAt(fit.at.radius(), largestRadius);
            return fit;
        }
        std::optional<Point> move = step(at, false);
        if (!move || !(radius < largestRadius)) {
            fit.status = Status::collinear;
            return fit;
        }
        // Far from the minimum steps overshoot: the centre of a short arc would move out to a line.
        if (const double whole = std::hypot(move->x, move->y); whole > radius)
            move = Point{move->x * radius / whole, move->y * radius / whole};
        const auto after = [&](Point by) {
            return linearise(points, groups, mean, {fit.c.x + by.x, fit.c.y + by.y},
                             radius - at.ux * by.x - at.uy * by.y);
        };
        // Below this the sum of squares is only rounding error and cannot judge the step.
        const double noise = 4 * epsilon * radius * (std::sqrt(at.variance()) + epsilon * radius);
        fit.at = after(*move);
        double length = std::hypot(move->x, move->y);
        if (length > before / quick) {
            // Large residuals: near the minimum, second derivatives speed up slow convergence.
            const std::optional<Point> newton = step(at, true);
            const Linearised there = newton ? after(*newton) : fit.at;
            if (newton && there.variance() <= std::min(fit.at.variance(), at.variance()) + noise) {
                move = newton;
                fit.at = there;
                length = std::hypot(move->x, move->y);
            }
        }
        for (int halvings = 0; fit.at.variance() > at.variance() + noise && halvings < 40; ++halvings) {
            move = Point{move->x / 2, move->y / 2};
            fit.at = after(*move);
        }
        fit.c = {fit.c.x + move->x, fit.c.y + move->y};
        // Converged, or at the rounding floor, where neither steps nor sum of squares shrink any more.
        const double floor = std::max(1e-12, 64 * epsilon / leastCurvature(fit.at)) * radius;
        const bool still = length > before / 2 && at.variance() - fit.at.variance() <= noise;
        if (length <= options.tolerance * radius || (length <= floor && still)) {
            fit.status = statusAt(fit.at.radius(), largestRadius);
            return fit;
        }
        before = length;
    }
    return fit;
}

/// Returns the centre with the smallest sum among candidates on both sides of the line through the points,
/// near to far. Descent from there cannot end in the line if a circle is better.
Point startAcross(Point normal, double extent, PointsView points, std::span<const std::size_t> groups,
                  Point mean) {
    constexpr int distances = 24; // up to 10⁶ extents: beyond that the points are as straight as a line
    Point best;
    double least = std::numeric_limits<double>::infinity();
    for (const double side : {extent / 4, -extent / 4}) {
        double distance = side;
        for (int i = 0; i < distances; ++i, distance *= 2) {
            const Point c{distance * normal.x, distance * normal.y};
            const double variance =
                linearise(points, groups, mean, c, std::hypot(extent, distance)).variance();
            if (variance < least) {
                least = variance;
                best = c;
            }
        }
    }
    return best;
}

/// Returns local minima of the sum on a grid of directions and distances: centres relative to the mean of the
/// points, those with the smallest sums.
std::vector<Point> startsAround(double extent, PointsView points, Point mean) {
    constexpr int directions = 36;
    constexpr int distances = 34; // by √2, up to 3 000 extents: beyond that short arcs are lines
    constexpr std::size_t most = 20;
    const Points some = thinned(points);
    const std::array<std::size_t, 1> all{some.size()};
    struct Node {
        Point c;
        double variance = 0;
    };
    std::vector<Node> net;
    for (int i = 0; i < distances; ++i) {
        const double distance = extent / 32 * std::pow(2, i / 2.0);
        for (int k = 0; k < directions; ++k) {
            const Point towards = direction(k * 360.0 / directions);
            const Point c{distance * towards.x, distance * towards.y};
            net.push_back({c, linearise(some.view(), all, mean, c, std::hypot(extent, distance)).variance()});
        }
    }
    const auto at = [&](int i, int k) -> const Node & {
        const int index = i * directions + (k + directions) % directions;
        return net[static_cast<std::size_t>(index)];
    };
    std::vector<Node> lowest;
    for (int i = 0; i < distances; ++i) {
        for (int k = 0; k < directions; ++k) {
            bool isLowest = true;
            for (int di = -1; di <= 1; ++di)
                for (int dk = -1; dk <= 1; ++dk)
                    isLowest = isLowest && (i + di < 0 || i + di >= distances ||
                                            at(i, k).variance <= at(i + di, k + dk).variance);
            if (isLowest)
                lowest.push_back(at(i, k));
        }
    }
    std::ranges::sort(lowest, {}, &Node::variance);
    lowest.resize(std::min(lowest.size(), most));
    std::vector<Point> starts;
    starts.reserve(lowest.size());
    for (const Node &node : lowest)
        starts.push_back(node.c);
    return starts;
}

/// True if other local minima must be searched. Short arcs with large residuals may have several, but only if
/// the residuals are as large as the bend of the arc, or large compared with the extent of the points.
bool needsOthers(const Fit &fit, double extent) {
    constexpr double large = 0.02;
    const double bend = 1 - std::hypot(fit.at.ux, fit.at.uy);
    const double deviation = std::sqrt(fit.at.variance());
    return fit.status != Status::converged || 2 * deviation > bend * fit.at.radius() ||
           deviation > large * extent;
}

LeastSquaresCircle circleOf(const Fit &fit, PointsView points, Point mean) {
    const RadiusExtremes extremes = radiusExtremes(points, fit.c, mean);
    LeastSquaresCircle circle;
    circle.status = fit.status;
    circle.iterations = fit.iterations;
    circle.centre = {mean.x + fit.c.x, mean.y + fit.c.y};
    circle.radius = fit.at.radius();
    circle.innerRadius = extremes.inner;
    circle.outerRadius = extremes.outer;
    circle.nearest = extremes.nearest;
    circle.farthest = extremes.farthest;
    circle.rms = std::sqrt(fit.at.variance());
    return circle;
}

} // namespace

LeastSquaresCircle leastSquaresCircle(PointsView points, const LeastSquaresCircleOptions &options) {
    assert(points.x.size() == points.y.size());
    const std::array<std::size_t, 1> all{points.size()};
    const std::span<const std::size_t> groups = options.groups.empty() ? std::span(all) : options.groups;
    assert(std::accumulate(groups.begin(), groups.end(), std::size_t{0}) == points.size());

    const auto refused = [](Status status) {
        LeastSquaresCircle circle;
        circle.status = status;
        return circle;
    };
    if (points.size() == 0)
        return refused(Status::tooFewPoints);

    const Scatter s = scatterOf(points, groups);
    const Point mean = s.mean;
    if (!std::isfinite(s.xx + s.yy + s.xz + s.yz))
        return refused(Status::notFinite);
    if (!threeDistinct(points))
        return refused(Status::tooFewPoints);
    if (collinear(points, groups, s))
        return refused(Status::collinear);

    // Algebraic start, about the mean: S·c = ½·(Σwuz, Σwvz), R² = |c|² + Σwz.
    const double extent = std::sqrt(s.xx + s.yy);
    const double determinant = s.xx * s.yy - s.xy * s.xy;
    if (!(determinant > 0))
        return refused(Status::collinear);
    const Point start{(s.xz * s.yy - s.yz * s.xy) / (2 * determinant),
                      (s.yz * s.xx - s.xz * s.xy) / (2 * determinant)};
    const double R = std::sqrt(start.x * start.x + start.y * start.y + s.xx + s.yy);
    // A circle whose sagitta over the points is lost in rounding is a straight line.
    const double largestRadius = extent * 1e8;
    Fit fit = fitFrom(start, R, points, groups, mean, largestRadius, options);
    if (needsOthers(fit, extent)) {
        for (const Point &c : startsAround(extent, points, mean)) {
            const Fit other = fitFrom(c, std::hypot(extent, std::hypot(c.x, c.y)), points, groups, mean,
                                      largestRadius, options);
            if (other.status == Status::converged &&
                (fit.status != Status::converged || other.at.variance() < fit.at.variance()))
                fit = other;
        }
        // A local minimum is not enough if a line is better than all circles.
        if (fit.status == Status::converged && fit.at.variance() > s.across() * (1 + lineMargin))
            fit.status = Status::collinear;
    }
    if (fit.status != Status::converged) {
        const Point across = startAcross(normalOf(s), extent, points, groups, mean);
        fit = fitFrom(across, std::hypot(extent, std::hypot(across.x, across.y)), points, groups, mean,
                      largestRadius, options);
    }
    if (fit.status != Status::converged)
        return refused(fit.status);

    return circleOf(fit, points, mean);
}

} // namespace palmer
