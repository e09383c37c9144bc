// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/arctable.h"

#include "document/documenterror.h"
#include "editing/pastedtable.h"
#include "import/doubts.h"
#include "import/layouts/arcs.h"
#include "import/layouts/tablebody.h"
#include "kernel/words/shortest.h"
#include "tables/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr std::array layouts{"angleDeviation", "angleRadius", "xy"}; // in the order of ArcContent
constexpr std::array marks{"point", "comma"};                        // in the order of DecimalMark

/// Headings count, numbers decide: one column of them.
bool isOneColumn(const TableBody &body) {
    return body.numberColumns().size() == 1;
}

/// The double of the decimal that was written: a change of unit may miss it by the last bit, which a table
/// that shows all digits would tell.
void tidy(std::vector<double> &values) {
    constexpr double grid = 1e10; // finer than anybody writes millimetres or degrees
    constexpr double lastBits = 4 * std::numeric_limits<double>::epsilon();
    for (double &value : values) {
        const double decimal = std::round(value * grid) / grid;
        if (std::abs(decimal - value) <= lastBits * std::abs(value))
            value = decimal;
    }
}

void giveSense(Arc &arc, Sense sense) {
    if (arc.sense == sense)
        return;
    std::ranges::reverse(arc.angles);
    std::ranges::reverse(arc.radialDeviations);
    arc.sense = sense;
}

/// Throws where a line has none: the angles of the others would be wrong.
std::vector<double> numbersOf(const CellTable &table, const TableBody &body, std::size_t column) {
    std::vector<double> numbers;
    std::size_t missing = 0;
    for (const TableBlock &block : body.blocks) {
        for (const std::uint32_t row : block.rows) {
            const auto cells = table.cells(table.rows()[row]);
            if (column < cells.size() && cells[column].isNumber())
                numbers.push_back(cells[column].value);
            else
                ++missing;
        }
    }
    if (missing > 0)
        throw Error(Error::Kind::content,
                    {REPORT_TEXT_COUNTED("report",
                                         "%n line(s) without a number: without angles every point is needed"),
                     {},
                     static_cast<int>(missing)});
    return numbers;
}

ArcTable readDeviations(const CellTable &table, const TableBody &body, const CircularMeasurement &circle,
                        const ArcTableChoices &choices) {
    ArcTable result;
    result.content = {ArcContent::deviations,
                      choices.content == ArcContent::deviations ? Origin::chosen : Origin::recognised};
    result.decimalMark = table.decimalMark;
    const std::size_t column = body.numberColumns().front();
    Arc arc;
    arc.radialDeviations = numbersOf(table, body, column);
    const Unit *stated = body.columns[column].unit;
    const double size = std::ranges::max(arc.radialDeviations, {}, [](double v) { return std::abs(v); });
    constexpr double smallestInMicrometres = 0.5;
    result.unit = {stated && stated->kind == UnitKind::length ? stated->word
                   : std::abs(size) < smallestInMicrometres   ? "mm"
                                                              : "um",
                   stated ? Origin::recognised : Origin::guessed};
    if (choices.unit)
        result.unit = {*choices.unit, Origin::chosen};
    const Unit *unit = unitOf(result.unit.value);
    if (!unit || unit->kind != UnitKind::length)
        throw Error(Error::Kind::content, {REPORT_TEXT("report", "%1 cannot be %2 for a circular test"),
                                           {"unit", result.unit.value}});
    if (result.unit.origin == Origin::guessed)
        result.remarks.push_back(
            {RemarkGrade::assumption,
             {REPORT_TEXT("report",
                          "Unit of the radial deviations: nothing in the file says it; read as %1."),
              {std::string(unit->sign)}},
             0,
             0,
             "unit"});
    for (double &deviation : arc.radialDeviations)
        deviation = unit->toBase(deviation);
    tidy(arc.radialDeviations);
    arc.sense = choices.sense.value_or(Sense::counterclockwise);
    arc.angleReference = choices.angleReference;
    const double way = arc.sense == Sense::counterclockwise ? choices.arc : -choices.arc;
    const std::size_t count = arc.radialDeviations.size();
    for (std::size_t i = 0; i < count; ++i)
        arc.angles.push_back(count == 1 ? choices.startAngle
                                        : choices.startAngle +
                                              way * static_cast<double>(i) / static_cast<double>(count - 1));
    result.remarks.push_back(
        {RemarkGrade::assumption,
         {REPORT_TEXT("report", "No angles: the points are put at equal steps from %1 to %2."),
          {Number{arc.angles.front(), Quantity::angle}, Number{arc.angles.back(), Quantity::angle}}},
         0,
         0,
         "startAngle"});
    if (!choices.sense)
        result.remarks.push_back(
            {RemarkGrade::assumption,
             {REPORT_TEXT("report", "Sense: nothing in the table says it; taken as anticlockwise.")},
             0,
             0,
             "sense"});
    result.points = count;
    result.arcs.push_back(std::move(arc));
    Test test;
    CircularMeasurement measurement = circle;
    measurement.arcs = result.arcs;
    test.measurement = std::move(measurement);
    questionNumbers(test, result.remarks);
    ImportOptions answers = choices.answers;
    answers.insert({"startAngle", {}}); // start and extent are stated
    const std::array<ImportChoice, 1> guessed{ImportChoice{"unit", result.unit.value, result.unit.origin}};
    result.questions = takeQuestions(result.remarks, answers, guessed);
    return result;
}

} // namespace

ArcTable readArcTable(const std::string &text, const CircularMeasurement &circle,
                      const ArcTableChoices &choices) {
    TableOptions tableOptions;
    tableOptions.decimalMark = choices.decimalMark;
    const CellTable table = readTable(text, tableOptions);
    const TableBody body = bodyOf(table);
    if (choices.content == ArcContent::deviations || (!choices.content && isOneColumn(body)))
        return readDeviations(table, body, circle, choices);

    // The test says already what a file would have to say.
    ImportOptions options{
        {"kind", "circular"},
        {"plane", "XY"},
        {"nominalRadius", shortest(circle.nominalRadius)},
        {"angleReference", choices.angleReference == AngleReference::polar ? "polar" : "commanded"},
        {"sign", "actualMinusTarget"}};
    options.insert(choices.answers.begin(), choices.answers.end());
    if (choices.content)
        options["layout"] = layouts.at(static_cast<std::size_t>(*choices.content));
    if (choices.decimalMark)
        options["decimalMark"] = marks.at(static_cast<std::size_t>(*choices.decimalMark));
    if (choices.unit)
        options["unit"] = *choices.unit;
    Imported imported = readPastedTable(text, options);
    ArcTable result;
    result.arcs = std::move(std::get<CircularMeasurement>(imported.test->measurement).arcs);
    for (Arc &arc : result.arcs) {
        arc.angleReference = choices.angleReference;
        tidy(arc.angles);
        tidy(arc.radialDeviations);
        result.points += arc.angles.size();
        if (choices.sense)
            giveSense(arc, *choices.sense);
    }
    result.decimalMark = imported.table.decimalMark;
    for (const ImportChoice &choice : imported.choices) {
        if (choice.key == "unit")
            result.unit = {choice.value, choice.origin};
        const auto *const layout = std::ranges::find(layouts, choice.value);
        if (choice.key == "layout" && layout != layouts.end())
            result.content = {static_cast<ArcContent>(layout - layouts.begin()), choice.origin};
    }
    result.remarks = std::move(imported.remarks);
    result.questions = std::move(imported.questions);
    return result;
}

} // namespace palmer
