// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/proof/verifyreport.h"

#include "document/readdocument.h"
#include "export/dcc.h"
#include "export/resultsjson.h"
#include "language/papercharacters.h"
#include "print/pdf/pages.h"
#include "print/pdf/textblock.h"
#include "print/pdf/writepdf.h"
#include "print/proof/pdfpages.h"
#include "proof/compare.h"
#include "proof/deviation.h"
#include "report/blocks/pagetext.h"
#include "report/composereport.h"
#include "report/tables/resulttable.h"
#include "report/words/formula.h"
#include "report/words/wording.h"

#include <QBuffer>
#include <QPainter>
#include <algorithm>
#include <string>

namespace palmer {

namespace {

constexpr double sizeTolerance = 0.01;    ///< points: sizes are written with two decimals
constexpr std::size_t fewDifferences = 5; ///< on a page with the same layout in another version

Document attachedDocument(const QByteArray &testFile) {
    try {
        return readDocument(testFile);
    } catch (Error &error) {
        error.place = "test file" + (error.place.empty() ? std::string() : ": " + error.place);
        throw;
    }
}

/// Words of a page that intersect `area`.
QString wordsIn(const PrintedWords &words, const QRectF &area) {
    constexpr qsizetype longest = 120;
    QStringList found;
    for (const PrintedWord &word : words) {
        if (word.area.intersects(area))
            found << word.text;
    }
    const QString text = found.join(u' ');
    return text.size() > longest ? text.left(longest) + u'…' : text;
}

constexpr QChar replacement(u'\uFFFD');

/// Areas of the report with characters that the paper font lacks, by page; empty if there are none. Another
/// program does not know them all: some glyphs do not state their character.
std::vector<std::vector<QRectF>> foreignPlaces(const Report &report) {
    std::vector<std::vector<QRectF>> result;
    if (notOnPaper(pageText(report)).empty())
        return result;
    ForeignPlaces places;
    LaidOutReport laidOut(report);
    for (std::size_t i = 0; i < laidOut.pageCount(); ++i) {
        QImage nowhere(1, 1, QImage::Format_RGB32);
        QPainter painter(&nowhere);
        drawPage(painter, laidOut.page(i));
        result.push_back(places.take());
    }
    return result;
}

/// Area that another font may cover for a character: such fonts are higher.
QRectF coveredBy(const QRectF &foreign) {
    const double above = foreign.height() / 2;
    return foreign.adjusted(-2, -above, 2, above);
}

/// Text of a page in the paper font, unordered: readers may change it next to other fonts.
struct OwnText {
    QStringList words;     ///< words away from characters of other fonts, sorted
    std::u32string beside; ///< characters of the other words, sorted

    bool operator==(const OwnText &) const = default;
};

OwnText ownText(const PrintedWords &words, const std::vector<QRectF> &foreign) {
    OwnText result;
    for (const PrintedWord &word : words) {
        const bool isBeside = std::ranges::any_of(
            foreign, [&](const QRectF &area) { return coveredBy(area).intersects(word.area); });
        if (!isBeside) {
            result.words << word.text;
            continue;
        }
        for (const char32_t character : word.text.toUcs4()) {
            if (isOnPaper(character) && character != replacement.unicode())
                result.beside += character;
        }
    }
    result.words.sort();
    std::ranges::sort(result.beside);
    return result;
}

/// A picture at 72 dpi with these areas cleared.
QImage without(QImage picture, const std::vector<QRectF> &areas) {
    for (const QRectF &area : areas) {
        const QRect wiped = coveredBy(area).toAlignedRect() & picture.rect();
        for (int y = wiped.top(); y <= wiped.bottom(); ++y) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): pixels, as QImage has it
            auto *line = reinterpret_cast<QRgb *>(picture.scanLine(y));
            std::fill(line + wiped.left(), line + wiped.right() + 1, qRgb(255, 255, 255));
        }
    }
    return picture;
}

/// Bounding box of all pixels that differ; empty if none do.
QRectF differingArea(const QImage &a, const QImage &b) {
    if (a.size() != b.size())
        return {0, 0, static_cast<double>(a.width()), static_cast<double>(a.height())};
    QRectF area;
    for (int y = 0; y < a.height(); ++y) {
        // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): pixels, as QImage has it
        const auto *left = reinterpret_cast<const QRgb *>(a.constScanLine(y));
        const auto *right = reinterpret_cast<const QRgb *>(b.constScanLine(y));
        // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
        for (int x = 0; x < a.width(); ++x) {
            if (left[x] != right[x])
                area |= QRectF(x, y, 1, 1);
        }
    }
    return area;
}

/// Rows printed by the tables of results and the verdict lines.
std::vector<PrintedRow> rowsOf(const EvaluatedDocument &evaluated, const Report &composed,
                               const Language &language) {
    std::vector<PrintedRow> rows;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        const Test &test = *evaluated.document->tests[i];
        for (const PrintedResult &result :
             printedResults(*evaluated.document, test, *evaluated.tests[i], language)) {
            const Parameter &parameter = *result.parameter;
            if (result.value.isEmpty())
                continue;
            PrintedRow row{symbolFormula(parameter).plain(),
                           {result.value, result.uncertainty, result.limit}};
            if (parameter.verdict)
                row.values << language.text(limitText(*parameter.verdict));
            row.values.removeAll(QString());
            rows.push_back(std::move(row));
        }
    }
    for (const Block &block : composed.blocks) {
        const auto *verdict = std::get_if<VerdictLine>(&block);
        if (verdict && !verdict->word.isEmpty())
            rows.push_back({verdict->word, {}}); // larger than its label, and therefore on a separate line
        if (verdict && !verdict->second.isEmpty())
            rows.push_back({verdict->second, {}});
    }
    return rows;
}

/// The values, units and uncertainties of a digital calibration certificate.
QByteArrayList numbersOf(const QByteArray &certificate) {
    QByteArrayList result;
    for (const QByteArray &line : certificate.split('\n')) {
        if (line.trimmed().startsWith("<si:"))
            result << line.trimmed();
    }
    return result;
}

class PageComparison {
public:
    PageComparison(const OpenedReport &report, const Report &composed, const Language &language,
                   const QByteArray &pdf, Verification &result)
        : m_report(report)
        , m_composed(composed)
        , m_fingerprint(shortFingerprint(composed.fingerprint))
        , m_language(language)
        , m_printed(openPages(report.pdf))
        , m_follows(openPages(pdf))
        , m_foreign(foreignPlaces(composed))
        , m_result(result) {}

    void run(bool sameProgram) {
        const int pages = std::min(m_printed->count(), m_follows->count());
        for (int page = 0; page < pages; ++page)
            compare(page, sameProgram);
        if (sameProgram && m_printed->count() != m_follows->count())
            m_result.differences.push_back(otherPageCount(m_printed->count(), m_follows->count()));
        if (!sameProgram)
            compareRowsOfResults();
        m_result.signatures = m_printed->signatures();
        for (const SignatureStatement &signature : m_result.signatures) {
            if (signature.state == SignatureStatement::State::broken)
                m_result.differences.push_back(brokenSignature(signature.signer));
        }
    }

private:
    /// For another version, whose layout may differ.
    void compareRowsOfResults() {
        std::vector<PrintedWords> pages;
        pages.reserve(static_cast<std::size_t>(m_printed->count()));
        for (int page = 0; page < m_printed->count(); ++page)
            pages.push_back(m_printed->words(page));
        for (Difference &difference :
             compareRows(pages, rowsOf(m_report.evaluated, m_composed, m_language))) {
            const bool isNamed = std::ranges::any_of(m_result.differences, [&](const Difference &other) {
                return other.page == difference.page && other.area.intersects(difference.area);
            });
            if (!isNamed)
                m_result.differences.push_back(std::move(difference));
        }
    }

    void compare(int page, bool sameProgram) {
        const QSizeF size = m_printed->size(page) - m_follows->size(page);
        if (std::abs(size.width()) > sizeTolerance || std::abs(size.height()) > sizeTolerance) {
            m_result.differences.push_back(otherPageSize(page + 1));
            return;
        }
        const PrintedWords printed = m_printed->words(page);
        const PrintedWords follows = m_follows->words(page);
        QStringList words;
        for (const PrintedWord &word : printed)
            words << word.text;
        m_result.fingerprintPrinted &= words.join(u' ').contains(m_fingerprint);
        // Other fonts, or missing ones, do not count.
        const auto index = static_cast<std::size_t>(page);
        const std::vector<QRectF> foreign =
            index < m_foreign.size() ? m_foreign[index] : std::vector<QRectF>();
        const bool same = !foreign.empty() && ownText(printed, foreign) == ownText(follows, foreign);
        const std::vector<Difference> found =
            same ? std::vector<Difference>() : compareWords(printed, follows, page + 1);
        const bool sameLayout = printed.size() == follows.size() && found.size() <= fewDifferences;
        for (const Difference &difference : found) {
            const bool counts = sameProgram || (sameLayout && isSerious(difference));
            (counts ? m_result.differences : m_result.wording).push_back(difference);
        }
        if (found.empty())
            comparePictures(page, follows, foreign, sameProgram);
        requireFree(page + 1, follows);
    }

    /// If the words are the same, the pictures must be, too.
    void comparePictures(int page, const PrintedWords &words, const std::vector<QRectF> &foreign,
                         bool sameProgram) {
        const QRectF area = differingArea(without(m_printed->picture(page), foreign),
                                          without(m_follows->picture(page), foreign));
        if (area.isEmpty())
            return;
        (sameProgram ? m_result.differences : m_result.wording)
            .push_back(drawnOtherwise(page + 1, area, wordsIn(words, area)));
    }

    /// A signature picture must not hide printed text.
    void requireFree(int page, const PrintedWords &words) {
        for (const SignatureField &field : m_report.parts.signatureFields) {
            const QString covered = field.page == page ? wordsIn(words, field.area) : QString();
            if (!covered.isEmpty())
                m_result.differences.push_back(coveredBySignature(page, field.area, covered));
        }
    }

    /// True for numbers, dates and verdicts; other words may change with the version of the program.
    [[nodiscard]] bool isSerious(const Difference &difference) const {
        const QString both = difference.printed + u' ' + difference.follows;
        if (std::ranges::any_of(both, [](QChar c) { return c.isDigit(); }))
            return true;
        for (const Verdict verdict : {Verdict::conforms, Verdict::notProven, Verdict::doesNotConform}) {
            for (const Text &text : {verdictText(verdict), limitText(verdict), limitsText(verdict, true)}) {
                const QStringList words = m_language.text(text).split(u' ');
                for (const QString &word : both.split(u' ')) {
                    if (words.contains(word, Qt::CaseInsensitive))
                        return true;
                }
            }
        }
        return false;
    }

    const OpenedReport &m_report;
    const Report &m_composed;
    QString m_fingerprint;
    const Language &m_language;
    std::unique_ptr<PdfPages> m_printed;
    std::unique_ptr<PdfPages> m_follows;
    std::vector<std::vector<QRectF>> m_foreign; ///< by page
    Verification &m_result;
};

} // namespace

std::optional<OpenedReport> openReport(const QByteArray &pdf, int threads, const std::stop_token &stop,
                                       const std::function<void(const SimulationProgress &)> &progress) {
    OpenedReport result{pdf, readReportPdf(pdf, Carried::testFileOrHistory), {}};
    if (result.parts.isHistory)
        return result;
    result.evaluated = evaluate(std::make_shared<const Document>(attachedDocument(result.parts.testFile)),
                                nullptr, result.parts.metadata.making.edition.toStdString());
    for (const int number : result.parts.metadata.making.simulated) {
        const std::size_t test = static_cast<std::size_t>(number) - 1;
        if (test >= result.evaluated.tests.size())
            continue; // the recomputed report lacks it and differs
        SimulationOptions options = simulationOptions(*result.evaluated.document->tests[test]);
        options.threads = threads;
        auto simulation = simulateTest(result.evaluated, test, options, stop, progress);
        if (stop.stop_requested())
            return std::nullopt;
        if (simulation)
            result.evaluated = withSimulation(result.evaluated, test, std::move(*simulation));
    }
    return result;
}

namespace {

Report composedAgain(const OpenedReport &report, const Language &language, HistoryComposer history) {
    if (report.parts.isHistory)
        return history(report.parts.testFile, language);
    const Making &making = report.parts.metadata.making;
    return composeReport(
        report.evaluated, language,
        {making.program, making.selfTestPassed, {}, report.parts.testFile, {}, making.annex});
}

} // namespace

Verification verifyReport(const OpenedReport &report, HistoryComposer history) {
    const ReportMetadata &metadata = report.parts.metadata;
    const Language language = Language::fromName(metadata.language).value_or(Language(Language::Id::english));
    const Report composed = composedAgain(report, language, history);
    const bool isHistory = report.parts.isHistory;
    const QByteArray results = isHistory ? QByteArray() : attachedResults(report.evaluated);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const bool certified =
        !isHistory && !report.parts.certificate.isEmpty() && missingForDcc(report.evaluated).empty();
    const QByteArray certificate = certified ? dcc(report.evaluated) : QByteArray();
    writePdf(composed, buffer, results, certificate);

    Verification result;
    result.ofHistory = isHistory;
    result.madeBy = metadata.making.program;
    result.fingerprint = composed.fingerprint;
    result.identical = report.pdf == buffer.data();
    if (result.identical)
        return result;
    result.appended = report.pdf.startsWith(buffer.data());
    const bool sameProgram = metadata.making.program == QLatin1StringView("Palmer " PALMER_VERSION);
    result.otherVersion = !sameProgram;
    for (const PdfAddition &addition : report.parts.additions)
        result.differences.push_back(differenceOf(addition));
    if (report.parts.certificate != certificate) {
        const bool sameNumbers = numbersOf(report.parts.certificate) == numbersOf(certificate);
        (sameProgram || !sameNumbers ? result.differences : result.wording).push_back(otherCertificate());
    }
    if (report.parts.testFileName != composed.testFileName)
        result.differences.push_back(otherFileName(report.parts.testFileName));
    if (sameProgram) {
        const QStringList follows = readReportPdf(buffer.data(), Carried::testFileOrHistory).beside;
        const auto [shown, expected] = std::ranges::mismatch(report.parts.beside, follows);
        if (shown != report.parts.beside.end() || expected != follows.end())
            result.differences.push_back(
                otherBeside(shown != report.parts.beside.end() ? *shown : QString()));
    }
    PageComparison(report, composed, language, buffer.data(), result).run(sameProgram);
    for (Difference &difference : compareResults(report.parts.results, results, sameProgram))
        result.differences.push_back(std::move(difference));
    return result;
}

} // namespace palmer
