// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/minimumzone.h"
#include "kernel/numerics/rays.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace palmer {

/// The largest difference of the distances of two closed paths whose points stay near a reference.
///
/// Every point is compared with the two points of the other path that enclose its angle
/// (iso230_4::largestDifference recomputes and sorts all angles, which took most of the time of a trial).
/// Near the reference the difference of a point is
///     d + t − (1 − p)·t_before − p·t_above,
/// d, p and the neighbours being those of the reference, t the changes of the ρ: no angle, no root. The
/// neglected terms have a bound, so that only the few points that can have the largest difference are
/// computed in the ordinary way, from the points around them, to the last bit.
class NearbyHysteresis {
public:
    /// `centre`: reference point of the distances.
    NearbyHysteresis(const Rays &first, const Rays &second, Point centre);

    /// Returns the largest difference of looks at the same rays, mm. Null if the order of the angles is
    /// uncertain: use iso230_4::largestDifference then.
    [[nodiscard]] std::optional<double> largestDifference(const std::array<RaysLook, 2> &paths,
                                                          Point centre) const;

private:
    /// A path in the order of its angles about the centre of the reference.
    struct Path {
        std::vector<std::uint32_t> order; ///< its points
        std::vector<double> angles;       ///< radians
        std::vector<double> distances;    ///< mm
        std::vector<char> close; ///< true if the next angle is close; the last is followed by the first
    };
    /// The points of a path compared with the other path.
    struct Comparisons {
        std::vector<std::uint32_t> point;
        std::vector<std::uint32_t> before; ///< points of the other path
        std::vector<std::uint32_t> above;
        std::vector<double> part;        ///< p
        std::vector<double> difference;  ///< d, mm
        std::vector<std::uint32_t> open; ///< points whose neighbours may swap: always computed
        std::vector<std::uint32_t> next; ///< for all points: position of the neighbour above in the order
    };
    [[nodiscard]] static Path sorted(const Rays &rays, Point centre);
    void addGaps(Path &path);
    void addDirections(const Rays &rays);
    [[nodiscard]] Comparisons compare(const Path &from, const Path &to);
    [[nodiscard]] std::optional<double> leftOut(double largest, Point delta) const;
    [[nodiscard]] std::optional<double> largestOf(std::size_t path, const std::vector<double> &greatest,
                                                  double least, const std::array<RaysLook, 2> &paths,
                                                  Point centre) const;
    [[nodiscard]] std::optional<double> plainDifference(std::size_t path, std::uint32_t point,
                                                        const std::array<RaysLook, 2> &paths,
                                                        Point centre) const;

    std::array<Path, 2> m_paths;
    std::array<Comparisons, 2> m_comparisons;
    Point m_centre;
    bool m_usable = false;
    double m_least = 0; ///< smallest distance
    double m_greatest = 0;
    double m_across = 0;   ///< largest |u × w|, w the direction from the centre
    double m_bend = 0;     ///< largest 1 − u·w
    double m_turn = 0;     ///< largest |w − (1 − p)·w_before − p·w_above|
    double m_steepest = 0; ///< change of distance per angle between neighbours that are not close, mm
    double m_gap = 0;      ///< smallest angle between these
    double m_close = 0;    ///< neighbours closer than this are close, radians
};

} // namespace palmer
