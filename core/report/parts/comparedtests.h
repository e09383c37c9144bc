// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <optional>
#include <vector>

namespace palmer {

/// States that a comparison is no result of the standard.
[[nodiscard]] Text comparisonNature();

/// "no change proven", "changed, better".
[[nodiscard]] Text changeText(ChangeWord word);
[[nodiscard]] Mark markOf(ChangeWord word);

/// True for the words that state a difference.
[[nodiscard]] bool statesDifference(ChangeWord word);

/// The word on all parameters: the direction of the change only where all changes have it. Null: no words.
[[nodiscard]] std::optional<ChangeWord> wordOfAll(const TestComparison &comparison);

/// The outcome of a comparison: the word, how many parameters changed with the first of them, and the others.
/// Without words an empty line.
[[nodiscard]] VerdictLine decisionLine(const TestComparison &comparison, const Language &language);

/// The headings of the values of two tests: "as found", "as left", else "before", "after".
[[nodiscard]] std::pair<Text, Text> sideTexts(const PlacedTest &before, const PlacedTest &after);

/// A parameter in words and numbers, both values with as many decimals as U needs; empty: not known.
struct ComparedWords {
    Phrase symbol;
    QString name;
    QString before;
    QString after;
    QString difference;
    QString uncertainty;
    QString repeatability; ///< parts of U, each alone
    QString errors;
    QString shift; ///< of the simulated mean
    QString enRatio;
    QString word;
    std::optional<Whisker> picture; ///< on an axis common to all
};
[[nodiscard]] std::vector<ComparedWords> comparedWords(const TestComparison &comparison,
                                                       const Language &language);

/// Something that two tests state differently; empty: not stated.
struct DifferingCondition {
    QString name;
    QString before;
    QString after;
};
struct ComparedConditions {
    std::vector<DifferingCondition> differing;
    QStringList alike; ///< names of what both state alike
};
[[nodiscard]] ComparedConditions compareConditions(const PlacedTest &before, const PlacedTest &after,
                                                   const Language &language);

/// How U was made, what both tests share, and what "changed" means; empty without U.
[[nodiscard]] QStringList methodSentences(const TestComparison &comparison, const Language &language);

/// Why the tests are not compared, or why no word is said; empty otherwise.
[[nodiscard]] QString reasonOf(const TestComparison &comparison, const Language &language);

/// A comparison below its head: differing conditions, parameters with their words, how U was made, curves.
/// `tolerance`: agreed, as it was compared with.
[[nodiscard]] std::vector<Block> comparisonBlocks(const TestComparison &comparison, const PlacedTest &before,
                                                  const PlacedTest &after, const Language &language,
                                                  std::optional<double> tolerance = {});

/// The same as a report, for a terminal.
[[nodiscard]] Report composeComparison(const TestComparison &comparison, const PlacedTest &before,
                                       const PlacedTest &after, const Language &language,
                                       std::optional<double> tolerance = {});

} // namespace palmer
