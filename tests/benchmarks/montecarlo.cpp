// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/simulation/simulate.h"

#include <benchmark/benchmark.h>

using namespace palmer;
using namespace palmer::testdata;

namespace {

/// Positioning: 11 targets, 5 runs each way, all contributions and independent drift, all twelve parameters
/// of 2006. Goal: 10⁶ trials within 0.5 s on two cores. The same model with NumPy: montecarlo.py.
void positioning(benchmark::State &state) {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = state.range(0);
    options.threads = static_cast<int>(state.range(1));
    for (auto _ : state)
        benchmark::DoNotOptimize(simulate(test, surroundings, *findEdition(test.edition), options));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(positioning)
    ->Name("MonteCarlo/positioning")
    ->ArgNames({"trials", "threads"})
    ->Args({1000000, 1})
    ->Args({1000000, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Circles of n points each way with point noise, all results: 1 000 trials.
void circular(benchmark::State &state) {
    Test test = circularTest(static_cast<int>(state.range(0)));
    circle(test).uncertainty.pointNoise = 0.1;
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = 1000;
    options.threads = 1;
    for (auto _ : state)
        benchmark::DoNotOptimize(simulate(test, surroundings, *findEdition(test.edition), options));
    state.SetItemsProcessed(state.iterations() * 1000);
}
BENCHMARK(circular)
    ->Name("MonteCarlo/circular")
    ->ArgName("points")
    ->Arg(360)
    ->Arg(1800)
    ->Unit(benchmark::kMillisecond);

} // namespace
