// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/aboutcentre.h"

#include "kernel/numerics/wideregisters.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace palmer {

namespace {

constexpr double halfTurn = 180;
constexpr double smallTangent = 1e-3; ///< below it t − t³/3 is the arc tangent to rounding

double turnBySlowWay(Point p, Point away) {
    const double sine = p.x * away.y - p.y * away.x;
    const double cosine = p.x * away.x + p.y * away.y;
    const double tangent = sine / cosine;
    const bool small = cosine > 0 && std::abs(tangent) < smallTangent;
    const double radians = small ? tangent - tangent * tangent * tangent / 3 : std::atan2(sine, cosine);
    return radians * halfTurn / std::numbers::pi;
}

/// Assumes that all tangents are small; returns whether they were. A plain loop, so that the compiler can
/// vectorise it for the function it is inlined into; a branch would prevent that.
[[gnu::always_inline]] inline bool allSmall(const double *x, const double *y, std::size_t size, Point centre,
                                            double *turns, double *distances) {
    std::uint64_t large = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const double dx = x[i] - centre.x;
        const double dy = y[i] - centre.y;
        const double sine = x[i] * dy - y[i] * dx;
        const double cosine = x[i] * dx + y[i] * dy;
        const double tangent = sine / cosine;
        large += cosine > 0 ? 0 : 1;
        large += __builtin_fabs(tangent) < smallTangent ? 0 : 1;
        const double radians = tangent - tangent * tangent * tangent / 3;
        turns[i] = radians * halfTurn / std::numbers::pi;
        distances[i] = __builtin_sqrt(dx * dx + dy * dy);
    }
    return large == 0;
}

bool allSmallByRegisters(const double *x, const double *y, std::size_t size, Point centre, double *turns,
                         double *distances) {
    bool all = false;
    inAvailableRegisters([&](auto) __attribute__((always_inline)) {
        all = allSmall(x, y, size, centre, turns, distances);
    });
    return all;
}

template <class AllSmall>
void fill(PointsView points, Point centre, std::span<double> turns, std::span<double> distances,
          const AllSmall &allSmallOf) {
    assert(turns.size() == points.size() && distances.size() == points.size());
    constexpr std::size_t block = 256; // a block is recomputed if one tangent in it is not small
    for (std::size_t begin = 0; begin < points.size(); begin += block) {
        const std::size_t size = points.size() - begin < block ? points.size() - begin : block;
        if (allSmallOf(&points.x[begin], &points.y[begin], size, centre, &turns[begin], &distances[begin]))
            continue;
        for (std::size_t i = begin; i < begin + size; ++i)
            turns[i] = turnBySlowWay(points[i], {points.x[i] - centre.x, points.y[i] - centre.y});
    }
}

} // namespace

void aboutCentreNarrow(PointsView points, Point centre, std::span<double> turns,
                       std::span<double> distances) {
    fill(points, centre, turns, distances, allSmall);
}

void aboutCentre(PointsView points, Point centre, std::span<double> turns, std::span<double> distances) {
    fill(points, centre, turns, distances, allSmallByRegisters);
}

} // namespace palmer
