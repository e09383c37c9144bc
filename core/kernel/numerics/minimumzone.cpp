// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/minimumzone.h"

#include "kernel/numerics/radiusextremes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace palmer {

namespace {

using Status = MinimumZone::Status;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point with its index in the data; coordinates relative to the origin of the search.
struct Sample {
    Point point;
    std::size_t index = 0;
};

double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}

Point difference(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}

double squaredDistance(Point p, Point centre) {
    return squaredDistance(p.x, p.y, {}, centre);
}

/// Two concentric circles and the points that define them: |outer[0] − c| = |outer[1] − c|, same for inner.
struct Ring {
    Point centre;
    double least = 0;    ///< Squared inner radius.
    double greatest = 0; ///< Squared outer radius.
    std::array<Sample, 2> outer;
    std::array<Sample, 2> inner;

    [[nodiscard]] double innerRadius() const { return std::sqrt(least); }
    [[nodiscard]] double outerRadius() const { return std::sqrt(greatest); }
    [[nodiscard]] double width() const { return outerRadius() - innerRadius(); }
    /// Width plus its possible rounding error: the width of a ring of enormous radius cannot be trusted.
    [[nodiscard]] double bound(double tolerance) const { return width() + tolerance * outerRadius(); }

    void include(Point p) {
        const double d = squaredDistance(p, centre);
        least = std::min(least, d);
        greatest = std::max(greatest, d);
    }
};

/// The bisector of two points, n·c = k.
struct Bisector {
    Point n;
    double k;
    std::array<const Sample *, 2> of; ///< must outlive the bisector

    Bisector(const Sample &a, const Sample &b)
        : n(difference(b.point, a.point))
        , k((n.x * (a.point.x + b.point.x) + n.y * (a.point.y + b.point.y)) / 2)
        , of{&a, &b} {}
};

/// Returns a non-finite point if the bisectors are parallel or one of them is of the same point twice.
Point intersection(const Bisector &a, const Bisector &b) {
    const double inverse = 1 / cross(a.n, b.n);
    return {(a.k * b.n.y - b.k * a.n.y) * inverse, (a.n.x * b.k - b.n.x * a.k) * inverse};
}

Ring ringOf(const Bisector &a, const Bisector &b, Point centre, double least, double greatest) {
    const bool outside = squaredDistance(a.of[0]->point, centre) >= squaredDistance(b.of[0]->point, centre);
    const Bisector &outer = outside ? a : b;
    const Bisector &inner = outside ? b : a;
    return {centre, least, greatest, {*outer.of[0], *outer.of[1]}, {*inner.of[0], *inner.of[1]}};
}

/// Returns the ring about the intersection of two bisectors, just wide enough for the four points.
std::optional<Ring> intersect(const Bisector &a, const Bisector &b) {
    const Point centre = intersection(a, b);
    const double d = squaredDistance(a.of[0]->point, centre);
    if (!std::isfinite(d))
        return std::nullopt;
    Ring ring = ringOf(a, b, centre, d, d);
    ring.include(a.of[1]->point);
    ring.include(b.of[0]->point);
    ring.include(b.of[1]->point);
    return ring;
}

/// True if p lies between a and b counterclockwise.
bool between(Point a, Point b, Point p) {
    if (cross(a, b) >= 0)
        return cross(a, p) > 0 && cross(p, b) > 0;
    return !(cross(b, p) >= 0 && cross(p, a) >= 0);
}

bool alternate(const Ring &ring) {
    const Point a = difference(ring.outer[0].point, ring.centre);
    const Point b = difference(ring.outer[1].point, ring.centre);
    return between(a, b, difference(ring.inner[0].point, ring.centre)) !=
           between(a, b, difference(ring.inner[1].point, ring.centre));
}

/// True if the ring is a local minimum: four distinct points touch the circles, and alternate.
bool isMinimum(const Ring &ring, double tolerance) {
    const double outerRadius = ring.outerRadius() * (1 - 2 * tolerance);
    const double innerRadius = ring.innerRadius() * (1 + 2 * tolerance);
    for (const Sample &outer : ring.outer) {
        if (squaredDistance(outer.point, ring.centre) < outerRadius * outerRadius)
            return false;
        for (const Sample &inner : ring.inner)
            if (outer.point == inner.point)
                return false;
    }
    for (const Sample &inner : ring.inner)
        if (squaredDistance(inner.point, ring.centre) > innerRadius * innerRadius)
            return false;
    return alternate(ring);
}

/// A strip between parallel lines; |normal| = 1.
struct Strip {
    Point normal;
    double width = infinity;
};

/// Returns the thinnest strip that contains the points: one of its lines passes through two of them.
Strip thinnestStrip(std::span<const Sample> samples) {
    Strip thinnest;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t j = i + 1; j < samples.size(); ++j) {
            const Point along = difference(samples[j].point, samples[i].point);
            const double length = std::hypot(along.x, along.y);
            if (!(length > 0))
                continue;
            const Point normal{-along.y / length, along.x / length};
            double least = 0;
            double greatest = 0;
            for (const Sample &s : samples) {
                const Point d = difference(s.point, samples[i].point);
                const double height = normal.x * d.x + normal.y * d.y;
                least = std::min(least, height);
                greatest = std::max(greatest, height);
            }
            if (greatest - least < thinnest.width)
                thinnest = {normal, greatest - least};
        }
    }
    return thinnest;
}

/// The three ways of pairing four points.
using Pairing = std::array<std::size_t, 4>;
constexpr std::array<Pairing, 3> pairings{{{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}};

std::optional<Ring> intersect(const std::array<Sample, 4> &four, const Pairing &p) {
    return intersect({four[p[0]], four[p[1]]}, {four[p[2]], four[p[3]]});
}

/// The O(1) certificate (see the header), proven from the four contacts alone: all other rings of the
/// contacts are wider by at least `margin`.
bool certify(const Ring &ring, double tolerance, double margin = 0) {
    if (!isMinimum(ring, tolerance))
        return false;
    const std::array<Sample, 4> contacts{ring.outer[0], ring.outer[1], ring.inner[0], ring.inner[1]};
    for (const Pairing &pairing : {pairings[1], pairings[2]}) {
        const std::optional<Ring> other = intersect(contacts, pairing);
        if (other && other->bound(tolerance) < ring.width() + margin)
            return false;
    }
    return thinnestStrip(contacts).width > ring.bound(tolerance) + margin;
}

/// Up to 8 points that may touch the circles.
struct Contacts {
    std::array<Sample, 8> samples;
    std::size_t size = 0;

    void add(const Sample &s) { samples[size++] = s; }
};

/// Returns the two points of a circle, and a point beyond it.
Contacts contactsOf(const std::array<Sample, 2> &circle, const std::optional<Sample> &beyond = {}) {
    Contacts contacts;
    for (const Sample &s : circle)
        contacts.add(s);
    if (beyond)
        contacts.add(*beyond);
    return contacts;
}

/// The thinnest of several rings, each about all points of a set. The width is stored with the ring, which
/// saves two of four square roots per candidate.
class Thinnest {
public:
    explicit Thinnest(std::span<const Point> points)
        : m_points(points) {}

    void offer(const Bisector &a, const Bisector &b) {
        const Point centre = intersection(a, b);
        double least = infinity;
        double greatest = 0;
        for (const Point p : m_points) {
            const double d = squaredDistance(p, centre);
            least = std::min(least, d);
            greatest = std::max(greatest, d);
        }
        // Parallel bisectors give NaN or a negative width, as no distance was compared.
        const double width = std::sqrt(greatest) - std::sqrt(least);
        if (!(width >= 0 && width < m_width))
            return;
        m_width = width;
        m_ring = ringOf(a, b, centre, least, greatest);
    }

    [[nodiscard]] const std::optional<Ring> &ring() const { return m_ring; }

private:
    std::span<const Point> m_points;
    std::optional<Ring> m_ring;
    double m_width = infinity;
};

/// Returns the least ring about some points, with every choice of outer points.
std::optional<Ring> leastRingOfAll(std::span<const Sample> all, std::span<const Point> points) {
    Thinnest best(points);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            for (std::size_t k = i + 1; k < all.size(); ++k)
                for (std::size_t l = k + 1; l < all.size(); ++l)
                    if (k != j && l != j)
                        best.offer({all[i], all[j]}, {all[k], all[l]});
    return best.ring();
}

/// Returns the least ring about outer and inner points: first with outer points paired with outer, inner with
/// inner; if no such ring is a minimum, some point belongs to the other circle, and all pairings are tried.
std::optional<Ring> leastRing(const Contacts &outer, const Contacts &inner, double tolerance) {
    std::array<Point, 16> coordinates;
    std::size_t size = 0;
    for (const Contacts *contacts : {&outer, &inner})
        for (std::size_t i = 0; i < contacts->size; ++i)
            coordinates[size++] = contacts->samples[i].point;
    const std::span<const Point> points(coordinates.data(), size);
    Thinnest best(points);
    for (std::size_t i = 0; i < outer.size; ++i) {
        for (std::size_t j = i + 1; j < outer.size; ++j) {
            const Bisector outside(outer.samples[i], outer.samples[j]);
            for (std::size_t k = 0; k < inner.size; ++k)
                for (std::size_t l = k + 1; l < inner.size; ++l)
                    best.offer(outside, {inner.samples[k], inner.samples[l]});
        }
    }
    if (best.ring() && isMinimum(*best.ring(), tolerance))
        return best.ring();
    std::array<Sample, 16> all;
    std::copy_n(inner.samples.begin(), inner.size,
                std::copy_n(outer.samples.begin(), outer.size, all.begin()));
    return leastRingOfAll({all.data(), size}, points);
}

/// The points farthest outside a ring: beyond the outer and within the inner circle.
struct Violators {
    std::optional<Sample> farthest;
    std::optional<Sample> nearest;

    [[nodiscard]] bool any() const { return farthest || nearest; }
};

constexpr std::size_t smallest = 256; ///< up to this size the working set contains all points

/// Returns k such that the working set starts with every k-th point: about 3·√n points.
std::size_t strideOfWorkingSet(std::size_t n) {
    constexpr std::size_t sampleFactor = 3;
    return n <= smallest ? 1 : static_cast<std::size_t>(std::sqrt(static_cast<double>(n))) / sampleFactor;
}

/// The data and a small working set of its points, which is searched first. Passes over all points go block
/// by block; a block is skipped while the movement of the centre since the first pass cannot have brought any
/// of its points outside the ring.
class Search {
public:
    Search(PointsView points, double tolerance)
        : m_points(points)
        , m_tolerance(tolerance) {
        const std::size_t n = points.size();
        m_complete = n <= smallest;
        const std::size_t stride = strideOfWorkingSet(n);
        const std::size_t size = (n + stride - 1) / stride;
        m_index.reserve(size);
        m_x.reserve(size);
        m_y.reserve(size);
        Point sum;
        for (std::size_t i = 0; i < n; i += stride) {
            m_index.push_back(i);
            sum.x += points.x[i];
            sum.y += points.y[i];
        }
        m_origin = {sum.x / static_cast<double>(size), sum.y / static_cast<double>(size)};
        for (const std::size_t i : m_index) {
            m_x.push_back(points.x[i] - m_origin.x);
            m_y.push_back(points.y[i] - m_origin.y);
        }
    }

    [[nodiscard]] Point origin() const { return m_origin; }
    [[nodiscard]] int scans() const { return m_scans; }
    [[nodiscard]] bool finite() const { return m_finite; }
    [[nodiscard]] std::size_t workingSize() const { return m_index.size(); }
    [[nodiscard]] Sample working(std::size_t k) const { return {{m_x[k], m_y[k]}, m_index[k]}; }

    /// Returns up to four distinct points of the data.
    [[nodiscard]] std::vector<Sample> fourDistinct() {
        std::vector<Sample> found;
        const auto offer = [&](const Sample &s) {
            if (std::none_of(found.begin(), found.end(), [&](const Sample &f) { return f.point == s.point; }))
                found.push_back(s);
            return found.size() == 4;
        };
        for (std::size_t k = 0; k < workingSize(); ++k)
            if (offer(working(k)))
                return found;
        for (std::size_t i = 0; i < m_points.size() && !m_complete; ++i)
            if (offer(sample(i)))
                break;
        return found;
    }

    /// Returns the centre of the algebraic circle of the working set, a rough start; NaN if collinear.
    [[nodiscard]] Point algebraicCentre() {
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xz = 0;
        double yz = 0;
        for (std::size_t k = 0; k < workingSize(); ++k) {
            const double x = m_x[k];
            const double y = m_y[k];
            const double z = x * x + y * y;
            xx += x * x;
            xy += x * y;
            yy += y * y;
            xz += x * z;
            yz += y * z;
        }
        m_finite = std::isfinite(xz + yz + xx + yy);
        const double determinant = 2 * (xx * yy - xy * xy);
        return {(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
    }

    /// Returns the farthest and nearest points outside the ring in the working set; if there are none, those
    /// of all points, and the violators of every block are added to the working set.
    Violators violators(const Ring &ring) {
        const double allowance = m_tolerance * ring.outerRadius();
        const double outer = ring.outerRadius() + allowance;
        const double inner = ring.innerRadius() - allowance;
        const Violators own = violatorsFrom(0, ring.centre, outer, inner);
        if (own.any() || m_complete) {
            m_scans = std::max(m_scans, m_complete ? 1 : 0);
            return own;
        }
        const std::size_t size = workingSize();
        scanAll(ring.centre, outer, inner);
        return violatorsFrom(size, ring.centre, outer, inner);
    }

    /// Extremes of all points relative to a centre.
    struct Extremes {
        double least = 0;
        double greatest = 0;
        Sample nearest;
        Sample farthest;
    };
    [[nodiscard]] Extremes extremes(Point centre) {
        ++m_scans;
        const RadiusExtremes r = radiusExtremes(m_points, centre, m_origin);
        m_finite = m_finite && r.finite;
        const Sample nearest = sample(r.nearest);
        const Sample farthest = sample(r.farthest);
        return {squaredDistance(nearest.point, centre), squaredDistance(farthest.point, centre), nearest,
                farthest};
    }

    /// The outermost points in both senses of a direction, their distance along it, and the greatest distance
    /// of a point from the origin.
    struct Span {
        Sample lowest;
        Sample highest;
        double width;
        double extent;
    };
    [[nodiscard]] Span span(Point normal) {
        ++m_scans;
        Span span{sample(0), sample(0), 0, 0};
        double least = infinity;
        double greatest = -infinity;
        double reach = 0;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const Point p = sample(i).point;
            const double height = normal.x * p.x + normal.y * p.y;
            const double square = p.x * p.x + p.y * p.y;
            m_finite = m_finite && std::isfinite(square);
            reach = std::max(reach, square);
            if (height < least) {
                least = height;
                span.lowest = sample(i);
            }
            if (height > greatest) {
                greatest = height;
                span.highest = sample(i);
            }
        }
        span.width = greatest - least;
        span.extent = std::sqrt(reach);
        return span;
    }

private:
    static constexpr std::size_t blockSize = 128;

    [[nodiscard]] Sample sample(std::size_t i) const {
        return {{m_points.x[i] - m_origin.x, m_points.y[i] - m_origin.y}, i};
    }

    [[nodiscard]] Violators violatorsFrom(std::size_t from, Point centre, double outer, double inner) const {
        Violators found;
        const double *x = m_x.data() + from;
        const double *y = m_y.data() + from;
        const std::size_t size = m_x.size() - from;
        if (size == 0)
            return found;
        const SquaredRange range = squaredRange(x, y, size, {}, centre);
        if (std::sqrt(range.greatest) > outer)
            found.farthest = working(from + findSquaredDistance(x, y, size, {}, centre, range.greatest));
        if (std::sqrt(range.least) < inner)
            found.nearest = working(from + findSquaredDistance(x, y, size, {}, centre, range.least));
        return found;
    }

    void scanAll(Point centre, double outer, double inner) {
        ++m_scans;
        const std::size_t n = m_points.size();
        const bool first = m_blocks.empty();
        if (first) {
            m_blocks.resize((n + blockSize - 1) / blockSize);
            m_reference = centre;
        }
        // |r(c) − r(c_reference)| ≤ |c − c_reference|, plus an allowance for rounding.
        const double movement =
            std::hypot(centre.x - m_reference.x, centre.y - m_reference.y) + m_tolerance * outer;
        double sum = 0;
        for (std::size_t b = 0; b < m_blocks.size(); ++b) {
            const std::size_t begin = b * blockSize;
            const std::size_t size = std::min(blockSize, n - begin);
            const double *x = m_points.x.data() + begin;
            const double *y = m_points.y.data() + begin;
            if (!first && m_blocks[b].outer + movement <= outer && m_blocks[b].inner - movement >= inner)
                continue;
            const SquaredRange range = squaredRange(x, y, size, m_origin, centre);
            const double farthest = std::sqrt(range.greatest);
            const double nearest = std::sqrt(range.least);
            if (first) {
                m_blocks[b] = {nearest, farthest};
                sum += range.sum;
            }
            if (farthest > outer)
                join(begin + findSquaredDistance(x, y, size, m_origin, centre, range.greatest));
            if (nearest < inner)
                join(begin + findSquaredDistance(x, y, size, m_origin, centre, range.least));
        }
        m_finite = m_finite && std::isfinite(sum);
    }

    void join(std::size_t i) {
        if (i >= m_points.size())
            return; // not found: the block contains a NaN
        m_x.push_back(m_points.x[i] - m_origin.x);
        m_y.push_back(m_points.y[i] - m_origin.y);
        m_index.push_back(i);
    }

    struct Block {
        double inner;
        double outer;
    };

    PointsView m_points;
    double m_tolerance;
    Point m_origin;
    std::vector<double> m_x; // the working set, relative to the origin
    std::vector<double> m_y;
    std::vector<std::size_t> m_index; // indices of the working set in the data
    bool m_complete = false;          // the working set contains all points
    std::vector<Block> m_blocks;      // distances from m_reference
    Point m_reference;
    int m_scans = 0;
    bool m_finite = true;
};

/// Returns the initial ring, from the farthest and nearest point of each quadrant about the mean.
std::optional<Ring> firstRing(Search &search, double tolerance) {
    const Point centre = search.algebraicCentre();
    if (!search.finite() || !std::isfinite(centre.x) || !std::isfinite(centre.y))
        return std::nullopt;
    std::array<double, 4> greatest{-1, -1, -1, -1};
    std::array<double, 4> least{infinity, infinity, infinity, infinity};
    std::array<Sample, 4> farthest;
    std::array<Sample, 4> nearest;
    for (std::size_t k = 0; k < search.workingSize(); ++k) {
        const Sample s = search.working(k);
        const std::size_t quarter = (s.point.x < 0 ? 1U : 0U) + (s.point.y < 0 ? 2U : 0U);
        const double d = squaredDistance(s.point, centre);
        if (d > greatest[quarter]) {
            greatest[quarter] = d;
            farthest[quarter] = s;
        }
        if (d < least[quarter]) {
            least[quarter] = d;
            nearest[quarter] = s;
        }
    }
    Contacts outer;
    Contacts inner;
    for (std::size_t q = 0; q < 4; ++q) {
        if (greatest[q] >= 0) {
            outer.add(farthest[q]);
            inner.add(nearest[q]);
        }
    }
    return leastRing(outer, inner, tolerance);
}

struct Exchanged {
    std::optional<Ring> ring; ///< the last one
    bool terminated = false;  ///< it contains all points
};

Exchanged exchange(Search &search, const MinimumZoneOptions &options) {
    Exchanged result;
    std::optional<Ring> ring = firstRing(search, options.tolerance);
    for (int step = 0; ring && search.finite() && step < options.maxExchanges; ++step) {
        result.ring = ring;
        const Violators violators = search.violators(*ring);
        if (!violators.any()) {
            result.terminated = true;
            break;
        }
        ring = leastRing(contactsOf(ring->outer, violators.farthest),
                         contactsOf(ring->inner, violators.nearest), options.tolerance);
    }
    return result;
}

/// Search over the whole plane. m_rings holds every local minimum of the width over the core that is not
/// wider than the best ring known to contain all points.
class CoreSearch {
public:
    CoreSearch(Search &search, const MinimumZoneOptions &options)
        : m_search(search)
        , m_options(options) {}

    MinimumZone::Status run(std::span<const Sample> seed, Ring &result, bool &certified) {
        for (const Sample &s : seed)
            add(s);
        while (m_search.finite() && m_core.size() + 2 <= static_cast<std::size_t>(m_options.maxCorePoints)) {
            const Ring *least = leastRing();
            const Strip strip = thinnestStrip(m_core);
            if (!least || strip.width <= least->bound(tolerance())) {
                // No ring of the core is thinner than this strip; is a point outside the strip?
                const Search::Span all = m_search.span(strip.normal);
                const bool outside = all.width > strip.width + 2 * tolerance() * all.extent;
                if (!outside || (int{add(all.lowest)} + int{add(all.highest)}) == 0)
                    return Status::straight;
                continue;
            }
            Ring candidate = *least;
            const Search::Extremes all = m_search.extremes(candidate.centre);
            const double bound = candidate.bound(tolerance());
            candidate.least = all.least;
            candidate.greatest = all.greatest;
            if (candidate.bound(tolerance()) < m_bound) {
                m_best = candidate;
                m_bound = candidate.bound(tolerance());
            }
            // All inside to rounding: the least ring of the core contains all points.
            const bool grown =
                candidate.width() > bound && (int{add(all.farthest)} + int{add(all.nearest)}) > 0;
            if (!grown) {
                result = candidate;
                certified = true;
                return Status::found;
            }
        }
        if (!m_best)
            return Status::straight;
        result = *m_best;
        return Status::found;
    }

private:
    [[nodiscard]] double tolerance() const { return m_options.tolerance; }

    /// Returns the least ring; among those equal to rounding, one whose contacts prove it to be a minimum.
    [[nodiscard]] const Ring *leastRing() const {
        const Ring *least = nullptr;
        for (const Ring &ring : m_rings)
            if (!least || ring.bound(tolerance()) < least->bound(tolerance()))
                least = &ring;
        if (least && !isMinimum(*least, tolerance())) {
            for (const Ring &ring : m_rings)
                if (ring.width() <= least->bound(tolerance()) && isMinimum(ring, tolerance()))
                    return &ring;
        }
        return least;
    }

    /// Adds a point to the core; returns false if already present.
    bool add(const Sample &s) {
        if (std::any_of(m_core.begin(), m_core.end(), [&](const Sample &c) { return c.point == s.point; }))
            return false;
        for (Ring &ring : m_rings)
            ring.include(s.point);
        std::erase_if(m_rings, [&](const Ring &ring) { return ring.width() > m_bound; });
        for (std::size_t i = 0; i < m_core.size(); ++i)
            for (std::size_t j = i + 1; j < m_core.size(); ++j)
                for (std::size_t k = j + 1; k < m_core.size(); ++k)
                    for (const Pairing &pairing : pairings)
                        offer(intersect({s, m_core[i], m_core[j], m_core[k]}, pairing));
        m_core.push_back(s);
        return true;
    }

    void offer(std::optional<Ring> ring) {
        if (!ring || ring->width() > m_bound)
            return; // other points only widen it
        for (const Sample &s : m_core)
            ring->include(s.point);
        if (ring->width() <= m_bound)
            m_rings.push_back(*ring);
    }

    Search &m_search;
    const MinimumZoneOptions &m_options;
    std::vector<Sample> m_core;
    std::vector<Ring> m_rings;
    std::optional<Ring> m_best; // contains all points
    double m_bound = infinity;  // of m_best
};

/// The exchange over points on rays.
class RaysSearch {
public:
    RaysSearch(std::span<const RaysLook> points, const MinimumZoneOptions &options)
        : m_points(points)
        , m_tolerance(options.tolerance) {
        std::size_t n = 0;
        for (const RaysLook &part : points)
            n += part.rays->size();
        // The same origin as in the ordinary search, so that all coordinates and results are the same bits.
        Point sum;
        std::size_t size = 0;
        const std::size_t stride = strideOfWorkingSet(n);
        std::size_t k = 0;
        for (const RaysLook &part : points) {
            for (; k < part.rays->size(); k += stride, ++size) {
                const Point p = part.rays->point(*part.look, k);
                sum.x += p.x;
                sum.y += p.y;
            }
            k -= part.rays->size();
        }
        m_origin = {sum.x / static_cast<double>(size), sum.y / static_cast<double>(size)};
    }

    [[nodiscard]] Point origin() const { return m_origin; }

    [[nodiscard]] std::optional<Ring> run(const std::array<std::size_t, 4> &first) const {
        Contacts outer = contactsOf({sample(first[0]), sample(first[1])});
        Contacts inner = contactsOf({sample(first[2]), sample(first[3])});
        constexpr int mostExchanges = 50;
        for (int step = 0; step < mostExchanges; ++step) {
            const std::optional<Ring> ring = leastRing(outer, inner, m_tolerance);
            if (!ring || !std::isfinite(ring->greatest))
                return std::nullopt;
            Beyond beyond{likelyViolators(*ring)};
            if (!beyond.violators.any())
                beyond = this->beyond(*ring);
            if (!beyond.violators.any())
                return beyond.close || !certify(*ring, m_tolerance, margin(*ring)) ? std::nullopt : ring;
            outer = contactsOf(ring->outer, beyond.violators.farthest);
            inner = contactsOf(ring->inner, beyond.violators.nearest);
        }
        return std::nullopt;
    }

private:
    struct Beyond {
        Violators violators;
        bool close = false; ///< a point other than the contacts lies outside the ring or within its margin
    };

    /// Far above rounding errors, far below the distance between neighbouring points.
    static double margin(const Ring &ring) { return 1e-12 * ring.outerRadius(); }

    [[nodiscard]] Sample sample(std::size_t i) const {
        std::size_t k = i;
        for (const RaysLook &part : m_points) {
            if (k < part.rays->size())
                return {about(part.rays->point(*part.look, k)), i};
            k -= part.rays->size();
        }
        assert(false);
        return {};
    }

    [[nodiscard]] Point about(Point p) const { return {p.x - m_origin.x, p.y - m_origin.y}; }

    /// Squared radii: of the ring reduced by the margins, and of the ring extended by the tolerance.
    struct Borders {
        double outerMargin;
        double innerMargin;
        double outer;
        double inner;
    };
    [[nodiscard]] Borders bordersOf(const Ring &ring) const {
        const double allowance = m_tolerance * ring.outerRadius();
        const auto square = [](double r) { return r > 0 ? r * r : 0; };
        return {square(ring.outerRadius() - margin(ring)), square(ring.innerRadius() + margin(ring)),
                square(ring.outerRadius() + allowance), square(ring.innerRadius() - allowance)};
    }

    /// Records the points of a part that are outside; `reached` follows the outermost.
    [[nodiscard]] auto visitor(const Ring &ring, std::size_t k, const Borders &borders, Borders &reached,
                               Beyond &result) const {
        const std::size_t offset = k == 0 ? 0 : m_points[0].rays->size();
        return [&, k, offset](std::size_t i) {
            const Point p = about(m_points[k].rays->point(*m_points[k].look, i));
            const double d = squaredDistance(p, ring.centre);
            if (d <= borders.outerMargin && d >= borders.innerMargin)
                return;
            const Sample s{p, offset + i};
            result.close = result.close || !isContact(ring, s.index);
            if (d > reached.outer) {
                reached.outer = d;
                result.violators.farthest = s;
            }
            if (d < reached.inner) {
                reached.inner = d;
                result.violators.nearest = s;
            }
        };
    }

    /// Returns violators from the sectors that may reach farthest out and in: as good to continue with as the
    /// outermost of all, while many points are outside.
    [[nodiscard]] Violators likelyViolators(const Ring &ring) const {
        const Point centre{m_origin.x + ring.centre.x, m_origin.y + ring.centre.y};
        std::array<std::size_t, 2> in{};
        Rays::Outermost all;
        for (std::size_t k = 0; k < m_points.size(); ++k) {
            const Rays::Outermost of = m_points[k].rays->outermost(*m_points[k].look, centre);
            if (of.greatest > all.greatest) {
                in[0] = k;
                all.greatest = of.greatest;
                all.farthest = of.farthest;
            }
            if (of.least < all.least) {
                in[1] = k;
                all.least = of.least;
                all.nearest = of.nearest;
            }
        }
        Beyond result;
        const Borders borders = bordersOf(ring);
        Borders reached = borders;
        if (all.greatest > ring.outerRadius())
            m_points[in[0]].rays->visitSector(all.farthest, visitor(ring, in[0], borders, reached, result));
        if (all.least < ring.innerRadius())
            m_points[in[1]].rays->visitSector(all.nearest, visitor(ring, in[1], borders, reached, result));
        return result.violators;
    }

    [[nodiscard]] Beyond beyond(const Ring &ring) const {
        const Point centre{m_origin.x + ring.centre.x, m_origin.y + ring.centre.y};
        const double margin = RaysSearch::margin(ring);
        const Borders borders = bordersOf(ring);
        Borders reached = borders;
        Beyond result;
        for (std::size_t k = 0; k < m_points.size(); ++k)
            m_points[k].rays->visitBeyond(*m_points[k].look, centre, ring.outerRadius() - margin,
                                          ring.innerRadius() + margin,
                                          visitor(ring, k, borders, reached, result));
        return result;
    }

    static bool isContact(const Ring &ring, std::size_t i) {
        return ring.outer[0].index == i || ring.outer[1].index == i || ring.inner[0].index == i ||
               ring.inner[1].index == i;
    }

    std::span<const RaysLook> m_points;
    double m_tolerance;
    Point m_origin;
};

MinimumZone zoneOf(const Ring &ring, Point origin) {
    MinimumZone zone;
    zone.status = Status::found;
    zone.centre = {origin.x + ring.centre.x, origin.y + ring.centre.y};
    zone.innerRadius = ring.innerRadius();
    zone.outerRadius = ring.outerRadius();
    zone.width = ring.width();
    zone.outer = {ring.outer[0].index, ring.outer[1].index};
    zone.inner = {ring.inner[0].index, ring.inner[1].index};
    return zone;
}

} // namespace

MinimumZone minimumZone(PointsView points, const MinimumZoneOptions &options) {
    assert(points.x.size() == points.y.size());
    MinimumZone zone;
    if (points.size() == 0)
        return zone;

    Search search(points, options.tolerance);
    Ring ring;
    const Exchanged exchanged = exchange(search, options);
    if (exchanged.terminated) {
        ring = *exchanged.ring;
        zone.certified = certify(ring, options.tolerance);
        zone.status = Status::found;
    }
    if (!zone.certified && search.finite()) {
        std::vector<Sample> seed = search.fourDistinct();
        if (seed.size() < 4) {
            zone.status = Status::tooFewPoints;
        } else {
            if (const auto &near = exchanged.ring) // good to begin with
                seed.insert(seed.end(), {near->outer[0], near->outer[1], near->inner[0], near->inner[1]});
            zone.status = CoreSearch(search, options).run(seed, ring, zone.certified);
        }
    }
    if (!search.finite())
        zone.status = Status::notFinite;
    zone.scans = search.scans();
    if (zone.status != Status::found) {
        zone.certified = false;
        return zone;
    }
    MinimumZone found = zoneOf(ring, search.origin());
    found.certified = zone.certified;
    found.scans = zone.scans;
    return found;
}

std::optional<MinimumZone> minimumZone(std::span<const RaysLook> points,
                                       const std::array<std::size_t, 4> &first,
                                       const MinimumZoneOptions &options) {
    for (const RaysLook &part : points)
        if (!Rays::finite(*part.look))
            return std::nullopt;
    const RaysSearch search(points, options);
    const std::optional<Ring> ring = search.run(first);
    if (!ring)
        return std::nullopt;
    MinimumZone zone = zoneOf(*ring, search.origin());
    zone.certified = true;
    return zone;
}

} // namespace palmer
