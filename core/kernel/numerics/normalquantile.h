// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/lanes.h"

namespace palmer {

/// Returns the standard normal deviate z whose distribution function is p, 0 < p < 1; relative error about
/// 1e-16. ±∞ or NaN outside.
/// Source: M. J. Wichura, Algorithm AS 241, Applied Statistics 37 (1988), 477–484.
[[nodiscard]] double normalQuantile(double p);

/// Returns the quantiles of (1 + q)/2 for four values, −1 < q < 1.
[[nodiscard]] Lanes normalQuantileOfSymmetric(const Lanes &q);

} // namespace palmer
