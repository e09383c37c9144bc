// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace palmer {

/// Adds the simulation of the test, if run under this edition, and decides which U each parameter has.
/// `method`: direct uses `stated` (mm, rotary: degrees); budget the budget, budgetActual the budget with the
/// actual targets; monteCarlo the simulation, unless it has too few trials or shifts the result by more than
/// a third of its U: then the budget. Precondition: `evaluation` has its parameters, their
/// `budgetUncertainty`, and the contributions.
void decideUncertainty(TestEvaluation &evaluation, UncertaintyMethod method, const Surroundings &surroundings,
                       const std::function<std::optional<double>(const Parameter &)> &stated);

/// Returns the symbols of the results that should have a U and do not: of those required, all that every
/// report prints.
[[nodiscard]] std::string resultsWithoutUncertainty(std::span<const Parameter> parameters);

/// A missing or impossible input, and the results that have no uncertainty because of it; empty: all.
struct MissingInput {
    InputDefect defect;
    std::string results;
};

/// Adds the findings on uncertainty if the method needs a budget: missing inputs by name, a simulation not
/// run or with too few trials, large shifts, and (a remark) methods that differ by more than 20 %. `reason`:
/// the sentence explaining the difference for a parameter, with %1 for the symbols.
void findUncertainty(TestEvaluation &evaluation, const std::vector<MissingInput> &missing,
                     const std::function<Message(const Parameter &)> &reason);

/// |U_MC/U − 1| up to which the methods agree.
inline constexpr double agreementOfMethods = 0.2;

[[nodiscard]] inline bool methodsAgree(double found, double expected) {
    return std::abs(found - expected) <= agreementOfMethods * expected;
}

/// Reasons of a difference that all kinds of tests can have.
inline constexpr Text notNormallyDistributed =
    REPORT_TEXT("report", "%1: budget and Monte Carlo differ by more than 20 %: the results of the "
                          "trials are not normally distributed, half of their 95.45 % interval "
                          "is not 2u.");
inline constexpr Text noKnownReason =
    REPORT_TEXT("report", "%1: budget and Monte Carlo differ by more than 20 %; no single reason that "
                          "is known explains it.");

/// True if budget and simulation differ by more than that; false if one of them is missing.
[[nodiscard]] bool methodsDiffer(const Parameter &parameter);

} // namespace palmer
