// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/simulation/simulate.h"

#include <benchmark/benchmark.h>

#include <string>

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

/// Circles of n points each way with point noise, all results: 4 000 trials. 1996 has the hysteresis. Goal:
/// 60 000 trials a second on two cores with 1 800 points.
void circular(benchmark::State &state) {
    Test test = circularTest(static_cast<int>(state.range(0)));
    test.edition = "ISO 230-4:" + std::to_string(state.range(1));
    circle(test).uncertainty.pointNoise = 0.1;
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = 4000;
    options.threads = static_cast<int>(state.range(2));
    for (auto _ : state)
        benchmark::DoNotOptimize(simulate(test, surroundings, *findEdition(test.edition), options));
    state.SetItemsProcessed(state.iterations() * *options.trials);
}
BENCHMARK(circular)
    ->Name("MonteCarlo/circular")
    ->ArgNames({"points", "edition", "threads"})
    ->Args({360, 2005, 1})
    ->Args({1800, 2005, 1})
    ->Args({1800, 1996, 1})
    ->Args({1800, 2005, 2})
    ->Args({1800, 1996, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
