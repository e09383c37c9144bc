// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatesheet.h"

#include "kernel/evaluation/conformity.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// Takes the numbers of a parameter; its limit as a range if the sign counts.
void take(SheetResult &result, const Parameter &parameter) {
    result.parameter = &parameter;
    result.value = parameter.value;
    result.uncertainty = parameter.expandedUncertainty;
    if (!parameter.limit || !parameter.limit->value)
        return;
    (parameter.bound == Bound::lower ? result.permitted.low : result.permitted.high) = parameter.limit->value;
}

void findSource(SheetResult &result, const SheetSource &source, std::span<const NamedTest> tests) {
    const auto test = std::ranges::find(tests, source.test, &NamedTest::id);
    if (source.test.empty() || test == tests.end()) {
        result.gap = SheetGap::noSuchTest;
        return;
    }
    result.test = static_cast<std::size_t>(test - tests.begin());
    // Without its axes a name stands for the largest of those it means: "G" of both senses.
    const Parameter *found = nullptr;
    for (const Parameter &parameter : test->evaluation->parameters) {
        const auto size = [](const Parameter &p) { return std::abs(p.value.value_or(0)); };
        if (parameterId(parameter) == source.parameter) {
            found = &parameter;
            break;
        }
        if (parameter.term.isMeantBy(source.parameter) && (!found || size(parameter) > size(*found)))
            found = &parameter;
    }
    if (found)
        take(result, *found);
    else
        result.gap = SheetGap::noSuchParameter;
    if (!result.gap && !result.value)
        result.gap = SheetGap::noValue;
}

Verdict decideRow(const SheetResult &result, std::optional<double> guarded, const DecisionRule &rule) {
    const double value = *result.value;
    const Permitted &permitted = result.permitted;
    if (!permitted.low)
        return decideUpper(std::abs(value), *permitted.high, guarded, rule, roundingOfWritten);
    return std::max(decideUpper(value, *permitted.high, guarded, rule, roundingOfWritten),
                    decideUpper(-value, -*permitted.low, guarded, rule, roundingOfWritten));
}

SheetResult evaluateRow(const SheetRow &row, const DecisionRule &rule, std::span<const NamedTest> tests) {
    SheetResult result;
    if (row.from) {
        findSource(result, *row.from, tests);
    } else {
        result.value = row.measured;
        result.uncertainty = row.uncertainty;
        result.permitted = row.permitted;
    }
    if (!row.notApplicable.empty()) {
        result.state = SheetState::notApplicable;
    } else if (result.value && result.parameter) { // what the test proves, doubts of its conditions included
        const std::optional<Verdict> verdict = result.parameter->verdict;
        result.guardBand = verdict ? result.parameter->guardBand : std::nullopt;
        result.state = verdict ? static_cast<SheetState>(*verdict) : SheetState::noLimit;
    } else if (result.value && !result.permitted.low && !result.permitted.high) {
        result.state = SheetState::noLimit;
    } else if (result.value) {
        result.guardBand = guardBand(result.uncertainty, rule);
        result.state = static_cast<SheetState>(decideRow(result, result.uncertainty, rule));
    }
    return result;
}

} // namespace

std::vector<SheetResult> evaluateSheet(std::span<const SheetRow> rows, const DecisionRule &rule,
                                       std::span<const NamedTest> tests) {
    std::vector<SheetResult> results;
    results.reserve(rows.size());
    for (const SheetRow &row : rows)
        results.push_back(evaluateRow(row, rule, tests));
    return results;
}

std::vector<Finding> findingsOf(std::span<const SheetRow> rows, std::span<const SheetResult> results) {
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!results[i].gap || !rows[i].from)
            continue;
        const Text words = inOrder(
            *results[i].gap,
            {REPORT_TEXT("report", "Row %1 of the acceptance sheet is not measured: this report has no "
                                   "test “%2”."),
             REPORT_TEXT("report", "Row %1 of the acceptance sheet is not measured: test “%2” has no "
                                   "result “%3”."),
             REPORT_TEXT("report", "Row %1 of the acceptance sheet is not measured: test “%2” has no "
                                   "value of “%3”.")});
        Finding finding;
        finding.subject = Subject::report;
        finding.id = "sheetSource";
        finding.keys = {"report.sheet[" + std::to_string(i) + "].from"};
        finding.missing = true;
        finding.message = {words,
                           {rows[i].number.empty() ? std::to_string(i + 1) : rows[i].number,
                            rows[i].from->test, rows[i].from->parameter},
                           {}};
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::optional<Verdict> verdictOf(std::span<const SheetResult> results) {
    std::optional<Verdict> verdict;
    bool anyWithoutLimit = false;
    for (const SheetResult &result : results) {
        switch (result.state) {
        case SheetState::conforms:
        case SheetState::notProven:
        case SheetState::doesNotConform:
            verdict = worst(verdict, static_cast<Verdict>(result.state));
            break;
        case SheetState::notMeasured:
            verdict = worst(verdict, Verdict::notProven);
            break;
        case SheetState::noLimit:
            anyWithoutLimit = true;
            break;
        case SheetState::notApplicable:
            break;
        }
    }
    return verdict && anyWithoutLimit ? worst(verdict, Verdict::notProven) : verdict;
}

} // namespace palmer
