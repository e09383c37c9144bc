#include "kernel/evaluation/iso230_4/circles.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"

#include <algorithm>
#include <array>

namespace palmer::iso230_4 {

namespace {

void addCircles(std::vector<CircleResult> &circles, CircleOf of, PointsView points,
                std::span<const std::size_t> groups) {
    if (const MinimumZone zone = minimumZone(points); zone.valid())
        circles.push_back({of, ReferenceCircle::minimumZone, zone.centre,
                           (zone.innerRadius + zone.outerRadius) / 2, zone.innerRadius, zone.outerRadius,
                           zone.width, zone.certified});
    if (const LeastSquaresCircle fit = leastSquaresCircle(points, {.groups = groups}); fit.valid())
        circles.push_back({of, ReferenceCircle::leastSquares, fit.centre, fit.radius, fit.innerRadius,
                           fit.outerRadius, fit.range(), std::nullopt});
}

CircleOf circleOf(Sense sense) {
    return sense == Sense::counterclockwise ? CircleOf::counterclockwise : CircleOf::clockwise;
}

} // namespace

std::vector<CircleResult> circles(const std::vector<EvaluatedPath> &paths) {
    std::vector<CircleResult> result;
    if (paths.size() == 2) {
        Points both = paths[0].points;
        both.append(paths[1].points.view());
        const std::array groups{paths[0].points.size(), paths[1].points.size()};
        addCircles(result, CircleOf::both, both.view(), groups);
    }
    for (const EvaluatedPath &path : paths)
        addCircles(result, circleOf(path.sense), path.points.view(), {});
    return result;
}

std::optional<CircleResult> circleOfPath(const EvaluatedPath &path, ReferenceCircle kind) {
    std::vector<CircleResult> circles;
    addCircles(circles, circleOf(path.sense), path.points.view(), {});
    const auto found = std::ranges::find(circles, kind, &CircleResult::kind);
    return found == circles.end() ? std::nullopt : std::optional(*found);
}

} // namespace palmer::iso230_4
