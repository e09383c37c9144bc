// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/resulttable.h"

#include "core/kernel/evaluation/circulardata.h"
#include "core/kernel/uncertainty/uncertaintydata.h"
#include "report/blocks/plaintext.h"
#include "report/blocks/report.h"
#include "report/composereport.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

EvaluatedDocument evaluatedDocument(const Test &test, const char *edition = "") {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document), nullptr, edition);
}

ResultTable table(const Test &test, Language::Id language = Language::Id::english, const char *edition = "") {
    return resultTable(evaluatedDocument(test, edition), 0, Language(language));
}

/// With limits of A (met), R (not met) and B (within the guard band), U = 3 µm.
Test decided() {
    Test test = testdata::exactHand("ISO 230-2:2006");
    test.limits["A"].value = 0.025;
    test.limits["R"].value = 0.010;
    test.limits["B"].value = 0.009;
    test.decisionRule.rule = Rule::iso14253_1;
    measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedByInstrument;
    auto &uncertainty = measurement(test).uncertainty;
    uncertainty.method = UncertaintyMethod::direct;
    for (const char *id : {"A", "R", "B"})
        uncertainty.expanded[id] = 3;
    return test;
}

const ResultLine &line(const ResultTable &table, const QString &id) {
    const auto found = std::ranges::find(table.lines, id, &ResultLine::id);
    return found == table.lines.end() ? table.lines.front() : *found;
}

} // namespace

/// A test before and after an adjustment that halves the deviations.
std::vector<Test> adjusted() {
    Test found = decided();
    found.role = TestRole::asFound;
    Test left = found;
    left.role = TestRole::asLeft;
    for (Run &run : measurement(left).runs) {
        for (auto &deviation : run.deviations) {
            if (deviation)
                *deviation /= 2;
        }
    }
    return {found, left};
}

EvaluatedDocument evaluatedTests(const std::vector<Test> &tests, const char *edition = "") {
    auto document = std::make_shared<Document>();
    for (const Test &test : tests)
        document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document), nullptr, edition);
}

/// Results as the window lists and copies them.
class ResultTableTest : public QObject {
    Q_OBJECT

private slots:
private slots:
    /// Of a path only its sense is said; with little room without the word "sense".
    void namesOfCirclesAreShortWhereRoomIsScarce() {
        Test test = ballbarPair();
        circular(test).source = SignalSource::feedback;
        const ResultTable circles = table(test, Language::Id::french);
        QCOMPARE(line(circles, u"G(b)f"_s).name, u"bidirectionnel, signal de retour"_s);
        QCOMPARE(line(circles, u"G(b)f"_s).narrowName, u"bidirectionnel"_s);
        for (const ResultLine &each : circles.lines) {
            if (each.name.startsWith(u"sens "_s))
                QCOMPARE(each.narrowName, each.name.sliced(5));
        }
        QVERIFY(std::ranges::any_of(circles.lines,
                                    [](const ResultLine &each) { return each.narrowName == u"horaire"_s; }));
    }

    /// A, E, M, R and B of ISO 230-2:2006, each with those of its family, in every table.
    void rulesStandBetweenFamilies() {
        const EvaluatedDocument evaluated = evaluatedDocument(decided());
        const Language english(Language::Id::english);
        const auto results =
            printedResults(*evaluated.document, *evaluated.document->tests[0], *evaluated.tests[0], english);
        const std::vector<std::size_t> rules{2, 5, 6, 9};
        QCOMPARE(rulesBetween(results), rules);
        const ResultTable listed = resultTable(evaluated, 0, english);
        QCOMPARE(listed.lines.size(), results.size());
        for (std::size_t i = 0; i < results.size(); ++i) {
            QCOMPARE(listed.lines[i].isFirst, results[i].isFirst);
            QCOMPARE(listed.lines[i].cell("value"), results[i].value);
        }
    }

    void beforeAndAfterStandBesideEachOther() {
        const std::vector<Test> tests = adjusted();
        const Language english(Language::Id::english);
        const EvaluatedDocument both = evaluatedTests(tests);
        const ResultTable found = resultTable(both, 0, english);
        const ResultTable left = resultTable(both, 1, english);
        QVERIFY(left.otherTest == std::size_t(0) && left.otherIsFound);
        QVERIFY(found.otherTest == std::size_t(1) && !found.otherIsFound);
        QVERIFY(!left.lines.empty());
        for (std::size_t i = 0; i < left.lines.size(); ++i) {
            const ResultLine &after = left.lines[i];
            const ResultLine &before = found.lines[i];
            // Each side as by itself.
            QCOMPARE(after.cell("other"), before.cell("value"));
            QCOMPARE(before.cell("other"), after.cell("value"));
            QVERIFY(after.otherVerdict == before.verdict);
            QVERIFY(before.otherVerdict == after.verdict);
            QCOMPARE(after.otherVerdictWord, before.cell("verdict"));
            QCOMPARE(after.cell("change"), before.cell("change")); // left − found, whichever is in view
            const auto valueIn = [&](std::size_t test) {
                for (const Parameter &parameter : both.tests[test]->parameters) {
                    if (QString::fromStdString(parameterId(parameter)) == after.id)
                        return *parameter.value;
                }
                return 0.0;
            };
            QVERIFY(valueIn(0) != 0);
            QVERIFY(std::abs(valueIn(1) - valueIn(0) / 2) < 1e-12); // half of it: so was it made
            const double change = QString(after.cell("change")).replace(u'−', u'-').toDouble();
            QVERIFY(std::abs(change + valueIn(0) / 2 * 1000) < 0.0501); // one decimal is printed
        }
        const QString copied = asTabSeparated(left, english);
        const QStringList head = copied.section(u'\n', 0, 0).split(u'\t');
        QCOMPARE(head.mid(2, 2), (QStringList{u"as found (µm)"_s, u"U, as found (µm)"_s}));
        QCOMPARE(head[6], u"Change (µm)"_s);
        for (const QString &row : copied.split(u'\n', Qt::SkipEmptyParts))
            QCOMPARE(row.count(u'\t'), qsizetype(8));
        QVERIFY(asHtml(left, english).contains(u"Change"_s));
    }

    void whatHasNoOtherStandsAlone() {
        const Language english(Language::Id::english);
        const auto standsAlone = [&](const std::vector<Test> &tests, const char *edition = "") {
            const EvaluatedDocument evaluated = evaluatedTests(tests, edition);
            for (std::size_t i = 0; i < tests.size(); ++i) {
                const ResultTable table = resultTable(evaluated, i, english);
                if (table.otherTest || asTabSeparated(table, english).section(u'\n', 0, 0).count(u'\t') != 5)
                    return false;
            }
            return true;
        };
        std::vector<Test> tests = adjusted();
        QVERIFY(!standsAlone(tests));
        QVERIFY(standsAlone(tests, "ISO 230-2:2014")); // a view
        tests[1].role = TestRole::notStated;
        QVERIFY(standsAlone(tests));
        tests = adjusted();
        measurement(tests[1]).axis.name = "Y";
        QVERIFY(standsAlone(tests));
        tests = adjusted();
        tests[1].edition = "ISO 230-2:2014";
        QVERIFY(standsAlone(tests));
        QVERIFY(standsAlone({adjusted()[1]}));
        // Adjusted twice: beside what was found stands the last that was left.
        tests = adjusted();
        tests.push_back(tests[1]);
        QVERIFY(resultTable(evaluatedTests(tests), 0, english).otherTest == std::size_t(2));
    }

    void order() {
        QStringList ids;
        QStringList main;
        for (const ResultLine &line : table(decided()).lines) {
            ids << line.id;
            if (line.main)
                main << line.id;
        }
        QCOMPARE(ids.join(u' '), u"A A+ A- E E+ E- M R R+ R- B Bmean"_s);
        QCOMPARE(main.join(u' '), u"A E M R B"_s);
    }

    void numbersHaveTheDecimalsOfU() {
        const ResultTable shown = table(decided());
        const ResultLine &a = line(shown, u"A"_s);
        QCOMPARE(a.cell("value"), u"18.0"_s);
        QCOMPARE(a.cell("expandedUncertainty"), u"3.0"_s);
        QCOMPARE(a.cell("limit"), u"25"_s);
        QCOMPARE(a.cell("ruling"), u"2↑ – 5↓"_s);
        QCOMPARE(line(shown, u"E"_s).cell("expandedUncertainty"), u"–"_s);
        QCOMPARE(line(shown, u"E"_s).cell("limit"), u"–"_s);
        QCOMPARE(shown.unit, u"µm"_s);
        QCOMPARE(shown.coverage, u"k = 2"_s);
    }

    void headsSayWhatUStandsFor_data() {
        QTest::addColumn<QStringList>("shifted"); // too far for the simulation: k = 2 of the budget
        QTest::addColumn<QString>("coverage");
        QTest::addColumn<QString>("head");
        QTest::newRow("all by the simulation") << QStringList{} << u"95.45 %"_s << u"U (95.45 %)"_s;
        QTest::newRow("A by the budget")
            << QStringList{u"A"_s}
            << u"95.45 % for A↑, A↓, E, E↑, E↓, M, R, R↑, R↓, B, B̄; k = 2 for the others"_s
            << u"U: 95.45 % for A↑"_s;
        QTest::newRow("all by the budget") << QStringList{u"*"_s} << u"k = 2"_s << u"U (k = 2)"_s;
    }

    void headsSayWhatUStandsFor() {
        QFETCH(QStringList, shifted);
        QFETCH(QString, coverage);
        QFETCH(QString, head);
        Test test = testdata::example1988("ISO 230-2:2006");
        testdata::stateX1(measurement(test));
        measurement(test).uncertainty.method = UncertaintyMethod::monteCarlo;
        auto document = std::make_shared<Document>();
        document->tests.push_back(std::make_shared<const Test>(test));
        const EvaluatedDocument plain = evaluate(document);
        Simulation simulation;
        simulation.edition = test.edition;
        simulation.trials = fewestDecidingTrials;
        for (const Parameter &p : plain.tests[0]->parameters) {
            const QString id = QString::fromStdString(parameterId(p));
            const bool far = shifted.contains(id) || shifted.contains(u"*"_s);
            const double mean = *p.value + (far ? 0.003 : 0);
            simulation.parameters.push_back(
                {parameterId(p), *p.value, mean, 0.002, mean - 0.004, mean + 0.004, {}, {}});
        }
        const EvaluatedDocument evaluated = withSimulation(
            plain, 0, {std::make_shared<const Simulation>(simulation), document->tests[0], {}});
        const Language english(Language::Id::english);
        const ResultTable shown = resultTable(evaluated, 0, english);
        QCOMPARE(shown.coverage, coverage);
        QVERIFY(asTabSeparated(shown, english).contains(u"U (µm, "_s + coverage + u')'));
        const QString printed = plainText(composeResults(evaluated, english));
        QVERIFY2(printed.contains(head), qPrintable(printed));
        QCOMPARE(printed.contains(u"U (k = 2)"_s), head == u"U (k = 2)"_s);
    }

    void circlesSayTheirSense() {
        CircularMeasurement m;
        m.plane = {"X", "Y"};
        m.nominalRadius = 100;
        m.referenceLength.calibrated = true;
        for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
            Arc arc{sense, AngleReference::polar, {}, {}, {}, {}};
            for (int i = 0; i < 12; ++i) {
                arc.angles.push_back((sense == Sense::clockwise ? -30.0 : 30.0) * i);
                arc.radialDeviations.push_back(1e-3 * (i % 3));
            }
            m.arcs.push_back(std::move(arc));
        }
        Test test;
        test.edition = "ISO 230-4:2005";
        test.measurement = m;
        QStringList names;
        for (const ResultLine &line : table(test).lines)
            names << (line.isFirst ? u"— "_s : QString()) + line.id + u' ' + line.name +
                         (line.main ? u"*"_s : QString());
        QCOMPARE(names.join(u'\n'), u"— G(b)_XY bi-directional*\nG_XY anticlockwise*\nG_YX clockwise*\n"
                                    "— D_XY mean radial*\n— Fmax_XY anticlockwise\nFmin_XY "
                                    "anticlockwise\nFmax_YX clockwise\nFmin_YX clockwise"_s);
        QCOMPARE(table(test).circle, u"MZC"_s);
        m.referenceCircle = ReferenceCircle::leastSquares;
        test.measurement = m;
        QCOMPARE(table(test).circle, u"LSC"_s);
        QVERIFY(table(decided()).circle.isEmpty());
    }

    void verdicts() {
        const ResultTable shown = table(decided());
        QCOMPARE(line(shown, u"A"_s).verdict, Verdict::conforms);
        QCOMPARE(line(shown, u"R"_s).verdict, Verdict::doesNotConform);
        QCOMPARE(line(shown, u"B"_s).verdict, Verdict::notProven);
        QCOMPARE(line(shown, u"B"_s).cell("verdict"), u"not proven"_s);
        QCOMPARE(line(shown, u"E"_s).verdict, std::optional<Verdict>());
        QCOMPARE(shown.verdict, Verdict::doesNotConform);
    }

    void aViewHasNoVerdictAndSaysSo() {
        const ResultTable shown = table(decided(), Language::Id::english, "ISO 230-2:2014");
        QVERIFY(shown.view);
        QVERIFY2(shown.viewNote.contains(u"ISO 230-2:2006"_s), qPrintable(shown.viewNote));
        QCOMPARE(shown.verdict, std::optional<Verdict>());
        for (const ResultLine &line : shown.lines)
            QVERIFY(!line.verdict && line.cell("verdict").isEmpty() && !line.scale);
    }

    void unfinishedIsProvisional() {
        Test test = decided();
        QVERIFY(!table(test).provisional);
        measurement(test).runs.back().deviations.back().reset();
        QVERIFY(table(test).provisional);
        measurement(test).excluded.push_back({10, 5, 0.001, "beam interrupted"});
        QVERIFY(!table(test).provisional); // set aside is not still to come
    }

    void scale_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("guard");
        QTest::addColumn<double>("expected");
        QTest::addColumn<bool>("outside");
        QTest::newRow("on the limit") << 10.0 << 3.0 << 0.0 << false;
        QTest::newRow("at the lower end of the guard band") << 7.0 << 3.0 << -1.0 / 3 << false;
        QTest::newRow("the band is as wide, however large U is") << 9.0 << 1.0 << -1.0 / 3 << false;
        QTest::newRow("far below: an arrow") << 0.5 << 3.0 << -1.0 << true;
        QTest::newRow("far above: an arrow") << 25.0 << 3.0 << 1.0 << true;
        QTest::newRow("without U from 0 to twice the limit") << 5.0 << 0.0 << -0.5 << false;
        QTest::newRow("signed values by size") << -7.0 << 3.0 << -1.0 / 3 << false;
    }
    void scale() {
        QFETCH(double, value);
        QFETCH(double, guard);
        Parameter parameter;
        parameter.value = value;
        parameter.limit = Limit{10.0, std::nullopt, {}};
        if (guard > 0)
            parameter.guardBand = guard;
        const auto scale = decisionScale(parameter);
        QVERIFY(scale);
        QFETCH(double, expected);
        QVERIFY(std::abs(scale->value - expected) < 1e-12);
        QTEST(scale->below || scale->above, "outside");
        QCOMPARE(scale->band, guard > 0);
    }

    void tabSeparatedIsWhatASpreadsheetReads() {
        Test test = decided();
        for (Run &run : measurement(test).runs) {
            for (auto &deviation : run.deviations)
                *deviation *= 1000; // thousands get a space when they are shown
        }
        const QString text =
            asTabSeparated(table(test, Language::Id::french), Language(Language::Id::french));
        const QStringList lines = text.split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 13);
        for (const QString &row : lines)
            QCOMPARE(row.count(u'\t'), 5);
        QVERIFY2(lines[1].startsWith(u"A\t"_s) && lines[1].contains(u"\t18000,0\t3,0\t25\t"_s),
                 qPrintable(lines[1]));
        QVERIFY2(lines[4].contains(u"\t13000,0\t\t\t"_s), qPrintable(lines[4])); // no dashes
    }

    void htmlHasATable() {
        const QString html = asHtml(table(decided()), Language(Language::Id::english));
        QCOMPARE(html.count(u"<tr>"_s), 13);
        QVERIFY(html.contains(u"<td align=\"right\">18.0</td>"_s));
    }

    /// Where no result of both directions stands above, the names say what they are of.
    void oneDirectionHasItsNoun() {
        int seen = 0;
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::positioning)
                continue;
            Test test = testdata::exactHand(edition->word);
            std::erase_if(measurement(test).runs,
                          [](const Run &run) { return run.approach == Direction::negative; });
            for (const ResultLine &line : table(test, Language::Id::french).lines) {
                ++seen;
                QVERIFY2(!line.name.startsWith(u"unidirection"_s), qPrintable(edition->word + line.id));
                if (line.id == u"A+"_s)
                    QCOMPARE(line.name, QString::fromUtf8(edition->word) == u"ISO 230-2:1988"_s
                                            ? u"précision unidirectionnelle"_s
                                            : u"exactitude unidirectionnelle"_s);
                if (line.id == u"R+"_s)
                    QCOMPARE(line.name, u"répétabilité unidirectionnelle"_s);
            }
        }
        QVERIFY(seen > 10);
        QCOMPARE(line(table(decided(), Language::Id::french), u"A+"_s).name, u"unidirectionnelle"_s);
    }

    void everyTermHasAShortName() {
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::positioning)
                continue;
            for (const ResultLine &line : table(testdata::exactHand(edition->word)).lines)
                QVERIFY2(line.name.size() <= 26, qPrintable(line.id + u' ' + line.name));
        }
    }
};

QTEST_APPLESS_MAIN(ResultTableTest)
#include "resulttable.moc"
