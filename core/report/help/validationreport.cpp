// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/help/validationreport.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr int digitsOfDifference = 2;
constexpr int digitsShown = 12; ///< the difference tells the rest

Text sourceText(ExpectationSource source) {
    switch (source) {
    case ExpectationSource::published:
        return REPORT_TEXT("report", "published");
    case ExpectationSource::recomputed:
        return REPORT_TEXT("report", "recomputed");
    case ExpectationSource::exact:
        return REPORT_TEXT("report", "exact");
    case ExpectationSource::certified:
        return REPORT_TEXT("report", "certified");
    }
    return {};
}

double rounded(double value, int digits) {
    return QString::number(value, 'g', digits).toDouble();
}

std::vector<Cell> row(const Comparison &comparison, Quantity quantity, const Language &language) {
    const Expectation &expected = comparison.expectation;
    const Quantity ofDifference = expected.relative ? Quantity::number : quantity;
    const auto shown = [&](std::optional<double> value) {
        return value ? Phrase(language.number(rounded(*value, digitsShown), quantity)) : Phrase();
    };
    return {comparison.of,
            comparison.symbol,
            language.text(sourceText(expected.source)),
            shown(expected.value),
            shown(comparison.computed),
            comparison.difference
                ? Phrase(language.number(rounded(*comparison.difference, digitsOfDifference), ofDifference))
                : Phrase(),
            language.number(expected.tolerance, ofDifference),
            language.text(comparison.agrees ? REPORT_TEXT("report", "agrees")
                                            : REPORT_TEXT("report", "DOES NOT AGREE"))};
}

Table table(const SetValidation &set, const Language &language) {
    const QString unit = set.quantity == Quantity::number ? QString() : language.unit(set.quantity);
    const auto title = [&](const Text &words) { return Phrase(language.text(words)); };
    Table result;
    result.columns = {{title(set.points ? REPORT_TEXT("report", "File") : REPORT_TEXT("report", "Edition")),
                       {},
                       Alignment::left,
                       false},
                      {title(REPORT_TEXT("report", "Quantity")), {}, Alignment::left, false},
                      {title(REPORT_TEXT("report", "Source")), {}, Alignment::left, false},
                      {title(REPORT_TEXT("report", "Expected")), unit, Alignment::decimal, false},
                      {title(REPORT_TEXT("report", "Computed")), unit, Alignment::decimal, false},
                      {title(REPORT_TEXT("report", "Difference")), unit, Alignment::right, false},
                      {title(REPORT_TEXT("report", "Tolerance")), unit, Alignment::right, false},
                      {{}, {}, Alignment::left, false}};
    for (const Comparison &comparison : set.comparisons)
        result.rows.push_back(row(comparison, set.quantity, language));
    return result;
}

} // namespace

Report composeValidation(const std::vector<SetValidation> &sets, const Language &language) {
    Report report;
    std::size_t values = 0;
    std::size_t reproduced = 0;
    for (const SetValidation &set : sets) {
        values += set.comparisons.size();
        reproduced +=
            static_cast<std::size_t>(std::ranges::count(set.comparisons, true, &Comparison::agrees));
    }
    const auto count = [](std::size_t number) {
        return Number{static_cast<double>(number), Quantity::count, 0};
    };
    report.blocks.emplace_back(Paragraph{language.sentence(
        {REPORT_TEXT("report", "%1 of %2 values reproduced."), {count(reproduced), count(values)}, {}})});
    if (reproduced < values)
        report.blocks.emplace_back(Paragraph{language.sentence(
            {REPORT_TEXT("report", "Values that do NOT agree with the reference data: %1 of %2."),
             {count(values - reproduced), count(values)},
             {}})});
    for (const SetValidation &set : sets) {
        report.blocks.emplace_back(Heading{1, set.name});
        report.blocks.emplace_back(Paragraph{set.origin});
        report.blocks.emplace_back(table(set, language));
    }
    return report;
}

} // namespace palmer
