// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/composereport.h"

#include "document/visibletexts.h"
#include "document/windowthread.h"
#include "document/writedocument.h"
#include "figures/thinning.h"
#include "language/papercharacters.h"
#include "report/blocks/pagetext.h"
#include "report/parts/parts.h"

#include <QHash>
#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace palmer {

namespace {

std::vector<EvaluatedDocument> viewsOf(const EvaluatedDocument &evaluated) {
    std::vector<EvaluatedDocument> views;
    for (const std::string &word : evaluated.document->report.editions)
        views.push_back(evaluate(evaluated.document, nullptr, word));
    return views;
}

std::vector<TestPart> testParts(const EvaluatedDocument &evaluated, const Writer &write,
                                const std::vector<EvaluatedDocument> &views, bool annex) {
    std::vector<TestPart> parts;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (evaluated.tests[i]->edition) // drift tests have no page
            parts.push_back({write, evaluated, *evaluated.document->tests[i], *evaluated.tests[i], i,
                             static_cast<int>(parts.size()) + 1, 0, &views, annex});
    }
    for (TestPart &part : parts)
        part.count = static_cast<int>(parts.size());
    return parts;
}

/// The remarks of a test, with those of the report if this is its only test.
QString remarksBeside(const TestPart &part) {
    QStringList remarks{QString::fromStdString(part.test.remarks)};
    if (part.count == 1)
        remarks << QString::fromStdString(part.head().remarks);
    return joined(remarks, QStringLiteral("\n"));
}

/// Adds the first page of a test: head, verdict, figure and results.
void addFirstPage(std::vector<Block> &blocks, const PositioningPart &part) {
    blocks.emplace_back(positioningHead(part));
    addVerdict(blocks, part);
    addFigure(blocks, part);
    addResults(blocks, part);
}

void addFirstPage(std::vector<Block> &blocks, const CircularPart &part) {
    blocks.emplace_back(circularHead(part));
    addVerdict(blocks, part);
    addActualPaths(blocks, part);
    addResults(blocks, part);
}

/// Adds what the readings were corrected by and which have no part in the results.
void addChanges(std::vector<Block> &blocks, const PositioningPart &part) {
    addExcludedReadings(blocks, part);
    addCorrection(blocks, part);
}

void addChanges(std::vector<Block> &blocks, const CircularPart &part) {
    if (part.count == 1) // otherwise in one section for all tests
        addCorrection(blocks, part);
}

/// Adds the sections of the annex that only a test of this kind has.
void addData(std::vector<Block> &blocks, const PositioningPart &part) {
    addTargetsAndReadings(blocks, part);
}

void addData(std::vector<Block> &blocks, const CircularPart &part) {
    if (part.count == 1)
        addPaths(blocks, part);
    addCircles(blocks, part);
    addRepetitions(blocks, part);
}

/// Adds what follows the results in the certificate of the only test.
void addCertificate(std::vector<Block> &blocks, const TestPart &part) {
    withKind(part, [&](const auto &own) {
        if constexpr (requires { addSeparateFigures(blocks, own); })
            addSeparateFigures(blocks, own);
        addConditions(blocks, own);
    });
    addAgreedPoints(blocks, part);
    addTraceability(blocks, part.write, part.evaluated);
    addFindings(blocks, part);
    addRemarks(blocks, part, remarksBeside(part));
    if (part.annex)
        return;
    addLimits(blocks, part);
    withKind(part, [&](const auto &own) { addChanges(blocks, own); });
}

/// Adds the sections of a test in the annex.
void addAnnex(std::vector<Block> &blocks, const TestPart &part) {
    withKind(part, [&](const auto &own) {
        if constexpr (requires { addSeparateFigures(blocks, own); }) {
            if (part.count > 1)
                addSeparateFigures(blocks, own);
        }
        addData(blocks, own);
        addChanges(blocks, own);
        if (part.count > 1)
            addTemperatureCurve(blocks, own);
    });
    if (part.count == 1)
        addFurtherConditions(blocks, part);
    addBudget(blocks, part);
    if (part.count == 1) {
        addLimits(blocks, part);
        addEditions(blocks, part);
    }
    addFurtherFindings(blocks, part);
    addImports(blocks, part);
}

/// Adds the pages of interpretation.
void addDiagnosisOf(std::vector<Block> &blocks, const TestPart &part) {
    withKind(part, [&](const auto &own) {
        if constexpr (requires { addDiagnosis(blocks, own); })
            addDiagnosis(blocks, own);
    });
}

/// Thins figures to what paper resolves, because a report is copied with its figures.
void thinFigures(std::vector<Block> &blocks) {
    for (Block &each : blocks) {
        auto *block = std::get_if<FigureBlock>(&each);
        const auto *figure = block ? std::get_if<CurveFigure>(&*block->figure) : nullptr;
        if (figure && !isOrdinary(*figure))
            block->figure = thinned(*figure);
    }
}

/// Packs the tables from block `first` on: those of a thousand tests would take most of the memory.
void packTables(std::vector<Block> &blocks, std::size_t first) {
    for (std::size_t i = first; i < blocks.size(); ++i) {
        if (auto *table = std::get_if<Table>(&blocks[i]); table && table->links.empty())
            packRows(*table);
    }
}

bool beginsSection(const Block &block) {
    if (const auto *both = std::get_if<SideBySide>(&block))
        return !both->left.empty() && std::holds_alternative<Heading>(both->left.front());
    const auto *heading = std::get_if<Heading>(&block);
    return heading && heading->level <= 2;
}

/// The sections of earlier tests, for finding repetitions. They stay where they are in the report and are
/// found by what they say: a thousand tests have ten thousand.
class PrintedSections {
public:
    /// Replaces sections that are identical in an earlier test by a line that refers to it.
    void leaveOutRepeated(std::vector<Block> &blocks, std::size_t from, const TestPart &part) {
        std::vector<std::pair<Section, Section *>> kept; // and what is remembered of it
        std::map<int, QStringList> repeated;             // by test number
        std::size_t place = from;                        // of that line
        std::size_t size = from;                         // of what is kept
        for (std::size_t i = from; i < blocks.size();) {
            std::size_t end = i + 1;
            while (end < blocks.size() && !beginsSection(blocks[end]))
                ++end;
            const auto *heading = std::get_if<Heading>(&blocks[i]);
            // The content of a level 1 heading is in the sections after it, which may differ.
            const bool known = heading && heading->level > 1 && heading->anchor.isEmpty() && end > i + 1;
            const std::size_t words = known ? wordsOf(blocks, i, end) : 0;
            const Section section{part.number, i, end};
            const Section *same = known ? sameAs(blocks, section, words) : nullptr;
            if (same) {
                repeated[same->test] << heading->text;
                place = size;
            } else {
                kept.emplace_back(section, known ? &m_sections.emplace(words, section)->second : nullptr);
                size += end - i;
            }
            i = end;
        }
        QStringList lines;
        for (const auto &[test, headings] : repeated)
            lines << part.write.say(
                REPORT_TEXT("report", "As for test %1: %2."),
                {std::to_string(test), headings.join(part.write.semicolon()).toStdString()});
        if (lines.isEmpty())
            return;
        std::vector<Block> result;
        for (const auto &[section, remembered] : kept) {
            const std::size_t begin = from + result.size() + (from + result.size() >= place ? 1 : 0);
            if (remembered)
                *remembered = {section.test, begin, begin + section.end - section.begin};
            result.insert(result.end(), std::make_move_iterator(at(blocks, section.begin)),
                          std::make_move_iterator(at(blocks, section.end)));
        }
        result.insert(result.begin() + static_cast<std::ptrdiff_t>(place - from),
                      Paragraph{lines.join(u'\n'), TextSize::small});
        blocks.resize(from);
        blocks.insert(blocks.end(), std::make_move_iterator(result.begin()),
                      std::make_move_iterator(result.end()));
    }

private:
    struct Section {
        int test = 1;
        std::size_t begin = 0; ///< in the report
        std::size_t end = 0;
    };

    static std::vector<Block>::iterator at(std::vector<Block> &blocks, std::size_t index) {
        return blocks.begin() + static_cast<std::ptrdiff_t>(index);
    }

    static std::size_t wordsOf(const std::vector<Block> &blocks, std::size_t begin, std::size_t end) {
        std::size_t words = 0;
        for (std::size_t i = begin; i < end; ++i)
            eachPageLine(blocks[i], [&words](const QString &line) { words = qHash(line, words); });
        return words;
    }

    /// The first section that is equal; null if there is none.
    const Section *sameAs(std::vector<Block> &blocks, const Section &section, std::size_t words) const {
        const Section *first = nullptr;
        const auto [from, to] = m_sections.equal_range(words);
        for (auto each = from; each != to; ++each) {
            const Section &other = each->second;
            if ((!first || other.begin < first->begin) &&
                std::equal(at(blocks, other.begin), at(blocks, other.end), at(blocks, section.begin),
                           at(blocks, section.end)))
                first = &other;
        }
        return first;
    }

    std::unordered_multimap<std::size_t, Section> m_sections; ///< by their words
};

/// Adds what follows the summary of several tests: one page per test with its results, and the common
/// statements.
void addCertificates(std::vector<Block> &blocks, const std::vector<TestPart> &parts,
                     const std::stop_token &stop) {
    const Writer &write = parts.front().write;
    const ReportHead &head = parts.front().head();
    for (const TestPart &part : parts) {
        if (stop.stop_requested())
            return;
        blocks.emplace_back(PageBreak{});
        blocks.emplace_back(runningHead(part));
        const std::size_t first = blocks.size();
        withKind(part, [&](const auto &own) { addFirstPage(blocks, own); });
        packTables(blocks, first);
    }
    // Precedes the break because the page has no head of its own.
    blocks.emplace_back(RunningHead{QString::fromStdString(head.laboratory.name), reportTitle(write, head)});
    blocks.emplace_back(PageBreak{});
    blocks.emplace_back(Heading{1, write.text(REPORT_TEXT("report", "All tests"))});
    addConditionsOfTests(blocks, parts);
    addAgreedPointsOfTests(blocks, parts);
    addLimitsOfTests(blocks, parts);
    addBeforeAndAfter(blocks, parts);
    addRemarksOfTests(blocks, parts);
    addDriftTests(blocks, write, parts.front().evaluated);
    addTraceability(blocks, write, parts.front().evaluated);
    for (const TestPart &part : parts)
        addFindings(blocks, part);
    if (parts.front().annex)
        return;
    for (const TestPart &part : parts)
        withKind(part, [&](const auto &own) { addChanges(blocks, own); });
}

/// Adds what the annex says of several tests, then each without page breaks.
void addAnnexes(std::vector<Block> &blocks, const std::vector<TestPart> &parts, const std::stop_token &stop) {
    const Writer &write = parts.front().write;
    addPathsOfTests(blocks, parts);
    addComparisonsOfTests(blocks, parts);
    PrintedSections printed;
    for (const TestPart &part : parts) {
        if (stop.stop_requested())
            return;
        const std::size_t first = blocks.size();
        const RunningHead running = runningHead(part);
        addAnnex(blocks, part);
        packTables(blocks, first);
        const std::size_t ofTest = blocks.size();
        addDiagnosisOf(blocks, part);
        if (blocks.size() > ofTest)
            blocks.emplace_back(PageBreak{});
        if (blocks.size() == first)
            continue; // everything was left out
        const std::array<Block, 2> heading{
            running, Heading{1,
                             write.say(REPORT_TEXT("report", "Test %1: %2"),
                                       {std::to_string(part.number), running.right.toStdString()}),
                             QString::fromStdString(part.test.title)}};
        blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(first), heading.begin(), heading.end());
        printed.leaveOutRepeated(blocks, first, part);
    }
    blocks.emplace_back(annexRunningHead(parts));
}

/// "U+6F22, U+5B57": characters in the report so far that the paper font lacks.
QString foreignCharacters(const Report &report) {
    constexpr std::size_t most = 20;
    constexpr int hexadecimal = 16;
    constexpr int digits = 4;
    std::set<char32_t> foreign;
    for (const Block &block : report.blocks) {
        eachPageLine(block, [&foreign](const QString &line) {
            const std::vector<char32_t> more = notOnPaper(line);
            foreign.insert(more.begin(), more.end());
        });
    }
    QStringList names;
    for (const char32_t character : foreign) {
        if (names.size() == most) {
            names << QStringLiteral("…");
            break;
        }
        names << QStringLiteral("U+%1")
                     .arg(static_cast<uint>(character), digits, hexadecimal, QLatin1Char('0'))
                     .toUpper();
    }
    return names.join(QStringLiteral(", "));
}

std::vector<int> simulatedTests(const EvaluatedDocument &evaluated) {
    std::vector<int> result;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (evaluated.tests[i]->uncertainty.simulation)
            result.push_back(static_cast<int>(i) + 1);
    }
    return result;
}

/// The usual title speaks of an acceptance only where the sheet or a test states it; else it is "Test
/// report".
std::shared_ptr<const Document> withTitle(std::shared_ptr<const Document> document,
                                          const Language &language) {
    const ReportHead &head = document->report;
    const auto isAcceptance = [](const auto &test) { return test->purpose == Purpose::acceptance; };
    if (!head.title.empty() || !head.sheet.empty() || std::ranges::any_of(document->tests, isAcceptance))
        return document;
    auto titled = std::make_shared<Document>(*document);
    titled->report.title = language.text(REPORT_TEXT("report", "Test report")).toStdString();
    return titled;
}

/// Edition of a view; empty for a report under the editions of the file.
QString viewedEdition(const EvaluatedDocument &evaluated) {
    const auto found = std::ranges::find_if(evaluated.tests, [](const auto &test) { return test->view; });
    return found == evaluated.tests.end() ? QString() : QString::fromUtf8((*found)->edition->word);
}

/// Ends the certificate and adds what follows it. A single test ends with its diagnosis, for the pages of
/// interpretation stand alone.
void addAnnexOfReport(Report &report, const std::vector<TestPart> &parts, const std::stop_token &stop) {
    const TestPart &first = parts.front();
    const Document &document = first.document();
    const bool several = parts.size() > 1;
    std::vector<Block> &blocks = report.blocks;
    const QString anchor = QStringLiteral("annex");
    blocks.emplace_back(
        EndMark{first.write.text(REPORT_TEXT(
                    "report", "End of the certificate. The annex from page %1 on is part of this report.")),
                anchor});
    blocks.insert(blocks.end(), {PageBreak{}, annexRunningHead(parts), annexHead(parts, anchor)});
    several ? addAnnexes(blocks, parts, stop) : addAnnex(blocks, first);
    report.certificatePages = static_cast<int>(2 * parts.size()) + several + !document.report.sheet.empty();
    addProgram(blocks, first.write, first.evaluated, report.making, report.fingerprint,
               foreignCharacters(report), several ? 1 : 2);
    if (!several)
        addDiagnosisOf(blocks, first);
}

/// Leaves no more rows of a table than a page may hold, and all that a cell of them spans.
void keepFirstRows(Table &table) {
    constexpr std::size_t most = 120;
    std::size_t end = 0;
    for (std::size_t i = 0; i < table.rows.size() && (i < most || i < end); ++i) {
        for (const Cell &cell : table.rows[i])
            end = std::max(end, i + cell.extras->rows);
    }
    if (end >= table.rows.size())
        return;
    table.rows.resize(end);
    if (!table.links.empty())
        table.links.resize(end);
    for (auto *rules : {&table.rulesAfter, &table.strongRulesAfter})
        std::erase_if(*rules, [end](std::size_t row) { return row >= end; });
}

/// Hands over what the first page may hold: it is soon laid out, however long the report.
void announceFirstPage(const Report &report, const ReportOptions &options) {
    if (!options.onFirstPage)
        return;
    Report first = report;
    for (Block &block : first.blocks) {
        if (auto *table = std::get_if<Table>(&block))
            keepFirstRows(*table);
    }
    thinFigures(first.blocks);
    options.onFirstPage(first);
}

} // namespace

Report composeReport(const EvaluatedDocument &given, const Language &language, const ReportOptions &options) {
    requireBackground(*given.document);
    Report report;
    report.testFile =
        options.testFile.isEmpty() ? attachedFile(*given.document, options.originals) : options.testFile;
    report.testFileName = attachedFileName(*given.document);
    report.fingerprint = fingerprint(report.testFile);
    EvaluatedDocument evaluated = given;
    evaluated.document = withVisibleTexts(
        given.document, options.testFile.isEmpty() ? report.testFile : writeDocument(*given.document));
    evaluated.document = withTitle(std::move(evaluated.document), language);
    const Document &document = *evaluated.document;
    const ReportHead &head = document.report;
    const Writer write(language);
    const std::string number = head.number.empty() ? "–" : head.number;

    report.language = language.code();
    report.paper = head.paper;
    report.title =
        joined({reportTitle(write, head), QString::fromStdString(head.number)}, QStringLiteral(" "));
    report.laboratory = QString::fromStdString(head.laboratory.name);
    report.date = QString::fromStdString(head.date.value_or(std::string()));
    report.making = {options.program, options.selfTestPassed, simulatedTests(evaluated),
                     viewedEdition(evaluated)};
    report.footerLeft = write.say(REPORT_TEXT("report", "Report %1"), {number});
    report.footerCentre =
        write.say(REPORT_TEXT("report", "Fingerprint SHA-256 %1"), shortFingerprint(report.fingerprint));
    report.footerRight = write.text(REPORT_TEXT("report", "page %1 / %2"));

    const std::vector<EvaluatedDocument> views = viewsOf(evaluated);
    const bool hasSheet = !head.sheet.empty();
    report.making.annex =
        options.annex &&
        std::ranges::any_of(evaluated.tests, [](const auto &test) { return test->edition != nullptr; }) &&
        std::ranges::find(head.leaveOut, ReportPart::annex) == head.leaveOut.end();
    const std::vector<TestPart> parts = testParts(evaluated, write, views, report.making.annex);
    const bool several = parts.size() > 1;
    std::vector<Block> &blocks = report.blocks;
    if (hasSheet) {
        addSheet(blocks, evaluated, parts, write);
        announceFirstPage(report, options);
        if (!parts.empty())
            blocks.emplace_back(PageBreak{});
    }
    if (several) {
        addSummary(blocks, parts);
        if (!hasSheet)
            announceFirstPage(report, options);
        addCertificates(blocks, parts, options.stop);
    } else if (!parts.empty()) {
        blocks.emplace_back(runningHead(parts.front()));
        withKind(parts.front(), [&](const auto &own) { addFirstPage(blocks, own); });
        if (!hasSheet)
            announceFirstPage(report, options);
        addCertificate(blocks, parts.front());
    } else {
        if (!hasSheet)
            blocks.emplace_back(driftHead(write, document));
        if (!head.remarks.empty()) {
            addHeading(blocks, write.text(REPORT_TEXT("report", "Remarks")));
            blocks.emplace_back(Paragraph{QString::fromStdString(head.remarks)});
        }
        addTraceability(blocks, write, evaluated);
    }
    if (!several) {
        addDriftTests(report.blocks, write, evaluated);
    }
    if (parts.empty())
        addThermalPages(report.blocks, evaluated, write);
    addStatements(report.blocks, write, evaluated, report.making, report.fingerprint,
                  foreignCharacters(report), several ? 1 : 2);
    if (report.making.annex)
        addAnnexOfReport(report, parts, options.stop);
    if (several)
        addStatedComparisons(blocks, parts);
    if (report.making.annex)
        addThermalPages(blocks, evaluated, write);
    thinFigures(blocks);
    blocks.emplace_back(EndMark{write.text(REPORT_TEXT("report", "End of the report"))});
    return report;
}

} // namespace palmer
