// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/nearbyhysteresis.h"

#include "kernel/evaluation/iso230_4/hysteresis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace palmer {

namespace {

using iso230_4::PolarPoint;

constexpr double turn = 2 * std::numbers::pi;
constexpr std::size_t fewestPoints = 16; ///< per path: below, the ordinary way costs little
constexpr double closePart = 0.05;       ///< of the mean step: closer neighbours are close
constexpr std::size_t mostOpen = 64;     ///< points that are always computed
constexpr std::size_t mostAround = 64;   ///< points around a computed one
constexpr std::size_t block = 64;        ///< points compared together
using Block = std::array<double, block>;

/// The columns of a range of comparisons.
struct Columns {
    const std::uint32_t *point;
    const std::uint32_t *before;
    const std::uint32_t *above;
    const double *part;
    const double *difference;
    const double *from; ///< changes
    const double *to;
    std::size_t count; ///< up to a block
};

/// |differences| of up to a block of points, padded with zeros.
void differencesOf(const Columns &c, Block &into) {
    for (std::size_t k = 0; k < c.count; ++k) {
        const double before = c.to[c.before[k]];
        const double change = (c.from[c.point[k]] - before) - c.part[k] * (c.to[c.above[k]] - before);
        into[k] = std::abs(c.difference[k] + change);
    }
    for (std::size_t k = c.count; k < block; ++k)
        into[k] = 0;
}

/// Returns the columns of the comparisons of a path from `begin`.
template <class Comparisons>
Columns columns(const Comparisons &of, std::size_t begin, const std::array<RaysLook, 2> &paths,
                std::size_t path) {
    return {of.point.data() + begin,
            of.before.data() + begin,
            of.above.data() + begin,
            of.part.data() + begin,
            of.difference.data() + begin,
            paths[path].look->changes.data(),
            paths[1 - path].look->changes.data(),
            std::min(block, of.point.size() - begin)};
}

double greatestOf(const Block &values) {
    constexpr std::size_t lanes = 8; // parallel: none waits for another
    std::array<double, lanes> greatest{};
    for (std::size_t k = 0; k < block; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            greatest[lane] = greatest[lane] < values[k + lane] ? values[k + lane] : greatest[lane];
    return *std::ranges::max_element(greatest);
}

Point unit(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

NearbyHysteresis::NearbyHysteresis(const Rays &first, const Rays &second, Point centre)
    : m_centre(centre)
    , m_least(std::numeric_limits<double>::infinity())
    , m_gap(std::numeric_limits<double>::infinity()) {
    if (std::min(first.size(), second.size()) < fewestPoints)
        return;
    m_paths = {sorted(first, centre), sorted(second, centre)};
    m_close = closePart * turn / static_cast<double>(std::max(first.size(), second.size()));
    for (Path &path : m_paths)
        addGaps(path);
    addDirections(first);
    addDirections(second);
    m_comparisons = {compare(m_paths[0], m_paths[1]), compare(m_paths[1], m_paths[0])};
    m_usable = std::isfinite(m_gap) &&
               std::max(m_comparisons[0].open.size(), m_comparisons[1].open.size()) <= mostOpen;
}

NearbyHysteresis::Path NearbyHysteresis::sorted(const Rays &rays, Point centre) {
    const Points points = rays.reference();
    std::vector<PolarPoint> polar;
    for (std::size_t i = 0; i < points.size(); ++i)
        polar.push_back(iso230_4::polarPoint(points.view()[i], centre));
    Path path;
    path.order.resize(points.size());
    std::iota(path.order.begin(), path.order.end(), 0U);
    std::ranges::sort(path.order, {}, [&](std::uint32_t i) { return polar[i].angle; });
    for (const std::uint32_t i : path.order) {
        path.angles.push_back(polar[i].angle);
        path.distances.push_back(polar[i].distance);
    }
    return path;
}

void NearbyHysteresis::addGaps(Path &path) {
    for (std::size_t k = 0; k < path.order.size(); ++k) {
        const bool last = k + 1 == path.order.size();
        const std::size_t next = last ? 0 : k + 1;
        const double gap = path.angles[next] + (last ? turn : 0) - path.angles[k];
        path.close.push_back(gap >= m_close ? 0 : 1);
        if (!(gap >= m_close))
            continue;
        m_gap = std::min(m_gap, gap);
        m_steepest = std::max(m_steepest, std::abs(path.distances[next] - path.distances[k]) / gap);
    }
}

void NearbyHysteresis::addDirections(const Rays &rays) {
    const Points points = rays.reference();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Point d{points.x[i] - m_centre.x, points.y[i] - m_centre.y};
        const double r = std::hypot(d.x, d.y);
        const Point u = rays.direction(i);
        m_across = std::max(m_across, std::abs(u.x * d.y - u.y * d.x) / r);
        m_bend = std::max(m_bend, 1 - (u.x * d.x + u.y * d.y) / r);
        m_least = std::min(m_least, r);
        m_greatest = std::max(m_greatest, r);
    }
}

NearbyHysteresis::Comparisons NearbyHysteresis::compare(const Path &from, const Path &to) {
    constexpr std::size_t near = 2; // gaps on either side that must not be close
    const std::size_t n = to.order.size();
    Comparisons result;
    result.next.resize(from.order.size());
    for (std::size_t k = 0; k < from.order.size(); ++k) {
        const double angle = from.angles[k];
        const auto found = std::ranges::lower_bound(to.angles, angle) - to.angles.begin();
        const std::size_t above = static_cast<std::size_t>(found) % n;
        const std::size_t before = (above + n - 1) % n;
        result.next[from.order[k]] = static_cast<std::uint32_t>(above);
        bool open = false;
        for (std::size_t gap = before + n - near; gap <= before + n + near; ++gap)
            open = open || to.close[gap % n] != 0;
        if (open) {
            result.open.push_back(from.order[k]);
            continue;
        }
        const double way = to.angles[above] - to.angles[before] + (above == 0 ? turn : 0);
        const double behind = angle - to.angles[before];
        const double part = (behind < 0 ? behind + turn : behind) / way;
        const Point w = unit(angle);
        const Point a = unit(to.angles[above]);
        const Point b = unit(to.angles[before]);
        m_turn = std::max(m_turn, std::hypot(w.x - b.x - part * (a.x - b.x), w.y - b.y - part * (a.y - b.y)));
        result.point.push_back(from.order[k]);
        result.before.push_back(to.order[before]);
        result.above.push_back(to.order[above]);
        result.part.push_back(part);
        result.difference.push_back(
            from.distances[k] - (to.distances[before] + part * (to.distances[above] - to.distances[before])));
    }
    return result;
}

/// Returns a bound for the error of the computed difference of any point that is not open. With c = c₀ + δ a
/// point moves by t·u − δ: along w by a = t·(u·w) − δ·w, across it by b ≤ |t|·|u × w| + |δ|.
std::optional<double> NearbyHysteresis::leftOut(double largest, Point delta) const {
    const double length = std::hypot(delta.x, delta.y);
    const double moved = largest + length; // upper bound for all points
    const double inner = m_least - moved;
    const double across = largest * m_across + length;
    if (!(inner > m_least / 2))
        return std::nullopt;
    const double turned = across / inner; // upper bound for all angles
    constexpr double part = 8;
    if (!(turned <= m_close / part))
        return std::nullopt; // neighbours that are not close might swap
    // The distances are r + a within b²/2r; a differs from t by its δ·w, which is nearly the same for the
    // neighbours, and by 1 − u·w.
    const double distances = across * across / inner + 2 * largest * m_bend + length * m_turn;
    // The polygon of the other path at an angle equals the original one at an angle at most twice the largest
    // rotation away; its sides are as steep as before, except for the movement of their ends.
    const double angles = 3 * turned * (m_steepest + 2 * moved / m_gap);
    return distances + angles + 1e-13 * (m_greatest + moved);
}

/// Uses the points of the other path on either side up to the second gap that is not close: those beyond
/// cannot come between.
std::optional<double> NearbyHysteresis::plainDifference(std::size_t path, std::uint32_t point,
                                                        const std::array<RaysLook, 2> &paths,
                                                        Point centre) const {
    const Path &other = m_paths[1 - path];
    const RaysLook &to = paths[1 - path];
    const std::size_t n = other.order.size();
    std::vector<PolarPoint> around;
    const auto take = [&](std::size_t place) {
        around.push_back(iso230_4::polarPoint(to.rays->point(*to.look, other.order[place]), centre));
    };
    constexpr int enough = 2;
    const std::size_t above = m_comparisons[path].next[point];
    std::size_t last = above;
    take(last);
    for (int gaps = 0; gaps < enough && around.size() < mostAround; last = (last + 1) % n, take(last))
        gaps += other.close[last] != 0 ? 0 : 1;
    std::size_t first = (above + n - 1) % n;
    take(first);
    for (int gaps = 0; gaps < enough && around.size() < mostAround; take(first)) {
        first = (first + n - 1) % n;
        gaps += other.close[first] != 0 ? 0 : 1;
    }
    std::ranges::sort(around, {}, &PolarPoint::angle);
    // With equal angles, or a point taken twice, the order is undefined.
    if (around.size() >= mostAround ||
        std::ranges::adjacent_find(around, {}, &PolarPoint::angle) != around.end())
        return std::nullopt;
    const RaysLook &from = paths[path];
    const PolarPoint seen = iso230_4::polarPoint(from.rays->point(*from.look, point), centre);
    return std::abs(seen.distance - iso230_4::distanceAt(around, seen.angle));
}

/// Returns the largest difference of the points of a path that may reach `least`; `greatest`: per block.
std::optional<double> NearbyHysteresis::largestOf(std::size_t path, const std::vector<double> &greatest,
                                                  double least, const std::array<RaysLook, 2> &paths,
                                                  Point centre) const {
    const Comparisons &comparisons = m_comparisons[path];
    std::vector<std::uint32_t> points = comparisons.open;
    Block values{};
    for (std::size_t k = 0; k < greatest.size(); ++k) {
        if (greatest[k] < least)
            continue;
        differencesOf(columns(comparisons, k * block, paths, path), values);
        for (std::size_t i = 0; i < std::min(block, comparisons.point.size() - k * block); ++i)
            if (values[i] >= least)
                points.push_back(comparisons.point[k * block + i]);
    }
    double result = 0;
    for (const std::uint32_t point : points) {
        const auto difference = plainDifference(path, point, paths, centre);
        if (!difference)
            return std::nullopt;
        result = std::max(result, *difference);
    }
    return result;
}

std::optional<double> NearbyHysteresis::largestDifference(const std::array<RaysLook, 2> &paths,
                                                          Point centre) const {
    if (!m_usable)
        return std::nullopt;
    const auto bound = leftOut(std::max(paths[0].look->largest, paths[1].look->largest),
                               {centre.x - m_centre.x, centre.y - m_centre.y});
    if (!bound)
        return std::nullopt;
    std::array<std::vector<double>, 2> greatest; // per block
    double all = 0;
    Block values{};
    for (std::size_t path = 0; path < paths.size(); ++path) {
        for (std::size_t begin = 0; begin < m_comparisons[path].point.size(); begin += block) {
            differencesOf(columns(m_comparisons[path], begin, paths, path), values);
            greatest[path].push_back(greatestOf(values));
            all = std::max(all, greatest[path].back());
        }
    }
    const double least = all - 2 * *bound; // smaller ones cannot be the largest
    const auto first = largestOf(0, greatest[0], least, paths, centre);
    const auto second = largestOf(1, greatest[1], least, paths, centre);
    return first && second ? std::optional(std::max(*first, *second)) : std::nullopt;
}

} // namespace palmer
