// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <span>

namespace palmer {

/// The accordance of a test with its edition as a sentence: the second part of the verdict. With `page`, it
/// includes "see page %1" if there are details, with the number still to be filled in.
[[nodiscard]] QString accordanceText(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language, bool page);

/// The numbers of that sentence: "4 requirements not met, 12 not declared". Empty if there are none.
[[nodiscard]] QString requirementsText(const TestEvaluation &evaluation, const Language &language);

/// Short form for lists.
[[nodiscard]] Text accordanceWords(Accordance accordance);

/// The mark next to it.
[[nodiscard]] Mark markOf(Accordance accordance);

/// The sentence as the second part of a verdict: the text before its colon is the state.
[[nodiscard]] VerdictStatement accordanceStatement(const Test &test, const TestEvaluation &evaluation,
                                                   const Language &language, bool page);

/// States that all tests are in accordance, or how many are.
[[nodiscard]] QString accordanceOfAll(std::span<const Accordance> tests, const Language &language);

} // namespace palmer
