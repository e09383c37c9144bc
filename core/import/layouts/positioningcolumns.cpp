// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"
#include "import/layouts/conditioncolumns.h"

#include "document/place.h"
#include "tables/contenterror.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palmer {

namespace {

/// True for numbers without a heading after the targets if other columns have one.
bool isUntitled(const ColumnSearch &search, std::size_t c) {
    const std::vector<TableColumn> &heads = search.reading.body.columns;
    const auto isTitled = [](const TableColumn &head) { return !head.heading.empty(); };
    return !isTitled(heads[c]) && std::ranges::any_of(heads, isTitled) && c > search.result.target &&
           !isCounter(search.reading, c);
}

/// The cells of a column in all rows of the table.
std::vector<std::string_view> cellsOf(const ColumnSearch &search, std::size_t c) {
    std::vector<std::string_view> cells;
    for (const TableBlock &block : search.reading.body.blocks) {
        for (const std::uint32_t row : block.rows)
            cells.push_back(search.reading.cellText(row, c));
    }
    return cells;
}

/// "(4.5)", "3.5±0.2", "0x10": cells with numbers that are not read as such, under a heading of readings or
/// targets; or targets by their heading, where others are taken that are none by theirs.
bool isUnreadable(const ColumnSearch &search, std::size_t c) {
    const TableColumn &head = search.reading.body.columns[c];
    const std::vector<TableColumn> &heads = search.reading.body.columns;
    const bool hasTargets = search.result.target &&
                            isOneOf(heads[*search.result.target].meaning, {Meaning::target, Meaning::place});
    const bool isNamed = head.words.direction || head.words.hint ||
                         isOneOf(head.meaning, {Meaning::deviation, Meaning::reading, Meaning::actual}) ||
                         (!hasTargets && isOneOf(head.meaning, {Meaning::target, Meaning::place}));
    // "Air temperature: 20,5" above "Target (mm)" makes the targets a temperature.
    if (head.kind == ColumnKind::numbers)
        return !hasTargets && head.words.isTarget;
    return head.kind == ColumnKind::words && isNamed &&
           std::ranges::any_of(cellsOf(search, c), [](std::string_view cell) {
               return cell.substr(0, 2).find_first_of("0123456789") != std::string_view::npos;
           });
}

/// "µm" in a column of its own is the unit of the readings; units that differ from line to line, or that are
/// not known, are asked for.
void takeUnitColumn(ColumnSearch &search) {
    const std::vector<TableColumn> &heads = search.reading.body.columns;
    for (std::size_t c = 0; c < heads.size() && !search.result.unit.isSaid(); ++c) {
        if (heads[c].kind != ColumnKind::words || search.result.columns[c].role != ColumnRole::ignored)
            continue;
        const std::vector<std::string_view> cells = cellsOf(search, c);
        const std::set<std::string_view> different(cells.begin(), cells.end());
        constexpr std::size_t most = 4;
        if (different.size() > most)
            continue;
        SaidUnit unit;
        for (const std::string_view cell : different) {
            const SaidUnit said = saidUnit('(' + std::string(cell) + ')');
            if (!said.isSaid())
                return;
            unit = different.size() == 1
                       ? said
                       : SaidUnit{nullptr, unit.foreign + (unit.isSaid() ? ", " : "") + std::string(cell)};
        }
        search.result.unit = unit;
    }
}

/// "(sec)" above readings is a unit of time, which readings have not: quotes it as the heading has it.
void quoteForeignUnit(ColumnSearch &search) {
    SaidUnit &said = search.result.unit;
    if (!said.unit || said.unit->kind == UnitKind::length || said.unit->kind == UnitKind::angle)
        return;
    for (const std::size_t c : search.result.values) {
        const std::string_view heading = search.reading.body.columns[c].heading;
        const std::size_t open = heading.find_last_of("([");
        const std::size_t close = heading.find_last_of(")]");
        if (open != std::string_view::npos && close != std::string_view::npos && close > open + 1) {
            said = {nullptr, std::string(heading.substr(open + 1, close - open - 1))};
            return;
        }
    }
}

/// True if the lowest row of the headings names run, direction and unit as those of the readings do, whatever
/// the rows above say; not below "Mean".
bool isHeadedAsRun(const ColumnSearch &search, std::size_t c) {
    const TableColumn &head = search.reading.body.columns[c];
    const HeadingWords own = readHeading(head.own);
    const auto hasSameUnit = [&](std::size_t other) {
        return saidUnit(search.reading.body.columns[other].own) == saidUnit(head.own);
    };
    return head.kind == ColumnKind::numbers && own.number && own.direction &&
           isOneOf(own.meaning, {Meaning::unknown, Meaning::run, Meaning::deviation, Meaning::reading,
                                 Meaning::actual, Meaning::direction}) &&
           std::ranges::any_of(search.result.values, hasSameUnit) &&
           readHeading(head.group).meaning != Meaning::statistic;
}

/// True if an unread column has a heading or position typical of readings.
bool looksLikeReadings(const ColumnSearch &search, std::size_t c) {
    const TableColumn &head = search.reading.body.columns[c];
    const std::string &axis = search.reading.axisFound;
    const bool isOfAxis = axis.empty() || head.words.axis == 0 || head.words.axis == axis[0];
    const bool isOfOtherState =
        head.words.state != TestRole::notStated && head.words.state != search.reading.stateFound;
    if (search.result.columns[c].role == ColumnRole::actual && !search.result.sign.empty())
        return false; // it proved the sign
    if (isOfAxis && !isOfOtherState && (isUnreadable(search, c) || isHeadedAsRun(search, c)))
        return true;
    if (head.kind != ColumnKind::numbers || search.result.columns[c].role != ColumnRole::ignored ||
        !isOfAxis || isOfOtherState ||
        (head.meaning == Meaning::run && !head.words.number && isCounter(search.reading, c)))
        return false;
    return isOneOf(head.meaning, {Meaning::deviation, Meaning::reading, Meaning::run}) ||
           (isOneOf(head.meaning, {Meaning::unknown, Meaning::actual, Meaning::direction, Meaning::place}) &&
            (head.words.direction || head.words.namesSense || isUntitled(search, c)));
}

/// True if a column has a role, or only counts or selects the lines.
bool isUsed(const ColumnSearch &search, std::size_t c) {
    const TableColumn &head = search.reading.body.columns[c];
    const ColumnRole role = search.result.columns[c].role;
    return role == ColumnRole::target || role == ColumnRole::direction || role == ColumnRole::number ||
           std::ranges::find(search.result.values, c) != search.result.values.end() ||
           std::ranges::find(search.result.conditions, c) != search.result.conditions.end() ||
           head.meaning == Meaning::index ||
           (head.meaning == Meaning::axis && head.kind == ColumnKind::words); // it selects the lines
}

/// Remarks on unread columns; those that look like readings become a question.
void remarkIgnored(ColumnSearch &search) {
    TableReading &m = search.reading;
    const auto isRead = [&](std::size_t c) { return isUsed(search, c); };
    const auto isReading = [&](std::size_t c) { return looksLikeReadings(search, c); };
    m.askForMarks(isRead);
    for (std::size_t c = 0; c < m.body.columns.size() && !m.choices.isChosen("columns"); ++c) {
        const TableColumn &head = m.body.columns[c];
        if (isRead(c) || head.kind == ColumnKind::empty)
            continue;
        if (head.meaning == Meaning::direction && !isReading(c))
            m.remarks.problem("columns",
                              REPORT_TEXT("report",
                                          "Columns: “%1” is headed as directions, but its cells name "
                                          "none that is known; it is not read."),
                              excerpt(head.heading));
    }
    m.remarkUnread(isRead, isReading);
}

/// "Target ↑; Dev ↑; Target ↓; Dev ↓": readings belong to the targets on their left.
void placeOwnTargets(PositioningColumns &columns) {
    std::size_t nearest = columns.target.value_or(0);
    for (std::size_t c = 0; c < columns.columns.size(); ++c) {
        if (columns.columns[c].role == ColumnRole::target)
            nearest = c;
        if (nearest != columns.target && std::ranges::find(columns.values, c) != columns.values.end())
            columns.ownTargets[c] = nearest;
    }
}

/// Replaces what was found by the user's choice. Throws Error for roles that make no test.
void takeChosenColumns(ColumnSearch &search, std::vector<ImportColumn> chosen) {
    const std::vector<TableColumn> &heads = search.reading.body.columns;
    const auto named = palmer::columnsOf(search.reading.choices.chosen("columns"));
    if (named && named->size() > heads.size())
        throw Error(Error::Kind::content,
                    {REPORT_TEXT_COUNTED("report", "%1 names %n column(s), the table has %2"),
                     {"columns", counted(heads.size())},
                     static_cast<int>(named->size())});
    PositioningColumns result;
    result.columns = std::move(chosen);
    result.target = columnOf(result.columns, ColumnRole::target);
    result.direction = columnOf(result.columns, ColumnRole::direction);
    result.number = columnOf(result.columns, ColumnRole::number);
    const bool hasDeviations = columnOf(result.columns, ColumnRole::deviation).has_value();
    ColumnRole content = ColumnRole::run;
    for (std::size_t c = 0; c < result.columns.size(); ++c) {
        const ImportColumn &column = result.columns[c];
        const bool isProof = hasDeviations && column.role == ColumnRole::actual;
        if (!column.hasReadings() || isProof)
            continue;
        if (!result.values.empty() && column.role != content)
            refuseContent(REPORT_TEXT(
                "report",
                "columns of different roles cannot be read as runs of one test; ignore one of them"));
        content = column.role;
        result.values.push_back(c);
        if (!result.unit.isSaid())
            result.unit = heads[c].said();
    }
    result.content = content == ColumnRole::deviation ? "deviations"
                     : content == ColumnRole::actual  ? "positions"
                                                      : "";
    search.result = std::move(result);
}

/// "P1; P2; P3": targets across whose positions are not said, of which the first is no column of targets.
void askForTargetsAcross(ColumnSearch &search) {
    if (!search.result.target)
        return;
    const std::vector<TableColumn> &heads = search.reading.body.columns;
    const TableColumn &target = heads[*search.result.target];
    const auto isAlike = [&](const TableColumn &head) {
        return head.kind == ColumnKind::numbers && head.meaning == target.meaning && head.words.number &&
               head.words.number != target.words.number && !head.words.direction;
    };
    const auto other = std::ranges::find_if(heads, isAlike);
    if (!target.words.number || other == heads.end() ||
        search.result.columns[static_cast<std::size_t>(other - heads.begin())].role == ColumnRole::target)
        return;
    search.reading.remarks.problem("columns",
                                   REPORT_TEXT("report", "Columns: “%1” and “%2” are headed alike; only the "
                                                         "first is read as targets."),
                                   excerpt(target.heading), excerpt(other->heading));
}

/// Settles the columns: the user's choice, otherwise what was found, with its question.
void resolve(ColumnSearch &search) {
    TableReading &m = search.reading;
    if (auto chosen = m.resolveColumns(search.result.columns, search.question,
                                       search.isDoubtful ? RemarkGrade::problem : RemarkGrade::assumption))
        takeChosenColumns(search, std::move(*chosen));
    else if (!search.hasProposal)
        m.remarks.back().isOwed = true;
    m.result.columns = search.result.columns; // to be shown and changed even if nothing else is known
    if (!search.result.target || search.result.values.empty())
        refuseContent(REPORT_TEXT("report", "the columns of the targets and "
                                            "of the readings are not known; give the columns their roles"));
    if (!m.choices.isChosen("columns"))
        askForTargetsAcross(search);
    placeOwnTargets(search.result);
    takeUnitColumn(search);
    quoteForeignUnit(search);
    takeConditions(m, search.result.columns, !m.choices.isChosen("columns"), search.result);
    remarkIgnored(search);
}

} // namespace

bool ColumnStep::followsTarget(std::size_t column) const {
    const std::vector<double> targets = valuesOf(*m_result.target);
    const std::vector<double> values = valuesOf(column);
    if (targets.size() != values.size() || targets.size() < 2)
        return false;
    const auto [low, high] = std::ranges::minmax(targets);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::abs(values[i] - targets[i]) > 0.1 * (high - low))
            return false;
    }
    return high > low;
}

PositioningColumns positioningColumns(TableReading &reading) {
    ColumnSearch search{reading};
    takeRolesOfHeadings(search);
    findTargetColumn(search);
    findReadings(search);
    keepReadingsOfOneKind(search);
    takeDirectionsOfHeadings(search);
    findOwnTargets(search);
    proveSign(search);
    resolve(search);
    return std::move(search.result);
}

TestRole resolveState(TableReading &reading) {
    const auto choice = reading.choices.resolve("state", "asFound", Origin::guessed);
    const bool isLeft = choice.value == "asLeft";
    reading.remarks.problem(
        "state", isLeft ? REPORT_TEXT("report", "State: the table has readings as found and as left; those "
                                                "as left are read, the others are a test of their own.")
                        : REPORT_TEXT("report", "State: the table has readings as found and as left; those "
                                                "as found are read, the others are a test of their own."));
    return isLeft ? TestRole::asLeft : TestRole::asFound;
}

TestRole statedState(TableReading &reading, TestRole state, std::string_view words) {
    reading.remarks.note({},
                         state == TestRole::asLeft ? REPORT_TEXT("report", "State: as left, as “%1” says.")
                                                   : REPORT_TEXT("report", "State: as found, as “%1” says."),
                         excerpt(withoutBlanks(words)));
    return state;
}

std::string resolveAxis(TableReading &reading, const std::vector<std::string> &axes) {
    const std::string chosen(reading.choices.chosen("axis"));
    std::string names;
    for (const std::string &each : axes)
        names += (names.empty() ? "" : ", ") + each;
    const bool isOne = std::ranges::find(axes, chosen) != axes.end();
    if (!chosen.empty() && !isOne)
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("axis"), chosen,
                      names);
    reading.axisFound = isOne ? chosen : axes.front();
    reading.remarks
        .problem("axis",
                 REPORT_TEXT("report", "Axis: the table has several (%1); %2 is read, the others are a test "
                                       "of their own."),
                 names, reading.axisFound)
        .answers = axes;
    return reading.axisFound;
}

} // namespace palmer
