// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"

#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/applylimits.h"
#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/evaluation/instrumentresult.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/correction.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/evaluation/positioninguncertainty.h"
#include "kernel/uncertainty/positioningbudget.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

int runsOf(const PositioningMeasurement &measurement, Direction direction) {
    return static_cast<int>(std::ranges::count(measurement.runs, direction, &Run::approach));
}

/// Returns what the test offers to parameters: its directions, and s if any direction has more than one run.
unsigned offered(const PositioningResults &results) {
    unsigned bits = 0;
    if (results.upward)
        bits |= upward;
    if (results.downward)
        bits |= downward;
    if (std::max(results.positiveRuns, results.negativeRuns) > 1)
        bits |= scatter;
    return bits;
}

/// Returns U as stated by the laboratory.
std::optional<double> statedUncertainty(const PositioningMeasurement &measurement, const Parameter &p) {
    const auto found = measurement.uncertainty.expanded.find(p.term.id);
    if (found == measurement.uncertainty.expanded.end() || !(found->second >= 0) ||
        !std::isfinite(found->second))
        return std::nullopt; // a negative U would reverse the guard band
    return found->second / (measurement.axis.motion == Motion::linear ? 1000.0 : 3600.0); // µm, arc seconds
}

std::vector<MissingInput> missingInputs(const PositioningBudget &budget) {
    std::vector<MissingInput> missing;
    for (const Contribution &contribution : budget.contributions) {
        for (const InputDefect &defect : contribution.defects) {
            if (std::ranges::find(missing, defect, &MissingInput::defect) == missing.end())
                missing.push_back({defect, {}});
        }
    }
    return missing;
}

Parameter parameter(const Row &row, const PositioningMeasurement &measurement,
                    std::span<const TargetStatistics> targets, double c) {
    Parameter result;
    result.term = row.term;
    result.dependsOnTemperature = row.dependsOnTemperature;
    if (measurement.axis.motion == Motion::rotary)
        result.term.quantity = Quantity::angularDeviation;
    const Outcome outcome = (*row.value)(targets, c);
    if (std::isfinite(outcome.value)) {
        result.value = outcome.value;
        result.ruling = outcome.ruling;
    }
    return result;
}

/// Explains why parameters have no value: the first target with a missing statistic and the parameters
/// affected, except those given only on request, which no clause on results asks for.
void explainMissingValues(TestEvaluation &evaluation, std::span<const TargetStatistics> targets,
                          const PositioningResults &results, const Edition &edition) {
    std::string symbols;
    for (const Parameter &p : evaluation.parameters) {
        if (!p.value && p.term.printed == Printed::always)
            symbols += (symbols.empty() ? "" : ", ") + plainSymbol(p);
    }
    if (symbols.empty())
        return;
    const auto missing = [&](auto &&statistic) -> std::string {
        std::string where;
        for (std::size_t i = 0; i < targets.size() && where.empty(); ++i) {
            if (results.upward && std::isnan(statistic(targets[i].positive)))
                where = std::to_string(i + 1) + "↑";
            else if (results.downward && std::isnan(statistic(targets[i].negative)))
                where = std::to_string(i + 1) + "↓";
        }
        return where;
    };
    const std::string noMean = missing([](const DirectionStatistics &d) { return d.mean; });
    const std::string noScatter = missing([](const DirectionStatistics &d) { return d.s; });
    Message message;
    if (targets.empty())
        message = {REPORT_TEXT("report", "No value for %1: the test has no targets."), {symbols}, {}};
    else if (!noMean.empty())
        message = {
            REPORT_TEXT("report", "No value for %1: target %2 has no reading."), {symbols, noMean}, {}};
    else
        message = {REPORT_TEXT("report", "No value for %1: target %2 has no s."), {symbols, noScatter}, {}};
    // ISO 230-2:1988 asks for R, A and the mean reversal value.
    const bool asked = *edition.resultsClause != 0;
    Finding finding;
    finding.id = "noValue";
    finding.explains = Explains::missingValues;
    finding.message = std::move(message);
    if (asked) {
        finding.grade = Grade::requirement;
        finding.source = Source::text;
        finding.state = State::unmet;
        finding.clause = edition.resultsClause;
    }
    evaluation.findings.push_back(std::move(finding));
}

/// Returns why the limit of a parameter cannot be evaluated.
NotEvaluable whyMissing(const std::string &id, const Edition &edition, unsigned offers) {
    const auto row = std::ranges::find_if(edition.rows, [&](const Row &r) { return id == r.term.id; });
    if (row == edition.rows.end())
        return NotEvaluable::noSuchParameter;
    const unsigned lacks = row->needs & ~offers;
    return (lacks & bothWays) != 0 ? NotEvaluable::oneDirection
           : lacks != 0            ? NotEvaluable::oneRun
                                   : NotEvaluable::noValue;
}

/// Returns the results that precede the parameters.
PositioningResults statisticsOf(const PositioningMeasurement &measurement, const Edition &edition) {
    PositioningResults results;
    results.positiveRuns = runsOf(measurement, Direction::positive);
    results.negativeRuns = runsOf(measurement, Direction::negative);
    results.upward = results.positiveRuns > 0;
    results.downward = results.negativeRuns > 0;
    if (edition.rangeMethod)
        results.standardDeviation = measurement.standardDeviation;
    if (auto corrections = iso230_2::correctionsTo20(measurement))
        results.corrections = std::move(*corrections);
    results.at20 = iso230_2::lengthsAt20(measurement);

    const Readings table = readings(measurement, results.corrections);
    results.targets.resize(measurement.targets.size());
    statistics(table.view(), results.standardDeviation, results.targets);
    results.drift = driftStatistic(table.view(), results.targets);
    return results;
}

} // namespace

TestEvaluation evaluatePositioning(const Test &test, const Surroundings &surroundings,
                                   const Edition &edition) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    TestEvaluation evaluation;
    evaluation.edition = &edition;
    evaluation.view = test.edition != edition.word;

    PositioningResults results = statisticsOf(measurement, edition);
    const unsigned offers = offered(results);
    for (const Row &row : edition.rows) {
        if ((row.needs & ~offers) == 0)
            evaluation.parameters.push_back(parameter(row, measurement, results.targets, edition.c));
    }

    const PositioningBudget budget = positioningBudget(measurement, surroundings.environmentalVariation);
    addPositioningBudget(evaluation, measurement, budget, results.targets);
    decideUncertainty(evaluation, measurement.uncertainty.method, surroundings,
                      [&](const Parameter &p) { return statedUncertainty(measurement, p); });
    const PositioningCase whole{test,
                                measurement,
                                surroundings,
                                edition,
                                results.targets,
                                results.drift,
                                results.positiveRuns,
                                results.negativeRuns,
                                resultsWithoutUncertainty(evaluation.parameters)};
    results.judgedAsZone = whole.zoneTest();

    results.countByPractice = whole.longAxis() || !whole.linear();
    results.stepCycleAgreed = edition.stepCycleByAgreement && measurement.cycle == Cycle::step &&
                              iso230_2::stepCycleInWriting(whole);
    results.stepCycleNotAgreed =
        edition.stepCycleByAgreement && measurement.cycle == Cycle::step && !results.stepCycleAgreed;

    judge(edition.requirements, whole, evaluation.findings);
    explainMissingValues(evaluation, results.targets, results, edition);
    findNotAgreed(edition, test, evaluation.findings);
    findUncertainty(evaluation, missingInputs(budget), [&](const Parameter &p) {
        return reasonOfDifference(p, evaluation, measurement, budget, results.targets);
    });
    applyLimits(
        evaluation, test, results.at20,
        [&](const std::string &id) {
            const auto found = std::ranges::find_if(evaluation.parameters,
                                                    [&](const Parameter &p) { return id == p.term.id; });
            return found == evaluation.parameters.end() ? std::vector<Judged>{}
                                                        : std::vector<Judged>{{&*found}};
        },
        [&](const std::string &id) { return whyMissing(id, edition, offers); });
    findOtherResults(evaluation, test, surroundings);

    evaluation.results = std::move(results);
    return evaluation;
}

} // namespace palmer
