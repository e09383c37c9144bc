#include "report/uncertaintyparts.h"

#include "kernel/evaluation/decideuncertainty.h"
#include "language/rounding.h"
#include "report/wording.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr int contributionDecimals = 2;
constexpr double percent = 100;
constexpr double leastShare = 0.005; ///< below, "< 1" is printed
constexpr double smallShare = 0.05;  ///< of the largest: nothing stands out

Quantity deviationOf(const TestPart &part) {
    const auto *positioning = std::get_if<PositioningMeasurement>(&part.test.measurement);
    return positioning ? deviationQuantity(*positioning) : Quantity::deviation;
}

/// With a capital, and the index of E_VE set lower.
Phrase nameOf(const Writer &write, const Contribution &contribution) {
    QString name = write.text(contribution.name);
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    const QString index = QStringLiteral("_VE");
    const qsizetype at = name.indexOf(index);
    if (at < 0)
        return name;
    return Phrase({{name.left(at)}, {index.mid(1), true}, {name.mid(at + index.size())}});
}

/// "1 500.41 mm; k = 2": what the budget is made after.
QString budgetNote(const TestPart &part) {
    const Writer &write = part.write;
    const auto *positioning = std::get_if<PositioningMeasurement>(&part.test.measurement);
    QStringList notes;
    notes << write.text(positioning ? REPORT_TEXT("report", "GUM, after the model of ISO 230-2:2006 Annex A")
                                    : REPORT_TEXT("report", "GUM, contributors of ISO 230-4:2005, 4.6"));
    if (positioning && positioning->axis.motion == Motion::linear && part.evaluation.uncertainty.length)
        notes << QStringLiteral("L = ") +
                     write.quantity(part.evaluation.uncertainty.length, Quantity::position);
    notes << QStringLiteral("k = 2");
    return notes.join(write.semicolon());
}

QString shareText(const Writer &write, double share) {
    if (share < leastShare)
        return share > 0 ? QStringLiteral("<\u00A01") : QStringLiteral("0");
    return write.language().number(share * percent, Quantity::number, 0);
}

Table contributionTable(const TestPart &part) {
    const Writer &write = part.write;
    const auto &contributions = part.evaluation.uncertainty.contributions;
    const Quantity quantity = deviationOf(part);
    double largest = 0;
    for (const Contribution &contribution : contributions)
        largest = std::max(largest, contribution.expanded.value_or(0));
    const double unit = quantity == Quantity::deviation ? 1e-3 : 1.0 / 3600; // µm, arc seconds
    const double end = scaleEnd(largest / unit) * unit;
    Table table;
    table.unbroken = true;
    table.columns = {
        {write.text(REPORT_TEXT_FOR("report", "Component", "of a budget")), {}, Alignment::left, false, 57},
        {write.text(REPORT_TEXT("report", "Inputs")), {}, Alignment::left, true, 56},
        {Phrase({{QStringLiteral("U")}, {QStringLiteral("i"), true}}), write.language().unit(quantity),
         Alignment::decimal, false, 12},
        {write.text(REPORT_TEXT_FOR("report", "Share", "of a budget")), QStringLiteral("%"), Alignment::right,
         false, 12},
        {QString(),
         largest > 0 ? write.say(REPORT_TEXT("report", "0 to %1"), {Number{end, quantity}}) : QString(),
         Alignment::left, false, 38}};
    table.columns.back().paddingLeft = 3.2;
    for (const Contribution *contribution : bySize(contributions)) {
        const bool shown = contribution->expanded && contribution->applies;
        Cell bar = blankCell();
        if (largest > 0) {
            bar.blank = false;
            bar.bar = contribution->expanded.value_or(0) / end;
        }
        table.rows.push_back(
            {nameOf(write, *contribution),
             contribution->expanded ? write.language().sentence(contribution->inputs)
                                    : write.text(REPORT_TEXT("report", "not stated")),
             shown ? Cell(write.language().number(*contribution->expanded, quantity, contributionDecimals))
                   : Cell(),
             shown ? Cell(shareText(write, shareOf(*contribution, contributions))) : Cell(), bar});
    }
    return table;
}

/// U of each result, a row a method; bold what decides.
Table resultTable(const TestPart &part) {
    const Writer &write = part.write;
    const Quantity quantity = deviationOf(part);
    const auto resolution = finestResolution(part.document(), part.test);
    Table table;
    table.unbroken = true;
    table.columns.push_back(
        {write.say(REPORT_TEXT("report", "U in %1, k = 2"), write.language().unit(quantity)),
         {},
         Alignment::left,
         false,
         38});
    const bool simulated = part.evaluation.uncertainty.simulation != nullptr;
    const bool positioning = std::holds_alternative<PositioningMeasurement>(part.test.measurement);
    std::vector<Cell> budget{write.text(positioning ? REPORT_TEXT("report", "Model of Annex A")
                                                    : REPORT_TEXT("report", "Simplified budget"))};
    std::vector<Cell> monteCarlo{write.text(REPORT_TEXT("report", "Monte Carlo (GUM-S1)"))};
    std::vector<Cell> shift{write.text(REPORT_TEXT("report", "Shift of the mean"))};
    const auto shown = [&](std::optional<double> value, bool decides) {
        if (!value)
            return Cell();
        Cell cell(write.language().uncertainty(*value, quantity,
                                               decimalsWithUncertainty(*value, quantity, resolution)));
        cell.bold = decides;
        return cell;
    };
    for (const Parameter &parameter : part.evaluation.parameters) {
        if (!isPrinted(parameter, part.head()))
            continue;
        table.columns.push_back(
            {symbolPhrase(parameter.term.symbol, parameter.index), {}, Alignment::decimal, false, 0});
        budget.push_back(
            shown(parameter.budgetUncertainty, parameter.decidedBy == UncertaintyMethod::budget));
        const auto &simulation = parameter.simulated;
        monteCarlo.push_back(shown(simulation ? std::optional(simulation->expanded()) : std::nullopt,
                                   parameter.decidedBy == UncertaintyMethod::monteCarlo));
        shift.push_back(simulation
                            ? Cell(write.language().number(
                                  simulation->shift(), quantity,
                                  decimalsWithUncertainty(simulation->expanded(), quantity, resolution)))
                            : Cell());
    }
    table.rows = {budget};
    if (simulated) {
        table.rows.push_back(monteCarlo);
        table.rows.push_back(shift);
    }
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

QString methodText(const TestPart &part) {
    const Writer &write = part.write;
    const UncertaintyEvaluation &uncertainty = part.evaluation.uncertainty;
    QStringList words;
    if (uncertainty.simulation) {
        const auto count = [](long long number) {
            return Number{static_cast<double>(number), Quantity::count};
        };
        words << write.say(
            REPORT_TEXT("report", "Monte Carlo: %1 trials of the whole evaluation, seed %2; U is half of the "
                                  "shortest interval that holds 95.45 % of the results, the shift their mean "
                                  "less the evaluated value."),
            {count(uncertainty.simulation->trials), std::to_string(uncertainty.simulation->seed)});
        const QString differing = symbolsOf(part, methodsDiffer);
        if (!differing.isEmpty())
            words << write.say(
                REPORT_TEXT("report",
                            "The methods differ by more than 20 % for %1; reason: see the findings."),
                differing);
    }
    if (uncertainty.method == UncertaintyMethod::monteCarlo) {
        const QString byBudget =
            symbolsOf(part, [](const Parameter &p) { return p.decidedBy == UncertaintyMethod::budget; });
        words << (byBudget.isEmpty()
                      ? write.text(REPORT_TEXT("report", "The U of the Monte Carlo simulation decides."))
                      : write.say(REPORT_TEXT("report",
                                              "The U of the Monte Carlo simulation decides; for %1, which it "
                                              "shifts by more than a third of its U, that of the budget."),
                                  byBudget));
    } else {
        words << write.text(REPORT_TEXT("report", "The U of the budget decides."));
    }
    return words.join(u' ');
}

/// "To improve first: …"; empty where nothing stands out.
QString adviceText(const TestPart &part) {
    const auto &contributions = part.evaluation.uncertainty.contributions;
    const auto ordered = bySize(contributions);
    const auto largest =
        std::ranges::find_if(ordered, [](const Contribution *c) { return c->expanded.has_value(); });
    if (largest == ordered.end() || !part.evaluation.uncertainty.complete)
        return {};
    const double share = shareOf(**largest, contributions);
    if (share < smallShare)
        return {};
    QString name = part.write.text((*largest)->name);
    name.replace(QStringLiteral("E_VE"), QStringLiteral("EVE"));
    return part.write.say(REPORT_TEXT("report", "To improve first: %1 (%2 % of the budget)."),
                          {name.toStdString(), Number{share * percent, Quantity::number, 0}});
}

} // namespace

bool usesBudget(const TestEvaluation &evaluation) {
    const UncertaintyMethod method = evaluation.uncertainty.method;
    return !evaluation.view &&
           (method == UncertaintyMethod::budget || method == UncertaintyMethod::monteCarlo) &&
           !evaluation.uncertainty.contributions.empty();
}

std::vector<const Contribution *> bySize(const std::vector<Contribution> &contributions) {
    std::vector<const Contribution *> result;
    for (const Contribution &contribution : contributions)
        result.push_back(&contribution);
    std::ranges::stable_sort(result, [](const Contribution *a, const Contribution *b) {
        const auto rank = [](const Contribution *c) {
            return !c->expanded ? std::numeric_limits<double>::infinity() : c->applies ? *c->expanded : -1;
        };
        return rank(a) > rank(b);
    });
    return result;
}

double shareOf(const Contribution &contribution, const std::vector<Contribution> &contributions) {
    double squares = 0;
    for (const Contribution &one : contributions)
        squares += one.expanded.value_or(0) * one.expanded.value_or(0);
    const double size = contribution.expanded.value_or(0);
    return squares > 0 ? size * size / squares : 0;
}

double scaleEnd(double size) {
    if (!(size > 0) || !std::isfinite(size))
        return 1;
    constexpr std::array steps{1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    const double power = std::pow(10.0, std::floor(std::log10(size)));
    for (const double step : steps) {
        if (step * power >= size)
            return step * power;
    }
    return steps.back() * power;
}

void addBudget(std::vector<Block> &blocks, const TestPart &part) {
    if (part.leavesOut(ReportPart::uncertainty) || !usesBudget(part.evaluation))
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Uncertainty budget")), budgetNote(part));
    blocks.emplace_back(contributionTable(part));
    const bool any = std::ranges::any_of(part.evaluation.parameters, [&](const Parameter &p) {
        return isPrinted(p, part.head()) && p.budgetUncertainty.has_value();
    });
    if (!any)
        return;
    blocks.emplace_back(resultTable(part));
    blocks.emplace_back(
        Paragraph{joined({methodText(part), adviceText(part)}, QStringLiteral(" ")), TextSize::small});
}

} // namespace palmer
