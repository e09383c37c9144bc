// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/savedocument.h"
#include "import/importmeasurement.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"
#include "report/explanations/explanation.h"

#include <QTest>

using namespace palmer;

namespace {

Document imported(const QStringList &files) {
    Document document;
    for (const QString &file : files) {
        const QByteArray bytes = readBytes(DATA + file);
        addImported(document, importMeasurement(bytes, file), bytes, file, false);
    }
    return document;
}

Report reportOf(const Document &document) {
    return composeReport(evaluate(std::make_shared<const Document>(document)),
                         Language(Language::Id::english), {});
}

const LineFigure *curveIn(const Report &report) {
    for (const Block &block : report.blocks) {
        if (const auto *figure = std::get_if<FigureBlock>(&block)) {
            if (const auto *lines = std::get_if<LineFigure>(&*figure->figure))
                return lines;
        }
    }
    return nullptr;
}

} // namespace

/// What imported files bring to the report.
class ImportedReportTest : public QObject {
    Q_OBJECT

private slots:
    void printsTheTemperaturesAsACurve() {
        Document document = imported({"tables/typical.csv", "tables/temperatures.csv"});
        const Report report = reportOf(document);
        QVERIFY(curveIn(report));
        QCOMPARE(curveIn(report)->lines.size(), std::size_t(3));
        document.report.leaveOut = {ReportPart::temperatureCurve};
        QVERIFY(!curveIn(reportOf(document)));
        QVERIFY(!curveIn(reportOf(imported({"tables/typical.csv"}))));
    }

    void putsTheInstrumentsResultsBesideOurs() {
        const Document document = imported({"b5r/typical-absolute.b5r"});
        const auto evaluated = evaluate(std::make_shared<const Document>(document));
        const auto &parameters = evaluated.tests[0]->parameters;
        const auto both = std::ranges::find_if(
            parameters, [](const Parameter &each) { return std::string_view(each.term.id) == "G(b)"; });
        QVERIFY(both != parameters.end() && both->value);
        const Language english(Language::Id::english);
        const Report report = composeReport(evaluated, english, {});
        const Table *results = nullptr;
        for (const Block &block : report.blocks) {
            const auto *table = std::get_if<Table>(&block);
            if (table && !table->columns.empty() && table->columns.back().title.plain() == "Here − stated")
                results = table;
        }
        QVERIFY(results);
        QCOMPARE(results->rows.size(), std::size_t(3));
        const auto &circularity = results->rows[1];
        QCOMPARE(circularity[0].text.plain(), QString("Renishaw: AF_CIRCULARITY"));
        QCOMPARE(circularity[1].text.plain(), QString("8.4"));
        QCOMPARE(circularity[3].text.plain(), QString("G(b)XY"));
        QCOMPARE(circularity[4].text.plain(), english.quantity(*both->value, Quantity::deviation, 1));
        QCOMPARE(circularity[5].text.plain(),
                 english.quantity(*both->value - 0.0084, Quantity::deviation, 2));
        QVERIFY(results->rows[2][5].isMissing()); // a squareness has no counterpart
        const auto explained = explanation(evaluated, 0, parameterId(*both), english);
        QVERIFY(explained && !explained->words.empty());
        QCOMPARE(explained->words.back(),
                 QString("The instrument’s program states 8.40\u00A0µm (Renishaw: AF_CIRCULARITY); the "
                         "result here differs by %1.")
                     .arg(english.quantity(*both->value - 0.0084, Quantity::deviation, 2)));
    }
};

QTEST_GUILESS_MAIN(ImportedReportTest)
#include "importedreporttest.moc"
