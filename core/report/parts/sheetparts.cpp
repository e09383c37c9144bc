// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "kernel/evaluation/conformity.h"
#include "report/tables/findinglines.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <span>

namespace palmer {

namespace {

/// The numbers of a row as printed: those of the user as entered, those of a result as in its test.
struct SheetNumbers {
    QString permitted;
    QString value;
    QString uncertainty;
    QString unit;
};

QString permittedText(const Writer &write, const Permitted &permitted, int decimals) {
    const auto number = [&](double value) {
        return write.language().number(value, Quantity::number, decimals).toStdString();
    };
    if (permitted.low && permitted.high)
        return write.say(REPORT_TEXT("report", "%1 to %2"),
                         {number(*permitted.low), number(*permitted.high)});
    return permitted.high ? QString::fromStdString(number(*permitted.high)) : QString();
}

/// The most that one of its own numbers has.
int decimalsOf(const SheetRow &row) {
    int decimals = 0;
    for (const std::optional<double> &value :
         {row.permitted.low, row.permitted.high, row.measured, row.uncertainty}) {
        if (value)
            decimals = std::max(decimals, decimalsOf(*value, Quantity::number));
    }
    return decimals;
}

SheetNumbers ownNumbers(const Writer &write, const SheetRow &row) {
    const int decimals = decimalsOf(row);
    return {permittedText(write, row.permitted, decimals),
            write.number(row.measured, Quantity::number, decimals),
            write.number(row.uncertainty, Quantity::number, decimals), QString::fromStdString(row.unit)};
}

std::optional<Verdict> verdictOfRow(const SheetResult &result) {
    return result.state <= SheetState::doesNotConform ? std::optional(static_cast<Verdict>(result.state))
                                                      : std::nullopt;
}

/// The result as in its test, whose rule decided it.
SheetNumbers numbersOfResult(const Writer &write, const SheetResult &result,
                             const EvaluatedDocument &evaluated) {
    const Document &document = *evaluated.document;
    const PrintedNumbers numbers =
        printedNumbers(*result.parameter, *document.tests[*result.test], document, write.language());
    return {numbers.limit, numbers.value, numbers.uncertainty,
            write.language().unit(result.parameter->term.quantity)};
}

/// " ± 0.0005", the guard band of a row with numbers of its own; it may need a digit more than they do.
QString bandOf(const Writer &write, const SheetResult &result, const SheetRow &row) {
    if (!result.guardBand)
        return {};
    const int shown = decimalsOf(row);
    const int decimals = std::clamp(decimalsOf(*result.guardBand, Quantity::number), shown, shown + 2);
    return QStringLiteral(" ± ") + write.number(result.guardBand, Quantity::number, decimals);
}

/// As in the results of a test: none without a guard band.
Text bandTitle(const std::vector<SheetResult> &results) {
    const auto hasBand = [](const SheetResult &result) { return result.guardBand.has_value(); };
    const auto isU = [](const SheetResult &result) {
        return !result.guardBand || result.guardBand == result.uncertainty;
    };
    if (std::ranges::none_of(results, hasBand))
        return {};
    return std::ranges::all_of(results, isU) ? REPORT_TEXT("report", "Limit ± U")
                                             : REPORT_TEXT("report", "Limit ± g");
}

Mark markOf(SheetState state) {
    return inOrder(state,
                   {Mark::check, Mark::openCircle, Mark::cross, Mark::warning, Mark::none, Mark::none});
}

/// "test 2", of those with a page.
QString testWord(const Writer &write, const std::vector<TestPart> &parts, const SheetResult &result,
                 const SheetSource &source) {
    const auto part =
        std::ranges::find(parts, result.test, [](const TestPart &p) { return std::optional(p.index); });
    return write.say(REPORT_TEXT("report", "test %1"),
                     {part == parts.end() ? source.test : std::to_string(part->number)});
}

/// "G9", or its place.
std::string nameOf(const SheetRow &row, std::size_t index) {
    return row.number.empty() ? std::to_string(index + 1) : row.number;
}

std::size_t countOfState(const std::vector<SheetResult> &results, SheetState state) {
    return static_cast<std::size_t>(std::ranges::count(results, state, &SheetResult::state));
}

/// "G9", "row 3": a number alone would read like a count.
QString nameInSentence(const SheetRow &row, std::size_t index, const Writer &write) {
    const std::string name = nameOf(row, index);
    return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; })
               ? write.say(REPORT_TEXT_FOR("report", "row %1", "of the acceptance sheet"), {name})
               : QString::fromStdString(name);
}

/// "G9 (0.019 mm for 0.020 ± 0.003 mm), G14": the rows in this state; those whose verdict is that of a test
/// are named with it.
QString namedRows(const EvaluatedDocument &evaluated, const std::vector<SheetResult> &results,
                  SheetState state, const Writer &write) {
    const ReportHead &head = evaluated.document->report;
    QStringList names;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SheetResult &result = results[i];
        const std::optional<Verdict> verdict = verdictOfRow(result);
        const bool saidByTest = verdict && result.parameter && result.parameter->verdict == verdict;
        if (result.state != state || saidByTest)
            continue;
        names << nameInSentence(head.sheet[i], i, write);
        if (!verdict)
            continue;
        const SheetWords words = sheetWords(evaluated, {}, result, i, write);
        const auto withUnit = [&](const QString &number) {
            return joined({number, words.unit}, QString(QChar::Nbsp)).toStdString();
        };
        const QString band = bandOf(write, result, head.sheet[i]); // no verdict of a test comes here
        names.last() += QStringLiteral(" (") +
                        write.say(REPORT_TEXT_FOR("report", "%1 for %2", "measured, tolerance"),
                                  {withUnit(words.value), withUnit(words.permitted + band)}) +
                        u')';
    }
    if (names.size() > mostNamed)
        names = names.mid(0, mostNamed) << QStringLiteral("…");
    return names.join(QStringLiteral(", "));
}

/// Why nothing is proven, unless the numbers of the row say it.
Text reasonOf(const EvaluatedDocument &evaluated, const SheetResult &result) {
    if (result.state != SheetState::notProven)
        return {};
    if (result.parameter)
        return whyNotProven(*result.parameter, *evaluated.tests[*result.test]);
    return result.uncertainty ? Text() : notProvenWithoutUncertainty;
}

} // namespace

Text sheetStateText(SheetState state) {
    if (state <= SheetState::doesNotConform)
        return limitText(static_cast<Verdict>(state));
    return state == SheetState::notMeasured ? REPORT_TEXT_FOR("report", "not measured", "a row of the sheet")
           : state == SheetState::noLimit   ? REPORT_TEXT("report", "no tolerance")
                                          : REPORT_TEXT_FOR("report", "not applicable", "a row of the sheet");
}

Cell sheetPicture(const SheetResult &result) {
    Cell cell = blankCell();
    const std::optional<double> limit = result.permitted.low ? std::nullopt : result.permitted.high;
    if (!result.value || !limit || !(*limit > 0) || !verdictOfRow(result))
        return cell;
    const Bound bound = result.parameter ? result.parameter->bound : Bound::magnitude;
    cell.blank = false;
    cell.extras.edit().guard = Guard{*limit, judgedValue(*result.value, bound), result.guardBand};
    return cell;
}

SheetWords sheetWords(const EvaluatedDocument &evaluated, const std::vector<TestPart> &parts,
                      const SheetResult &result, std::size_t index, const Writer &write) {
    const SheetRow &row = evaluated.document->report.sheet[index];
    SheetNumbers numbers =
        result.parameter ? numbersOfResult(write, result, evaluated) : ownNumbers(write, row);
    SheetWords words{std::move(numbers.permitted),
                     std::move(numbers.value),
                     std::move(numbers.uncertainty),
                     std::move(numbers.unit),
                     {},
                     write.text(sheetStateText(result.state)),
                     write.text(reasonOf(evaluated, result))};
    if (row.from)
        words.source =
            testWord(write, parts, result, *row.from) + QStringLiteral(", ") +
            QString::fromStdString(result.parameter ? plainSymbol(*result.parameter) : row.from->parameter);
    return words;
}

/// Numbers at their decimal marks. Pascals and millionths of a metre at one mark would leave no room for the
/// objects.
Alignment alignmentOf(std::span<const SheetWords> rows) {
    constexpr qsizetype mostAligned = 14; // characters
    qsizetype whole = 0;
    qsizetype fraction = 0;
    for (const SheetWords &words : rows) {
        for (const QString &text : {words.value, words.uncertainty}) {
            const qsizetype mark = std::max(text.indexOf(u'.'), text.indexOf(u','));
            whole = std::max(whole, mark < 0 ? text.size() : mark);
            fraction = std::max(fraction, mark < 0 ? 0 : text.size() - mark);
        }
    }
    return whole + fraction > mostAligned ? Alignment::right : Alignment::decimal;
}

Cell objectCell(const SheetRow &row, const SheetWords &words) {
    Cell object(QString::fromStdString(row.object));
    if (row.from)
        object.text.spans.push_back(
            {(row.object.empty() ? QString() : QStringLiteral(" · ")) + words.source, false, false, true});
    for (const std::string *note : {&row.standard, &row.remark, &row.notApplicable}) {
        if (!note->empty())
            object.extras.edit().notes.push_back({QString::fromStdString(*note)});
    }
    if (!words.reason.isEmpty())
        object.extras.edit().notes.push_back({words.reason});
    return object;
}

Table sheetTable(const EvaluatedDocument &evaluated, const std::vector<TestPart> &parts,
                 const Writer &write) {
    constexpr double numberColumn = 9.2; // mm, like all widths here
    constexpr double valueColumn = 13;   // wider where a number or title needs it
    constexpr double unitColumn = 9.6;
    constexpr double instrumentColumn = 26;
    constexpr double pictureColumn = 17;
    constexpr double verdictColumn = 22;
    constexpr double least = 40;
    const ReportHead &head = evaluated.document->report;
    const std::vector<SheetResult> results = evaluated.sheet();
    CoverageOfResults coverage;
    for (const SheetResult &result : results) {
        if (result.parameter && result.parameter->decidedBy == UncertaintyMethod::monteCarlo)
            coverage.simulated.push_back(QString::fromStdString(plainSymbol(*result.parameter)));
        else
            coverage.factor |= result.uncertainty.has_value();
    }
    std::vector<SheetWords> rows;
    for (std::size_t i = 0; i < results.size(); ++i)
        rows.push_back(sheetWords(evaluated, parts, results[i], i, write));
    const Alignment alignment = alignmentOf(rows);
    const auto number = [&](const Text &title) {
        Column column = write.column(title, valueColumn, alignment);
        column.fitting = true;
        return column;
    };
    Table table;
    table.columns = {write.column(REPORT_TEXT_FOR("report", "No.", "number of a row"), numberColumn),
                     write.flexible(REPORT_TEXT_FOR("report", "Object", "of the acceptance sheet"), least),
                     number(REPORT_TEXT("report", "Tolerance")),
                     number(REPORT_TEXT_FOR("report", "Measured", "value")),
                     number(REPORT_TEXT("report", "Limit")),
                     columnOf(QString(), unitColumn),
                     write.column(REPORT_TEXT("report", "Instrument"), instrumentColumn),
                     write.column(bandTitle(results), pictureColumn),
                     write.column(REPORT_TEXT("report", "Verdict"), verdictColumn)};
    table.columns.back().paddingLeft = 2; // from the picture
    table.columns.back().fitting = true;
    table.columns[4].title = uncertaintyHead(coverage, write.language());
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SheetRow &row = head.sheet[i];
        const SheetResult &result = results[i];
        const SheetWords &words = rows[i];
        Cell verdict(words.state);
        verdict.mark = markOf(result.state);
        verdict.bold = result.state == SheetState::doesNotConform;
        table.rows.push_back(
            {boldCell(QString::fromStdString(nameOf(row, i))), objectCell(row, words), words.permitted,
             boldCell(words.value), words.uncertainty, words.unit.isEmpty() ? blankCell() : Cell(words.unit),
             row.instrument.empty() ? blankCell() : Cell(QString::fromStdString(row.instrument)),
             sheetPicture(result), verdict});
        const auto part =
            std::ranges::find(parts, result.test, [](const TestPart &p) { return std::optional(p.index); });
        table.links.push_back(part == parts.end() ? QString() : part->headAnchor());
    }
    return table;
}

VerdictStatement sheetStatement(const EvaluatedDocument &evaluated, const Writer &write) {
    const std::vector<SheetResult> results = evaluated.sheet();
    const std::optional<Verdict> verdict = verdictOf(results);
    const std::size_t apply = results.size() - countOfState(results, SheetState::notApplicable);
    const std::size_t met = countOfState(results, SheetState::conforms);
    VerdictStatement statement;
    statement.label = write.text(REPORT_TEXT_FOR("report", "Sheet", "part of a verdict"));
    statement.mark = verdict ? palmer::markOf(*verdict) : Mark::none;
    statement.state =
        met == apply && apply > 1
            ? write.language().sentence(
                  {REPORT_TEXT_COUNTED("report", "all %n row(s) met"), {}, static_cast<int>(apply)})
            : write.language().sentence({REPORT_TEXT_COUNTED("report", "%n of %1 rows met"),
                                         {wholeNumber(apply)},
                                         static_cast<int>(met)});
    QStringList sentences;
    for (const SheetState state : {SheetState::doesNotConform, SheetState::notProven, SheetState::notMeasured,
                                   SheetState::noLimit, SheetState::notApplicable}) {
        if (const QString names = namedRows(evaluated, results, state, write); !names.isEmpty())
            sentences << write.say(REPORT_TEXT("report", "%1: %2"),
                                   {names.toStdString(), write.text(sheetStateText(state)).toStdString()});
    }
    statement.text = sentences.isEmpty() ? QString() : sentences.join(write.semicolon()) + u'.';
    return statement;
}

void addSheetFindings(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write) {
    TestEvaluation found;
    found.findings = findingsOf(evaluated.document->report.sheet, evaluated.sheet());
    if (found.findings.empty())
        return;
    addHeading(blocks, write.text(REPORT_TEXT("report", "Findings")));
    blocks.emplace_back(findingLines(found, write.language()));
}

void addSheet(std::vector<Block> &blocks, const EvaluatedDocument &evaluated,
              const std::vector<TestPart> &parts, const Writer &write) {
    const ReportHead &head = evaluated.document->report;
    TestHead heading = sheetHead(write, evaluated, parts);
    blocks.emplace_back(RunningHead{heading.laboratory, heading.title});
    blocks.emplace_back(std::move(heading));

    VerdictLine line = parts.empty() ? VerdictLine() : verdictOfTests(parts);
    const Accordance accordance = worstAccordance(evaluated).value_or(Accordance::yes);
    const std::optional<Verdict> verdict = evaluated.verdict();
    const LargeWord word = largeWord(verdict, !head.sheet.empty(), accordance);
    line.large = true;
    line.mark = largeMark(verdict, accordance);
    line.label = write.text(REPORT_TEXT("report", "Verdict of the report"));
    line.word = write.text(word.word).toUpper();
    line.second = word.second.empty() ? QString() : write.text(word.second).toUpper();
    if (parts.empty()) {
        line.accordance = {write.text(REPORT_TEXT_FOR("report", "Tests", "part of a verdict")),
                           Mark::none,
                           write.text(REPORT_TEXT_FOR("report", "none", "tests")),
                           {}};
    } else {
        line.accordance.state =
            write.say(REPORT_TEXT("report", "%1: %2"),
                      {line.limits.label.toStdString(), line.limits.state.toStdString()}) +
            write.semicolon() + line.accordance.state;
        if (line.accordance.mark == Mark::check)
            line.accordance.mark = line.limits.mark;
        Phrase text = line.limits.text;
        if (!text.spans.empty() && !line.accordance.text.spans.empty())
            text.spans.push_back({QStringLiteral(" ")});
        text += line.accordance.text;
        line.accordance.text = std::move(text);
    }
    line.limits = sheetStatement(evaluated, write);
    blocks.emplace_back(std::move(line));

    const QString rule =
        ruleWithBand(head.decisionRule, ruleWords(head.decisionRule.rule).inReport, write.language());
    addHeading(blocks, write.text(REPORT_TEXT_FOR("report", "Checks", "of the acceptance sheet")),
               write.text(REPORT_TEXT("report", "verdict based on unrounded values")));
    Table table = sheetTable(evaluated, parts, write);
    const bool pictures = std::ranges::any_of(
        table.rows, [](const std::vector<Cell> &row) { return row[7].extras->guard.has_value(); });
    const bool bands = std::ranges::any_of(table.rows, [](const std::vector<Cell> &row) {
        return row[7].extras->guard && row[7].extras->guard->guardBand;
    });
    if (!pictures)
        leaveOutEmptyColumns(table, 7, 7);
    leaveOutEmptyColumns(table, 6, 6);
    blocks.emplace_back(std::move(table));
    if (pictures) {
        ResultsLegend legend{
            {{LegendSign::value, write.text(REPORT_TEXT_FOR("report", "measured", "legend"))},
             {LegendSign::limit, write.text(REPORT_TEXT_FOR("report", "tolerance", "legend"))}}};
        if (bands)
            legend.items.push_back(
                {LegendSign::band, write.text(REPORT_TEXT("report", "guard band about the limit"))});
        blocks.emplace_back(std::move(legend));
    }
    const DecisionRule &decision = head.decisionRule;
    const bool hasBand =
        decision.rule != Rule::simpleAcceptance || decision.guardFactor == DecisionRule().guardFactor;
    const QString unused =
        hasBand ? QString()
                : write.say(REPORT_TEXT("report", "The stated factor of a guard band, %1, has no effect."),
                            {Number{decision.guardFactor, Quantity::number, -1}}) +
                      u' ';
    blocks.emplace_back(Paragraph{
        write.say(REPORT_TEXT("report", "Decision rule: %1"), rule) + QStringLiteral(". ") + unused +
        write.text(REPORT_TEXT(
            "report", "The verdict of the report is the worst of those of sheet and tests; a row that "
                      "is not measured forbids “all met”. Objects and tolerances are those of the "
                      "parties.")) +
        u' ' + scopeText(write)});
    addSheetFindings(blocks, evaluated, write);
    if (std::ranges::find(head.leaveOut, ReportPart::signatures) == head.leaveOut.end())
        addResponsibility(blocks, write, head);
}

void addSheetResults(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write) {
    if (evaluated.document->report.sheet.empty())
        return;
    blocks.emplace_back(Heading{1, write.text(REPORT_TEXT("report", "Acceptance sheet"))});
    Table table = sheetTable(evaluated, {}, write);
    table.links.clear();
    eraseColumn(table, 7);
    blocks.emplace_back(std::move(table));
    VerdictLine line;
    line.limits = sheetStatement(evaluated, write);
    line.accordance = {write.text(REPORT_TEXT("report", "Decision rule")),
                       Mark::none,
                       ruleWithBand(evaluated.document->report.decisionRule,
                                    ruleWords(evaluated.document->report.decisionRule.rule).condition,
                                    write.language()),
                       {}};
    blocks.emplace_back(std::move(line));
    addSheetFindings(blocks, evaluated, write);
}

} // namespace palmer
