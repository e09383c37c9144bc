// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"

#include <optional>

namespace palmer {

/// The verdict on a value against its upper limit, from unrounded numbers; signed results by absolute value.
/// simple acceptance: value ≤ limit conforms. ISO 14253-1 and "rejection proven": with g = guardFactor·U,
/// value ≤ limit − g conforms, value > limit + g does not, between (or without U) it is not proven. Without a
/// value conformity is not proven under any rule. All in the same unit.
[[nodiscard]] Verdict decide(std::optional<double> value, double limit,
                             std::optional<double> expandedUncertainty, const DecisionRule &rule);

/// The same for a signed value that exists: value ≤ limit, whatever its sign. `rounding`: relative difference
/// that is no difference: that of sums of readings, or of a number as it was written.
inline constexpr double roundingOfSums = 1e-12;
inline constexpr double roundingOfWritten = 2e-15;
[[nodiscard]] Verdict decideUpper(double value, double limit, std::optional<double> expandedUncertainty,
                                  const DecisionRule &rule, double rounding = roundingOfSums);

/// The relative difference of a value from a limit that is none: of sums of readings, and of a difference
/// between numbers of the size of a radius, which a double holds to 2e-16 of it.
[[nodiscard]] double roundingBeside(const Parameter &parameter, double limit);

/// A value and its limit turned so that less is better: upper limits as they are, signed results by their
/// size, lower limits with both signs exchanged.
[[nodiscard]] double judgedValue(double value, Bound bound);
[[nodiscard]] double judgedLimit(double limit, Bound bound);

/// guardFactor·U, null under simple acceptance or without U.
[[nodiscard]] std::optional<double> guardBand(std::optional<double> expandedUncertainty,
                                              const DecisionRule &rule);

/// The worse of two verdicts; null is no verdict.
[[nodiscard]] std::optional<Verdict> worst(std::optional<Verdict> a, std::optional<Verdict> b);

} // namespace palmer
