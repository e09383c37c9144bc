// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/tablebody.h"

#include "document/place.h"
#include "import/filenotes.h"
#include "kernel/words/characters.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

// Above 500 lines: one sorter, whose steps share the counts of the columns.

namespace palmer {

namespace {

constexpr std::size_t widestTable = 100'000; ///< columns

bool isNumeric(const TableCell &cell) {
    return cell.kind == CellKind::number || cell.kind == CellKind::missing ||
           cell.kind == CellKind::grouped || cell.kind == CellKind::broken;
}

/// "X" is a missing reading among numbers, and an axis among axes.
bool isAxisLetter(const CellTable &table, const TableCell &cell) {
    const std::string_view text = table.text(cell);
    return text == "X" || text == "x";
}

std::size_t numberCount(std::span<const TableCell> cells) {
    return static_cast<std::size_t>(std::ranges::count(cells, CellKind::number, &TableCell::kind));
}

/// The row width that contains most of the numbers.
std::size_t widthOf(const CellTable &table) {
    std::map<std::size_t, std::size_t> numbers;
    for (const TableRow &row : table.rows()) {
        if (!row.comment)
            numbers[row.count] += numberCount(table.cells(row));
    }
    std::size_t width = 0;
    std::size_t most = 0;
    for (const auto &[count, sum] : numbers) {
        if (sum >= most && sum > 0) {
            most = sum;
            width = count;
        }
    }
    return width;
}

/// "Approach; ↑; ↓; ↑; ↓": a direction for each column.
bool isRowOfDirections(const CellTable &table, const TableRow &row) {
    constexpr std::ptrdiff_t fewest = 4;
    const auto cells = table.cells(row);
    const auto names = [&](Direction direction) {
        return [&table, direction](const TableCell &cell) {
            return isDirectionCell(table, cell) && directionOf(table.text(cell)) == direction;
        };
    };
    const auto up = std::ranges::count_if(cells, names(Direction::positive));
    const auto down = std::ranges::count_if(cells, names(Direction::negative));
    const auto filled =
        std::ranges::count_if(cells, [](const TableCell &cell) { return cell.kind != CellKind::empty; });
    return !row.comment && up == down && up + down >= fewest && filled <= up + down + 1;
}

/// Numbers of cells in a column by kind.
struct CellCount {
    std::size_t numbers = 0;
    std::size_t directions = 0;
    std::size_t senses = 0;
    std::size_t clocks = 0;
    std::size_t dates = 0;
    std::size_t words = 0;
    std::size_t upward = 0;                                       ///< of the directions
    std::map<std::string, std::size_t, std::less<>> unknown = {}; ///< first distinct words
};

void remember(CellCount &count, std::string_view word) {
    constexpr std::size_t few = 3;
    if (const auto known = count.unknown.find(word); known != count.unknown.end())
        ++known->second;
    else if (count.unknown.size() < few)
        count.unknown.emplace(word, 1);
}

std::size_t CellCount::*countOf(const CellTable &table, const TableCell &cell) {
    if (cell.isNumber() || cell.kind == CellKind::grouped)
        return &CellCount::numbers;
    if (isDirectionCell(table, cell))
        return &CellCount::directions;
    if (isDate(table.text(cell)))
        return &CellCount::dates;
    if (isNumeric(cell) && !(cell.kind == CellKind::missing && isAxisLetter(table, cell)))
        return &CellCount::numbers;
    if (senseIn(table.text(cell)))
        return &CellCount::senses;
    return clockTime(table.text(cell)) ? &CellCount::clocks : &CellCount::words;
}

ColumnKind kindOf(const CellCount &count) {
    const std::size_t others = count.directions + count.senses + count.clocks + count.dates + count.words;
    if (count.numbers > 0 && count.numbers >= others)
        return ColumnKind::numbers;
    if (others == 0)
        return ColumnKind::empty;
    if (2 * count.directions >= others)
        return ColumnKind::directions;
    if (2 * count.senses >= others)
        return ColumnKind::senses;
    // Readings that a spreadsheet turned into dates and times are not a series.
    if (2 * count.clocks >= others && 4 * count.numbers <= count.clocks)
        return ColumnKind::clock;
    return 2 * count.dates >= others && 4 * count.numbers <= count.dates ? ColumnKind::dates
                                                                         : ColumnKind::words;
}

/// True if a line of words heads the column as directions.
bool isCalledDirection(const CellTable &table, std::size_t column) {
    return std::ranges::any_of(table.rows(), [&](const TableRow &row) {
        const auto cells = table.cells(row);
        return !row.comment && cells.size() > column && numberCount(cells) == 0 &&
               readHeading(table.text(cells[column])).meaning == Meaning::direction;
    });
}

using DirectionWords = decltype(TableBody::directionWords);

/// The direction of each of two words: initials of forward and reverse, vorwärts and rückwärts, aller and
/// retour …, or "from +" and "from −"; null if they are none.
DirectionWords pairOf(std::string_view first, std::string_view second) {
    constexpr std::array<std::string_view, 12> pairs{"fr", "fb", "vr", "vz", "hr", "hz",
                                                     "ar", "ai", "iv", "pn", "ud", "md"};
    const std::string initials = folded(first.substr(0, 1)) + folded(second.substr(0, 1));
    const auto isIn = [&](std::string_view pair) { return pair == initials; };
    const auto isReverse = [&](std::string_view pair) {
        return pair[0] == initials[1] && pair[1] == initials[0];
    };
    constexpr std::size_t longest = 2;
    const bool areShort = initials.size() == 2 && std::max(first.size(), second.size()) <= longest;
    const HeadingWords from = readHeading(first);
    std::optional<Direction> direction;
    if (from.comesFrom && readHeading(second).comesFrom && readHeading(second).hint != from.hint)
        direction = from.hint;
    else if (areShort && std::ranges::any_of(pairs, isIn))
        direction = Direction::positive;
    else if (areShort && std::ranges::any_of(pairs, isReverse))
        direction = Direction::negative;
    const auto opposite = !direction                          ? direction
                          : *direction == Direction::positive ? std::optional(Direction::negative)
                                                              : std::optional(Direction::positive);
    return {{std::string(first), direction}, {std::string(second), opposite}};
}

/// Finds unknown words in a column headed as directions: two and nothing else, or a single one in a
/// considerable part of the lines, the others naming one direction.
DirectionWords directionWordsIn(const CellTable &table, std::size_t column, const CellCount &count) {
    constexpr std::size_t part = 4;
    if (count.unknown.empty() || count.unknown.size() > 2 || !isCalledDirection(table, column))
        return {};
    const std::string &word = count.unknown.begin()->first;
    if (count.directions == 0)
        return count.numbers + count.senses > 0 ? DirectionWords()
               : count.unknown.size() == 1      ? DirectionWords{{word, std::nullopt}}
                                                : pairOf(word, count.unknown.rbegin()->first);
    const bool isOneDirection = count.upward == 0 || count.upward == count.directions;
    if (!isOneDirection || count.unknown.size() != 1 ||
        part * count.unknown.begin()->second < count.directions + count.words)
        return {};
    return {{word, count.upward > 0 ? Direction::negative : Direction::positive}};
}

std::vector<TableColumn> columnsOf(const CellTable &table, std::size_t width,
                                   DirectionWords &directionWords) {
    std::vector<CellCount> counts(width);
    for (const TableRow &row : table.rows()) {
        const auto cells = table.cells(row);
        if (row.comment || cells.size() != width || numberCount(cells) == 0)
            continue;
        for (std::size_t c = 0; c < width; ++c) {
            if (cells[c].kind == CellKind::empty)
                continue;
            std::size_t CellCount::*const kind = countOf(table, cells[c]);
            ++(counts[c].*kind);
            if (kind == &CellCount::words)
                remember(counts[c], table.text(cells[c]));
            else if (kind == &CellCount::directions)
                counts[c].upward += directionOf(table.text(cells[c])) == Direction::positive ? 1 : 0;
        }
    }
    std::vector<TableColumn> columns(width);
    for (std::size_t c = 0; c < width; ++c)
        columns[c].kind = kindOf(counts[c]);
    for (std::size_t c = 0; c < width && directionWords.empty(); ++c) {
        if (columns[c].kind == ColumnKind::directions || columns[c].kind == ColumnKind::words)
            directionWords = directionWordsIn(table, c, counts[c]);
        if (!directionWords.empty() && counts[c].directions > 0)
            columns[c].kind = ColumnKind::directions;
    }
    return columns;
}

/// Sorts rows into blocks, headings and notes.
class Sorter {
public:
    Sorter(const CellTable &table, TableBody &body)
        : m_table(table)
        , m_body(body) {
        const auto numbers = body.numberColumns();
        m_firstNumber = numbers.front();
        m_numberColumns = numbers.size();
        m_directions = body.columnOf(ColumnKind::directions);
        m_senses = body.columnOf(ColumnKind::senses);
        m_clock = body.columnOf(ColumnKind::clock);
    }

    void sort() {
        std::vector<bool> areBody;
        areBody.reserve(m_table.rows().size());
        for (const TableRow &row : m_table.rows())
            areBody.push_back(!row.comment && isBodyRow(row));
        const bool gapsCount = gapsSeparate(areBody);
        findForms();
        std::uint32_t lastLine = 0; // of the last row of the table
        std::vector<std::uint32_t> beside;
        for (std::uint32_t i = 0; i < m_table.rows().size(); ++i) {
            const TableRow &row = m_table.rows()[i];
            if (row.beside) {
                beside.push_back(i);
            } else if (m_formHeads.contains(i)) {
                takeFormHead(i);
                lastLine = row.line;
            } else if (isRule(row)) {
                lastLine = row.line;
            } else if (!areBody[i]) {
                if (isDamaged(row))
                    remarkUnread(row);
                else if (takeHead(i, row))
                    lastLine = row.line;
            } else if (hasNumbersBeyond(row) || hasGapAmongBlanks(row)) {
                remarkUnread(row); // "50,1,234.5" cannot be assigned to columns
                lastLine = row.line;
            } else {
                if (gapsCount && row.line > lastLine + 1)
                    finish();
                takeBodyRow(i);
                lastLine = row.line;
            }
        }
        finish();
        m_body.notes = std::move(m_heads); // after the last block
        m_body.notes.insert(m_body.notes.end(), beside.begin(), beside.end());
    }

private:
    /// Ends the current block.
    void finish() {
        if (!m_block.rows.empty())
            m_body.blocks.push_back(std::move(m_block));
        m_block = {};
    }

    /// Takes a row outside the body. False if it is unlike the others and remains unread.
    bool takeHead(std::uint32_t index, const TableRow &row) {
        const bool hasNumbers = !row.comment && isNumericHead(row) && !isComputedRow(m_table, row);
        const bool unread =
            hasNumbers ? !m_block.rows.empty() && !(m_numericHead && sameAsHead(row, *m_numericHead))
                       : !row.comment && looksLikeData(row, !m_body.blocks.empty() || !m_block.rows.empty());
        if (unread) {
            remarkUnread(row);
            return false;
        }
        if (hasNumbers)
            m_numericHead = index;
        else if (isWholeHeading(row))
            m_numericHead.reset(); // what was above belongs to something else
        finish();
        m_heads.push_back(index);
        return true;
    }

    /// Finds the tables of ISO 230-2: targets across, each above the two columns that a line of directions
    /// names; a line that counts the targets may stand above them.
    void findForms() {
        constexpr std::uint32_t mostHeads = 3;
        const auto rows = m_table.rows();
        for (std::uint32_t i = 0; i < rows.size(); ++i) {
            if (!isRowOfDirections(m_table, rows[i]))
                continue;
            std::optional<std::uint32_t> targets;
            std::vector<std::uint32_t> heads{i};
            std::uint32_t above = 0;
            for (std::uint32_t k = i; above < mostHeads && k-- > 0;) {
                if (rows[k].beside)
                    continue;
                if (rows[k].line + ++above != rows[i].line)
                    break;
                const std::vector<double> numbers = numbersAbove(rows[k], rows[i]);
                if (numbers.empty())
                    continue;
                heads.push_back(k);
                if (!targets &&
                    std::ranges::adjacent_find(numbers, std::ranges::greater_equal()) == numbers.end())
                    targets = k;
            }
            if (!targets)
                continue;
            m_formHeads.insert(heads.begin(), heads.end());
            m_targetsOf[i] = *targets;
        }
    }

    /// The numbers of a line that stand above one of each two directions, or above each; empty if others do.
    [[nodiscard]] std::vector<double> numbersAbove(const TableRow &row, const TableRow &directions) const {
        const auto below = m_table.cells(directions);
        const auto cells = m_table.cells(row);
        std::vector<double> numbers;
        std::size_t columns = 0;
        if (areYears(cells))
            return {};
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const bool isAbove = c < below.size() && isDirectionCell(m_table, below[c]);
            columns += isAbove ? 1 : 0;
            if (cells[c].isNumber() && (!isAbove || row.comment))
                return {};
            if (cells[c].isNumber() && (numbers.empty() || numbers.back() != cells[c].value))
                numbers.push_back(cells[c].value);
        }
        return 2 * numbers.size() >= columns ? numbers : std::vector<double>();
    }

    void takeFormHead(std::uint32_t index) {
        finish();
        m_heads.push_back(index);
        if (const auto targets = m_targetsOf.find(index); targets != m_targetsOf.end()) {
            m_numericHead = targets->second;
            m_directionHead = index;
        }
    }

    /// A line that heads its columns as targets and readings.
    [[nodiscard]] bool isWholeHeading(const TableRow &row) const {
        const auto cells = m_table.cells(row);
        const auto callsTargets = [&](const TableCell &cell) {
            const Meaning meaning =
                cell.kind == CellKind::text ? readHeading(m_table.text(cell)).meaning : Meaning::unknown;
            return meaning == Meaning::target || meaning == Meaning::place;
        };
        return !row.comment && wordCount(row) >= m_numberColumns && numberCount(cells) == 0 &&
               std::ranges::any_of(cells, callsTargets);
    }

    void takeBodyRow(std::uint32_t index) {
        if (m_block.rows.empty()) {
            m_block.heads = std::exchange(m_heads, {});
            m_block.numericHead = m_numericHead;
            if (m_numericHead && m_directionHead > m_numericHead)
                m_block.directionHead = m_directionHead;
        }
        m_block.rows.push_back(index);
    }

    [[nodiscard]] bool isBodyRow(const TableRow &row) const {
        const auto cells = m_table.cells(row);
        if (cells.size() <= m_firstNumber || !isNumeric(cells[m_firstNumber]) || isLoneDirection(cells))
            return false;
        if (!cells[m_firstNumber].isNumber() && m_firstNumber > 0 &&
            isDate(m_table.text(cells[m_firstNumber])))
            return false; // "Calibrated; 05.03.2024"
        if (m_numberColumns > 2 && !cells.front().isNumber() && isLabelledValue(m_table, row))
            return false;
        if (m_directions && (cells.size() <= *m_directions || !saysDirection(cells[*m_directions])))
            return false;
        if (m_senses && (cells.size() <= *m_senses || !couldBeSense(cells[*m_senses])))
            return false;
        if (m_clock && (cells.size() <= *m_clock || !clockTime(m_table.text(cells[*m_clock]))))
            return false;
        return isOfNumbers(cells);
    }

    /// False for words among the numbers: a heading that begins with a number, not a row with a remark.
    [[nodiscard]] bool isOfNumbers(std::span<const TableCell> cells) const {
        std::size_t numbers = 0;
        std::size_t words = 0;
        std::size_t remarks = 0; // "beam lost" in place of the reading
        for (std::size_t c = 0; c < std::min(cells.size(), m_body.columns.size()); ++c) {
            if (m_body.columns[c].kind != ColumnKind::numbers || m_body.columns[c].isChosen)
                continue;
            numbers += isNumeric(cells[c]) ? 1 : 0;
            words += cells[c].kind == CellKind::text ? 1 : 0;
            remarks += cells[c].kind == CellKind::text && isRemark(m_table.text(cells[c])) ? 1 : 0;
        }
        const bool isTarget = cells[m_firstNumber].isNumber() && words == remarks;
        return words <= numbers && (m_numberColumns > 2 || words == 0 || words < numbers || isTarget);
    }

    /// Words that head no column.
    [[nodiscard]] static bool isRemark(std::string_view text) {
        const HeadingWords heading = readHeading(text);
        return heading.meaning == Meaning::unknown && heading.unknownWords > 0 && !heading.direction &&
               !heading.hint && !heading.number && !saidUnit(text).isSaid();
    }

    /// True also for an unknown word, which is asked so that its points are not lost; not for a heading.
    [[nodiscard]] bool couldBeSense(const TableCell &cell) const {
        const std::string_view text = m_table.text(cell);
        return senseIn(text) || (cell.kind == CellKind::text && !saidUnit(text).isSaid() &&
                                 readHeading(text).meaning == Meaning::unknown);
    }

    [[nodiscard]] bool saysDirection(const TableCell &cell) const {
        return isDirectionCell(m_table, cell) || m_body.directionWords.contains(m_table.text(cell));
    }

    /// A single "-" among rows of several numbers is the title of a block, not a missing number.
    [[nodiscard]] bool isLoneDirection(std::span<const TableCell> cells) const {
        const auto isFilled = [](const TableCell &cell) { return cell.kind != CellKind::empty; };
        const auto first = std::ranges::find_if(cells, isFilled);
        return m_numberColumns > 1 && std::ranges::count_if(cells, isFilled) == 1 && !first->isNumber() &&
               isDirectionCell(m_table, *first);
    }

    /// "| --- | :---: |" of Markdown, or a line of dashes.
    [[nodiscard]] bool isRule(const TableRow &row) const {
        std::size_t dashes = 0;
        for (const TableCell &cell : m_table.cells(row)) {
            const std::string_view text = m_table.text(cell);
            if (!text.empty() && isDigit(text.front())) // in most rows
                return false;
            if (text.find_first_not_of("-:=_+ ") != std::string_view::npos)
                return false;
            dashes += text.find("--") != std::string_view::npos ? 1 : 0;
        }
        return dashes > 0 && 2 * dashes >= m_table.cells(row).size();
    }

    /// Mostly digits, or beginning with a number: "12O.5", "~97.1", "1.2x5".
    [[nodiscard]] bool isDamagedNumber(std::string_view text, bool alone) const {
        constexpr std::size_t shortest = 3;
        const auto digits = static_cast<std::size_t>(std::ranges::count_if(text, isDigit));
        const bool mostly = text.size() >= shortest && 2 * digits >= text.size();
        const bool begins = leadingNumber(text, m_table.decimalMark.value).size > 0;
        return (alone ? mostly && begins : mostly || begins) && !isDate(text) && !clockTime(text);
    }

    /// Numbers, with damaged ones in place of the others. Neither words nor dates.
    [[nodiscard]] bool isDamaged(const TableRow &row) const {
        if (row.comment || isComputedRow(m_table, row))
            return false;
        std::size_t numbers = 0;
        std::size_t damaged = 0;
        for (const TableCell &cell : m_table.cells(row)) {
            if (cell.isNumber()) {
                ++numbers;
            } else if (cell.kind != CellKind::empty && cell.kind != CellKind::missing) {
                if (!isDamagedNumber(m_table.text(cell), row.count == 1))
                    return false;
                ++damaged;
            }
        }
        if (numbers == 0) // "-68.1x133.6" among rows of two
            return damaged == 1 && row.count == 1 && m_numberColumns == 2 && !m_block.rows.empty();
        return damaged > 0 && 2 * (numbers + damaged) >= m_numberColumns;
    }

    /// A row outside the body with as many numbers: below it, unless it begins with a computed quantity.
    [[nodiscard]] bool looksLikeData(const TableRow &row, bool inBody) const {
        const auto cells = m_table.cells(row);
        const std::size_t numbers = numberCount(cells);
        if (numbers == 0 || !inBody)
            return false;
        if (wordCount(row) == 0)
            return true;
        if (2 * numbers < m_numberColumns || (m_numberColumns <= 2 && numbers < m_numberColumns))
            return false;
        const auto isComputed = [&](const TableCell &cell) {
            const Meaning meaning =
                cell.kind == CellKind::text ? readHeading(m_table.text(cell)).meaning : Meaning::unknown;
            return meaning == Meaning::statistic || meaning == Meaning::other ||
                   meaning == Meaning::temperature;
        };
        return !isComputedRow(m_table, row) && std::ranges::none_of(cells, isComputed);
    }

    /// Numbers to the right of the last column.
    [[nodiscard]] bool hasNumbersBeyond(const TableRow &row) const {
        const auto cells = m_table.cells(row);
        return cells.size() > m_body.columns.size() && numberCount(cells.subspan(m_body.columns.size())) > 0;
    }

    /// Fewer numbers than columns, separated only by blanks.
    [[nodiscard]] bool hasGapAmongBlanks(const TableRow &row) const {
        return m_table.delimiter.value == Delimiter::blanks && row.count < m_body.columns.size() &&
               std::any_of(m_body.columns.begin() + row.count, m_body.columns.end(),
                           std::mem_fn(&TableColumn::isNumeric));
    }

    /// A row like those of the body, but with a word or nothing in place of their first number.
    [[nodiscard]] bool isNumericHead(const TableRow &row) const {
        auto cells = trimmed(m_table.cells(row));
        while (!cells.empty() && cells.front().kind == CellKind::empty) // a bar of Markdown, a margin
            cells = cells.subspan(1);
        const std::size_t numbers = numberCount(cells);
        return numbers >= 2 && 2 * numbers >= m_numberColumns && wordCount(row) <= 2 &&
               numbers + 2 >= cells.size() && !areYears(cells);
    }

    /// ";2024;;2025;" above column headings.
    [[nodiscard]] static bool areYears(std::span<const TableCell> cells) {
        constexpr std::size_t few = 4; // there are more targets
        return numberCount(cells) <= few && std::ranges::all_of(cells, [](const TableCell &cell) {
                   return cell.kind != CellKind::number || isYear(cell.value);
               });
    }

    [[nodiscard]] std::size_t wordCount(const TableRow &row) const {
        return static_cast<std::size_t>(
            std::ranges::count(m_table.cells(row), CellKind::text, &TableCell::kind));
    }

    [[nodiscard]] bool sameAsHead(const TableRow &row, std::uint32_t head) const {
        const auto a = m_table.cells(row);
        const auto b = m_table.cells(m_table.rows()[head]);
        return std::ranges::equal(a, b, {}, &TableCell::value, &TableCell::value);
    }

    void remarkUnread(const TableRow &row) { m_body.remarks.unlike(row.line); }

    /// Empty lines separate blocks unless they are everywhere.
    [[nodiscard]] bool gapsSeparate(const std::vector<bool> &areBody) const {
        std::size_t gaps = 0;
        std::size_t rows = 0;
        std::uint32_t last = 0;
        for (std::size_t i = 0; i < areBody.size(); ++i) {
            const TableRow &row = m_table.rows()[i];
            if (!areBody[i])
                continue;
            gaps += rows > 0 && row.line > last + 1 ? 1 : 0;
            ++rows;
            last = row.line;
        }
        return 3 * gaps < rows;
    }

    const CellTable &m_table;
    TableBody &m_body;
    TableBlock m_block;                 ///< current block
    std::vector<std::uint32_t> m_heads; ///< for the next block
    std::optional<std::uint32_t> m_numericHead;
    std::optional<std::uint32_t> m_directionHead;
    std::set<std::uint32_t> m_formHeads;
    std::map<std::uint32_t, std::uint32_t> m_targetsOf; ///< lines of targets by that of the directions
    std::size_t m_firstNumber = 0;
    std::size_t m_numberColumns = 0;
    std::optional<std::size_t> m_directions;
    std::optional<std::size_t> m_senses;
    std::optional<std::size_t> m_clock;
};

} // namespace

bool isDirectionCell(const CellTable &table, const TableCell &cell) {
    return (cell.kind == CellKind::text || cell.kind == CellKind::missing || cell.kind == CellKind::broken) &&
           directionOf(table.text(cell)).has_value();
}

std::size_t TableBody::rowCount() const {
    std::size_t rows = 0;
    for (const TableBlock &block : blocks)
        rows += block.rows.size();
    return rows;
}

TableBody bodyOf(const CellTable &table, const std::vector<std::size_t> &ofNumbers) {
    TableBody body;
    const std::size_t width = widthOf(table);
    if (width == 0)
        refuseWithoutNumbers();
    if (width > widestTable)
        refuseTableSize();
    body.columns = columnsOf(table, width, body.directionWords);
    for (const std::size_t c : ofNumbers) {
        if (c < width && body.columns[c].kind != ColumnKind::numbers &&
            body.columns[c].kind != ColumnKind::empty) {
            body.columns[c].kind = ColumnKind::numbers;
            body.columns[c].isChosen = true;
        }
    }
    if (body.numberColumns().empty())
        refuseWithoutNumbers();
    Sorter(table, body).sort();
    if (body.blocks.empty())
        refuseWithoutNumbers();
    findSections(table, body);
    for (const TableBlock &block : body.blocks)
        body.lastRows.push_back(block.rows.back());
    for (const TableBlock &block : body.blocks)
        body.notes.insert(body.notes.end(), block.heads.begin(), block.heads.end());
    std::erase_if(body.notes,
                  [&](std::uint32_t index) { return std::ranges::binary_search(body.columnHeads, index); });
    std::ranges::sort(body.notes);
    return body;
}

} // namespace palmer
