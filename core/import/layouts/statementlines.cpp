// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/tablebody.h"

#include "import/filenotes.h"
#include "import/labelledvalues.h"
#include "import/layouts/phrases.h"
#include "import/layouts/sections.h"
#include "import/notelabels.h"
#include "kernel/words/characters.h"
#include "tables/cellunits.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

namespace {

/// Part of a line: a cell, or in blank-separated columns the text between two or more blanks.
struct Entry {
    std::string_view text;
    CellKind kind = CellKind::text;
};
using Entries = std::vector<Entry>;

const char *endOf(std::string_view text) {
    return text.data() + text.size();
}

Entries entriesOf(const CellTable &table, const TableRow &row) {
    Entries entries;
    const auto cells = table.cells(row);
    if (table.delimiter.value != Delimiter::blanks || table.isPlaced) {
        for (const TableCell &cell : cells) {
            if (cell.kind != CellKind::empty)
                entries.push_back({table.text(cell), cell.kind});
        }
        return entries;
    }
    const std::string_view all = table.text();
    for (const TableCell &cell : cells) {
        if (cell.kind == CellKind::empty)
            continue; // from fixed-width columns: not in the text
        const std::string_view text = table.text(cell);
        const std::size_t behind =
            entries.empty() ? 0 : static_cast<std::size_t>(endOf(entries.back().text) - all.data());
        if (entries.empty() || cell.begin > behind + 1 || all[behind] == '\t')
            entries.push_back({text, cell.kind});
        else // a single blank does not separate
            entries.back() = {{entries.back().text.data(), endOf(text)}, CellKind::text};
    }
    return entries;
}

std::size_t count(const Entries &entries, CellKind kind) {
    return static_cast<std::size_t>(std::ranges::count(entries, kind, &Entry::kind));
}

/// Rows without an empty line between them.
struct Paragraph {
    std::vector<std::size_t> rows;   ///< without comments
    std::vector<std::size_t> titles; ///< those of them with a text and no number
    std::size_t numbers = 0;
};

std::vector<Paragraph> paragraphsOf(const CellTable &table) {
    std::vector<Paragraph> paragraphs;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const TableRow &row = table.rows()[i];
        if (paragraphs.empty() || row.line > last + 1)
            paragraphs.emplace_back();
        last = row.line;
        if (row.comment)
            continue;
        const auto cells = table.cells(row);
        const auto numbers = std::ranges::count(cells, CellKind::number, &TableCell::kind);
        paragraphs.back().rows.push_back(i);
        paragraphs.back().numbers += static_cast<std::size_t>(numbers);
        if (numbers == 0 && !cells.empty() && cells.front().kind == CellKind::text)
            paragraphs.back().titles.push_back(i);
    }
    std::erase_if(paragraphs, [](const Paragraph &paragraph) { return paragraph.rows.empty(); });
    return paragraphs;
}

/// True for "Number of runs", which is not a run.
bool isCount(std::string_view label) {
    constexpr std::array<std::string_view, 5> beginnings{"number of ", "nombre d", "anzahl ", "numero di ",
                                                         "numero de "};
    const std::string text = folded(label);
    return std::ranges::any_of(beginnings, [&](std::string_view each) { return text.starts_with(each); });
}

/// A number with a unit, in one cell or two, or a date.
bool isQuantity(std::string_view value, std::string_view next) {
    constexpr std::array<std::string_view, 14> others{"hPa", "mbar", "Pa",  "kPa", "bar", "mmHg",   "%rH",
                                                      "%RH", "kg",   "rpm", "kW",  "V",   "mm/min", "m/min"};
    const LeadingNumber number = leadingNumber(value, decimalMarkIn(value));
    const std::string_view rest = withoutBlanks(value.substr(number.size));
    const std::string_view unit = next.empty() ? rest : next;
    const bool isUnit = unitIn('(' + std::string(unit) + ')') != nullptr || unit.starts_with('%') ||
                        std::ranges::find(others, unit) != others.end();
    return number.size > 0 && isUnit && (next.empty() || rest.empty());
}

bool couldBeLabel(std::string_view text) {
    return !text.empty() && !isDigit(text.front()) && !unitIn(text);
}

/// The name of a condition: a time of day is no reading, a run is no condition.
bool namesCondition(std::string_view text) {
    return factOfWholeTest(text) ||
           (couldBeLabel(text) && (readHeading(text).meaning == Meaning::time || !tellsReadings(text)));
}

/// The number of texts that are one label with its value, from the first on; 0 if there is none.
std::size_t statementAt(std::span<const std::string_view> texts) {
    const std::string_view label = texts.front();
    if (!namesCondition(label.substr(0, label.find_first_of(":="))))
        return 0;
    const std::size_t sign = label.find_first_of(":=");
    if (sign < label.size() - 1) // "Machine: DMU 50" in one cell
        return 1;
    if (texts.size() < 2)
        return 0;
    const std::string_view value = texts[1];
    if (texts.size() > 2 && isQuantity(value, texts[2]))
        return 3;
    const bool isName = factOfWholeTest(label) && !factOfWholeTest(value) && !tellsReadings(value);
    const bool isLetter = value.size() == 1 && readHeading(label).meaning == Meaning::axis;
    const bool isValue = sign != std::string_view::npos || isName || isLetter || isDate(value) ||
                         clockTime(value) || numberIn(value) || isQuantity(value, {});
    return isValue ? 2 : 0;
}

class Preface {
public:
    Preface(const CellTable &table, const std::vector<Paragraph> &paragraphs, std::size_t at)
        : m_table(table)
        , m_paragraphs(paragraphs)
        , m_at(at) {}

    [[nodiscard]] bool isStatements() const {
        const auto &rows = m_paragraphs[m_at].rows;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!isStatement(rows[i]) && !isLoneRow(i))
                return false;
        }
        return isLabelledValue(m_table, m_table.rows()[rows.back()]) || areLabels(rows.back()) ||
               !isHeading(rows.back());
    }

private:
    [[nodiscard]] Entries entries(std::size_t row) const { return entriesOf(m_table, m_table.rows()[row]); }

    /// "Test after ISO 230-2:2014" is not the title of a block.
    [[nodiscard]] static bool isSentence(const Entries &all) {
        constexpr std::size_t longestTitle = 3;
        const HeadingWords words = readHeading(all.front().text);
        // "Linear positioning test", "Laser measurement"; "Test 1" counts a run.
        const bool isOfWholeTest = (words.isTest || words.meaning == Meaning::reading) && words.words > 1 &&
                                   !words.number && !words.hint;
        return all.size() == 1 && !words.direction &&
               (isOfWholeTest || (words.words > longestTitle && words.unknownWords > 0));
    }

    /// True for a label with values, but not for a row of a wider table or the title of one of several
    /// blocks.
    [[nodiscard]] bool isStatement(std::size_t row) const {
        constexpr std::size_t mostEntries = 4; // "Air", "20.1", "20.3", "°C"
        const Entries all = entries(row);
        const auto isRule = [](const Entry &entry) { // of Markdown
            return entry.text.find_first_not_of("-:") == std::string_view::npos;
        };
        if (all.empty())
            return false;
        if (std::ranges::all_of(all, isRule))
            return true;
        if (all.front().kind != CellKind::text || all.size() > mostEntries || recurs(all.front().text))
            return false;
        const std::string_view label = all.front().text;
        return isSentence(all) || (label.ends_with(':') && all.size() > 1) || isCount(label) ||
               isLabelledValue(m_table, m_table.rows()[row]) || areLabels(row) || !tellsReadings(label);
    }

    /// "Machine under test; VF2; ; Dead path; 80 mm": labels, each with its value.
    [[nodiscard]] bool areLabels(std::size_t row) const {
        const std::vector<LabelledValue> said = labelledValuesIn(m_table, m_table.rows()[row]);
        return !said.empty() && std::ranges::all_of(said, [](const LabelledValue &one) {
            if (one.label.empty() || one.values.empty())
                return false;
            // "Measuring instrument; XL-80"
            const bool isOther =
                readHeading(one.label).unknownWords > 0 && !tellsReadings(one.values.front());
            return factOf(one.label) || !tellsReadings(one.label) || isOther;
        });
    }

    /// Numbers below a single row of words: "Lower limit; Upper limit" and "0; 500".
    [[nodiscard]] bool isLoneRow(std::size_t index) const {
        const auto &rows = m_paragraphs[m_at].rows;
        if (rows.size() != 2 || index != 1)
            return false;
        const Entries words = entries(rows.front());
        const Entries numbers = entries(rows.back());
        return count(words, CellKind::text) == words.size() && words.size() == numbers.size() &&
               count(numbers, CellKind::number) == numbers.size() &&
               std::ranges::none_of(words, tellsReadings, &Entry::text);
    }

    /// True for the last row above numbers without their own heading.
    [[nodiscard]] bool isHeading(std::size_t row) const {
        const Entries all = entries(row);
        if (count(all, CellKind::text) < all.size() || isSentence(all))
            return false;
        for (std::size_t i = m_paragraphs[m_at + 1].rows.front(); i < m_table.rows().size(); ++i) {
            const auto cells = m_table.cells(m_table.rows()[i]);
            if (std::ranges::find(cells, CellKind::number, &TableCell::kind) != cells.end())
                return all.size() >= cells.size() || std::ranges::any_of(all, tellsReadings, &Entry::text);
            if (std::ranges::count(cells, CellKind::text, &TableCell::kind) >= 2)
                return false;
        }
        return false;
    }

    /// True if blocks below have the same title, or that of another axis.
    [[nodiscard]] bool recurs(std::string_view label) const {
        const HeadingWords words = readHeading(label);
        const bool isAxis = words.axis != 0 && words.unknownWords == 0 && words.meaning != Meaning::other;
        for (std::size_t p = m_at + 1; p < m_paragraphs.size(); ++p) {
            for (const std::size_t i : m_paragraphs[p].titles) {
                const std::string_view text = entries(i).front().text;
                if (text == label || (isAxis && readHeading(text).axis != 0))
                    return true;
            }
        }
        return false;
    }

    const CellTable &m_table;
    const std::vector<Paragraph> &m_paragraphs;
    std::size_t m_at;
};

} // namespace

/// True if a text distinguishes columns or blocks: "Run 1", "Target", "↑", "As found".
bool tellsReadings(std::string_view text) {
    const HeadingWords words = readHeading(text);
    constexpr std::array readings{Meaning::target,  Meaning::place,     Meaning::actual, Meaning::deviation,
                                  Meaning::reading, Meaning::direction, Meaning::run,    Meaning::angle,
                                  Meaning::radius,  Meaning::time,      Meaning::x,      Meaning::y};
    return words.direction || words.hint || directionOf(text) || words.state != TestRole::notStated ||
           std::ranges::find(readings, words.meaning) != readings.end();
}

bool isRowOfStatements(const CellTable &table, const TableRow &row) {
    std::vector<std::string_view> texts;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.kind != CellKind::empty)
            texts.push_back(table.text(cell));
    }
    if (texts.size() < 2)
        return false;
    if (texts.size() <= 3 && couldBeLabel(texts[0]) &&
        (texts.size() == 2 ? isDate(texts[1]) || isQuantity(texts[1], {}) : isQuantity(texts[1], texts[2])))
        return true;
    std::set<std::string> labels; // a label twice heads two columns
    std::size_t taken = 0;
    while (taken < texts.size()) {
        const std::size_t size = statementAt(std::span(texts).subspan(taken));
        if (size == 0 || !labels.insert(folded(texts[taken])).second)
            return false;
        taken += size;
    }
    return labels.size() > 1;
}

namespace {

/// Finds columns beside a table that hold labels and their values.
class StatementColumns {
public:
    explicit StatementColumns(const CellTable &table)
        : m_table(table) {
        for (const TableRow &row : table.rows())
            m_width = std::max<std::size_t>(m_width, row.comment ? 0 : row.count);
    }

    [[nodiscard]] std::size_t width() const { return m_width; }

    /// True if columns `first` to `end` hold statements, and those from `table` to `tableEnd` numbers in some
    /// of the same lines. If column `gap` between them is not empty, most labels must be known.
    [[nodiscard]] bool areBeside(std::size_t first, std::size_t end, std::size_t gap, std::size_t table,
                                 std::size_t tableEnd) const {
        constexpr std::size_t mostTitles = 2;
        std::set<std::string> labels;
        std::size_t known = 0;
        std::size_t titles = 0;
        std::size_t shared = 0; // lines with cells of both
        bool isApart = true;
        for (const TableRow &row : m_table.rows()) {
            const std::vector<TableCell> cells = cellsIn(row, first, end);
            if (row.comment || cells.empty())
                continue;
            const bool isShared = !cellsIn(row, table, tableEnd).empty();
            if (first < table && !isShared) { // a title above the table, or a line below
                if (cells.front().isNumber())
                    return false; // the table itself
                continue;
            }
            isApart = isApart && cellsIn(row, gap, gap + 1).empty();
            shared += isShared ? 1 : 0;
            if (isTitle(cells) && ++titles <= mostTitles)
                continue;
            const std::string label = labelOf(cells);
            if (label.empty() || !labels.insert(label).second)
                return false;
            known += isKnown(label, cells) ? 1 : 0;
        }
        return shared > 0 &&
               (isApart ? known >= 1 && 8 * known >= labels.size()
                        : known >= 2 && 2 * known >= labels.size() && titles == 0) &&
               hasNumbers(table, tableEnd);
    }

private:
    /// The filled cells of these columns.
    [[nodiscard]] std::vector<TableCell> cellsIn(const TableRow &row, std::size_t first,
                                                 std::size_t end) const {
        std::vector<TableCell> filled;
        const auto cells = m_table.cells(row);
        for (std::size_t c = first; c < std::min(end, cells.size()); ++c) {
            if (cells[c].kind != CellKind::empty)
                filled.push_back(cells[c]);
        }
        return filled;
    }

    /// The label, folded, of cells that are one with its value; else empty. "Run 1; 0.2" belongs to a table.
    [[nodiscard]] std::string labelOf(const std::vector<TableCell> &cells) const {
        constexpr std::size_t mostCells = 4; // "Air", "20.1", "20.3", "°C"
        if (cells.front().kind != CellKind::text || cells.size() > mostCells)
            return {};
        const std::string_view text = m_table.text(cells.front());
        const std::string_view label = text.substr(0, text.find_first_of(":="));
        const bool hasValue = cells.size() > 1 || label.size() + 1 < text.size();
        const bool isOfReadings =
            !factOf(label) && tellsReadings(label) && cells.size() > 1 && cells[1].isNumber();
        return hasValue && !isOfReadings ? folded(withoutBlanks(label)) : std::string();
    }

    [[nodiscard]] bool isKnown(const std::string &label, const std::vector<TableCell> &cells) const {
        return factOf(label) || m_table.text(cells.front()).ends_with(':');
    }

    /// "Conditions" above statements.
    [[nodiscard]] bool isTitle(const std::vector<TableCell> &cells) const {
        const std::string_view text = m_table.text(cells.front());
        return cells.size() == 1 && cells.front().kind == CellKind::text && !tellsReadings(text) &&
               text.find_first_of(":=") >= text.size() - 1;
    }

    [[nodiscard]] bool hasNumbers(std::size_t first, std::size_t end) const {
        constexpr std::ptrdiff_t fewest = 2; // lines
        return std::ranges::count_if(m_table.rows(), [&](const TableRow &row) {
                   return !row.comment &&
                          std::ranges::any_of(cellsIn(row, first, end), [this](const TableCell &cell) {
                              return cell.isNumber() ||
                                     cellWithUnit(m_table.text(cell), m_table.decimalMark.value);
                          });
               }) >= fewest;
    }

    const CellTable &m_table;
    std::size_t m_width = 0;
};

} // namespace

void setColumnsAside(CellTable &table) {
    constexpr std::size_t mostLines = 20'000; // longer tables are series
    constexpr std::size_t mostColumns = 500;
    constexpr std::size_t widest = 6; // of statements to the left
    const StatementColumns columns(table);
    const std::size_t width = columns.width();
    if ((table.delimiter.value == Delimiter::blanks && !table.isPlaced) || width > mostColumns ||
        table.rows().size() > mostLines)
        return;
    for (std::size_t c = 1; c < width; ++c) {
        if (columns.areBeside(c, width, c, 0, c))
            return table.moveBeside(c, width);
    }
    for (std::size_t gap = 1; gap + 1 < std::min(width, widest); ++gap) {
        if (columns.areBeside(0, gap, gap, gap + 1, width))
            return table.moveBeside(0, gap);
    }
}

void setStatementsAside(CellTable &table) {
    constexpr std::size_t mostLines = 300; // above the table
    const std::vector<Paragraph> paragraphs = paragraphsOf(table);
    const auto hasAsMany = [](const Paragraph &paragraph) {
        return [&paragraph](const Paragraph &other) { return other.numbers >= paragraph.numbers; };
    };
    std::vector<std::size_t> aside;
    for (auto p = paragraphs.begin(); p != paragraphs.end(); ++p) {
        if (std::none_of(p + 1, paragraphs.end(), hasAsMany(*p)) ||
            aside.size() + p->rows.size() > mostLines ||
            !Preface(table, paragraphs, static_cast<std::size_t>(p - paragraphs.begin())).isStatements())
            break;
        aside.insert(aside.end(), p->rows.begin(), p->rows.end());
    }
    table.setAside(aside);
}

} // namespace palmer
