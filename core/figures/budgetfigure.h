// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// Contributions to the uncertainty of a test as bars, the largest first: U_i (k = 2) in µm (rotary: arc
/// seconds), and its share in the sum of squares. Unknown contributions come first and have no bar. No bars
/// if the method of the test needs no budget, nor for drift tests. `evaluation` is the evaluation of `test`.
[[nodiscard]] BarFigure budgetFigure(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language);

/// Decimals of the U of a contribution, in the displayed unit.
inline constexpr int contributionDecimals = 2;

/// Name of a contribution, capitalised to begin a line.
[[nodiscard]] QString contributionName(const Contribution &contribution, const Language &language);

/// Percentage without the % sign: "54"; "< 1" if below 0.5 %.
[[nodiscard]] QString shareText(double share, const Language &language);

} // namespace palmer
