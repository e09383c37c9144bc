#pragma once

#include "report/testpart.h"

namespace palmer {

/// The word of a verdict in capitals; "no limit agreed" where there is none.
[[nodiscard]] QString verdictWord(const Writer &write, std::optional<Verdict> verdict);

/// The figure of a positioning test below its heading.
void addFigure(std::vector<Block> &blocks, const PositioningPart &part);

/// Results with limits, guard pictures and verdicts, what these mean, and the verdict line. `name`: what the
/// heading calls the object of the results; `notCorrected`: E, A, M say so.
void addResults(std::vector<Block> &blocks, const TestPart &part, const QString &heading, bool notCorrected);

/// Findings in the order of their grades, unless the report leaves them out.
void addFindings(std::vector<Block> &blocks, const TestPart &part);

/// The limits with their sources and the decision rule in words.
void addLimits(std::vector<Block> &blocks, const TestPart &part);

} // namespace palmer
