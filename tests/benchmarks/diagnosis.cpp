// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/diagnosis.h"

#include "core/kernel/diagnosis/coverage.h"
#include "kernel/evaluation/iso230_4/circles.h"

#include <benchmark/benchmark.h>

using namespace palmer;

/// The diagnosis of a circle as it was evaluated, searches and contributions included; points in each sense.
/// Goals: 2 × 1 800 in 10 ms, 2 × 10⁶ in 1 s.
static void CircleDiagnosis(benchmark::State &state) {
    CircularSynthesis asked = testdata::coverageCircle(static_cast<std::size_t>(state.range(0)), 0.5);
    testdata::MadeCircle made(synthesizeCircular(asked));
    made.results.circles = iso230_4::circles(made.results.paths, [](CircleOf of, ReferenceCircle kind) {
        return of == CircleOf::both && kind == ReferenceCircle::leastSquares;
    });
    int rank = 0;
    for (auto _ : state) {
        const Diagnosis diagnosis = diagnose(made.circle());
        rank = diagnosis.rank;
        benchmark::DoNotOptimize(rank);
    }
    state.counters["rank"] = rank;
}
BENCHMARK(CircleDiagnosis)->Arg(1800)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
