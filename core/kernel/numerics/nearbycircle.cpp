// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/nearbycircle.h"

#include "kernel/numerics/columnsums.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

// NOLINTBEGIN(modernize-avoid-c-arrays): rows as columnsums::sumUp makes them

/// The first step.
struct FirstStep {
    static constexpr std::size_t number = 2;
    static constexpr std::size_t columns = 3;
    const double *column[columns]{}; ///< change, step per unit change

    template <class Value>
    [[gnu::always_inline]] inline void of(const Value (&c)[columns], Value (&values)[number]) const {
        values[0] = c[0] * c[1];
        values[1] = c[0] * c[2];
    }
};

/// f, u and f·u at a centre.
struct Distances {
    static constexpr std::size_t number = 5;
    static constexpr std::size_t columns = 7;
    const double *column[columns]{}; ///< change, then the columns of a set
    Point delta;

    template <class Value>
    [[gnu::always_inline]] inline void of(const Value (&c)[columns], Value (&values)[number]) const {
        const Value &wx = c[1];
        const Value &wy = c[2];
        const Value a = c[0] * c[3] - (delta.x * wx + delta.y * wy);
        const Value b = c[0] * c[4] + (delta.x * wy - delta.y * wx);
        const Value turn = b * c[6]; // rotation of the direction
        values[0] = (c[5] + a) + 0.5 * b * turn;
        const Value sideways = turn - turn * (a * c[6]);
        const Value shorter = 1.0 - 0.5 * turn * turn;
        values[1] = wx * shorter - sideways * wy;
        values[2] = wy * shorter + sideways * wx;
        values[3] = values[0] * values[1];
        values[4] = values[0] * values[2];
    }
};

// NOLINTEND(modernize-avoid-c-arrays)

} // namespace

NearbyCircle::NearbyCircle(std::span<const Rays *const> sets, Point centre)
    : m_centre(centre)
    , m_least(std::numeric_limits<double>::infinity()) {
    const double weight = 1 / static_cast<double>(sets.size());
    for (const Rays *rays : sets) {
        const Points points = rays->reference();
        const std::size_t n = points.size();
        const std::vector<double> empty(n);
        Set set{empty, empty, empty, empty, empty, empty, empty, empty};
        for (std::size_t i = 0; i < n; ++i) {
            const double dx = points.x[i] - centre.x;
            const double dy = points.y[i] - centre.y;
            const double r = std::sqrt(dx * dx + dy * dy);
            const Point u = rays->direction(i);
            const Point w{dx / r, dy / r};
            set.wx[i] = w.x;
            set.wy[i] = w.y;
            set.along[i] = u.x * w.x + u.y * w.y;
            set.across[i] = u.y * w.x - u.x * w.y;
            set.residual[i] = r;
            set.inverse[i] = 1 / r;
            m_least = std::min(m_least, r);
            m_across = std::max(m_across, std::abs(set.across[i]));
            m_radius += r * weight / static_cast<double>(n);
        }
        m_sets.push_back(std::move(set));
    }
    // Half the second derivatives of the variance of r, as in leastSquaresCircle.
    double ux = 0;
    double uy = 0;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (Set &set : m_sets) {
        const double each = weight / static_cast<double>(set.wx.size());
        for (std::size_t i = 0; i < set.wx.size(); ++i) {
            set.residual[i] -= m_radius;
            m_residual = std::max(m_residual, std::abs(set.residual[i]));
            const double x = set.wx[i];
            const double y = set.wy[i];
            const double bend = set.residual[i] * set.inverse[i];
            ux += x * each;
            uy += y * each;
            xx += (x * x + bend * y * y) * each;
            xy += (x * y - bend * x * y) * each;
            yy += (y * y + bend * x * x) * each;
        }
    }
    xx -= ux * ux;
    xy -= ux * uy;
    yy -= uy * uy;
    const double determinant = xx * yy - xy * xy;
    m_xx = yy / determinant;
    m_xy = -xy / determinant;
    m_yy = xx / determinant;
    for (Set &set : m_sets) {
        const double each = weight / static_cast<double>(set.wx.size());
        for (std::size_t i = 0; i < set.wx.size(); ++i) {
            // Derivative of the gradient with respect to the change of a point.
            const double sideways = set.residual[i] * set.across[i] * set.inverse[i];
            const double gx = (set.along[i] * (set.wx[i] - ux) - sideways * set.wy[i]) * each;
            const double gy = (set.along[i] * (set.wy[i] - uy) + sideways * set.wx[i]) * each;
            set.stepX[i] = m_xx * gx + m_xy * gy;
            set.stepY[i] = m_xy * gx + m_yy * gy;
        }
    }
}

Point NearbyCircle::firstStep(std::span<const Rays::Look *const> looks) const {
    Point result;
    for (std::size_t k = 0; k < m_sets.size(); ++k) {
        const Set &set = m_sets[k];
        const FirstStep step{{looks[k]->changes.data(), set.stepX.data(), set.stepY.data()}};
        const auto [x, y] = columnsums::sumsOf(step, set.wx.size());
        result = {result.x + x, result.y + y};
    }
    return result;
}

NearbyCircle::Means NearbyCircle::means(std::span<const Rays::Look *const> looks, Point delta) const {
    Means all;
    const double weight = 1 / static_cast<double>(m_sets.size());
    for (std::size_t k = 0; k < m_sets.size(); ++k) {
        const Set &set = m_sets[k];
        const Distances distances{{looks[k]->changes.data(), set.wx.data(), set.wy.data(), set.along.data(),
                                   set.across.data(), set.residual.data(), set.inverse.data()},
                                  delta};
        const std::size_t n = set.wx.size();
        const auto [f, ux, uy, fx, fy] = columnsums::sumsOf(distances, n);
        const double each = weight / static_cast<double>(n);
        all = {all.f + f * each, all.ux + ux * each, all.uy + uy * each, all.fx + fx * each,
               all.fy + fy * each};
    }
    return all;
}

Point NearbyCircle::step(const Means &means) const {
    const Point g = means.gradient();
    return {m_xx * g.x + m_xy * g.y, m_xy * g.x + m_yy * g.y};
}

std::optional<NearbyCircle::Fit> NearbyCircle::fit(std::span<const Rays::Look *const> looks) const {
    double largest = 0;
    for (const Rays::Look *look : looks)
        largest = std::max(largest, look->largest);
    const Point first = firstStep(looks);
    const Means at = means(looks, first);
    const Point second = step(at);
    // Terms neglected in the gradient and the radius, and the size of a third step.
    const double moved = std::hypot(first.x, first.y);
    const double a = largest + moved;
    const double b = largest * m_across + moved;
    const double relative = (a + b) / m_least;
    const double stiffness = std::abs(m_xx) + std::abs(m_xy) + std::abs(m_yy);
    const double left = (b / m_least) * relative * (b + relative * (m_residual + a)) +
                        relative * std::hypot(second.x, second.y);
    constexpr double allowed = 1e-14;
    if (!(left * stiffness <= allowed * m_radius))
        return std::nullopt;
    return Fit{{m_centre.x + first.x + second.x, m_centre.y + first.y + second.y},
               m_radius + at.f - at.ux * second.x - at.uy * second.y};
}

} // namespace palmer
