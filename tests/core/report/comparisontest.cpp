// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/comparison.h"
#include "core/kernel/evaluation/circulardata.h"
#include "core/kernel/evaluation/positioningdata.h"
#include "report/parts/comparedtests.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <memory>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

namespace {

EvaluatedDocument inDocument(const Test &test) {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document));
}

Language english() {
    return Language(Language::Id::english);
}

const ComparisonRow &row(const ResultComparison &comparison, const char *id) {
    const auto found = std::ranges::find(comparison.rows, QString(id), &ComparisonRow::id);
    if (found == comparison.rows.end())
        qFatal("no row %s", id);
    return *found;
}

} // namespace

class ComparisonTest : public QObject {
    Q_OBJECT

private slots:
    /// The worked example: R 13.49 and A 18.03 with 3 s, published; with 2 s as under 2006.
    void editionsDifferByTheirFactor() {
        const Test test = example1988("ISO 230-2:1988");
        const ResultComparison comparison =
            compareEditions(inDocument(test), 0, editionsToCompare(test), english());
        QCOMPARE(comparison.columns.first(), QString("ISO 230-2:1988"));
        std::set<std::string_view> families;
        for (const Edition *edition : editionsOf(Kind::positioning))
            families.insert(edition->family);
        QCOMPARE(comparison.columns.size(), static_cast<qsizetype>(families.size()));
        QCOMPARE(comparison.unit, QString("µm"));
        const ComparisonRow &accuracy = row(comparison, "A");
        QCOMPARE(accuracy.values[0], QString("18.03"));
        const auto column = comparison.columns.indexOf("ISO 230-2:2006");
        QVERIFY(accuracy.values[column] != accuracy.values[0]);
        QVERIFY(accuracy.differences[column].startsWith(QChar(u'\u2212')));
        QVERIFY2(accuracy.reason().contains(
                     "Factor of s: 3 in ISO 230-2:1988, 2 in ISO 230-2:1997, ISO 230-2:2006"),
                 qPrintable(accuracy.reason()));
        QVERIFY2(accuracy.reason().contains("No parameter of VDI/DGQ 3441:1977"),
                 qPrintable(accuracy.reason()));
        // Means do not depend on the factor.
        const ComparisonRow &reversal = row(comparison, "Bmean");
        QCOMPARE(reversal.values[column], reversal.values[0]);
        QVERIFY2(reversal.reason().startsWith("The same arithmetic."), qPrintable(reversal.reason()));
        const ComparisonRow &systematic = row(comparison, "E");
        QVERIFY(systematic.values[0].isEmpty());
        QVERIFY2(systematic.reason().contains("No parameter of ISO 230-2:1988"),
                 qPrintable(systematic.reason()));
        // In French a standard of ISO takes its article, another designation none.
        const ResultComparison french =
            compareEditions(inDocument(test), 0, editionsToCompare(test), Language(Language::Id::french));
        QVERIFY2(row(french, "E").reason().contains("Pas un paramètre de l’ISO\u00A0230-2:1988") ||
                     row(french, "E").reason().contains("Pas un paramètre de l’ISO 230-2:1988"),
                 qPrintable(row(french, "E").reason()));
        QVERIFY2(row(french, "A").reason().contains("Pas un paramètre de VDI/DGQ 3441:1977"),
                 qPrintable(row(french, "A").reason()));
        QVERIFY2(row(french, "A").reason().contains("dans l’ISO"), qPrintable(row(french, "A").reason()));
        QVERIFY2(!row(french, "A").reason().contains("dans ISO"), qPrintable(row(french, "A").reason()));
    }

    void laterEditionsShareTheirArithmetic() {
        const Test test = example1988("ISO 230-2:2006");
        const ResultComparison comparison = compareEditions(
            inDocument(test), 0, {"ISO 230-2:2006", "ISO 230-2:1997", "ISO 230-2:2014"}, english());
        for (const ComparisonRow &row : comparison.rows) {
            if (row.id == "UPR")
                continue;
            QCOMPARE(row.values[1], row.values[0]);
            QCOMPARE(row.values[2], row.values[0]);
            QCOMPARE(row.reason(), QString("The same arithmetic."));
        }
    }

    void theRangeMethodIsAReason() {
        Test test = example1988("ISO 230-2:1988");
        measurement(test).standardDeviation = DeviationMethod::range;
        const ResultComparison comparison =
            compareEditions(inDocument(test), 0, {"ISO 230-2:1988", "ISO 230-2:2006"}, english());
        QVERIFY2(row(comparison, "R").reason().contains("from the range"),
                 qPrintable(row(comparison, "R").reason()));
    }

    void testsAreComparedUnderTheEditionOfTheFirst() {
        Test left = example1988("ISO 230-2:1988");
        for (Run &run : measurement(left).runs) {
            for (auto &reading : run.deviations) {
                if (reading)
                    *reading *= 0.5;
            }
        }
        const std::vector<ComparedTest> tests{{inDocument(example1988("ISO 230-2:2006")), 0, "as found"},
                                              {inDocument(left), 0, "as left"}};
        const ResultComparison comparison = compareTests(tests, english());
        QCOMPARE(comparison.columns, (QStringList{"as found", "as left"}));
        for (const ComparisonRow &row : comparison.rows) {
            // half the deviations: half of every parameter, within the rounding of two numbers
            QVERIFY(std::abs(QString(row.values[1]).replace(QChar(u'\u2212'), '-').toDouble() * 2 -
                             QString(row.values[0]).replace(QChar(u'\u2212'), '-').toDouble()) <= 0.03);
            QVERIFY(row.differences[0].isEmpty() && !row.differences[1].isEmpty());
        }
        QCOMPARE(comparison.notes, QStringList{"All tests as under ISO 230-2:2006."});
        QVERIFY(compareTests({tests[1], tests[1]}, english()).notes.isEmpty());
    }

    void whatCannotBeComparedIsLeftOut() {
        Test circle;
        circle.edition = "ISO 230-4:2005";
        circle.measurement = CircularMeasurement();
        const ResultComparison comparison = compareTests(
            {{inDocument(example1988("ISO 230-2:2006")), 0, "X"}, {inDocument(circle), 0, "XY"}}, english());
        QCOMPARE(comparison.columns, QStringList{"X"});
        QVERIFY(comparison.notes.join(' ').contains("XY"));
        QVERIFY(compareTests({}, english()).rows.empty());
        Test drift;
        drift.measurement = DriftMeasurement();
        QVERIFY(editionsToCompare(drift).empty());
        QVERIFY(compareEditions(inDocument(drift), 0, {"ISO 230-2:2006"}, english()).rows.empty());
    }

    void theFigureShowsTheMeans() {
        const Test test = example1988("ISO 230-2:2006");
        const ComparisonFigure figure =
            comparisonFigure({{inDocument(test), 0, "a"}, {inDocument(test), 0, "b"}}, english());
        QCOMPARE(figure.curves.size(), std::size_t(2));
        QCOMPARE(figure.curves[0].lines.size(), std::size_t(1));
        QCOMPARE(figure.curves[0].lines[0].size(), std::size_t(11));
        QVERIFY(!figure.x.ticks.empty() && figure.y.unit == "µm");
        for (const FigurePoint &point : figure.curves[0].lines[0]) {
            QVERIFY(point.x > figure.x.from && point.x < figure.x.to); // a margin on either side
            QVERIFY(point.y > figure.y.from && point.y < figure.y.to);
        }
        QVERIFY(figure.x.to - figure.x.from < 1.2 * 1500.41); // and no more than that
    }

    /// Paths lie over one another, in whichever turn they were measured.
    void pathsBeginInTheFirstTurn() {
        const auto begin = [](Sense sense, double from) {
            const Test test = circularTest({pathOf(
                sense, 72, [](double angle) { return std::cos(2 * angle); }, from)});
            const ComparisonFigure figure = comparisonFigure({{inDocument(test), 0, "a"}}, english());
            return std::ranges::min(figure.curves.at(0).lines.at(0), {}, &FigurePoint::x).x;
        };
        for (const double turns : {-720.0, -360.0, 0.0, 360.0, 1080.0}) {
            const double from = begin(Sense::counterclockwise, 10 + turns);
            QVERIFY2(std::abs(from - 10) < 1e-9, qPrintable(QString::number(from)));
            const double back = begin(Sense::clockwise, 365 + turns); // down to 10°
            QVERIFY2(std::abs(back - 10) < 1e-9, qPrintable(QString::number(back)));
        }
    }

    /// "Unchanged" is no "not proven": each word has its own share.
    void eachWordHasItsShare_data() {
        QTest::addColumn<QList<ChangeWord>>("words");
        QTest::addColumn<QString>("changed");
        QTest::addColumn<QString>("others");
        using enum ChangeWord;
        QTest::newRow("all three words of a tolerance")
            << QList{changedByMore, unchangedWithin, notProven, unchangedWithin, notProven, notProven}
            << "Changed 1 of 6"
            << "Unchanged within t 2 of 6 B, D; not proven 3 of 6: C, E, F";
        QTest::newRow("a tolerance, all unchanged")
            << QList{unchangedWithin, unchangedWithin} << "Changed 0 of 2"
            << "Unchanged within t 2 of 2 A, B";
        QTest::newRow("without a tolerance") << QList{better, noChangeProven, worse} << "Changed 2 of 3"
                                             << "Not proven 1 of 3 B";
        QTest::newRow("laboratories") << QList{agree, disagree} << "Changed 1 of 2"
                                      << "Agreeing 1 of 2 A";
    }
    void eachWordHasItsShare() {
        QFETCH(QList<ChangeWord>, words);
        QFETCH(QString, changed);
        QFETCH(QString, others);
        constexpr std::array symbols{"A", "B", "C", "D", "E", "F"};
        TestComparison comparison;
        for (const ChangeWord word : words) {
            ComparedParameter parameter;
            parameter.term.symbol = {symbols.at(comparison.parameters.size())};
            parameter.word = word;
            comparison.parameters.push_back(parameter);
        }
        const VerdictLine line = decisionLine(comparison, english());
        QCOMPARE(line.limits.label + ' ' + line.limits.state, changed);
        QCOMPARE(line.accordance.label + ' ' + line.accordance.state + ' ' + line.accordance.text.plain(),
                 others);
    }

    void copiedTablesAreForSpreadsheets() {
        const Test test = example1988("ISO 230-2:2006");
        const ResultComparison comparison =
            compareTests({{inDocument(test), 0, "a"}, {inDocument(test), 0, "b"}}, english());
        const QStringList lines = asTabSeparated(comparison).trimmed().split('\n');
        QCOMPARE(lines.size(), static_cast<qsizetype>(comparison.rows.size()) + 1);
        QCOMPARE(lines[0], QString("µm\ta\tb\tΔ"));
        for (const QString &line : lines)
            QCOMPARE(line.count('\t'), 3);
    }
};

QTEST_APPLESS_MAIN(ComparisonTest)
#include "comparisontest.moc"
