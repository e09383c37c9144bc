// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/testevaluation.h"
#include "kernel/measurement/test.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <span>

namespace palmer {

/// Whether a test is in accordance with its edition: the second part of the verdict, one sentence. With
/// `page`, "see page %1" stands where there is something to see, the number still to be put in.
[[nodiscard]] QString accordanceText(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language, bool page);

/// The same in a few words, for lists.
[[nodiscard]] Text accordanceWords(Accordance accordance);

/// The mark beside it.
[[nodiscard]] Mark markOf(Accordance accordance);

/// The sentence as the second part of a verdict: what stands before its colon is the state.
[[nodiscard]] VerdictStatement accordanceStatement(const Test &test, const TestEvaluation &evaluation,
                                                   const Language &language, bool page);

/// Of several tests: that all are in accordance, or how many are.
[[nodiscard]] QString accordanceOfAll(std::span<const Accordance> tests, const Language &language);

} // namespace palmer
