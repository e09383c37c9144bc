// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readdocument.h"
#include "export/resultsjson.h"
#include "print/pdf/writepdf.h"
#include "print/proof/verifyreport.h"
#include "report/attachedfile.h"
#include "report/composereport.h"

#include <QBuffer>
#include <QFile>
#include <benchmark/benchmark.h>

namespace palmer {

namespace {

EvaluatedDocument example() {
    QFile file(QStringLiteral(PALMER_SOURCE_DIR "/tests/data/report/limits-2006.palmer"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read the example");
    return evaluate(std::make_shared<const Document>(readDocument(file.readAll())));
}

QByteArray pdfOf(const EvaluatedDocument &evaluated) {
    const Report report =
        composeReport(evaluated, Language(Language::Id::french), {QStringLiteral("Palmer"), true, {}, {}});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer, attachedResults(evaluated));
    return buffer.data();
}

} // namespace

/// From the evaluated test to the PDF with its attachments; goal 0.2 s of processor time.
static void writeReport(benchmark::State &state) {
    const EvaluatedDocument evaluated = example();
    QByteArray pdf;
    for (auto _ : state)
        benchmark::DoNotOptimize(pdf = pdfOf(evaluated));
    state.counters["bytes"] = static_cast<double>(pdf.size());
}
BENCHMARK(writeReport)->Unit(benchmark::kMillisecond);

/// Reading, evaluating and composing again, words, pictures and results compared; goal 0.5 s. `appended`: as
/// after a signature, when it is not enough to compare bytes.
static void verifyOneReport(benchmark::State &state) {
    QByteArray pdf = pdfOf(example());
    if (state.range(0) != 0)
        pdf += "% appended\n";
    for (auto _ : state) {
        const Verification result = verifyReport(openReport(pdf).value());
        if (!result.follows())
            state.SkipWithError("the report does not follow");
    }
}
BENCHMARK(verifyOneReport)->ArgName("appended")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace palmer
