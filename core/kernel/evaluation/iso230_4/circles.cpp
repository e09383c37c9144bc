// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/circles.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"

#include <algorithm>
#include <array>

namespace palmer::iso230_4 {

namespace {

using Wanted = std::function<bool(CircleOf of, ReferenceCircle kind)>;

void addMinimumZone(std::vector<CircleResult> &circles, CircleOf of, PointsView points) {
    const MinimumZone zone = minimumZone(points);
    if (zone.valid())
        circles.push_back({of, ReferenceCircle::minimumZone, zone.centre,
                           (zone.innerRadius + zone.outerRadius) / 2, zone.innerRadius, zone.outerRadius,
                           zone.width, zone.certified});
}

void addLeastSquares(std::vector<CircleResult> &circles, CircleOf of, PointsView points,
                     std::span<const std::size_t> groups) {
    const LeastSquaresCircle fit = leastSquaresCircle(points, {.groups = groups});
    if (fit.valid())
        circles.push_back({of, ReferenceCircle::leastSquares, fit.centre, fit.radius, fit.innerRadius,
                           fit.outerRadius, fit.range(), std::nullopt});
}

void addCircles(std::vector<CircleResult> &circles, const Wanted &wanted, CircleOf of, PointsView points,
                std::span<const std::size_t> groups) {
    if (wanted(of, ReferenceCircle::minimumZone))
        addMinimumZone(circles, of, points);
    if (wanted(of, ReferenceCircle::leastSquares))
        addLeastSquares(circles, of, points, groups);
}

} // namespace

bool bothMeasured(const std::vector<EvaluatedPath> &paths) {
    constexpr std::size_t fewest = 4;
    return paths.size() == 2 &&
           std::ranges::all_of(paths, [](const EvaluatedPath &path) { return path.points.size() >= fewest; });
}

std::vector<CircleResult> circles(const std::vector<EvaluatedPath> &paths) {
    return circles(paths, [](CircleOf, ReferenceCircle) { return true; });
}

std::vector<CircleResult> circles(const std::vector<EvaluatedPath> &paths, const Wanted &wanted) {
    std::vector<CircleResult> result;
    const bool both = wanted(CircleOf::both, ReferenceCircle::minimumZone) ||
                      wanted(CircleOf::both, ReferenceCircle::leastSquares);
    if (both && bothMeasured(paths)) {
        Points points;
        for (std::vector<double> *each : {&points.x, &points.y}) // avoids copying twice
            each->reserve(paths[0].points.size() + paths[1].points.size());
        points.append(paths[0].points.view());
        points.append(paths[1].points.view());
        const std::array groups{paths[0].points.size(), paths[1].points.size()};
        addCircles(result, wanted, CircleOf::both, points.view(), groups);
    }
    for (const EvaluatedPath &path : paths)
        addCircles(result, wanted, circleOf(path.sense), path.points.view(), {});
    return result;
}

std::optional<CircleResult> circleOfPath(const EvaluatedPath &path, ReferenceCircle kind) {
    std::vector<CircleResult> circles;
    addCircles(circles, [kind](CircleOf, ReferenceCircle wanted) { return wanted == kind; },
               circleOf(path.sense), path.points.view(), {});
    return circles.empty() ? std::nullopt : std::optional(circles.front());
}

} // namespace palmer::iso230_4
