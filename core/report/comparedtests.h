// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <optional>
#include <vector>

namespace palmer {

/// "no change proven", "changed, better".
[[nodiscard]] Text changeText(ChangeWord word);

/// Something that two tests state differently; empty: not stated.
struct DifferingCondition {
    QString name;
    QString before;
    QString after;
};
[[nodiscard]] std::vector<DifferingCondition>
differingConditions(const PlacedTest &before, const PlacedTest &after, const Language &language);

/// A comparison as text: what it is, differing conditions, parameters with their words, how U was made,
/// curves. `tolerance`: agreed, as it was compared with.
[[nodiscard]] std::vector<Block> comparisonBlocks(const TestComparison &comparison, const PlacedTest &before,
                                                  const PlacedTest &after, const Language &language,
                                                  std::optional<double> tolerance = {});

/// The same as a report, for a terminal.
[[nodiscard]] Report composeComparison(const TestComparison &comparison, const PlacedTest &before,
                                       const PlacedTest &after, const Language &language,
                                       std::optional<double> tolerance = {});

} // namespace palmer
