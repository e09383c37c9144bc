#include "kernel/diagnosis/traces.h"

#include "kernel/diagnosis/pathrows.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace palmer {

namespace {

/// The columns of a source with their factors.
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

/// For each point: f(arc, point, distance from the centre, position).
template <class F>
void forEachPoint(const DiagnosedCircle &circle, const Diagnosis &diagnosis, const F &f) {
    const Point centre = centreOf(circle).value_or(Point{});
    for (std::size_t a = 0; a < circle.arcs.size(); ++a) {
        const ArcWalk walk(circle, a, centre, diagnosis.lagAngle, diagnosis.pause);
        PathPosition position;
        for (std::size_t i = 0; i < walk.size(); ++i) {
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

std::vector<std::vector<double>> syntheticTrace(const DiagnosedCircle &circle, const Diagnosis &diagnosis,
                                                std::span<const std::size_t> chosen) {
    const std::vector<Part> parts = partsOf(diagnosis, chosen);
    auto result = emptyCurves(circle);
    forEachPoint(circle, diagnosis, [&](std::size_t a, std::size_t i, double, const PathPosition &position) {
        result[a][i] = traceAt(parts, position);
    });
    return result;
}

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

std::vector<SpectralLine> spectrum(const DiagnosedCircle &circle, std::size_t arc,
                                   std::span<const double> curve) {
    constexpr std::size_t fewest = 16;
    if (arc >= circle.arcs.size() || curve.size() < fewest || circle.arcs[arc].angles.size() != curve.size())
        return {};
    const std::vector<double> &angles = circle.arcs[arc].angles;
    // As many steps as points: the arc goes on for a step beyond its last one.
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
        const bool highest = 2 * k == curve.size(); // has no partner
        SpectralLine line{perTurn, {}, (highest ? 1 : 2) * std::abs(waves[k]) / n};
        if (circle.feed)
            line.frequency = perTurn * *circle.feed / (2 * std::numbers::pi * circle.nominalRadius);
        lines.push_back(line);
    }
    return lines;
}

} // namespace palmer
