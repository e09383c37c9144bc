// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// Returns the probability that χ² with these degrees of freedom (> 0, any real number) exceeds a value, by
/// the cube root of χ²/ν, which is nearly normal: within a factor of three down to 1e-6 for ν ≥ 2. 1 for
/// degrees ≤ 0.
/// Source: E. B. Wilson, M. M. Hilferty, Proc. Natl. Acad. Sci. 17 (1931), 684–688.
[[nodiscard]] double chiSquareExceeded(double value, double degrees);

/// Returns the probability that a standard normal variable deviates by more than ± z.
[[nodiscard]] double normalExceeded(double z);

} // namespace palmer
