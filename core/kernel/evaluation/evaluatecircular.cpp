// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/evaluation/instrumentresult.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/iso230_4/results.h"
#include "kernel/uncertainty/circularbudget.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// Returns U as stated by the laboratory; for F that of Fmax and Fmin.
std::optional<double> statedUncertainty(const CircularMeasurement &measurement, const Parameter &p) {
    const auto &expanded = measurement.uncertainty.expanded;
    auto found = expanded.find(p.term.id);
    if (found == expanded.end())
        found = expanded.find(p.term.also);
    if (found == expanded.end() || !(found->second >= 0) || !std::isfinite(found->second))
        return std::nullopt;
    return found->second / 1000; // µm
}

Parameter parameter(const iso230_4::ListedParameter &listed, const CircularCase &test) {
    Parameter result;
    result.term = listed.row->term;
    result.index = listed.index;
    result.dependsOnTemperature = listed.row->dependsOnTemperature;
    result.calibrationOpen = listed.row->dependsOnTemperature && !test.measurement.referenceLength.calibrated;
    result.required = test.isRequired(listed.row->term);
    result.value = iso230_4::value(listed, test);
    result.size = test.measurement.nominalRadius;
    return result;
}

/// Records the inputs missing for the uncertainty of a parameter.
void noteMissing(std::vector<MissingInput> &missing, const CircularBudget &budget,
                 const CircularContributions &uses, const Parameter &parameter) {
    for (const Contribution &contribution : budget.contributions) {
        if (!takesUp(uses, contribution.id))
            continue;
        for (const InputDefect &defect : contribution.defects) {
            auto known = std::ranges::find(missing, defect, &MissingInput::defect);
            if (known == missing.end()) {
                missing.push_back({defect, {}});
                known = missing.end() - 1;
            }
            known->results += (known->results.empty() ? "" : ", ") + plainSymbol(parameter);
        }
    }
}

/// Adds budget, simulation and stated uncertainty; returns the missing inputs with the results affected.
std::vector<MissingInput> addUncertainty(TestEvaluation &evaluation, const CircularCase &test,
                                         const std::vector<iso230_4::ListedParameter> &listed) {
    const CircularUncertaintyInputs &inputs = test.measurement.uncertainty;
    std::vector<std::optional<double>> repeated(listed.size());
    if (usesContributions(inputs.method) && !inputs.repeatability)
        repeated = iso230_4::repeatabilities(test);
    const auto largest =
        std::ranges::max_element(repeated, {}, [](const std::optional<double> &s) { return s.value_or(-1); });
    std::size_t points = 0;
    for (const EvaluatedPath &path : test.results.paths)
        points += path.points.size();
    const CircularBudget budget = circularBudget(test.measurement, test.surroundings.environmentalVariation,
                                                 largest == repeated.end() ? std::nullopt : *largest, points);
    CircularContributions anyUses;

    std::vector<MissingInput> missing;
    bool complete = true;
    bool any = false;
    for (std::size_t k = 0; k < listed.size(); ++k) {
        Parameter &p = evaluation.parameters[k];
        if (!p.value)
            continue;
        const CircularContributions uses = contributionsOf(p.term.circle, test.measurement.centring);
        p.budgetUncertainty = combined(budget, uses, repeated[k]);
        anyUses.length |= uses.length;
        anyUses.centring |= uses.centring;
        anyUses.noise |= uses.noise;
        any |= p.budgetUncertainty.has_value();
        if (p.budgetUncertainty || !p.required)
            continue;
        complete = false;
        noteMissing(missing, budget, uses, p);
    }
    for (const Contribution &contribution : budget.contributions) {
        if (takesUp(anyUses, contribution.id))
            evaluation.uncertainty.contributions.push_back(contribution);
    }
    evaluation.uncertainty.complete = any && complete;
    decideUncertainty(evaluation, inputs.method, test.surroundings,
                      [&](const Parameter &p) { return statedUncertainty(test.measurement, p); });
    return missing;
}

/// Returns why budget and simulation differ: the first reason confirmed by computation.
Message reasonOfDifference(const Parameter &p, const TestEvaluation &evaluation,
                           const CircularMeasurement &measurement) {
    const SimulatedParameter &simulated = *p.simulated;
    const double byBudget = *p.budgetUncertainty;
    const auto without = [&](std::initializer_list<std::string_view> ids) {
        double squares = byBudget * byBudget;
        for (const Contribution &one : evaluation.uncertainty.contributions) {
            if (std::ranges::find(ids, one.id) != ids.end())
                squares -= one.expanded.value_or(0) * one.expanded.value_or(0);
        }
        return std::sqrt(std::max(0.0, squares));
    };
    const bool width = !p.dependsOnTemperature; // G and G(b); F and D are distances
    const bool smaller = simulated.expanded() < byBudget;
    const bool noise = measurement.uncertainty.pointNoise.value_or(0) > 0 ||
                       measurement.uncertainty.resolution.value_or(0) > 0;
    if (width && smaller &&
        (methodsAgree(simulated.expanded(), without({driftId})) ||
         methodsAgree(simulated.expanded(), without({driftId, displacementId}))))
        return {REPORT_TEXT(
            "report", "%1: budget and Monte Carlo differ by more than 20 %: an error that all points of "
                      "a path have in common moves the circle and leaves its width; the budget counts "
                      "it in full.")};
    if (methodsAgree(2 * simulated.u, byBudget))
        return {notNormallyDistributed};
    if (noise && !smaller)
        return {REPORT_TEXT("report", "%1: budget and Monte Carlo differ by more than 20 %: the simulation "
                                      "follows the extreme points of the path and their noise.")};
    return {noKnownReason};
}

/// Returns the parameters a key of `limits` applies to. F means the larger of |Fmax| and |Fmin| of each path.
std::vector<Judged> judged(std::vector<Parameter> &parameters, const std::string &id) {
    std::vector<Judged> result;
    for (Parameter &p : parameters) {
        if (id == p.term.id)
            result.push_back({&p, p.term.bound});
        if (id != p.term.also || p.term.bound != Bound::upper)
            continue;
        const auto low = std::ranges::find_if(parameters, [&](const Parameter &q) {
            return id == q.term.also && q.term.bound == Bound::lower && q.index == p.index;
        });
        const bool lowRules =
            low != parameters.end() && low->value && p.value && std::abs(*low->value) > std::abs(*p.value);
        result.push_back({lowRules ? &*low : &p, Bound::magnitude});
    }
    return result;
}

/// Returns why the limit of a quantity cannot be evaluated.
NotEvaluable whyMissing(const std::string &id, const CircularCase &test) {
    const auto &rows = test.edition.circles->rows;
    const auto row = std::ranges::find_if(rows, [&](const CircularRow &r) { return r.term.isMeantBy(id); });
    if (row == rows.end())
        return NotEvaluable::noSuchParameter;
    if (row->external == test.feedback())
        return test.feedback() ? NotEvaluable::feedbackSignal : NotEvaluable::noSuchParameter;
    if (row->term.of == Of::pair && !test.bothSenses())
        return NotEvaluable::oneSense;
    return row->dependsOnTemperature && test.notCalibrated() ? NotEvaluable::notCalibrated
                                                             : NotEvaluable::noValue;
}

void findNoValue(TestEvaluation &evaluation, Message message) {
    Finding finding;
    finding.id = "noValue";
    finding.explains = Explains::missingValues;
    finding.message = std::move(message);
    evaluation.findings.push_back(std::move(finding));
}

/// `whole`: its required results may have names that this test does not know.
void explainMissingValues(TestEvaluation &evaluation, const CircularCase &whole) {
    std::string symbols;
    for (const Parameter &p : evaluation.parameters) {
        if (!p.value && p.required)
            symbols += (symbols.empty() ? "" : ", ") + plainSymbol(p);
    }
    if (!symbols.empty())
        findNoValue(evaluation,
                    {REPORT_TEXT("report", "No value for %1: see what the test lacks."), {symbols}});
    for (const std::string &word : whole.measurement.requiredResults) {
        const bool given = std::ranges::any_of(evaluation.parameters,
                                               [&](const Parameter &p) { return p.term.isMeantBy(word); });
        const NotEvaluable reason = whyMissing(word, whole);
        if (!given && (reason == NotEvaluable::noSuchParameter || reason == NotEvaluable::feedbackSignal))
            findNoValue(evaluation, {REPORT_TEXT("report", "The required result %1 has no value: %2."),
                                     {symbolOf(word, whole.edition), notEvaluableText(reason)}});
    }
}

} // namespace

TestEvaluation evaluateCircular(const Test &test, const Surroundings &surroundings, const Edition &edition) {
    const auto &measurement = std::get<CircularMeasurement>(test.measurement);
    TestEvaluation evaluation;
    evaluation.edition = &edition;
    evaluation.view = test.edition != edition.word;

    CircularResults results = iso230_4::circularResults(measurement);
    CircularCase whole{test, measurement, surroundings, edition, results};
    const auto listed = iso230_4::listedParameters(whole);
    for (const iso230_4::ListedParameter &one : listed)
        evaluation.parameters.push_back(parameter(one, whole));
    if (std::ranges::none_of(evaluation.parameters, &Parameter::required)) {
        for (Parameter &p : evaluation.parameters) // a report without any results would say nothing
            p.required = true;
    }
    const std::vector<MissingInput> missing = addUncertainty(evaluation, whole, listed);
    whole.withoutUncertainty = resultsWithoutUncertainty(evaluation.parameters);

    judge(edition.circles->requirements, whole, evaluation.findings);
    explainMissingValues(evaluation, whole);
    findNotAgreed(edition, test, evaluation.findings);
    findUncertainty(evaluation, missing,
                    [&](const Parameter &p) { return reasonOfDifference(p, evaluation, measurement); });
    applyLimits(
        evaluation, test, results.at20,
        [&](const std::string &id) { return judged(evaluation.parameters, id); },
        [&](const std::string &id) { return whyMissing(id, whole); });
    findOtherResults(evaluation, test, surroundings);

    evaluation.results = std::move(results);
    return evaluation;
}

} // namespace palmer
