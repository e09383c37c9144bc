// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// The large word of a verdict, and a second line if the limits are respected but facts of the test are
/// unknown.
struct LargeWord {
    Text word;
    Text second = {}; ///< may be empty
};

/// "Conforms" etc. require that all requirements were read, declared and met. Otherwise the word only
/// concerns the limits, and with an unmet requirement there is no verdict on respected limits.
[[nodiscard]] LargeWord largeWord(std::optional<Verdict> verdict, bool anyLimit, Accordance accordance);

/// The mark next to the large word; may be none.
[[nodiscard]] Mark largeMark(std::optional<Verdict> verdict, Accordance accordance);

/// The guard picture of a result; blank without verdict, or if the limit is not positive.
[[nodiscard]] Cell guardCell(const Parameter &parameter);

/// "met", "exceeded" with its mark; a missing value without verdict.
[[nodiscard]] Cell verdictCell(const Writer &write, const Parameter &parameter);

/// "ISO 14253-1, conformity has to be proven", with the guard band unless it is U.
[[nodiscard]] QString ruleInShort(const TestPart &part);

/// Adds the figure of a positioning test with its heading.
void addFigure(std::vector<Block> &blocks, const PositioningPart &part);

/// Adds results with limits, guard pictures and verdicts, their legend, and the verdict line.
void addResults(std::vector<Block> &blocks, const PositioningPart &part);
void addResults(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the findings in order of grade, unless the report leaves them out.
void addFindings(std::vector<Block> &blocks, const TestPart &part);

/// The decision rule of a test in words, with its guard factor.
[[nodiscard]] QString decisionText(const TestPart &part);

/// The limits with their sources; may have no rows.
[[nodiscard]] Table limitsTable(const TestPart &part);

/// Adds these and the decision rule in words.
void addLimits(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
