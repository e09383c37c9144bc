// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"
#include "kernel/numerics/rays.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace palmer {

struct MinimumZoneOptions {
    /// A point is inside the ring, and a ring is not thinner than another, when it is so to tolerance·R:
    /// the rounding of a distance.
    double tolerance = 1e-15;
    int maxExchanges = 200; ///< Of the exchange; after them the search over the whole plane goes on.
    int maxCorePoints = 64; ///< Of the search over the whole plane; after them the result is not certified.
};

/// The minimum zone circles: the two concentric circles of least separation that have all points between
/// them,
///     w = min over c of (max r_i(c) − min r_i(c)),   r_i(c) = |P_i − c|.
///
/// Characterisation: with u_i = (P_i − c)/r_i, c is a local minimum if and only if the segment between the
/// u of two outer contacts (r = max) crosses the segment between the u of two inner contacts (r = min): the
/// four contacts alternate in angle. So c lies on the bisector of the outer pair and on that of the inner
/// pair.
///
/// Method (exchange): the four contacts of a small set, one look at all points for those outside its ring,
/// these join the set, again until none is outside. Each ring is the least of its set; the last, which has
/// all points inside, is a minimum of all.
///
/// Certificate, O(1): four contacts can be paired in three ways, and every local minimum of w over the four
/// belongs to one of them; far away w tends to the width of a strip. If neither another pairing nor a strip
/// is thinner than the ring, then no ring that holds the four points is thinner, and so none that holds all.
/// Should the four contacts not suffice (seen on short arcs with w/R beyond some per cent), the same proof is
/// carried out with more points: every pairing among a core set is enumerated and the core grows until its
/// least ring holds all points.
///
/// Validity: any number and order of points, duplicates and ties included, arcs, coordinates far off the
/// origin. Time: O(n), two to four looks at the data; memory: about a hundredth of the data.
struct MinimumZone {
    enum class Status {
        found,
        tooFewPoints, ///< Fewer than 4 distinct points.
        straight, ///< Collinear, or so nearly that a strip between parallel lines is thinner than every ring.
        notFinite, ///< A coordinate is not a finite number, or too large to be squared.
    };

    Status status = Status::tooFewPoints;
    Point centre;                       ///< c, mm
    double innerRadius = 0;             ///< min r_i, mm
    double outerRadius = 0;             ///< max r_i, mm
    double width = 0;                   ///< w, mm
    std::array<std::size_t, 2> outer{}; ///< Indices of the outer contacts.
    std::array<std::size_t, 2> inner{}; ///< Indices of the inner contacts.
    bool certified = false;             ///< Proven to be the least of all rings, to rounding.
    int scans = 0;                      ///< Looks at the data.

    [[nodiscard]] bool valid() const { return status == Status::found; }

    bool operator==(const MinimumZone &) const = default;
};

[[nodiscard]] MinimumZone minimumZone(PointsView points, const MinimumZoneOptions &options = {});

/// The points of some rays at one look, one set behind the other.
struct RaysLook {
    const Rays *rays;
    const Rays::Look *look;
};

/// The minimum zone circles of the points of one or two sets of rays near a reference, to the last bit those
/// of the plain way; null where it cannot be told from so little: the plain way tells then. `first`: indices
/// of the contacts to begin with, those of the reference, outer then inner, so that the result depends on no
/// other look. The exchange needs the points beyond each ring alone, which Rays finds without looking at all.
/// The result is taken only where no other ring can be as thin: the O(1) certificate holds, and no point but
/// the contacts comes near the circles, both by more than all rounding.
[[nodiscard]] std::optional<MinimumZone> minimumZone(std::span<const RaysLook> points,
                                                     const std::array<std::size_t, 4> &first,
                                                     const MinimumZoneOptions &options = {});

} // namespace palmer
