// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"

#include <optional>

namespace palmer {

/// Returns the verdict on a value against its upper limit, from unrounded numbers; signed results by absolute
/// value. Simple acceptance: value ≤ limit conforms. ISO 14253-1 and "rejection proven": with g =
/// guardFactor·U, value ≤ limit − g conforms, value > limit + g does not, between them (or without U) it is
/// not proven. Without a value conformity is not proven under any rule. All in the same unit.
[[nodiscard]] Verdict decide(std::optional<double> value, double limit,
                             std::optional<double> expandedUncertainty, const DecisionRule &rule);

/// The same for an existing signed value: value ≤ limit, whatever its sign. `rounding`: relative difference
/// to be ignored: for sums of readings, or for numbers as written.
inline constexpr double roundingOfSums = 1e-12;
inline constexpr double roundingOfWritten = 2e-15;
[[nodiscard]] Verdict decideUpper(double value, double limit, std::optional<double> expandedUncertainty,
                                  const DecisionRule &rule, double rounding = roundingOfSums);

/// Returns the relative difference between a value and a limit to be ignored: for sums of readings, and for a
/// difference of numbers the size of a radius, each of which a double holds to 2e-16.
[[nodiscard]] double roundingBeside(const Parameter &parameter, double limit);

/// A value and its limit transformed so that less is better: upper limits unchanged, signed results by
/// magnitude, lower limits with both signs reversed.
[[nodiscard]] double judgedValue(double value, Bound bound);
[[nodiscard]] double judgedLimit(double limit, Bound bound);

/// Returns guardFactor·U; null under simple acceptance or without U.
[[nodiscard]] std::optional<double> guardBand(std::optional<double> expandedUncertainty,
                                              const DecisionRule &rule);

/// Returns the worse of two verdicts; null means no verdict.
[[nodiscard]] std::optional<Verdict> worst(std::optional<Verdict> a, std::optional<Verdict> b);

} // namespace palmer
