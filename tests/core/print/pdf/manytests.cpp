// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/pdf/generator.h"
#include "print/figures/style.h"
#include "print/pdf/textblock.h"
#include "report/blocks/pagetext.h"

#include <QXmlStreamReader>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

namespace {

const QStringList examples{
    u"iso230-2-1988-example"_s,   u"long-axis-with-zone"_s, // two tests
    u"one-direction"_s,           u"rotary-axis"_s,         u"iso230-4-full-circles-xy"_s,
    u"iso230-4-partial-arc-zx"_s, u"iso230-4-feedback-yz"_s};

/// The tests of several documents as those of one, with head, machine and parties of the rotary axis.
Document merged(const QStringList &names) {
    Document result = storedDocument(u"rotary-axis"_s);
    result.tests.clear();
    result.instruments.clear();
    for (const QString &name : names) {
        const std::string prefix = name.toStdString() + '-';
        const Document source = storedDocument(name);
        for (Instrument instrument : source.instruments) {
            instrument.id = prefix + instrument.id;
            result.instruments.push_back(std::move(instrument));
        }
        for (const TestPointer &pointer : source.tests) {
            Test test = *pointer;
            test.id = prefix + test.id;
            for (std::string &id : test.instruments)
                id = prefix + id;
            result.tests.push_back(std::make_shared<const Test>(std::move(test)));
        }
    }
    result.report.title = "Acceptance of the machine";
    return result;
}

struct Line {
    double top = 0;
    double end = 0;
    double left = 0;
    QString text;
};

/// Lines of each page, from top to bottom.
std::vector<std::vector<Line>> linesOf(const QByteArray &pdf) {
    std::vector<std::vector<Line>> pages;
    QXmlStreamReader xml(run(u"pdftotext"_s, {u"-bbox-layout"_s, u"-"_s, u"-"_s}, pdf));
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"page")
            pages.emplace_back();
        const auto number = [&](QLatin1StringView name) { return xml.attributes().value(name).toDouble(); };
        if (xml.name() == u"line")
            pages.back().push_back({number("yMin"_L1), number("yMax"_L1), number("xMin"_L1), {}});
        if (xml.name() == u"word")
            pages.back().back().text += xml.readElementText();
    }
    for (auto &page : pages)
        std::ranges::sort(page, {}, &Line::top);
    return pages;
}

constexpr double footer = 18 * mm;

/// A word of a page with its place to a tenth of a point.
using Word = std::tuple<long, long, QString>;

/// Words of the first pages, by page from 0, that begin left of `end` and above the footer.
std::vector<std::set<Word>> wordsOf(const QByteArray &pdf, int pages, double end) {
    std::vector<std::set<Word>> result;
    double bottom = 0;
    QXmlStreamReader xml(
        run(u"pdftotext"_s, {u"-bbox"_s, u"-l"_s, QString::number(pages), u"-"_s, u"-"_s}, pdf));
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        const auto number = [&](QLatin1StringView name) { return xml.attributes().value(name).toDouble(); };
        if (xml.name() == u"page") {
            result.emplace_back();
            bottom = number("height"_L1) - footer;
        } else if (xml.name() == u"word") {
            const double left = number("xMin"_L1);
            const double top = number("yMin"_L1);
            if (left < end && top < bottom)
                result.back().insert({std::lround(10 * left), std::lround(10 * top), xml.readElementText()});
        }
    }
    return result;
}

/// A hundred times the same test.
Document hundredTests() {
    Document document = storedDocument(u"limits-2006"_s);
    document.tests.assign(100, document.tests.front());
    document.report.leaveOut = {ReportPart::annex};
    return document;
}

} // namespace

/// Reports over several tests: what their pages hold, and how many there are.
class ManyTests : public QObject {
    Q_OBJECT

private slots:
    void pagesAreBounded_data();
    void pagesAreBounded();
    void noPageIsWasted();
    void everythingIsThereOnce();
    void theTestsFollowTheirNumbers();
    void beforeAndAfterStandSideBySide();
    void everyTargetStandsOnce();
    void noLineEndsWithinANameOrNumber();
    void numbersOfTestsStayOnOneLine();
    void theFirstPageIsThatOfTheReport();
};

void ManyTests::pagesAreBounded_data() {
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<bool>("compared");
    QTest::addColumn<int>("most");
    QTest::addColumn<int>("mostOfLetter");
    QTest::newRow("eight tests") << examples << false << 21 << 23;
    QTest::newRow("eight tests under three editions") << examples << true << 22 << 23;
    QTest::newRow("three positioning tests")
        << QStringList{u"long-axis-with-zone"_s, u"rotary-axis"_s} << false << 10 << 11;
    QTest::newRow("three circles") << QStringList{examples.mid(4)} << false << 8 << 8;
    QTest::newRow("an axis and two circles")
        << QStringList{examples[3], examples[4], examples[5]} << false << 10 << 11;
}

void ManyTests::pagesAreBounded() {
    QFETCH(const QStringList, names);
    QFETCH(const bool, compared);
    QFETCH(const int, most);
    QFETCH(const int, mostOfLetter);
    Document document = merged(names);
    if (compared)
        document.report.editions = {"ISO 230-2:1988", "ISO 230-2:2006", "ISO 230-2:2014"};
    for (const Paper paper : {Paper::a4, Paper::letter}) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            document.report.paper = paper;
            const qsizetype pages = pageTexts(pdfOf(reportOf(document, language))).size();
            QVERIFY2(pages <= (paper == Paper::a4 ? most : mostOfLetter),
                     qPrintable(
                         u"%1 pages, paper %2, language %3"_s.arg(pages).arg(int(paper)).arg(int(language))));
        }
    }
}

/// No page is left a third blank but the last, the one whose end may have been moved to it, and that of the
/// signatures; no heading is the last of one.
void ManyTests::noPageIsWasted() {
    Document document = merged(examples);
    document.report.editions = {"ISO 230-2:1988", "ISO 230-2:2006", "ISO 230-2:2014"};
    for (const Paper paper : {Paper::a4, Paper::letter}) {
        const double height = paper == Paper::a4 ? 297 * mm : 792;
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            document.report.paper = paper;
            const Report report = reportOf(document, language);
            std::set<QString> headings;
            for (const Block &block : report.blocks) {
                if (const auto *heading = std::get_if<Heading>(&block))
                    headings.insert(squeezed(heading->text));
            }
            const auto pages = linesOf(pdfOf(report));
            QStringList wasted;
            for (std::size_t i = 0; i < pages.size(); ++i) {
                Line last;
                for (const Line &line : pages[i]) {
                    if (line.end < height - footer)
                        last = line.end > last.end ? line : last;
                }
                QVERIFY2(!headings.contains(squeezed(last.text)), qPrintable(last.text));
                const bool ends = std::ranges::any_of(pages[i], [](const Line &line) {
                    return line.text.startsWith(u"Findu"_s) || line.text.startsWith(u"Endofthe"_s);
                });
                if (!ends && i + 2 != pages.size() && height - footer - last.end >= height / 3)
                    wasted << u"page %1 ends at %2 mm: %3"_s.arg(i + 1).arg(last.end / mm).arg(last.text);
            }
            QVERIFY2(wasted.isEmpty(), qPrintable(wasted.join(u'\n')));
        }
    }
}

void ManyTests::everythingIsThereOnce() {
    const Document document = merged(examples);
    const Report report = reportOf(document, Language::Id::english);
    QMap<QString, int> count;
    for (const Block &block : report.blocks) {
        if (const auto *heading = std::get_if<Heading>(&block))
            ++count[heading->text];
    }
    for (const char *once :
         {"Test conditions", "Environment", "Temperature sensors", "Limits and decision rule",
          "Traceability of the instruments", "Responsibility and signatures", "Program and test file"})
        QCOMPARE(count.value(QString::fromUtf8(once)), 1);
    QMap<QString, int> anchors;
    for (const Block &block : report.blocks)
        ++anchors[anchorOf(block)];
    int named = 0;
    for (const Block &block : report.blocks) { // each verdict leads to its own findings
        const auto *verdict = std::get_if<VerdictLine>(&block);
        if (!verdict || verdict->large || verdict->anchor.isEmpty())
            continue;
        ++named;
        QCOMPARE(anchors.value(verdict->anchor), 1);
    }
    QVERIFY(named > 1);
    QCOMPARE(count.value(u"Results per target position"_s), 4);
    QCOMPARE(count.value(u"Results and readings per target position"_s), 1); // of one direction: one table
    QCOMPARE(count.value(u"Readings"_s), 3);                                 // of one run they are the means
    QCOMPARE(count.value(u"Measured paths"_s), 1);
    QCOMPARE(count.value(u"Correction to 20 °C"_s), 1); // of the circles
    // All that each test states stands in the report, whoever else states it.
    const QStringList pages = pageTexts(pdfOf(report));
    const QString all = squeezed(pages.join(u' '));
    QCOMPARE(all.count(squeezed(u"the readings tilted by"_s)), 1); // how the method works: once
    QCOMPARE(all.count(squeezed(u", otherwise as for test 2."_s)), 3);
    QVERIFY(squeezed(pages[1]).contains(u"Limitsanddecisionrule"_s)); // in the room the summary leaves
    for (const QString &page : pages.first(2))                        // of the summary: no unit breaks
        QVERIFY2(!page.contains(QRegularExpression(u"(^|\\s)µ(\\s|$)"_s)), qPrintable(page));
    for (const TestPointer &test : document.tests) {
        const auto *m = std::get_if<PositioningMeasurement>(&test->measurement);
        const Conditions &conditions =
            m ? m->conditions.common : std::get<CircularMeasurement>(test->measurement).conditions.common;
        for (const std::string &text : {conditions.warmUp.text, conditions.soak, conditions.load,
                                        conditions.instrumentPosition, m ? conditions.otherAxes : ""})
            QVERIFY2(all.contains(squeezed(QString::fromStdString(text))), text.c_str());
        for (const Sensor &sensor : conditions.sensors)
            QVERIFY2(all.contains(squeezed(QString::fromStdString(sensor.position))),
                     sensor.position.c_str());
        for (const AgreedPoint &point : test->agreedPoints)
            QVERIFY2(all.contains(squeezed(QString::fromStdString(point.text))), point.text.c_str());
    }
}

/// What a test states stands beside its number, and nowhere beside that of another.
void ManyTests::theTestsFollowTheirNumbers() {
    Document document = merged(examples);
    const std::size_t count = document.tests.size();
    for (std::size_t i = 0; i < count; ++i) {
        Test test = *document.tests[i];
        auto *m = std::get_if<PositioningMeasurement>(&test.measurement);
        Conditions &conditions =
            m ? m->conditions.common : std::get<CircularMeasurement>(test.measurement).conditions.common;
        // Tests 1 and 5 say the same; all others their own.
        conditions.soak = "soak " + std::to_string(i == 4 ? 1 : i + 1);
        conditions.shielded = true;
        document.tests[i] = std::make_shared<const Test>(std::move(test));
    }
    const Report report = reportOf(document, Language::Id::english);
    std::vector<std::vector<Cell>> rows; // of the conditions, in one table or in two halves
    const auto add = [&](const auto &part) {
        const auto *table = std::get_if<Table>(&part);
        if (table && table->columns.front().title.plain() == u"Condition")
            rows.insert(rows.end(), table->rows.begin(), table->rows.end());
    };
    for (const Block &block : report.blocks) {
        add(block);
        if (const auto *both = std::get_if<SideBySide>(&block)) {
            std::ranges::for_each(both->left, add);
            std::ranges::for_each(both->right, add);
        }
    }
    QVERIFY(!rows.empty());
    QStringList said;
    QString key;
    QStringList shielded;
    for (const std::vector<Cell> &row : rows) {
        if (!row[0].blank)
            key = row[0].text.plain();
        if (key == u"Soaking time")
            said << row[1].text.plain() + u": "_s + row[2].text.plain();
        if (key == u"Shielded from draughts and radiation")
            shielded << row[1].text.plain() + u": "_s + row[2].text.plain();
    }
    QCOMPARE(said, (QStringList{u"1, 5: soak 1"_s, u"2: soak 2"_s, u"3: soak 3"_s, u"4: soak 4"_s,
                                u"6: soak 6"_s, u"7: soak 7"_s, u"8: soak 8"_s}));
    QCOMPARE(shielded, QStringList{u"all: yes"_s});
}

/// A test as found and the one as left, of the same axis and edition: both values, both verdicts and the
/// change between them.
void ManyTests::beforeAndAfterStandSideBySide() {
    Document document = storedDocument(u"limits-2006"_s);
    Test found = *document.tests.front();
    found.role = TestRole::asFound;
    Test left = found;
    left.id = "left";
    left.role = TestRole::asLeft;
    for (Run &run : std::get<PositioningMeasurement>(left.measurement).runs) {
        for (auto &deviation : run.deviations) {
            if (deviation)
                *deviation /= 2; // everything is half as large
        }
    }
    Test other = left; // of another axis: nothing to compare with
    other.id = "other";
    std::get<PositioningMeasurement>(other.measurement).axis.name = "W";
    const auto tableOf = [&](std::vector<Test> tests) -> std::optional<Table> {
        Document changed = document;
        changed.report.adjustments = "backlash compensation";
        changed.tests.clear();
        for (Test &test : tests)
            changed.tests.push_back(std::make_shared<const Test>(std::move(test)));
        const Report report = reportOf(changed, Language::Id::english);
        for (std::size_t i = 0; i + 3 < report.blocks.size(); ++i) {
            const auto *heading = std::get_if<Heading>(&report.blocks[i]);
            if (heading && heading->text == u"Before and after adjustment")
                return std::get<Paragraph>(report.blocks[i + 1]).text == u"backlash compensation"
                           ? std::get<Table>(report.blocks[i + 3])
                           : std::optional<Table>();
        }
        return std::nullopt;
    };
    for (const bool before : {true, false}) { // whichever stands first in the file
        const auto table = tableOf(before ? std::vector{found, left} : std::vector{left, found});
        QVERIFY(table);
        QCOMPARE(table->spanners.size(), std::size_t(2));
        QCOMPARE(table->spanners[0].title.plain(), before ? u"as found (1)"_s : u"as found (2)"_s);
        QCOMPARE(table->spanners[1].title.plain(), before ? u"as left (2)"_s : u"as left (1)"_s);
        const auto number = [](const Cell &cell) {
            return cell.text.plain().replace(QChar(u'−'), u'-').toDouble();
        };
        int verdicts = 0;
        QVERIFY(table->rows.size() >= 5);
        for (const std::vector<Cell> &row : table->rows) {
            // Each is rounded by itself to 0.1 µm.
            QVERIFY(std::abs(number(row[2]) - 2 * number(row[5])) < 0.16);
            QVERIFY(std::abs(number(row[8]) - (number(row[5]) - number(row[2]))) < 0.16);
            verdicts += !row[4].text.plain().isEmpty() && !row[7].text.plain().isEmpty() ? 1 : 0;
        }
        QVERIFY(verdicts > 0);
    }
    QVERIFY(!tableOf({found, other}));
    other = left;
    other.edition = "ISO 230-2:1988"; // its A is another quantity
    QVERIFY(!tableOf({found, other}));
    left.role = TestRole::notStated;
    QVERIFY(!tableOf({found, left}));
}

/// In a table of one half or two: each target with its own values, and as a table that is whole no more than
/// twenty rows.
void ManyTests::everyTargetStandsOnce() {
    Document document = storedDocument(u"long-axis-with-zone"_s);
    document.tests.resize(1);
    for (int count = 2; count <= 45; ++count) {
        Test test = *document.tests.front();
        auto &m = std::get<PositioningMeasurement>(test.measurement);
        m.targets.clear();
        for (int i = 0; i < count; ++i)
            m.targets.push_back(100.0 * i);
        double up = 0;
        for (Run &run : m.runs) {
            run.deviations.clear();
            for (int i = 0; i < count; ++i)
                run.deviations.emplace_back(run.approach == Direction::positive ? 0.001 * i : -0.001 * i);
            up += run.approach == Direction::positive ? 1 : 0;
        }
        QCOMPARE(up, 1.0);
        document.tests.front() = std::make_shared<const Test>(std::move(test));
        const Report report = reportOf(document, Language::Id::english);
        const Table *table = nullptr;
        for (std::size_t i = 0; i + 1 < report.blocks.size(); ++i) {
            const auto *heading = std::get_if<Heading>(&report.blocks[i]);
            if (heading && heading->text == u"Results per target position")
                table = std::get_if<Table>(&report.blocks[i + 1]);
        }
        QVERIFY(table);
        const std::size_t halves = table->columns.size() / 6;
        QCOMPARE(table->columns.size(), 6 * halves);
        QCOMPARE(halves, count > 15 && count <= 40 ? std::size_t{2} : std::size_t{1});
        QVERIFY(halves == 1 || table->rows.size() <= 20);
        int number = 0;
        for (std::size_t half = 0; half < halves; ++half) {
            for (const std::vector<Cell> &row : table->rows) {
                QCOMPARE(row.size(), table->columns.size());
                if (row[6 * half].blank)
                    continue;
                QCOMPARE(row[6 * half].text.plain(), QString::number(++number));
                const Language english(Language::Id::english);
                QCOMPARE(row[6 * half + 1].text.plain(),
                         english.number(100.0 * (number - 1), Quantity::position, 0));
                QCOMPARE(row[6 * half + 2].text.plain(),
                         english.number(0.001 * (number - 1), Quantity::deviation, 1));
            }
        }
        QCOMPARE(number, count);
    }
}

/// Of all texts of all reports, however narrow their column.
void ManyTests::noLineEndsWithinANameOrNumber() {
    const QRegularExpression &forbidden = forbiddenBreaks();
    QVERIFY(forbidden.match(u"de l’ISO \n230-2"_s).hasMatch());
    QVERIFY(forbidden.match(u"20 \n°C,"_s).hasMatch());
    QVERIFY(forbidden.match(u"segments of 2 \n000 mm"_s).hasMatch());
    QVERIFY(!forbidden.match(u"of ISO 230-2 \n20 targets"_s).hasMatch());
    constexpr TextStyle style{9, false, 0xff000000, 1.2};
    qsizetype breaks = 0;
    QSet<QString> seen;
    for (const QString &name : storedDocuments) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            QString all = pageText(reportOf(storedDocument(name), language));
            all.replace(u"  "_s, u"\n"_s); // between labels and values
            for (const QString &text : all.split(u'\n')) {
                if (seen.contains(text))
                    continue;
                seen.insert(text);
                for (const double width : {110.0, 150.0, 230.0, 400.0}) {
                    const TextBlock block(text, style, width);
                    for (std::size_t i = 0; i + 1 < block.lineCount(); ++i) {
                        ++breaks;
                        const QString last = block.line(i).text().trimmed().section(u' ', -1);
                        const QString next = block.line(i + 1).text().trimmed().section(u' ', 0, 0);
                        const QString both = last + u" \n"_s + next;
                        QVERIFY2(!forbidden.match(both).hasMatch(), qPrintable(both + u" in "_s + text));
                    }
                }
            }
        }
    }
    QVERIFY(breaks > 3000);
}

void ManyTests::numbersOfTestsStayOnOneLine() {
    const Document document = hundredTests();
    std::set<QString> numbers;
    for (const auto &page : wordsOf(pdfOf(reportOf(document, Language::Id::english)), 9, 25 * mm)) {
        for (const Word &word : page)
            numbers.insert(std::get<QString>(word));
    }
    for (std::size_t number = 1; number <= document.tests.size(); ++number)
        QVERIFY2(numbers.contains(QString::number(number)), qPrintable(QString::number(number)));
}

/// The page shown while the others are composed has what the printed one has, except for the numbers of
/// pages.
void ManyTests::theFirstPageIsThatOfTheReport() {
    constexpr double pageColumn = 182 * mm;
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(hundredTests()));
    QByteArray shown;
    ReportOptions options;
    options.onFirstPage = [&shown](const Report &first) { shown = pdfOf(first); };
    const Report report = composeReport(evaluated, Language(Language::Id::french), options);
    const auto expected = wordsOf(pdfOf(report), 1, pageColumn).front();
    QVERIFY(expected.size() > 150);
    QVERIFY(wordsOf(shown, 1, pageColumn).front() == expected);
}

QTEST_MAIN(ManyTests)
#include "manytests.moc"
