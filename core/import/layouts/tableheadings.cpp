// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/tablebody.h"

#include "document/place.h"
#include "import/filenotes.h"
#include "import/layouts/sections.h"
#include "kernel/words/characters.h"
#include "tables/folded.h"

#include <algorithm>
#include <cmath>

// Above 500 lines: one search, whose steps share the rows that were taken for headings.

namespace palmer {

namespace {

constexpr std::size_t headingRows = 5;

/// True for "Forward", "Rev", "Run 2": headings above several columns.
bool namesRuns(const HeadingWords &heading) {
    return heading.direction || (heading.unknownWords == 0 &&
                                 (heading.hint || (heading.meaning == Meaning::run && heading.number)));
}

/// A line with a single text between headings and body: "* door opened". It does not hide the heading.
bool isLoneText(const CellTable &table, const TableRow &row) {
    const auto cells = trimmed(table.cells(row));
    return cells.size() == 1 && cells.front().kind == CellKind::text;
}

/// "Runs 1, 3: backward": speaks of several columns, whatever it is above.
bool isOfSeveralRuns(std::string_view text) {
    const std::string_view label = text.substr(0, text.find(':'));
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < label.size(); ++i)
        numbers += isDigit(label[i]) && (i == 0 || !isDigit(label[i - 1])) ? 1 : 0;
    return numbers > 1 && label.size() + 1 < text.size();
}

bool saysUnit(std::string_view text) {
    return saidUnit(text).isSaid();
}

/// "Reading (Zg)": an unknown word in brackets at the end is an unknown unit.
std::string wordInBrackets(std::string_view heading) {
    constexpr std::size_t longest = 8;
    const std::size_t open = heading.find_last_of("([");
    if (open == std::string_view::npos || open == 0 || heading.find_last_of(")]") != heading.size() - 1)
        return {};
    const std::string_view inside = withoutBlanks(heading.substr(open + 1, heading.size() - open - 2));
    const bool isWord =
        inside.size() > 1 && inside.size() <= longest &&
        std::ranges::none_of(inside, [](char c) { return isDigit(c) || c == ' ' || c == ','; });
    return isWord && readHeading(inside).unknownWords == 1 && !senseIn(inside) ? std::string(inside)
                                                                               : std::string();
}

/// Some are units only in brackets: "m", "V", a quotation mark.
bool isUnitInBrackets(std::string_view text) {
    return !saysUnit(text) && saysUnit('(' + std::string(text) + ')');
}

/// A unit and nothing else.
bool isBareUnit(std::string_view text) {
    const HeadingWords heading = readHeading(text);
    return saysUnit(text) && heading.meaning == Meaning::unknown && !heading.direction && !heading.hint &&
           !heading.number && heading.unknownWords == 0 && heading.words <= 1;
}

/// "div" below a heading, where the word beside it is a unit.
bool couldBeUnit(std::string_view text) {
    return !wordInBrackets("of (" + std::string(text) + ')').empty();
}

bool isUnitOrEmpty(const CellTable &table, const TableCell &cell) {
    const std::string_view text = table.text(cell);
    return cell.kind == CellKind::empty || isUnitInBrackets(text) || isBareUnit(text);
}

/// True for a heading row of units, in which a dash means none. "in;div;div": a word that is a unit in such a
/// row alone, above words that are nothing else.
bool isRowOfUnits(const CellTable &table, std::span<const TableCell> cells) {
    const auto isUnit = [&](const TableCell &cell) { return isBareUnit(table.text(cell)); };
    if (std::ranges::any_of(cells, isUnit))
        return true;
    const auto isUnitHere = [&](const TableCell &cell) { return isUnitInBrackets(table.text(cell)); };
    while (!cells.empty() && cells.front().kind == CellKind::empty) // the bar of Markdown, a counter
        cells = cells.subspan(1);
    return cells.size() > 1 && isUnitHere(cells.front()) &&
           std::ranges::all_of(cells.subspan(1), [&](const TableCell &cell) {
               return cell.kind == CellKind::empty || isUnitHere(cell) || couldBeUnit(table.text(cell));
           });
}

/// True for a line of fewer cells than columns where blanks part them, so that it does not say which are
/// empty.
bool isShiftedLeft(const CellTable &table, std::size_t cells, std::size_t width) {
    return table.delimiter.value == Delimiter::blanks && !table.isPlaced && cells < width;
}

/// "[mm];;;[µm]": the units of columns, of which some have none.
bool isRowOfUnitsAlone(const CellTable &table, const TableRow &row, std::size_t width) {
    const auto cells = trimmed(table.cells(row));
    return !row.comment && cells.size() > 1 && 2 * cells.size() >= width &&
           !isShiftedLeft(table, cells.size(), width) && isRowOfUnits(table, cells) &&
           std::ranges::all_of(cells, [&](const TableCell &cell) { return isUnitOrEmpty(table, cell); });
}

/// True if a row above the body describes its columns.
bool isHeading(const CellTable &table, const TableRow &row, std::size_t width) {
    if (isRowOfUnitsAlone(table, row, width))
        return true;
    if (row.comment || isComputedRow(table, row) || isRowOfStatements(table, row))
        return false;
    const auto cells = trimmed(table.cells(row));
    std::size_t filled = 0;
    std::size_t words = 0;
    std::size_t directions = 0;
    for (const TableCell &cell : cells) {
        filled += cell.kind != CellKind::empty ? 1 : 0;
        const std::string_view text = table.text(cell);
        const bool namesRun =
            !text.empty() && !isOfSeveralRuns(text) && (namesRuns(readHeading(text)) || senseIn(text));
        words += cell.kind == CellKind::text || (cell.kind == CellKind::missing && namesRun) ? 1 : 0; // "-"
        directions += namesRun ? 1 : 0;
    }
    if (directions >= 2 && words >= 2)
        return true;
    // Texts beyond the numbers are headings of empty columns, or prose split into cells.
    const auto isUnderstood = [&](const TableCell &cell) {
        return readHeading(table.text(cell)).unknownWords == 0;
    };
    if (filled == 0 || (cells.size() > width + 1 && !std::ranges::all_of(cells, isUnderstood)))
        return false;
    const bool isTitle = filled == 1 && width > 1 && cells.front().kind != CellKind::empty;
    return !isTitle && 2 * filled >= width && (words > 0 || directions > 0) && (width <= 2 || filled > 1);
}

bool saysYear(const TableCell &cell) {
    return cell.kind == CellKind::number && isYear(cell.value);
}

/// The first column that holds anything: the bars of Markdown leave none before them.
std::size_t firstColumn(const std::vector<TableColumn> &columns) {
    const auto found = std::ranges::find_if(
        columns, [](const TableColumn &column) { return column.kind != ColumnKind::empty; });
    return static_cast<std::size_t>(found - columns.begin());
}

/// ";Linear;;Pitch;", ";2024;;2025;", "X;X;Y;Y": headings above several columns each, not label and value.
bool isGroupRow(const CellTable &table, const TableRow &row, std::size_t width, std::size_t first) {
    const auto cells = trimmed(table.cells(row));
    if (row.comment || cells.empty() || cells.size() > width || width < 3)
        return false;
    std::size_t filled = 0;
    std::size_t gaps = 0;
    std::size_t repeated = 0;
    for (std::size_t c = first; c < cells.size(); ++c) {
        if (cells[c].kind == CellKind::empty) {
            ++gaps;
            continue;
        }
        const std::string_view text = table.text(cells[c]);
        const bool isLetter = cells[c].kind == CellKind::missing && folded(text) == "x"; // not missing
        if ((cells[c].kind != CellKind::text && !saysYear(cells[c]) && !isLetter) || text.ends_with(':'))
            return false;
        repeated +=
            c > first && cells[c - 1].kind != CellKind::empty && table.text(cells[c - 1]) == text ? 1 : 0;
        ++filled;
    }
    const bool beginsBehindTargets = first < cells.size() && cells[first].kind == CellKind::empty;
    // "; Exported by …": a remark marked by what separates the columns.
    if (beginsBehindTargets && filled == 1 && row.count < width &&
        readHeading(table.text(cells.back())).unknownWords > 0)
        return false;
    return beginsBehindTargets ? filled > 0 : filled > 1 && filled < width && (gaps > 0 || repeated > 0);
}

/// True if a row above headings of every column adds to them: groups, directions, axes, not label and value.
bool addsToHeadings(const CellTable &table, const TableRow &row) {
    const auto cells = table.cells(row);
    if (std::ranges::count(cells, CellKind::number, &TableCell::kind) == 1 &&
        std::ranges::none_of(cells, saysYear))
        return false; // "Number of runs; 5"
    std::size_t known = 0;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.kind == CellKind::empty || cell.kind == CellKind::number)
            continue;
        const std::string_view text = table.text(cell);
        const HeadingWords heading = readHeading(text);
        if (text.ends_with(':') || (heading.unknownWords > 0 && !senseIn(text)))
            return false;
        ++known;
    }
    return known > 1 || (known == 1 && trimmed(table.cells(row)).size() > 1);
}

/// "# angle; x; y": takes as many words as there are columns; false if there are others.
bool takeFromComment(const CellTable &table, const TableRow &row, std::vector<TableColumn> &columns) {
    std::string text(table.text(table.cells(row).front()));
    const auto takeParted = [&](Delimiter delimiter) {
        const CellTable line = readTable(text, {delimiter, table.decimalMark.value});
        if (line.rows().empty() || columns.size() < 2)
            return false;
        const auto cells = line.cells(line.rows().front());
        // "#;Target;…": the mark is the heading of a counter.
        const std::size_t first = cells.size() > 1 && cells.size() + 1 == columns.size() ? 1 : 0;
        for (std::size_t c = 0; c < cells.size() && cells.size() + first == columns.size(); ++c)
            columns[c + first].heading = line.text(cells[c]);
        return cells.size() + first == columns.size() &&
               std::ranges::none_of(cells, &TableCell::isNumber); // "# Air 20.1 20.3"
    };
    if (takeParted(table.delimiter.value))
        return true;
    if (table.delimiter.value != Delimiter::blanks)
        return false;
    // "# Nom X   Act X": headings of several words.
    for (std::size_t at = text.find("  "); at != std::string::npos; at = text.find("  ", at + 1))
        text.replace(at, std::min(text.find_first_not_of(' ', at), text.size()) - at, "\t");
    return takeParted(Delimiter::tab);
}

/// "Name; X position; Y position" above "Unit; mm; mm": properties of each column, as written by
/// oscilloscopes of controls. False if no line names the columns and none their units.
bool takeFromProperties(const CellTable &table, const TableBlock &block, std::vector<TableColumn> &columns) {
    const auto rowCalled = [&](std::string_view labels) -> const TableRow * {
        for (const std::uint32_t head : block.heads) {
            const TableRow &row = table.rows()[head];
            const auto cells = trimmed(table.cells(row));
            const std::string label =
                '|' + (cells.empty() ? std::string() : folded(table.text(cells.front()))) + '|';
            if (cells.size() > 1 && cells.size() == columns.size() &&
                labels.find(label) != std::string_view::npos)
                return &row;
        }
        return nullptr;
    };
    const TableRow *names = rowCalled("|name|names|signal|channel|kanal|nom|nome|nombre|");
    const TableRow *units = rowCalled("|unit|units|einheit|unite|unita|unidad|");
    if (!names || !units)
        return false;
    columns.front().heading = "time"; // of the samples
    for (std::size_t c = 1; c < columns.size(); ++c)
        columns[c].heading = std::string(table.text(table.cells(*names)[c])) + " (" +
                             std::string(table.text(table.cells(*units)[c])) + ')';
    return true;
}

/// The rows directly above a block that are its column headings, from top to bottom.
struct HeadingRows {
    std::vector<std::uint32_t> rows;
    std::optional<std::uint32_t> looseUnits; ///< a row of units that cannot be assigned to columns
};

/// "mm;µm" between the headings of more columns and the numbers.
bool isShortRowOfUnits(const CellTable &table, const TableRow &row, std::size_t width) {
    const auto cells = trimmed(table.cells(row));
    if (row.comment || cells.empty() ||
        (2 * cells.size() >= width && !isShiftedLeft(table, cells.size(), width)))
        return false;
    return std::ranges::all_of(cells, [&](const TableCell &cell) { return isUnitOrEmpty(table, cell); });
}

/// A row between headings and numbers that hides no heading: a title, units, a label with its value.
bool isPassedOver(const CellTable &table, const TableRow &row, std::size_t width) {
    if (isRowOfUnitsAlone(table, row, width))
        return false;
    return isShortRowOfUnits(table, row, width) || isRowOfStatements(table, row) ||
           (!isHeading(table, row, width) && isLabelledValue(table, row));
}

/// True if a row heads every column, or two of them as readings or targets.
bool headsColumns(const CellTable &table, const TableRow &row, std::size_t width) {
    const auto cells = trimmed(table.cells(row));
    const auto isFilled = [](const TableCell &cell) { return cell.kind != CellKind::empty; };
    return (cells.size() >= width && std::ranges::all_of(cells, isFilled)) ||
           std::ranges::count_if(cells,
                                 [&](const TableCell &cell) { return tellsReadings(table.text(cell)); }) >= 2;
}

/// True if the first column has the targets and those behind it no directions or numbers of runs, so that
/// this many units from the left on are in their columns.
bool beginsWithTargets(const CellTable &table, const TableRow &row, std::size_t units) {
    const auto cells = table.cells(row);
    const auto hasNoUnit = [&](const TableCell &cell) {
        const HeadingWords words = readHeading(table.text(cell));
        return !words.direction && !words.number &&
               isOneOf(words.meaning, {Meaning::direction, Meaning::run, Meaning::index});
    };
    return !cells.empty() && std::ranges::none_of(cells.first(std::min(units, cells.size())), hasNoUnit) &&
           isOneOf(readHeading(table.text(cells.front())).meaning,
                   {Meaning::target, Meaning::place, Meaning::angle, Meaning::time});
}

class HeadingSearch {
public:
    HeadingSearch(const CellTable &table, const TableBlock &block, const std::vector<TableColumn> &all)
        : m_table(table)
        , m_block(block)
        , m_columns(all) {
        std::size_t width = 0; // of this block, which may be narrower than the file's widest
        for (const std::uint32_t row : block.rows)
            width = std::max<std::size_t>(width, table.rows()[row].count);
        m_width = std::min(width, all.size());
    }

    HeadingRows find() {
        for (auto at = m_block.heads.rbegin();
             at != m_block.heads.rend() && m_found.rows.size() < headingRows; ++at) {
            if (m_found.rows.empty() && passes(*at))
                continue;
            if (!take(*at))
                break;
        }
        std::ranges::reverse(m_found.rows);
        return std::move(m_found);
    }

private:
    [[nodiscard]] const TableRow &row(std::uint32_t index) const { return m_table.rows()[index]; }

    /// Passes over a row directly above the numbers that is none of their headings.
    bool passes(std::uint32_t index) {
        if (m_block.numericHead == index)
            return false;
        const TableRow &head = row(index);
        if (!head.comment && isPassedOver(m_table, head, m_width)) {
            if (!m_units && isShortRowOfUnits(m_table, head, m_width))
                m_units = index;
            m_hasPassed = true;
            return true;
        }
        // The title of the block.
        return head.comment || isComputedRow(m_table, head) || (m_width > 2 && isLoneText(m_table, head));
    }

    bool take(std::uint32_t index) {
        const TableRow &head = row(index);
        // Run numbers are below what they number: "Forward;;Reverse;" above "1;2;1;2".
        const bool isGroup =
            !m_found.rows.empty() && isGroupRow(m_table, head, m_width, firstColumn(m_columns));
        const bool isNumeric = m_block.numericHead == index;
        if (!isNumeric && !isGroup && !isHeading(m_table, head, m_width))
            return false;
        if (m_hasPassed && m_found.rows.empty() && !isNumeric && !headsColumns(m_table, head, m_width))
            return false;
        const auto cells = m_table.cells(head);
        const auto empty = std::ranges::count(cells, CellKind::empty, &TableCell::kind);
        const bool isStatement =
            (std::ssize(cells) == empty + 2 && isLabelledValue(m_table, head)) || // "Unit;nm"
            isRowOfStatements(m_table, head);
        if (m_isComplete && (isStatement || (!isGroup && !addsToHeadings(m_table, head))))
            return false;
        m_isComplete |=
            !isNumeric && cells.size() >= m_width && !isRowOfUnits(m_table, cells) &&
            std::ranges::all_of(cells.first(m_width).subspan(std::min(firstColumn(m_columns), m_width)),
                                [](const TableCell &cell) { return cell.kind != CellKind::empty; });
        if (m_units && m_found.rows.empty())
            takeUnits(head);
        m_found.rows.push_back(index);
        return true;
    }

    void takeUnits(const TableRow &heading) {
        if (beginsWithTargets(m_table, heading, trimmed(m_table.cells(row(*m_units))).size()))
            m_found.rows.push_back(*m_units);
        else
            m_found.looseUnits = m_units;
    }

    const CellTable &m_table;
    const TableBlock &m_block;
    const std::vector<TableColumn> &m_columns;
    std::size_t m_width = 0;
    HeadingRows m_found;
    std::optional<std::uint32_t> m_units; ///< a short row of units
    bool m_hasPassed = false;
    bool m_isComplete = false;
};

void addWords(std::string &heading, std::string_view words) {
    if (words.empty())
        return;
    std::string plain(words);
    for (const auto &[wide, narrow] : {std::pair("（", '('), std::pair("）", ')')}) {
        constexpr std::size_t size = 3; // bytes of the full-width forms
        for (std::size_t at = plain.find(wide); at != std::string::npos; at = plain.find(wide))
            plain.replace(at, size, 1, narrow);
    }
    heading += (heading.empty() ? "" : " ") + plain;
}

/// A cell of a heading; in a row of units a unit in brackets.
std::string headingOf(std::string_view text, bool hasUnits, bool isBelow) {
    const bool isUnit =
        hasUnits && (isUnitInBrackets(text) || (isBelow && !saysUnit(text) && couldBeUnit(text)));
    return isUnit ? '(' + std::string(text) + ')' : std::string(text);
}

/// Joins the heading rows downwards.
void composeHeadings(const CellTable &table, const std::vector<std::uint32_t> &rows,
                     std::vector<TableColumn> &columns) {
    for (const std::uint32_t index : rows) {
        const auto cells = trimmed(table.cells(table.rows()[index]));
        // "Forward;;;Reverse": a heading over several columns; workbooks omit the last cells.
        const auto filled = cells.size() - static_cast<std::size_t>(
                                               std::ranges::count(cells, CellKind::empty, &TableCell::kind));
        const bool spans = filled + 1 < columns.size() && index != rows.back();
        const bool hasUnits = isRowOfUnits(table, cells);
        const bool isBelow = index != rows.front();
        const bool isGroup = index != rows.back() &&
                             isGroupRow(table, table.rows()[index], columns.size(), firstColumn(columns));
        std::string_view last;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            std::string_view text = c < cells.size() ? table.text(cells[c]) : std::string_view();
            if (hasUnits && folded(text) == "-")
                continue;
            if (!text.empty())
                last = text;
            else if ((spans || isGroup) && c > 0)
                text = last;
            if (isGroup)
                addWords(columns[c].group, text);
            addWords(columns[c].heading, headingOf(text, hasUnits, isBelow));
            if (!hasUnits)
                columns[c].own = text;
        }
    }
}

/// "Forward;;;Reverse;;" in the last heading row: merged cells. Each that names a run applies to the columns
/// of numbers after it, if each has the same number of them.
void spreadHeadings(std::vector<TableColumn> &columns) {
    std::vector<std::size_t> named;
    std::vector<std::size_t> behind;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const TableColumn &column = columns[c];
        const HeadingWords words = readHeading(column.heading);
        if (!column.heading.empty() && (namesRuns(words) || words.namesSense) && !words.number) {
            named.push_back(c);
            behind.push_back(0);
        } else if (column.heading.empty() && column.kind == ColumnKind::numbers && !named.empty() &&
                   named.back() + behind.back() + 1 == c) {
            ++behind.back();
        }
    }
    if (named.size() < 2 || behind.front() == 0 ||
        std::ranges::any_of(behind, [&](std::size_t count) { return count != behind.front(); }))
        return;
    for (const std::size_t first : named) {
        for (std::size_t c = first + 1; c <= first + behind.front(); ++c) {
            columns[c].heading = columns[first].heading;
            columns[c].isSpread = true;
        }
    }
}

/// Units in cells take precedence over the heading, but both must be checked.
void takeUnitOfCells(const CellTable &table, std::size_t c, TableColumn &column, Remarks &remarks) {
    const ColumnUnit cells = table.unitOfColumn(c);
    if (!cells.unit)
        return;
    const bool isTarget = column.meaning == Meaning::target || column.meaning == Meaning::place;
    const char *choice = isTarget ? "positionUnit" : "unit";
    if ((column.unit && column.unit != cells.unit) || !column.foreignUnit.empty())
        remarks.assumption(choice,
                           REPORT_TEXT("report", "Unit: the heading “%1” names another unit than the cells "
                                                 "of its column; read in %2, as the cells say."),
                           excerpt(column.heading), std::string(cells.unit->sign));
    if (cells.bareLine > 0)
        remarks.assumption({choice, cells.bareLine},
                           REPORT_TEXT("report", "Unit: a number has none, "
                                                 "where the others of its column have one; read in %1."),
                           std::string(cells.unit->sign));
    column.unit = cells.unit;
    column.foreignUnit.clear();
}

/// The heading without the part above several columns.
std::string_view ownHeading(const TableColumn &column) {
    return std::string_view(column.heading).substr(std::min(column.group.size(), column.heading.size()));
}

/// A group of unknown words does not hide the headings below it, but is a kind of its own.
void takeGroup(TableColumn &column) {
    const HeadingWords group = readHeading(column.group);
    const bool isUnderstood = group.unknownWords == 0 && !isYear(group.number.value_or(0));
    if (column.group.empty() || isUnderstood)
        return;
    HeadingWords words = readHeading(ownHeading(column));
    words.group = folded(withoutUnit(column.group));
    if (words.meaning == Meaning::unknown)
        words.meaning = group.meaning;
    if (words.axis == 0)
        words.axis = group.axis;
    if (!words.direction)
        words.direction = group.direction;
    if (words.state == TestRole::notStated)
        words.state = group.state;
    column.words = std::move(words);
}

void readHeadings(const CellTable &table, std::vector<TableColumn> &columns, Remarks &remarks) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
        TableColumn &column = columns[c];
        column.words = readHeading(column.heading);
        takeGroup(column);
        column.meaning = column.words.meaning;
        const SaidUnit said = saidUnit(column.heading);
        column.unit = said.unit;
        column.foreignUnit = said.foreign;
        const SaidUnit ofGroup = saidUnit(column.group.empty() ? std::string() : '(' + column.group + ')');
        const SaidUnit own = saidUnit(ownHeading(column));
        if (ofGroup.isSaid() && own.isSaid() && !(ofGroup == own)) {
            column.unit = nullptr; // "arcsec" above "Forward (µm)"
            column.foreignUnit = ofGroup.words() + ", " + own.words();
        } else if (ofGroup.isSaid() && !said.isSaid()) {
            column.unit = ofGroup.unit;
            column.foreignUnit = ofGroup.foreign;
        }
        if (!said.isSaid() && column.kind == ColumnKind::numbers)
            column.foreignUnit = wordInBrackets(column.heading);
        takeUnitOfCells(table, c, column, remarks);
        // "Point (mm)" is not a counter.
        if (column.meaning == Meaning::index && column.unit &&
            (column.unit->kind == UnitKind::length || column.unit->kind == UnitKind::angle))
            column.meaning = Meaning::place;
    }
}

/// True if a heading tells that its column has no readings.
bool isNoReading(const HeadingWords &heading) {
    return !heading.direction && !heading.hint &&
           (heading.meaning == Meaning::unknown || heading.meaning == Meaning::other ||
            heading.meaning == Meaning::statistic);
}

/// Headings extend further right than any line: either their columns were omitted in all lines, or the
/// headings are not above their columns. A remark after headings that begin with the targets is the former.
void askForHeadingsBeyond(const CellTable &table, const std::vector<std::uint32_t> &heads,
                          const TableBlock &block, const std::vector<TableColumn> &columns,
                          Remarks &remarks) {
    if (table.isPlaced)
        return;
    const auto isAsLong = [&](std::size_t count) {
        return std::ranges::any_of(block.rows,
                                   [&](std::uint32_t row) { return table.rows()[row].count >= count; });
    };
    for (const std::uint32_t head : heads) {
        const auto cells = trimmed(table.cells(table.rows()[head]));
        if (cells.size() <= columns.size() || isAsLong(cells.size()))
            continue;
        const std::string_view beyond = table.text(cells[columns.size()]);
        const Meaning first = columns.front().meaning;
        const bool beginsWithTargets = first == Meaning::target || first == Meaning::place ||
                                       first == Meaning::angle || first == Meaning::time;
        if (beginsWithTargets && isNoReading(readHeading(beyond)))
            continue;
        remarks.push_back(
            {RemarkGrade::assumption,
             {REPORT_TEXT("report", "Columns: the lines end before “%1”; either nothing was entered there, "
                                    "or the headings do not stand above their columns."),
              {excerpt(beyond)}},
             table.rows()[head].line,
             0,
             "columns"});
    }
}

void askForLooseUnits(const CellTable &table, const TableRow &row, Remarks &remarks) {
    std::string units;
    for (const TableCell &cell : table.cells(row))
        units += (units.empty() || cell.size == 0 ? "" : " ") + std::string(table.text(cell));
    remarks.problem({"unit", row.line},
                    REPORT_TEXT("report", "Unit: “%1” does not say to which columns it belongs; say the unit "
                                          "of the readings."),
                    excerpt(units));
}

/// "2s", "± 4 s": a multiple of the standard deviation; "1 s" could number a run.
bool isSpread(std::string_view label) {
    std::string bare;
    for (const char c : label) {
        if (c != ' ')
            bare += c;
    }
    if (bare.starts_with("±"))
        bare.erase(0, std::string_view("±").size());
    return bare == "2s" || bare == "3s" || bare == "4s";
}

} // namespace

bool isComputedRow(const CellTable &table, const TableRow &row) {
    std::size_t numbers = 0;
    bool isLabelled = false;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.kind == CellKind::empty)
            continue;
        if (isLabelled && cell.kind != CellKind::number)
            return false;
        if (!isLabelled) {
            const Meaning meaning =
                cell.kind == CellKind::text ? readHeading(table.text(cell)).meaning : Meaning::unknown;
            isLabelled = meaning == Meaning::statistic || meaning == Meaning::other ||
                         (meaning == Meaning::temperature && table.text(cell).size() > 1) ||
                         isSpread(table.text(cell));
            if (!isLabelled)
                return false;
        } else {
            ++numbers;
        }
    }
    return numbers > 1;
}

bool isYear(double number) {
    constexpr double first = 1990;
    constexpr double last = 2050;
    return number >= first && number <= last && number == std::floor(number);
}

std::span<const TableCell> trimmed(std::span<const TableCell> cells) {
    while (!cells.empty() && cells.back().kind == CellKind::empty)
        cells = cells.first(cells.size() - 1);
    return cells;
}

void findSections(const CellTable &table, TableBody &body) {
    const std::vector<TableColumn> bare = body.columns;
    for (TableBlock &block : body.blocks) {
        const auto [rows, looseUnits] = HeadingSearch(table, block, bare).find();
        std::vector<TableColumn> columns = bare;
        if (rows.empty() && !block.heads.empty() && table.rows()[block.heads.back()].comment &&
            !table.rows()[block.heads.back()].aside &&
            takeFromComment(table, table.rows()[block.heads.back()], columns))
            body.columnHeads.push_back(block.heads.back()); // the comment is the heading
        if (!takeFromProperties(table, block, columns)) {
            composeHeadings(table, rows, columns);
            spreadHeadings(columns);
        }
        const bool named =
            std::ranges::any_of(columns, [](const TableColumn &column) { return !column.heading.empty(); });
        if (named || body.sections.empty()) {
            readHeadings(table, columns, body.remarks);
            askForHeadingsBeyond(table, rows, block, columns, body.remarks);
            if (looseUnits)
                askForLooseUnits(table, table.rows()[*looseUnits], body.remarks);
            body.sections.push_back(std::move(columns));
        }
        block.section = body.sections.size() - 1;
        body.columnHeads.insert(body.columnHeads.end(), rows.begin(), rows.end());
    }
}

} // namespace palmer
