#include "validation/validation.h"

#include "document/evaluateddocument.h"
#include "kernel/evaluation/targetvalue.h"

#include <QFile>
#include <algorithm>
#include <cmath>
#include <map>

namespace palmer {

namespace {

QString targetSymbol(const Edition &edition, const Expectation &expected) {
    const auto term = std::ranges::find(edition.targetTerms, std::string_view(expected.statistic),
                                        [](const TargetTerm &t) { return std::string_view(t.id); });
    if (term == edition.targetTerms.end())
        return QString::fromStdString(expected.statistic);
    return QString::fromUtf8(term->symbol.base) + QString::number(expected.target) +
           QString::fromUtf8(term->symbol.arrow);
}

void computeStatistic(Comparison &comparison, const TestEvaluation &evaluation) {
    const auto &results = std::get<PositioningResults>(evaluation.results);
    const Expectation &expected = comparison.expectation;
    comparison.symbol = targetSymbol(*evaluation.edition, expected);
    const auto index = static_cast<std::size_t>(expected.target) - 1;
    if (index < results.targets.size())
        comparison.computed = targetValue(expected.statistic, results.targets[index], evaluation.edition->c);
}

void computeParameter(Comparison &comparison, const TestEvaluation &evaluation) {
    comparison.symbol = QString::fromStdString(comparison.expectation.parameter);
    for (const Parameter &parameter : evaluation.parameters) {
        if (parameterId(parameter) != comparison.expectation.parameter)
            continue;
        comparison.symbol = QString::fromStdString(plainSymbol(parameter));
        comparison.computed = parameter.value;
    }
}

Comparison compare(const Expectation &expected, const TestEvaluation &evaluation) {
    Comparison result;
    result.expectation = expected;
    // An unknown edition would fall back on that of the test: no comparison then.
    if (evaluation.edition->word != expected.edition)
        return result;
    if (expected.parameter.empty())
        computeStatistic(result, evaluation);
    else
        computeParameter(result, evaluation);
    if (!result.computed)
        return result;
    const double scale = expected.relative ? std::abs(expected.value) : 1;
    result.difference = (*result.computed - expected.value) / scale;
    result.agrees = std::abs(*result.difference) <= expected.tolerance;
    return result;
}

} // namespace

bool SetValidation::agrees() const {
    return std::ranges::all_of(comparisons, &Comparison::agrees);
}

SetValidation validate(const ReferenceSet &set) {
    SetValidation result{set.name, set.origin, set.quantity, {}};
    std::map<std::string, EvaluatedDocument> evaluations;
    for (const Expectation &expected : set.expected) {
        auto [place, isNew] = evaluations.try_emplace(expected.edition);
        if (isNew)
            place->second = evaluate(set.document, nullptr, expected.edition);
        result.comparisons.push_back(compare(expected, *place->second.tests.front()));
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
    return result;
}

} // namespace palmer
