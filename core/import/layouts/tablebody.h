// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/columnrole.h"
#include "import/layouts/headings.h"
#include "import/remark.h"
#include "tables/table.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

enum class ColumnKind { empty, numbers, directions, senses, clock, dates, words };

struct TableColumn {
    ColumnKind kind = ColumnKind::empty;
    std::string heading; ///< all rows of the heading joined
    std::string group;   ///< of it what stands above several columns
    HeadingWords words;  ///< what it says
    Meaning meaning = Meaning::unknown;
    const Unit *unit = nullptr; ///< of the heading, or null
    std::string foreignUnit;    ///< of the heading, where it is none that numbers are converted from

    bool isSpread = false; ///< its heading is that of a column before it
    bool isChosen = false; ///< the user says that it holds numbers, whatever its cells look like

    [[nodiscard]] SaidUnit said() const { return {unit, foreignUnit}; }
};

/// Rows of numbers that belong together, and the words above them. Indexes of rows of the table.
struct TableBlock {
    std::vector<std::uint32_t> rows;
    std::vector<std::uint32_t> heads;         ///< since the block before
    std::optional<std::uint32_t> numericHead; ///< a heading of numbers: "Run; 0; 150; 300"
    std::size_t section = 0;                  ///< whose headings hold for it
};

/// A word that nobody knows in a column of one direction, whose heading says that it holds directions.
struct OppositeWord {
    std::string word;
    Direction direction = Direction::negative; ///< the other one than that of the words that are known
};

/// The rows of a table sorted into what is measured and what is said about it.
struct TableBody {
    std::vector<TableColumn> columns;               ///< of the first section
    std::vector<std::vector<TableColumn>> sections; ///< alike but for directions and numbers of runs
    std::vector<TableBlock> blocks;
    std::vector<std::uint32_t> notes;       ///< comments and lines that are no heading
    std::vector<std::uint32_t> columnHeads; ///< rows that the headings are made of
    std::vector<Remark> remarks;
    std::vector<ListedTable> tables; ///< in the order of the file, with the one that is read
    std::size_t table = 0;           ///< of them, the one that is read
    std::optional<OppositeWord> opposite;

    /// The direction a cell of the column of directions says.
    [[nodiscard]] std::optional<Direction> directionIn(std::string_view cell) const {
        return opposite && opposite->word == cell ? opposite->direction : directionOf(cell);
    }
    [[nodiscard]] std::size_t rowCount() const;
    /// Columns of numbers, from the left.
    [[nodiscard]] std::vector<std::size_t> numberColumns() const;
    [[nodiscard]] std::optional<std::size_t> columnOf(Meaning meaning) const;
    [[nodiscard]] std::optional<std::size_t> columnOf(ColumnKind kind) const;
};

/// Reads the table that was chosen (from 1); without a choice the one with targets and readings, the longest
/// where several have them. Throws Error(content) where there are no rows of numbers. `ofNumbers` are columns
/// that the user has given a role of numbers.
[[nodiscard]] TableBody bodyOf(const CellTable &table, const std::vector<std::size_t> &ofNumbers = {},
                               std::optional<std::size_t> chosen = {});

} // namespace palmer
