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
#include <utility>
#include <vector>

namespace palmer {

/// The separator of the cells of a line; `colon` only between blanks.
enum class Delimiter { tab, semicolon, comma, bar, colon, blanks };

/// A cell of a table with its position in the table's text, without quotation marks and outer blanks.
struct TableCell {
    double value = 0; ///< of a number, otherwise 0
    std::uint32_t begin = 0;
    std::uint16_t size = 0; ///< bytes, truncated at 65 535
    CellKind kind = CellKind::empty;

    [[nodiscard]] bool isNumber() const { return kind == CellKind::number; }
};

/// A line of a table: its cells from `first` on. Lines without a cell are not rows.
struct TableRow {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t line = 1; ///< in the text, from 1
    bool comment = false;   ///< begins with # % or // (one cell, the line without the mark), or was set aside
    bool aside = false;     ///< a comment because of its content
    bool beside = false;    ///< one from the cells beside a table, which parts nothing
};

struct TableOptions {
    std::optional<Delimiter> delimiter;
    std::optional<DecimalMark> decimalMark;
    bool comments = true; ///< lines that begin with # % or // are comments
};

/// The unit after the numbers in a column's cells.
struct ColumnUnit {
    const Unit *unit = nullptr; ///< null if there is none
    std::uint32_t bareLine = 0; ///< line of a number other than 0 without unit; 0 if there is none
};

/// A text split into rows and cells. The cells refer to the text it holds.
class CellTable {
public:
    CellTable() = default;

    [[nodiscard]] const std::string &text() const { return m_text; }
    [[nodiscard]] std::span<const TableRow> rows() const { return m_rows; }
    [[nodiscard]] std::span<const TableCell> cells(const TableRow &row) const {
        return std::span(m_cells).subspan(row.first, row.count);
    }
    /// The text of a cell, without quotation marks; "" inside a quoted cell remains doubled.
    [[nodiscard]] std::string_view text(const TableCell &cell) const {
        return std::string_view(m_text).substr(cell.begin, cell.size);
    }
    /// The unit stated in the cells of a column ("1.234 mm"), once takeUnits() has converted them to numbers.
    [[nodiscard]] ColumnUnit unitOfColumn(std::size_t column) const {
        return column < m_units.size() ? m_units[column] : ColumnUnit{};
    }
    /// The row of targets across and the unit after its numbers.
    struct RowUnit {
        std::uint32_t row = 0;
        const Unit *unit = nullptr; ///< null if there is no such row
    };
    [[nodiscard]] const RowUnit &unitOfRow() const { return m_rowUnit; }

    /// Converts cells that repeat one word with a number each, such as "Target 100 mm", to these numbers if
    /// the word `isOfTargets` and no other number is in their line.
    void takeNumbersBehind(bool (*isOfTargets)(std::string_view word));

    /// Converts cells with a unit to numbers if most numbers of their column have one, all in the same unit;
    /// decimals are moved in the text. Other cells remain texts.
    void takeUnits();

    /// From 1, in characters of the line.
    [[nodiscard]] std::size_t column(const TableCell &cell) const;

    /// Removes the rows outside these lines of the file, counted from 1.
    void keepLines(std::size_t first, std::size_t last);

    /// Marks rows, by index, as comments.
    void setAside(std::span<const std::size_t> rows);

    /// Makes comments of the cells in columns `first` to `end`, each below the line that they stand in.
    void moveBeside(std::size_t first, std::size_t end);

    Choice<Delimiter> delimiter;
    Choice<DecimalMark> decimalMark;
    bool isFormDoubtful = false; ///< of the guessed ones: other numbers are as likely
    bool isPlaced = false;       ///< the file states the column of each cell, as workbooks do

private:
    void joinWords();
    const TableRow *joinLabels();
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
    bool m_saysUnits = false; ///< in at least one cell
    std::vector<ColumnUnit> m_units;
    std::vector<std::pair<std::uint32_t, double>> m_formatted; ///< cells whose unit is only displayed
    RowUnit m_rowUnit;
};

/// Reads a table from a text: UTF-8, lines ending with CR, LF or both. Cells may be quoted ("…", doubled
/// inside). Unset options are detected: the delimiter and decimal mark with which most cells are numbers and
/// the rows are alike; `guessed` if another reading of the numbers is as likely. Throws Error(tooLarge) for
/// more than 10⁷ cells or a line of more than 1 MiB, with the line. Linear in the text.
[[nodiscard]] CellTable readTable(std::string text, const TableOptions &options = {});

/// Builds a table from separate cells, as in a workbook; numbers have a decimal point.
class TableBuilder {
public:
    /// Makes room for so many cells, up to the most that a table holds.
    void reserve(std::size_t cells);
    void beginRow(std::size_t line);
    void add(std::string_view cell); ///< a text, possibly a number typed as text
    void add(double number, std::string_view shown);
    /// A number whose cell displays a unit.
    void add(double number, const Unit &unit);
    /// Numbers among the texts have the given mark, otherwise the one valid for most.
    [[nodiscard]] CellTable take(std::optional<DecimalMark> mark = {});

private:
    std::vector<std::size_t> m_texts; ///< text cells that may be numbers
    TableCell &append(std::string_view cell);

    CellTable m_table;
};

} // namespace palmer
