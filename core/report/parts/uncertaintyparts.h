// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// Whether the budget of a test is to be used, and so to be shown.
[[nodiscard]] bool usesBudget(const TestEvaluation &evaluation);

/// The sources of an uncertainty budget as a table sorted by size, with shares and bars; below it the U of
/// each result by the budget and by Monte Carlo, which of them decides, and what to improve first. Nothing
/// where the method needs no budget.
void addBudget(std::vector<Block> &blocks, const TestPart &part);

/// Which method gave U how, which of them decides and where they differ: the sentences below the U of both
/// methods, in window and report. Where the methods were explained for the test `before`, the numbers alone.
[[nodiscard]] QString methodText(const TestPart &part, std::optional<int> before = {});

} // namespace palmer
