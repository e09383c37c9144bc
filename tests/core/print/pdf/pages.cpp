// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/pages.h"
#include "print/figures/style.h"

#include "core/print/pdf/reports.h"
#include "document/bounds.h"

#include <QXmlStreamReader>

using namespace palmer;
using namespace palmer::testdata;

namespace {

constexpr double bottom = (297 - 18) * mm; ///< of the text on A4

/// A word of a PDF and where it stands, points from the top left corner.
struct PlacedWord {
    int page = 0;
    QString text;
    double top = 0;
    double end = 0; ///< lower edge
    double left = 0;
    double right = 0;
};

std::vector<PlacedWord> placedWords(const QByteArray &pdf) {
    std::vector<PlacedWord> result;
    QXmlStreamReader xml(run(u"pdftotext"_s, {u"-bbox"_s, u"-"_s, u"-"_s}, pdf));
    int page = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"page")
            ++page;
        if (xml.name() == u"word") {
            const double top = xml.attributes().value("yMin"_L1).toDouble();
            const double end = xml.attributes().value("yMax"_L1).toDouble();
            const double left = xml.attributes().value("xMin"_L1).toDouble();
            const double right = xml.attributes().value("xMax"_L1).toDouble();
            result.push_back({page, xml.readElementText(), top, end, left, right});
        }
    }
    return result;
}

Report reportOfBlocks(std::vector<Block> blocks) {
    Report report;
    report.blocks = std::move(blocks);
    report.language = u"en"_s;
    report.title = u"Pages"_s;
    report.footerLeft = u"Report"_s;
    report.footerCentre = u"Fingerprint"_s;
    report.footerRight = u"page %1 / %2"_s;
    return report;
}

/// Lines that fill a page step by step.
Paragraph filler(int lines) {
    return {QStringList(lines, u"filler"_s).join(u'\n'), TextSize::small};
}

Table tableOf(int rows) {
    Table table;
    table.columns = {{u"Name"_s, {}, Alignment::left, true, 60},
                     {u"Value"_s, u"mm"_s, Alignment::decimal, false, 30}};
    for (int i = 1; i <= rows; ++i)
        table.rows.push_back({Cell(u"row%1"_s.arg(i)), Cell(u"%1.5"_s.arg(i))});
    return table;
}

FigureBlock figure() {
    const Report report = reportOf(storedDocument(u"one-direction"_s), Language::Id::english);
    for (const Block &block : report.blocks) {
        if (const auto *found = std::get_if<FigureBlock>(&block))
            return *found;
    }
    qFatal("the report has no figure");
}

PositioningMeasurement &measurementOf(Document &document, Test &test) {
    test = *document.tests.front();
    return std::get<PositioningMeasurement>(test.measurement);
}

Document withTest(Document document, Test test) {
    document.tests = {std::make_shared<const Test>(std::move(test))};
    return document;
}

Document withTargets(int targets, int runs) {
    Document document = storedDocument(u"limits-2006"_s);
    Test test;
    PositioningMeasurement &measurement = measurementOf(document, test);
    const Run first = measurement.runs.front();
    measurement.targets.clear();
    measurement.runs.clear();
    measurement.excluded.clear();
    for (int i = 0; i < targets; ++i)
        measurement.targets.push_back(10.123 * i);
    for (int run = 0; run < 2 * runs; ++run) {
        Run next = first;
        next.approach = run % 2 == 0 ? Direction::positive : Direction::negative;
        next.deviations.clear();
        for (int i = 0; i < targets; ++i)
            next.deviations.emplace_back(0.0001 * ((i * 7 + run * 13) % 97 - 40));
        measurement.runs.push_back(next);
    }
    return withTest(std::move(document), std::move(test));
}

Document withLongNames(int size) {
    Document document = storedDocument(u"limits-2006"_s);
    const std::string words =
        QString(u"Laboratoire central d’essais "_s.repeated(size / 28 + 1)).left(size).toStdString();
    const std::string word(static_cast<std::size_t>(size), 'W'); // nowhere to break
    ReportHead &head = document.report;
    head.laboratory.name = words;
    head.laboratory.address = word;
    head.laboratory.accreditation = words;
    head.title = words;
    head.number = word;
    head.revision = words;
    head.place = word;
    head.customer.name = words;
    head.supplier.name = word;
    head.operatorName = words;
    head.authorisedBy = {word, words};
    head.signatures = {Signer::operatorSigns, Signer::laboratory, Signer::supplier, Signer::customer};
    document.machine.manufacturer = words;
    document.machine.serialNumber = word;
    for (Instrument &instrument : document.instruments) {
        instrument.manufacturer = words;
        instrument.serialNumber = word;
    }
    Test test = *document.tests.front();
    test.title = words;
    for (AgreedPoint &point : test.agreedPoints)
        point.text = word;
    return withTest(std::move(document), std::move(test));
}

Document withLongAgreement() {
    Document document = storedDocument(u"limits-2006"_s);
    Test test = *document.tests.front();
    const std::string text =
        u"La mise en température se fait à 10 m/min sur toute la course. "_s.repeated(120).toStdString();
    for (AgreedPoint &point : test.agreedPoints)
        point.text = text;
    test.remarks = text;
    document.report.remarks = text;
    return withTest(std::move(document), std::move(test));
}

Document withoutConditions() {
    Document document;
    Test test;
    test.edition = "ISO 230-2:2014";
    Document example = storedDocument(u"iso230-2-1988-example"_s);
    Test source;
    PositioningMeasurement measurement;
    measurement.targets = measurementOf(example, source).targets;
    measurement.runs = std::get<PositioningMeasurement>(source.measurement).runs;
    test.measurement = measurement;
    return withTest(std::move(document), std::move(test));
}

Document withPaper(Paper paper) {
    Document document = storedDocument(u"limits-2006"_s);
    document.report.paper = paper;
    return document;
}

} // namespace

/// Where the blocks of a report stand on its pages.
class PagesTest : public QObject {
    Q_OBJECT

private slots:
    void emptyReportHasOnePage();
    void sectionsNeverStartAtTheBottom();
    void figureKeepsItsCaption();
    void aParagraphIsNotCutToFillTheLastPage();
    void signaturesAreNeverSplit();
    void headOfASplitTableRepeats();
    void runningHeadBeginsOnTheSecondPage();
    void aPartBeginsBehindWhatFoundNoRoom();
    void signaturesNeverStandAlone();
    void resultsStayWhole();
    void resultsStandOnTheFirstPage();
    void extremeDocumentsStayInTheMargins_data();
    void extremeDocumentsStayInTheMargins();
    void numbersStandOnTheirDecimalMark();
    void namesKeepAGapToTheTargets();
    void titlesStandInsideTheirHead();
    void figuresStandBesideTheirParameters();
};

void PagesTest::emptyReportHasOnePage() {
    QCOMPARE(layoutPages(reportOfBlocks({})).size(), std::size_t(1));
}

void PagesTest::sectionsNeverStartAtTheBottom() {
    std::vector<Block> blocks;
    constexpr int cases = 75;
    for (int lines = 1; lines <= cases; ++lines) {
        blocks.insert(blocks.end(), {filler(lines), Heading{2, u"SECTION%1"_s.arg(lines)},
                                     Paragraph{u"below%1"_s.arg(lines)}, PageBreak{}});
    }
    std::map<QString, PlacedWord> found;
    for (const PlacedWord &word : placedWords(pdfOf(reportOfBlocks(std::move(blocks)))))
        found[word.text] = word;
    bool reachesLimit = false;
    for (int lines = 1; lines <= cases; ++lines) {
        const PlacedWord &heading = found.at(u"SECTION%1"_s.arg(lines));
        QVERIFY(heading.top < bottom - 24 * mm); // a line is 1 mm higher than its box
        QCOMPARE(found.at(u"below%1"_s.arg(lines)).page, heading.page);
        reachesLimit = reachesLimit || heading.top > bottom - 30 * mm;
    }
    QVERIFY(reachesLimit);
}

void PagesTest::figureKeepsItsCaption() {
    std::vector<Block> blocks;
    const FigureBlock picture = figure();
    for (int lines = 30; lines <= 60; lines += 2)
        blocks.insert(blocks.end(), {filler(lines), Heading{2, u"CAPTION"_s}, picture, PageBreak{}});
    const std::vector<PlacedWord> words = placedWords(pdfOf(reportOfBlocks(std::move(blocks))));
    int captions = 0;
    for (const PlacedWord &caption : words) {
        if (caption.text != u"CAPTION")
            continue;
        ++captions;
        const bool below = std::any_of(words.begin(), words.end(), [&](const PlacedWord &word) {
            return word.page == caption.page && word.text == u"Target" && word.top > caption.top + 60 * mm &&
                   word.end < bottom;
        });
        QVERIFY(below);
    }
    QCOMPARE(captions, 16);
}

/// A text with room on its page gives no line to the figure on the next, however empty that page is.
void PagesTest::aParagraphIsNotCutToFillTheLastPage() {
    std::vector<Block> blocks;
    const Paragraph text{u"BEGIN\na\nb\nc\nd\ne\nf\ng\nh\nEND"_s, TextSize::small};
    for (int lines = 48; lines <= 60; ++lines)
        blocks.insert(blocks.end(), {filler(lines), text, Heading{2, u"CAPTION"_s}, figure(), PageBreak{}});
    std::map<QString, std::vector<int>> pages;
    for (const PlacedWord &word : placedWords(pdfOf(reportOfBlocks(std::move(blocks)))))
        pages[word.text].push_back(word.page);
    QCOMPARE(pages[u"BEGIN"_s].size(), std::size_t(13));
    QCOMPARE(pages[u"END"_s], pages[u"BEGIN"_s]);
    QVERIFY(pages[u"CAPTION"_s] != pages[u"END"_s]);
}

void PagesTest::signaturesAreNeverSplit() {
    std::vector<Block> blocks;
    const Signatures signatures{{{u"OPERATOR"_s, {{u"NAME"_s, u"N. N."_s}, {u"SIGNATURE"_s, {}, true}}},
                                 {u"Customer"_s, {{u"Name"_s}, {u"Signature"_s, {}, true}}}}};
    for (int lines = 40; lines <= 70; ++lines)
        blocks.insert(blocks.end(), {filler(lines), Heading{2, u"Signatures"_s}, signatures, PageBreak{}});
    int page = 0;
    int blocksFound = 0;
    for (const PlacedWord &word : placedWords(pdfOf(reportOfBlocks(std::move(blocks))))) {
        if (word.text == u"OPERATOR")
            page = word.page;
        if (word.text == u"SIGNATURE") {
            ++blocksFound;
            QCOMPARE(word.page, page);
            QVERIFY(word.end + 12 * mm < bottom); // room to sign
        }
    }
    QCOMPARE(blocksFound, 31);
}

void PagesTest::headOfASplitTableRepeats() {
    const QStringList pages = pageTexts(pdfOf(reportOfBlocks({Heading{2, u"Values"_s}, tableOf(120)})));
    QCOMPARE(pages.size(), 3);
    for (const QString &page : pages)
        QVERIFY2(squeezed(page).contains(u"NameValuemmrow"), qPrintable(page));
}

void PagesTest::runningHeadBeginsOnTheSecondPage() {
    const QStringList pages =
        pageTexts(pdfOf(reportOfBlocks({RunningHead{u"Laboratory"_s, u"FIRST"_s}, filler(150), PageBreak{},
                                        RunningHead{u"Laboratory"_s, u"SECOND"_s}, filler(100)})));
    QCOMPARE(pages.size(), 5);
    const QStringList heads{QString(), u"FIRST"_s, u"FIRST"_s, QString(), u"SECOND"_s};
    for (qsizetype i = 0; i < pages.size(); ++i) {
        QCOMPARE(pages[i].contains(u"FIRST"), heads[i] == u"FIRST");
        QCOMPARE(pages[i].contains(u"SECOND"), heads[i] == u"SECOND");
    }
}

/// A page that only goes on with a test may be filled up with the next part; the first page of a test, and
/// that of the next head, are its own.
void PagesTest::aPartBeginsBehindWhatFoundNoRoom() {
    const RunningHead running{u"Laboratory"_s, u"Test"_s};
    const auto pageOfNext = [&](int lines, const std::vector<Block> &next) {
        std::vector<Block> blocks{running, filler(lines), PageBreak{}};
        blocks.insert(blocks.end(), next.begin(), next.end());
        const QStringList pages = pageTexts(pdfOf(reportOfBlocks(std::move(blocks))));
        for (qsizetype i = 0; i < pages.size(); ++i) {
            if (pages[i].contains(u"NEXT"))
                return i + 1;
        }
        return qsizetype(0);
    };
    const std::vector<Block> part{Heading{1, u"NEXT"_s}, Paragraph{u"below"_s}};
    const std::vector<Block> section{Heading{2, u"NEXT"_s}, Paragraph{u"below"_s}};
    TestHead head;
    head.title = u"NEXT"_s;
    QCOMPARE(pageOfNext(10, part), qsizetype(2));
    QCOMPARE(pageOfNext(100, part), qsizetype(2));
    QCOMPARE(pageOfNext(100, section), qsizetype(3));
    QCOMPARE(pageOfNext(100, {running, head}), qsizetype(3));
}

void PagesTest::signaturesNeverStandAlone() {
    Signatures signatures;
    signatures.columns = {{u"Operator"_s, {{u"Date"_s, {}, false, 0}, {u"Signature"_s, {}, true, 0}}}};
    int overleaf = 0;
    for (int rows = 20; rows < 70; ++rows) {
        const QStringList pages = pageTexts(pdfOf(
            reportOfBlocks({Heading{2, u"Values"_s}, tableOf(rows), Heading{2, u"SIGN"_s}, signatures})));
        if (pages.size() == 1)
            continue;
        ++overleaf;
        const QString last = squeezed(pages.last());
        QVERIFY2(last.contains(u"row") || !last.contains(u"SIGN"), qPrintable(pages.last()));
    }
    QVERIFY(overleaf > 20);
}

void PagesTest::resultsStayWhole() {
    for (const QString &name : storedDocuments) {
        const Report report = reportOf(storedDocument(name), Language::Id::french);
        const QStringList pages = pageTexts(pdfOf(report));
        for (std::size_t i = 1; i < report.blocks.size(); ++i) {
            const auto *verdict = std::get_if<VerdictLine>(&report.blocks[i]);
            if (!verdict || verdict->large) // that of the summary
                continue;
            std::size_t from = i; // the heading of the results
            while (!std::holds_alternative<Heading>(report.blocks[from]) ||
                   !std::holds_alternative<Table>(report.blocks[from + 1]))
                ++from;
            const QString heading = squeezed(std::get<Heading>(report.blocks[from]).text);
            const QString words = squeezed(verdict->label + verdict->word);
            // On one page; where a head is too long for both, the verdict below the head and the results
            // overleaf.
            bool together = false;
            for (qsizetype page = 0; page < pages.size(); ++page) {
                const bool hasResults = squeezed(pages[page]).contains(heading);
                together = together || (hasResults && squeezed(pages[page]).contains(words)) ||
                           (hasResults && page > 0 && squeezed(pages[page - 1]).contains(words));
            }
            QVERIFY2(together, qPrintable(name + u": "_s + words));
        }
    }
}

void PagesTest::resultsStandOnTheFirstPage() {
    // The gaps give way, and where that does not suffice, the figure: of limits-2006 in English it has to.
    for (const QString &name : {u"limits-2006"_s, u"budget-2006"_s, u"one-direction-with-gaps"_s,
                                u"rotary-axis"_s, u"iso230-2-1988-example"_s}) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            const Report report = reportOf(storedDocument(name), language);
            const QString page = squeezed(pageTexts(pdfOf(report)).front());
            for (const Block &block : report.blocks) {
                if (const auto *verdict = std::get_if<VerdictLine>(&block))
                    QVERIFY2(page.contains(squeezed(verdict->label + verdict->word)), qPrintable(name));
            }
        }
    }
}

void PagesTest::extremeDocumentsStayInTheMargins_data() {
    QTest::addColumn<Document>("document");
    QTest::addColumn<bool>("inEnglishToo"); // the longest texts take seconds, and are the same there
    for (const QString &name : storedDocuments)
        QTest::newRow(qPrintable(name)) << storedDocument(name) << true;
    QTest::newRow("one target") << withTargets(1, 5) << true;
    QTest::newRow("400 targets, 10 runs each way") << withTargets(400, 10) << true;
    QTest::newRow("names of 200 characters") << withLongNames(200) << true;
    QTest::newRow("names as long as the file allows") << withLongNames(static_cast<int>(mostOfLine)) << false;
    QTest::newRow("agreed texts longer than a page") << withLongAgreement() << false;
    QTest::newRow("nothing stated at all") << withoutConditions() << true;
    QTest::newRow("Letter") << withPaper(Paper::letter) << true;
}

void PagesTest::extremeDocumentsStayInTheMargins() {
    QFETCH(const Document, document);
    QFETCH(const bool, inEnglishToo);
    const bool letter = document.report.paper == Paper::letter;
    const double width = letter ? 215.9 : 210;
    const double height = letter ? 279.4 : 297;
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        if (language == Language::Id::english && !inEnglishToo)
            continue;
        const QByteArray pdf = pdfOf(reportOf(document, language));
        int number = 0;
        for (const QImage &page : pictures(pdf, 76.2)) { // 3 pixels a mm
            ++number;
            QCOMPARE(page.format(), QImage::Format_Grayscale8);
            QVERIFY(std::abs(page.width() - 3 * width) < 2 && std::abs(page.height() - 3 * height) < 2);
            // Half a millimetre for rules and overhanging letters.
            const int left = qCeil(19.5 * 3);
            const int right = qFloor((width - 14.5) * 3);
            for (int y = 0; y < page.height(); ++y) {
                const double down = y / 3.0;
                const bool inText = down > 14.5 && down < height - 17.6;
                const bool inFooter = down > height - 14.5 && down < height - 9;
                const auto *pixels = page.constScanLine(y);
                for (int x = 0; x < page.width(); ++x) {
                    const bool allowed = (inText || inFooter) && x >= left && x <= right;
                    if (!allowed && pixels[x] <= 250)
                        QFAIL(qPrintable(u"page %1: %2 mm, %3 mm"_s.arg(number).arg(x / 3.0).arg(down)));
                    if (inText && x == left)
                        x = right; // nothing to look at between the margins
                }
            }
        }
        QVERIFY(number > 0);
    }
}

void PagesTest::numbersStandOnTheirDecimalMark() {
    Table table;
    table.columns = {{u"Value"_s, u"mm"_s, Alignment::decimal, false, 40},
                     {u"V"_s, {}, Alignment::decimal, false, 8}, // as wide as wholes and decimals need
                     {u"Text"_s, {}, Alignment::left, true, 40}};
    table.columns[1].fitting = true;
    for (const auto &[number, other] :
         {std::pair(u"1.25"_s, u"1.2500001"_s), std::pair(u"−12.5"_s, u"−12.6"_s),
          std::pair(u"123"_s, u"124"_s), std::pair(QString(), u"125"_s)})
        table.rows.push_back({number.isEmpty() ? Cell() : Cell(number), other, u"text"_s});
    // In tenths of a point: the mark of each number, by the widths that the PDF has.
    QXmlStreamReader xml(run(u"pdftotext"_s, {u"-bbox"_s, u"-"_s, u"-"_s}, pdfOf(reportOfBlocks({table}))));
    std::map<QString, std::pair<double, double>> edges;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == u"word") {
            const double from = xml.attributes().value("xMin"_L1).toDouble();
            const double to = xml.attributes().value("xMax"_L1).toDouble();
            edges[xml.readElementText()] = {from, to};
        }
    }
    const double digit = 0.556 * 8.5;
    const double mark = 0.278 * 8.5;
    const double place = edges.at(u"123"_s).second; // end of the whole
    constexpr double tolerance = 0.1;               // of the rounded widths in a PDF
    QVERIFY(std::abs(edges.at(u"1.25"_s).second - mark - 2 * digit - place) < tolerance);
    QVERIFY(std::abs(edges.at(u"−12.5"_s).second - mark - digit - place) < tolerance);
    QVERIFY(std::abs(edges.at(u"–"_s).second - place) < tolerance);
    QVERIFY(std::abs(edges.at(u"mm"_s).second - edges.at(u"1.25"_s).second) < tolerance);
    const double fitted = edges.at(u"124"_s).second;
    QVERIFY(std::abs(edges.at(u"1.2500001"_s).second - mark - 7 * digit - fitted) < tolerance);
    QVERIFY(std::abs(edges.at(u"−12.6"_s).second - mark - digit - fitted) < tolerance);
}

/// Between the name of a result and the targets that rule it white space is wide enough to part them.
void PagesTest::namesKeepAGapToTheTargets() {
    constexpr double least = 1.9 * mm;
    static const QRegularExpression target(u"^[0-9]+[↑↓]?$"_s);
    static const QRegularExpression symbol(u"^[AEMRB][↑↓]?$"_s);
    for (const QString &name : {u"limits-2006"_s, u"long-axis-with-zone"_s, u"iso230-2-1988-example"_s}) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            std::map<std::pair<int, long>, std::vector<PlacedWord>> lines;
            for (const PlacedWord &word : placedWords(pdfOf(reportOf(storedDocument(name), language))))
                lines[{word.page, std::lround(word.end)}].push_back(word);
            int rows = 0;
            for (auto &[place, words] : lines) {
                std::ranges::sort(words, {}, &PlacedWord::left);
                const bool atMargin = words.front().left < 25 * mm;
                if (!atMargin || !symbol.match(words.front().text).hasMatch())
                    continue;
                const auto first = std::ranges::find_if(
                    words, [&](const PlacedWord &word) { return target.match(word.text).hasMatch(); });
                if (first == words.end() || first - words.begin() < 2)
                    continue; // the name goes on on the next line, or none rules
                ++rows;
                const double gap = first->left - (first - 1)->right;
                QVERIFY2(gap >= least,
                         qPrintable(u"%1 %2: %3 mm"_s.arg(name, (first - 1)->text).arg(gap / mm)));
            }
            QVERIFY(rows >= 5);
        }
    }
}

void PagesTest::titlesStandInsideTheirHead() {
    // The only unit stands in a column without title: the titles of the numbers still keep its line free.
    Table table;
    table.columns = {{QString(), u"unit"_s, Alignment::left, true, 60},
                     {u"TITLE"_s, {}, Alignment::decimal, false, 30}};
    table.rows.push_back({Cell(u"name"_s), Cell(u"1.5"_s)});
    const auto words = placedWords(pdfOf(reportOfBlocks({Paragraph{u"above"_s}, table})));
    const auto word = [&](const QString &text) { return *std::ranges::find(words, text, &PlacedWord::text); };
    QVERIFY(word(u"TITLE"_s).top > word(u"above"_s).end);
    QVERIFY(word(u"unit"_s).top > word(u"TITLE"_s).top);
}

void PagesTest::figuresStandBesideTheirParameters() {
    for (const QString &name : {u"iso230-4-full-circles-xy"_s, u"iso230-4-partial-arc-zx"_s}) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            const auto words = placedWords(pdfOf(reportOf(storedDocument(name), language)));
            const bool french = language == Language::Id::french;
            const auto onPage = [&](const QString &text) {
                return std::ranges::find(words, text, &PlacedWord::text)->page;
            };
            // Figure, results and verdict share the first page.
            QCOMPARE(onPage(french ? u"grossissement"_s : u"magnification"_s), 1);
            QCOMPARE(onPage(u"Compensation"_s), 1);
            QCOMPARE(onPage(french ? u"CONFORME"_s : u"CONFORMS"_s), 1);
        }
    }
}

QTEST_MAIN(PagesTest)

#include "pages.moc"
