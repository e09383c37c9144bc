// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/table.h"

#include <string>
#include <vector>

namespace palmer {

/// A label with its values, as a line of text states them: "Machine: DMU 50".
struct LabelledValue {
    std::string label; ///< without its colon; empty: text without a label
    std::vector<std::string> values;
    std::string text; ///< as written
};

/// The labels and values of a row, one or several: in cells of their own ("Machine:" | "DMU 50" | "Date" |
/// …), or within a cell ("Machine: DMU 50   Serial: 123"). Quoted cells are whole values, and so is what
/// commas part after a label in a file whose cells are separated by commas.
[[nodiscard]] std::vector<LabelledValue> labelledValuesIn(const CellTable &table, const TableRow &row);

/// The texts of the cells that are not empty. "0,1 µm", torn by a comma that also separates cells, is one
/// again.
[[nodiscard]] std::vector<std::string> textsIn(const CellTable &table, const TableRow &row);

} // namespace palmer
