// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/tablebody.h"

#include <span>

namespace palmer {

/// Cells without trailing empty ones.
[[nodiscard]] std::span<const TableCell> trimmed(std::span<const TableCell> cells);

/// True for 2024, 2025 above columns: neither a run number nor a target.
[[nodiscard]] bool isYear(double number);

/// Finds the column headings: for each block of rows those above it, joined downwards. Blocks without
/// headings belong to the section before them.
void findSections(const CellTable &table, TableBody &body);

/// "Tolerance; 8; 8; 8": a label of computed or required values, with numbers.
[[nodiscard]] bool isComputedRow(const CellTable &table, const TableRow &row);

} // namespace palmer
