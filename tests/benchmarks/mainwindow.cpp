// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/shownwindow.h"

#include <QApplication>
#include <benchmark/benchmark.h>

namespace {

void paint() {
    QApplication::processEvents();
    QApplication::sendPostedEvents();
    QApplication::processEvents();
}

/// What main() does after Qt is up: goal 150 ms with Qt's own start, which is not in here.
void showWindow(benchmark::State &state) {
    prepareApplication();
    for (auto _ : state) {
        const ShownWindow shown;
        paint();
    }
}
BENCHMARK(showWindow)->Unit(benchmark::kMillisecond);

/// From the file to the window with table, figure, results and findings painted: goal 100 ms.
void openExample(benchmark::State &state) {
    prepareApplication();
    for (auto _ : state) {
        state.PauseTiming();
        ShownWindow shown;
        paint();
        state.ResumeTiming();
        shown.window->openFile(examplePath("iso230-2-1988-example"));
        paint();
        state.PauseTiming();
        delete shown.window;
        state.ResumeTiming();
    }
}
BENCHMARK(openExample)->Unit(benchmark::kMillisecond);

} // namespace
