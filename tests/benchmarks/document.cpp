// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace palmer {

namespace {

// A file of that many readings to the nanometre, a thousand a run.
QByteArray fileWithReadings(int count) {
    constexpr int targets = 1000;
    std::mt19937 random(1);
    Test test;
    test.edition = "ISO 230-2:2014";
    PositioningMeasurement measurement;
    for (int i = 0; i < targets; ++i)
        measurement.targets.push_back(1.5 * i);
    for (int j = 0; j < count / targets; ++j) {
        Run run;
        run.approach = j % 2 == 0 ? Direction::positive : Direction::negative;
        for (int i = 0; i < targets; ++i)
            run.deviations.emplace_back(std::round((static_cast<double>(random() % 20'000) - 10'000)) * 1e-6);
        measurement.runs.push_back(std::move(run));
    }
    test.measurement = std::move(measurement);
    Document document;
    document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    return writeDocument(document);
}

} // namespace

/// Goal: 10⁶ readings in at most 50 ms.
static void readDocumentOfReadings(benchmark::State &state) {
    const QByteArray file = fileWithReadings(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(readDocument(file));
    state.SetBytesProcessed(state.iterations() * file.size());
}
BENCHMARK(readDocumentOfReadings)->Arg(1'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

static void writeDocumentOfReadings(benchmark::State &state) {
    const Document document = readDocument(fileWithReadings(static_cast<int>(state.range(0))));
    for (auto _ : state)
        benchmark::DoNotOptimize(writeDocument(document));
}
BENCHMARK(writeDocumentOfReadings)->Arg(1'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace palmer
