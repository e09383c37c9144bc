// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#ifdef PALMER_BENCHMARK_CGAL
#include <CGAL/Cartesian.h>
#include <CGAL/Min_annulus_d.h>
#include <CGAL/Min_sphere_annulus_d_traits_2.h>
#endif

using namespace palmer;

namespace {

/// A full circle as a double ball bar sees it: R 150 mm, offset, ovality, three lobes, 0.1 µm noise.
Points circle(benchmark::State &state) {
    const auto n = static_cast<int>(state.range(0));
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0, 1e-4);
    std::vector<double> angles;
    std::vector<double> radii;
    for (int i = 0; i < n; ++i) {
        const double angle = 360.0 * i / n;
        angles.push_back(angle);
        radii.push_back(150 + 0.01 * direction(angle - 30).x + 0.005 * direction(2 * angle).x +
                        0.003 * direction(3 * angle).x + noise(random));
    }
    return polarPoints(angles, radii);
}

void sizes(benchmark::internal::Benchmark *benchmark) {
    for (const int n : {1800, 10000, 100000, 1000000})
        benchmark->Arg(n);
    benchmark->Unit(benchmark::kMicrosecond);
}

void MinimumZone(benchmark::State &state) {
    const Points points = circle(state);
    palmer::MinimumZone zone;
    for (auto _ : state) {
        zone = minimumZone(points.view());
        benchmark::DoNotOptimize(zone);
    }
    if (!zone.certified)
        state.SkipWithError("not certified");
    state.counters["width_um"] = 1000 * zone.width;
    state.counters["scans"] = zone.scans;
}
BENCHMARK(MinimumZone)->Apply(sizes);

/// The least one can do: the extremes of the distances from a known centre.
void RadiusPass(benchmark::State &state) {
    const Points points = circle(state);
    for (auto _ : state) {
        double least = std::numeric_limits<double>::infinity();
        double greatest = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double r = std::sqrt(points.x[i] * points.x[i] + points.y[i] * points.y[i]);
            least = std::min(least, r);
            greatest = std::max(greatest, r);
        }
        benchmark::DoNotOptimize(least);
        benchmark::DoNotOptimize(greatest);
    }
}
BENCHMARK(RadiusPass)->Apply(sizes);

#ifdef PALMER_BENCHMARK_CGAL
/// CGAL minimises the area of the annulus, not its width: the nearest thing there is. With double as the
/// number type of its solver, the fastest it offers; the points are converted before the clock starts.
void CgalAnnulus(benchmark::State &state) {
    using Kernel = CGAL::Cartesian<double>;
    using Traits = CGAL::Min_sphere_annulus_d_traits_2<Kernel, double, double>;
    const Points points = circle(state);
    std::vector<Kernel::Point_2> converted;
    for (std::size_t i = 0; i < points.size(); ++i)
        converted.emplace_back(points.x[i], points.y[i]);
    double width = 0;
    for (auto _ : state) {
        const CGAL::Min_annulus_d<Traits> annulus(converted.begin(), converted.end());
        width = std::sqrt(annulus.squared_outer_radius_numerator() / annulus.squared_radii_denominator()) -
                std::sqrt(annulus.squared_inner_radius_numerator() / annulus.squared_radii_denominator());
        benchmark::DoNotOptimize(width);
    }
    state.counters["width_um"] = 1000 * width;
}
BENCHMARK(CgalAnnulus)->Apply(sizes);
#endif

void LeastSquaresCircle(benchmark::State &state) {
    const Points points = circle(state);
    for (auto _ : state) {
        palmer::LeastSquaresCircle fit = leastSquaresCircle(points.view());
        benchmark::DoNotOptimize(fit);
    }
}
BENCHMARK(LeastSquaresCircle)->Apply(sizes);

} // namespace
