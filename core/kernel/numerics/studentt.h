// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// Returns the quantile t(p; degrees) of Student's distribution, 0.5 < p < 1, degrees ≥ 1: the bound that a
/// variable stays below with probability p. Solved by bisection of the distribution function, which for
/// integer degrees of freedom is the finite sum of Abramowitz and Stegun 26.7.3 and 26.7.4; relative error
/// below 1e-12. Infinite for degrees < 1.
[[nodiscard]] double studentQuantile(double probability, int degrees);

/// Returns t(0.975; degrees), the two-sided 95 % bound.
[[nodiscard]] double studentQuantile975(int degrees);

/// Returns the probability that χ² with these degrees of freedom (> 0, any real number) exceeds a value, by
/// the cube root of χ²/ν, which is nearly normal: within a factor of three down to 1e-6 for ν ≥ 2. 1 for
/// degrees ≤ 0.
/// Source: E. B. Wilson, M. M. Hilferty, Proc. Natl. Acad. Sci. 17 (1931), 684–688.
[[nodiscard]] double chiSquareExceeded(double value, double degrees);

/// Returns the probability that a standard normal variable deviates by more than ± z.
[[nodiscard]] double normalExceeded(double z);

} // namespace palmer
