// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace palmer {

/// Returns how much of a curve v a cyclic error with a given pitch would explain: the part of Σ v² within the
/// columns sin(2πx/p)·x/R and cos(2πx/p)·x/R, x being the position along the axis. `along` is x/R, `curve` is
/// v·x/R, `squares` is (x/R)², all of equal length and 0 in omitted rows. `periods` is R/p. The sines are
/// accurate to 1e-4: good for choosing a pitch, not for a fit.
[[nodiscard]] double explainedByPitch(std::span<const double> along, std::span<const double> curve,
                                      std::span<const double> squares, double periods);

} // namespace palmer
