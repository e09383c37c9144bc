#pragma once

namespace palmer {

/// Quantile t(0.975; degrees) of Student's distribution, degrees ≥ 1: the two-sided 95 % bound.
/// Solved by bisection on the distribution function, which for whole degrees of freedom is the finite sum of
/// Abramowitz and Stegun 26.7.3 and 26.7.4; relative error below 1e-12. Infinite for degrees < 1.
[[nodiscard]] double studentQuantile975(int degrees);

} // namespace palmer
