// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/testsofverdict.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>

namespace palmer {

namespace {

bool isSameSubject(const PositioningMeasurement &a, const PositioningMeasurement &b) {
    return a.axis.name == b.axis.name && a.axis.motion == b.axis.motion &&
           a.zone.has_value() == b.zone.has_value();
}

bool isSameSubject(const CircularMeasurement &a, const CircularMeasurement &b) {
    return a.plane == b.plane && a.source == b.source && a.nominalRadius == b.nominalRadius;
}

bool isSameSubject(const Unjudged auto & /*a*/, const Unjudged auto & /*b*/) {
    return false;
}

bool hasSameSubject(const Test &a, const Test &b) {
    return a.edition == b.edition &&
           areOfOneKind(a, b, [](const auto &x, const auto &y) { return isSameSubject(x, y); });
}

bool isRejected(const Test &test, const TestEvaluation &evaluation) {
    if (!evaluation.verdict)
        return false;
    const auto notEvaluable = [](const AgreedLimit &l) { return l.state == LimitState::notEvaluable; };
    if (std::ranges::any_of(evaluation.limits, notEvaluable))
        return true;
    if (test.decisionRule.rule == Rule::rejectionProven)
        return *evaluation.verdict == Verdict::doesNotConform;
    return *evaluation.verdict != Verdict::conforms;
}

} // namespace

bool countsForVerdict(const Document &document, std::size_t test) {
    if (document.tests[test]->role != TestRole::asFound)
        return true;
    return std::ranges::none_of(document.tests, [](const TestPointer &other) {
        return isJudged(*other) && other->role != TestRole::asFound;
    });
}

std::optional<std::size_t> testAsFound(const Document &document, std::size_t asLeft) {
    const auto &tests = document.tests;
    if (tests[asLeft]->role != TestRole::asLeft)
        return std::nullopt;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < tests.size() && (i < asLeft || !found); ++i) {
        if (tests[i]->role == TestRole::asFound && hasSameSubject(*tests[i], *tests[asLeft]))
            found = i;
    }
    return found;
}

bool hasRejection(const EvaluatedDocument &evaluated) {
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (countsForVerdict(*evaluated.document, i) &&
            isRejected(*evaluated.document->tests[i], *evaluated.tests[i]))
            return true;
    }
    const std::vector<SheetResult> sheet = evaluated.sheet();
    const std::optional<Verdict> verdict = verdictOf(sheet);
    const bool anyOpen =
        std::ranges::find(sheet, SheetState::notMeasured, &SheetResult::state) != sheet.end();
    return anyOpen || verdict == Verdict::doesNotConform ||
           (verdict == Verdict::notProven &&
            evaluated.document->report.decisionRule.rule != Rule::rejectionProven);
}

} // namespace palmer
