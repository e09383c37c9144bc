#include "kernel/numerics/nearbycircle.h"

#include "kernel/numerics/lanes.h"

#include <algorithm>
#include <cmath>

namespace palmer {

NearbyCircle::NearbyCircle(std::span<const Rays *const> sets, Point centre)
    : m_centre(centre)
    , m_least(std::numeric_limits<double>::infinity()) {
    const double weight = 1 / static_cast<double>(sets.size());
    for (const Rays *rays : sets) {
        const Points points = rays->reference();
        const std::size_t n = points.size();
        Set set{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n),
                std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
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
    // Half the second derivatives of the variance of r: those of leastSquaresCircle.
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
}

NearbyCircle::Means NearbyCircle::meansOf(const Set &set, const std::vector<double> &changes, Point delta) {
    // One after the other for each lane: the compiler keeps the sums in registers.
    Lanes sums[5]{0, 0, 0, 0, 0};
    const Lanes dx = delta.x;
    const Lanes dy = delta.y;
    const auto add = [&](auto &into, const auto &t, const auto &wx, const auto &wy, const auto &along,
                         const auto &across, const auto &residual, const auto &inverse, const auto &x,
                         const auto &y) {
        const auto a = t * along - (x * wx + y * wy);
        const auto b = t * across + (x * wy - y * wx);
        const auto q = b * inverse;
        const auto f = (residual + a) + 0.5 * b * q;
        const auto turn = q * (1.0 - a * inverse);  // of the direction
        const auto shorter = 1.0 - 0.5 * q * q;
        const auto ux = wx * shorter - turn * wy;
        const auto uy = wy * shorter + turn * wx;
        into[0] += f;
        into[1] += ux;
        into[2] += uy;
        into[3] += f * ux;
        into[4] += f * uy;
    };
    const std::size_t n = set.wx.size();
    std::size_t i = 0;
    for (; i + Lanes::count <= n; i += Lanes::count)
        add(sums, Lanes::from(&changes[i]), Lanes::from(&set.wx[i]), Lanes::from(&set.wy[i]),
            Lanes::from(&set.along[i]), Lanes::from(&set.across[i]), Lanes::from(&set.residual[i]),
            Lanes::from(&set.inverse[i]), dx, dy);
    double rest[5]{};
    for (; i < n; ++i)
        add(rest, changes[i], set.wx[i], set.wy[i], set.along[i], set.across[i], set.residual[i],
            set.inverse[i], delta.x, delta.y);
    double mean[5];
    for (std::size_t k = 0; k < 5; ++k) {
        const auto v = sums[k].values();
        mean[k] = ((v[0] + v[1]) + (v[2] + v[3]) + rest[k]) / static_cast<double>(n);
    }
    return {mean[0], mean[1], mean[2], mean[3], mean[4]};
}

NearbyCircle::Means NearbyCircle::means(std::span<const Rays::Look *const> looks, Point delta) const {
    Means all;
    const double weight = 1 / static_cast<double>(m_sets.size());
    for (std::size_t k = 0; k < m_sets.size(); ++k) {
        const Means of = meansOf(m_sets[k], looks[k]->changes, delta);
        all.f += of.f * weight;
        all.ux += of.ux * weight;
        all.uy += of.uy * weight;
        all.fx += of.fx * weight;
        all.fy += of.fy * weight;
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
    const Point first = step(means(looks, {}));
    const Means at = means(looks, first);
    const Point second = step(at);
    // What is left out, of the gradient and of the radius, and what a third step would be.
    const double moved = std::hypot(first.x, first.y);
    const double a = largest + moved;
    const double b = largest * m_across + moved;
    const double relative = (a + b) / m_least;
    const double stiffness = std::abs(m_xx) + std::abs(m_xy) + std::abs(m_yy);
    const double left = (b / m_least) * relative * (b + relative * (m_residual + a)) +
                        relative * std::hypot(second.x, second.y);
    constexpr double allowed = 2e-15;
    if (!(left * stiffness <= allowed * m_radius))
        return std::nullopt;
    return Fit{{m_centre.x + first.x + second.x, m_centre.y + first.y + second.y},
               m_radius + at.f - at.ux * second.x - at.uy * second.y};
}

} // namespace palmer
