// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "document/testsofverdict.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/conformity.h"
#include "report/tables/resulttable.h"
#include "report/words/accordancetext.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <map>
#include <span>

namespace palmer {

namespace {

// Widths around those of the result columns, mm.
constexpr double leastNumberWidth = 5;
constexpr double numberPadding = 2.3;
constexpr double numberDigit = 1.7;
constexpr double testWidth = 38.2;
constexpr double unitWidth = 5.6; ///< used if units differ between tests
constexpr double unitGap = 0.3;   ///< before the number
constexpr double pictureGap = 2.3;
constexpr double pageWidth = 9.2;

bool counts(const TestPart &part) {
    return countsForVerdict(part.document(), part.index);
}

bool isLimited(const Parameter &parameter, const ReportHead &head) {
    return isPrinted(parameter, head) && parameter.verdict && parameter.limit;
}

/// "X axis", "XY circle, R 150 mm".
QString briefTestName(const TestPart &part) {
    const Writer &write = part.write;
    const std::string stated = axesOf(part.test);
    const std::string axes = stated.empty() ? "–" : stated;
    const double radius = partOr(0.0, part.test.measurement,
                                 [](auto &m) -> decltype(m.nominalRadius) { return m.nominalRadius; });
    return write.say(kindWords(part.test).brief, {axes, Number{radius, Quantity::position, -1}});
}

/// The accordance in words, with the number of requirements that are not met or not declared.
QString countedWords(const Writer &write, Accordance accordance, const RequirementCounts &found) {
    if (accordance == Accordance::no)
        return write.language().sentence(
            {REPORT_TEXT_COUNTED("report", "%n requirement(s) not met"), {}, found.unmet});
    if (accordance == Accordance::notShown)
        return write.language().sentence(
            {REPORT_TEXT_COUNTED("report", "%n requirement(s) not declared"), {}, found.undeclared});
    return write.text(accordanceWords(accordance));
}

CellNote accordanceNote(const TestPart &part) {
    const Accordance accordance = part.evaluation.accordance();
    return {countedWords(part.write, accordance, countRequirements(part.evaluation.findings)),
            markOf(accordance)};
}

Cell testCell(const TestPart &part, bool pale) {
    const Text role = roleText(part.test.role);
    Cell cell = boldCell(joined({briefTestName(part), role.empty() ? QString() : part.write.text(role)}));
    cell.pale = pale;
    if (!part.test.title.empty())
        cell.extras.edit().notes.push_back({QString::fromStdString(part.test.title)});
    const QString date = part.test.date && !part.test.date->empty()
                             ? part.write.language().shortDate(*part.test.date)
                             : QString();
    cell.extras.edit().notes.push_back(
        {joined({date, QString::fromUtf8(part.edition().word)}, QStringLiteral(" · "))});
    cell.extras.edit().notes.push_back(accordanceNote(part));
    if (pale)
        cell.extras.edit().notes.push_back(
            {part.write.text(REPORT_TEXT("report", "for information, not part of the verdict"))});
    return cell;
}

/// Properties common to the tables of all tests; others are stated per row or not at all.
struct Shared {
    QString unit; ///< empty if they differ
    QString rule;
    CoverageOfResults coverage;
    bool band = false; ///< true if a limit has a guard band
};

Shared sharedBy(const std::vector<TestPart> &parts) {
    Shared shared;
    QStringList units;
    QStringList rules;
    for (const TestPart &part : parts) {
        const CoverageOfResults coverage = coverageOf(part.evaluation, part.head());
        shared.coverage.factor |= coverage.factor;
        shared.coverage.simulated.insert(shared.coverage.simulated.end(), coverage.simulated.begin(),
                                         coverage.simulated.end());
        for (const Parameter &parameter : part.evaluation.parameters) {
            if (!isLimited(parameter, part.head()))
                continue;
            units << part.write.language().unit(parameter.term.quantity);
            rules << ruleInShort(part);
            shared.band |= parameter.guardBand.has_value();
        }
    }
    units.removeDuplicates();
    rules.removeDuplicates();
    shared.unit = units.size() == 1 ? units.front() : QString();
    shared.rule = rules.size() == 1 ? rules.front() : QString();
    return shared;
}

class LimitedQuantities {
public:
    LimitedQuantities(const std::vector<TestPart> &parts, const Shared &shared)
        : m_parts(parts)
        , m_write(parts.front().write)
        , m_shared(shared) {
        addColumns();
        for (std::size_t i = 0; i < parts.size(); ++i)
            addTest(i);
        leaveOutEmptyColumns(m_table, m_units, m_units);
        leaveOutEmptyColumns(m_table, m_uncertainty, m_uncertainty);
    }

    [[nodiscard]] Table take() { return std::move(m_table); }

private:
    /// The result columns between the test and its page, and the unit before the picture.
    void addColumns() {
        Column test = m_write.column(REPORT_TEXT("report", "Test"), numberWidth());
        test.titleSpan = 2;
        test.paddingLeft = 1.2;
        m_table.columns = {test, columnOf(QString(), testWidth)};
        for (const ResultColumn &column : resultColumns()) {
            if (!(column.summaryWidth > 0))
                continue;
            if (column.look == ResultLook::picture) {
                m_units = m_table.columns.size();
                m_table.columns.push_back(columnOf(QString(), unitWidth));
                m_table.columns.back().paddingLeft = unitGap;
            }
            if (column.key == std::string_view("expandedUncertainty"))
                m_uncertainty = m_table.columns.size();
            m_table.columns.push_back(columnInSummary(column));
        }
        Column page = m_write.column(REPORT_TEXT("report", "Page"), pageWidth, Alignment::right);
        page.pages = true;
        m_table.columns.push_back(page);
    }

    /// The width of the column of the tests' numbers, which never wrap.
    [[nodiscard]] double numberWidth() const {
        const auto digits = static_cast<double>(std::to_string(m_parts.size()).size());
        return std::max(leastNumberWidth, numberPadding + digits * numberDigit);
    }

    [[nodiscard]] Column columnInSummary(const ResultColumn &column) const {
        if (column.look == ResultLook::name)
            return flexibleColumn(QString(), column.summaryWidth);
        const bool isNumber = column.look == ResultLook::number;
        Column result =
            m_write.column(column.title, column.summaryWidth, isNumber ? Alignment::decimal : Alignment::left,
                           isNumber ? m_shared.unit : QString());
        if (column.look == ResultLook::symbol) { // followed by the name
            result.title = m_write.text(resultColumn("name").title);
            result.titleSpan = 2;
        } else if (column.look == ResultLook::picture) {
            if (m_shared.band)
                result.title = m_write.text(REPORT_TEXT("report", "Limit ± U"));
            result.paddingLeft = pictureGap;
        } else if (column.look == ResultLook::verdict) {
            result.paddingLeft = 2; // from the picture
            result.fitting = true;
        } else if (column.key == std::string_view("expandedUncertainty")) {
            result.title = uncertaintyHead(m_shared.coverage, m_write.language());
        }
        return result;
    }

    void addTest(std::size_t index) {
        const TestPart &part = m_parts[index];
        const bool pale = !counts(part);
        const std::size_t first = m_table.rows.size();
        for (const Parameter &parameter : part.evaluation.parameters) {
            if (isLimited(parameter, part.head()))
                addResult(part, parameter, pale);
        }
        for (const AgreedLimit &limit : part.evaluation.limits) {
            if (std::ranges::none_of(part.evaluation.parameters, [&](const Parameter &parameter) {
                    return isLimited(parameter, part.head()) && parameter.limitOf == limit.key;
                }))
                addOpenLimit(part, limit, pale);
        }
        if (m_table.rows.size() == first)
            addWithoutLimit(part, pale);
        Cell number(QString::number(part.number));
        Cell test = testCell(part, pale);
        number.pale = pale;
        number.extras.edit().rows = test.extras.edit().rows = m_table.rows.size() - first;
        m_table.rows[first][0] = number;
        m_table.rows[first][1] = test;
        const bool last = index + 1 == m_parts.size();
        if (!last && part.test.role == TestRole::asFound &&
            m_parts[index + 1].test.role == TestRole::asLeft && !part.head().adjustments.empty())
            addAdjustment(part);
        else if (!last)
            m_table.strongRulesAfter.push_back(m_table.rows.size() - 1);
    }

    void addRow(const TestPart &part, std::vector<Cell> cells, bool pale) {
        for (Cell &cell : cells) {
            cell.pale = pale;
            cell.bold = cell.bold && !pale;
        }
        m_table.rows.push_back(std::move(cells));
        m_table.links.push_back(part.headAnchor());
    }

    void addResult(const TestPart &part, const Parameter &parameter, bool pale) {
        const PrintedResult result{printedNumbers(parameter, part.test, part.document(), m_write.language()),
                                   &parameter};
        std::vector<Cell> cells{blankCell(), blankCell()};
        for (const ResultColumn &column : resultColumns()) {
            if (column.summaryWidth > 0)
                addCell(cells, column, part, result);
        }
        cells.emplace_back();
        addRow(part, std::move(cells), pale);
    }

    void addCell(std::vector<Cell> &cells, const ResultColumn &column, const TestPart &part,
                 const PrintedResult &result) const {
        const Parameter &parameter = *result.parameter;
        switch (column.look) {
        case ResultLook::symbol:
            cells.push_back(boldCell(symbolPhrase(parameter)));
            break;
        case ResultLook::name:
            cells.emplace_back(m_write.text(briefName(parameter, part.evaluation)));
            break;
        case ResultLook::picture:
            cells.push_back(m_shared.unit.isEmpty() ? Cell(m_write.language().unit(parameter.term.quantity))
                                                    : blankCell());
            cells.push_back(guardCell(parameter));
            break;
        case ResultLook::verdict:
            cells.push_back(verdictCell(m_write, parameter));
            break;
        case ResultLook::text:
        case ResultLook::number:
            cells.emplace_back(column.shown({result, m_write.language()}));
            cells.back().bold = column.key == std::string_view("value");
        }
    }

    [[nodiscard]] static Verdict stateOf(const AgreedLimit &limit) {
        return limit.state == LimitState::respected  ? Verdict::conforms
               : limit.state == LimitState::exceeded ? Verdict::doesNotConform
                                                     : Verdict::notProven;
    }

    /// A limit without a row of results: it cannot be evaluated, or another one rules.
    void addOpenLimit(const TestPart &part, const AgreedLimit &limit, bool pale) {
        const QString value =
            m_write.quantity(limit.limit.value, deviationQuantity(part.test)).replace(u' ', u'\u00A0');
        std::vector<Cell> cells(m_table.columns.size(), blankCell());
        cells[2] = boldCell(QString::fromStdString(limit.symbol));
        cells[3] = Cell(limit.reason ? m_write.say(REPORT_TEXT("report", "limit %1 not evaluable: %2"),
                                                   {value.toStdString(), notEvaluableText(*limit.reason)})
                                     : m_write.say(REPORT_TEXT("report", "limit %1: %2"),
                                                   {value.toStdString(), limitText(stateOf(limit))}));
        cells[3].extras.edit().columns = cells.size() - 4;
        cells.back() = Cell();
        addRow(part, std::move(cells), pale);
    }

    void addWithoutLimit(const TestPart &part, bool pale) {
        std::vector<Cell> cells(m_table.columns.size(), blankCell());
        cells[2] = Cell(m_write.text(REPORT_TEXT("report", "no limit agreed")));
        cells[2].extras.edit().columns = cells.size() - 3;
        cells.back() = Cell();
        addRow(part, std::move(cells), pale);
    }

    /// Adds the adjustment between a test as found and the one as left.
    void addAdjustment(const TestPart &part) {
        m_table.rulesAfter.push_back(m_table.rows.size() - 1);
        std::vector<Cell> cells(m_table.columns.size(), blankCell());
        cells[0] = Cell(QStringLiteral("↓"));
        cells[1] = Cell(
            Phrase({{m_write.text(REPORT_TEXT("report", "Adjustment:")) + u' ', false, false, false, true},
                    {QString::fromStdString(part.head().adjustments)}}));
        cells[1].extras.edit().columns = m_table.columns.size() - 1;
        m_table.rows.push_back(std::move(cells));
        m_table.links.emplace_back();
    }

    const std::vector<TestPart> &m_parts;
    const Writer &m_write;
    const Shared &m_shared;
    std::size_t m_uncertainty = 0; ///< its column
    std::size_t m_units = 0;
    Table m_table;
};

/// Inputs of the verdict of the report.
struct Whole {
    std::optional<Verdict> verdict;
    std::vector<Accordance> accordances; ///< of the tests that count
    std::vector<Accordance> ofAll;       ///< with those as found
    bool anyLimit = false;
    bool asLeft = false;
    int limits = 0;
    int met = 0;
    RequirementCounts requirements;
    QStringList editions;
    QStringList asFound; ///< numbers of tests that do not count

    [[nodiscard]] Accordance weakest() const {
        for (const Accordance each :
             {Accordance::no, Accordance::notShown, Accordance::notChecked, Accordance::partly}) {
            if (std::ranges::find(accordances, each) != accordances.end())
                return each;
        }
        return Accordance::yes;
    }
};

Whole wholeOf(const std::vector<TestPart> &parts) {
    Whole whole;
    for (const TestPart &part : parts) {
        whole.ofAll.push_back(part.evaluation.accordance());
        if (!counts(part)) {
            whole.asFound << QString::number(part.number);
            continue;
        }
        whole.anyLimit |= hasLimits(part.test.limits);
        whole.verdict = worst(whole.verdict, part.evaluation.verdict);
        whole.accordances.push_back(part.evaluation.accordance());
        const RequirementCounts requirements = countRequirements(part.evaluation.findings);
        whole.requirements.unmet += requirements.unmet;
        whole.requirements.undeclared += requirements.undeclared;
        whole.asLeft |= part.test.role == TestRole::asLeft;
        whole.editions << standardName(part.write.language(), &part.edition());
        whole.limits += static_cast<int>(part.evaluation.limits.size());
        whole.met += static_cast<int>(
            std::ranges::count(part.evaluation.limits, LimitState::respected, &AgreedLimit::state));
    }
    whole.editions.removeDuplicates();
    return whole;
}

/// Leaves out the period of a sentence whose list of names ends with dots.
QString onePeriod(QString sentence) {
    return sentence.replace(QLatin1StringView("…."), QLatin1StringView("…"));
}

/// Results of the tests that count, those with the same symbol and words together: "E (Y axis), R (X axis,
/// tests 1–3)". The numbers are given where several tests share the axis or circle.
class NamedResults {
public:
    explicit NamedResults(const std::vector<TestPart> &parts)
        : m_write(parts.front().write) {
        for (const TestPart &part : parts)
            m_testsOfName[briefTestName(part)] += counts(part) ? 1 : 0;
    }

    void add(const TestPart &part, const Phrase &symbol, const QString &reason = {}) {
        const QString name = briefTestName(part);
        const auto same = std::ranges::find_if(m_results, [&](const Named &each) {
            return each.symbol == symbol && each.name == name && each.reason == reason;
        });
        Named &named =
            same == m_results.end() ? m_results.emplace_back(Named{symbol, name, reason, {}}) : *same;
        if (named.tests.empty() || named.tests.back() != part.number)
            named.tests.push_back(part.number);
    }

    [[nodiscard]] Phrase take() const {
        Phrase result;
        for (const Named &named :
             std::span(m_results).first(std::min(m_results.size(), std::size_t{mostNamed}))) {
            if (!result.spans.empty())
                result.spans.push_back({QStringLiteral(", ")});
            result += named.symbol;
            QString words = joined({named.name, numbers(named)}, QStringLiteral(", "));
            words = joined({words, named.reason}, m_write.semicolon());
            result.spans.push_back({QStringLiteral(" (") + words + u')'});
        }
        if (std::ssize(m_results) > mostNamed)
            result.spans.push_back({QStringLiteral(", …")});
        return result;
    }

private:
    struct Named {
        Phrase symbol;
        QString name;
        QString reason;
        std::vector<int> tests;
    };

    /// "test 2", "tests 1, 3–5"; the count of more than a line has room for; empty if the name says which.
    [[nodiscard]] QString numbers(const Named &named) const {
        constexpr int mostNumbers = 6;
        const auto count = static_cast<int>(named.tests.size());
        if (m_testsOfName.at(named.name) < 2)
            return {};
        if (count == 1)
            return m_write.say(REPORT_TEXT("report", "test %1"), QString::number(named.tests.front()));
        if (count <= mostNumbers)
            return m_write.say(REPORT_TEXT("report", "tests %1"), testNumbers(m_write, named.tests, 0));
        return m_write.language().sentence({REPORT_TEXT_COUNTED("report", "%n test(s)"), {}, count});
    }

    const Writer &m_write;
    std::map<QString, int> m_testsOfName;
    std::vector<Named> m_results;
};

/// The quantities with this verdict.
Phrase namedQuantities(const std::vector<TestPart> &parts, Verdict verdict) {
    NamedResults results(parts);
    for (const TestPart &part : parts) {
        for (const Parameter &parameter : part.evaluation.parameters) {
            if (counts(part) && isLimited(parameter, part.head()) && parameter.verdict == verdict &&
                parameter.value)
                results.add(part, symbolPhrase(parameter));
        }
    }
    return results.take();
}

/// "Not evaluable: A (X axis; one run in each direction)."; empty if every limit was evaluated.
QString notEvaluable(const std::vector<TestPart> &parts) {
    const Writer &write = parts.front().write;
    NamedResults results(parts);
    for (const TestPart &part : parts) {
        for (const AgreedLimit &limit : part.evaluation.limits) {
            if (counts(part) && limit.reason)
                results.add(part, QString::fromStdString(limit.symbol),
                            write.text(notEvaluableText(*limit.reason)));
        }
    }
    const QString names = results.take().plain();
    return names.isEmpty() ? QString()
                           : onePeriod(write.say(REPORT_TEXT("report", "Not evaluable: %1."), names));
}

Phrase limitsText(const std::vector<TestPart> &parts, const Whole &whole, const QString &rule) {
    const Writer &write = parts.front().write;
    if (!whole.verdict)
        return write.text(
            whole.anyLimit
                ? REPORT_TEXT("report", "The limits agreed do not hold for these tests: no verdict.")
                : REPORT_TEXT("report", "The results have no verdict."));
    const bool one = whole.limits == 1;
    const Number limits = wholeNumber(whole.limits);
    if (whole.verdict == Verdict::conforms) {
        const QString met =
            one ? write.text(REPORT_TEXT("report", "1 limit"))
                : write.language().sentence(
                      {REPORT_TEXT_COUNTED("report", "%n of %1 limits"), {limits}, whole.met});
        return joined({met, rule}, write.semicolon()) + u'.';
    }
    Phrase result = namedQuantities(parts, *whole.verdict);
    const auto period = [&result] { return result.plain().endsWith(u'…') ? QString() : QStringLiteral("."); };
    if (*whole.verdict == Verdict::doesNotConform) {
        const Phrase open = namedQuantities(parts, Verdict::notProven);
        if (!open.spans.empty()) {
            result.spans.push_back(
                {period() + u' ' + write.text(REPORT_TEXT("report", "Not proven:")) + u' '});
            result += open;
        }
    }
    QString rest = result.spans.empty() ? QString() : period();
    if (const QString open = notEvaluable(parts); !open.isEmpty())
        rest += (result.spans.empty() ? QString() : QStringLiteral(" ")) + open;
    if (!one)
        rest += u' ' + write.language().sentence(
                           {REPORT_TEXT_COUNTED("report", "Met: %n of %1 limits."), {limits}, whole.met});
    result.spans.push_back({rest});
    return result;
}

VerdictLine verdictLine(const std::vector<TestPart> &parts, const Whole &whole, const QString &rule) {
    const Writer &write = parts.front().write;
    const Accordance weakest = whole.weakest();
    VerdictLine line;
    line.large = true;
    line.mark = largeMark(whole.verdict, weakest);
    line.label =
        write.text(parts.front().head().sheet.empty() ? REPORT_TEXT("report", "Verdict of the report")
                                                      : REPORT_TEXT("report", "Verdict of the tests"));
    const LargeWord word = largeWord(whole.verdict, whole.anyLimit, weakest);
    line.word = write.text(word.word).toUpper();
    if (!word.second.empty())
        line.second = write.text(word.second).toUpper();
    if (whole.asLeft)
        line.note = write.text(REPORT_TEXT("report", "machine in its final condition, as left"));
    line.limits = {write.text(REPORT_TEXT_FOR("report", "Limits", "part of a verdict")),
                   whole.verdict ? markOf(*whole.verdict) : Mark::none,
                   write.text(palmer::limitsText(whole.verdict, whole.anyLimit)),
                   limitsText(parts, whole, rule)};
    const QString state =
        weakest == Accordance::yes
            ? write.say(REPORT_TEXT("report", "in accordance with %1"), enumerated(write, whole.editions))
            : countedWords(write, weakest, whole.requirements);
    line.accordance = {write.text(REPORT_TEXT_FOR("report", "Tests", "part of a verdict")), markOf(weakest),
                       state, accordanceOfAll(whole.ofAll, write.language())};
    return line;
}

ResultsLegend legendOf(const Writer &write, const Shared &shared) {
    ResultsLegend legend;
    const auto add = [&](LegendSign sign, const QString &text) { legend.items.push_back({sign, text}); };
    add(LegendSign::value, write.text(REPORT_TEXT_FOR("report", "value", "legend")));
    add(LegendSign::limit, write.text(REPORT_TEXT_FOR("report", "limit", "legend")));
    if (shared.band)
        add(LegendSign::band, write.text(REPORT_TEXT("report", "guard band about the limit")));
    add(LegendSign::check, write.text(limitText(Verdict::conforms)));
    add(LegendSign::cross, write.text(limitText(Verdict::doesNotConform)));
    add(LegendSign::openCircle, write.text(limitText(Verdict::notProven)));
    add(LegendSign::warning, write.text(REPORT_TEXT("report", "requirement not met")));
    return legend;
}

QString closingText(const Writer &write, const Whole &whole) {
    QStringList sentences;
    if (whole.asFound.isEmpty())
        sentences << write.text(
            REPORT_TEXT("report", "The verdict of the report is the worst of the verdicts of the tests."));
    else if (whole.asFound.size() == 1)
        sentences << write.say(
            REPORT_TEXT("report", "The verdict of the report is the worst of the verdicts of the tests "
                                  "in the final condition; test %1, as found, does not enter."),
            whole.asFound.front());
    else
        sentences << write.say(
            REPORT_TEXT("report", "The verdict of the report is the worst of the verdicts of the tests "
                                  "in the final condition; tests %1, as found, do not enter."),
            enumerated(write, whole.asFound));
    sentences << scopeText(write);
    return sentences.join(u' ');
}

} // namespace

VerdictLine verdictOfTests(const std::vector<TestPart> &parts) {
    return verdictLine(parts, wholeOf(parts), sharedBy(parts).rule);
}

void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const TestPart &first = parts.front();
    const Writer &write = first.write;
    const Shared shared = sharedBy(parts);
    const Whole whole = wholeOf(parts);
    TestHead head = summaryHead(parts);
    blocks.emplace_back(RunningHead{head.laboratory, head.title});
    blocks.emplace_back(std::move(head));
    blocks.emplace_back(verdictLine(parts, whole, shared.rule));

    QStringList notes{shared.rule};
    if (whole.limits > 0)
        notes << write.text(REPORT_TEXT("report", "verdict based on unrounded values"));
    addHeading(blocks, write.text(REPORT_TEXT("report", "Limited quantities")),
               joined(notes, write.semicolon()));
    blocks.emplace_back(LimitedQuantities(parts, shared).take());
    if (whole.limits > 0)
        blocks.emplace_back(legendOf(write, shared));
    if (!first.head().sheet.empty())
        return; // which says the rest
    blocks.emplace_back(Paragraph{closingText(write, whole)});
    if (!first.leavesOut(ReportPart::signatures))
        addResponsibility(blocks, write, first.head());
}

} // namespace palmer
