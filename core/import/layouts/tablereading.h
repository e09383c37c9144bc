// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/imported.h"

namespace palmer {

/// The columns that say machine, day, plane, feed … of each line, and the lines of other tests.
struct LineConditions {
    std::vector<std::size_t> conditions; ///< columns, as used
    std::vector<bool> isOfOtherTest;     ///< of each row of the table; empty if all are of one test
};

/// A table being read, shared by the readers of all kinds.
class TableReading {
public:
    TableReading(Imported &imported, Choices &chosen, const std::vector<CoverSheet> &covers);

    [[nodiscard]] const CellTable &table() const { return result.table; }
    [[nodiscard]] const TableRow &row(std::uint32_t index) const { return result.table.rows()[index]; }
    /// The cell of the row of that index; null if the row is too short.
    [[nodiscard]] const TableCell *cell(std::uint32_t index, std::size_t column) const {
        const auto cells = table().cells(row(index));
        return column < cells.size() ? &cells[column] : nullptr;
    }
    /// The columns of the table in the roles that such a text names, as for the choice "columns"; the others
    /// are ignored.
    [[nodiscard]] std::vector<ImportColumn> columnsAs(std::string_view roles) const;
    /// Settles the roles that were found, with the question about them as a remark of that grade. Returns the
    /// columns that the user chose instead; null if none.
    [[nodiscard]] std::optional<std::vector<ImportColumn>>
    resolveColumns(const std::vector<ImportColumn> &found, const std::optional<Message> &question,
                   RemarkGrade grade);
    [[nodiscard]] std::string_view cellText(std::uint32_t index, std::size_t column) const;
    /// All cells of a row, each preceded by a blank.
    [[nodiscard]] std::string textOf(std::uint32_t index) const;

    /// The number of a cell; null if missing. Anything else is a problem, and missing.
    [[nodiscard]] std::optional<double> number(std::uint32_t index, std::size_t column) {
        const TableCell *found = cell(index, column);
        return found && found->isNumber() ? found->value : noNumber(index, column);
    }
    /// The number of a cell as it is; null for anything else.
    [[nodiscard]] std::optional<double> numberAt(std::uint32_t index, std::size_t column) const {
        const TableCell *found = cell(index, column);
        return found && found->isNumber() ? std::optional(found->value) : std::nullopt;
    }
    /// The numbers of a column in all blocks, no more than `most`.
    [[nodiscard]] std::vector<double> valuesOf(std::size_t column, std::size_t most = SIZE_MAX) const;
    /// The lowest and the highest number of a column; ∞ and −∞ if it has none.
    [[nodiscard]] std::pair<double, double> rangeOf(std::size_t column) const;
    /// A problem: the line is not read.
    void remarkNoTarget(std::uint32_t index, std::string_view cell);
    void setRole(std::uint32_t index, std::size_t column, CellRole role) {
        if (column < row(index).count)
            result.roles[row(index).first + column] = role;
    }

    /// The rows above a block that are no column headings, from the nearest one up.
    [[nodiscard]] std::vector<std::uint32_t> titlesOf(const TableBlock &block) const;
    /// The state that a title above a block names.
    [[nodiscard]] TestRole stateOf(const TableBlock &block) const;
    /// "Status", "Valid", "gültig": marks that differ from line to line, so that some readings are not like
    /// the others.
    [[nodiscard]] bool marksReadings(std::size_t column) const;
    /// Asks about the columns of such marks.
    void askForMarks(const std::function<bool(std::size_t)> &isRead) const;
    /// Names the columns that are not read: those that look like readings in a question.
    void remarkUnread(const std::function<bool(std::size_t)> &isRead,
                      const std::function<bool(std::size_t)> &looksLikeReadings);

    Imported &result;
    Remarks &remarks{result.remarks};
    Choices &choices;
    TableBody body;
    FileNotes notes;
    std::string axisFound;                     ///< the axis read, if the table has several
    TestRole stateFound = TestRole::notStated; ///< the state read, if there are two: before or after an
                                               ///< adjustment

private:
    void askForTable(bool isOfAxis);
    void keepOneTest(const std::vector<CoverSheet> &covers);
    void askForCutEnd();
    std::optional<double> noNumber(std::uint32_t index, std::size_t column);

    std::size_t m_missingWords = 0;
};

/// Reads targets and readings in one of the layouts. Sets the test of the result.
void readPositioning(TableReading &reading);
/// Reads points of circles. Sets the test of the result.
void readCircles(TableReading &reading);
/// Reads deviations or temperatures over time. Sets the test or the sensors of the result.
void readSeries(TableReading &reading, bool temperatures);

/// True if the pairs of x and y lie on a circle.
[[nodiscard]] bool areOnCircle(const TableReading &reading, std::size_t xColumn, std::size_t yColumn);

/// The word for a quantity measured along an axis other than its position; empty if there is none.
[[nodiscard]] std::string otherQuantity(std::string_view text);

/// True if a column counts 0, 1, 2 … or 1, 2, 3 … .
[[nodiscard]] bool isCounter(const TableReading &reading, std::size_t column);

} // namespace palmer
