// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The large word of a verdict line, and the line below it where limits are respected by a test of which not
/// all is known.
struct LargeWord {
    Text word;
    Text second = {}; ///< may be empty
};

/// "Conforms" and its likes are for tests whose requirements were all read, declared and met. Otherwise the
/// word is of the limits alone, and with an unmet requirement there is no verdict on respected limits.
[[nodiscard]] LargeWord largeWord(std::optional<Verdict> verdict, bool anyLimit, Accordance accordance);

/// The mark beside the large word; none where it has none.
[[nodiscard]] Mark largeMark(std::optional<Verdict> verdict, Accordance accordance);

/// The guard picture of a result; blank without verdict, or where the limit is no size.
[[nodiscard]] Cell guardCell(const Parameter &parameter);

/// "met", "exceeded" with its mark; missing without verdict.
[[nodiscard]] Cell verdictCell(const Writer &write, const Parameter &parameter);

/// "ISO 14253-1, conformity has to be proven", with the guard band where that is not U.
[[nodiscard]] QString ruleInShort(const TestPart &part);

/// The figure of a positioning test below its heading.
void addFigure(std::vector<Block> &blocks, const PositioningPart &part);

/// Results with limits, guard pictures and verdicts, what these mean, and the verdict line.
void addResults(std::vector<Block> &blocks, const PositioningPart &part);
void addResults(std::vector<Block> &blocks, const CircularPart &part);

/// Findings in the order of their grades, unless the report leaves them out.
void addFindings(std::vector<Block> &blocks, const TestPart &part);

/// The decision rule of a test in words, with its guard factor.
[[nodiscard]] QString decisionText(const TestPart &part);

/// The limits with their sources; without rows where there are none.
[[nodiscard]] Table limitsTable(const TestPart &part);

/// These and the decision rule in words.
void addLimits(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
