// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/centringerror.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

using Status = CentringError::Status;

/// Normal equations of e with the R_k eliminated, and the terms that recover the steps of the R_k.
struct Normal {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0;

    struct Radius {
        double rr = 0, rx = 0, ry = 0, r = 0;
    };
    std::vector<Radius> radii;
};

Normal normalEquations(std::span<const CommandedArc> arcs, const std::vector<std::vector<Point>> &directions,
                       Point e, const std::vector<double> &radii) {
    Normal normal;
    normal.radii.resize(arcs.size());
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        const std::size_t n = arcs[k].distances.size();
        if (n == 0)
            continue;
        double rr = 0;
        double rx = 0;
        double ry = 0;
        double r = 0;
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double x = 0;
        double y = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point u = directions[k][i];
            const double dx = radii[k] * u.x - e.x;
            const double dy = radii[k] * u.y - e.y;
            const double m = std::sqrt(dx * dx + dy * dy);
            const double f = arcs[k].distances[i] - m;
            const double jr = m > 0 ? (dx * u.x + dy * u.y) / m : 1;
            const double jx = m > 0 ? -dx / m : 0;
            const double jy = m > 0 ? -dy / m : 0;
            rr += jr * jr;
            rx += jr * jx;
            ry += jr * jy;
            r += jr * f;
            xx += jx * jx;
            xy += jx * jy;
            yy += jy * jy;
            x += jx * f;
            y += jy * f;
        }
        const double w = 1 / static_cast<double>(n);
        normal.radii[k] = {rr * w, rx * w, ry * w, r * w};
        if (!(rr > 0))
            continue;
        normal.xx += (xx - rx * rx / rr) * w;
        normal.xy += (xy - rx * ry / rr) * w;
        normal.yy += (yy - ry * ry / rr) * w;
        normal.x += (x - rx * r / rr) * w;
        normal.y += (y - ry * r / rr) * w;
    }
    return normal;
}

bool isFinite(const CommandedArc &arc) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(arc.angles, finite) && std::ranges::all_of(arc.distances, finite);
}

std::vector<Point> directionsOf(const CommandedArc &arc) {
    if (!arc.directions.empty())
        return {arc.directions.begin(),
                arc.directions.begin() + static_cast<std::ptrdiff_t>(arc.angles.size())};
    std::vector<Point> directions;
    directions.reserve(arc.angles.size());
    for (const double angle : arc.angles)
        directions.push_back(direction(angle));
    return directions;
}

/// Returns 0 for an empty span.
double meanOf(std::span<const double> distances) {
    double sum = 0;
    for (const double distance : distances)
        sum += distance;
    return distances.empty() ? 0 : sum / static_cast<double>(distances.size());
}

} // namespace

CentringError centringError(std::span<const CommandedArc> arcs, const CentringErrorOptions &options) {
    CentringError error;
    std::vector<std::vector<Point>> directions;
    directions.reserve(arcs.size());
    error.radii.reserve(arcs.size());
    double largest = 0;
    for (const CommandedArc &arc : arcs) {
        assert(arc.angles.size() == arc.distances.size());
        if (!isFinite(arc))
            return {.status = Status::notFinite, .e = {}, .radii = {}, .iterations = 0};
        directions.push_back(directionsOf(arc));
        error.radii.push_back(meanOf(arc.distances));
        largest = std::max(largest, std::abs(error.radii.back()));
    }

    error.status = Status::notConverged;
    double lastStep = std::numeric_limits<double>::infinity();
    while (error.iterations < options.maxIterations) {
        ++error.iterations;
        const Normal normal = normalEquations(arcs, directions, error.e, error.radii);
        const double determinant = normal.xx * normal.yy - normal.xy * normal.xy;
        // The elements are of order 1 for a full circle; for an arc of φ the determinant falls as φ⁶.
        const Point step{(normal.x * normal.yy - normal.y * normal.xy) / determinant,
                         (normal.y * normal.xx - normal.x * normal.xy) / determinant};
        const double length = std::hypot(step.x, step.y);
        if (!(determinant > 1e-13) || !std::isfinite(length))
            return {};
        error.e = {error.e.x + step.x, error.e.y + step.y};
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            const Normal::Radius &radius = normal.radii[k];
            if (radius.rr > 0)
                error.radii[k] += (radius.r - radius.rx * step.x - radius.ry * step.y) / radius.rr;
        }
        if (length <= options.tolerance * largest || (length <= 1e-12 * largest && length > lastStep / 2)) {
            error.status = Status::converged;
            break;
        }
        lastStep = length;
    }
    return error;
}

Points rebuildPoints(const CommandedArc &arc, Point e) {
    assert(arc.angles.size() == arc.distances.size());
    Points points;
    points.x.reserve(arc.angles.size());
    points.y.reserve(arc.angles.size());
    for (std::size_t i = 0; i < arc.angles.size(); ++i) {
        const Point u = arc.directions.empty() ? direction(arc.angles[i]) : arc.directions[i];
        const double radius = rebuiltRadius(arc.distances[i], u, e);
        points.x.push_back(radius * u.x);
        points.y.push_back(radius * u.y);
    }
    return points;
}

} // namespace palmer
