// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/pastedtable.h"
#include "kernel/measurement/sheet.h"
#include "kernel/words/text.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer {

/// The columns to type in a row of the acceptance sheet, in the order in which a block without heading has
/// it.
enum class SheetColumn {
    number,
    object,
    permitted,
    measured,
    uncertainty,
    unit,
    instrument,
    remark,
    standard
};
inline constexpr int sheetColumns = 9;

/// Puts a typed text into a row: numbers with a point or a comma, a tolerance also as "±0.02" or "−0.01 to
/// 0.02"; empty takes the statement away. Returns why it is refused; the row then stays as it was.
[[nodiscard]] std::optional<Text> typeIntoSheet(std::vector<SheetRow> &rows, std::size_t row,
                                                SheetColumn column, const QString &typed);

/// The rows of a sheet with those of a block put in.
struct PastedSheet : Pasted {
    std::vector<SheetRow> sheet;
    std::vector<SheetColumn> columns; ///< of the block, from left to right
};

/// Puts a block of a spreadsheet into the sheet. Its columns are those that its heading names, else those
/// from `column` on. Rows whose number stands in the sheet already are replaced cell by cell; others fill
/// those from `first` on if the block has no numbers, or are added. `answers` may say the decimal mark.
/// Throws Error with the line for what is no number: then nothing is taken.
[[nodiscard]] PastedSheet pasteSheet(std::vector<SheetRow> rows, std::size_t first, SheetColumn column,
                                     const QString &block, const ImportOptions &answers = {});

} // namespace palmer
