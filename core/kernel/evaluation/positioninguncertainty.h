// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/positioning.h"
#include "kernel/uncertainty/positioningbudget.h"

#include <span>

namespace palmer {

/// Adds the contributions to the evaluation and the budget's U to its parameters: the n of every mean and s
/// are those of the ruling targets and directions; the fewest of all for a mean over targets. Also adds U
/// with the actual targets:
///     S_eff = max(Y(+T), Y(−T)) − Y(0),   Y(t) the evaluation of x_ij + t·ℓ_i/L,
/// T being the part of S that grows with the length; the rest (a fixed part of the instrument) counts in
/// full. Adds no U without a complete budget.
void addPositioningBudget(TestEvaluation &evaluation, const PositioningMeasurement &measurement,
                          const PositioningBudget &budget, std::span<const TargetStatistics> targets);

/// Returns why budget and simulation differ by more than 20 % for a parameter: the first reason confirmed by
/// computation, otherwise a sentence that none was found. The sentence has %1 for the symbols.
[[nodiscard]] Message reasonOfDifference(const Parameter &parameter, const TestEvaluation &evaluation,
                                         const PositioningMeasurement &measurement,
                                         const PositioningBudget &budget,
                                         std::span<const TargetStatistics> targets);

} // namespace palmer
