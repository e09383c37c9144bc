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
    /// Points are inside the ring, and rings no thinner than another, within tolerance·R: the rounding error
    /// of a distance.
    double tolerance = 1e-15;
    int maxExchanges = 200; ///< For the exchange; after that the search over the whole plane continues.
    int maxCorePoints = 64; ///< For the search over the whole plane; beyond it the result is not certified.
};

/// The minimum zone circles: the two concentric circles of least separation that enclose all points,
///     w = min over c of (max r_i(c) − min r_i(c)),   r_i(c) = |P_i − c|.
///
/// Characterisation: with u_i = (P_i − c)/r_i, c is a local minimum if and only if the segment between the u
/// of two outer contacts (r = max) crosses the segment between the u of two inner contacts (r = min): the
/// four contacts alternate in angle. So c lies on the bisectors of the outer pair and of the inner pair.
///
/// Method (exchange): find the four contacts of a small set, add the points outside its ring found in one
/// pass over all points, and repeat until none is outside. Each ring is the least of its set; the last one
/// contains all points and is therefore the minimum of all.
///
/// Certificate, O(1): four contacts can be paired in three ways, and every local minimum of w over the four
/// belongs to one of them; far away w tends to the width of a strip. If neither another pairing nor a strip
/// is thinner than the ring, no ring that contains the four points is thinner, and so none that contains all.
/// If the four contacts do not suffice (seen on short arcs with w/R beyond a few per cent), the same proof
/// uses more points: every pairing among a core set is enumerated, and the core grows until its least ring
/// contains all points.
///
/// Validity: any number and order of points, including duplicates and ties, arcs, coordinates far from the
/// origin. Time: O(n), two to four passes over the data; memory: about a hundredth of the data.
struct MinimumZone {
    enum class Status {
        found,
        tooFewPoints, ///< Fewer than 4 distinct points.
        straight,     ///< Collinear, or a strip between parallel lines is thinner than every ring.
        notFinite,    ///< A coordinate is not finite, or too large to be squared.
    };

    Status status = Status::tooFewPoints;
    Point centre;                       ///< c, mm
    double innerRadius = 0;             ///< min r_i, mm
    double outerRadius = 0;             ///< max r_i, mm
    double width = 0;                   ///< w, mm
    std::array<std::size_t, 2> outer{}; ///< Indices of the outer contacts.
    std::array<std::size_t, 2> inner{}; ///< Indices of the inner contacts.
    bool certified = false;             ///< Proven to be the least of all rings, to rounding.
    int scans = 0;                      ///< Passes over the data.

    [[nodiscard]] bool valid() const { return status == Status::found; }

    bool operator==(const MinimumZone &) const = default;
};

[[nodiscard]] MinimumZone minimumZone(PointsView points, const MinimumZoneOptions &options = {});

/// The points of one set of rays at one look.
struct RaysLook {
    const Rays *rays;
    const Rays::Look *look;
};

/// Returns the minimum zone circles of one or two sets of rays near a reference, identical to those of the
/// ordinary search to the last bit; null if the ordinary search is needed. `first`: indices of the initial
/// contacts, outer then inner, those of the reference, so that the result depends on no other look. The
/// exchange needs only the points outside each ring, which Rays finds without visiting all. The result is
/// returned only if no other ring can be as thin: the O(1) certificate holds, and no other point than the
/// contacts comes near the circles, both by more than rounding.
[[nodiscard]] std::optional<MinimumZone> minimumZone(std::span<const RaysLook> points,
                                                     const std::array<std::size_t, 4> &first,
                                                     const MinimumZoneOptions &options = {});

} // namespace palmer
