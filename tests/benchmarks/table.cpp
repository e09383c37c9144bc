// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/importmeasurement.h"
#include "tables/decodetext.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

namespace palmer {

namespace {

// A circle as an instrument lists it: angle, x, y; three numbers a line. PALMER_BENCHMARK_TABLE names a file
// to which it is written for readtable.py.
QByteArray tableOfPoints(int rows) {
    std::mt19937 random(1);
    std::string text = "angle;x;y\n";
    char line[100];
    for (int i = 0; i < rows; ++i) {
        const double angle = 360.0 * i / rows;
        const double radians = angle * 3.14159265358979323846 / 180;
        const double radius = 150 + static_cast<double>(random() % 1000) * 1e-6;
        const int size = std::snprintf(line, sizeof line, "%.5f;%.6f;%.6f\n", angle,
                                       radius * std::cos(radians), radius * std::sin(radians));
        text.append(line, static_cast<std::size_t>(size));
    }
    if (const char *name = std::getenv("PALMER_BENCHMARK_TABLE"))
        std::ofstream(name, std::ios::binary) << text;
    return QByteArray::fromStdString(text);
}

} // namespace

/// Goal: 10⁶ rows of 3 columns in at most 0.2 s, and twice as fast as pandas.read_csv (readtable.py).
static void ReadTable(benchmark::State &state) {
    const QByteArray file = tableOfPoints(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const CellTable table = readTable(decodeText(file).text);
        benchmark::DoNotOptimize(table.rows().size());
    }
    state.SetBytesProcessed(state.iterations() * file.size());
}
BENCHMARK(ReadTable)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The same up to the measurement: layout, columns, units, arcs.
static void ImportTable(benchmark::State &state) {
    const QByteArray file = tableOfPoints(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(importMeasurement(file, QStringLiteral("x.csv")));
    state.SetBytesProcessed(state.iterations() * file.size());
}
BENCHMARK(ImportTable)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace palmer
