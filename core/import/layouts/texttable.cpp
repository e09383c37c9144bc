// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/filewords.h"
#include "document/place.h"
#include "import/layouts/arcs.h"
#include "import/layouts/tablebody.h"
#include "import/layouts/tablereading.h"
#include "kernel/measurement/testfacts.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/decodetext.h"
#include "tables/richtext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace palmer {

namespace {

/// Resolves a choice among words whose rows are in the order of an enumeration.
template <class Enumeration>
std::optional<Enumeration> chosenOf(const char *key, const Choices &choices) {
    const auto words = findImportKey(key)->words;
    const auto found =
        std::ranges::find_if(words, [&](const ImportWord &each) { return choices.chosen(key) == each.word; });
    return found == words.end() ? std::nullopt
                                : std::optional(static_cast<Enumeration>(found - words.begin()));
}

template <class Enumeration>
void resolveWord(const char *key, const Choice<Enumeration> &found, Choices &choices) {
    choices.resolve(key, findImportKey(key)->words[static_cast<std::size_t>(found.value)].word, found.origin);
}

/// Temperatures or a drift, if a column has times. Without a keyword a log of positions is more likely.
std::string seriesKindOf(const TableBody &body, Origin &origin) {
    const bool temperature = body.anyColumn(&TableColumn::isTemperature);
    const bool readings = body.anyColumn([](const TableColumn &column) {
        return column.isIn(UnitKind::length) || column.isIn(UnitKind::angle) ||
               isOneOf(column.meaning,
                       {Meaning::deviation, Meaning::actual, Meaning::reading, Meaning::place});
    });
    if (!temperature && !readings)
        origin = Origin::guessed;
    return temperature && !readings ? "temperatures" : "drift";
}

/// True for a direction of approach, but not for a sense of rotation.
bool saysDirection(const TableColumn &column) {
    return column.words.direction.has_value() && !senseIn(column.heading);
}

/// True for arrows or words for the directions of an axis, or angular deviations: angles are then targets.
bool isApproached(const TableBody &body) {
    return body.columnOf(ColumnKind::directions) || body.anyColumn([](const TableColumn &column) {
        const bool isReading =
            column.meaning == Meaning::deviation || column.words.namesSense || column.words.isActual;
        return (isReading && column.isIn(UnitKind::angle)) ||
               (column.words.isTarget && column.meaning != Meaning::nominal) || saysDirection(column);
    });
}

bool hasTimes(const TableBody &body) {
    return body.anyColumn([](const TableColumn &column) {
        return column.kind == ColumnKind::clock || (column.isNumeric() && column.isTime());
    });
}

/// Lengths measured at angles belong to a circle, not to a rotary axis.
bool areLengthsAtAngles(const TableBody &body) {
    bool angles = false;
    bool lengths = false;
    for (const std::size_t c : body.numberColumns()) {
        const TableColumn &column = body.columns[c];
        const Meaning meaning = column.meaning;
        const bool isPlace = isOneOf(meaning, {Meaning::place, Meaning::target, Meaning::angle}) ||
                             (meaning == Meaning::unknown && !angles);
        if (isPlace && column.isIn(UnitKind::length))
            return false; // an angle next to the targets of a linear axis
        const bool isReading = !isPlace && meaning != Meaning::nominal;
        angles |= isPlace && column.isIn(UnitKind::angle);
        lengths |= isReading && column.isIn(UnitKind::length);
        if (isReading && column.isIn(UnitKind::angle))
            return false;
    }
    return angles && lengths && !body.columnOf(ColumnKind::directions);
}

/// Positions of two axes on a circle, whatever else is beside them: times, commanded positions, a third axis
/// that stands still.
bool areAxesOnCircle(const TableReading &reading) {
    const auto axes = axisColumns(reading);
    return axes && areOnCircle(reading, axes->first, axes->second);
}

/// Coordinates along two axes.
bool hasTwoAxes(const TableBody &body) {
    std::set<char> axes;
    for (const std::size_t c : body.numberColumns()) {
        if (isOneOf(body.columns[c].meaning, {Meaning::x, Meaning::y, Meaning::target, Meaning::actual}))
            axes.insert(body.columns[c].words.axis);
    }
    axes.erase(0);
    return axes.size() > 1;
}

/// True if the headings name a circle.
bool isCircular(const TableBody &body) {
    const auto has = [&](Meaning meaning) { return body.columnOf(meaning).has_value(); };
    const auto angles = body.columnOf(Meaning::angle); // with targets across, it heads a column of words
    const bool hasAngles = angles && body.columns[*angles].kind == ColumnKind::numbers;
    if (hasAngles && !(has(Meaning::run) && !has(Meaning::radius)))
        return true;
    if (has(Meaning::x) && has(Meaning::y) && !has(Meaning::deviation) && !has(Meaning::place))
        return true;
    // Planes without X: two axes and nothing else.
    std::set<char> axes;
    for (const TableColumn &column : body.columns) {
        if (column.kind == ColumnKind::numbers && column.meaning == Meaning::y)
            axes.insert(column.words.axis);
    }
    const bool isPlane =
        axes.size() == 2 && !hasTimes(body) && !has(Meaning::deviation) && !has(Meaning::place);
    const bool isAcross = body.blocks.front().numericHead.has_value(); // the senses belong to runs
    return isPlane || (body.columnOf(ColumnKind::senses) && !isAcross);
}

/// True if the numbers could be angles in degrees of a circle or a large part of one.
bool couldBeAngles(const TableReading &reading, std::size_t column) {
    const auto [low, high] = reading.rangeOf(column);
    return high - low >= 85 && high - low <= 800 && high <= 800 && low >= -800;
}

/// True if consecutive numbers of a column differ.
bool moves(const TableReading &reading, std::size_t column) {
    std::optional<double> last;
    for (const TableBlock &block : reading.body.blocks) {
        for (const std::uint32_t row : block.rows) {
            const auto value = reading.numberAt(row, column);
            if (!value || value == last)
                return false;
            last = value;
        }
    }
    return true;
}

/// True for a radius, a sense or the words of a circle.
bool saysCircle(const TableReading &reading) {
    const TableBody &body = reading.body;
    const auto namesSense = [](const TableColumn &column) { return senseIn(column.heading).has_value(); };
    return reading.notes.radius || body.has(Meaning::radius) || body.has(Meaning::nominal) ||
           body.columnOf(ColumnKind::senses) || (body.has(Meaning::angle) && isCircular(body)) ||
           body.anyColumn(namesSense);
}

/// True if the user chose the target column.
bool choosesTargets(const Choices &choices) {
    const auto columns = palmer::columnsOf(choices.chosen("columns"));
    return columns && columnOf(*columns, ColumnRole::target);
}

constexpr std::size_t fewPoints = 30;

/// Columns of numbers other than times and a counter.
std::vector<std::size_t> bareColumns(const TableReading &reading) {
    std::vector<std::size_t> data = reading.body.numberColumns();
    std::erase_if(data, [&](std::size_t c) { return reading.body.columns[c].isTime(); });
    if (data.size() == 3 && isCounter(reading, data.front()))
        data.erase(data.begin());
    return data;
}

/// Two columns that no word tells apart, on a circle: "Time; XPOS; YPOS".
bool areUnnamedOnCircle(const TableReading &reading) {
    const std::vector<std::size_t> data = bareColumns(reading);
    return data.size() == 2 && reading.body.rowCount() >= fewPoints &&
           areOnCircle(reading, data[0], data[1]) && std::ranges::all_of(data, [&](std::size_t c) {
               return reading.body.columns[c].meaning == Meaning::unknown;
           });
}

/// Two columns without words, or three with a counter: points of a circle, if there are many.
std::string kindOfBareNumbers(const TableReading &reading, Origin &origin) {
    const std::vector<std::size_t> data = bareColumns(reading);
    if (data.size() != 2 || reading.body.rowCount() < fewPoints)
        return "positioning";
    origin = Origin::guessed;
    return areOnCircle(reading, data[0], data[1]) || couldBeAngles(reading, data[0]) ? "circular"
                                                                                     : "positioning";
}

/// Deviations without places, as they are below the radius of a circle.
bool areDeviationsAlone(const TableBody &body) {
    const auto is = [](const TableColumn &column) {
        return column.isNumeric() && !column.isTime() && !column.isTemperature() &&
               (column.meaning == Meaning::deviation || senseIn(column.heading));
    };
    return body.anyColumn(is) && !body.has(Meaning::place) && !body.has(Meaning::target) &&
           !body.has(Meaning::direction) && !body.blocks.front().numericHead;
}

/// The kind of measurement indicated by the columns.
std::string kindOf(const TableReading &reading, Origin &origin) {
    const TableBody &body = reading.body;
    origin = Origin::recognised;
    const auto has = [&](Meaning meaning) { return body.has(meaning); };
    if (choosesTargets(reading.choices))
        return "positioning";
    if (areLengthsAtAngles(body) && !body.anyColumn(saysDirection)) {
        origin = saysCircle(reading) ? Origin::recognised : Origin::guessed;
        return "circular";
    }
    if (reading.notes.radius && hasTwoAxes(body))
        return "circular";
    if (areAxesOnCircle(reading))
        return "circular";
    if (isApproached(body))
        return "positioning";
    if (reading.notes.radius && areDeviationsAlone(body))
        return "circular";
    const bool positions = has(Meaning::run) || has(Meaning::direction);
    // X and Y over time with temperatures beside them drift; they are no path.
    if (hasTimes(body) && !positions &&
        body.anyColumn([](const TableColumn &c) { return c.isTemperature(); }))
        return seriesKindOf(body, origin);
    if (isCircular(body))
        return "circular";
    if (areUnnamedOnCircle(reading)) {
        origin = Origin::guessed;
        return "circular";
    }
    // A place next to a measured value is a target, even with clock times.
    const bool placed = has(Meaning::place) && (!body.columnOf(ColumnKind::clock) || has(Meaning::actual));
    if (hasTimes(body) && !positions && !placed) {
        // Places and deviations with the time of day: a pass, or a series at one place.
        const bool isEither = has(Meaning::place) && has(Meaning::deviation);
        const bool goesOn = isEither && moves(reading, *body.columnOf(Meaning::place));
        const std::string series = seriesKindOf(body, origin);
        origin = isEither ? Origin::guessed : origin;
        return goesOn ? "positioning" : series;
    }
    if (positions || has(Meaning::place) || has(Meaning::angle) || body.blocks.front().numericHead)
        return "positioning";
    return kindOfBareNumbers(reading, origin);
}

/// "38-58"
void keepLines(CellTable &table, std::string_view lines) {
    const std::size_t dash = lines.find_first_of("-–");
    const auto numberIn = [](std::string_view text) {
        const LeadingNumber number = leadingNumber(withoutBlanks(text), DecimalMark::point);
        return number.size > 0 && number.size == withoutBlanks(text).size() && number.value >= 1 &&
                       number.value < 1e9
                   ? static_cast<std::size_t>(number.value)
                   : 0;
    };
    const std::size_t first = numberIn(lines.substr(0, dash));
    const std::size_t last = dash == std::string_view::npos ? 0 : numberIn(lines.substr(dash + 1));
    if (first == 0 || last < first)
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; expected lines as 38-58"),
                      nameOfChoice("lines"), std::string(lines));
    table.keepLines(first, last);
}

} // namespace

std::string decodedText(QByteArrayView bytes, Choices &choices, Imported &imported) {
    DecodedText decoded = decodeText(bytes, chosenOf<Encoding>("encoding", choices));
    resolveWord("encoding", decoded.encoding, choices);
    if (decoded.encoding.origin == Origin::guessed)
        imported.remarks.assumption(
            "encoding",
            decoded.encoding.value == Encoding::gb18030
                ? REPORT_TEXT("report", "Encoding: the text is not UTF-8; read as Chinese (GB18030).")
                : REPORT_TEXT("report", "Encoding: the text is not UTF-8; read as Windows-1252."));
    return std::move(decoded.text);
}

void takeDate(const std::optional<std::string> &date, const std::string &text, Test &test, Remarks &remarks) {
    if (date && !test.date) {
        test.date = date;
        test.time = timeOfDay(text);
    }
    if (test.date || text.empty())
        return;
    test.remarks = text;
    remarks.note({},
                 hasTwoReadings(text)
                     ? REPORT_TEXT("report", "The date %1 can be read in several ways; it stays as text in "
                                             "the remarks.")
                     : REPORT_TEXT("report", "The date %1 is not one that is known; it stays as text in the "
                                             "remarks."),
                 text);
}

namespace {

/// A factor in a line, and a unit in the headings of readings that are no positioning test.
void askForFactor(const TableReading &reading) {
    for (const ImportColumn &column : reading.result.columns) {
        constexpr std::array ofReadings{ColumnRole::deviation, ColumnRole::radius, ColumnRole::x,
                                        ColumnRole::y};
        if (!reading.notes.factor.empty() && column.unit &&
            std::ranges::find(ofReadings, column.role) != ofReadings.end())
            return (void)reading.remarks.problem(
                "unit", REPORT_TEXT("report", "Unit: a line says “%1”, the headings %2; read in %2."),
                excerpt(reading.notes.factor), std::string(column.unit->sign));
    }
}

} // namespace

void readMeasurementTable(Choices &choices, Imported &imported, const std::vector<CoverSheet> &covers) {
    if (choices.isChosen("lines"))
        keepLines(imported.table, choices.resolve("lines", {}, Origin::chosen).value);
    setColumnsAside(imported.table);
    imported.table.takeNumbersBehind([](std::string_view word) {
        const HeadingWords heading = readHeading(word);
        return isOneOf(heading.meaning, {Meaning::target, Meaning::place}) && heading.unknownWords == 0;
    });
    imported.table.takeUnits();
    setStatementsAside(imported.table);
    TableReading reading(imported, choices, covers);
    Origin origin = Origin::recognised;
    const std::string found = kindOf(reading, origin);
    const auto kind = choices.resolve("kind", found, origin);
    if (kind.origin == Origin::guessed)
        reading.remarks.assumption(
            "kind",
            kind.value == "circular"
                ? REPORT_TEXT("report", "Kind: nothing in the file says it; read as a circular test.")
            : kind.value == "drift"
                ? REPORT_TEXT("report", "Kind: nothing in the file says it; read as a drift test.")
                : REPORT_TEXT("report", "Kind: nothing in the file says it; read as a positioning test."));
    switch (ofFileWord<Kind>(kind.value).value_or(Kind::drift)) { // else temperatures
    case Kind::positioning:
        readPositioning(reading);
        break;
    case Kind::circular:
        readCircles(reading);
        askForFactor(reading);
        break;
    case Kind::drift:
        readSeries(reading, kind.value == "temperatures");
        askForFactor(reading);
        break;
    }
    takeNotes(reading.notes, imported);
}

void takeNotes(const FileNotes &notes, Imported &imported) {
    const auto fill = [](std::string &field, const std::string &value) {
        if (field.empty())
            field = value;
    };
    fill(imported.machine.name, notes.machine);
    fill(imported.machine.serialNumber, notes.serialNumber);
    fill(imported.operatorName, notes.operatorName);
    if (imported.test) {
        Test &test = *imported.test;
        imported.sensors.insert(imported.sensors.end(), notes.sensors.begin(), notes.sensors.end());
        takeDate(notes.date, notes.dateText, test, imported.remarks);
        if (!test.time)
            test.time = notes.time;
        if (auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement)) {
            PositioningConditions &conditions = measurement->conditions;
            if (!conditions.airPressure)
                conditions.airPressure = notes.airPressure;
            if (!conditions.airHumidity)
                conditions.airHumidity = notes.airHumidity;
            if (!conditions.feed && measurement->axis.motion == Motion::linear)
                conditions.feed = notes.feed;
        }
        if (Conditions *conditions = conditionsOf(test); conditions && notes.isCorrectedTo20)
            conditions->correctionTo20 =
                *notes.isCorrectedTo20 ? CorrectionTo20::appliedByInstrument : CorrectionTo20::notApplied;
    }
    for (const auto &[line, text] : notes.doubts)
        imported.remarks.problem(
            "statement", REPORT_TEXT("report", "Line %1 says “%2”: are the readings right as they stand?"),
            std::to_string(line), text);
    notes.used.remarkUsed(imported.remarks);
    notes.unused.remarkUnused(imported.remarks);
}

namespace {

bool isAnything(QByteArrayView) {
    return true;
}

void readTextTable(const ImportSource &source, Choices &choices, Imported &imported) {
    std::string text = decodedText(source.bytes, choices, imported);
    if (text.starts_with("{\\rtf"))
        text = textOfRtf(text);
    text = textOfLatex(std::move(text));
    imported.table = readTable(std::move(text), {chosenOf<Delimiter>("delimiter", choices),
                                                 chosenOf<DecimalMark>("decimalMark", choices)});
    const CellTable &table = imported.table;
    resolveWord("delimiter", table.delimiter, choices);
    resolveWord("decimalMark", table.decimalMark, choices);
    if (table.decimalMark.origin == Origin::guessed || table.delimiter.origin == Origin::guessed)
        imported.remarks.add(table.isFormDoubtful ? RemarkGrade::problem : RemarkGrade::assumption,
                             "decimalMark",
                             {table.decimalMark.value == DecimalMark::comma
                                  ? REPORT_TEXT("report", "Decimal mark: the numbers can be read in several "
                                                          "ways; the comma is taken as decimal mark.")
                                  : REPORT_TEXT("report", "Decimal mark: the numbers can be read in several "
                                                          "ways; the point is taken as decimal mark."),
                              {}});
    readMeasurementTable(choices, imported);
}

} // namespace

const ImportFormat tableFormat{"table", REPORT_TEXT("report", "table"), "csv tsv txt", isAnything,
                               readTextTable};

} // namespace palmer
