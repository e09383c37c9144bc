// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/applylimits.h"

#include "kernel/evaluation/conformity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

/// True if agreed for the edition in use or one of its aliases.
bool holds(const Limit &limit, const TestEvaluation &evaluation) {
    if (!limit.edition)
        return true;
    const Edition *agreed = findEdition(*limit.edition);
    return agreed && std::string_view(agreed->family) == evaluation.edition->family;
}

Verdict decide(const Judged &judged, double limit, const DecisionRule &rule) {
    const Parameter &p = *judged.parameter;
    if (!p.value)
        return Verdict::notProven;
    return decideUpper(judgedValue(*p.value, judged.bound), judgedLimit(limit, judged.bound),
                       p.guardedUncertainty(), rule, roundingBeside(p, limit));
}

/// Returns the distance of the value from the limit; negative beyond it.
double room(const Parameter &p, double limit, Bound bound) {
    return p.value ? judgedLimit(limit, bound) - judgedValue(*p.value, bound) : 0;
}

void note(TestEvaluation &evaluation, const char *id, Source source, Message message) {
    Finding finding;
    finding.source = source;
    finding.subject = Subject::limits;
    finding.id = id;
    finding.keys = {id};
    finding.message = std::move(message);
    evaluation.findings.push_back(std::move(finding));
}

/// Why one of two limits rules.
enum class Rules { worseVerdict, tighter, alike };

void findSecondLimit(TestEvaluation &evaluation, const Parameter &p, const std::string &other, Rules why) {
    static constexpr std::array texts{
        // in the order of Rules
        REPORT_TEXT("report", "%1 is held against the limits of %2 and of %3: its row shows that of "
                              "%2, which has the worse verdict."),
        REPORT_TEXT("report", "%1 is held against the limits of %2 and of %3: its row shows that of "
                              "%2, which is the tighter one."),
        REPORT_TEXT("report", "%1 is held against the limits of %2 and of %3, which are equal: its row "
                              "shows that of %2.")};
    note(evaluation, "limits", Source::program,
         {texts.at(static_cast<std::size_t>(why)), {plainSymbol(p), p.limitOf, other}});
}

/// Stores the limit of `key` and its verdict in the parameter, unless the limit already stored rules. A limit
/// for the parameter itself (processed after F) replaces an equally tight one.
void enter(TestEvaluation &evaluation, const Judged &judged, const std::string &key, const Limit &limit,
           Verdict verdict) {
    Parameter &p = *judged.parameter;
    std::string other = p.limitOf;
    const std::optional<Verdict> before = p.verdict;
    const bool first = !p.limit;
    const Rules why = first || verdict != *before ? Rules::worseVerdict
                      : judgedLimit(*limit.value, judged.bound) == judgedLimit(*p.limit->value, p.bound)
                          ? Rules::alike
                          : Rules::tighter;
    if (first || verdict > *before ||
        (verdict == *before && room(p, *limit.value, judged.bound) <= room(p, *p.limit->value, p.bound))) {
        p.limit = limit;
        p.limitOf = key;
        p.bound = judged.bound;
        p.verdict = verdict;
    } else {
        other = key;
    }
    if (!first)
        findSecondLimit(evaluation, p, other, why);
}

/// Appends to a list: "A, B". Once, for a result may have two limits, as Fmax has that of F.
void add(std::string &list, const std::string &symbol) {
    if ((", " + list + ", ").find(", " + symbol + ", ") == std::string::npos)
        list += (list.empty() ? "" : ", ") + symbol;
}

/// Returns why a limit cannot be evaluated; null if it can. `found`: the results it applies to.
std::optional<NotEvaluable> reasonForNone(const std::string &id, const Limit &limit,
                                          const std::vector<Judged> &found, const TestEvaluation &evaluation,
                                          const std::function<NotEvaluable(const std::string &id)> &missing) {
    if (!holds(limit, evaluation))
        return NotEvaluable::otherEdition;
    const auto valueless = [](const Judged &one) { return !one.parameter->value; };
    if (found.empty() || std::ranges::any_of(found, valueless))
        return missing(id);
    return std::nullopt;
}

/// Returns the sentence for a limit that applies to no result.
Message noVerdict(const AgreedLimit &agreed, const char *edition) {
    switch (*agreed.reason) {
    case NotEvaluable::otherEdition:
        return {REPORT_TEXT("report", "The limit of %1 has no verdict: it was agreed for %2, the test is "
                                      "evaluated under %3."),
                {agreed.symbol, Designation{*agreed.limit.edition}, Designation{edition}}};
    case NotEvaluable::noSuchParameter:
        return {REPORT_TEXT("report",
                            "The limit of %1 has no verdict: this test has no such parameter under %2."),
                {agreed.symbol, Designation{edition}}};
    default:
        return {REPORT_TEXT("report", "The limit of %1 cannot be evaluated: %2."),
                {agreed.symbol, notEvaluableText(*agreed.reason)}};
    }
}

LimitState stateOf(Verdict verdict) {
    return verdict == Verdict::conforms    ? LimitState::respected
           : verdict == Verdict::notProven ? LimitState::notProven
                                           : LimitState::exceeded;
}

/// Reported even if the edition permits the temperature: the decision rule does not.
void findUncorrected(TestEvaluation &evaluation, At20 at20, const std::string &symbols) {
    if (symbols.empty())
        return;
    note(evaluation, "decisionRule", Source::laboratory,
         {at20 == At20::wrong
              ? REPORT_TEXT("report", "Nothing is proven for %1: results that depend on the temperature are "
                                      "not corrected to 20 °C.")
              : REPORT_TEXT("report", "Nothing is proven for %1: results that depend on the temperature are "
                                      "not shown to hold at 20 °C."),
          {symbols}});
}

/// Reports U that is large compared with the limits, whatever the verdicts.
void findLargeUncertainty(TestEvaluation &evaluation, const DecisionRule &rule) {
    std::string guarded;
    std::string large;
    for (const Parameter &p : evaluation.parameters) {
        if (!p.limit || !p.limit->value)
            continue;
        const double limit = std::abs(*p.limit->value);
        const bool byRule = rule.rule != Rule::simpleAcceptance;
        if (byRule && p.bound == Bound::magnitude && p.guardBand && *p.guardBand >= limit)
            add(guarded, plainSymbol(p));
        if (p.expandedUncertainty && *p.expandedUncertainty > limit / 2)
            add(large, plainSymbol(p));
    }
    if (!guarded.empty())
        note(evaluation, "guardBand", Source::laboratory,
             {REPORT_TEXT("report", "%1: the guard band reaches the limit; no value can meet it."),
              {guarded}});
    if (!large.empty())
        note(evaluation, "largeUncertainty", Source::laboratory,
             {REPORT_TEXT("report", "%1: U is more than half the limit."), {large}});
}

} // namespace

std::string symbolOf(const std::string &key, const Edition &edition) {
    const std::span<const Edition *const> others = editionsOf(edition.kind);
    std::vector<const Edition *> known{&edition};
    known.insert(known.end(), others.begin(), others.end());
    for (const Edition *one : known) {
        for (const Term *term : termsOf(*one)) {
            if (key == term->id)
                return std::string(term->symbol.base) + term->symbol.subscript + term->symbol.arrow;
        }
    }
    return key; // "F", which covers Fmax and Fmin
}

Text notEvaluableText(NotEvaluable reason) {
    static constexpr std::array texts{
        // in the order of NotEvaluable
        REPORT_TEXT("report", "one run in each direction"),
        REPORT_TEXT("report", "a direction was not measured"),
        REPORT_TEXT("report", "a sense was not measured"),
        REPORT_TEXT_FOR("report", "feedback signal", "why a limit cannot be evaluated"),
        REPORT_TEXT("report", "reference length not calibrated"),
        REPORT_TEXT("report", "calibration of the reference length not stated"),
        REPORT_TEXT("report", "not a parameter of this test"),
        REPORT_TEXT("report", "agreed for another edition"),
        REPORT_TEXT_FOR("report", "no value", "why a limit cannot be evaluated")};
    return texts.at(static_cast<std::size_t>(reason));
}

namespace {

/// Reports a limit that looks like millimetres compared with results in micrometres.
void findScale(TestEvaluation &evaluation, const Parameter &p, double limit) {
    constexpr double suspicious = 1000;
    if (!p.value || !(*p.value > 0) || !(limit > suspicious * *p.value))
        return;
    note(evaluation, "limits", Source::program,
         {REPORT_TEXT("report", "%1: the limit is %2 times the value; is its unit right?"),
          {plainSymbol(p), Number{std::floor(limit / *p.value), Quantity::count, 0}}});
    evaluation.findings.back().id = "limitScale";
}

/// Facts reported once for all limits.
struct Seen {
    bool uncertaintyMissing = false;
    std::string uncorrected; ///< symbols
};

/// Judges one result by a limit and updates its parameter, the limit and the verdict of the test.
void judge(TestEvaluation &evaluation, const Judged &one, const Limit &limit, const DecisionRule &rule,
           At20 at20, AgreedLimit &agreed, Seen &seen) {
    Parameter &p = *one.parameter;
    p.guardBand = guardBand(p.guardedUncertainty(), rule);
    Verdict verdict = decide(one, *limit.value, rule);
    if (rule.rule != Rule::simpleAcceptance) {
        // Even where the budget decides instead, the reason is a shift found by the simulation.
        evaluation.provisional |=
            evaluation.uncertainty.outdated && evaluation.uncertainty.method == UncertaintyMethod::monteCarlo;
        seen.uncertaintyMissing |= !p.expandedUncertainty;
        if (p.dependsOnTemperature && at20 != At20::hold) { // an expansion raises a value or lowers it
            verdict = Verdict::notProven;
            add(seen.uncorrected, plainSymbol(p));
        }
    }
    if (p.calibrationOpen && verdict != Verdict::doesNotConform) {
        verdict = Verdict::notProven;
        agreed.state = std::max(agreed.state, LimitState::notEvaluable);
        agreed.reason = NotEvaluable::calibrationOpen;
    }
    enter(evaluation, one, agreed.key, limit, verdict);
    findScale(evaluation, p, *limit.value);
    evaluation.verdict = worst(evaluation.verdict, verdict);
    if (p.value)
        agreed.state = std::max(agreed.state, stateOf(verdict));
}

} // namespace

void applyLimits(TestEvaluation &evaluation, const Test &test, At20 at20,
                 const std::function<std::vector<Judged>(const std::string &id)> &judged,
                 const std::function<NotEvaluable(const std::string &id)> &missing) {
    if (evaluation.view)
        return;
    Seen seen;
    std::string negative;
    for (const auto &[id, limit] : test.limits) {
        if (!limit.value)
            continue;
        const std::vector<Judged> found = judged(id);
        AgreedLimit agreed{id, symbolOf(id, *evaluation.edition), limit, LimitState::respected, {}, {}};
        for (const Judged &one : found)
            agreed.parameters.push_back(parameterId(*one.parameter));
        agreed.reason = reasonForNone(id, limit, found, evaluation, missing);
        if (agreed.reason) {
            agreed.state = LimitState::notEvaluable;
            evaluation.verdict = worst(evaluation.verdict, Verdict::notProven);
        }
        if (found.empty() || agreed.reason == NotEvaluable::otherEdition) {
            note(evaluation, "limits", Source::program, noVerdict(agreed, evaluation.edition->word));
            evaluation.limits.push_back(std::move(agreed));
            continue;
        }
        if (*limit.value < 0 && found.front().bound == Bound::magnitude)
            add(negative, agreed.symbol);
        for (const Judged &one : found)
            judge(evaluation, one, limit, test.decisionRule, at20, agreed, seen);
        if (agreed.state != LimitState::notEvaluable)
            agreed.reason = {};
        evaluation.limits.push_back(std::move(agreed));
    }
    if (!negative.empty())
        note(evaluation, "limits", Source::laboratory,
             {REPORT_TEXT("report", "The limit of %1 is negative; no value can meet it."), {negative}});
    findUncorrected(evaluation, at20, seen.uncorrected);
    if (seen.uncertaintyMissing)
        note(evaluation, "decisionRule", Source::laboratory,
             {REPORT_TEXT("report", "The decision rule needs the measurement uncertainty: without it "
                                    "nothing is proven.")});
    findLargeUncertainty(evaluation, test.decisionRule);
}

} // namespace palmer
