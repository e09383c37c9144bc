// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/place.h"
#include "import/instruments/compensationtable.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

// Readers of the compensation tables, one per control, each by the rules of its control.

namespace palmer {

namespace {

constexpr double positionFineness = 1e6; ///< fraction of a mm or degree
constexpr double valueFineness = 1e7;
constexpr std::size_t mostTableRows = 100'000;

double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0; // never −0
}

[[noreturn]] void refuseLine(const TextLine &line) {
    refuseContentAt(placeOfLine(line.number),
                    REPORT_TEXT("report", "“%1” is no line of a compensation table"),
                    excerpt(withoutBlanks(line.text)));
}

[[noreturn]] void refuseTable() {
    refuseContent(REPORT_TEXT("report", "the compensation table has no values, no step or no begin"));
}

double numberOf(std::string_view text, const TextLine &line) {
    const CellValue value = readCell(text, DecimalMark::point);
    if (value.kind != CellKind::number)
        refuseLine(line);
    return value.value;
}

void requireAscent(const CompensationTable &table) {
    if (table.positions.empty())
        refuseTable();
    if (std::ranges::adjacent_find(table.positions, std::ranges::greater_equal()) != table.positions.end())
        refuseContent(REPORT_TEXT("report", "the positions of a compensation table ascend"));
}

void finish(CompensationTable &table) {
    table.perDirection = table.forward != table.reverse;
    requireAscent(table);
}

/// Like sscanf("%lf %lf %lf"): three numbers preceded by blanks, followed by anything.
std::optional<std::array<double, 3>> triplet(std::string_view line) {
    std::array<double, 3> numbers{};
    for (double &number : numbers) {
        const std::size_t begin = line.find_first_not_of(" \t\v\f");
        if (begin == std::string_view::npos)
            return {};
        line.remove_prefix(begin);
        if (line.front() == '+' && line.size() > 1 && line[1] != '-')
            line.remove_prefix(1);
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (error != std::errc() || !std::isfinite(number))
            return {};
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
    return numbers;
}

// ---- SINUMERIK

/// $NAME[indexes]=value ; comment
struct Command {
    std::string name;
    std::vector<std::string> indexes;
    std::string value;
    TextLine line;
};

std::string capitals(std::string_view text) {
    std::string result = upperCase(text);
    std::erase_if(result, [](char c) { return c == ' ' || c == '\t'; });
    return result;
}

std::vector<Command> assignmentsOf(std::string_view text) {
    std::vector<Command> result;
    for (const TextLine &line : linesOf(text)) {
        const std::string code = capitals(line.text.substr(0, line.text.find(';')));
        if (!code.starts_with("$AA_ENC_COMP") && !code.starts_with("$AN_CEC"))
            continue;
        const std::size_t open = code.find('[');
        const std::size_t close = code.find(']');
        const std::size_t equals = code.find('=');
        if (open == std::string::npos || close == std::string::npos || close < open || equals != close + 1)
            refuseLine(line);
        Command each{code.substr(0, open), {}, code.substr(equals + 1), line};
        // Some manuals print [0.3] for [0,3].
        const std::string inside = code.substr(open + 1, close - open - 1);
        for (std::size_t at = 0; at <= inside.size();) {
            const std::size_t end = std::min(inside.find_first_of(",.", at), inside.size());
            each.indexes.push_back(inside.substr(at, end - at));
            at = end + 1;
        }
        result.push_back(std::move(each));
    }
    return result;
}

/// A SINUMERIK table: points counted from MIN in steps up to MAX.
struct Stepped {
    std::map<std::size_t, double> values;
    std::optional<double> step;
    std::optional<double> low;
    std::optional<double> high;
    bool modulo = false;
    int direction = 0;
    std::string input; ///< input axis of $AN_CEC
    std::string output;
};

std::size_t pointIndex(const std::string &text, const TextLine &line) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size() || index > mostTableRows)
        refuseLine(line);
    return index;
}

std::string withoutBrackets(std::string text) {
    std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == '"'; });
    return text;
}

void take(Stepped &table, const Command &each, std::string_view what) {
    const auto number = [&] { return numberOf(each.value, each.line); };
    if (what.empty())
        table.values[pointIndex(each.indexes[1], each.line)] = number();
    else if (what == "_STEP")
        table.step = number();
    else if (what == "_MIN")
        table.low = number();
    else if (what == "_MAX")
        table.high = number();
    else if (what == "_IS_MODULO")
        table.modulo = number() != 0;
    else if (what == "_DIRECTION")
        table.direction = static_cast<int>(std::clamp(number(), -1.0, 1.0));
    else if (what == "_INPUT_AXIS")
        table.input = withoutBrackets(each.value);
    else if (what == "_OUTPUT_AXIS")
        table.output = withoutBrackets(each.value);
}

/// Corrections of a table: a positive value moves the axis in the negative direction.
CompensationTable correctionsOf(const Stepped &stepped) {
    if (stepped.values.empty() || !stepped.step || !stepped.low || !(*stepped.step > 0))
        refuseTable();
    CompensationTable table;
    std::size_t points = stepped.values.rbegin()->first + 1;
    if (stepped.high) {
        const double steps = std::floor((*stepped.high - *stepped.low) / *stepped.step + 1e-6);
        if (!(steps >= 0) || steps > static_cast<double>(mostTableRows))
            refuseTable();
        points = static_cast<std::size_t>(steps) + 1;
    }
    for (std::size_t i = 0; i < points; ++i) {
        const auto value = stepped.values.find(i);
        if (value == stepped.values.end())
            refuseContent(
                REPORT_TEXT(
                    "report",
                    "point %1 of the compensation table has no value: the control would keep an older one"),
                counted(i));
        table.positions.push_back(
            rounded(*stepped.low + static_cast<double>(i) * *stepped.step, positionFineness));
        table.forward.push_back(rounded(-value->second, valueFineness));
    }
    table.reverse = table.forward;
    if (stepped.modulo)
        table.period = table.positions.back() - table.positions.front();
    return table;
}

/// Merges the tables of both directions.
CompensationTable bothDirections(const CompensationTable &up, const CompensationTable &down) {
    CompensationTable table = up;
    table.perDirection = true;
    std::set<double> positions(up.positions.begin(), up.positions.end());
    positions.insert(down.positions.begin(), down.positions.end());
    table.positions.assign(positions.begin(), positions.end());
    table.forward.clear();
    table.reverse.clear();
    for (const double position : table.positions) {
        table.forward.push_back(up.correction(position, Direction::positive));
        table.reverse.push_back(down.correction(position, Direction::negative));
    }
    return table;
}

void noteOthers(FoundTable &found, std::size_t others) {
    if (others > 0)
        found.remarks.push_back(
            {REPORT_TEXT("report", "other tables in the file that were not used: %1"), {counted(others)}});
}

FoundTable encoderTable(const std::vector<Command> &assignments) {
    std::map<std::string, Stepped> tables; // by axis and measuring system
    std::string first;
    std::string axis;
    for (const Command &each : assignments) {
        if (!each.name.starts_with("$AA_ENC_COMP"))
            continue;
        const std::string what = each.name.substr(std::string_view("$AA_ENC_COMP").size());
        if (each.indexes.size() != (what.empty() ? 3U : 2U))
            refuseLine(each.line);
        const std::string key = each.indexes.front() + ',' + each.indexes.back();
        if (first.empty()) {
            first = key;
            axis = each.indexes.back();
        }
        take(tables[key], each, what);
    }
    FoundTable found{"SINUMERIK $AA_ENC_COMP", correctionsOf(tables[first]), {}};
    found.table.axis = axis;
    noteOthers(found, tables.size() - 1);
    return found;
}

FoundTable sagTable(const std::vector<Command> &assignments) {
    std::map<std::string, Stepped> tables; // by index
    for (const Command &each : assignments) {
        const std::string what = each.name.substr(std::string_view("$AN_CEC").size());
        if (each.indexes.size() != (what.empty() ? 2U : 1U))
            refuseLine(each.line);
        take(tables[each.indexes.front()], each, what);
    }
    const auto onItself = [](const auto &table) {
        return !table.second.input.empty() && table.second.input == table.second.output;
    };
    const auto first = std::ranges::find_if(tables, onItself);
    if (first == tables.end())
        refuseContent(REPORT_TEXT("report", "no table in it compensates an axis upon itself"));
    FoundTable found{"SINUMERIK $AN_CEC", correctionsOf(first->second), {}};
    std::size_t used = 1;
    const int direction = first->second.direction;
    const auto opposite = std::ranges::find_if(tables, [&](const auto &table) {
        return onItself(table) && table.second.input == first->second.input && direction != 0 &&
               table.second.direction == -direction;
    });
    if (opposite != tables.end()) {
        const CompensationTable other = correctionsOf(opposite->second);
        found.table = direction > 0 ? bothDirections(found.table, other) : bothDirections(other, found.table);
        ++used;
    } else if (direction != 0) {
        found.table.perDirection = true;
        std::ranges::fill(direction > 0 ? found.table.reverse : found.table.forward, 0.0);
    }
    found.table.axis = first->second.input;
    found.remarks.push_back(
        {REPORT_TEXT("report", "its values are taken to have the sign of those of $AA_ENC_COMP")});
    noteOthers(found, tables.size() - used);
    return found;
}

// ---- Heidenhain

struct HeidenhainColumn {
    std::string name;
    std::size_t begin = 0;
};

std::vector<HeidenhainColumn> headingColumns(std::string_view line) {
    std::vector<HeidenhainColumn> columns;
    for (std::size_t at = 0;;) {
        at = line.find_first_not_of(" \t", at);
        if (at == std::string_view::npos)
            return columns;
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        columns.push_back({capitals(line.substr(at, end - at)), at});
        at = end;
    }
}

/// The cell below a column: cells are aligned with their headings, empty ones are blank.
std::string_view cellOf(std::string_view line, const std::vector<HeidenhainColumn> &columns,
                        std::size_t column) {
    const std::size_t begin = columns[column].begin;
    if (begin >= line.size())
        return {};
    const std::size_t end = column + 1 < columns.size() ? columns[column + 1].begin : line.size();
    return withoutBlanks(line.substr(begin, end - begin));
}

struct ComColumns {
    std::vector<HeidenhainColumn> all;
    std::size_t position = 0;
    std::size_t axis = 0;
    std::optional<std::size_t> reverse;
};

ComColumns comColumns(std::string_view headings) {
    ComColumns columns{headingColumns(headings), 0, 0, {}};
    bool hasPosition = false;
    bool hasAxis = false;
    for (std::size_t i = 0; i < columns.all.size(); ++i) {
        const std::string &name = columns.all[i].name;
        if (name == "AXISPOS") {
            columns.position = i;
            hasPosition = true;
        } else if (name == "BACKLASH") {
            columns.reverse = i;
        } else if (name != "NR" && !hasAxis) {
            columns.axis = i;
            hasAxis = true;
        }
    }
    if (!hasPosition || !hasAxis)
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report", "the rules of this compensation table (%1) are not read here"),
                 std::string("Heidenhain"));
    return columns;
}

} // namespace

FoundTable readLinuxcncTable(std::string_view text, LinuxcncValues values) {
    constexpr std::size_t most = 256;
    FoundTable found{"LinuxCNC", {}, {}};
    CompensationTable &table = found.table;
    std::size_t leftOut = 0;
    for (const TextLine &line : linesOf(text)) {
        const auto numbers = triplet(line.text);
        if (!numbers) {
            if (table.positions.empty())
                refuseContentAt(
                    placeOfLine(line.number),
                    REPORT_TEXT("report", "“%1” is no three numbers: LinuxCNC stops here and loads nothing"),
                    excerpt(withoutBlanks(line.text)));
            found.remarks.push_back(
                {REPORT_TEXT("report", "LinuxCNC stops reading at line %1"), {counted(line.number)}});
            break;
        }
        const auto &[nominal, first, second] = *numbers;
        if (table.positions.size() == most ||
            (!table.positions.empty() && !(nominal > table.positions.back()))) {
            ++leftOut;
            continue;
        }
        const bool positions = values == LinuxcncValues::positions;
        table.positions.push_back(nominal);
        table.forward.push_back(rounded(positions ? nominal - first : first, valueFineness));
        table.reverse.push_back(rounded(positions ? nominal - second : second, valueFineness));
    }
    if (leftOut > 0)
        found.remarks.push_back(
            {REPORT_TEXT("report", "lines that LinuxCNC does not load, beyond 256 or not ascending: %1"),
             {counted(leftOut)}});
    finish(table);
    return found;
}

FoundTable readSinumerikTable(std::string_view text) {
    const std::vector<Command> assignments = assignmentsOf(text);
    const bool encoder = std::ranges::any_of(
        assignments, [](const Command &each) { return each.name.starts_with("$AA_ENC_COMP"); });
    if (assignments.empty())
        refuseTable();
    FoundTable found = encoder ? encoderTable(assignments) : sagTable(assignments);
    if (text.find("unit=deg") != std::string_view::npos)
        found.table.motion = Motion::rotary;
    requireAscent(found.table);
    return found;
}

FoundTable readWeihongTable(std::string_view text, bool deviations) {
    FoundTable found{"Weihong", {}, {}};
    std::string axis;
    std::size_t others = 0;
    for (const TextLine &line : linesOf(text)) {
        const std::string code = capitals(line.text);
        if (code.empty() || code.starts_with(';') || code.starts_with("UNIT="))
            continue;
        if (code.front() == '[') {
            if (code.back() != ']')
                refuseLine(line);
            axis = code.substr(1, code.size() - 2);
            if (found.table.axis.empty())
                found.table.axis = axis;
            else
                ++others;
            continue;
        }
        if (axis.empty())
            refuseLine(line);
        if (axis != found.table.axis)
            continue;
        const std::size_t first = code.find(',');
        const std::size_t second = code.find(',', first + 1);
        if (first == std::string::npos || second == std::string::npos)
            refuseLine(line);
        const double sign = deviations ? -1 : 1;
        found.table.positions.push_back(numberOf(code.substr(0, first), line));
        found.table.forward.push_back(
            rounded(sign * numberOf(code.substr(first + 1, second - first - 1), line), valueFineness));
        found.table.reverse.push_back(rounded(sign * numberOf(code.substr(second + 1), line), valueFineness));
    }
    finish(found.table);
    if (!deviations)
        found.remarks.push_back({REPORT_TEXT(
            "report", "its values are taken as nominal − actual, the formula of the maker's manual")});
    noteOthers(found, others);
    return found;
}

FoundTable readHeidenhainTable(std::string_view text) {
    constexpr double inch = 25.4;
    FoundTable found{"Heidenhain", {}, {}};
    CompensationTable &table = found.table;
    std::optional<ComColumns> columns;
    double unit = 1;
    for (const TextLine &line : linesOf(text)) {
        const std::string code = capitals(line.text);
        if (code.starts_with("BEGIN"))
            unit = code.ends_with("INCH") ? inch : 1;
        if (code.empty() || code == "[END]" || code.starts_with("BEGIN"))
            continue;
        if (!columns) {
            columns = comColumns(line.text);
            table.axis = columns->all[columns->axis].name;
            continue;
        }
        const auto cell = [&](std::size_t column) { return cellOf(line.text, columns->all, column); };
        const std::string_view forward = cell(columns->axis);
        const std::string_view back = columns->reverse ? cell(*columns->reverse) : std::string_view();
        if (forward.empty() && back.empty())
            continue; // interpolated
        const double up = forward.empty() ? 0 : numberOf(forward, line) * unit;
        const double down = back.empty() ? up : numberOf(back, line) * unit;
        table.positions.push_back(numberOf(cell(columns->position), line) * unit);
        table.forward.push_back(rounded(up, valueFineness));
        // NOLINTNEXTLINE(readability-suspicious-call-argument): they stand as they should
        table.reverse.push_back(rounded(down, valueFineness));
    }
    finish(table);
    found.remarks.push_back({REPORT_TEXT(
        "report", "its values are taken as corrections, added to the command: their sign is not public")});
    return found;
}

} // namespace palmer
