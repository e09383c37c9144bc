#include "kernel/evaluation/evaluatetest.h"

#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/iso230_4/correction.h"
#include "kernel/evaluation/iso230_4/paths.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

std::optional<double> expandedUncertainty(const CircularMeasurement &measurement, const CircularRow &row) {
    if (measurement.uncertainty.method != UncertaintyMethod::direct)
        return std::nullopt;
    const auto &expanded = measurement.uncertainty.expanded;
    auto found = expanded.find(row.term.id);
    if (found == expanded.end())
        found = expanded.find(row.quantity); // U of F is that of Fmax and Fmin
    if (found == expanded.end() || found->second < 0)
        return std::nullopt;
    return found->second / 1000; // µm
}

/// The first rows that are of one quantity: Fmax and Fmin of a path stand together.
std::span<const CircularRow> rowsOfAQuantity(std::span<const CircularRow> rows) {
    std::size_t count = 1;
    while (count < rows.size() && std::string_view(rows[count].quantity) == rows.front().quantity)
        ++count;
    return rows.first(count);
}

void addParameter(TestEvaluation &evaluation, const CircularRow &row, const CircularCase &test,
                  const EvaluatedPath *path, const std::string &index) {
    Parameter result;
    result.term = row.term;
    result.index = index;
    result.dependsOnTemperature = row.dependsOnTemperature;
    result.required = test.isRequired(row.quantity) || test.isRequired(row.term.id);
    result.value = row.value(test, path);
    if (result.value && !std::isfinite(*result.value))
        result.value.reset();
    result.expandedUncertainty = expandedUncertainty(test.measurement, row);
    evaluation.parameters.push_back(std::move(result));
}

/// The parameters a key of `limits` is for. F stands for the larger of |Fmax| and |Fmin| of each path.
std::vector<Judged> judged(std::vector<Parameter> &parameters, const std::string &id) {
    std::vector<Judged> result;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        Parameter &p = parameters[k];
        if (id == p.term.id)
            result.push_back({&p, id == "Fmax"   ? Bound::upper
                                  : id == "Fmin" ? Bound::lower
                                                 : Bound::magnitude});
        if (id != "F" || std::string_view(p.term.id) != "Fmax")
            continue;
        const auto low = std::ranges::find_if(parameters, [&](const Parameter &q) {
            return std::string_view(q.term.id) == "Fmin" && q.index == p.index;
        });
        const bool lowRules =
            low != parameters.end() && low->value && p.value && std::abs(*low->value) > std::abs(*p.value);
        result.push_back({lowRules ? &*low : &p, Bound::magnitude});
    }
    return result;
}

void explainMissingValues(TestEvaluation &evaluation) {
    std::string symbols;
    for (const Parameter &p : evaluation.parameters) {
        if (!p.value && p.required)
            symbols += (symbols.empty() ? "" : ", ") + parameterId(p);
    }
    if (!symbols.empty())
        evaluation.findings.push_back(
            {Grade::requirement,
             "noValue",
             "",
             {REPORT_TEXT("report", "No value for %1: see what the test lacks."), {symbols}}});
}

} // namespace

TestEvaluation evaluateCircular(const Test &test, const Surroundings &surroundings, const Edition &edition) {
    const auto &measurement = std::get<CircularMeasurement>(test.measurement);
    TestEvaluation evaluation;
    evaluation.edition = &edition;
    evaluation.view = test.edition != edition.word;

    CircularResults results;
    iso230_4::Paths paths = iso230_4::paths(measurement);
    results.paths = std::move(paths.evaluated);
    results.repetitions = std::move(paths.repetitions);
    results.centringError = paths.centringError;
    results.circles = iso230_4::circles(results.paths);
    results.correction = iso230_4::correctionTo20(measurement);
    results.notCorrected = iso230_4::awayFrom20(measurement) && !iso230_4::isCorrected(measurement);

    CircularCase whole{test, measurement, surroundings, edition, results};
    for (auto rows = edition.circles->rows; !rows.empty();) {
        const auto quantity = rowsOfAQuantity(rows);
        rows = rows.subspan(quantity.size());
        if (quantity.front().external == whole.feedback())
            continue;
        if (quantity.front().of == CircularRow::Of::eachArc) {
            for (const EvaluatedPath &path : results.paths) {
                for (const CircularRow &row : quantity)
                    addParameter(evaluation, row, whole, &path, path.index);
            }
        } else if (whole.bothSenses()) {
            addParameter(evaluation, quantity.front(), whole, nullptr, results.paths.front().index);
        }
    }
    whole.uncertaintyStated = std::ranges::all_of(evaluation.parameters, [](const Parameter &p) {
        return !p.value || !p.required || p.expandedUncertainty;
    });

    for (const CircularRequirement &row : edition.circles->requirements) {
        if (auto message = row.unmet(whole))
            evaluation.findings.push_back({row.grade, row.id, row.clause, std::move(*message)});
    }
    explainMissingValues(evaluation);
    for (const CircularStatement &row : edition.circles->statements) {
        if (!row.stated(whole))
            evaluation.findings.push_back({Grade::requirement,
                                           row.id,
                                           edition.statementsClause,
                                           {REPORT_TEXT("report", "Not stated: %1."), {row.name}}});
    }
    findNotAgreed(edition, test, evaluation.findings);
    applyLimits(evaluation, test, results.notCorrected,
                [&](const std::string &id) { return judged(evaluation.parameters, id); });

    evaluation.results = std::move(results);
    return evaluation;
}

} // namespace palmer
