// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/figures/recordedtexts.h"
#include "core/print/pdf/generator.h"
#include "print/figures/drawfigure.h"
#include "print/figures/style.h"
#include "report/blocks/pagetext.h"

#include <QXmlStreamReader>
#include <algorithm>

using namespace palmer;
using namespace palmer::testdata;

namespace {

constexpr double leastFill = 0.45;

struct Line {
    QString first; ///< word
    QString last;  ///< word
    QRectF area;
    QStringList words = {};
};

struct Page {
    QSizeF size;
    std::vector<Line> lines; ///< in the order of reading

    [[nodiscard]] double bottom() const { return size.height() - 18 * mm; }
    /// Lower edge of the text above the footer.
    [[nodiscard]] double end() const {
        double end = 15 * mm;
        for (const Line &line : lines)
            end = line.area.bottom() < bottom() + mm ? std::max(end, line.area.bottom()) : end;
        return end;
    }
    [[nodiscard]] double fill() const { return (end() - 15 * mm) / (bottom() - 15 * mm); }
};

std::vector<Page> pagesOf(const QByteArray &pdf) {
    std::vector<Page> pages;
    QXmlStreamReader xml(run(u"pdftotext"_s, {u"-bbox-layout"_s, u"-"_s, u"-"_s}, pdf));
    const auto number = [&](QLatin1StringView name) { return xml.attributes().value(name).toDouble(); };
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"page")
            pages.push_back({{number("width"_L1), number("height"_L1)}, {}});
        if (xml.name() == u"line")
            pages.back().lines.push_back({{},
                                          {},
                                          QRectF(QPointF(number("xMin"_L1), number("yMin"_L1)),
                                                 QPointF(number("xMax"_L1), number("yMax"_L1)))});
        if (xml.name() == u"word") {
            Line &line = pages.back().lines.back();
            line.last = xml.readElementText();
            line.words << line.last;
            if (line.first.isEmpty())
                line.first = line.last;
        }
    }
    return pages;
}

/// Faults of the pages of a report, each with its page.
QStringList faultsOf(const Report &report) {
    QStringList faults;
    const QByteArray pdf = pdfOf(report);
    const std::vector<Page> pages = pagesOf(pdf);
    const QStringList texts = pageTexts(pdf);
    QSet<QString> headings;
    QString endOfCertificate;
    for (const Block &block : report.blocks) {
        if (const auto *heading = std::get_if<Heading>(&block))
            headings << squeezed(heading->text);
        if (const auto *mark = std::get_if<EndMark>(&block); mark && !mark->anchor.isEmpty())
            endOfCertificate = squeezed(mark->text.section(u'.', 0, 0));
    }
    static const QRegularExpression cut(u"^[0-9]{0,2}:(19|20)[0-9]{2}$"_s); // "VDI/DGQ 344|1:1977"
    static const QRegularExpression count(u"^[0-9]{1,3}$"_s);
    static const QRegularExpression noun(u"^\\p{Ll}"_s, QRegularExpression::UseUnicodePropertiesOption);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Page &page = pages[i];
        const auto say = [&](const QString &fault) { faults << u"page %1: %2"_s.arg(i + 1).arg(fault); };
        const QString text = squeezed(texts[static_cast<qsizetype>(i)]);
        for (std::size_t k = 0; k < page.lines.size(); ++k) {
            const Line &line = page.lines[k];
            if (line.area.left() < 20 * mm - 1 || line.area.right() > page.size.width() - 15 * mm + 1)
                say(u"outside the margins: "_s + line.first);
            for (const QString &word : line.words) {
                if (cut.match(word).hasMatch())
                    say(u"broken: “%1”"_s.arg(word));
            }
            if (k + 1 == page.lines.size())
                continue;
            const Line &next = page.lines[k + 1];
            const bool goesOn =
                std::abs(next.area.left() - line.area.left()) < mm && next.area.top() > line.area.top() &&
                next.area.top() < line.area.bottom() + 0.2 * line.area.height(); // no row of its own
            // not the number of a name, "Hall 2"
            const bool partsCount = line.words.size() > 1 &&
                                    u":;·("_s.contains(line.words.end()[-2].back()) &&
                                    count.match(line.last).hasMatch() && noun.match(next.first).hasMatch();
            if (goesOn &&
                (partsCount || forbiddenBreaks().match(line.last + u" \n"_s + next.first).hasMatch()))
                say(u"broken: “%1|%2”"_s.arg(
                    line.words.mid(std::max<qsizetype>(line.words.size() - 4, 0)).join(u' '), next.first));
        }
        const bool ends =
            i + 1 == pages.size() || (!endOfCertificate.isEmpty() && text.contains(endOfCertificate));
        if (ends && i > 0 && page.fill() < leastFill)
            say(u"last page %1 % full"_s.arg(qRound(100 * page.fill())));
        QString lowest;
        double end = 0;
        for (const Line &line : page.lines) {
            if (line.area.bottom() < page.bottom() + mm && line.area.bottom() > end) {
                end = line.area.bottom();
                lowest = line.first + line.last;
            }
        }
        if (headings.contains(lowest))
            say(u"a heading ends it: "_s + lowest);
    }
    return faults;
}

/// Calls `use` with all blocks of a kind, also those beside something.
template <class Kind>
void eachOf(const Report &report, const auto &use) {
    const auto take = [&](const auto &block) {
        if (const auto *kind = std::get_if<Kind>(&block))
            use(*kind);
    };
    for (const Block &block : report.blocks) {
        take(block);
        if (const auto *sides = std::get_if<SideBySide>(&block)) {
            std::ranges::for_each(sides->left, take);
            std::ranges::for_each(sides->right, take);
        }
    }
}

/// Texts that leave the figure or touch each other, limits and legend entries without their text.
QStringList faultsOf(const FigureBlock &block) {
    QStringList faults;
    for (const double height : {block.height, std::max(block.least, 0.85 * block.height)}) {
        const QRectF area(QPointF(0, 0), QSizeF(block.width, height) * mm);
        TextRecorder recorder(area.size().toSize() + QSize(1, 1));
        QPainter painter(&recorder);
        drawFigure(painter, area, *block.figure, Medium::paper);
        painter.end();
        QStringList texts;
        for (std::size_t i = 0; i < recorder.texts.size(); ++i) {
            const RecordedText &a = recorder.texts[i];
            texts << a.text;
            if (!area.adjusted(-0.2, -0.2, 0.2, 0.2).contains(a.box))
                faults << u"beyond the figure: "_s + a.text;
            for (std::size_t j = 0; j < i; ++j) {
                const RecordedText &b = recorder.texts[j];
                if (a.outline.intersects(b.outline) &&
                    a.box.adjusted(0.1, 0.1, -0.1, -0.1).intersects(b.box.adjusted(0.1, 0.1, -0.1, -0.1)))
                    faults << u"“%1” on “%2”"_s.arg(a.text, b.text);
            }
        }
        const auto needs = [&](const QString &text) {
            if (!text.isEmpty() && !texts.contains(text))
                faults << u"not drawn: "_s + text;
        };
        if (const auto *circle = std::get_if<CircleFigure>(&*block.figure)) {
            for (const CircleLegendEntry &entry : circle->legend)
                needs(entry.text);
            for (const SenseArrow &arrow : circle->arrows)
                needs(arrow.index);
            if (circle->envelope && circle->envelope->limit)
                needs(circle->envelope->limitLabel);
        } else if (const auto *curve = std::get_if<CurveFigure>(&*block.figure)) {
            for (const Dimension &dimension : curve->dimensions)
                needs(dimension.limit ? dimension.limitText : QString());
        }
    }
    return faults;
}

/// Rows that name another unit of length than the head of their column, as nm below µm.
QStringList otherUnits(const Table &table) {
    static const QRegularExpression length(u"(?<!\\p{L})(nm|µm|mm)(?![\\p{L}/])"_s,
                                           QRegularExpression::UseUnicodePropertiesOption);
    QStringList faults;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const QString unit = table.columns[c].unit;
        if (!length.match(unit).hasMatch())
            continue;
        for (const std::vector<Cell> &row : table.rows) {
            for (const Cell *cell : {&row.front(), &row[c]}) {
                const auto named = length.match(cell->text.plain());
                if (named.hasMatch() && named.captured() != unit)
                    faults << u"“%1” below %2"_s.arg(cell->text.plain(), unit);
            }
        }
    }
    return faults;
}

/// Columns of decimal numbers that are not aligned at their mark, rows with a unit of their own.
QStringList faultsOf(const Table &table) {
    static const QRegularExpression number(u"^[−+]?[0-9\u202F]+([.,]([0-9]+))?$"_s);
    QStringList faults;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        QSet<qsizetype> decimals;
        for (const std::vector<Cell> &row : table.rows) {
            if (const auto found = number.match(row[c].text.plain()); found.hasMatch())
                decimals << found.capturedLength(2);
        }
        if (decimals.size() > 1 && table.columns[c].alignment != Alignment::decimal)
            faults << u"decimals not aligned: column “%1”"_s.arg(table.columns[c].title.plain());
    }
    return faults + otherUnits(table);
}

/// Faults of figures and tables.
QStringList faultsOfBlocks(const Report &report) {
    QStringList faults;
    eachOf<FigureBlock>(report, [&](const FigureBlock &block) { faults << faultsOf(block); });
    eachOf<Table>(report, [&](const Table &table) { faults << faultsOf(table); });
    QMap<QString, QSet<double>> magnifications; // of the senses of each subject
    eachOf<FigureBlock>(report, [&](const FigureBlock &block) {
        const auto *circle = std::get_if<CircleFigure>(&*block.figure);
        if (circle && circle->traces.size() == 1 && circle->envelope)
            magnifications[circle->envelope->label] << circle->magnification;
    });
    for (const auto &[subject, values] : magnifications.asKeyValueRange()) {
        if (values.size() > 1)
            faults << u"magnifications differ: "_s + subject;
    }
    return faults;
}

/// Spaces before the double signs: no-break ones, and never none.
QStringList frenchFaults(const QString &text) {
    static const QRegularExpression wrong(
        u"[^\\n]{0,12}(\\p{L}[;?!](?=\\s)|[ \\p{L}]:(?= )| [;?!])[^\\n]{0,8}"_s,
        QRegularExpression::UseUnicodePropertiesOption);
    QStringList faults;
    for (auto found = wrong.globalMatch(text); found.hasNext();)
        faults << found.next().captured();
    return faults;
}

} // namespace

/// Rules of typography on the pages of generated reports: PALMER_REPORTS of them, 200 for all kinds, papers
/// and languages; PALMER_FIRST of them are left out.
class TypographyTest : public QObject {
    Q_OBJECT

private slots:
    void pagesAreSetWell();
    void storedReportsAreSetWell();
    void resultsKeepTheirSmallPrint();
    void frenchTextsHaveTheirSpaces();
    void rowsInAnotherUnitAreFaults();
};

void TypographyTest::pagesAreSetWell() {
    constexpr int few = 12;
    const int count = qEnvironmentVariableIntValue("PALMER_REPORTS") > 0
                          ? qEnvironmentVariableIntValue("PALMER_REPORTS")
                          : few;
    int nearlyEmpty = 0;
    QStringList faults;
    for (int seed = 1 + qEnvironmentVariableIntValue("PALMER_FIRST"); seed <= count; ++seed) {
        const auto language = seed % 2 == 0 ? Language::Id::french : Language::Id::english;
        Document document = Generator(static_cast<unsigned>(seed) + 5000).document();
        if (seed % 3 == 0)
            document.report.figures = CircleFigures::separate;
        if (seed % 4 == 0)
            document.report.editions = {"ISO 230-2:1988", "VDI/DGQ 3441:1977", "ISO 230-4:1996"};
        if (seed % 5 == 0)
            document.report.include = {ReportExtra::diagnosis};
        if (seed % 25 == 0) { // twelve tests
            const auto tests = document.tests;
            while (document.tests.size() < 12) {
                Test another = *tests[document.tests.size() % tests.size()];
                another.id += '-' + std::to_string(document.tests.size());
                document.tests.push_back(std::make_shared<const Test>(std::move(another)));
            }
        }
        const Report report = reportOf(document, language);
        const QStringList ofBlocks = faultsOfBlocks(report);
        for (const QString &fault : ofBlocks)
            faults << u"seed %1, %2"_s.arg(seed).arg(fault);
        for (const QString &fault : faultsOf(report)) {
            nearlyEmpty += fault.contains(u"last page"_s) ? 1 : 0;
            const QString said = u"seed %1, %2"_s.arg(seed).arg(fault);
            if (fault.contains(u"last page"_s))
                qInfo().noquote() << said;
            else
                faults << said;
        }
    }
    qInfo().noquote() << u"%1 reports, %2 faults, %3 last pages nearly empty"_s.arg(count)
                             .arg(faults.size())
                             .arg(nearlyEmpty);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
    QVERIFY2(nearlyEmpty <= 1 + count / 100, qPrintable(QString::number(nearlyEmpty)));
}

/// Those of kinds that are not generated: a sheet, several tests with editions side by side, a long axis.
void TypographyTest::storedReportsAreSetWell() {
    QStringList faults;
    for (const QString &name : {u"machine-acceptance-sheet"_s, u"mixed"_s, u"long-axis-with-zone"_s}) {
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            const Report report = reportOf(storedDocument(name), language);
            for (const QString &fault : faultsOfBlocks(report) + faultsOf(report))
                faults << name + u": "_s + fault;
        }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
}

/// However small the paper, all rows and the small print are on one page.
void TypographyTest::resultsKeepTheirSmallPrint() {
    for (const QString &name : {u"budget-2006"_s, u"limits-2006"_s}) {
        for (const Paper paper : {Paper::a4, Paper::letter}) {
            Document document = storedDocument(name);
            document.report.paper = paper;
            const QStringList pages = pageTexts(pdfOf(reportOf(document, Language::Id::english)));
            int smallPrints = 0;
            for (const QString &page : pages) {
                const qsizetype print = page.indexOf(u"U: expanded uncertainty"_s);
                smallPrints += print < 0 ? 0 : 1;
                for (const QString &row :
                     {u"Bi-directional accuracy of positioning"_s, u"Mean reversal value"_s})
                    QVERIFY2(print < 0 || page.first(print).contains(row), qPrintable(page));
            }
            QCOMPARE(smallPrints, 1);
        }
    }
}

void TypographyTest::frenchTextsHaveTheirSpaces() {
    QVERIFY(!frenchFaults(u"Limite: 3"_s).isEmpty());
    QVERIFY(!frenchFaults(u"une ; deux"_s).isEmpty());
    QVERIFY(frenchFaults(u"à 10:15, ISO 230-2:2006 ; deux"_s.replace(u" ;"_s, u"\u202F;"_s)).isEmpty());
    for (const QString &name : {u"iso230-2-1988-example"_s, u"iso230-4-full-circles-xy"_s}) {
        const QStringList faults =
            frenchFaults(pageText(reportOf(storedDocument(name), Language::Id::french)));
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
    }
}

/// The rule itself: nm below µm is one fault, the unit of the column and other columns are none.
void TypographyTest::rowsInAnotherUnitAreFaults() {
    const auto faultsWith = [](const QString &name, const QString &value) {
        Table table;
        table.columns.resize(3);
        table.columns[1].unit = u"µm"_s;
        table.rows = {{Cell{name}, Cell{value}, Cell{u"3 mm"_s}}};
        return otherUnits(table).size();
    };
    QCOMPARE(faultsWith(u"A"_s, u"12.3"_s), 0);
    QCOMPARE(faultsWith(u"A (µm)"_s, u"12.3 µm"_s), 0);
    QVERIFY(faultsWith(u"A (nm)"_s, u"12.3"_s) > 0);
    QVERIFY(faultsWith(u"A"_s, u"12 nm"_s) > 0);
    QCOMPARE(faultsWith(u"A"_s, u"4 nm/K"_s), 0); // another quantity
}

QTEST_MAIN(TypographyTest)
#include "typography.moc"
