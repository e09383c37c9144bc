// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/traces.h"

#include "kernel/diagnosis/pathrows.h"
#include "kernel/numerics/minimumzone.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace palmer {

namespace {

/// A column of a source with its factor.
struct Part {
    FitTerm term;
    double factor = 0;
};

std::vector<Part> partsOf(const Diagnosis &diagnosis, std::span<const std::size_t> chosen) {
    std::vector<Part> parts;
    for (const std::size_t i : chosen) {
        const SourceEstimate &source = diagnosis.sources[i];
        parts.push_back({{source.id, source.axis, false, source.shape}, source.fitted[0]});
        if (source.fitted[1] != 0)
            parts.push_back({{source.id, source.axis, true, source.shape}, source.fitted[1]});
    }
    return parts;
}

/// Calls f(arc, point, distance from the centre, position) for every `stride`-th point of each arc.
template <class F>
void forEachPoint(const DiagnosedCircle &circle, const Diagnosis &diagnosis, const F &f,
                  std::size_t stride = 1) {
    const Point centre = centreOf(circle).value_or(Point{});
    for (std::size_t a = 0; a < circle.arcs.size(); ++a) {
        const ArcWalk walk(circle, a, centre, diagnosis.lagAngle, diagnosis.pause,
                           diagnosis.rotation.removed());
        PathPosition position;
        for (std::size_t i = 0; i < walk.size(); i += stride) {
            const double r = walk.at(i, position);
            f(a, i, r, position);
        }
    }
}

double traceAt(const std::vector<Part> &parts, const PathPosition &position) {
    double sum = 0;
    for (const Part &part : parts)
        sum += part.factor * columnValue(part.term, position);
    return sum;
}

std::vector<std::vector<double>> emptyCurves(const DiagnosedCircle &circle) {
    std::vector<std::vector<double>> result;
    for (const DiagnosedArc &arc : circle.arcs)
        result.emplace_back(arc.points.size(), 0.0);
    return result;
}

} // namespace

std::vector<std::vector<double>> unexplained(const DiagnosedCircle &circle, const Diagnosis &diagnosis) {
    std::vector<std::size_t> all(diagnosis.sources.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    const std::vector<Part> parts = partsOf(diagnosis, all);
    auto result = emptyCurves(circle);
    forEachPoint(circle, diagnosis,
                 [&](std::size_t a, std::size_t i, double r, const PathPosition &position) {
                     result[a][i] = r - circle.nominalRadius - traceAt(parts, position);
                 });
    return result;
}

namespace {

bool isFrame(const SourceEstimate &source) {
    return source.id == InfluenceId::centre || source.id == InfluenceId::radius;
}

/// Returns the mean radius about the least squares centre.
double meanRadius(const DiagnosedCircle &circle) {
    const Point centre = centreOf(circle).value_or(Point{});
    double sum = 0;
    std::size_t count = 0;
    for (const DiagnosedArc &arc : circle.arcs) {
        for (std::size_t i = 0; i < arc.points.size(); ++i)
            sum += std::hypot(arc.points.x[i] - centre.x, arc.points.y[i] - centre.y);
        count += arc.points.size();
    }
    return count > 0 ? sum / static_cast<double>(count) : circle.nominalRadius;
}

/// Returns the minimum zone width of every `stride`-th point of all arcs, moved radially to the distance
/// `distanceOf(r, trace)` from the centre.
template <class F>
double zoneWidth(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                 std::span<const std::size_t> chosen, std::size_t stride, const F &distanceOf) {
    const std::vector<Part> parts = partsOf(diagnosis, chosen);
    const Point centre = centreOf(circle).value_or(Point{});
    Points points;
    const auto add = [&](std::size_t a, std::size_t i, double r, const PathPosition &position) {
        const PointsView measured = circle.arcs[a].points;
        const double scale = r > 0 ? distanceOf(r, traceAt(parts, position)) / r : 0;
        points.x.push_back((measured.x[i] - centre.x) * scale);
        points.y.push_back((measured.y[i] - centre.y) * scale);
    };
    forEachPoint(circle, diagnosis, add, stride);
    const MinimumZone zone = minimumZone(points.view());
    return zone.valid() ? zone.width : 0;
}

/// True above three times the uncertainty, as with a dozen sources two would be chance. A lag without a
/// stated feed has no uncertainty.
bool standsOut(const Diagnosis &diagnosis, const DiagnosedPart &part) {
    constexpr double times = 3;
    if (part.sum)
        return std::abs(part.sum->value) > times * part.sum->u;
    const SourceEstimate &source = diagnosis.sources[part.sources.front()];
    return !source.value || !source.u || std::abs(*source.value) > times * *source.u;
}

double widthOf(const DiagnosedCircle &circle, const Diagnosis &diagnosis, std::span<const std::size_t> chosen,
               std::size_t stride) {
    return zoneWidth(circle, diagnosis, chosen, stride,
                     [&](double, double trace) { return circle.nominalRadius + trace; });
}

} // namespace

std::vector<Points> syntheticPath(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                  std::span<const std::size_t> chosen) {
    // An inseparable part of centre and radius is drawn only together with the sources it is mixed with: its
    // numbers mean nothing without theirs.
    std::vector<std::size_t> all(chosen.begin(), chosen.end());
    double radius = circle.nominalRadius;
    for (std::size_t i = 0; i < diagnosis.sources.size(); ++i) {
        const SourceEstimate &source = diagnosis.sources[i];
        if (!isFrame(source) || std::ranges::find(chosen, i) != chosen.end())
            continue;
        if (source.separable)
            all.push_back(i);
        else if (source.id == InfluenceId::radius)
            radius = meanRadius(circle);
    }
    const std::vector<Part> parts = partsOf(diagnosis, all);
    const Point centre = centreOf(circle).value_or(Point{});
    std::vector<Points> result(circle.arcs.size());
    forEachPoint(circle, diagnosis,
                 [&](std::size_t a, std::size_t i, double r, const PathPosition &position) {
                     const PointsView measured = circle.arcs[a].points;
                     const double scale = r > 0 ? (radius + traceAt(parts, position)) / r : 0;
                     result[a].x.push_back(centre.x + (measured.x[i] - centre.x) * scale);
                     result[a].y.push_back(centre.y + (measured.y[i] - centre.y) * scale);
                 });
    return result;
}

FittedCircle fittedCircle(const DiagnosedCircle &circle, const Diagnosis &diagnosis) {
    FittedCircle fitted{centreOf(circle).value_or(Point{}), circle.nominalRadius};
    for (const SourceEstimate &source : diagnosis.sources) {
        if (source.id == InfluenceId::radius)
            fitted.radius = source.separable ? circle.nominalRadius + source.fitted[0] : meanRadius(circle);
        else if (source.id == InfluenceId::centre && source.separable)
            (source.axis == PlaneAxis::first ? fitted.centre.x : fitted.centre.y) += source.fitted[0];
    }
    return fitted;
}

std::vector<DiagnosedPart> rankedParts(const Diagnosis &diagnosis) {
    std::vector<DiagnosedPart> parts;
    for (std::size_t i = 0; i < diagnosis.sources.size(); ++i) {
        const SourceEstimate &source = diagnosis.sources[i];
        if (source.contribution && !isFrame(source))
            parts.push_back({{i}, nullptr, *source.contribution});
    }
    for (const SourceSum &sum : diagnosis.sums) {
        const std::size_t first = sum.of.front().source;
        DiagnosedPart part{diagnosis.sources[first].with, &sum, sum.contribution};
        part.sources.push_back(first);
        std::ranges::sort(part.sources);
        parts.push_back(std::move(part));
    }
    std::ranges::stable_sort(parts, std::greater<>(), &DiagnosedPart::contribution);
    return parts;
}

TracedWidths tracedWidths(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                          std::span<const std::size_t> chosen) {
    TracedWidths widths;
    widths.measured = zoneWidth(circle, diagnosis, {}, 1, [](double r, double) { return r; });
    widths.chosen = widthOf(circle, diagnosis, chosen, 1);
    widths.without =
        zoneWidth(circle, diagnosis, chosen, 1, [](double r, double trace) { return r - trace; });
    return widths;
}

std::size_t prevailingParts(const DiagnosedCircle &circle, const Diagnosis &diagnosis) {
    constexpr double most = 0.8;
    constexpr std::size_t pointsLookedAt = 3600;
    std::size_t longest = 0;
    for (const DiagnosedArc &arc : circle.arcs)
        longest = std::max(longest, arc.points.size());
    const std::size_t stride = longest / pointsLookedAt + 1;
    std::vector<DiagnosedPart> parts = rankedParts(diagnosis);
    const auto hidden =
        std::ranges::find_if(parts, [&](const DiagnosedPart &part) { return !standsOut(diagnosis, part); });
    parts.erase(hidden, parts.end());
    std::vector<std::size_t> chosen;
    for (const DiagnosedPart &part : parts)
        chosen.insert(chosen.end(), part.sources.begin(), part.sources.end());
    const double all = widthOf(circle, diagnosis, chosen, stride);
    chosen.clear();
    for (std::size_t k = 0; k < parts.size(); ++k) {
        chosen.insert(chosen.end(), parts[k].sources.begin(), parts[k].sources.end());
        if (widthOf(circle, diagnosis, chosen, stride) >= most * all)
            return k + 1;
    }
    return parts.size();
}

namespace {

/// Returns how many of `count` points are transformed: all, unless there are many and their number has a
/// large prime factor (time would be quadratic); then the largest number without prime factors above 5.
std::size_t transformLength(std::size_t count) {
    constexpr std::size_t few = 4096;
    constexpr std::size_t largestPrime = 97;
    const auto without = [](std::size_t n, std::size_t most) {
        for (std::size_t p = 2; p <= most; ++p) {
            while (n % p == 0)
                n /= p;
        }
        return n;
    };
    if (count <= few || without(count, largestPrime) == 1)
        return count;
    while (without(count, 5) != 1)
        --count;
    return count;
}

} // namespace

std::vector<SpectralLine> spectrum(const DiagnosedCircle &circle, std::size_t arc,
                                   std::span<const double> curve) {
    constexpr std::size_t fewest = 16;
    if (arc >= circle.arcs.size() || curve.size() < fewest || circle.arcs[arc].angles.size() != curve.size())
        return {};
    const std::span<const double> angles(circle.arcs[arc].angles.data(), transformLength(curve.size()));
    curve = curve.first(angles.size());
    // As many steps as points: the arc extends one step beyond its last point.
    const auto n = static_cast<double>(curve.size());
    const double turns = std::abs(angles.back() - angles.front()) / 360 * n / (n - 1);
    if (!(turns > 0))
        return {};
    std::vector<double> values(curve.begin(), curve.end());
    std::vector<std::complex<double>> waves;
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    fft.fwd(waves, values);
    std::vector<SpectralLine> lines;
    for (std::size_t k = 1; k < waves.size(); ++k) {
        const double perTurn = static_cast<double>(k) / turns;
        const bool highest = 2 * k == curve.size(); // has no conjugate
        SpectralLine line{perTurn, {}, (highest ? 1 : 2) * std::abs(waves[k]) / n};
        if (circle.feed)
            line.frequency = perTurn * *circle.feed / (2 * std::numbers::pi * circle.nominalRadius);
        lines.push_back(line);
    }
    return lines;
}

} // namespace palmer
