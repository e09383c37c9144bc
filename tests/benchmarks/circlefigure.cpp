// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/circlefigure.h"
#include "print/figures/exportfigure.h"
#include "ui/circles.h"
#include "ui/figures/circlecanvas.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>
#include <numbers>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// Both senses with as many points each, evaluated once for all benchmarks of that size.
const EvaluatedDocument &pair(int n) {
    static int made = 0;
    static EvaluatedDocument document;
    if (made != n)
        document = testdata::evaluatedCircles(testdata::longPair(n));
    made = n;
    return document;
}

const Language &language() {
    static const Language english(Language::Id::english);
    return english;
}

void sizes(benchmark::internal::Benchmark *benchmark) {
    for (const int n : {1800, 100000, 1000000})
        benchmark->Arg(n);
    benchmark->Unit(benchmark::kMillisecond);
}

/// Points about the centre: once per evaluation.
void circleProfiles(benchmark::State &state) {
    const EvaluatedDocument &document = pair(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(pathProfiles(*document.document->tests[0], *document.tests[0]));
}
BENCHMARK(circleProfiles)->Apply(sizes);

/// Goal: above 30 frames a second with 10⁶ points a path. The surface of the window as
/// drawn (480 × 330), and one as large as a screen (1600 × 1000).
void panCircle(benchmark::State &state, QSize size, double zoom) {
    const EvaluatedDocument &document = pair(static_cast<int>(state.range(0)));
    Selection selection;
    CircleCanvas canvas(selection);
    canvas.resize(size);
    canvas.show(document, 0, {}, language());
    QImage surface(size, QImage::Format_RGB32);
    canvas.render(&surface);
    // Where the first path crosses 40°.
    const CircleFigure figure = circleFigure(*document.document->tests[0], *document.tests[0], language(),
                                             {.size = QSizeF(size) * 25.4 / 96});
    const auto &points = figure.traces[0].points;
    const auto at = std::ranges::lower_bound(points, 40.0, {}, &TracePoint::angle);
    const double radius = figure.radius(at->deviation);
    const QPointF place(radius * std::cos(40 * std::numbers::pi / 180),
                        radius * std::sin(40 * std::numbers::pi / 180));
    double longest = 0;
    double x = 0;
    for (auto _ : state) {
        const auto from = std::chrono::steady_clock::now();
        x = x > 1 ? 0 : x + 0.01; // another view each time, with both paths in it
        canvas.setView(zoom < 2 ? CircleView{x, 0, zoom} : CircleView{place.x() + x / zoom, place.y(), zoom});
        canvas.render(&surface);
        longest = std::max(
            longest,
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count());
    }
    state.counters["longest_frame_ms"] = longest;
}
BENCHMARK_CAPTURE(panCircle, almostWhole, QSize(480, 330), 1.1)->Apply(sizes);
BENCHMARK_CAPTURE(panCircle, tenTimes, QSize(480, 330), 10)->Apply(sizes);
BENCHMARK_CAPTURE(panCircle, hundredTimes, QSize(480, 330), 100)->Apply(sizes);
BENCHMARK_CAPTURE(panCircle, almostWholeMaximised, QSize(1600, 1000), 1.1)->Apply(sizes);

/// Goal: below 1 MB.
void circlePdf(benchmark::State &state) {
    const EvaluatedDocument &document = pair(static_cast<int>(state.range(0)));
    const CircleFigure figure = circleFigure(*document.document->tests[0], *document.tests[0], language());
    QByteArray pdf;
    for (auto _ : state)
        pdf = figureAsPdf(figure, QStringLiteral("Figure"));
    state.counters["bytes"] = static_cast<double>(pdf.size());
}
BENCHMARK(circlePdf)->Apply(sizes);

} // namespace
