// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// The contributions to the uncertainty of a test as bars, the largest first: U_i (k = 2) in µm, rotary: arc
/// seconds, and the share in the sum of the squares; unknown ones before all others, without a bar. No bars
/// where the method of the test needs no budget, and for drift tests. `evaluation` is that of the test.
[[nodiscard]] BarFigure budgetFigure(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language);

/// Decimals of the U of a contribution, in the unit it is shown in.
inline constexpr int contributionDecimals = 2;

/// The name of a contribution as it begins a line: with a capital.
[[nodiscard]] QString contributionName(const Contribution &contribution, const Language &language);

/// "54"; a share below 0.5 % as "< 1". Without the sign.
[[nodiscard]] QString shareText(double share, const Language &language);

} // namespace palmer
