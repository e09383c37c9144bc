// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/rays.h"

#include "kernel/numerics/columnsums.h"
#include "kernel/numerics/lanes.h"
#include "kernel/numerics/radiusextremes.h"

#include <algorithm>
#include <cstring>

namespace palmer {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double largestOf(const Lanes &a) {
    const auto v = a.values();
    return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}

double smallestOf(const Lanes &a) {
    const auto v = a.values();
    return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
}

} // namespace

Rays::Rays(std::vector<double> ux, std::vector<double> uy, std::vector<double> radii, Point centre)
    : m_ux(std::move(ux))
    , m_uy(std::move(uy))
    , m_radii(std::move(radii))
    , m_centre(centre)
    , m_distances(m_radii.size())
    , m_along(m_radii.size())
    , m_sectorCount((m_radii.size() + sectorSize - 1) / sectorSize)
    , m_least(infinity) {
    std::vector<Point> w(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const Point d{m_radii[i] * m_ux[i] - centre.x, m_radii[i] * m_uy[i] - centre.y};
        const double r = std::sqrt(d.x * d.x + d.y * d.y);
        w[i] = r > 0 ? Point{d.x / r, d.y / r} : Point{};
        m_distances[i] = r;
        m_along[i] = m_ux[i] * w[i].x + m_uy[i] * w[i].y;
        m_across = std::max(m_across, std::abs(m_ux[i] * w[i].y - m_uy[i] * w[i].x));
        m_least = std::min(m_least, r);
        m_greatest = std::max(m_greatest, r);
    }
    for (std::size_t s = 0; s < m_sectorCount; ++s) {
        const std::size_t begin = s * sectorSize;
        const std::size_t end = std::min(size(), begin + sectorSize);
        Point mean;
        for (std::size_t i = begin; i < end; ++i) {
            mean.x += w[i].x / static_cast<double>(end - begin);
            mean.y += w[i].y / static_cast<double>(end - begin);
        }
        double spread = 0;
        for (std::size_t i = begin; i < end; ++i)
            spread = std::max(spread, std::hypot(w[i].x - mean.x, w[i].y - mean.y));
        m_sectors.wx.push_back(mean.x);
        m_sectors.wy.push_back(mean.y);
        m_sectors.spread.push_back(spread);
    }
}

Points Rays::reference() const {
    Points points;
    Look same = sample();
    same.radii = m_radii;
    fill(same, points);
    return points;
}

Rays::Look Rays::sample() const {
    return {std::vector<double>(size()), std::vector<double>(size()), 0, std::vector<double>(m_sectorCount),
            std::vector<double>(m_sectorCount)};
}

void Rays::prepare(Look &look) const {
    look.largest = 0;
    double sum = 0; // not finite if a change is not: comparisons miss it
    Lanes largest = 0;
    const std::size_t whole = size() / sectorSize;
    for (std::size_t s = 0; s < whole; ++s) {
        Lanes least = infinity;
        Lanes greatest = -infinity;
        Lanes all = 0;
        for (std::size_t i = s * sectorSize; i < (s + 1) * sectorSize; i += Lanes::count) {
            const Lanes change = Lanes::from(&look.radii[i]) - Lanes::from(&m_radii[i]);
            change.store(&look.changes[i]);
            const Lanes size = magnitude(change);
            all += size;
            largest = larger(largest, size);
            const Lanes r = Lanes::from(&m_distances[i]) + Lanes::from(&m_along[i]) * change;
            least = smaller(least, r);
            greatest = larger(greatest, r);
        }
        look.nearest[s] = smallestOf(least);
        look.farthest[s] = largestOf(greatest);
        const auto v = all.values();
        sum += (v[0] + v[1]) + (v[2] + v[3]);
    }
    look.largest = largestOf(largest);
    if (whole < m_sectorCount) {
        look.nearest[whole] = infinity;
        look.farthest[whole] = -infinity;
    }
    for (std::size_t i = whole * sectorSize; i < size(); ++i) {
        const double change = look.radii[i] - m_radii[i];
        look.changes[i] = change;
        sum += std::abs(change);
        look.largest = std::max(look.largest, std::abs(change));
        const double r = m_distances[i] + m_along[i] * change;
        look.nearest[whole] = std::min(look.nearest[whole], r);
        look.farthest[whole] = std::max(look.farthest[whole], r);
    }
    if (!std::isfinite(sum))
        look.largest = infinity;
}

void Rays::fill(const Look &look, Points &points) const {
    points.x.resize(size());
    points.y.resize(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const Point p = point(look, i);
        points.x[i] = p.x;
        points.y[i] = p.y;
    }
}

Rays::Bound Rays::boundOf(const Look &look, Point centre) const {
    const Point delta{centre.x - m_centre.x, centre.y - m_centre.y};
    const double length = std::sqrt(delta.x * delta.x + delta.y * delta.y);
    if (!(look.largest + length < m_least / 2))
        return {delta, 0, infinity, infinity};
    const double across = look.largest * m_across + length;
    const double rounding = 1e-13 * (m_greatest + look.largest);
    return {delta, length, across * across / m_least + rounding, rounding};
}

// NOLINTBEGIN(modernize-avoid-c-arrays): registers are no arguments of templates, GCC drops their width

/// Finds the outermost of the first sectors, eight at a time; returns how many it compared. One at a time,
/// with each comparison waiting for the previous one, this took most of the time of an exchange.
template <class Register>
[[gnu::always_inline]] inline std::size_t Rays::outermostOf(const Compared &c, std::size_t count,
                                                            Outermost &result) {
    using Value = typename Register::Value;
    using Index = typename Register::Index;
    constexpr std::size_t together = columnsums::together;
    constexpr std::size_t lanes = sizeof(Value) / sizeof(double);
    constexpr std::size_t parts = together / lanes;
    Value greatest[parts]{};
    Value least[parts]{};
    Index farthest[parts]{}; // the block of eight that contained it
    Index nearest[parts]{};
    for (std::size_t k = 0; k < parts; ++k) {
        greatest[k] = Value{} - infinity;
        least[k] = Value{} + infinity;
    }
    const Bound &bound = c.bound;
    std::size_t s = 0;
    for (; s + together <= count; s += together) {
        const auto block = static_cast<std::int64_t>(s);
        for (std::size_t k = 0; k < parts; ++k) {
            Value far{};
            Value near{};
            Value wx{};
            Value wy{};
            Value spread{};
            std::memcpy(&far, c.farthest + s + k * lanes, sizeof(Value));
            std::memcpy(&near, c.nearest + s + k * lanes, sizeof(Value));
            std::memcpy(&wx, c.wx + s + k * lanes, sizeof(Value));
            std::memcpy(&wy, c.wy + s + k * lanes, sizeof(Value));
            std::memcpy(&spread, c.spread + s + k * lanes, sizeof(Value));
            const Value along = bound.delta.x * wx + bound.delta.y * wy;
            far = far - along + bound.length * spread + bound.above;
            near = near - along - bound.length * spread - bound.below;
            const auto farther = far > greatest[k];
            const auto nearer = near < least[k];
            greatest[k] = farther ? far : greatest[k];
            least[k] = nearer ? near : least[k];
            farthest[k] = farther ? Index{} + block : farthest[k];
            nearest[k] = nearer ? Index{} + block : nearest[k];
        }
    }
    for (std::size_t k = 0; k < together && s > 0; ++k) {
        const std::size_t part = k / lanes;
        const std::size_t lane = k % lanes;
        if (greatest[part][lane] > result.greatest) {
            result.greatest = greatest[part][lane];
            result.farthest = static_cast<std::size_t>(farthest[part][lane]) + k;
        }
        if (least[part][lane] < result.least) {
            result.least = least[part][lane];
            result.nearest = static_cast<std::size_t>(nearest[part][lane]) + k;
        }
    }
    return s;
}

// NOLINTEND(modernize-avoid-c-arrays)

Rays::Outermost Rays::outermost(const Look &look, Point centre) const {
    const Compared compared{look.farthest.data(), look.nearest.data(),     m_sectors.wx.data(),
                            m_sectors.wy.data(),  m_sectors.spread.data(), boundOf(look, centre)};
    Outermost result;
    std::size_t s = 0;
    inAvailableRegisters([&](auto registers) __attribute__((always_inline)) {
        s = outermostOf<decltype(registers)>(compared, m_sectorCount, result);
    });
    for (; s < m_sectorCount; ++s) {
        if (const double r = farthest(look, s, compared.bound); r > result.greatest) {
            result.greatest = r;
            result.farthest = s;
        }
        if (const double r = nearest(look, s, compared.bound); r < result.least) {
            result.least = r;
            result.nearest = s;
        }
    }
    return result;
}

Rays::Extremes Rays::extremes(const Look &look, Point centre) const {
    const Bound bound = boundOf(look, centre);
    // Sectors that certainly cannot reach what one sector certainly reaches need not be searched.
    double reached = -infinity;
    double near = infinity;
    for (std::size_t s = 0; s < m_sectorCount; ++s) {
        const double wide = 2 * bound.length * m_sectors.spread[s];
        reached = std::max(reached, farthest(look, s, bound) - wide - bound.above - bound.below);
        near = std::min(near, nearest(look, s, bound) + wide + bound.above + bound.below);
    }
    double least = infinity;
    double greatest = 0;
    visitBeyond(look, centre, std::isfinite(reached) ? reached : -infinity,
                std::isfinite(near) ? near : infinity, [&](std::size_t i) {
                    const Point p = point(look, i);
                    const double d = squaredDistance(p.x, p.y, {}, centre);
                    least = std::min(least, d);
                    greatest = std::max(greatest, d);
                });
    return {std::sqrt(least), std::sqrt(greatest)};
}

} // namespace palmer
