// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/cellunits.h"
#include "tables/table.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace palmer {

/// Finds the unit of each column and converts its cells to numbers.
class UnitTaker {
public:
    explicit UnitTaker(CellTable &table)
        : m_table(table)
        , m_mark(table.decimalMark.value) {}

    void take() {
        for (std::uint32_t i = 0; i < m_table.m_rows.size(); ++i)
            count(i);
        if (!m_rows.empty())
            findRow();
        resolveColumns();
        for (const std::uint32_t row : m_rows)
            convert(row);
    }

private:
    struct Count {
        std::map<const Unit *, std::size_t> units; ///< including those of the first row
        std::size_t said = 0;
        std::size_t bare = 0;
        std::uint32_t bareLine = 0;
    };

    [[nodiscard]] std::span<TableCell> cellsOf(std::uint32_t row) {
        const TableRow &found = m_table.m_rows[row];
        return std::span(m_table.m_cells).subspan(found.first, found.count);
    }

    [[nodiscard]] std::optional<CellWithUnit> said(const TableCell &cell) const {
        return cell.kind == CellKind::text ? cellWithUnit(m_table.text(cell), m_mark) : std::nullopt;
    }

    /// True for a row of numbers, some with units, not a label with its value.
    [[nodiscard]] bool isOfNumbers(std::uint32_t row) {
        std::size_t withUnit = 0;
        std::size_t numbers = 0;
        std::size_t words = 0;
        bool beginsWithWord = false;
        for (const TableCell &cell : cellsOf(row)) {
            const bool isWord = cell.kind == CellKind::text && !said(cell);
            withUnit += cell.kind == CellKind::text && !isWord ? 1 : 0;
            beginsWithWord |= isWord && numbers + words == 0;
            words += isWord ? 1 : 0;
            numbers += !isWord && cell.kind != CellKind::empty ? 1 : 0;
        }
        return withUnit > 0 && (beginsWithWord ? numbers > words : numbers >= words);
    }

    void count(std::uint32_t row) {
        if (m_table.m_rows[row].comment || !isOfNumbers(row))
            return;
        m_rows.push_back(row);
        const auto cells = cellsOf(row);
        if (m_counts.size() < cells.size())
            m_counts.resize(cells.size());
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (const auto read = said(cells[c])) {
                ++m_counts[c].units[read->unit];
                ++m_counts[c].said;
            } else if (cells[c].isNumber() && cells[c].value != 0) {
                m_counts[c].bareLine =
                    m_counts[c].bare++ == 0 ? m_table.m_rows[row].line : m_counts[c].bareLine;
            }
        }
    }

    /// Targets across: the first row has one unit, which does not recur in its columns.
    void findRow() {
        const std::uint32_t row = m_rows.front();
        const auto cells = cellsOf(row);
        std::set<const Unit *> units;
        std::vector<double> values;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const auto read = said(cells[c]);
            if (cells[c].isNumber() || (read && m_counts[c].units[read->unit] > 1))
                return;
            if (read) {
                units.insert(read->unit);
                values.push_back(read->value);
            }
        }
        if (units.size() != 1 || values.size() < 2)
            return;
        // "1°; 2°; 3°" are the first, second and third run.
        bool countsOn = *units.begin() == unitOf("deg");
        for (std::size_t i = 0; i < values.size(); ++i)
            countsOn = countsOn && values[i] == static_cast<double>(i + 1);
        if (countsOn)
            return;
        m_table.m_rowUnit = {row, *units.begin()};
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (const auto read = said(cells[c])) {
                --m_counts[c].said;
                m_counts[c].units.erase(read->unit);
                set(cells[c], read->value);
            }
        }
        m_rows.erase(m_rows.begin());
    }

    /// The finest of lengths that differ by powers of ten, degrees for angles in several units; null if none.
    [[nodiscard]] static const Unit *commonUnit(const std::map<const Unit *, std::size_t> &units) {
        if (units.size() == 1)
            return units.begin()->first;
        const auto isPart = [](const auto &each) {
            return each.first->kind == UnitKind::angle && each.first->multiplier == 1;
        };
        if (std::ranges::all_of(units, isPart))
            return unitOf("deg");
        const Unit *finest = units.begin()->first;
        for (const auto &[unit, times] : units)
            finest = unit->multiplier / unit->divisor < finest->multiplier / finest->divisor ? unit : finest;
        const auto isOfSame = [&](const auto &each) {
            return each.first->kind == finest->kind &&
                   numberIn(*finest, "1 " + std::string(each.first->sign), DecimalMark::point).has_value();
        };
        return std::ranges::all_of(units, isOfSame) ? finest : nullptr;
    }

    void resolveColumns() {
        m_table.m_units.resize(m_counts.size());
        for (std::size_t c = 0; c < m_counts.size(); ++c) {
            const Count &column = m_counts[c];
            if (column.said >= 2 && column.said > column.bare)
                m_table.m_units[c] = {commonUnit(column.units), column.bareLine};
        }
    }

    void convert(std::uint32_t row) {
        const auto cells = cellsOf(row);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const Unit *unit = m_table.unitOfColumn(c).unit;
            if (!unit || cells[c].kind != CellKind::text)
                continue;
            if (const auto number = numberIn(*unit, m_table.text(cells[c]), m_mark))
                set(cells[c], *number);
        }
    }

    static void set(TableCell &cell, double value) {
        cell.kind = CellKind::number;
        cell.value = value;
    }

    CellTable &m_table;
    DecimalMark m_mark;
    std::vector<std::uint32_t> m_rows; ///< rows of numbers with units
    std::vector<Count> m_counts;
};

namespace {

/// "Target 100 mm": a word, a number, and its unit if any.
struct NumberedWord {
    std::string_view word;
    double number = 0;
    const Unit *unit = nullptr;
};

std::optional<NumberedWord> numberedWord(std::string_view text, DecimalMark mark) {
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == std::string_view::npos || digit == 0)
        return {};
    const std::size_t begin = text.find_last_of(" :=", digit);
    if (begin == std::string_view::npos)
        return {};
    const std::string_view rest = withoutBlanks(text.substr(begin + 1));
    const std::string_view word = withoutBlanks(text.substr(0, text.find_last_not_of(" :=", begin) + 1));
    if (const LeadingNumber number = leadingNumber(rest, mark); number.size == rest.size())
        return NumberedWord{word, number.value};
    const auto read = cellWithUnit(rest, mark);
    return read ? std::optional(NumberedWord{word, read->value, read->unit}) : std::nullopt;
}

/// True for 1, 2, 3, which count.
bool areCounted(const std::vector<double> &numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != static_cast<double>(i + 1))
            return false;
    }
    return true;
}

} // namespace

void CellTable::takeNumbersBehind(bool (*isOfTargets)(std::string_view word)) {
    constexpr std::size_t mostRows = 100;
    constexpr std::size_t fewest = 3;
    for (std::uint32_t i = 0; i < std::min(m_rows.size(), mostRows); ++i) {
        const auto cells = std::span(m_cells).subspan(m_rows[i].first, m_rows[i].count);
        if (m_rows[i].comment || std::ranges::any_of(cells, &TableCell::isNumber))
            continue;
        std::vector<std::pair<TableCell *, NumberedWord>> found;
        std::vector<double> numbers;
        for (TableCell &cell : cells) {
            const auto said =
                cell.kind == CellKind::text ? numberedWord(text(cell), decimalMark.value) : std::nullopt;
            if (!said || !isOfTargets(said->word))
                continue;
            found.emplace_back(&cell, *said);
            numbers.push_back(said->number);
        }
        const auto isOther = [&](const auto &each) {
            return each.second.word != found.front().second.word ||
                   each.second.unit != found.front().second.unit;
        };
        const bool isAscending =
            std::ranges::adjacent_find(numbers, std::ranges::greater_equal()) == numbers.end();
        const bool isDescending =
            std::ranges::adjacent_find(numbers, std::ranges::less_equal()) == numbers.end();
        if (found.size() < fewest || std::ranges::any_of(found, isOther) || areCounted(numbers) ||
            !(isAscending || isDescending))
            continue;
        if (found.front().second.unit)
            m_rowUnit = {i, found.front().second.unit};
        for (auto &[cell, said] : found) {
            cell->kind = CellKind::number;
            cell->value = said.number;
        }
        return;
    }
}

void CellTable::takeUnits() {
    if (!std::exchange(m_saysUnits, false))
        return;
    UnitTaker(*this).take();
    /// True for a cell that displays another unit than the heading above it.
    const auto deniesHeading = [this](std::uint32_t index) {
        const auto below = std::ranges::upper_bound(m_rows, index, {}, &TableRow::first);
        const std::size_t column = index - std::prev(below)->first;
        constexpr std::ptrdiff_t mostHeads = 100;
        for (auto row = m_rows.begin(); row != below && row - m_rows.begin() < mostHeads; ++row) {
            const auto cells = this->cells(*row);
            const Unit *unit = column < cells.size() && cells[column].kind == CellKind::text
                                   ? unitIn(text(cells[column]))
                                   : nullptr;
            if (unit && row + 1 != below)
                return unit->kind != UnitKind::time && unit != unitIn(text(m_cells[index]));
        }
        return false;
    };
    // A unit that few cells of a column display is none of the column.
    for (const auto &[index, number] : std::exchange(m_formatted, {})) {
        TableCell &cell = m_cells[index];
        if (cell.kind == CellKind::text && !deniesHeading(index)) {
            cell.kind = CellKind::number;
            cell.value = number;
        }
    }
}

} // namespace palmer
