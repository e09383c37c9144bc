#include "kernel/evaluation/applylimits.h"

#include "kernel/evaluation/conformity.h"

namespace palmer {

namespace {

/// Agreed for the edition in use or one of its aliases.
bool holds(const Limit &limit, const TestEvaluation &evaluation) {
    if (!limit.edition)
        return true;
    const Edition *agreed = findEdition(*limit.edition);
    return agreed && std::string_view(agreed->family) == evaluation.edition->family;
}

Verdict decide(const Judged &judged, double limit, const DecisionRule &rule) {
    const Parameter &p = *judged.parameter;
    if (judged.bound == Bound::magnitude || !p.value)
        return decide(p.value, limit, p.guardedUncertainty(), rule);
    const double sign = judged.bound == Bound::upper ? 1 : -1;
    return decideUpper(sign * *p.value, sign * limit, p.guardedUncertainty(), rule);
}

} // namespace

void applyLimits(TestEvaluation &evaluation, const Test &test, bool notCorrected,
                 const std::function<std::vector<Judged>(const std::string &id)> &judged) {
    if (evaluation.view)
        return;
    bool uncertaintyMissing = false;
    for (const auto &[id, limit] : test.limits) {
        if (!limit.value)
            continue;
        const std::vector<Judged> found = judged(id);
        if (found.empty()) {
            evaluation.findings.push_back(
                {Grade::note,
                 "limits",
                 "",
                 {REPORT_TEXT("report",
                              "The limit of %1 has no verdict: this test has no such parameter under %2."),
                  {id, std::string(evaluation.edition->word)}}});
            continue;
        }
        if (!holds(limit, evaluation)) {
            evaluation.findings.push_back(
                {Grade::note,
                 "limits",
                 "",
                 {REPORT_TEXT("report", "The limit of %1 has no verdict: it was agreed for %2, the test is "
                                        "evaluated under %3."),
                  {id, *limit.edition, std::string(evaluation.edition->word)}}});
            continue;
        }
        for (const Judged &one : found) {
            Parameter &p = *one.parameter;
            p.limit = limit;
            p.guardBand = guardBand(p.guardedUncertainty(), test.decisionRule);
            p.verdict = decide(one, *limit.value, test.decisionRule);
            if (test.decisionRule.rule != Rule::simpleAcceptance) {
                // Where the budget decides in its place it is by the shift of the simulation.
                evaluation.provisional |= evaluation.uncertainty.outdated &&
                                          evaluation.uncertainty.method == UncertaintyMethod::monteCarlo;
                uncertaintyMissing |= !p.expandedUncertainty;
                if (notCorrected && p.dependsOnTemperature)
                    p.verdict = Verdict::notProven;
            }
            evaluation.verdict = worst(evaluation.verdict, p.verdict);
        }
    }
    if (uncertaintyMissing)
        evaluation.findings.push_back(
            {Grade::requirement,
             "decisionRule",
             "",
             {REPORT_TEXT("report", "The decision rule needs the measurement uncertainty: without it "
                                    "nothing is proven.")}});
}

} // namespace palmer
