// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/columnrole.h"
#include "import/layouts/headings.h"
#include "import/remark.h"
#include "tables/table.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

enum class ColumnKind { empty, numbers, directions, senses, clock, dates, words };

struct TableColumn {
    ColumnKind kind = ColumnKind::empty;
    std::string heading; ///< all heading rows joined
    std::string group;   ///< the part of the heading above several columns
    std::string own;     ///< the lowest heading row, but for a row of units
    HeadingWords words;  ///< meaning of the heading
    Meaning meaning = Meaning::unknown;
    const Unit *unit = nullptr; ///< of the heading; may be null
    std::string foreignUnit;    ///< of the heading, if it is a unit without conversion

    bool isSpread = false; ///< its heading is that of an earlier column
    bool isChosen = false; ///< the user assigned it a role of numbers, whatever its cells look like

    [[nodiscard]] SaidUnit said() const { return {unit, foreignUnit}; }
    [[nodiscard]] bool isIn(UnitKind of) const { return unit && unit->kind == of; }
    [[nodiscard]] bool isNumeric() const { return kind == ColumnKind::numbers; }
    [[nodiscard]] bool isTime() const { return meaning == Meaning::time || isIn(UnitKind::time); }
    [[nodiscard]] bool isTemperature() const {
        return meaning == Meaning::temperature || isIn(UnitKind::temperature);
    }
};

/// Related rows of numbers and the words above them, as row indices of the table.
struct TableBlock {
    std::vector<std::uint32_t> rows;
    std::vector<std::uint32_t> heads;           ///< since the former block
    std::optional<std::uint32_t> numericHead;   ///< a heading with numbers: "Run; 0; 150; 300"
    std::optional<std::uint32_t> directionHead; ///< below it, the directions of columns: "; ↑; ↓; ↑; ↓"
    std::size_t section = 0;                    ///< index of the section with its headings
};

/// The rows of a table sorted into measured data and statements about them.
struct TableBody {
    std::vector<TableColumn> columns;               ///< of the first section
    std::vector<std::vector<TableColumn>> sections; ///< alike except for directions and run numbers
    std::vector<TableBlock> blocks;
    std::vector<std::uint32_t> lastRows;    ///< of the blocks, also of those of tables that are not read
    std::vector<std::uint32_t> notes;       ///< comments and lines that are not headings
    std::vector<std::uint32_t> columnHeads; ///< rows of the headings
    Remarks remarks;
    std::vector<ListedTable> tables; ///< in file order, including the one read
    std::size_t table = 0;           ///< index of the one read
    /// Words that name no direction by themselves, in a column headed as directions: a single one is the
    /// opposite of the others, two are letters of a pair, or null and asked.
    std::map<std::string, std::optional<Direction>, std::less<>> directionWords;

    /// The direction named by a cell of the direction column.
    [[nodiscard]] std::optional<Direction> directionIn(std::string_view cell) const {
        const auto word = directionWords.find(cell);
        return word == directionWords.end() ? directionOf(cell) : word->second;
    }
    /// True for a column of directions.
    [[nodiscard]] bool saysDirections(const TableColumn &column) const {
        return column.kind == ColumnKind::directions ||
               (column.kind == ColumnKind::words && column.meaning == Meaning::direction &&
                !directionWords.empty());
    }
    [[nodiscard]] std::size_t rowCount() const;
    /// The columns for which it is true, from left to right.
    template <class Is>
    [[nodiscard]] std::vector<std::size_t> columnsWhere(Is is) const {
        std::vector<std::size_t> found;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (std::invoke(is, columns[c]))
                found.push_back(c);
        }
        return found;
    }
    [[nodiscard]] std::vector<std::size_t> numberColumns() const {
        return columnsWhere(&TableColumn::isNumeric);
    }
    [[nodiscard]] std::vector<std::size_t> numberColumns(Meaning meaning) const {
        return columnsWhere(
            [=](const TableColumn &column) { return column.isNumeric() && column.meaning == meaning; });
    }
    template <class Is>
    [[nodiscard]] bool anyColumn(Is is) const {
        return std::ranges::any_of(columns, is);
    }
    /// The first of that meaning or kind.
    [[nodiscard]] std::optional<std::size_t> columnOf(Meaning meaning) const {
        return indexOf(columns, meaning, &TableColumn::meaning);
    }
    [[nodiscard]] std::optional<std::size_t> columnOf(ColumnKind kind) const {
        return indexOf(columns, kind, &TableColumn::kind);
    }
    [[nodiscard]] bool has(Meaning meaning) const { return columnOf(meaning).has_value(); }
};

/// Throws Error(content) if there are no rows of numbers. `ofNumbers`: columns to which the user assigned a
/// role of numbers.
[[nodiscard]] TableBody bodyOf(const CellTable &table, const std::vector<std::size_t> &ofNumbers);

/// Cells without trailing empty ones.
[[nodiscard]] std::span<const TableCell> trimmed(std::span<const TableCell> cells);

/// True if a cell names a direction; signs are not missing readings there.
[[nodiscard]] bool isDirectionCell(const CellTable &table, const TableCell &cell);

/// True for 2024, 2025 above columns: neither a run number nor a target.
[[nodiscard]] bool isYear(double number);

/// Finds the column headings: for each block of rows those above it, joined downwards. Blocks without
/// headings belong to the section before them.
void findSections(const CellTable &table, TableBody &body);

/// "Tolerance; 8; 8; 8": a label of computed or required values, with numbers.
[[nodiscard]] bool isComputedRow(const CellTable &table, const TableRow &row);

/// "Axis; X; Feed; 2000 mm/min", "Temperature; 20.3; °C", "Date; 12/03/2024": labels, each with its value.
[[nodiscard]] bool isRowOfStatements(const CellTable &table, const TableRow &row);

/// True if a text distinguishes columns or blocks: "Run 1", "Target", "↑", "As found".
[[nodiscard]] bool tellsReadings(std::string_view text);

/// Makes comments of the statements in columns to the right or left of a table: "Operator; Smith" beside its
/// lines.
void setColumnsAside(CellTable &table);

/// Makes comments of the lines above the first table and an empty line if they do not describe columns: "Air
/// temperature; 20.1; 20.3", "Travel; 0; 500", "Machine: DMU 50". They are read as notes and do not affect
/// the layout. Headings are kept, including blocks titled by direction, axis or state.
void setStatementsAside(CellTable &table);

} // namespace palmer
