// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/imported.h"

namespace palmer {

/// A table on its way to a measurement: what the readers of the kinds share.
class TableReading {
public:
    TableReading(Imported &imported, Choices &chosen);

    [[nodiscard]] const CellTable &table() const { return result.table; }
    [[nodiscard]] const TableRow &row(std::uint32_t index) const { return result.table.rows()[index]; }
    /// The cell of the row of that index, or null where the row is too short.
    [[nodiscard]] const TableCell *cell(std::uint32_t index, std::size_t column) const {
        const auto cells = table().cells(row(index));
        return column < cells.size() ? &cells[column] : nullptr;
    }
    [[nodiscard]] std::string_view cellText(std::uint32_t index, std::size_t column) const;
    /// All cells of a row, a blank before each.
    [[nodiscard]] std::string textOf(std::uint32_t index) const;

    /// The number of a cell; null for a missing one. What is neither is a problem and missing.
    [[nodiscard]] std::optional<double> number(std::uint32_t index, std::size_t column) {
        const TableCell *found = cell(index, column);
        return found && found->isNumber() ? found->value : noNumber(index, column);
    }
    void setRole(std::uint32_t index, std::size_t column, CellRole role) {
        if (column < row(index).count)
            result.roles[row(index).first + column] = role;
    }

    void remark(RemarkGrade grade, Message message, std::size_t line = 0, std::string choice = {});
    /// The headings of a block as one text, without those of the columns.
    [[nodiscard]] std::string titleOf(const TableBlock &block) const;

    Imported &result;
    Choices &choices;
    TableBody body;
    FileNotes notes;
    std::string axisFound;                     ///< the one of several in the table that is read
    TestRole stateFound = TestRole::notStated; ///< likewise: before or after an adjustment

private:
    void askForTable();
    std::optional<double> noNumber(std::uint32_t index, std::size_t column);

    std::size_t m_missingWords = 0;
};

/// Targets and readings, in one of the layouts. Sets the test of the result.
void readPositioning(TableReading &reading);
/// Points of circles. Sets the test of the result.
void readCircles(TableReading &reading);
/// Deviations or temperatures over time. Sets the test, or the sensors of the result.
void readSeries(TableReading &reading, bool temperatures);

/// Whether the points lie on a circle: pairs of x and y.
[[nodiscard]] bool areOnCircle(const TableReading &reading, std::size_t xColumn, std::size_t yColumn);

/// Whether a column counts 0, 1, 2 … or 1, 2, 3 … .
[[nodiscard]] bool isCounter(const TableReading &reading, std::size_t column);

} // namespace palmer
