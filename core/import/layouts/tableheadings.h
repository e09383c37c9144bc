// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/tablebody.h"

#include <span>

namespace palmer {

/// Cells without the empty ones at the end.
[[nodiscard]] std::span<const TableCell> trimmed(std::span<const TableCell> cells);

/// 2024, 2025 above columns: neither a number of a run nor a target.
[[nodiscard]] bool isYear(double number);

/// Finds the headings of the columns: above each block of rows those that stand over it, joined from above.
/// Blocks without headings of their own belong to the section before them.
void findSections(const CellTable &table, TableBody &body);

/// "Tolerance; 8; 8; 8": a label of what is computed or asked for, and numbers.
[[nodiscard]] bool isComputedRow(const CellTable &table, const TableRow &row);

} // namespace palmer
