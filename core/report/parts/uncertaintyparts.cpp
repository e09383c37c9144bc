// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "document/evaluateddocument.h"
#include "figures/testfigures.h"
#include "figures/ticks.h"
#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "language/rounding.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

/// Capitalised, with the index of E_VE as a subscript.
Phrase nameOf(const Writer &write, const Contribution &contribution) {
    QString name = contributionName(contribution, write.language());
    const QString index = QStringLiteral("_VE");
    const qsizetype at = name.indexOf(index);
    if (at < 0)
        return name;
    return Phrase({{name.left(at)}, {index.mid(1), true}, {name.mid(at + index.size())}});
}

/// Length and k of the budget: "1 500.41 mm; k = 2".
QString budgetNote(const TestPart &part) {
    const Writer &write = part.write;
    QStringList notes;
    if (motionOf(part.test) == Motion::linear && part.evaluation.uncertainty.length)
        notes << QStringLiteral("L = ") +
                     write.quantity(part.evaluation.uncertainty.length, Quantity::position);
    notes << QStringLiteral("k = 2");
    return notes.join(write.semicolon());
}

Table contributionTable(const TestPart &part) {
    const Writer &write = part.write;
    const auto &contributions = part.evaluation.uncertainty.contributions;
    const Quantity quantity = deviationQuantity(part.test);
    double largest = 0;
    for (const Contribution &contribution : contributions)
        largest = std::max(largest, contribution.expanded.value_or(0));
    const double unit = quantity == Quantity::deviation ? 1e-3 : 1.0 / 3600; // µm, arc seconds
    const double end = scaleEnd(largest / unit) * unit;
    Table table;
    table.unbroken = true;
    table.columns = {write.column(REPORT_TEXT_FOR("report", "Component", "of a budget"), 57),
                     write.flexible(REPORT_TEXT("report", "Inputs"), 56),
                     columnOf(Phrase({{QStringLiteral("U")}, {QStringLiteral("i"), true}}), 12,
                              Alignment::decimal, write.language().unit(quantity)),
                     write.column(REPORT_TEXT_FOR("report", "Share", "of a budget"), 12, Alignment::right,
                                  QStringLiteral("%")),
                     columnOf(QString(), 38, Alignment::left,
                              largest > 0 ? write.say(REPORT_TEXT("report", "0 to %1"),
                                                      {Number{end, quantity, decimalsOf(end, quantity)}})
                                          : QString())};
    table.columns.back().paddingLeft = 3.2;
    for (const Contribution *contribution : bySize(contributions)) {
        const bool shown = contribution->expanded && contribution->applies;
        Cell bar = blankCell();
        if (largest > 0) {
            bar.blank = false;
            bar.extras.edit().bar = contribution->expanded.value_or(0) / end;
        }
        table.rows.push_back(
            {nameOf(write, *contribution),
             contribution->expanded ? write.language().sentence(contribution->inputs)
                                    : write.text(REPORT_TEXT("report", "not stated")),
             shown ? Cell(write.language().number(*contribution->expanded, quantity, contributionDecimals))
                   : Cell(),
             shown ? Cell(shareText(shareOf(*contribution, contributions), write.language())) : Cell(), bar});
    }
    return table;
}

/// Name of a method with the coverage of its U.
QString withCoverage(const QString &method, const QString &coverage) {
    return method + QStringLiteral(", ") + coverage;
}

/// U of a result by one method; the deciding one is bold and printed as in the results.
Cell uncertaintyCell(const TestPart &part, const Parameter &parameter, double value,
                     UncertaintyMethod method) {
    const Language &language = part.write.language();
    const Quantity quantity = deviationQuantity(part.test);
    const auto resolution = finestResolution(part.document(), part.test);
    const bool decides = parameter.decidedBy == method;
    Cell cell(decides ? printedNumbers(parameter, part.test, part.document(), language).uncertainty
                      : language.uncertainty(value, quantity,
                                             decimalsWithUncertainty(value, quantity, resolution)));
    cell.bold = decides;
    return cell;
}

/// U of each result, one row per method.
Table resultTable(const TestPart &part) {
    const Writer &write = part.write;
    const Quantity quantity = deviationQuantity(part.test);
    const auto resolution = finestResolution(part.document(), part.test);
    Table table;
    table.unbroken = true;
    table.columns.push_back(
        columnOf(write.say(REPORT_TEXT("report", "U in %1"), write.language().unit(quantity)), 56));
    const bool simulated = part.evaluation.uncertainty.simulation != nullptr;
    const QString factor = QStringLiteral("k\u00A0=\u00A02");
    std::vector<Cell> budget{withCoverage(write.text(REPORT_TEXT("report", "Budget (GUM)")), factor)};
    std::vector<Cell> actual{
        withCoverage(write.text(REPORT_TEXT("report", "With the actual targets (Palmer's method)")), factor)};
    std::vector<Cell> monteCarlo{withCoverage(write.text(REPORT_TEXT("report", "Monte Carlo (GUM-S1)")),
                                              write.text(REPORT_TEXT("report", "95.45 %")))};
    std::vector<Cell> shift{write.text(REPORT_TEXT("report", "Shift of the mean"))};
    for (const Parameter &parameter : part.evaluation.parameters) {
        if (!isPrinted(parameter, part.head()))
            continue;
        table.columns.push_back(columnOf(symbolPhrase(parameter), 0, Alignment::decimal));
        const auto shown = [&](std::optional<double> value, UncertaintyMethod method) {
            return value ? uncertaintyCell(part, parameter, *value, method) : Cell();
        };
        budget.push_back(shown(parameter.budgetUncertainty, UncertaintyMethod::budget));
        actual.push_back(shown(parameter.actualUncertainty, UncertaintyMethod::budgetActual));
        const auto &simulation = parameter.simulated;
        monteCarlo.push_back(shown(simulation ? std::optional(simulation->expanded()) : std::nullopt,
                                   UncertaintyMethod::monteCarlo));
        shift.push_back(simulation
                            ? Cell(write.language().number(
                                  simulation->shift(), quantity,
                                  decimalsWithUncertainty(simulation->expanded(), quantity, resolution)))
                            : Cell());
    }
    table.rows = {budget};
    if (axisOf(part.test)) // only axes have targets
        table.rows.push_back(actual);
    if (simulated)
        table.rows.insert(table.rows.end(), {monteCarlo, shift});
    return table;
}

QString symbolsOf(const TestPart &part, bool (*holds)(const Parameter &)) {
    QStringList symbols;
    for (const Parameter &parameter : part.evaluation.parameters) {
        if (isPrinted(parameter, part.head()) && holds(parameter))
            symbols << QString::fromStdString(plainSymbol(parameter));
    }
    return symbols.join(QStringLiteral(", "));
}

/// The drift test that provides E_VE; null if E_VE was entered.
const Test *driftTestOf(const TestPart &part) {
    std::optional<std::string> id;
    withUncertainty(part.test, [&](const auto &inputs) {
        if (!inputs.environmentalVariation)
            id = inputs.driftTest;
    });
    if (!id)
        return nullptr;
    const auto &tests = part.document().tests;
    const auto found = std::ranges::find_if(
        tests, [&](const TestPointer &other) { return other->id == *id && isDrift(*other); });
    return found == tests.end() ? nullptr : found->get();
}

/// Adds the curve of that drift test.
void addDriftCurve(std::vector<Block> &blocks, const TestPart &part) {
    const Test *drift = driftTestOf(part);
    if (!drift)
        return;
    const auto &tests = part.document().tests;
    const auto index = static_cast<std::size_t>(
        std::ranges::find(tests, drift, [](const TestPointer &test) { return test.get(); }) - tests.begin());
    FigureBlock block;
    CurveFigure figure = driftFigure(*drift, *part.evaluated.tests[index], part.write.language(),
                                     takenVariation(part.document(), drift->id, part.test));
    if (figure.curves.empty())
        return;
    blocks.emplace_back(Heading{3, figure.title});
    constexpr double width = 120;
    constexpr double height = 50;
    block.figure = std::move(figure);
    block.width = width;
    block.height = height;
    blocks.emplace_back(std::move(block));
}

/// "Improve first: …"; empty if no contribution stands out.
QString adviceText(const TestPart &part) {
    const auto &contributions = part.evaluation.uncertainty.contributions;
    const Contribution *first = toImproveFirst(contributions);
    if (!first || !part.evaluation.uncertainty.complete)
        return {};
    QString name = part.write.text(first->name);
    name.replace(QStringLiteral("E_VE"), QStringLiteral("EVE"));
    return part.write.say(
        REPORT_TEXT("report", "Improve first: %1 (%2 % of the budget)."),
        {name.toStdString(), Number{shareOf(*first, contributions) * percent, Quantity::number, 0}});
}

} // namespace

bool usesBudget(const TestEvaluation &evaluation) {
    const UncertaintyMethod method = evaluation.uncertainty.method;
    return !evaluation.view && usesContributions(method) && !evaluation.uncertainty.contributions.empty();
}

namespace {

/// Which methods the explanations cover; numbers are not compared.
struct Explained {
    bool actual = false;
    bool simulated = false;
    bool stable = false;

    explicit Explained(const TestEvaluation &evaluation)
        : actual(evaluation.uncertainty.systematic &&
                 std::ranges::any_of(evaluation.parameters,
                                     [](const Parameter &p) { return p.actualUncertainty.has_value(); }))
        , simulated(evaluation.uncertainty.simulation != nullptr)
        , stable(simulated && evaluation.uncertainty.simulation->stable &&
                 evaluation.uncertainty.simulation->mayDecide()) {}

    bool operator==(const Explained &) const = default;
};

bool showsBudgetOf(const TestEvaluation &evaluation, const ReportHead &head) {
    return usesBudget(evaluation) && std::ranges::any_of(evaluation.parameters, [&](const Parameter &p) {
               return isPrinted(p, head) && p.budgetUncertainty.has_value();
           });
}

/// Number of an earlier test of the report with the same methods.
std::optional<int> explainedBefore(const TestPart &part) {
    int number = 0;
    for (std::size_t i = 0; i < part.index; ++i) {
        const TestEvaluation &before = *part.evaluated.tests[i];
        number += before.edition ? 1 : 0; // drift tests have no number
        if (before.edition && before.edition->kind == part.edition().kind &&
            showsBudgetOf(before, part.head()) && Explained(before) == Explained(part.evaluation))
            return number;
    }
    return std::nullopt;
}

int trialsOf(const TestPart &part) {
    return static_cast<int>(part.evaluation.uncertainty.simulation->trials);
}

/// Explains how the methods determine U; once for all tests with the same methods.
void addMethods(QStringList &words, const TestPart &part) {
    const Writer &write = part.write;
    const UncertaintyEvaluation &uncertainty = part.evaluation.uncertainty;
    const Explained explained(part.evaluation);
    words << write.text(kindWords(part.test).budget);
    if (explained.actual)
        words << write.say(
            REPORT_TEXT("report", "With the actual targets: in place of S = %1 what the positions that rule "
                                  "really carry of it, the readings tilted by ±S over L and evaluated anew; "
                                  "an explanation, unless it is chosen to decide."),
            {Number{*uncertainty.systematic, deviationQuantity(part.test), contributionDecimals}});
    if (explained.simulated)
        words << write.language().sentence(
            {REPORT_TEXT_COUNTED(
                 "report", "Monte Carlo: %n trial(s) of the whole evaluation, seed %1; U is half of the "
                           "shortest interval that holds 95.45 % of the results, the shift their mean "
                           "less the evaluated value."),
             {std::to_string(uncertainty.simulation->seed)},
             trialsOf(part)});
    if (explained.stable)
        words << write.text(REPORT_TEXT(
            "report", "Over the blocks of trials twice the standard deviation of mean, u, both ends "
                      "and U is below the tolerance of u, half a unit of its second digit."));
}

/// The next number with the decimals shown that is not below: an upper bound rounded down is none.
double roundedUp(double value, const TestPart &part) {
    const double scale = unitScale(deviationQuantity(part.test), part.write.language().units()) *
                         std::pow(10, contributionDecimals);
    return std::ceil(value * scale) / scale;
}

/// Adds only the numbers if the methods were explained for an earlier test.
void addMethodsAsFor(QStringList &words, const TestPart &part, int before) {
    const Writer &write = part.write;
    const UncertaintyEvaluation &uncertainty = part.evaluation.uncertainty;
    const Explained explained(part.evaluation);
    if (explained.actual)
        words << write.say(
            REPORT_TEXT("report", "With the actual targets: S = %1, otherwise as for test %2."),
            {Number{*uncertainty.systematic, deviationQuantity(part.test), contributionDecimals},
             std::to_string(before)});
    if (explained.simulated)
        words << write.language().sentence(
            {REPORT_TEXT_COUNTED("report", "Monte Carlo: %n trial(s), seed %1, otherwise as for test %2."),
             {std::to_string(uncertainty.simulation->seed), std::to_string(before)},
             trialsOf(part)});
}

} // namespace

QString methodText(const TestPart &part, std::optional<int> before) {
    const Writer &write = part.write;
    const UncertaintyEvaluation &uncertainty = part.evaluation.uncertainty;
    QStringList words;
    if (before)
        addMethodsAsFor(words, part, *before);
    else
        addMethods(words, part);
    if (!uncertainty.simulation && uncertainty.wantsSimulation() && isTooLargeUnasked(part.test))
        words << write.language().sentence(
            {REPORT_TEXT_COUNTED("report", "Not simulated: %n reading(s); the method Monte Carlo "
                                           "(--uncertainty monteCarlo) does it."),
             {},
             static_cast<int>(readingsOf(part.test))});
    if (uncertainty.simulation) {
        const QString differing =
            uncertainty.simulation->mayDecide() ? symbolsOf(part, methodsDiffer) : QString();
        double spread = 0;
        for (const Parameter &parameter : part.evaluation.parameters) {
            if (isPrinted(parameter, part.head()) && parameter.simulated)
                spread = std::max(spread, 2 * parameter.simulated->expandedError.value_or(0));
        }
        if (spread > 0)
            words << write.say(
                REPORT_TEXT("report", "Twice the standard deviation of U over the blocks of trials: "
                                      "at most %1."),
                {Number{roundedUp(spread, part), deviationQuantity(part.test), contributionDecimals}});
        if (!differing.isEmpty())
            words << write.say(
                part.leavesOut(ReportPart::findings)
                    ? REPORT_TEXT("report", "The methods differ by more than 20 % for %1.")
                    : REPORT_TEXT("report", "The methods differ by more than 20 % for %1; reason: see the "
                                            "findings."),
                differing);
    }
    const bool trusted = !uncertainty.simulation || uncertainty.simulation->mayDecide();
    if (uncertainty.method == UncertaintyMethod::budgetActual) {
        words << write.text(
            REPORT_TEXT("report", "The U of the budget with the actual targets is used for the verdict."));
    } else if (uncertainty.method == UncertaintyMethod::monteCarlo && !trusted) {
        words << write.text(
            REPORT_TEXT("report", "Too few trials to decide: the budget U is used for the verdict."));
    } else if (uncertainty.method == UncertaintyMethod::monteCarlo) {
        const QString byBudget =
            symbolsOf(part, [](const Parameter &p) { return p.decidedBy == UncertaintyMethod::budget; });
        words << (byBudget.isEmpty()
                      ? write.text(REPORT_TEXT(
                            "report", "The U of the Monte Carlo simulation is used for the verdict."))
                      : write.say(
                            REPORT_TEXT(
                                "report",
                                "The U of the Monte Carlo simulation is used for the verdict; "
                                "for %1, which it shifts by more than a third of its U, that of the budget."),
                            byBudget));
    } else {
        words << write.text(REPORT_TEXT("report", "The budget U is used for the verdict."));
    }
    return words.join(u' ');
}

void addBudget(std::vector<Block> &blocks, const TestPart &part) {
    if (part.leavesOut(ReportPart::uncertainty) || !usesBudget(part.evaluation))
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Uncertainty budget")), budgetNote(part));
    blocks.emplace_back(contributionTable(part));
    if (showsBudgetOf(part.evaluation, part.head())) {
        blocks.emplace_back(resultTable(part));
        blocks.emplace_back(Paragraph{
            joined({methodText(part, explainedBefore(part)), adviceText(part)}, QStringLiteral(" ")),
            TextSize::small});
    } else {
        blocks.emplace_back(Paragraph{part.write.text(kindWords(part.test).budget), TextSize::small});
    }
    addDriftCurve(blocks, part);
}

} // namespace palmer
