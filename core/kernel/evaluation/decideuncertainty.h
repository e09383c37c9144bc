// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace palmer {

/// Puts the simulation of the test, if it was run under this edition, beside the budget, and decides which U
/// each parameter has. `method`: direct takes `stated` (mm, rotary: degrees); budget the budget, budgetActual
/// that with the actual targets; monteCarlo the simulation, unless it has too few trials or shifts the result
/// by more than a third of its U: then the budget. `evaluation` has its parameters, their
/// `budgetUncertainty`, and the contributions.
void decideUncertainty(TestEvaluation &evaluation, UncertaintyMethod method, const Surroundings &surroundings,
                       const std::function<std::optional<double>(const Parameter &)> &stated);

/// The symbols of the results that ought to have a U and have none: those with a limit; without any limit the
/// main ones that are required.
[[nodiscard]] std::string resultsWithoutUncertainty(std::span<const Parameter> parameters,
                                                    const Limits &limits);

/// An input that is missing or impossible, and the results that have no uncertainty because of it; empty:
/// all.
struct MissingInput {
    InputDefect defect;
    std::string results;
};

/// The findings on the uncertainty where the method needs a budget: missing inputs by name, a simulation that
/// was not run or has too few trials, large shifts, and (a remark) where both methods differ by more than 20
/// %. `reason`: the sentence why they do for a parameter, with %1 for the symbols.
void findUncertainty(TestEvaluation &evaluation, const std::vector<MissingInput> &missing,
                     const std::function<Message(const Parameter &)> &reason);

/// |U_MC/U − 1| that is no more worth a remark.
inline constexpr double agreementOfMethods = 0.2;

/// Budget and simulation differ by more than that; false where one of them is missing.
[[nodiscard]] bool methodsDiffer(const Parameter &parameter);

} // namespace palmer
