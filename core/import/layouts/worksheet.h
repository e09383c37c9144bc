// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/layouts/zipfile.h"
#include "import/remark.h"
#include "tables/table.h"

#include <QString>
#include <charconv>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

inline constexpr int mostSheetColumns = 16'384;
inline constexpr std::size_t longestSheetCell = 65'535; ///< bytes

/// Adds cells of a sheet to the table, including the empty ones between them.
class Sheet {
public:
    explicit Sheet(const Choices &choices)
        : m_leavesHidden(choices.chosen("hidden") == "leave") {}

    /// Makes room for the cells of a sheet of so many bytes of XML.
    void expect(qint64 bytes) {
        constexpr qint64 usualCell = 26; // <c r="B12"><v>0.01</v></c>
        m_builder.reserve(static_cast<std::size_t>(bytes / usualCell));
    }
    /// Columns from 0, in ascending order, as described in files.
    void hideColumns(int first, int count) {
        if (first < std::ssize(m_hiddenColumns))
            return;
        m_hiddenColumns.resize(static_cast<std::size_t>(first), false);
        m_hiddenColumns.resize(static_cast<std::size_t>(first) + static_cast<std::size_t>(count), true);
    }
    void beginRow(std::size_t line, bool isHidden = false) {
        m_column = 0;
        m_line = line;
        m_begun = false;
        m_isHidden = isHidden;
        m_numbers = 0;
        m_emptyFormulas = 0;
    }
    /// A formula without a stored value, which may be a number.
    void addEmptyFormula() {
        ++m_emptyFormulas;
        countEmptyFormulas();
    }
    /// `unit`: displayed with the number; may be null.
    void add(int column, std::string_view text, std::optional<double> number, const Unit *unit = nullptr);
    CellTable take(const Choices &choices);

    QuotedLines comments;          ///< of cells
    std::size_t hiddenNumbers = 0; ///< in hidden rows or columns
    std::size_t emptyFormulas = 0; ///< in rows with numbers, such as readings
    std::size_t emptyFormulaLine = 0;

private:
    [[nodiscard]] bool isHiddenAt(int column) const {
        return m_isHidden ||
               (column < std::ssize(m_hiddenColumns) && m_hiddenColumns[static_cast<std::size_t>(column)]);
    }
    void countEmptyFormulas() {
        if (m_numbers == 0 || m_emptyFormulas == 0)
            return;
        if (emptyFormulas == 0)
            emptyFormulaLine = m_line;
        emptyFormulas += std::exchange(m_emptyFormulas, 0);
    }

    TableBuilder m_builder;
    std::vector<bool> m_hiddenColumns; ///< up to the last hidden one
    bool m_leavesHidden;
    std::size_t m_line = 1;
    int m_column = 0;
    bool m_begun = false;
    bool m_isHidden = false;
    std::size_t m_numbers = 0;       ///< in the row
    std::size_t m_emptyFormulas = 0; ///< in the row, not yet counted
};

/// The name of a sheet, and where it stands.
struct SheetName {
    QString name;
    QString member = {}; ///< in the archive (xlsx)
    bool isHidden = false;
};

/// An archive with sheets. `read` adds the cells of that of an index.
struct Workbook {
    std::vector<SheetName> sheets;
    std::function<void(std::size_t index, Sheet &sheet)> read;
};

// Null for other archives, which must outlive what is returned.
[[nodiscard]] std::optional<Workbook> xlsxOf(ZipFile &zip);
[[nodiscard]] std::optional<Workbook> odsOf(ZipFile &zip);

/// The integer value of an attribute; 0 for anything else.
template <class Number = int>
[[nodiscard]] Number wholeNumberIn(std::string_view text) {
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
}
/// The number of a cell; null for a text.
[[nodiscard]] std::optional<double> finiteNumber(std::string_view text);
[[nodiscard]] inline QString inQt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace palmer
