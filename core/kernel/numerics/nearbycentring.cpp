// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/nearbycentring.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr Eigen::Index ex = 0;
constexpr Eigen::Index ey = 1;
constexpr Eigen::Index firstRadius = 2;

/// m = |R·u − e| and its first derivatives with respect to e and R.
struct Model {
    double m;
    Point w;      ///< (R·u − e)/m
    double along; ///< ∂m/∂R = u·w

    Model(Point u, double radius, Point e)
        : m(std::hypot(radius * u.x - e.x, radius * u.y - e.y))
        , w{(radius * u.x - e.x) / m, (radius * u.y - e.y) / m}
        , along(u.x * w.x + u.y * w.y) {}
};

} // namespace

NearbyCentring::NearbyCentring(std::span<const CommandedArc> arcs, const CentringError &reference)
    : m_error(reference.e)
    , m_radius(*std::ranges::min_element(reference.radii)) {
    const auto size = firstRadius + static_cast<Eigen::Index>(arcs.size());
    Eigen::MatrixXd second = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        const CommandedArc &arc = arcs[k];
        const Eigen::Index r = firstRadius + static_cast<Eigen::Index>(k);
        second(r, r) = arc.distances.empty() ? 1 : 0;
        const double each = 1 / static_cast<double>(arc.distances.size());
        for (std::size_t i = 0; i < arc.distances.size(); ++i) {
            const Point u = arc.directions[i];
            const Model at(u, reference.radii[k], reference.e);
            // ∂²m/∂a∂b = (v_a·v_b − (w·v_a)·(w·v_b))/m: components perpendicular to w. v_e = −1, v_R = u.
            const double bend = (arc.distances[i] - at.m) / at.m * each;
            const Point across{-at.w.y, at.w.x};
            const double acrossR = u.x * across.x + u.y * across.y;
            second(ex, ex) += at.w.x * at.w.x * each - bend * across.x * across.x;
            second(ex, ey) += at.w.x * at.w.y * each - bend * across.x * across.y;
            second(ey, ey) += at.w.y * at.w.y * each - bend * across.y * across.y;
            second(ex, r) += -at.w.x * at.along * each + bend * across.x * acrossR;
            second(ey, r) += -at.w.y * at.along * each + bend * across.y * acrossR;
            second(r, r) += at.along * at.along * each - bend * acrossR * acrossR;
        }
    }
    second.triangularView<Eigen::StrictlyLower>() = second.transpose();
    const Eigen::MatrixXd inverse = second.inverse();
    m_stiffness = std::max(1.0, inverse.topRows(2).norm());
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        const CommandedArc &arc = arcs[k];
        const Eigen::Index r = firstRadius + static_cast<Eigen::Index>(k);
        Set set{{arc.distances.begin(), arc.distances.end()}, {}, {}};
        const double each = 1 / static_cast<double>(arc.distances.size());
        for (std::size_t i = 0; i < arc.distances.size(); ++i) {
            const Model at(arc.directions[i], reference.radii[k], reference.e);
            const auto change = [&](Eigen::Index of) {
                return (-at.w.x * inverse(of, ex) - at.w.y * inverse(of, ey) + at.along * inverse(of, r)) *
                       each;
            };
            set.x.push_back(change(ex));
            set.y.push_back(change(ey));
        }
        m_sets.push_back(std::move(set));
    }
}

std::optional<Point> NearbyCentring::centringError(std::span<const std::span<const double>> distances) const {
    constexpr std::size_t together = 8; // parallel sums, which the compiler vectorises
    std::array<double, together> x{};
    std::array<double, together> y{};
    std::array<double, together> largest{};
    const auto add = [&](const Set &set, std::span<const double> now, std::size_t i, std::size_t lane) {
        const double change = now[i] - set.distances[i];
        x[lane] += change * set.x[i];
        y[lane] += change * set.y[i];
        const double size = std::abs(change);
        largest[lane] = largest[lane] < size ? size : largest[lane];
    };
    for (std::size_t k = 0; k < m_sets.size(); ++k) {
        const Set &set = m_sets[k];
        std::size_t i = 0;
        for (; i + together <= set.x.size(); i += together)
            for (std::size_t lane = 0; lane < together; ++lane)
                add(set, distances[k], i + lane, lane);
        for (; i < set.x.size(); ++i)
            add(set, distances[k], i, 0);
    }
    Point step;
    for (std::size_t lane = 0; lane < together; ++lane)
        step = {step.x + x[lane], step.y + y[lane]};
    const double moved = std::hypot(step.x, step.y);
    const double relative = (*std::ranges::max_element(largest) + moved) / m_radius;
    const double felt =
        m_stiffness * relative * moved * (std::hypot(m_error.x, m_error.y) + moved) / m_radius;
    if (!(felt <= 1e-14 * m_radius))
        return std::nullopt;
    return Point{m_error.x + step.x, m_error.y + step.y};
}

} // namespace palmer
