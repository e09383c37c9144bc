// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/explanations/explanation.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"
#include "report/tables/resulttable.h"

#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

EvaluatedDocument evaluatedDocument(const Test &test, const char *edition = "") {
    auto document = std::make_shared<Document>();
    document->tests.push_back(std::make_shared<const Test>(test));
    return evaluate(std::move(document), nullptr, edition);
}

Explanation explained(const Test &test, const char *id, Language::Id language = Language::Id::english) {
    const auto result = explanation(evaluatedDocument(test), 0, id, Language(language));
    return result ? *result : Explanation{};
}

QString steps(const Explanation &explanation) {
    QStringList lines;
    for (const Formula &step : explanation.steps)
        lines << step.plain();
    return lines.join(u'\n');
}

} // namespace

/// The value of a printed calculation; brackets are replaced from the inside outwards.
double comesTo(QString text) {
    static const QRegularExpression inner(R"((max|min)?\(([^()]*)\)|\|([^|()]*)\|)");
    for (auto match = inner.match(text); match.hasMatch(); match = inner.match(text)) {
        const QString kind = match.captured(1);
        double value = 0;
        if (match.capturedLength(3) > 0) {
            value = std::abs(comesTo(match.captured(3)));
        } else {
            std::vector<double> values;
            for (const QString &one : match.captured(2).split(u"; "_s))
                values.push_back(comesTo(one));
            value = kind == "max"_L1 ? std::ranges::max(values) : std::ranges::min(values);
        }
        QString shown = QString::number(value, 'f', 12);
        text.replace(match.capturedStart(), match.capturedLength(), shown.replace(u'-', u'−'));
    }
    const auto product = [](const QString &factors) {
        double result = 1;
        for (const QString &factor : factors.split(u'·')) {
            QStringList parts = QString(factor).replace(u'−', u'-').split(u'/');
            result *= parts.takeFirst().toDouble();
            for (const QString &divisor : parts)
                result /= divisor.toDouble();
        }
        return result;
    };
    double sum = 0;
    for (const QString &part : text.replace(u" − "_s, u" + -1·"_s).split(u" + "_s))
        sum += product(part);
    return sum;
}

/// 36 points a sense on R 100: +3 µm at 0° and 180°, −2 µm at ±90°, clockwise 1 µm less; hence G = 5 µm about
/// the programmed centre, exactly.
Test fourLobes(CorrectionTo20 correction = CorrectionTo20::appliedHere) {
    CircularMeasurement m;
    m.plane = {"X", "Y"};
    m.nominalRadius = 100;
    m.referenceLength.calibrated = true;
    for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
        const bool clockwise = sense == Sense::clockwise;
        Arc arc{sense, AngleReference::polar, {}, {}, {}, {}};
        for (int i = 0; i < 36; ++i) {
            arc.angles.push_back((clockwise ? -10.0 : 10.0) * i);
            arc.radialDeviations.push_back((i % 18 == 0   ? 3e-3
                                            : i % 18 == 9 ? -2e-3
                                                          : 0) -
                                           (clockwise ? 1e-3 : 0));
        }
        m.arcs.push_back(std::move(arc));
    }
    Conditions &conditions = m.conditions.common;
    conditions.sensors = {{SensorMeasures::machine, "", 21.0, 21.0, {}},
                          {SensorMeasures::instrument, "", 20.5, 20.5, {}}};
    conditions.expansion = {10.0, 2.0};
    conditions.correctionTo20 = correction;
    Test test;
    test.edition = "ISO 230-4:2005";
    test.measurement = std::move(m);
    return test;
}

/// Formula, numbers put in and clauses of the parameters.
class ExplanationTest : public QObject {
    Q_OBJECT

private slots:
    void exactHand_data() {
        QTest::addColumn<QByteArray>("edition");
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("formula");
        QTest::addColumn<QString>("expected");
        const QByteArray iso("ISO 230-2:2006");
        const QByteArray vdi("VDI/DGQ 3441:1977");
        const auto row = [](const char *name, const QByteArray &edition, const char *id,
                            const QString &formula, const QString &expected) {
            QTest::newRow(name) << edition << QByteArray(id) << formula << expected;
        };
        row("accuracy: first of equal ends", iso, "A",
            u"A = max(x̄i↑ + 2si↑; x̄i↓ + 2si↓) − min(x̄i↑ − 2si↑; x̄i↓ − 2si↓)"_s,
            u"A = (x̄2↑ + 2s2↑) − (x̄5↓ − 2s5↓)\n= (4.00 + 2·2.00) − (−6.00 − 2·2.00)\n"
            u"= 8.00 − (−10.00) = 18.0\u00a0µm"_s);
        row("accuracy upwards", iso, "A+", u"A↑ = max(x̄i↑ + 2si↑) − min(x̄i↑ − 2si↑)"_s,
            u"A↑ = (x̄2↑ + 2s2↑) − (x̄3↑ − 2s3↑)\n= (4.00 + 2·2.00) − (−3.00 − 2·1.00)\n"
            u"= 8.00 − (−5.00) = 13.0\u00a0µm"_s);
        row("systematic deviation", iso, "E", u"E = max(x̄i↑; x̄i↓) − min(x̄i↑; x̄i↓)"_s,
            u"E = x̄4↑ − x̄5↓ = 7.00 − (−6.00) = 13.0\u00a0µm"_s);
        row("range of the means", iso, "M", u"M = max x̄i − min x̄i; x̄i = (x̄i↑ + x̄i↓)/2"_s,
            u"M = x̄4 − x̄5 = 5.50 − (−2.00) = 7.5\u00a0µm"_s);
        row("repeatability", iso, "R", u"R = max Ri; Ri = max(2si↑ + 2si↓ + |Bi|; 4si↑; 4si↓)"_s,
            u"R5 = max(2·1.00 + 2·2.00 + |8.00|; 4·1.00; 4·2.00)\n= max(14.0; 4.0; 8.0) = 14.0\u00a0µm"_s);
        row("repeatability upwards", iso, "R+", u"R↑ = max Ri↑; Ri↑ = 4si↑"_s,
            u"R↑ = R2↑ = 4·2.00 = 8.0\u00a0µm"_s);
        row("reversal value", iso, "B", u"B = max |Bi|; Bi = x̄i↑ − x̄i↓"_s,
            u"B = |B5| = |2.00 − (−6.00)| = 8.0\u00a0µm"_s);
        row("mean reversal value", iso, "Bmean", u"B̄ = Σ Bi / m; Bi = x̄i↑ − x̄i↓"_s,
            u"B̄ = 10.00 / 5 = 2.0\u00a0µm"_s);
        row("smaller repeatability", "ISO 230-2:2014", "UPR",
            u"UPR = min(R↑; R↓); R↑ = max Ri↑; R↓ = max Ri↓"_s, u"UPR = min(8.0; 12.0) = 8.0\u00a0µm"_s);
        row("mean repeatability", "ISO 230-2:1988", "r",
            u"r̄ = Σ Rj / m; Rj = max(3sj↑ + 3sj↓ + |Bj|; 6sj↑; 6sj↓)"_s, u"r̄ = 61.00 / 5 = 12.2\u00a0µm"_s);
        row("positional uncertainty", vdi, "P", u"P = max(x̄i + (Ui + Psi)/2) − min(x̄i − (Ui + Psi)/2)"_s,
            u"P = (3.50 + (1.00 + 9.00)/2) − (−2.00 − (8.00 + 9.00)/2)\n= 8.50 − (−10.50) = 19.0\u00a0µm"_s);
        row("positional scatter", vdi, "Psmax", u"Psmax = max Psi; Psi = 3(si↑ + si↓)"_s,
            u"Psmax = 3·(1.00 + 3.00) = 12.0\u00a0µm"_s);
        row("mean reversal range", vdi, "Umean", u"Ū = Σ Ui / m; Ui = |x̄i↑ − x̄i↓|"_s,
            u"Ū = 18.00 / 5 = 3.6\u00a0µm"_s);
    }
    void exactHand() {
        QFETCH(QByteArray, edition);
        QFETCH(QByteArray, id);
        const Explanation explanation = explained(testdata::exactHand(edition), id);
        QTEST(explanation.formula.plain(), "formula");
        QTEST(steps(explanation), "expected");
    }

    void workedExampleInFrench() {
        const Explanation r = explained(example1988("ISO 230-2:1988"), "R", Language::Id::french);
        QCOMPARE(steps(r), u"R11 = max(3·1,85 + 3·1,39 + |−3,78|\u202f; 6·1,85\u202f; 6·1,39)\n"
                           u"= max(13,5\u202f; 11,1\u202f; 8,3) = 13,5\u00a0µm"_s);
        QCOMPARE(r.result, u"R = 13,5\u00a0µm"_s);
        QCOMPARE(r.ruling, (std::vector<Ruling>{{11, std::nullopt}}));
        const Explanation up = explained(example1988("ISO 230-2:1988"), "R+", Language::Id::french);
        QCOMPARE(steps(up), u"R↑ = R10↑ = 6·1,97 = 11,8\u00a0µm"_s);
        const Explanation mean = explained(example1988("ISO 230-2:1988"), "Bmean", Language::Id::french);
        QVERIFY2(steps(mean).endsWith(u"= −1,5\u00a0µm"_s), qPrintable(steps(mean)));
    }

    /// Value, U and limit, of whatever size and however near, read alike in explanation, window, command line
    /// and report.
    void theResultReadsAsInTheTables() {
        std::mt19937_64 random(230);
        std::uniform_real_distribution<double> uniform(0, 1);
        const auto all = editions();
        int longer = 0;
        for (int trial = 0; trial < 120; ++trial) {
            const Edition *edition = all[random() % all.size()];
            const bool circle = edition->kind == Kind::circular;
            Test test = circle ? fourLobes() : testdata::exactHand(edition->word);
            test.edition = edition->word;
            test.decisionRule = {random() % 2 ? Rule::iso14253_1 : Rule::simpleAcceptance,
                                 random() % 2 ? 1.0 : 0.83};
            const double scale = std::pow(10, 3 * uniform(random) - 1.5);
            if (circle) {
                for (Arc &arc : std::get<CircularMeasurement>(test.measurement).arcs)
                    for (double &deviation : arc.radialDeviations)
                        deviation *= scale;
            } else {
                for (Run &run : measurement(test).runs)
                    for (auto &deviation : run.deviations)
                        deviation = *deviation * scale;
            }
            const auto expandedOf = [&](Test &changed) -> ExpandedUncertainties & {
                return std::visit(
                    [](auto &m) -> ExpandedUncertainties & {
                        if constexpr (requires { m.uncertainty.expanded; }) {
                            m.uncertainty.method = UncertaintyMethod::direct;
                            return m.uncertainty.expanded;
                        }
                        qFatal("a drift test");
                    },
                    changed.measurement);
            };
            const auto unchanged = evaluatedDocument(test);
            for (const Parameter &parameter : unchanged.tests[0]->parameters) {
                if (!parameter.value)
                    continue;
                const double size = std::abs(*parameter.value);
                const double near = size * (1 + (uniform(random) - 0.5) * std::pow(10, -5 * uniform(random)));
                if (random() % 2)
                    test.limits[parameter.term.id] = {near, std::nullopt, {}};
                if (random() % 2) // µm or arc seconds
                    expandedOf(test)[parameter.term.id] = 1000 * size * std::pow(10, -4 * uniform(random));
            }
            const Language language(random() % 2 ? Language::Id::french : Language::Id::english);
            const EvaluatedDocument evaluated = evaluatedDocument(test);
            const ResultTable window = resultTable(evaluated, 0, language);
            const QString cli = plainText(composeResults(evaluated, language));
            const QString report = plainText(composeReport(evaluated, language, {}));
            for (const ResultLine &line : window.lines) {
                const auto shown = explanation(evaluated, 0, line.id.toStdString(), language);
                QVERIFY2(shown, qPrintable(line.id));
                const bool has = line.cell("value") != u"–";
                QCOMPARE(shown->result.isEmpty(), !has);
                if (!has)
                    continue;
                const QString printed = u"= "_s + line.cell("value") + u'\u00a0' + window.unit;
                QVERIFY2(shown->result.endsWith(printed), qPrintable(shown->result + u" – "_s + printed));
                QVERIFY2(shown->steps.back().plain().endsWith(printed), qPrintable(steps(*shown)));
                longer += line.cell("value")
                              .section(language.id() == Language::Id::french ? u',' : u'.', 1)
                              .size() > 2;
                for (const QString &text : {cli, report}) {
                    const QStringList lines = text.split(u'\n');
                    const auto row = std::ranges::find_if(lines, [&](const QString &one) {
                        return one.startsWith(line.symbol.plain() + u"  "_s) &&
                               one.contains(line.cell("value"));
                    });
                    QVERIFY2(row != lines.end(),
                             qPrintable(line.symbol.plain() + u' ' + line.cell("value") + text));
                    QVERIFY2(line.cell("expandedUncertainty") == u"–" ||
                                 row->contains(line.cell("expandedUncertainty")),
                             qPrintable(*row));
                }
            }
        }
        QVERIFY(longer > 50); // digits that are owed
    }

    void numbersKnowTheirDirection() {
        const Explanation explanation = explained(testdata::exactHand("ISO 230-2:2006"), "R");
        int up = 0;
        int down = 0;
        for (const FormulaSpan &span : explanation.steps.at(0).spans) {
            up += span.approach == Direction::positive ? 1 : 0;
            down += span.approach == Direction::negative ? 1 : 0;
        }
        QCOMPARE(up, 2); // s↑ in the sum and alone
        QCOMPARE(down, 2);
    }

    void clauses_data() {
        QTest::addColumn<QByteArray>("edition");
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("expected");
        QTest::newRow("with those of the quantities it rests on")
            << QByteArray("ISO 230-2:2006") << QByteArray("R") << u"ISO 230-2:2006, clauses 2.17 and 2.19"_s;
        QTest::newRow("in the order of the standard, not of the alphabet")
            << QByteArray("ISO 230-2:2006") << QByteArray("A")
            << u"ISO 230-2:2006, clauses 2.10, 2.15 and 2.24"_s;
        QTest::newRow("1988") << QByteArray("ISO 230-2:1988") << QByteArray("Bmean")
                              << u"ISO 230-2:1988, clauses 2.7 and 6.3"_s;
        QTest::newRow("none are known: none are invented")
            << QByteArray("ISO 230-2:1997") << QByteArray("R") << u"ISO 230-2:1997"_s;
    }
    void clauses() {
        QFETCH(QByteArray, edition);
        QFETCH(QByteArray, id);
        QTEST(explained(testdata::exactHand(edition), id).source, "expected");
    }

    void everyParameterOfEveryEditionIsExplained() {
        int count = 0;
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::positioning)
                continue;
            const EvaluatedDocument evaluated = evaluatedDocument(testdata::exactHand(edition->word));
            for (const Parameter &parameter : evaluated.tests[0]->parameters) {
                const auto shown =
                    explanation(evaluated, 0, parameterId(parameter), Language(Language::Id::french));
                const QByteArray where = QByteArray(edition->word) + ' ' + parameter.term.id;
                QVERIFY2(shown, where);
                QVERIFY2(!shown->formula.spans.empty() && !shown->steps.empty() && !shown->words.isEmpty(),
                         where);
                QVERIFY2(!steps(*shown).contains(u'%') && !steps(*shown).contains(u'–') &&
                             !steps(*shown).contains(u'['),
                         where + ": " + steps(*shown).toUtf8());
                const QString result =
                    Language(Language::Id::french).quantity(*parameter.value, parameter.term.quantity, 1);
                QVERIFY2(steps(*shown).endsWith(QStringLiteral("= ") + result),
                         where + steps(*shown).toUtf8());
                ++count;
            }
        }
        QVERIFY(count >= 100);
    }

    /// A reader who does the printed sum gets the printed result.
    void printedSumsHold() {
        std::mt19937 random(11);
        std::normal_distribution<double> noise;
        static const QRegularExpression word("\\p{L}");
        int sums = 0;
        for (int round = 0; round < 40; ++round) {
            for (const Edition *edition : editions()) {
                if (edition->kind != Kind::positioning)
                    continue;
                const double scale = std::pow(10.0, round % 5 - 2);
                std::vector<std::vector<double>> runs[2];
                for (int run = 0; run < 10; ++run) {
                    std::vector<double> &readings = runs[run % 2].emplace_back();
                    for (int i = 0; i < 6; ++i)
                        readings.push_back(scale * (noise(random) + (run % 2) + i % 3));
                }
                const EvaluatedDocument evaluated = evaluatedDocument(
                    positioningTest(edition->word, {0, 100, 210, 290, 400, 500}, runs[0], runs[1]));
                for (const Parameter &parameter : evaluated.tests[0]->parameters) {
                    const auto shown =
                        explanation(evaluated, 0, parameterId(parameter), Language(Language::Id::english));
                    QStringList sides = steps(*shown).replace(u'\n', u' ').split(u" = "_s);
                    for (QString &side : sides)
                        side = side.section(u'\u00a0', 0, 0).remove(u"= "_s).remove(u'\u202f');
                    for (qsizetype i = 1; i < sides.size(); ++i) {
                        if (QString(sides[i - 1]).remove("max"_L1).remove("min"_L1).contains(word))
                            continue;
                        const auto decimals = sides[i].section(u'.', -1).count(QRegularExpression("[0-9]"));
                        // Each of its numbers is rounded.
                        const auto numbers = static_cast<double>(sides[i].count(u'.'));
                        const double half =
                            (0.5 + 1e-6) * numbers * std::pow(10.0, -static_cast<double>(decimals));
                        QVERIFY2(std::abs(comesTo(sides[i - 1]) - comesTo(sides[i])) <= half,
                                 qPrintable(steps(*shown)));
                        ++sums;
                    }
                }
            }
        }
        QVERIFY(sums > 4000);
    }

    void barsShowTheTargetThatRules() {
        const Explanation r = explained(testdata::exactHand("ISO 230-2:2006"), "R");
        QVERIFY(r.bars);
        QCOMPARE(r.bars->ruling, std::size_t{4});
        QCOMPARE(r.bars->labels, (std::vector<QString>{u"6.0"_s, u"8.0"_s, u"12.0"_s, u"5.0"_s, u"14.0"_s}));
        QVERIFY(!explained(testdata::exactHand("ISO 230-2:2006"), "A").bars);
    }

    void ofAMissingValueTheWordsSayWhy() {
        Test test = testdata::exactHand("ISO 230-2:2006");
        for (Run &run : measurement(test).runs) {
            if (run.approach == Direction::negative)
                run.deviations[1].reset();
        }
        const Explanation shown = explained(test, "R");
        QVERIFY(shown.steps.empty());
        QVERIFY(shown.result.isEmpty());
        QVERIFY2(shown.words.join(u' ').contains(u"2↓"_s), qPrintable(shown.words.join(u' ')));
    }

    void circles_data() {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("formula");
        QTest::addColumn<QString>("expected");
        QTest::addColumn<QString>("source");
        const auto row = [](const char *name, const char *id, const QString &formula, const QString &expected,
                            const char *clause) {
            QTest::newRow(name) << QByteArray(id) << formula << expected
                                << u"ISO 230-4:2005, clause "_s + QString::fromUtf8(clause);
        };
        // C = 100·[2·0.5 − 10·1]/1000 µm
        const QString c =
            u"C = R·[αi·(Ti − 20) − αm·(Tm − 20)] = 100·[2·(20.5 − 20) − 10·(21 − 20)]/1000 = "_s
            u"−0.90\u00a0µm\n"_s;
        row("of a path", "G_XY", u"GXY = max r − min r"_s,
            u"GXY = (max r − R) − (min r − R) = 3.00 − (−2.00) = 5.0\u00a0µm"_s, "3.4");
        row("of the pair", "G(b)_XY", u"G(b)XY = max r − min r"_s,
            u"G(b)XY = (max r − R) − (min r − R) = 3.00 − (−3.00) = 6.0\u00a0µm"_s, "3.3");
        row("Fmax", "Fmax_XY", u"Fmax,XY = max r − R + C"_s,
            c + u"Fmax,XY = (max r − R) + C = 3.00 + (−0.90) = 2.1\u00a0µm"_s, "3.5");
        row("Fmin", "Fmin_YX", u"Fmin,YX = min r − R + C"_s,
            c + u"Fmin,YX = (min r − R) + C = −3.00 + (−0.90) = −3.9\u00a0µm"_s, "3.5");
        // both mean deviations: 2·(3 − 2)/36 and the same − 1
        row("D", "D_XY", u"DXY = RLSC − R + C"_s,
            c + u"DXY = (RLSC − R) + C = −0.44 + (−0.90) = −1.3\u00a0µm"_s, "3.6");
    }
    void circles() {
        QFETCH(QByteArray, id);
        const Explanation explanation = explained(fourLobes(), id);
        QTEST(explanation.formula.plain(), "formula");
        QTEST(steps(explanation), "expected");
        QTEST(explanation.source, "source");
        QVERIFY(explanation.ruling.empty() && !explanation.bars);
    }

    void pointsThatRuleACircle() {
        const Explanation path = explained(fourLobes(), "G_XY");
        QStringList places;
        for (const RulingPoint &point : path.points)
            places
                << QStringLiteral("%1 %2 %3").arg(point.path).arg(std::round(point.angle)).arg(point.outer);
        places.sort();
        QCOMPARE(places.join(u", "_s).replace(u"-180"_s, u"180"_s), u"XY -90 0, XY 0 1, XY 180 1, XY 90 0"_s);
        QVERIFY2(path.words.contains(u"Proven: no narrower pair of circles holds all points."_s),
                 qPrintable(path.words.join(u'\n')));
        // Only the largest deviation rules Fmax, only the smallest Fmin.
        for (const RulingPoint &point : explained(fourLobes(), "Fmax_XY").points)
            QVERIFY(point.outer);
        for (const RulingPoint &point : explained(fourLobes(), "Fmin_XY").points)
            QVERIFY(!point.outer);
        QVERIFY(explained(fourLobes(), "D_XY").points.empty());
    }

    void circlesInFrench() {
        const Explanation g = explained(fourLobes(), "G_XY", Language::Id::french);
        QCOMPARE(steps(g), u"GXY = (max r − R) − (min r − R) = 3,00 − (−2,00) = 5,0\u00a0µm"_s);
        QCOMPARE(g.result, u"GXY = 5,0\u00a0µm"_s);
        QVERIFY(g.words.join(u' ').contains(u"zone minimale"_s));
    }

    void meansOfTemperaturesAreShort() {
        Test test = fourLobes();
        // (20.6 + 20.8)/2 is 20.700000000000003 as a double.
        auto &sensors = std::get<CircularMeasurement>(test.measurement).conditions.common.sensors;
        sensors[0].start = 20.6;
        sensors[0].end = 20.8;
        const QString shown = steps(explained(test, "D_XY"));
        QVERIFY2(shown.contains(u"10·(20.7 − 20)]"_s), qPrintable(shown));
    }

    void withoutCorrectionThereIsNone() {
        const Explanation d = explained(fourLobes(CorrectionTo20::notApplied), "D_XY");
        QCOMPARE(steps(d), u"DXY = (RLSC − R) = −0.4\u00a0µm"_s);
        QVERIFY(d.words.contains(u"Not corrected to 20 °C."_s));
    }

    void everyResultOfACircleIsExplained() {
        int count = 0;
        for (const Edition *edition : editions()) {
            if (edition->kind != Kind::circular)
                continue;
            for (const SignalSource source : {SignalSource::external, SignalSource::feedback}) {
                Test test = fourLobes();
                test.edition = edition->word;
                std::get<CircularMeasurement>(test.measurement).source = source;
                const EvaluatedDocument evaluated = evaluatedDocument(test);
                for (const Parameter &parameter : evaluated.tests[0]->parameters) {
                    const auto shown =
                        explanation(evaluated, 0, parameterId(parameter), Language(Language::Id::french));
                    const QByteArray where = QByteArray(edition->word) + ' ' + parameter.term.id;
                    QVERIFY2(shown && !shown->steps.empty() && !shown->words.isEmpty(), where);
                    QVERIFY2(!steps(*shown).contains(u'%') && !steps(*shown).contains(u'{'), where);
                    ++count;
                }
            }
        }
        QCOMPARE(count, 8 + 3 + 8 + 3 + 7);
    }

    void ofACircleWithoutValueTheWordsSayWhy() {
        Test test = fourLobes();
        std::get<CircularMeasurement>(test.measurement).referenceLength.calibrated = false;
        const Explanation d = explained(test, "D_XY");
        QVERIFY(d.steps.empty() && d.result.isEmpty());
        QVERIFY2(d.words.join(u' ').contains(u"not calibrated"_s), qPrintable(d.words.join(u' ')));
    }

    void nothingToExplain() {
        const EvaluatedDocument evaluated = evaluatedDocument(testdata::exactHand("ISO 230-2:1988"));
        QVERIFY(!explanation(evaluated, 0, "E", Language(Language::Id::english))); // not of this edition
        QVERIFY(!explanation(evaluated, 0, "", Language(Language::Id::english)));
        QVERIFY(!explanation(evaluated, 1, "A", Language(Language::Id::english)));
    }
};

QTEST_APPLESS_MAIN(ExplanationTest)
#include "explanation.moc"
