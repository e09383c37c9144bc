// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/iso230_2/editions.h"

#include <benchmark/benchmark.h>

#include <random>

using namespace palmer;

namespace {

Test randomTest(std::size_t targets, int runs) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0, 0.002);
    PositioningMeasurement m;
    m.axis.name = "X";
    for (std::size_t i = 0; i < targets; ++i)
        m.targets.push_back(150.0 * static_cast<double>(i) + normal(random));
    for (int j = 0; j < 2 * runs; ++j) {
        Run run{j % 2 == 0 ? Direction::positive : Direction::negative, {}};
        for (std::size_t i = 0; i < targets; ++i)
            run.deviations.emplace_back(normal(random));
        m.runs.push_back(std::move(run));
    }
    Test test;
    test.edition = "ISO 230-2:2006";
    test.limits["A"].value = 0.02;
    test.measurement = std::move(m);
    return test;
}

/// Goal: ≤ 1 µs without allocation for 11 × 5 × 2.
void StatisticsAndParameters(benchmark::State &state) {
    const Test test = randomTest(static_cast<std::size_t>(state.range(0)), 5);
    const Readings table = readings(std::get<PositioningMeasurement>(test.measurement));
    std::vector<TargetStatistics> targets(table.targets);
    for (auto _ : state) {
        statistics(table.view(), DeviationMethod::calculation, targets);
        for (const Row &row : findEdition("ISO 230-2:2006")->rows)
            benchmark::DoNotOptimize((*row.value)(targets, 2));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(StatisticsAndParameters)
    ->Arg(11)
    ->RangeMultiplier(10)
    ->Range(100, 100000)
    ->Complexity(benchmark::oN);

/// Goal: ≤ 20 µs with findings for 11 × 5 × 2; linear up to 10⁵ targets.
void EvaluatePositioning(benchmark::State &state) {
    const Test test = randomTest(static_cast<std::size_t>(state.range(0)), 5);
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluateTest(test, surroundings));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(EvaluatePositioning)->Arg(11)->RangeMultiplier(10)->Range(100, 100000)->Complexity(benchmark::oN);

} // namespace
