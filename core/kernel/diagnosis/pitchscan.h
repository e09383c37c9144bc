// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace palmer {

/// How much of a curve v a cyclic error of that pitch would explain: the part of Σ v² that the two columns
/// sin(2πx/p)·x/R and cos(2πx/p)·x/R reach, x the position along the axis. `along` is x/R, `curve` is v·x/R,
/// `squares` is (x/R)², all three 0 where a row does not count and as long as each other. `periods` is R/p.
/// The sines are good to 1e-4: for choosing a pitch, not for a fit.
[[nodiscard]] double explainedByPitch(std::span<const double> along, std::span<const double> curve,
                                      std::span<const double> squares, double periods);

} // namespace palmer
