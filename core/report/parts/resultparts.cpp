// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"
#include "report/tables/findinglines.h"
#include "report/words/accordancetext.h"
#include "report/words/findingtext.h"

#include "figures/testfigures.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/conformity.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "language/decimals.h"
#include "report/tables/resulttable.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <ranges>

namespace palmer {

namespace {

constexpr double earlierGuardFactor = 1.0;   ///< guard band U: earlier editions of ISO 14253-1
constexpr double oneSidedGuardFactor = 0.83; ///< 1.65 u: 95 % rule of later editions for one limit
constexpr QChar noBreakSpace(u'\u00A0');
constexpr qsizetype mostOfReason = 230; ///< characters that fit on three lines of the verdict

bool hasGuardBand(const Test &test) {
    return test.decisionRule.rule != Rule::simpleAcceptance;
}

bool factorIsOne(const Test &test) {
    return test.decisionRule.guardFactor == earlierGuardFactor;
}

/// False also if U is simulated: then the band is wider.
bool bandIsU(const TestPart &part) {
    return factorIsOne(part.test) && !guardsSimulated(part.evaluation);
}

Number factor(const Test &test) {
    return {test.decisionRule.guardFactor, Quantity::number, -1};
}

/// "U", "0.83 U"; with a simulated U "0.83 (U + 2s)", where s belongs to U.
QString bandName(const TestPart &part, bool simulated) {
    QString band = simulated ? QStringLiteral("U\u00A0+\u00A02s") : QStringLiteral("U");
    if (factorIsOne(part.test))
        return band;
    return part.write.language().number(certain(part.test.decisionRule.guardFactor), Quantity::number) +
           QStringLiteral("\u00A0") + (simulated ? u'(' + band + u')' : band);
}

/// Symbol for sentences, without typography: "Fmax,XY".
QString shownSymbol(const Parameter &parameter) {
    return symbolPhrase(parameter).plain();
}

QString joinedSymbols(const std::vector<const Parameter *> &parameters) {
    QStringList symbols;
    for (const Parameter *parameter : parameters)
        symbols << shownSymbol(*parameter);
    return symbols.join(QStringLiteral(", "));
}

Phrase targetsTitle(const TestPart &part) {
    return Phrase({{part.write.text(resultColumn("ruling").title) + u' '},
                   {letterOfTargets(part.edition()), false, true}});
}

/// Properties of the table of results of a kind of test.
struct ResultForm {
    QString heading;
    bool setUpInF = false; ///< note that F contains the set-up error
    std::function<QString(const Parameter &)> nameOf;
};

ResultForm positioningForm(const PositioningPart &part) {
    const std::string &axis = part.measurement.axis.name;
    return {part.write.say(REPORT_TEXT("report", "Results for the %1 axis"),
                           {axis.empty() ? std::string("–") : axis}),
            false, [&part](const Parameter &parameter) {
                QString name = nameInTable(part.write, parameter.term.name);
                const QString symbol =
                    QStringLiteral(" (%1)").arg(shownSymbol(parameter)); // printed next to it
                return name.endsWith(symbol) ? name.chopped(symbol.size()) : name;
            }};
}

/// Term, path and circle: "Circular deviation, anticlockwise, minimum zone".
QString circularName(const CircularPart &part, const Parameter &parameter) {
    const Writer &write = part.write;
    QStringList words{nameInTable(write, parameter.term.name)};
    for (const EvaluatedPath &path : part.results.paths) {
        if (parameter.term.of == Of::path && path.index == parameter.index)
            words << write.text(senseText(path.sense));
    }
    if (parameter.term.circle == OfCircle::deviation)
        words << write.text(part.measurement.referenceCircle == ReferenceCircle::minimumZone
                                ? REPORT_TEXT("report", "minimum zone")
                                : REPORT_TEXT("report", "least squares"));
    if (parameter.dependsOnTemperature && part.holdsAt20())
        words << write.text(REPORT_TEXT("report", "at 20 °C"));
    return words.join(QStringLiteral(", "));
}

ResultForm circularForm(const CircularPart &part) {
    return {part.write.say(REPORT_TEXT("report", "Results in the %1 plane"), part.plane()),
            part.measurement.centring == Centring::instrument,
            [&part](const Parameter &parameter) { return circularName(part, parameter); }};
}

/// Widths in mm: the name gets the rest; wider texts first take space next to the picture.
Column columnOnPaper(const ResultColumn &column, const TestPart &part, const QString &unit) {
    const Writer &write = part.write;
    constexpr double gap = 1.2;
    constexpr double beforePicture = 3.2;
    constexpr double besidePicture = 2;
    const bool isNumber = column.look == ResultLook::number;
    Column result{column.look == ResultLook::name ? QString() : write.text(column.title),
                  isNumber ? unit : QString(), isNumber ? Alignment::decimal : Alignment::left,
                  column.look == ResultLook::name, column.width};
    result.fitting = column.look != ResultLook::name;
    switch (column.look) {
    case ResultLook::symbol: // followed by the name
        result.title = write.text(resultColumn("name").title);
        result.titleSpan = 2;
        result.paddingLeft = gap;
        break;
    case ResultLook::text:
        if (column.axesOnly)
            result.title = targetsTitle(part);
        result.paddingLeft = gap;
        break;
    case ResultLook::picture:
        if (hasGuardBand(part.test))
            result.title = write.text(bandIsU(part) ? REPORT_TEXT("report", "Limit ± U")
                                                    : REPORT_TEXT("report", "Limit ± g"));
        result.fitting = false;
        result.paddingLeft = beforePicture;
        result.spare = besidePicture;
        break;
    case ResultLook::number:
        if (column.key == std::string_view("expandedUncertainty"))
            result.title = uncertaintyHead(coverageOf(part.evaluation, part.head()), write.language());
        break;
    case ResultLook::verdict:
        result.paddingLeft = besidePicture;
        break;
    case ResultLook::name:
        break;
    }
    return result;
}

bool isRadialDeviation(const Parameter &parameter) {
    return parameter.term.circle == OfCircle::radialDeviation && parameter.value;
}

QString nameOnPaper(const TestPart &part, const ResultForm &form, const Parameter &parameter) {
    QString name = form.nameOf(parameter);
    const auto own = part.test.limits.find(parameter.term.id);
    const bool severalLimits = own != part.test.limits.end() && own->second.value;
    if (const QString of = limitNote(parameter, part.write.language()); severalLimits && !of.isEmpty())
        name += QStringLiteral(", ") + of;
    if (notCorrected(part.evaluation) && parameter.dependsOnTemperature)
        name += QStringLiteral("\u00A0*");
    if (form.setUpInF && isRadialDeviation(parameter))
        name += QStringLiteral("\u00A0†");
    return name;
}

Cell cellOnPaper(const ResultColumn &column, const TestPart &part, const ResultForm &form,
                 const PrintedResult &result) {
    const Parameter &parameter = *result.parameter;
    switch (column.look) {
    case ResultLook::symbol: {
        return boldCell(symbolPhrase(parameter));
    }
    case ResultLook::name:
        return nameOnPaper(part, form, parameter);
    case ResultLook::picture:
        return guardCell(parameter);
    case ResultLook::verdict:
        return verdictCell(part.write, parameter);
    case ResultLook::text:
    case ResultLook::number:
        break;
    }
    QString text = column.shown({result, part.write.language()});
    Cell cell(column.look == ResultLook::text ? text.replace(u' ', noBreakSpace) : text);
    cell.bold = column.key == std::string_view("value") && !result.limit.isEmpty();
    return cell;
}

/// Those with a limit first.
Table resultTable(const TestPart &part, const ResultForm &form, std::vector<PrintedResult> results) {
    const auto withoutLimit = std::stable_partition(
        results.begin(), results.end(), [](const PrintedResult &result) { return !result.limit.isEmpty(); });
    const auto limited = static_cast<std::size_t>(withoutLimit - results.begin());
    Table table;
    table.unbroken = true;
    auto columns = resultColumns(onPaper);
    std::erase_if(columns,
                  [&](const ResultColumn *column) { return column->axesOnly && !axisOf(part.test); });
    const QString unit = part.write.language().unit(results.front().parameter->term.quantity);
    table.columns.reserve(columns.size());
    for (const ResultColumn *column : columns)
        table.columns.push_back(columnOnPaper(*column, part, unit));
    table.rulesAfter = rulesBetween(results);
    for (const PrintedResult &result : results) {
        std::vector<Cell> row;
        row.reserve(columns.size());
        for (const ResultColumn *column : columns)
            row.push_back(cellOnPaper(*column, part, form, result));
        table.rows.push_back(std::move(row));
    }
    const auto value =
        std::ranges::find(columns, std::string_view("value"), &ResultColumn::key) - columns.begin();
    leaveOutEmptyColumns(table, static_cast<std::size_t>(value) + 1, table.columns.size() - 1);
    if (limited > 0 && limited < results.size()) {
        std::vector<Cell> row(table.columns.size(), blankCell());
        row.front() =
            Phrase({{part.write.text(REPORT_TEXT("report", "No limit agreed")), false, false, true}});
        row.front().extras.edit().columns = table.columns.size();
        table.rows.insert(table.rows.begin() + static_cast<std::ptrdiff_t>(limited), std::move(row));
        std::erase_if(table.rulesAfter, [&](std::size_t after) { return after < limited; });
        for (std::size_t &after : table.rulesAfter)
            ++after;
        table.strongRulesAfter.push_back(limited - 1);
    }
    return table;
}

/// The origin of the limits if all have the same.
QString originOfLimits(const TestPart &part) {
    QStringList origins;
    for (const auto &[id, limit] : part.test.limits) {
        if (limit.value)
            origins << QString::fromStdString(limit.source);
    }
    origins.removeDuplicates();
    return origins.size() == 1 ? origins.front() : QString();
}

QString resultsNote(const TestPart &part) {
    QStringList notes;
    if (part.edition().rangeMethod) {
        const bool range = deviationMethod(part.evaluation) == DeviationMethod::range;
        notes << part.write.text(range ? REPORT_TEXT("report", "s by the range method")
                                       : REPORT_TEXT("report", "s by the calculation method"));
    }
    if (const QString origin = originOfLimits(part); !origin.isEmpty())
        notes << part.write.say(REPORT_TEXT("report", "limits: %1"), origin);
    return notes.join(part.write.semicolon());
}

/// The decision rule in one sentence; empty without a verdict.
QString ruleSentence(const TestPart &part) {
    if (!part.evaluation.verdict)
        return {};
    const QString band = bandName(part, guardsSimulated(part.evaluation));
    return part.write.say(
        inOrder(
            part.test.decisionRule.rule,
            {REPORT_TEXT("report", "Decision rule: %1. A limit is met by a value not above it; the verdict "
                                   "is based on unrounded values."),
             REPORT_TEXT("report", "Decision rule: %1. A limit is met where value + %2 ≤ limit, exceeded "
                                   "where value − %2 > limit, otherwise not proven; the verdict is based "
                                   "on unrounded values."),
             REPORT_TEXT("report", "Decision rule: %1. A limit is met where value + %2 ≤ limit, exceeded "
                                   "where value − %2 > limit; between, non-conformity is not proven; the "
                                   "verdict is based on unrounded values.")}),
        {part.write.text(ruleWords(part.test.decisionRule.rule).inReport).toStdString(), band.toStdString()});
}

void addLegend(std::vector<Block> &blocks, const TestPart &part, const ResultForm &form) {
    const Writer &write = part.write;
    const auto &parameters = part.evaluation.parameters;
    const auto addLine = [&](const QString &text) {
        blocks.emplace_back(ResultsLegend{{{LegendSign::none, text}}});
    };
    if (const auto *measurement = std::get_if<PositioningMeasurement>(&part.test.measurement)) {
        iso230_2::NameList targets;
        for (const std::size_t target : targetsWithoutReading(*measurement))
            targets.add(std::to_string(target + 1));
        if (!targets.empty())
            addLine(write.language().sentence(
                {REPORT_TEXT_COUNTED("report", "%n target(s) without any reading: %1."),
                 {targets.text()},
                 targets.count()}));
    }
    const auto isMarked = [&](const Parameter &p) {
        return p.dependsOnTemperature && isPrinted(p, part.head());
    };
    if (notCorrected(part.evaluation) && std::ranges::any_of(parameters, isMarked))
        addLine(QStringLiteral("*\u00A0") + write.text(REPORT_TEXT("report", "not corrected to 20 °C")));
    const auto holdsSetUp = [&](const Parameter &p) {
        return isRadialDeviation(p) && isPrinted(p, part.head());
    };
    if (form.setUpInF && std::ranges::any_of(parameters, holdsSetUp))
        addLine(QStringLiteral("†\u00A0") +
                write.text(REPORT_TEXT("report", "about the centre of the set-up: with the set-up error")));
    const bool pictures = std::ranges::any_of(
        parameters, [](const Parameter &p) { return guardCell(p).extras->guard.has_value(); });
    if (!pictures)
        return;
    ResultsLegend legend;
    legend.items.push_back({LegendSign::value, write.text(REPORT_TEXT_FOR("report", "value", "legend"))});
    legend.items.push_back({LegendSign::limit, write.text(REPORT_TEXT_FOR("report", "limit", "legend"))});
    const bool bands =
        std::ranges::any_of(parameters, [](const Parameter &p) { return p.guardBand.has_value(); });
    if (bands) {
        const QString band = bandIsU(part)
                                 ? QStringLiteral("U")
                                 : QStringLiteral("g = ") + bandName(part, guardsSimulated(part.evaluation));
        legend.items.push_back(
            {LegendSign::band, write.say(REPORT_TEXT("report", "limit ± %1, one scale per row"), band)});
    }
    blocks.emplace_back(std::move(legend));
}

// ---- The verdict line
// --------------------------------------------------------------------------------------

std::vector<const PrintedResult *> resultsWith(const std::vector<PrintedResult> &results, Verdict verdict) {
    std::vector<const PrintedResult *> found;
    for (const PrintedResult &result : results) {
        if (result.parameter->verdict == verdict && result.parameter->value)
            found.push_back(&result);
    }
    return found;
}

std::vector<const Parameter *> parametersOf(const std::vector<const PrintedResult *> &results) {
    std::vector<const Parameter *> parameters;
    parameters.reserve(results.size());
    for (const PrintedResult *result : results)
        parameters.push_back(result->parameter);
    return parameters;
}

std::string shownValue(const TestPart &part, const PrintedResult &result) {
    QString value = result.value;
    if (result.parameter->bound == Bound::magnitude && value.startsWith(u'−'))
        value.remove(0, 1); // the limit applies to the absolute value
    return withUnit(value, result.parameter->term.quantity, part.write.language()).toStdString();
}

std::string shownLimit(const TestPart &part, const PrintedResult &result) {
    return withUnit(result.limit, result.parameter->term.quantity, part.write.language()).toStdString();
}

QString shownUncertainty(const TestPart &part, const PrintedResult &result) {
    return withUnit(result.uncertainty, result.parameter->term.quantity, part.write.language());
}

Text exceededBand(bool isLower, bool bandIsU) {
    if (isLower)
        return bandIsU ? REPORT_TEXT("report", "%1 is below its lower limit by more than the uncertainty: %2 "
                                               "against %3 − %4 = %5.")
                       : REPORT_TEXT("report", "%1 is below its lower limit by more than the guard band: %2 "
                                               "against %3 − %4 = %5.");
    return bandIsU
               ? REPORT_TEXT("report",
                             "%1 exceeds its limit by more than the uncertainty: %2 against %3 + %4 = %5.")
               : REPORT_TEXT("report",
                             "%1 exceeds its limit by more than the guard band: %2 against %3 + %4 = %5.");
}

/// `inShort`: only the symbols.
QString exceeded(const TestPart &part, const std::vector<const PrintedResult *> &results, bool inShort) {
    const Writer &write = part.write;
    if (results.size() > 1 || inShort) {
        QStringList items;
        for (const PrintedResult *result : results) {
            const std::string symbol = shownSymbol(*result->parameter).toStdString();
            items << (inShort ? QString::fromStdString(symbol)
                              : write.say(REPORT_TEXT("report", "%1 (%2 against %3)"),
                                          {symbol, shownValue(part, *result), shownLimit(part, *result)}));
        }
        const QString list = items.join(QStringLiteral(", "));
        return hasGuardBand(part.test) // goes on from the state, "exceeded"
                   ? write.say(REPORT_TEXT("report", "by more than the guard band: %1."), list)
                   : list + u'.';
    }
    const PrintedResult &result = *results.front();
    const Parameter &parameter = *result.parameter;
    const bool isLower = parameter.bound == Bound::lower;
    if (!hasGuardBand(part.test) || result.reach.isEmpty())
        return write.say(
            isLower ? REPORT_TEXT("report", "%1 is below its lower limit: %2 against %3.")
                    : REPORT_TEXT("report", "%1 exceeds its limit: %2 against %3."),
            {shownSymbol(parameter).toStdString(), shownValue(part, result), shownLimit(part, result)});
    return write.say(exceededBand(isLower, factorIsOne(part.test)),
                     {shownSymbol(parameter).toStdString(), shownValue(part, result),
                      shownLimit(part, result),
                      QStringLiteral("%1 (%2)")
                          .arg(bandName(part, parameter.decidedBy == UncertaintyMethod::monteCarlo),
                               shownUncertainty(part, result))
                          .toStdString(),
                      withUnit(result.reach, parameter.term.quantity, write.language()).toStdString()});
}

QString notProven(const TestPart &part, const std::vector<const PrintedResult *> &results) {
    const QString symbols =
        enumerated(part.write, joinedSymbols(parametersOf(results)).split(QStringLiteral(", ")));
    const bool uncorrected =
        at20(part.evaluation) != At20::hold && std::ranges::all_of(results, [](const PrintedResult *result) {
            return result->parameter->dependsOnTemperature;
        });
    const bool withoutUncertainty = std::ranges::all_of(
        results, [](const PrintedResult *result) { return !result->parameter->expandedUncertainty; });
    const Text words =
        uncorrected && notCorrected(part.evaluation)
            ? REPORT_TEXT("report", "Not corrected to 20 °C, nothing is proven for %1.")
        : uncorrected ? REPORT_TEXT("report", "Not shown to hold at 20 °C, nothing is proven for %1.")
        : withoutUncertainty
            ? REPORT_TEXT("report", "Without the measurement uncertainty nothing is proven for %1.")
        : part.test.decisionRule.rule == Rule::rejectionProven
            ? REPORT_TEXT("report", "For %1 non-conformity is not proven: no ground for rejection.")
            : REPORT_TEXT("report", "For %1 neither conformity nor non-conformity is proven.");
    return part.write.say(words, symbols);
}

/// The result that decides a verdict, with its U and limit: the one furthest beyond its limit, or, if none
/// is, the one closest to it. The limit comes first: value, U and limit in this order are a row of the
/// results.
QString deciding(const TestPart &part, const std::vector<const PrintedResult *> &results) {
    const auto excess = [](const PrintedResult *result) {
        const Parameter &parameter = *result->parameter;
        if (result->limit.isEmpty())
            return -std::numeric_limits<double>::infinity();
        const double limit = judgedLimit(*parameter.limit->value, parameter.bound);
        const double beyond = judgedValue(*parameter.value, parameter.bound) - limit;
        const double band = parameter.guardBand.value_or(0);
        return (beyond + (parameter.verdict == Verdict::conforms ? band : -band)) /
               std::max(std::abs(limit), std::numeric_limits<double>::min());
    };
    const PrintedResult &result = **std::ranges::max_element(results, {}, excess);
    if (result.limit.isEmpty())
        return {};
    QString values = shownSymbol(*result.parameter) + QStringLiteral("\u00A0=\u00A0") +
                     QString::fromStdString(shownValue(part, result));
    if (!result.uncertainty.isEmpty())
        values += QStringLiteral(", U\u00A0=\u00A0") + shownUncertainty(part, result);
    return part.write.say(result.parameter->verdict == Verdict::doesNotConform
                              ? REPORT_TEXT("report", "Furthest beyond its limit of %1: %2.")
                              : REPORT_TEXT("report", "Closest to its limit of %1: %2."),
                          {shownLimit(part, result), values.toStdString()});
}

/// The sentences on the deciding results, then on those within their limits; `inShort`: exceeded limits
/// without their numbers.
QString judged(const TestPart &part, const std::vector<PrintedResult> &results, bool inShort) {
    const auto failing = resultsWith(results, Verdict::doesNotConform);
    const auto open = resultsWith(results, Verdict::notProven);
    const auto good = resultsWith(results, Verdict::conforms);
    QStringList all;
    if (!failing.empty())
        all << exceeded(part, failing, inShort);
    if (!open.empty())
        all << notProven(part, open);
    const auto &decisive = !failing.empty() ? failing : !open.empty() ? open : good;
    // A single exceeded limit is said with its numbers.
    const bool said = failing.size() == 1 && !inShort;
    const QString numbers = said || decisive.empty() ? QString() : deciding(part, decisive);
    const QString met = joinedSymbols(parametersOf(good));
    const QString unknown = notEvaluableSentence(part.evaluation, part.write.language());
    if (!unknown.isEmpty())
        all << unknown;
    const bool allMet = !good.empty() && failing.empty() && open.empty() && unknown.isEmpty();
    if (allMet) // the state says so
        all << enumerated(part.write, met.split(QStringLiteral(", "))) + u'.';
    if (!numbers.isEmpty())
        all << numbers;
    if (!allMet && !good.empty())
        all << part.write.say(good.size() == 1 ? REPORT_TEXT("report", "Within its limit: %1.")
                                               : REPORT_TEXT("report", "Within their limits: %1."),
                              met);
    return all.join(u' ');
}

QString reason(const TestPart &part, const std::vector<PrintedResult> &results) {
    if (part.evaluation.view)
        return part.write.say(
            REPORT_TEXT("report", "Seen under another edition than that of the test (%1): no verdict."),
            {part.test.edition});
    if (!part.evaluation.verdict) {
        return part.write.text(
            hasLimits(part.test.limits)
                ? REPORT_TEXT("report", "The limits agreed do not hold for this test: no verdict.")
                : REPORT_TEXT("report", "The results have no verdict."));
    }
    const QString whole = judged(part, results, false);
    return whole.size() <= mostOfReason ? whole : judged(part, results, true);
}

VerdictLine verdictLine(const TestPart &part, const std::vector<PrintedResult> &results) {
    const TestEvaluation &evaluation = part.evaluation;
    const bool limits = hasLimits(part.test.limits);
    VerdictLine line;
    line.mark = largeMark(evaluation.verdict, evaluation.accordance());
    line.label = part.write.text(REPORT_TEXT("report", "Verdict of the test"));
    const LargeWord word = largeWord(evaluation.verdict, limits, evaluation.accordance());
    line.word = part.write.text(word.word).toUpper();
    if (!word.second.empty())
        line.second = part.write.text(word.second).toUpper();
    line.limits = {part.write.text(REPORT_TEXT_FOR("report", "Limits", "part of a verdict")),
                   evaluation.verdict ? markOf(*evaluation.verdict) : Mark::none,
                   part.write.text(limitsText(evaluation.verdict, limits)),
                   withSymbols(reason(part, results), evaluation.parameters)};
    const bool listed =
        !part.leavesOut(ReportPart::findings) && (part.annex || part.edition().textRead != TextRead::none);
    line.accordance = accordanceStatement(part.test, evaluation, part.write.language(), listed);
    if (line.accordance.text.plain().contains(QLatin1String("%1")))
        line.anchor = part.findingsAnchor();
    return line;
}

void addResultsAs(std::vector<Block> &blocks, const TestPart &part, const ResultForm &form) {
    const auto results = printedResults(part.document(), part.test, part.evaluation, part.write.language());
    if (!results.empty()) {
        addHeading(blocks, form.heading, resultsNote(part));
        blocks.emplace_back(resultTable(part, form, results));
        addLegend(blocks, part, form);
        if (part.count > 1)
            return; // the sentences stand once for all tests
        const QString sentences =
            joined({uncertaintySentence(part), ruleSentence(part)}, QStringLiteral(" "));
        if (!sentences.isEmpty())
            blocks.emplace_back(Paragraph{sentences, TextSize::small});
    }
}

} // namespace

LargeWord largeWord(std::optional<Verdict> verdict, bool anyLimit, Accordance accordance) {
    if (!verdict)
        return {anyLimit ? REPORT_TEXT("report", "no verdict") : REPORT_TEXT("report", "no limit")};
    if (accordance == Accordance::yes || accordance == Accordance::partly)
        return {verdictText(*verdict)};
    switch (*verdict) {
    case Verdict::conforms:
        break;
    case Verdict::notProven:
        return {REPORT_TEXT("report", "limits not proven")};
    case Verdict::doesNotConform:
        return {REPORT_TEXT("report", "limits exceeded")};
    }
    if (accordance == Accordance::no)
        return {REPORT_TEXT("report", "no verdict")};
    return {REPORT_TEXT("report", "limits met"), accordance == Accordance::notChecked
                                                     ? REPORT_TEXT("report", "test not checked")
                                                     : REPORT_TEXT("report", "accordance not shown")};
}

Mark largeMark(std::optional<Verdict> verdict, Accordance accordance) {
    if (!verdict)
        return Mark::none;
    const bool open = accordance != Accordance::yes && accordance != Accordance::partly;
    return *verdict == Verdict::conforms && open ? Mark::warning : markOf(*verdict);
}

Cell guardCell(const Parameter &parameter) {
    Cell cell = blankCell();
    if (!parameter.verdict || !parameter.value || !parameter.limit || !parameter.limit->value)
        return cell;
    const double limit = judgedLimit(*parameter.limit->value, parameter.bound);
    if (limit <= 0)
        return cell;
    cell.blank = false;
    cell.extras.edit().guard =
        Guard{limit, judgedValue(*parameter.value, parameter.bound), parameter.guardBand};
    return cell;
}

Cell verdictCell(const Writer &write, const Parameter &parameter) {
    if (!parameter.verdict)
        return {};
    Cell cell(write.text(limitText(*parameter.verdict)));
    cell.mark = markOf(*parameter.verdict);
    cell.bold = parameter.verdict == Verdict::doesNotConform;
    return cell;
}

QString ruleInShort(const TestPart &part) {
    QString rule = part.write.text(ruleWords(part.test.decisionRule.rule).inReport);
    if (hasGuardBand(part.test) && !factorIsOne(part.test))
        rule += QStringLiteral(", g = ") + bandName(part, guardsSimulated(part.evaluation));
    return rule;
}

void addFigure(std::vector<Block> &blocks, const PositioningPart &part) {
    const Writer &write = part.write;
    const PositioningResults &results = part.results;
    const auto &include = part.head().include;
    DeviationFigureOptions options;
    options.readingMarks = std::ranges::find(include, ReportExtra::readingMarks) != include.end();
    CurveFigure figure = deviationFigure(part.test, part.evaluation, write.language(), options);
    QStringList notes;
    notes << (figure.bands.empty() ? write.text(REPORT_TEXT_FOR("report", "means", "figure"))
                                   : write.say(REPORT_TEXT("report", "means and ±%1s limits"),
                                               {Number{part.edition().c, Quantity::number, -1}}));
    notes << write.text(results.upward && results.downward ? REPORT_TEXT("report", "bi-directional test")
                                                           : REPORT_TEXT("report", "unidirectional test"));
    const QString n = results.positiveRuns == results.negativeRuns || !results.downward
                          ? QString::number(results.positiveRuns)
                      : !results.upward
                          ? QString::number(results.negativeRuns)
                          : QStringLiteral("%1↑, %2↓").arg(results.positiveRuns).arg(results.negativeRuns);
    notes << QStringLiteral("n\u00A0=\u00A0") + n;
    if (!figure.note.isEmpty())
        notes << figure.note;
    addHeading(blocks, figure.title, notes.join(QStringLiteral(", ")));
    blocks.emplace_back(FigureBlock{std::move(figure)});
}

void addVerdict(std::vector<Block> &blocks, const TestPart &part) {
    blocks.emplace_back(verdictLine(
        part, printedResults(part.document(), part.test, part.evaluation, part.write.language())));
}

void addResults(std::vector<Block> &blocks, const PositioningPart &part) {
    addResultsAs(blocks, part, positioningForm(part));
}

void addResults(std::vector<Block> &blocks, const CircularPart &part) {
    addResultsAs(blocks, part, circularForm(part));
}

namespace {

/// The number that the window shows, below the last findings of a test.
void addCount(std::vector<Block> &blocks, const TestPart &part) {
    const QString all = findingsByGrade(part.evaluation, part.write.language());
    blocks.emplace_back(Paragraph{
        part.write.say(REPORT_TEXT("report", "Findings of the test in all: %1."), all), TextSize::small});
}

} // namespace

void addFindings(std::vector<Block> &blocks, const TestPart &part) {
    const Language &language = part.write.language();
    const bool leftOut = part.leavesOut(ReportPart::findings);
    if (leftOut || !part.annex) {
        // Substituted readings are always declared with the readings.
        for (const Finding &finding : part.evaluation.findings) {
            if (finding.explains == Explains::substituteReadings)
                blocks.emplace_back(Paragraph{findingText(finding, language), TextSize::small});
        }
    }
    FindingsBlock block = findingLines(part.evaluation, language, FindingsOf::text);
    const bool none = block.lines.empty(); // stated next to the heading
    if (leftOut || (none && (part.count > 1 || part.edition().textRead == TextRead::none)))
        return;
    addHeading(blocks,
               part.count == 1
                   ? part.write.text(REPORT_TEXT("report", "Findings"))
                   : part.write.say(REPORT_TEXT("report", "Findings of test %1"), {wholeNumber(part.number)}),
               none ? part.write.text(REPORT_TEXT("report", "No findings."))
                    : part.write.say(
                          REPORT_TEXT("report", "what the text of %1 asks for and this test does not have"),
                          standardName(language, &part.edition())),
               part.findingsAnchor());
    if (none)
        return;
    blocks.emplace_back(std::move(block));
    const bool isLast =
        !part.annex || findingLines(part.evaluation, language, FindingsOf::others).lines.empty();
    if (isLast && part.evaluation.findings.size() > 1) // one is counted at a glance
        addCount(blocks, part);
}

void addFurtherFindings(std::vector<Block> &blocks, const TestPart &part) {
    if (part.leavesOut(ReportPart::findings))
        return;
    FindingsBlock block = findingLines(part.evaluation, part.write.language(), FindingsOf::others);
    if (block.lines.empty())
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Findings of practice, laboratory and program")),
               {}, part.edition().textRead == TextRead::none ? part.findingsAnchor() : QString());
    blocks.emplace_back(std::move(block));
    addCount(blocks, part);
}

QString nameInTable(const Writer &write, const Text &name) {
    QString result = write.text(name);
    const QString ending =
        u' ' + write.text(REPORT_TEXT_FOR("report", "of an axis", "end of the name of a parameter"));
    if (result.endsWith(ending) && result.chopped(ending.size()).contains(u' '))
        result.chop(ending.size());
    if (!result.isEmpty())
        result[0] = result[0].toUpper();
    return result;
}

QString uncertaintySentence(const TestPart &part) {
    const Writer &write = part.write;
    const CoverageOfResults coverage = coverageOf(part.evaluation, part.head());
    if (!coverage.factor && coverage.simulated.empty())
        return {};
    QStringList words{write.text(REPORT_TEXT("report", "U: expanded uncertainty"))};
    words << (coverage.simulated.empty()
                  ? write.text(
                        REPORT_TEXT("report", "coverage factor k = 2, coverage probability of about 95 %"))
                  : coverageNote(coverage, write.language()));
    if (!part.leavesOut(ReportPart::uncertainty)) {
        if (part.evaluation.uncertainty.method == UncertaintyMethod::direct)
            words << write.text(REPORT_TEXT("report", "stated by the laboratory"));
        else if (usesBudget(part.evaluation) && part.annex)
            words << write.text(REPORT_TEXT("report", "from the budget in the annex"));
    }
    return words.join(QStringLiteral(", ")) + u'.';
}

QString decisionText(const TestPart &part) {
    const Writer &write = part.write;
    QStringList words{write.say(
        inOrder(part.test.decisionRule.rule,
                {REPORT_TEXT("report", "Simple acceptance: a limit is met by a value not above it; the "
                                       "uncertainty has no part in it."),
                 REPORT_TEXT("report", "ISO 14253-1, conformity has to be proven: a limit is met when the "
                                       "value is at least g below it, exceeded when the value is more than g "
                                       "above it, and not proven between; g = %1·U."),
                 REPORT_TEXT("report",
                             "Non-conformity has to be proven: a limit is met when the value is at least g "
                             "below it and exceeded when the value is more than g above it; between, "
                             "non-conformity is not proven: no ground for rejection; g = %1·U.")}),
        {factor(part.test)})};
    if (hasGuardBand(part.test) && guardsSimulated(part.evaluation))
        words << write.say(
            REPORT_TEXT("report", "Where U comes from a simulation, g = %1·(U + 2s): our safety rule, s the "
                                  "standard deviation of U over the blocks of trials."),
            {factor(part.test)});
    if (hasGuardBand(part.test) && factorIsOne(part.test))
        words << write.text(
            REPORT_TEXT("report", "The factor 1 is the guard band of the earlier editions of ISO 14253-1."));
    if (hasGuardBand(part.test) && part.test.decisionRule.guardFactor == oneSidedGuardFactor)
        words << write.text(REPORT_TEXT(
            "report", "The factor 0.83 (1.65 u) is the later 95 % rule of ISO 14253-1 for one limit."));
    words << write.text(
        REPORT_TEXT("report", "Signed results are compared by their absolute value; the verdict is based "
                              "on the unrounded values."));
    const auto isSigned = [&](const Term *term) {
        return term->bound != Bound::magnitude && part.test.limits.contains(term->id);
    };
    if (std::ranges::any_of(termsOf(part.edition()), isSigned))
        words << write.text(REPORT_TEXT(
            "report", "The limits of Fmax and Fmin hold with their signs, that of Fmin as a lower "
                      "limit: for it, above and below change places."));
    return words.join(u' ');
}

Table limitsTable(const TestPart &part) {
    const Writer &write = part.write;
    const Quantity quantity = deviationQuantity(part.test);
    Table table;
    table.columns = {write.column(REPORT_TEXT("report", "Quantity"), 22),
                     write.column(REPORT_TEXT("report", "Limit"), 22),
                     write.column(REPORT_TEXT("report", "Agreed for"), 45),
                     write.flexible(REPORT_TEXT_FOR("report", "Source", "of a limit"), 86)};
    const auto addRow = [&](Cell symbol, const Limit &limit) {
        symbol.bold = true;
        table.rows.push_back({std::move(symbol), write.quantity(limit.value, quantity),
                              QString::fromStdString(limit.edition.value_or(part.test.edition)),
                              QString::fromStdString(limit.source)});
    };
    Limits others = part.test.limits; // limits without a parameter of this test come last
    for (const Parameter &parameter : part.evaluation.parameters) {
        const auto found = others.find(parameter.term.id);
        if (found == others.end())
            continue;
        if (found->second.value)
            addRow(symbolPhrase(parameter.term.symbol), found->second);
        others.erase(found);
    }
    for (const auto &[id, limit] : others) {
        if (limit.value)
            addRow(QString::fromStdString(symbolOf(id, part.edition())), limit);
    }
    return table;
}

void addLimits(std::vector<Block> &blocks, const TestPart &part) {
    Table table = limitsTable(part);
    if (table.rows.empty()) // the verdict says so
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Limits and decision rule")));
    blocks.emplace_back(std::move(table));
    blocks.emplace_back(Paragraph{decisionText(part), TextSize::small});
}

} // namespace palmer
