// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/positioning.h"
#include "kernel/uncertainty/positioningbudget.h"

#include <span>

namespace palmer {

/// Puts the contributions into the evaluation and U by the budget on its parameters: the n of every mean and
/// s are those of the targets and directions that rule it; the fewest of all where a mean over targets is
/// taken. Beside it U with the actual targets:
///     S_eff = max(Y(+T), Y(−T)) − Y(0),   Y(t) the evaluation of x_ij + t·ℓ_i/L,
/// T the part of S that grows with the length; what does not (a fixed part of the instrument) counts in full.
/// Nothing without a complete budget.
void addPositioningBudget(TestEvaluation &evaluation, const PositioningMeasurement &measurement,
                          const PositioningBudget &budget, std::span<const TargetStatistics> targets);

/// Why budget and simulation differ by more than 20 % for a parameter: the first reason that is computed to
/// hold; that there is none where there is none. The sentence has %1 for the symbols.
[[nodiscard]] Message reasonOfDifference(const Parameter &parameter, const TestEvaluation &evaluation,
                                         const PositioningMeasurement &measurement,
                                         const PositioningBudget &budget,
                                         std::span<const TargetStatistics> targets);

} // namespace palmer
