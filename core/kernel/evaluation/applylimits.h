// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <functional>
#include <string>
#include <vector>

namespace palmer {

/// A parameter to which a limit applies.
struct Judged {
    Parameter *parameter = nullptr;
    Bound bound = Bound::magnitude;
};

/// Returns the symbol of a key of `limits`, taken from another edition if necessary: "A↑" for "A+".
[[nodiscard]] std::string symbolOf(const std::string &key, const Edition &edition);

/// Returns the reason why a limit cannot be evaluated: "one run in each direction".
[[nodiscard]] Text notEvaluableText(NotEvaluable reason);

/// Applies the agreed limits of the test to its parameters: limit, guard band and verdict of each, and the
/// verdict of the test. `judged`: the parameters a key of `limits` applies to; if none, or if the limit was
/// agreed for another edition, a finding says so; `missing` gives the reason. A limit that cannot be
/// evaluated leaves the test not proven. Of two limits for one parameter, the parameter gets the one with the
/// worse verdict, with equal verdicts the one with less room, and a finding names it: the verdict of the test
/// is always the worst of its rows. If lengths do not hold at 20 °C, or this is open, rules that demand a
/// proof prove nothing that depends on them. A view has no verdicts.
void applyLimits(TestEvaluation &evaluation, const Test &test, At20 at20,
                 const std::function<std::vector<Judged>(const std::string &id)> &judged,
                 const std::function<NotEvaluable(const std::string &id)> &missing);

} // namespace palmer
