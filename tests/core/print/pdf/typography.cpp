// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/pdf/generator.h"
#include "report/blocks/pagetext.h"

#include <QXmlStreamReader>
#include <algorithm>

using namespace palmer;
using namespace palmer::testdata;

namespace {

constexpr double mm = 72 / 25.4;
constexpr double leastFill = 0.45;

struct Line {
    QString first; ///< word
    QString last;  ///< word
    QRectF area;
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
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Page &page = pages[i];
        const auto say = [&](const QString &fault) { faults << u"page %1: %2"_s.arg(i + 1).arg(fault); };
        const QString text = squeezed(texts[static_cast<qsizetype>(i)]);
        for (std::size_t k = 0; k < page.lines.size(); ++k) {
            const Line &line = page.lines[k];
            if (line.area.left() < 20 * mm - 1 || line.area.right() > page.size.width() - 15 * mm + 1)
                say(u"outside the margins: "_s + line.first);
            if (k + 1 == page.lines.size())
                continue;
            const Line &next = page.lines[k + 1];
            const bool goesOn = std::abs(next.area.left() - line.area.left()) < mm &&
                                next.area.top() > line.area.top() &&
                                next.area.top() < line.area.bottom() + 0.5 * line.area.height();
            if (goesOn && forbiddenBreaks().match(line.last + u" \n"_s + next.first).hasMatch())
                say(u"broken: “%1|%2”"_s.arg(line.last, next.first));
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
/// and languages.
class TypographyTest : public QObject {
    Q_OBJECT

private slots:
    void pagesAreSetWell();
    void frenchTextsHaveTheirSpaces();
};

void TypographyTest::pagesAreSetWell() {
    constexpr int few = 12;
    const int count = qEnvironmentVariableIntValue("PALMER_REPORTS") > 0
                          ? qEnvironmentVariableIntValue("PALMER_REPORTS")
                          : few;
    int nearlyEmpty = 0;
    QStringList faults;
    for (int seed = 1; seed <= count; ++seed) {
        const auto language = seed % 2 == 0 ? Language::Id::french : Language::Id::english;
        const Report report = reportOf(Generator(static_cast<unsigned>(seed) + 5000).document(), language);
        for (const QString &fault : faultsOf(report)) {
            nearlyEmpty += fault.contains(u"last page"_s) ? 1 : 0;
            const QString said = u"seed %1, %2"_s.arg(seed).arg(fault);
            if (fault.contains(u"last page"_s))
                qInfo().noquote() << said;
            else
                faults << said;
        }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(u'\n')));
    QVERIFY2(nearlyEmpty <= 1 + count / 100, qPrintable(QString::number(nearlyEmpty)));
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

QTEST_MAIN(TypographyTest)
#include "typography.moc"
