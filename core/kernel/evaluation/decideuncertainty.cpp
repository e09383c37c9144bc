// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/decideuncertainty.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// Returns the symbols of the parameters for which `holds` is true: "A, E, M".
template <class Predicate>
std::string symbolsOf(std::span<const Parameter> parameters, Predicate holds) {
    std::string symbols;
    for (const Parameter &parameter : parameters) {
        if (holds(parameter))
            symbols += (symbols.empty() ? "" : ", ") + plainSymbol(parameter);
    }
    return symbols;
}

bool shifted(const Parameter &parameter) {
    return parameter.simulated && parameter.simulated->largeShift();
}

void note(TestEvaluation &evaluation, const char *id, Message message) {
    Finding finding;
    finding.subject = Subject::uncertainty;
    finding.id = id;
    finding.keys = {std::string("uncertainty.") + id};
    finding.message = std::move(message);
    evaluation.findings.push_back(std::move(finding));
}

void findMissing(TestEvaluation &evaluation, const std::vector<MissingInput> &missing) {
    for (const auto &[defect, results] : missing) {
        if (results.empty())
            note(evaluation, defect.key,
                 {defect.impossible
                      ? REPORT_TEXT("report", "No uncertainty by the budget: impossible as stated: %1.")
                      : REPORT_TEXT("report", "No uncertainty by the budget: not stated: %1."),
                  {defect.name}});
        else
            note(evaluation, defect.key,
                 {defect.impossible
                      ? REPORT_TEXT("report", "No uncertainty of %1 by the budget: impossible as stated: %2.")
                      : REPORT_TEXT("report", "No uncertainty of %1 by the budget: not stated: %2."),
                  {results, defect.name}});
        evaluation.findings.back().missing = true;
    }
}

void findFewTrials(TestEvaluation &evaluation, bool simulationDecides) {
    note(evaluation, "monteCarlo",
         {simulationDecides
              ? REPORT_TEXT_COUNTED(
                    "report",
                    "The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) never "
                    "decide. The budget U is used for the verdict.")
              : REPORT_TEXT_COUNTED(
                    "report", "The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) are "
                              "shown and never decide."),
          {Number{static_cast<double>(fewestDecidingTrials), Quantity::count}},
          static_cast<int>(evaluation.uncertainty.simulation->trials)});
}

void findDifferences(TestEvaluation &evaluation, const std::function<Message(const Parameter &)> &reason) {
    std::vector<std::pair<Message, std::string>> reasons; // in the order of the parameters
    for (const Parameter &parameter : evaluation.parameters) {
        if (!methodsDiffer(parameter))
            continue;
        Message message = reason(parameter);
        auto known = std::ranges::find(reasons, message, &std::pair<Message, std::string>::first);
        if (known == reasons.end()) {
            reasons.emplace_back(std::move(message), std::string());
            known = reasons.end() - 1;
        }
        known->second += (known->second.empty() ? "" : ", ") + plainSymbol(parameter);
    }
    for (auto &[message, symbols] : reasons) {
        message.arguments.insert(message.arguments.begin(), symbols);
        note(evaluation, "uncertaintyMethods", std::move(message));
    }
}

} // namespace

std::string resultsWithoutUncertainty(std::span<const Parameter> parameters) {
    return symbolsOf(parameters, [](const Parameter &p) {
        const bool printed = p.required && p.term.printed == Printed::always;
        return p.value && printed && !p.expandedUncertainty;
    });
}

bool methodsDiffer(const Parameter &parameter) {
    if (!parameter.budgetUncertainty || !parameter.simulated)
        return false;
    const double budget = *parameter.budgetUncertainty;
    return std::abs(parameter.simulated->expanded() - budget) > agreementOfMethods * budget;
}

void decideUncertainty(TestEvaluation &evaluation, UncertaintyMethod method, const Surroundings &surroundings,
                       const std::function<std::optional<double>(const Parameter &)> &stated) {
    UncertaintyEvaluation &uncertainty = evaluation.uncertainty;
    uncertainty.method = method;
    const auto &simulation = surroundings.simulation;
    if (simulation && simulation->edition == evaluation.edition->word) {
        uncertainty.simulation = simulation;
        uncertainty.outdated = surroundings.simulationOutdated;
        for (Parameter &parameter : evaluation.parameters) {
            const SimulatedParameter *simulated = simulation->find(parameterId(parameter));
            if (simulated && parameter.value)
                parameter.simulated = *simulated;
        }
    }
    for (Parameter &parameter : evaluation.parameters) {
        UncertaintyMethod by = method;
        const bool trusted = !uncertainty.simulation || uncertainty.simulation->mayDecide();
        if (by == UncertaintyMethod::monteCarlo && (shifted(parameter) || !trusted))
            by = UncertaintyMethod::budget;
        switch (by) {
        case UncertaintyMethod::none:
            break;
        case UncertaintyMethod::budget:
            parameter.expandedUncertainty = parameter.budgetUncertainty;
            break;
        case UncertaintyMethod::budgetActual: // a parameter without S has only one U
            parameter.expandedUncertainty =
                parameter.actualUncertainty ? parameter.actualUncertainty : parameter.budgetUncertainty;
            break;
        case UncertaintyMethod::monteCarlo:
            if (parameter.simulated)
                parameter.expandedUncertainty = parameter.simulated->expanded();
            break;
        case UncertaintyMethod::direct:
            parameter.expandedUncertainty = stated(parameter);
            break;
        }
        if (parameter.expandedUncertainty)
            parameter.decidedBy = by;
    }
}

void findUncertainty(TestEvaluation &evaluation, const std::vector<MissingInput> &missing,
                     const std::function<Message(const Parameter &)> &reason) {
    const UncertaintyEvaluation &uncertainty = evaluation.uncertainty;
    const bool simulationDecides = uncertainty.method == UncertaintyMethod::monteCarlo;
    if (!usesContributions(uncertainty.method))
        return;
    findMissing(evaluation, missing);
    if (!uncertainty.simulation) {
        if (simulationDecides && uncertainty.complete)
            note(evaluation, "monteCarlo",
                 {REPORT_TEXT("report", "The Monte Carlo simulation that is to give the uncertainty was not "
                                        "run.")});
        else if (simulationDecides && !missing.empty())
            note(
                evaluation, "monteCarlo",
                {REPORT_TEXT("report", "The Monte Carlo simulation that is to give the uncertainty cannot be "
                                       "run: it takes all results at once, and of some the budget lacks an "
                                       "input.")});
        return;
    }
    if (uncertainty.outdated)
        note(
            evaluation, "monteCarlo",
            {REPORT_TEXT("report", "The Monte Carlo simulation was run before the last edit of the test: its "
                                   "figures are outdated.")});
    if (!uncertainty.simulation->mayDecide()) {
        // Shifts and differences of so few trials mean nothing.
        findFewTrials(evaluation, simulationDecides);
        return;
    }
    if (!uncertainty.simulation->stable)
        note(evaluation, "monteCarlo",
             {REPORT_TEXT("report",
                          "The Monte Carlo simulation ended before two places of the uncertainty were "
                          "stable.")});
    const std::string symbols = symbolsOf(evaluation.parameters, shifted);
    if (!symbols.empty())
        note(
            evaluation, "monteCarloShift",
            {simulationDecides
                 ? REPORT_TEXT("report",
                               "Measurement errors bias %1 by more than a third of the uncertainty "
                               "that the Monte Carlo simulation gives: the budget U is used for the verdict.")
                 : REPORT_TEXT("report", "Measurement errors bias %1 by more than a third of the uncertainty "
                                         "that the Monte Carlo simulation gives."),
             {symbols}});
    findDifferences(evaluation, reason);
}

} // namespace palmer
