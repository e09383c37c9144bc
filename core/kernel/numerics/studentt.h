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

} // namespace palmer
