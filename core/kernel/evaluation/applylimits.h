// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"

#include <functional>
#include <string>
#include <vector>

namespace palmer {

/// A parameter that a limit is for.
struct Judged {
    Parameter *parameter = nullptr;
    Bound bound = Bound::magnitude;
};

/// Why a limit cannot be evaluated, in words: "one run in each direction".
[[nodiscard]] Text notEvaluableText(NotEvaluable reason);

/// Puts the agreed limits of the test on its parameters, decides, and sums up: limit, guard band and verdict
/// of each, verdict of the test. `judged`: the parameters a key of `limits` is for; none: a finding says so,
/// as it does for a limit agreed for another edition; `missing` says why there are none. A limit that cannot
/// be evaluated leaves the test not proven. Of two limits for one parameter its row has the one
/// with the worse verdict, of equal verdicts the one with less room, and a finding says which: the verdict of
/// the test is always the worst of its rows. Where lengths do not hold at 20 °C, rules that ask for a proof
/// prove nothing of what depends on them; where that is open, they do not prove conformity. A view has no
/// verdicts.
void applyLimits(TestEvaluation &evaluation, const Test &test, At20 at20,
                 const std::function<std::vector<Judged>(const std::string &id)> &judged,
                 const std::function<NotEvaluable(const std::string &id)> &missing);

} // namespace palmer
