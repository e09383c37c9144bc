// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/tablereading.h"

#include "document/place.h"
#include "kernel/words/shortest.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>

// Above 500 lines: one reading, whose parts share the table, its blocks and what is said above them.

namespace palmer {

namespace {

/// Columns to which the user assigned a role of numbers.
std::vector<std::size_t> chosenNumbers(const Choices &choices) {
    std::vector<std::size_t> numbers;
    const auto columns = palmer::columnsOf(choices.chosen("columns"));
    if (!choices.isChosen("columns") || !columns)
        return numbers;
    for (std::size_t c = 0; c < columns->size(); ++c) {
        const ImportColumn &column = (*columns)[c];
        if (column.hasReadings() || column.role == ColumnRole::target || column.role == ColumnRole::angle ||
            column.role == ColumnRole::radius || column.role == ColumnRole::x || column.role == ColumnRole::y)
            numbers.push_back(c);
    }
    return numbers;
}

std::optional<std::size_t> chosenTable(const Choices &choices) {
    const auto number = choices.chosenNumber("table");
    return number ? std::optional(static_cast<std::size_t>(std::clamp(*number, 0.0, 1e6))) : std::nullopt;
}

/// True if the columns of two sections have the same meaning except for directions and run numbers.
bool areAlike(const std::vector<TableColumn> &a, const std::vector<TableColumn> &b) {
    const auto meaningOf = [](const TableColumn &column) {
        return column.meaning == Meaning::place ? Meaning::target : column.meaning;
    };
    return std::ranges::equal(a, b, [&](const TableColumn &x, const TableColumn &y) {
        const bool understood = x.words.unknownWords == 0 && y.words.unknownWords == 0;
        return !x.isNumeric() ||
               (meaningOf(x) == meaningOf(y) && x.unit == y.unit && x.words.axis == y.words.axis &&
                (understood || x.words.stem == y.words.stem) && x.words.group == y.words.group);
    });
}

/// How likely columns are a measurement: 2 with places and readings, or two axes; 1 with one of them.
int likeness(const std::vector<TableColumn> &columns) {
    bool places = false;
    bool readings = false;
    std::size_t axes = 0;
    for (const TableColumn &column : columns) {
        if (!column.isNumeric())
            continue;
        const Meaning meaning = column.meaning;
        places |= isOneOf(meaning, {Meaning::target, Meaning::place, Meaning::angle});
        readings |= isOneOf(meaning, {Meaning::deviation, Meaning::actual, Meaning::reading, Meaning::run,
                                      Meaning::radius}) ||
                    (column.words.direction && meaning != Meaning::statistic);
        axes += isOneOf(meaning, {Meaning::x, Meaning::y}) ? 1 : 0;
    }
    return axes == 2 ? 2 : (places ? 1 : 0) + (readings ? 1 : 0);
}

/// The axes that the lines above the blocks of each table name.
struct TablesOfAxis {
    std::set<std::size_t> wanted;              ///< with a block of the wanted axis
    std::map<std::size_t, std::string> axesOf; ///< a list
    bool isOfSeveral = false;                  ///< the file names other axes, too
};

TablesOfAxis tablesOfAxis(const std::vector<std::string> &axes, const TableBody &body,
                          const std::vector<std::size_t> &kindOf, std::string_view wanted) {
    TablesOfAxis result;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const std::size_t kind = kindOf[body.blocks[i].section];
        if (kind >= body.tables.size())
            continue;
        std::string &list = result.axesOf[kind];
        if (axes[i] == wanted)
            result.wanted.insert(kind);
        else
            result.isOfSeveral |= !axes[i].empty();
        if (!axes[i].empty() && list.find(axes[i]) == std::string::npos)
            list += (list.empty() ? "" : ", ") + axes[i];
    }
    return result;
}

/// Takes the table of the chosen axis, unless one was chosen, which has to have it. True if the axis decided.
template <class Rank>
bool takeTableOfAxis(const TablesOfAxis &tables, TableBody &body, bool isChosen, const Rank &rank,
                     const Choices &choices) {
    if (tables.wanted.empty())
        return false;
    if (!isChosen) {
        body.table = *std::ranges::max_element(tables.wanted, {}, rank);
        return tables.wanted.size() == 1 && tables.isOfSeveral;
    }
    const auto axes = tables.axesOf.find(body.table);
    if (!tables.wanted.contains(body.table) && axes != tables.axesOf.end() && !axes->second.empty())
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("axis"),
                      std::string(choices.chosen("axis")), axes->second);
    return false;
}

/// Keeps the blocks of one table and lists the others: the chosen one (from 1), that of the chosen axis, by
/// default the longest one with targets and readings. True if the axis decided.
bool keepOneTable(const CellTable &table, TableBody &body, const Choices &choices) {
    constexpr std::size_t mostKinds = 50; // a report with more is not read as a whole
    constexpr std::size_t longestHeadings = 60;
    std::vector<std::size_t> sections; // first section of each kind
    std::vector<std::size_t> kindOf;
    for (std::size_t s = 0; s < body.sections.size(); ++s) {
        const auto found = std::ranges::find_if(
            sections, [&](std::size_t other) { return areAlike(body.sections[other], body.sections[s]); });
        kindOf.push_back(static_cast<std::size_t>(found - sections.begin()));
        if (found == sections.end() && sections.size() < mostKinds)
            sections.push_back(s);
    }
    body.tables.resize(sections.size());
    for (const TableBlock &block : body.blocks) {
        if (kindOf[block.section] >= sections.size())
            continue;
        ListedTable &listed = body.tables[kindOf[block.section]];
        const std::size_t first = table.rows()[block.rows.front()].line;
        listed.firstLine = listed.rows == 0 ? first : listed.firstLine;
        listed.lastLine = table.rows()[block.rows.back()].line;
        listed.rows += block.rows.size();
    }
    for (std::size_t k = 0; k < sections.size(); ++k) {
        for (const TableColumn &column : body.sections[sections[k]]) {
            std::string &headings = body.tables[k].headings;
            if (!column.heading.empty() && headings.size() < longestHeadings)
                headings += (headings.empty() ? "" : ", ") + excerpt(column.heading);
        }
    }
    const auto rank = [&](std::size_t k) {
        return std::pair(likeness(body.sections[sections[k]]), body.tables[k].rows);
    };
    for (std::size_t k = 1; k < sections.size(); ++k)
        body.table = rank(k) > rank(body.table) ? k : body.table;
    const auto chosen = chosenTable(choices);
    const bool isChosen = chosen && *chosen >= 1 && *chosen <= sections.size();
    if (isChosen)
        body.table = *chosen - 1;
    const bool isOfAxis =
        sections.size() > 1 && choices.isChosen("axis") &&
        takeTableOfAxis(tablesOfAxis(axesOfBlocks(table, body), body, kindOf, choices.chosen("axis")), body,
                        isChosen, rank, choices);
    std::erase_if(body.blocks, [&](const TableBlock &block) { return kindOf[block.section] != body.table; });
    body.columns = body.sections[sections[body.table]];
    return isOfAxis;
}

/// The statements of the lines above a block: machine, serial number, day, the text of a day, plane, radius
/// and feed; then axis, state and unit.
using BlockFacts = std::array<std::string, 10>;
constexpr std::size_t factsOfTest = 7;
constexpr std::size_t unitFact = 9;

BlockFacts factsOf(const TableReading &reading, std::vector<std::uint32_t> lines) {
    TableBody own;
    own.notes = std::move(lines);
    const FileNotes notes = notesOf(reading.table(), own, {});
    std::string state;
    for (const std::uint32_t note : own.notes) {
        if (const TestRole said = readHeading(reading.textOf(note)).state; said != TestRole::notStated)
            state = said == TestRole::asFound ? "asFound" : "asLeft";
    }
    return {notes.machine,
            notes.serialNumber,
            notes.date.value_or(std::string()),
            notes.dateText,
            notes.plane,
            notes.radius ? shortest(*notes.radius) + " mm" : std::string(),
            notes.feed ? shortest(*notes.feed) + " mm/min" : std::string(),
            notes.axis,
            state,
            notes.unit.words()};
}

/// The lines above a block, in file order.
std::vector<std::uint32_t> linesAbove(const TableReading &reading, const TableBlock &block) {
    std::vector<std::uint32_t> lines = reading.titlesOf(block);
    std::ranges::reverse(lines);
    return lines;
}

bool differ(std::span<const BlockFacts> blocks, std::size_t fact) {
    std::set<std::string_view> said;
    for (const BlockFacts &block : blocks)
        said.insert(block[fact]);
    said.erase(std::string_view());
    return said.size() > 1;
}

/// The test that each block belongs to, by the facts in which they differ: a fact holds until another is
/// stated.
std::vector<std::string> testsOf(std::span<const BlockFacts> blocks) {
    std::vector<std::string> tests(blocks.size());
    for (std::size_t fact = 0; fact < factsOfTest; ++fact) {
        if (!differ(blocks, fact))
            continue;
        const auto states = [fact](const BlockFacts &block) { return !block[fact].empty(); };
        std::string last = (*std::ranges::find_if(blocks, states))[fact];
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            last = states(blocks[i]) ? blocks[i][fact] : last;
            tests[i] += (tests[i].empty() ? "" : ", ") + last;
        }
    }
    return tests;
}

/// The lines above a block that are only of its test: those above the first block hold for all, up to the one
/// that tells the tests apart.
std::vector<std::uint32_t> ownLines(const TableReading &reading, std::span<const BlockFacts> blocks,
                                    std::size_t index) {
    std::vector<std::uint32_t> lines = linesAbove(reading, reading.body.blocks[index]);
    const auto tells = [&](std::uint32_t line) {
        const BlockFacts facts = factsOf(reading, {line});
        for (std::size_t fact = 0; fact < factsOfTest; ++fact) {
            if (!facts[fact].empty() && differ(blocks, fact))
                return true;
        }
        return false;
    };
    if (index == 0)
        lines.erase(lines.begin(), std::ranges::find_if(lines, tells));
    return lines;
}

} // namespace

TableReading::TableReading(Imported &imported, Choices &chosen, const std::vector<CoverSheet> &covers)
    : result(imported)
    , choices(chosen)
    , body(bodyOf(imported.table, chosenNumbers(chosen))) {
    const bool isOfAxis = keepOneTable(result.table, body, chosen);
    notes = notesOf(imported.table, body, chosen.chosen("axis"), covers);
    keepOneTest(covers);
    std::size_t cells = 0;
    for (const TableRow &each : result.table.rows())
        cells = std::max<std::size_t>(cells, each.first + each.count); // rows may be in any order
    result.roles.assign(cells, CellRole::ignored);
    for (const std::uint32_t head : body.columnHeads) {
        for (std::size_t c = 0; c < row(head).count; ++c)
            setRole(head, c, CellRole::head);
    }
    result.remarks.insert(result.remarks.end(), body.remarks.begin(), body.remarks.end());
    askForTable(isOfAxis);
    askForCutEnd();
}

/// The last line, without its end: "2," where no other number ends so, or "-1" where all have a decimal, or
/// with fewer cells than the others. The file may have been cut there.
void TableReading::askForCutEnd() {
    if (table().isPlaced || body.blocks.empty() || table().text().ends_with('\n') ||
        table().text().ends_with('\r'))
        return;
    const TableRow &last = *std::ranges::max_element(table().rows(), {}, &TableRow::line);
    const std::vector<std::uint32_t> &rows = body.blocks.back().rows;
    const TableRow &end = row(rows.back());
    if (last.line > end.line + 1 || last.comment || rows.size() < 2)
        return;
    const auto cells = table().cells(last);
    const std::size_t at = cells.size() - 1;
    const char mark = table().decimalMark.value == DecimalMark::comma ? ',' : '.';
    const auto decimals = [mark](std::string_view number) {
        const std::size_t point = number.rfind(mark);
        return point == std::string_view::npos ? 0 : number.size() - point;
    };
    const std::size_t usual = row(rows.front()).count;
    bool areEqual = last.line == end.line && cells.back().isNumber();
    std::set<std::size_t> sizes; // decimals in this column
    std::size_t alike = 0;       // numbers with as many
    bool areAll = true;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const TableCell *above = cell(rows[i], at);
        areEqual = areEqual && above && above->isNumber();
        areAll = areAll && row(rows[i]).count == usual;
        if (above)
            sizes.insert(decimals(table().text(*above)));
        alike += static_cast<std::size_t>(
            std::ranges::count_if(table().cells(row(rows[i])), [&](const TableCell &each) {
                return sizes.contains(decimals(table().text(each)));
            }));
    }
    const std::size_t size = decimals(table().text(cells.back()));
    const bool isOpen = cells.back().size > 1 && size == 1 && !sizes.contains(1);
    constexpr std::size_t fewestAlike = 4; // fewer may have as many decimals by chance
    const bool isShorter = alike >= fewestAlike && sizes.size() == 1 && size < *sizes.begin();
    const bool isShortNumber = areEqual && (isOpen || isShorter);
    const bool isShortLine = areAll && last.count < usual && cells.front().isNumber();
    if (isShortNumber || isShortLine)
        remarks
            .problem({"unread", last.line},
                     isShortNumber ? REPORT_TEXT("report", "“%1” ends the table within a number: the file "
                                                           "seems to be cut short.")
                                   : REPORT_TEXT("report", "“%1” ends the table within a line: the file "
                                                           "seems to be cut short."),
                     std::string(table().text(cells.back())))
            .column = cells.size();
}

/// Keeps the blocks of one machine, day, plane, radius and feed, asked if the lines above them state several.
/// Axes and states have choices of their own.
void TableReading::keepOneTest(const std::vector<CoverSheet> &covers) {
    constexpr std::size_t mostBlocks = 1000;
    std::vector<BlockFacts> blocks;
    if (body.blocks.size() > mostBlocks)
        return;
    for (const TableBlock &block : body.blocks)
        blocks.push_back(factsOf(*this, linesAbove(*this, block)));
    if (differ(blocks, unitFact))
        remarks.problem("unit",
                        REPORT_TEXT("report", "Unit: the lines above the blocks of numbers name several; "
                                              "all are read in one."));
    if (differ(blocks, factsOfTest) || differ(blocks, factsOfTest + 1))
        return;
    const std::vector<std::string> tests = testsOf(blocks);
    std::vector<std::string> different;
    std::string list;
    for (const std::string &test : tests) {
        if (std::ranges::find(different, test) == different.end()) {
            different.push_back(test);
            list += (list.empty() ? "" : "; ") + test;
        }
    }
    if (different.size() < 2)
        return;
    const std::string read = choices.resolve("part", different.front(), Origin::guessed).value;
    different.push_back(list); // all as one test
    if (std::ranges::find(different, read) == different.end())
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("part"), read, list);
    remarks
        .problem("part",
                 REPORT_TEXT("report", "Lines: those above the blocks of numbers name several tests (%1); "
                                       "the blocks of “%2” are read."),
                 list, read)
        .answers = different;
    for (std::size_t i = blocks.size(); i-- > 0 && read != list;) {
        if (tests[i] == read)
            continue;
        const std::vector<std::uint32_t> titles = ownLines(*this, blocks, i);
        std::erase_if(body.notes, [&](auto note) { return std::ranges::find(titles, note) != titles.end(); });
        body.blocks.erase(body.blocks.begin() + static_cast<std::ptrdiff_t>(i));
    }
    notes = notesOf(result.table, body, choices.chosen("axis"), covers);
}

void TableReading::askForTable(bool isOfAxis) {
    if (body.tables.size() < 2)
        return;
    result.tables = body.tables;
    result.readTable = body.table;
    const std::string read = std::to_string(body.table + 1);
    const auto choice = choices.resolve("table", read, isOfAxis ? Origin::recognised : Origin::guessed);
    if (choice.origin == Origin::chosen && choice.value != read)
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; the file has %3 of them"),
                      nameOfChoice("table"), choice.value, std::to_string(body.tables.size()));
    std::string list;
    Remark question{isOfAxis ? RemarkGrade::note : RemarkGrade::problem, {}, 0, 0, "table"};
    for (std::size_t i = 0; i < body.tables.size(); ++i) {
        const ListedTable &table = body.tables[i];
        const std::string number = std::to_string(i + 1);
        list += (list.empty() ? "" : "; ") + number + ": " + std::to_string(table.firstLine) + "–" +
                std::to_string(table.lastLine) +
                (table.headings.empty() ? std::string() : " (" + table.headings + ')');
        question.answers.push_back(number);
    }
    question.message = {
        REPORT_TEXT("report", "Table: the file has several, in the lines %1; number %2 is read."),
        {list, read}};
    result.remarks.push_back(std::move(question));
}

std::vector<ImportColumn> TableReading::columnsAs(std::string_view roles) const {
    std::vector<ImportColumn> columns = columnsOf(roles).value_or(std::vector<ImportColumn>());
    columns.resize(body.columns.size());
    for (std::size_t c = 0; c < columns.size(); ++c) {
        columns[c].heading = body.columns[c].heading;
        columns[c].unit = body.columns[c].unit;
    }
    return columns;
}

std::optional<std::vector<ImportColumn>> TableReading::resolveColumns(const std::vector<ImportColumn> &found,
                                                                      const std::optional<Message> &question,
                                                                      RemarkGrade grade) {
    const auto choice =
        choices.resolve("columns", wordOf(found), question ? Origin::guessed : Origin::recognised);
    if (choice.origin == Origin::chosen)
        return columnsAs(choice.value);
    if (question)
        remarks.add(grade, "columns", *question);
    return {};
}

std::string_view TableReading::cellText(std::uint32_t index, std::size_t column) const {
    const TableCell *found = cell(index, column);
    return found ? table().text(*found) : std::string_view();
}

std::string TableReading::textOf(std::uint32_t index) const {
    std::string line;
    for (const TableCell &cell : table().cells(row(index)))
        line += ' ' + std::string(table().text(cell));
    return line;
}

std::optional<double> TableReading::noNumber(std::uint32_t index, std::size_t column) {
    const TableCell *found = cell(index, column);
    if (!found || found->kind == CellKind::empty)
        return {};
    if (found->kind == CellKind::missing) {
        if (++m_missingWords == 1)
            remarks.note({"", row(index).line}, REPORT_TEXT("report", "“%1” is read as a missing reading."),
                         excerpt(table().text(*found)));
        return {};
    }
    remarks
        .problem({"unread", row(index).line},
                 found->kind == CellKind::grouped
                     ? REPORT_TEXT("report", "“%1” has another decimal mark or thousands separators. The "
                                             "reading stays missing.")
                     : REPORT_TEXT("report", "“%1” is not a number. The reading stays missing."),
                 excerpt(table().text(*found)))
        .column = column + 1;
    return {};
}

void TableReading::remarkNoTarget(std::uint32_t index, std::string_view cell) {
    remarks.problem({"unread", row(index).line},
                    REPORT_TEXT("report", "“%1” is no target position; the line was not read."),
                    excerpt(cell));
}

void TableReading::remarkUnread(const std::function<bool(std::size_t)> &isRead,
                                const std::function<bool(std::size_t)> &looksLikeReadings) {
    std::string names;
    std::string readings;
    for (std::size_t c = 0; c < body.columns.size(); ++c) {
        const std::string &heading = body.columns[c].heading;
        if (isRead(c) || body.columns[c].kind == ColumnKind::empty)
            continue;
        const bool isReading = !choices.isChosen("columns") && looksLikeReadings(c);
        std::string &list = isReading ? readings : names;
        const std::string name = heading.empty() && isReading ? '#' + std::to_string(c + 1)
                                 : isReading                  ? excerpt(heading)
                                                              : heading;
        if (!name.empty())
            list += (list.empty() ? "" : ", ") + name;
    }
    if (!readings.empty())
        remarks.problem("columns",
                        REPORT_TEXT("report", "Columns that look like readings and are not read: %1."),
                        readings);
    if (!names.empty())
        remarks.note({}, REPORT_TEXT("report", "Columns that are not read: %1."), excerpt(names));
}

std::vector<std::uint32_t> TableReading::titlesOf(const TableBlock &block) const {
    std::vector<std::uint32_t> titles(block.heads.rbegin(), block.heads.rend());
    std::erase_if(titles, [&](auto head) { return std::ranges::binary_search(body.columnHeads, head); });
    return titles;
}

TestRole TableReading::stateOf(const TableBlock &block) const {
    for (const std::uint32_t head : titlesOf(block)) {
        const HeadingWords title = readTitle(textOf(head));
        if (title.state != TestRole::notStated && title.unknownWords < 3) // a title, not prose
            return title.state;
    }
    return TestRole::notStated;
}

bool TableReading::marksReadings(std::size_t column) const {
    constexpr std::string_view words =
        "|status|valid|validity|flag|flags|quality|rejected|outlier|excluded|statut|valide|"
        "etat|qualite|rejete|exclu|gultig|ungultig|qualitat|ausreisser|stato|valido|"
        "estado|calidad|";
    if (words.find('|' + folded(body.columns[column].heading) + '|') == std::string_view::npos)
        return false;
    std::set<std::string_view> cells;
    for (const TableBlock &block : body.blocks) {
        for (const std::uint32_t index : block.rows)
            cells.insert(cellText(index, column));
    }
    cells.erase(std::string_view());
    return cells.size() > 1;
}

void TableReading::askForMarks(const std::function<bool(std::size_t)> &isRead) const {
    for (std::size_t c = 0; c < body.columns.size() && !choices.isChosen("columns"); ++c) {
        if (!isRead(c) && body.columns[c].kind != ColumnKind::empty && marksReadings(c))
            remarks.problem(
                "columns",
                REPORT_TEXT("report",
                            "“%1” differs from line to line; all readings are read, whatever it says."),
                excerpt(body.columns[c].heading));
    }
}

std::vector<double> TableReading::valuesOf(std::size_t column, std::size_t most) const {
    std::vector<double> values;
    for (const TableBlock &block : body.blocks) {
        for (std::size_t i = 0; i < block.rows.size() && values.size() < most; ++i) {
            if (const auto value = numberAt(block.rows[i], column))
                values.push_back(*value);
        }
    }
    return values;
}

std::pair<double, double> TableReading::rangeOf(std::size_t column) const {
    std::pair<double, double> range{INFINITY, -INFINITY};
    for (const double value : valuesOf(column))
        range = {std::min(range.first, value), std::max(range.second, value)};
    return range;
}

bool isCounter(const TableReading &reading, std::size_t column) {
    // Some instruments continue counting across blocks, some restart.
    std::size_t rows = 0;
    for (const TableBlock &block : reading.body.blocks) {
        std::optional<double> last;
        for (const std::uint32_t row : block.rows) {
            const auto value = reading.numberAt(row, column);
            if (!value)
                return false;
            const bool begins = !last && *value >= 0 &&
                                *value == static_cast<double>(static_cast<long long>(std::min(*value, 1e9)));
            if (!(begins || (last && *value == *last + 1)))
                return false;
            if (rows == 0 && *value > 1)
                return false;
            last = value;
            ++rows;
        }
    }
    return rows > 1;
}

} // namespace palmer
