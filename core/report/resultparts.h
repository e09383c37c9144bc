#pragma once

#include "report/testpart.h"

namespace palmer {

/// The word of a verdict; without one "no limit agreed", or "no verdict" where limits were agreed that do not
/// hold.
[[nodiscard]] Text verdictWord(std::optional<Verdict> verdict, bool anyLimit);

/// The large word of a verdict line. "Conforms" and its likes stand only where no requirement is known to be
/// unmet or was not declared; there the word is of the limits alone, and with an unmet requirement there is
/// no verdict on limits that are respected.
[[nodiscard]] Text largeWord(std::optional<Verdict> verdict, bool anyLimit, Accordance accordance);

/// What the mark beside the large word says; none where it has none.
[[nodiscard]] std::optional<Verdict> largeMark(std::optional<Verdict> verdict, Accordance accordance);

/// Whether any limit was agreed for the test, for whatever edition.
[[nodiscard]] bool hasLimits(const Test &test);

/// The figure of a positioning test below its heading.
void addFigure(std::vector<Block> &blocks, const PositioningPart &part);

/// Results with limits, guard pictures and verdicts, what these mean, and the verdict line.
void addResults(std::vector<Block> &blocks, const PositioningPart &part);
void addResults(std::vector<Block> &blocks, const CircularPart &part);

/// Findings in the order of their grades, unless the report leaves them out.
void addFindings(std::vector<Block> &blocks, const TestPart &part);

/// The decision rule of a test in words, with its guard factor.
[[nodiscard]] QString decisionText(const TestPart &part);

/// The limits with their sources and the decision rule in words.
void addLimits(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
