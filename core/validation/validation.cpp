// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/validation.h"

#include "document/evaluateddocument.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/measurement/testfacts.h"

#include <QFile>
#include <algorithm>
#include <cmath>
#include <map>

namespace palmer {

namespace {

void computeStatistic(Comparison &comparison, const TestEvaluation &evaluation) {
    const auto &results = std::get<PositioningResults>(evaluation.results);
    const Expectation &expected = comparison.expectation;
    const auto &terms = evaluation.edition->targetTerms;
    const auto term = std::ranges::find(terms, std::string_view(expected.statistic),
                                        [](const TargetTerm &t) { return std::string_view(t.id); });
    if (term != terms.end())
        comparison.symbol = {term->symbol.base, "", term->symbol.arrow};
    comparison.index = term != terms.end() ? std::to_string(expected.target) : expected.statistic;
    const auto index = static_cast<std::size_t>(expected.target) - 1;
    if (index < results.targets.size())
        comparison.computed = targetValue(expected.statistic, results.targets[index], evaluation.edition->c);
}

void computeParameter(Comparison &comparison, const TestEvaluation &evaluation) {
    comparison.index = comparison.expectation.parameter; // if there is none of that name
    for (const Parameter &parameter : evaluation.parameters) {
        if (parameterId(parameter) != comparison.expectation.parameter)
            continue;
        comparison.symbol = parameter.term.symbol;
        comparison.index = parameter.index;
        comparison.computed = parameter.value;
    }
}

void computeCorrection(Comparison &comparison, const TestEvaluation &evaluation) {
    comparison.symbol = {"C"};
    comparison.computed =
        partOr(comparison.computed, evaluation.results,
               [](auto &results) -> decltype(results.correction) { return results.correction; });
}

void compute(Comparison &comparison, const EvaluatedDocument &evaluated) {
    const Expectation &expected = comparison.expectation;
    // With an unknown edition the test's own would be used: make no comparison.
    if (expected.test >= evaluated.tests.size() ||
        evaluated.tests[expected.test]->edition->word != expected.edition)
        return;
    const TestEvaluation &evaluation = *evaluated.tests[expected.test];
    switch (expected.what) {
    case Expected::parameter:
        return computeParameter(comparison, evaluation);
    case Expected::statistic:
        return computeStatistic(comparison, evaluation);
    case Expected::correction:
        return computeCorrection(comparison, evaluation);
    case Expected::contouringFeed:
        return; // not for a test
    }
}

Comparison compare(const Expectation &expected, const EvaluatedDocument &evaluated) {
    Comparison result;
    result.expectation = expected;
    result.of = QString::fromStdString(expected.edition);
    if (expected.what == Expected::contouringFeed) {
        result.symbol = {"V", "1"};
        result.computed = iso230_4::contouringFeed(expected.feed);
    } else {
        compute(result, evaluated);
    }
    if (result.computed)
        compareWith(result, *result.computed);
    return result;
}

} // namespace

bool SetValidation::agrees() const {
    return std::ranges::all_of(comparisons, &Comparison::agrees);
}

void compareWith(Comparison &comparison, double computed) {
    const Expectation &expected = comparison.expectation;
    const double scale = expected.relative ? std::abs(expected.value) : 1;
    comparison.computed = computed;
    comparison.difference = (computed - expected.value) / scale;
    comparison.agrees = std::abs(*comparison.difference) <= expected.tolerance;
}

SetValidation validate(const ReferenceSet &set) {
    SetValidation result{set.name, set.origin, set.quantity, {}, false};
    std::map<std::string, EvaluatedDocument> evaluations;
    for (const Expectation &expected : set.expected) {
        auto [place, isNew] = evaluations.try_emplace(expected.edition);
        if (isNew)
            place->second = evaluate(set.document, nullptr, expected.edition);
        result.comparisons.push_back(compare(expected, place->second));
    }
    return result;
}

std::vector<SetValidation> validateAll() {
    std::vector<SetValidation> result;
    for (const QString &name : embeddedReferenceFiles()) {
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly))
            throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                                  {file.errorString().toStdString()}});
        result.push_back(validate(readReferenceSet(file.readAll())));
    }
    std::ranges::move(validateCircles(), std::back_inserter(result));
    return result;
}

} // namespace palmer
