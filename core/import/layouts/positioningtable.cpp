// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/placedpass.h"
#include "import/layouts/tablereading.h"

#include "document/place.h"
#include "kernel/evaluation/edition.h"
#include "tables/contenterror.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// True for 1, 2, 3 … or 1, 1, 2, 2 …: run numbers, not positions.
bool areNumbersOfRuns(std::span<const double> values) {
    double last = 0;
    for (const double value : values) {
        if (value != last && value != last + 1 && value != 1)
            return false;
        last = value;
    }
    return !values.empty() && values.front() == 1 && last >= 1;
}

std::vector<double> numbersOf(const TableReading &reading, std::uint32_t row) {
    std::vector<double> numbers;
    for (const TableCell &cell : reading.table().cells(reading.row(row))) {
        if (cell.isNumber())
            numbers.push_back(cell.value);
    }
    return numbers;
}

/// The words of a line before its first number.
HeadingWords labelOf(const TableReading &reading, std::uint32_t row) {
    std::string label;
    for (const TableCell &cell : reading.table().cells(reading.row(row))) {
        if (cell.isNumber())
            break;
        label += ' ' + std::string(reading.table().text(cell));
    }
    return readHeading(label);
}

/// True if the first line is headed as targets or runs and the others name their run: "Run; 0; 100" above "1
/// ↑; 1.2; 0.7".
bool hasLabelledRuns(const TableReading &reading) {
    const auto &rows = reading.body.blocks.front().rows;
    if (reading.body.blocks.size() != 1 || rows.size() < 2 || reading.body.numberColumns().front() == 0)
        return false;
    const HeadingWords first = labelOf(reading, rows.front());
    const std::vector<double> numbers = numbersOf(reading, rows.front());
    if (first.words == 0 || first.direction || first.number || numbers.size() < 2 ||
        !isStrictlyMonotone(numbers))
        return false;
    std::size_t named = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const HeadingWords label = labelOf(reading, rows[i]);
        named += label.direction || label.number || label.hint ? 1 : 0;
    }
    return 2 * named >= rows.size() - 1;
}

/// Without headings: the first line ascends like targets and the first column does not.
bool looksLikeRunsDown(const TableReading &reading) {
    const TableBody &body = reading.body;
    if (body.blocks.size() != 1 || !body.columnHeads.empty() || body.blocks.front().rows.size() < 2)
        return false;
    const std::vector<double> column = reading.valuesOf(body.numberColumns().front());
    const std::vector<double> first = numbersOf(reading, body.blocks.front().rows.front());
    return first.size() > 2 && isStrictlyMonotone(first) && !isStrictlyMonotone(column);
}

std::string resolveLayout(TableReading &reading) {
    const TableBody &body = reading.body;
    const auto head = body.blocks.front().numericHead;
    std::string found = body.columnOf(ColumnKind::directions) ? "list" : "targetsDown";
    Origin origin = Origin::recognised;
    if (body.blocks.front().directionHead) {
        found = "runsDown";
    } else if (head) {
        const std::vector<double> numbers = numbersOf(reading, *head);
        if (!areNumbersOfRuns(numbers) && isStrictlyMonotone(numbers))
            found = "runsDown";
    } else if (hasLabelledRuns(reading)) {
        found = "runsDown";
    } else if (!body.columnOf(ColumnKind::directions) && !reading.choices.isChosen("columns") &&
               looksLikeRunsDown(reading)) {
        found = "runsDown";
        origin = Origin::guessed;
    }
    const auto choice = reading.choices.resolve("layout", found, origin);
    if (choice.value != "targetsDown" && choice.value != "runsDown" && choice.value != "list")
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for a positioning test"), nameOfChoice("layout"),
                      nameOfWord("layout", choice.value));
    if (choice.origin == Origin::guessed)
        reading.remarks.assumption("layout", REPORT_TEXT("report", "Layout: the first line is read as the "
                                                                   "targets, each further one as a run."));
    return choice.value;
}

/// The axis named by the headings of all columns read; 0 if there is none, or several. A, B and V are letters
/// of directions, too.
char axisOfHeadings(const TableReading &reading) {
    char axis = 0;
    for (const ImportColumn &column : reading.result.columns) {
        const char named = column.role == ColumnRole::ignored ? '\0' : readHeading(column.heading).axis;
        if (named == 0 || std::string_view("XYZUW").find(named) == std::string_view::npos)
            continue;
        if (axis != 0 && named != axis)
            return 0;
        axis = named;
    }
    return axis;
}

std::string axisName(TableReading &reading) {
    if (!reading.axisFound.empty())
        return reading.axisFound;
    const std::string &noted = reading.notes.axis;
    if (const char headed = axisOfHeadings(reading); !noted.empty() && headed != 0 && noted[0] != headed)
        reading.remarks
            .problem(
                "axis",
                REPORT_TEXT("report", "Axis: a line of the file names %1, the headings %2; %1 is taken."),
                noted, std::string(1, headed))
            .answers = {noted, std::string(1, headed)};
    if (!noted.empty())
        return noted;
    // "X (mm)": a target column named after the axis.
    for (const TableColumn &column : reading.body.columns) {
        std::string bare = withoutUnit(column.heading);
        if (bare.size() == 1 && std::string_view("XYZABCUVW").find(bare[0]) != std::string_view::npos &&
            column.meaning != Meaning::statistic)
            return bare;
    }
    return {};
}

void colour(const std::vector<PlacedPass> &passes, TableReading &reading) {
    for (const PlacedPass &placed : passes) {
        for (const std::uint32_t cell : placed.cells)
            reading.result.roles[cell] =
                *placed.direction == Direction::positive ? CellRole::positive : CellRole::negative;
    }
}

/// The sign stated in the headings or in the lines around the table.
SaidSign signOf(const TableReading &reading) {
    for (const TableColumn &column : reading.body.columns) {
        if (SaidSign said = saidSign(column.heading); !said.sign.empty())
            return said;
    }
    for (const ImportColumn &column : reading.result.columns) {
        if (std::string words = unclearDifference(column.heading); column.hasReadings() && !words.empty())
            return {{}, std::move(words)};
    }
    return reading.notes.sign;
}

/// True for "Korrektur", "correction", "correzione": values to be added, with the opposite sign.
bool namesCorrection(const TableReading &reading) {
    return std::ranges::any_of(reading.result.columns, [](const ImportColumn &column) {
        const std::string low = folded(column.heading);
        return column.hasReadings() &&
               (low.find("correc") != std::string::npos || low.find("correzion") != std::string::npos ||
                low.find("korrekt") != std::string::npos);
    });
}

} // namespace

std::string otherQuantity(std::string_view text) {
    constexpr std::array<std::string_view, 29> words{"straightness",
                                                     "squareness",
                                                     "flatness",
                                                     "yaw",
                                                     "geradheit",
                                                     "rechtwinkligkeit",
                                                     "ebenheit",
                                                     "gieren",
                                                     "nicken",
                                                     "rectitude",
                                                     "perpendicularite",
                                                     "planeite",
                                                     "lacet",
                                                     "tangage",
                                                     "roulis",
                                                     "rettilineita",
                                                     "perpendicolarita",
                                                     "planarita",
                                                     "imbardata",
                                                     "beccheggio",
                                                     "rollio",
                                                     "rectitud",
                                                     "perpendicularidad",
                                                     "planitud",
                                                     "guinada",
                                                     "cabeceo",
                                                     "lag error",
                                                     "following error",
                                                     "schleppfehler"};
    const std::string low = folded(text.substr(0, 500));
    const auto isLetter = [&](std::size_t i) {
        return i < low.size() && ((low[i] >= 'a' && low[i] <= 'z') || (low[i] & '\x80') != 0);
    };
    for (const std::string_view word : words) {
        const std::size_t at = low.find(word);
        if (at != std::string::npos && !isLetter(at + word.size()) && (at == 0 || !isLetter(at - 1)))
            return std::string(word);
    }
    return {};
}

namespace {

void askForOtherQuantity(TableReading &reading) {
    std::vector<std::uint32_t> rows = reading.body.notes;
    rows.insert(rows.end(), reading.body.columnHeads.begin(), reading.body.columnHeads.end());
    for (const std::uint32_t row : rows) {
        if (const std::string word = otherQuantity(reading.textOf(row)); !word.empty()) {
            reading.remarks.problem(
                {"kind", reading.row(row).line},
                REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a positioning test."), word);
            return;
        }
    }
}

/// "Unit: inch", "All values x 10" beside headings in mm and µm; "Unit: mm" is the unit of one of them.
void askForOtherUnit(const FoundPasses &found, TableReading &reading) {
    const SaidUnit &noted = reading.notes.unit;
    const bool isSize =
        !noted.unit || noted.unit->kind == UnitKind::length || noted.unit->kind == UnitKind::angle;
    const Unit *unit = noted.unit || !reading.notes.factor.empty() ? noted.unit : unitIn(noted.foreign);
    if (found.unit.unit && noted.isSaid() && isSize && unit != found.unit.unit &&
        (!unit || unit != found.positionUnit.unit))
        reading.remarks.problem("unit",
                                REPORT_TEXT("report", "Unit: a line says “%1”, the headings %2; read in %2."),
                                excerpt(noted.words()), std::string(found.unit.unit->sign));
}

bool hasReading(const PlacedPass &placed) {
    return !std::ranges::all_of(placed.pass.readings, &PassReading::isMissing);
}

/// Points and commas are mixed, so that one of them leaves no pair of target and reading.
[[noreturn]] void refuseUnreadNumbers(const TableReading &reading) {
    for (const TableBlock &block : reading.body.blocks) {
        for (const std::uint32_t row : block.rows) {
            const auto cells = reading.table().cells(reading.row(row));
            const auto cell = std::ranges::find(cells, CellKind::grouped, &TableCell::kind);
            if (cell != cells.end())
                refuseContentAt(placeOfLine(reading.row(row).line),
                                REPORT_TEXT("report",
                                            "“%1” has another decimal mark than other numbers of the table, "
                                            "or thousands separators; write all with one decimal mark"),
                                excerpt(reading.table().text(*cell)));
        }
    }
    refuseWithoutReadings();
}

} // namespace

void readPositioning(TableReading &reading) {
    const std::string layout = resolveLayout(reading);
    FoundPasses found = layout == "runsDown" ? readRunsDown(reading) : readTargetsDown(reading);
    if (std::ranges::none_of(found.passes, hasReading))
        refuseUnreadNumbers(reading);
    askForOtherQuantity(reading);
    askForOtherUnit(found, reading);
    if (!reading.notes.days.empty())
        reading.remarks.problem("columns",
                                REPORT_TEXT("report",
                                            "Columns: they are of several days (%1); all runs are read "
                                            "as those of one test."),
                                excerpt(reading.notes.days));
    resolveDirections(found, reading);
    colour(found.passes, reading);
    std::vector<Pass> passes = inOrder(std::move(found.passes), reading);
    // "Unit: µm" above positions belongs to something else, so the unit is asked.
    const SaidUnit &noted = reading.notes.unit;
    const bool isTooSmall = noted.unit && noted.unit->toBase(1) < 1 && arePositions(passes);
    const SaidUnit unit = found.unit.isSaid() || isTooSmall ? found.unit : noted;
    const PassForm form =
        resolveForm(passes,
                    {found.content, found.sign, unit,
                     found.positionUnit.isSaid() ? found.positionUnit : reading.notes.positionUnit,
                     signOf(reading), namesCorrection(reading)},
                    reading.choices, reading.result.remarks);
    reading.result.test = testFrom(measurementOf(std::move(passes), form, reading.result.remarks),
                                   axisName(reading), reading.choices, reading.notes.edition);
    reading.result.test->role = reading.stateFound;
}

} // namespace palmer
