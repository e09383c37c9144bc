#include "kernel/numerics/leastsquarescircle.h"

#include "kernel/numerics/radiusextremes.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace palmer {

namespace {

using Status = LeastSquaresCircle::Status;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Two points side by side in a register.
using Pair = Eigen::Array<double, 2, 1>;

/// Σ w_i·term(x_i, y_i) of K terms, two points at a time, in blocks so that rounding does not grow with n.
template <std::size_t K, class Term>
std::array<double, K> weightedMean(PointsView points, std::span<const std::size_t> groups, Term term) {
    constexpr std::size_t block = 512;
    const auto counting = std::count_if(groups.begin(), groups.end(), [](std::size_t n) { return n > 0; });
    std::array<double, K> mean{};
    std::size_t begin = 0;
    for (const std::size_t size : groups) {
        std::array<double, K> group{};
        for (const std::size_t end = begin + size; begin < end;) {
            std::array<Pair, K> part;
            part.fill(Pair::Zero());
            const std::size_t stop = std::min(begin + block, end);
            for (; begin + 2 <= stop; begin += 2) {
                const std::array<Pair, K> value = term(Pair(Eigen::Map<const Pair>(&points.x[begin])),
                                                       Pair(Eigen::Map<const Pair>(&points.y[begin])));
                for (std::size_t k = 0; k < K; ++k)
                    part[k] += value[k];
            }
            if (begin < stop) { // an odd one out
                const std::array<Pair, K> value =
                    term(Pair::Constant(points.x[begin]).eval(), Pair::Constant(points.y[begin]).eval());
                for (std::size_t k = 0; k < K; ++k)
                    part[k][0] += value[k][0];
                ++begin;
            }
            for (std::size_t k = 0; k < K; ++k)
                group[k] += part[k].sum();
        }
        for (std::size_t k = 0; k < K && size > 0; ++k)
            mean[k] += group[k] / (static_cast<double>(size) * static_cast<double>(counting));
    }
    return mean;
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
    double xx, xy, yy, xz, yz; // z = x² + y²
};

/// Collinear to the rounding of the coordinates: the r.m.s. distance from the principal axis is a few ulp.
bool collinear(PointsView points, std::span<const std::size_t> groups, Point mean, const Scatter &s) {
    const double angle = std::atan2(2 * s.xy, s.xx - s.yy) / 2;
    const Point normal{-std::sin(angle), std::cos(angle)};
    const double length = std::sqrt(s.xx + s.yy);
    const auto [square] = weightedMean<1>(points, groups, [&](const Pair &x, const Pair &y) {
        const Pair d = normal.x * (x - mean.x) + normal.y * (y - mean.y);
        return std::array<Pair, 1>{d * d};
    });
    return std::sqrt(square) <= 4 * epsilon * (length + std::abs(mean.x) + std::abs(mean.y));
}

/// Weighted means at a centre (about the mean of the points), R being a value near that of mean r.
struct Linearised {
    double ux, uy, uxx, uxy, uyy; // u
    double f, fx, fy, ff;         // f = r − R, f·u, f²

    [[nodiscard]] double variance() const { return std::max(0.0, ff - f * f); }
};

Linearised linearise(PointsView points, std::span<const std::size_t> groups, Point mean, Point c, double R) {
    const auto m = weightedMean<9>(points, groups, [&](const Pair &x, const Pair &y) {
        const Pair dx = (x - mean.x) - c.x;
        const Pair dy = (y - mean.y) - c.y;
        const Pair r = (dx * dx + dy * dy).sqrt();
        const Pair inverse = 1 / r.max(std::numeric_limits<double>::min()); // a point at c pulls nowhere
        const Pair ux = dx * inverse;
        const Pair uy = dy * inverse;
        const Pair f = r - R;
        return std::array<Pair, 9>{ux, uy, ux * ux, ux * uy, uy * uy, f, f * ux, f * uy, f * f};
    });
    return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}

} // namespace

LeastSquaresCircle leastSquaresCircle(PointsView points, const LeastSquaresCircleOptions &options) {
    assert(points.x.size() == points.y.size());
    const std::array<std::size_t, 1> all{points.size()};
    const std::span<const std::size_t> groups = options.groups.empty() ? std::span(all) : options.groups;
    assert(std::accumulate(groups.begin(), groups.end(), std::size_t{0}) == points.size());

    LeastSquaresCircle circle;
    const auto refused = [&](Status status) {
        circle = {};
        circle.status = status;
        return circle;
    };
    if (points.size() == 0)
        return refused(Status::tooFewPoints);

    const auto [meanX, meanY] = weightedMean<2>(points, groups, [](const Pair &x, const Pair &y) {
        return std::array<Pair, 2>{x, y};
    });
    const Point mean{meanX, meanY};
    const auto moments = weightedMean<5>(points, groups, [&](const Pair &x, const Pair &y) {
        const Pair u = x - mean.x;
        const Pair v = y - mean.y;
        const Pair z = u * u + v * v;
        return std::array<Pair, 5>{u * u, u * v, v * v, u * z, v * z};
    });
    const Scatter s{moments[0], moments[1], moments[2], moments[3], moments[4]};
    if (!std::isfinite(s.xx + s.yy + s.xz + s.yz))
        return refused(Status::notFinite);
    if (!threeDistinct(points))
        return refused(Status::tooFewPoints);
    if (collinear(points, groups, mean, s))
        return refused(Status::collinear);

    // Algebraic start, about the mean: S·c = ½·(Σwuz, Σwvz), R² = |c|² + Σwz.
    const double extent = std::sqrt(s.xx + s.yy);
    const double determinant = s.xx * s.yy - s.xy * s.xy;
    if (!(determinant > 0))
        return refused(Status::collinear);
    Point c{(s.xz * s.yy - s.yz * s.xy) / (2 * determinant), (s.yz * s.xx - s.xz * s.xy) / (2 * determinant)};
    double R = std::sqrt(c.x * c.x + c.y * c.y + s.xx + s.yy);

    // A radius of which the sagitta over the points is lost in rounding is a straight line.
    const double largestRadius = extent * 1e8;
    Linearised at = linearise(points, groups, mean, c, R);
    double lastStep = std::numeric_limits<double>::infinity();
    circle.status = Status::notConverged;
    while (circle.iterations < options.maxIterations) {
        ++circle.iterations;
        R += at.f;
        const double xx = at.uxx - at.ux * at.ux;
        const double xy = at.uxy - at.ux * at.uy;
        const double yy = at.uyy - at.uy * at.uy;
        const double gx = at.fx - at.ux * at.f;
        const double gy = at.fy - at.uy * at.f;
        const double det = xx * yy - xy * xy;
        if (!(det > 0) || !(R < largestRadius))
            return refused(Status::collinear);
        Point step{(gx * yy - gy * xy) / det, (gy * xx - gx * xy) / det};
        const double length = std::hypot(step.x, step.y);
        if (!std::isfinite(length))
            return refused(Status::collinear);

        Linearised next = linearise(points, groups, mean, {c.x + step.x, c.y + step.y}, R);
        // Below this the sum of squares is all rounding, and says nothing about the step.
        const double noise = 4 * epsilon * R * (std::sqrt(at.variance()) + epsilon * R);
        for (int halvings = 0; next.variance() > at.variance() + noise && halvings < 40; ++halvings) {
            step = {step.x / 2, step.y / 2};
            next = linearise(points, groups, mean, {c.x + step.x, c.y + step.y}, R);
        }
        c = {c.x + step.x, c.y + step.y};
        at = next;
        // Done, or at the floor of rounding where the steps no longer shrink.
        if (length <= options.tolerance * R || (length <= 1e-12 * R && length > lastStep / 2)) {
            circle.status = Status::converged;
            break;
        }
        lastStep = length;
    }
    R += at.f;
    if (!(R < largestRadius))
        return refused(Status::collinear);

    const RadiusExtremes extremes = radiusExtremes(points, c, mean);
    circle.centre = {mean.x + c.x, mean.y + c.y};
    circle.radius = R;
    circle.innerRadius = extremes.inner;
    circle.outerRadius = extremes.outer;
    circle.nearest = extremes.nearest;
    circle.farthest = extremes.farthest;
    circle.rms = std::sqrt(at.variance());
    return circle;
}

} // namespace palmer
