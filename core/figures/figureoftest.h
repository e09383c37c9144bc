// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

namespace palmer {

/// Main figure of a kind of test: deviations over the targets, both senses of a circle, drift over time.
/// `evaluation` is the evaluation of `test`.
[[nodiscard]] Figure figureOfTest(const Test &test, const TestEvaluation &evaluation,
                                  const Language &language);

} // namespace palmer
