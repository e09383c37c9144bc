// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/choice.h"
#include "tables/numbercell.h"
#include "tables/units.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// The separator of the cells of a line; `colon` only between blanks.
enum class Delimiter { tab, semicolon, comma, bar, colon, blanks };

/// A cell of a table; where it stands in the text of the table, without quotation marks and outer blanks.
struct TableCell {
    double value = 0; ///< of a number, else 0
    std::uint32_t begin = 0;
    std::uint16_t size = 0; ///< bytes, cut off at 65 535
    CellKind kind = CellKind::empty;

    [[nodiscard]] bool isNumber() const { return kind == CellKind::number; }
};

/// A line of a table: its cells from `first` on. Lines without a cell are no rows.
struct TableRow {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t line = 1; ///< of the text, from 1
    bool comment = false;   ///< begins with # % or //: one cell, the line without the mark; or is set aside
    bool aside = false;     ///< a comment by what it says
};

struct TableOptions {
    std::optional<Delimiter> delimiter;
    std::optional<DecimalMark> decimalMark;
    bool comments = true; ///< whether lines that begin with # % or // are comments
};

/// What the cells of a column say behind their numbers.
struct ColumnUnit {
    const Unit *unit = nullptr; ///< null: nothing
    std::uint32_t bareLine = 0; ///< where a number other than 0 stands without one; 0: nowhere
};

/// A text taken apart into rows and cells. Immutable; the cells refer to the text it holds.
class CellTable {
public:
    CellTable() = default;

    [[nodiscard]] const std::string &text() const { return m_text; }
    [[nodiscard]] std::span<const TableRow> rows() const { return m_rows; }
    [[nodiscard]] std::span<const TableCell> cells(const TableRow &row) const {
        return std::span(m_cells).subspan(row.first, row.count);
    }
    /// What a cell says, without quotation marks; "" inside a quoted cell stays doubled.
    [[nodiscard]] std::string_view text(const TableCell &cell) const {
        return std::string_view(m_text).substr(cell.begin, cell.size);
    }
    /// Of cells that say one ("1.234 mm"), once takeUnits() has made numbers of them.
    [[nodiscard]] ColumnUnit unitOfColumn(std::size_t column) const {
        return column < m_units.size() ? m_units[column] : ColumnUnit{};
    }
    /// Of targets that stand across: their row, and what it says behind each number.
    struct RowUnit {
        std::uint32_t row = 0;
        const Unit *unit = nullptr; ///< null: there is no such row
    };
    [[nodiscard]] const RowUnit &unitOfRow() const { return m_rowUnit; }

    /// Makes numbers of cells with a unit where most numbers of their column have one, all in the same unit;
    /// decimals are moved in the text. Other cells stay texts.
    void takeUnits();

    /// From 1; the column counts characters of the line.
    [[nodiscard]] std::size_t column(const TableCell &cell) const;

    /// Leaves out what stands outside of these lines of the file, from 1.
    void keepLines(std::size_t first, std::size_t last);

    /// Takes rows, by index, for comments.
    void setAside(std::span<const std::size_t> rows);

    Choice<Delimiter> delimiter;
    Choice<DecimalMark> decimalMark;
    bool isPlaced = false; ///< the file says the column of each cell, as workbooks do

private:
    void joinWords();
    void placeHeads();
    void setCells(TableRow &row, const std::vector<TableCell> &cells);
    [[nodiscard]] const TableRow *usualRow() const;
    [[nodiscard]] std::vector<TableCell> joinedWords(const TableRow &row, bool brackets) const;
    [[nodiscard]] std::vector<TableCell> placedOver(const std::vector<TableCell> &words,
                                                    const TableRow &numbers) const;

    friend CellTable readTable(std::string text, const TableOptions &options);
    friend class TableBuilder;
    friend class UnitTaker;

    std::string m_text;
    std::vector<TableRow> m_rows;
    std::vector<TableCell> m_cells;
    bool m_saysUnits = false; ///< in a cell at least
    std::vector<ColumnUnit> m_units;
    RowUnit m_rowUnit;
};

/// The table a text says: UTF-8, lines ended by CR, LF or both. Cells may be quoted ("…", doubled inside).
/// What the options leave open is taken from the text: the delimiter and decimal mark under which most cells
/// are numbers and the rows are alike; `guessed` where another reading of the numbers is as likely.
/// Throws Error(tooLarge) for more than 10⁷ cells and for a line of more than 1 MiB, with the line. Linear in
/// the text.
[[nodiscard]] CellTable readTable(std::string text, const TableOptions &options = {});

/// A table from cells that are taken apart already, as those of a workbook; numbers with a point.
class TableBuilder {
public:
    void beginRow(std::size_t line);
    void add(std::string_view cell); ///< a text, which may be a number that was typed as text
    void add(double number, std::string_view shown);
    /// Numbers among the texts have the mark given, else that which most of them can have.
    [[nodiscard]] CellTable take(std::optional<DecimalMark> mark = {});

private:
    std::vector<std::size_t> m_texts; ///< cells that are no numbers of the workbook
    TableCell &append(std::string_view cell);

    CellTable m_table;
};

} // namespace palmer
