// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palmer {

/// Points on fixed rays from the origin, P_i = ρ_i·u_i, whose distances ρ_i change little from one look to
/// the next, as in the trials of a simulation. Bounds for sectors of 16 neighbours show which points may lie
/// outside a circle, so that only few sectors need be searched.
class Rays {
public:
    Rays() = default;
    /// `radii`: distances of the reference, mm; `centre`: a point close to the circles about them.
    Rays(std::vector<double> ux, std::vector<double> uy, std::vector<double> radii, Point centre);

    [[nodiscard]] std::size_t size() const { return m_radii.size(); }
    [[nodiscard]] Point direction(std::size_t i) const { return {m_ux[i], m_uy[i]}; }
    [[nodiscard]] const std::vector<double> &x() const { return m_ux; }
    [[nodiscard]] const std::vector<double> &y() const { return m_uy; }
    [[nodiscard]] Points reference() const;

    /// The distances of one look (e.g. one trial), and values derived from them.
    struct Look {
        std::vector<double> radii;   ///< ρ, mm; set these, then call `prepare`
        std::vector<double> changes; ///< ρ − ρ of the reference
        double largest = 0;          ///< of |changes|
        std::vector<double> nearest; ///< per sector: bounds of the distances from the centre of the reference
        std::vector<double> farthest;
    };
    [[nodiscard]] Look sample() const;
    void prepare(Look &look) const;
    [[nodiscard]] static bool finite(const Look &look) { return std::isfinite(look.largest); }
    [[nodiscard]] Point point(const Look &look, std::size_t i) const {
        return {look.radii[i] * m_ux[i], look.radii[i] * m_uy[i]};
    }
    void fill(const Look &look, Points &points) const;

    /// Smallest and greatest distance of the points from a centre, mm: computed as √((x − x_c)² + (y − y_c)²)
    /// for the points that can be the extreme.
    struct Extremes {
        double least = 0;
        double greatest = 0;
    };
    [[nodiscard]] Extremes extremes(const Look &look, Point centre) const;

    /// Calls visit(i) for every point that may be farther than `outer` from a centre or nearer than `inner`,
    /// and possibly for others.
    template <class Visit>
    void visitBeyond(const Look &look, Point centre, double outer, double inner, Visit visit) const {
        const Bound bound = boundOf(look, centre);
        for (std::size_t s = 0; s < m_sectorCount; ++s) {
            if (farthest(look, s, bound) <= outer && nearest(look, s, bound) >= inner)
                continue;
            visitSector(s, visit);
        }
    }

    /// The sectors that may contain the farthest and nearest point from a centre, with distance bounds.
    struct Outermost {
        std::size_t farthest = 0;
        std::size_t nearest = 0;
        double greatest = -std::numeric_limits<double>::infinity();
        double least = std::numeric_limits<double>::infinity();
    };
    [[nodiscard]] Outermost outermost(const Look &look, Point centre) const;
    template <class Visit>
    void visitSector(std::size_t sector, Visit visit) const {
        const std::size_t end = std::min(size(), (sector + 1) * sectorSize);
        for (std::size_t i = sector * sectorSize; i < end; ++i)
            visit(i);
    }

private:
    static constexpr std::size_t sectorSize = 16;

    /// With P − c_reference = r₀·w + t·u, t the change: |P − c| = √((r₀ + a)² + b²), a = t·(u·w) − δ·w, |b| ≤
    /// |t|·|u × w| + |δ|, δ = c − c_reference. So |P − c| lies between r₀ + a and r₀ + a + b²/r₀ as long as
    /// |a| ≤ r₀/2; and δ·w differs from its value for the mean direction of the sector by at most |δ|·spread.
    /// One entry per sector; columns, so that `outermost` compares eight sectors at once.
    struct Sectors {
        std::vector<double> wx; ///< mean direction
        std::vector<double> wy;
        std::vector<double> spread;
    };
    struct Bound {
        Point delta;
        double length = 0;
        double above = 0; ///< b²/r₀ and rounding
        double below = 0; ///< rounding
    };
    /// The columns that `outermost` compares.
    struct Compared {
        const double *farthest = nullptr;
        const double *nearest = nullptr;
        const double *wx = nullptr;
        const double *wy = nullptr;
        const double *spread = nullptr;
        Bound bound;
    };
    template <class Register>
    static std::size_t outermostOf(const Compared &c, std::size_t count, Outermost &result);
    [[nodiscard]] Bound boundOf(const Look &look, Point centre) const;
    [[nodiscard]] double farthest(const Look &look, std::size_t s, const Bound &bound) const {
        return look.farthest[s] - (bound.delta.x * m_sectors.wx[s] + bound.delta.y * m_sectors.wy[s]) +
               bound.length * m_sectors.spread[s] + bound.above;
    }
    [[nodiscard]] double nearest(const Look &look, std::size_t s, const Bound &bound) const {
        return look.nearest[s] - (bound.delta.x * m_sectors.wx[s] + bound.delta.y * m_sectors.wy[s]) -
               bound.length * m_sectors.spread[s] - bound.below;
    }

    std::vector<double> m_ux;
    std::vector<double> m_uy;
    std::vector<double> m_radii;
    Point m_centre;
    std::vector<double> m_distances; ///< r₀ from the centre
    std::vector<double> m_along;     ///< u·w
    std::size_t m_sectorCount = 0;
    Sectors m_sectors;
    double m_least = 0; ///< smallest distance
    double m_greatest = 0;
    double m_across = 0; ///< largest |u × w|
};

} // namespace palmer
