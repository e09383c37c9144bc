#pragma once

#include "report/testpart.h"

namespace palmer {

/// Whether the budget of a test is to be used, and so to be shown.
[[nodiscard]] bool usesBudget(const TestEvaluation &evaluation);

/// The sources of an uncertainty budget as a table sorted by size, with shares and bars; below it the U of
/// each result by the budget and by Monte Carlo, which of them decides, and what to improve first. Nothing
/// where the method needs no budget.
void addBudget(std::vector<Block> &blocks, const TestPart &part);

/// The contributions of a budget that say anything, the largest first; the unknown ones before, those that
/// do not apply last.
[[nodiscard]] std::vector<const Contribution *> bySize(const std::vector<Contribution> &contributions);

/// Part of a contribution in the sum of the squares of all; 0 where nothing is known.
[[nodiscard]] double shareOf(const Contribution &contribution,
                             const std::vector<Contribution> &contributions);

/// The end of a scale from 0 that holds `size`: 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 or 10 times a power of
/// ten.
[[nodiscard]] double scaleEnd(double size);

} // namespace palmer
