// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/rejection.h"

#include "document/testsofverdict.h"

#include <algorithm>

namespace palmer {

namespace {

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

bool hasRejection(const EvaluatedDocument &evaluated) {
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (countsForVerdict(*evaluated.document, i) &&
            isRejected(*evaluated.document->tests[i], *evaluated.tests[i]))
            return true;
    }
    return false;
}

} // namespace palmer
