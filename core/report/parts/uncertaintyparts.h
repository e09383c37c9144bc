// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/parts/testpart.h"

namespace palmer {

/// True if the budget of a test is used, and therefore shown.
[[nodiscard]] bool usesBudget(const TestEvaluation &evaluation);

/// Adds an uncertainty budget as a table sorted by size, with shares and bars, then the U of each result by
/// the budget and by Monte Carlo, which of them decides, and what to improve first. Nothing if the method
/// needs no budget.
void addBudget(std::vector<Block> &blocks, const TestPart &part);

/// Sentences below the U of both methods, in window and report: how each was determined, which decides, and
/// where they differ. Only the numbers if the methods were explained for the test `before`.
[[nodiscard]] QString methodText(const TestPart &part, std::optional<int> before = {});

} // namespace palmer
