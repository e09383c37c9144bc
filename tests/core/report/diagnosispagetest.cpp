// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/madecircles.h"
#include "report/blocks/pagetext.h"
#include "report/composereport.h"
#include "report/tables/diagnosisrows.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;

namespace {

Report composed(const Document &document, Language::Id id) {
    return composeReport(evaluate(std::make_shared<const Document>(document)), Language(id), {});
}

/// The headings and tables of the page, from its own heading on; empty: it is not there.
std::vector<Block> pageOf(const Report &report) {
    std::vector<Block> page;
    for (const Block &block : report.blocks) {
        const auto *heading = std::get_if<Heading>(&block);
        const bool begins = heading && heading->level == 1 &&
                            (heading->text.startsWith("Diagnosis") || heading->text.startsWith("Diagnostic"));
        if (begins || !page.empty())
            page.push_back(block);
    }
    return page;
}

Document circleFile(const CircularSynthesis &asked, bool diagnosis) {
    Document document = *madeCircles({asked});
    if (diagnosis)
        document.report.include.push_back(ReportExtra::diagnosis);
    return document;
}

const Table *sourcesTable(const std::vector<Block> &page) {
    for (const Block &block : page) {
        if (const auto *table = std::get_if<Table>(&block); table && table->columns.size() == 8)
            return table;
    }
    return nullptr;
}

} // namespace

/// The page of a report that says what the circle says about the machine.
class DiagnosisPageTest : public QObject {
    Q_OBJECT

private slots:
    void standsOnRequestOnly() {
        QVERIFY(pageOf(composed(circleFile(mixedCircle(), false), Language::Id::english)).empty());
        const auto page = pageOf(composed(circleFile(mixedCircle(), true), Language::Id::english));
        QVERIFY(!page.empty());
        QCOMPARE(std::get<Heading>(page[0]).text, QString("Diagnosis of the circle (interpretation)"));
        QCOMPARE(std::get<Heading>(page[0]).note.plain(), QString("not a result of ISO 230-4"));
        QVERIFY(std::get<Paragraph>(page[1]).text.contains("no part of the verdict"));
    }

    /// What a further circle says is not what the first said, and is headed as interpretation, too.
    void everyCircleHasItsHeading_data() {
        QTest::addColumn<Language::Id>("language");
        QTest::newRow("English") << Language::Id::english;
        QTest::newRow("French") << Language::Id::french;
    }
    void everyCircleHasItsHeading() {
        QFETCH(Language::Id, language);
        constexpr int circles = 3;
        std::vector<CircularSynthesis> asked(circles, mixedCircle());
        for (std::size_t i = 0; i < asked.size(); ++i)
            asked[i].radius += 10.0 * double(i); // circles of a plane, but not one circle at several feeds
        Document document = *madeCircles(asked);
        document.report.include.push_back(ReportExtra::diagnosis);
        const Report report = composed(document, language);
        int headings = 0;
        for (std::size_t i = 0; i < report.blocks.size(); ++i) {
            const auto *heading = std::get_if<Heading>(&report.blocks[i]);
            if (!heading || heading->level != 1 || !heading->text.contains("interpr"))
                continue;
            ++headings;
            QVERIFY(heading->note.plain().contains("ISO 230-4"));
            QVERIFY(std::holds_alternative<Paragraph>(report.blocks[i + 1]));
        }
        QCOMPARE(headings, circles);
    }

    void beginsAPageBehindTheTest() {
        const Report report = composed(circleFile(mixedCircle(), true), Language::Id::french);
        const auto page = pageOf(report);
        const std::size_t at = report.blocks.size() - page.size();
        QVERIFY(std::holds_alternative<PageBreak>(report.blocks[at - 1]));
        QCOMPARE(std::get<Heading>(page[0]).text, QString("Diagnostic du cercle (interprétation)"));
    }

    void ranksSourcesWithTheirNumbers() {
        const auto page = pageOf(composed(circleFile(mixedCircle(), true), Language::Id::english));
        const Table *table = sourcesTable(page);
        QVERIFY(table);
        const auto text = [&](std::size_t row, std::size_t column) {
            return table->rows[row][column].text.plain();
        };
        QCOMPARE(text(0, 1), QString("Scale mismatch X–Y"));
        QVERIFY(std::abs(text(0, 2).toDouble() - 60) < 0.5);
        QCOMPARE(text(0, 4), QString("µm/m"));
        QCOMPARE(text(0, 5), QString("9.0")); // 60 µm/m of 150 mm
        QCOMPARE(text(1, 1), QString("Servo mismatch X–Y"));
        QCOMPARE(text(2, 1), QString("Backlash X"));
        QVERIFY(text(0, 7).startsWith("X travels farther than Y"));
        QVERIFY(text(0, 7).contains("Compare the scales"));
        // 9 µm stands on a scale of 10 µm; those that are traced are full and come first.
        QVERIFY(std::abs(*table->rows[0][6].extras->bar - 0.9 * 18 / 18.5) < 0.01);
        QVERIFY(!table->rows[0][6].extras->hollow && table->rows[0][1].bold);
        const auto isHollow = [](const std::vector<Cell> &row) { return row[6].extras->hollow; };
        QVERIFY(isHollow(table->rows.back()));
        QVERIFY(std::ranges::is_sorted(table->rows, {}, isHollow));
        for (const auto &row : table->rows)
            QVERIFY(!row[1].text.plain().contains("Radius") && !row[1].text.plain().contains("Centre"));
    }

    void widthsAreThoseOfTheZones() {
        const Document document = circleFile(mixedCircle(), true);
        const auto page = pageOf(composed(document, Language::Id::english));
        const auto both = std::ranges::find_if(
            page, [](const Block &block) { return std::holds_alternative<SideBySide>(block); });
        QVERIFY(both != page.end());
        QString words;
        for (const Part &part : std::get<SideBySide>(*both).right) {
            if (const auto *values = std::get_if<KeyValues>(&part)) {
                for (const KeyValue &row : values->rows)
                    words += row.key + '=' + row.value + '\n';
            }
        }
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        const double zone = std::get<CircularResults>(evaluated.tests[0]->results)
                                .circle(CircleOf::both, ReferenceCircle::minimumZone)
                                ->width;
        const QString number = Language(Language::Id::english).quantity(zone, Quantity::deviation, 1);
        QVERIFY2(words.contains("G(b), measured=" + number), qPrintable(words));
        QVERIFY(words.contains("Fitted radius=+30.0"));
        QVERIFY(words.contains("Points=2 × 360"));
        QVERIFY(words.contains("Told apart=12 of 12"));
    }

    void whatIsNotToldSaysWhy() {
        CircularSynthesis asked = mixedCircle();
        asked.senses = {Sense::counterclockwise};
        const auto page = pageOf(composed(circleFile(asked, true), Language::Id::english));
        const Table *table = sourcesTable(page);
        QVERIFY(table);
        int sums = 0;
        int notTold = 0;
        for (const auto &row : table->rows) {
            const QString name = row[1].text.plain();
            if (row[7].text.plain().startsWith("These arcs tell the sum alone")) {
                ++sums;
                QVERIFY(name.contains(" + ") || name.contains(" − "));
                QVERIFY(!row[2].isMissing());
            }
            if (row[7].text.plain().startsWith("These arcs do not tell it from: ")) {
                ++notTold;
                QVERIFY(row[2].isMissing() && row[1].pale);
            }
        }
        QVERIFY(sums >= 1);
        QVERIFY(notTold >= 2);
        // Nor are they counted as told.
        QString fit;
        for (const Block &block : page) {
            if (const auto *both = std::get_if<SideBySide>(&block)) {
                for (const Part &part : both->right) {
                    if (const auto *values = std::get_if<KeyValues>(&part)) {
                        for (const KeyValue &row : values->rows)
                            fit += row.key + '=' + row.value + '\n';
                    }
                }
            }
        }
        const int told = int(table->rows.size()) - sums - notTold;
        QVERIFY2(fit.contains(QString("Told apart=%1 of 12").arg(told + 2)), qPrintable(fit)); // and a centre
    }

    void severalFeedsHaveAPageOfTheirOwn() {
        Document document = *madeCircles(threeFeeds());
        document.report.include.push_back(ReportExtra::diagnosis);
        const auto pagesOf = [](const Report &report, const QString &begin) {
            std::vector<std::size_t> places;
            for (std::size_t i = 0; i < report.blocks.size(); ++i) {
                const auto *heading = std::get_if<Heading>(&report.blocks[i]);
                if (heading && heading->level == 1 && heading->text.startsWith(begin))
                    places.push_back(i);
            }
            return places;
        };
        const Report report = composed(document, Language::Id::english);
        const auto places = pagesOf(report, "Diagnosis of plane XY at several feeds (interpretation)");
        QCOMPARE(places.size(), std::size_t(1));
        QVERIFY(places[0] > pagesOf(report, "Diagnosis of the circle").back()); // behind the last of them
        QVERIFY(std::holds_alternative<PageBreak>(report.blocks[places[0] - 1]));
        QCOMPARE(std::get<Heading>(report.blocks[places[0]]).note.plain(),
                 QString("not a result of ISO 230-4"));
        const std::vector<Block> page(report.blocks.begin() + std::ptrdiff_t(places[0]), report.blocks.end());
        const Table *table = sourcesTable(page);
        QVERIFY(table);
        // What a single circle cannot tell: the lag apart from the radius.
        double lag = 0;
        double radius = 0;
        for (const auto &row : table->rows) {
            if (row[1].text.plain() == "Common lag X–Y")
                lag = row[2].text.plain().toDouble();
            if (row[1].text.plain().startsWith("Radius"))
                radius = QString(row[2].text.plain()).remove('+').toDouble();
        }
        QVERIFY2(std::abs(lag - 20) < 0.5, qPrintable(QString::number(lag))); // ms
        QVERIFY2(std::abs(radius - 30) < 0.5, qPrintable(QString::number(radius)));
        const auto *over =
            std::get_if<SideBySide>(&*std::find_if(page.begin() + 2, page.end(), [](const Block &block) {
                return std::holds_alternative<SideBySide>(block);
            }));
        QVERIFY(over && !over->left.empty() && !over->right.empty());
        // What weighs most, over the feed.
        const auto *curves =
            std::get_if<SideBySide>(&*std::find_if(page.begin() + 2, page.end(), [](const Block &block) {
                const auto *both = std::get_if<SideBySide>(&block);
                const auto *heading =
                    both && !both->left.empty() ? std::get_if<Heading>(&both->left.front()) : nullptr;
                return heading && heading->note.plain() == "each circle by itself, with its 95 % interval";
            }));
        QVERIFY(curves && curves->left.size() == 2 && curves->right.size() == 2);
        QVERIFY(std::get<Heading>(curves->left.front()).text !=
                std::get<Heading>(curves->right.front()).text);
        const QString french = pageText(composed(document, Language::Id::french));
        QVERIFY(french.contains("Diagnostic du plan XY à plusieurs avances (interprétation)"));
        // Of one feed there is none.
        Document one = circleFile(mixedCircle(), true);
        QVERIFY(pagesOf(composed(one, Language::Id::english), "Diagnosis of plane").empty());
        document.report.include.clear();
        QVERIFY(pagesOf(composed(document, Language::Id::english), "Diagnosis").empty());
    }

    void tooFewPointsAreSaid() {
        CircularSynthesis asked = mixedCircle();
        asked.points = 8;
        const auto page = pageOf(composed(circleFile(asked, true), Language::Id::english));
        QVERIFY(std::get<Paragraph>(page[2]).text.contains("too few"));
    }

    void bothLanguagesAreWhole() {
        const QString french = [&] {
            Report report = composed(circleFile(mixedCircle(), true), Language::Id::french);
            report.blocks = pageOf(report);
            return pageText(report);
        }();
        QVERIFY2(french.contains("Différence d’échelle X–Y"), qPrintable(french));
        for (const char *english : {"Fit", "What", "Rest", "measured", "alone", "bars"})
            QVERIFY2(!french.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(english))), english);
    }

    void theInstrumentStandsBesideOurs() {
        Document document = circleFile(mixedCircle(), true);
        palmer::Test test = *document.tests[0];
        ImportedFile file;
        file.fileName = "bar.b5r";
        file.results = {{"Renishaw: AF_SQUARENESS", -12.5, "µm/m"},
                        {"Renishaw: AF_SCALE_MISMATCH", 61, "µm/m"},
                        {"AF_BACKLASH_X", 4.1, "µm"},
                        {"AF_BACKLASH_Z", 4.1, "µm"}, // no axis of this plane
                        {"AF_CIRCULARITY", 8.4, "µm"}};
        test.imports = {file};
        document.tests[0] = std::make_shared<const palmer::Test>(test);
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        const Language language(Language::Id::english);
        const auto stated = statedSources(test, diagnosedTest(evaluated, 0)->diagnosis, language);
        QCOMPARE(stated.size(), std::size_t(3));
        QCOMPARE(stated[0].stated, QString("−12.5"));
        QCOMPARE(stated[0].source, QString("Squareness X–Y"));
        QCOMPARE(stated[0].positive, QString("The angle from +X to +Y is larger than 90°."));
        QVERIFY(std::abs(stated[1].here.toDouble() - 60) < 0.5);
        QCOMPARE(stated[2].source, QString("Backlash X"));
        QVERIFY(pageText(composed(document, Language::Id::english)).contains("states no sign convention"));
        document.tests[0] = madeCircles({mixedCircle()})->tests[0];
        QVERIFY(!pageText(composed(document, Language::Id::english)).contains("states no sign convention"));
    }

    /// An uncertainty that rounds to nothing is said to be below the last digit; a width has one decimal.
    void numbersAreThoseOfTheUncertainty() {
        const EvaluatedDocument evaluated = evaluate(madeCircles({mixedCircle()}));
        Diagnosis diagnosis = diagnosedTest(evaluated, 0)->diagnosis;
        const auto rowOf = [&](std::size_t source) {
            const auto rows = diagnosisRows(diagnosis, Language(Language::Id::english));
            return *std::ranges::find_if(
                rows, [&](const DiagnosisRow &row) { return row.sources == std::vector{source}; });
        };
        const auto known = std::ranges::find_if(diagnosis.sources, [](const SourceEstimate &source) {
            return source.id == InfluenceId::backlash && source.value && source.u;
        });
        QVERIFY(known != diagnosis.sources.end());
        const auto source = static_cast<std::size_t>(known - diagnosis.sources.begin());
        QVERIFY2(!rowOf(source).expanded.contains('<') && rowOf(source).expanded.toDouble() > 0,
                 qPrintable(rowOf(source).expanded));
        known->u = 1e-15;
        QVERIFY2(rowOf(source).expanded.startsWith("<\u00A0"), qPrintable(rowOf(source).expanded));
        QVERIFY(rowOf(source).expanded.mid(2).toDouble() > 0);
        known->width = 1.25;
        known->pitch = 10;
        QVERIFY2(rowOf(source).name.endsWith(", 10\u00A0mm, 1.3°") ||
                     rowOf(source).name.endsWith(", 10\u00A0mm, 1.2°"),
                 qPrintable(rowOf(source).name));
    }

    void rowsHoldEachSourceOnce() {
        const EvaluatedDocument evaluated = evaluate(madeCircles({mixedCircle()}));
        const Diagnosis diagnosis = diagnosedTest(evaluated, 0)->diagnosis;
        const auto rows = diagnosisRows(diagnosis, Language(Language::Id::english));
        std::vector<int> times(diagnosis.sources.size());
        for (const DiagnosisRow &row : rows) {
            QCOMPARE(row.sources.size(), std::size_t(1));
            ++times[row.sources.front()];
            QVERIFY(!row.name.isEmpty() && !row.meaning.isEmpty());
        }
        QVERIFY(std::ranges::all_of(times, [](int n) { return n == 1; }));
        QCOMPARE(int(rows.back().kind), int(DiagnosisRowKind::fitCircle));
        // What is not seen needs no advice.
        for (const DiagnosisRow &row : rows) {
            if (row.meaning.startsWith("Not seen"))
                QVERIFY(row.advice.isEmpty());
        }
    }
};

QTEST_APPLESS_MAIN(DiagnosisPageTest)
#include "diagnosispagetest.moc"
