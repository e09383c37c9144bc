// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"
#include "language/language.h"

#include <span>

namespace palmer {

struct TestEvaluation;

/// A finding in words: its sentence, and for practice the remark that the text is not available.
[[nodiscard]] QString findingText(const Finding &finding, const Language &language);

/// Name of the subject of a finding, with the letter of a point to be agreed; empty if its sentence needs
/// none.
[[nodiscard]] QString findingName(const Finding &finding, const Language &language);

/// The sentences of several findings in order; names that complete the same sentence are listed in it and
/// counted. For lists with the source in their headings.
[[nodiscard]] QString findingsText(std::span<const Finding *const> findings, const Language &language);

/// "7 required statements missing".
[[nodiscard]] QString missingStatements(int count, const Language &language);

/// How many findings there are, as a reader of the report can recount them: "4 requirements not met · 1
/// recommendation · 9 notes".
[[nodiscard]] QString findingsByGrade(const TestEvaluation &evaluation, const Language &language);

/// The same for the window, whose pages count what is missing: "4 requirements not met, 12 not declared · 7
/// other required statements missing · 2 notes". Begins as the accordance does.
struct CountedFindings {
    QString lack; ///< without the notes; empty if there is nothing to do
    QString all;  ///< empty if there is no finding
};
[[nodiscard]] CountedFindings countedFindings(const TestEvaluation &evaluation, const Language &language);

} // namespace palmer
