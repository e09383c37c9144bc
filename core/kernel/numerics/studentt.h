// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// Returns the quantile t(p; degrees) of Student's distribution, 0.5 < p < 1, degrees ≥ 1: the bound that a
/// variable stays below with probability p. Infinite for degrees < 1.
[[nodiscard]] double studentQuantile(double probability, int degrees);

/// Returns t(0.975; degrees), the two-sided 95 % bound.
[[nodiscard]] double studentQuantile975(int degrees);

/// Returns the probability that χ² with these degrees of freedom (> 0, any real number) exceeds a value. 1
/// for degrees ≤ 0.
[[nodiscard]] double chiSquareExceeded(double value, double degrees);

/// Returns the probability that a standard normal variable deviates by more than ± z.
[[nodiscard]] double normalExceeded(double z);

} // namespace palmer
