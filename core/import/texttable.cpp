#include "import/readers.h"

#include "document/documenterror.h"
#include "import/decodetext.h"
#include "import/tablereading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr std::array encodings{"UTF-8", "UTF-16LE", "UTF-16BE", "Windows-1252"};
constexpr std::array delimiters{"tab", "semicolon", "comma", "bar", "blanks"};
constexpr std::array marks{"point", "comma"};

template <class Enumeration, std::size_t size>
std::optional<Enumeration> chosenOf(const std::array<const char *, size> &words, std::string_view word) {
    for (std::size_t i = 0; i < size; ++i) {
        if (words[i] == word)
            return static_cast<Enumeration>(i);
    }
    return {};
}

/// Kind of measurement that the columns show.
std::string kindOf(const TableReading &reading, Origin &origin) {
    const TableBody &body = reading.body;
    origin = Origin::recognised;
    const std::vector<std::size_t> columns = body.numberColumns();
    const auto angle = body.columnOf(Meaning::angle);
    // Arrows and words for the directions of an axis: angles are those of its targets.
    const bool approached = std::ranges::any_of(body.columns, [](const TableColumn &column) {
        return directionInHeading(column.heading, false).has_value() && !senseIn(column.heading);
    });
    if (approached || body.columnOf(ColumnKind::directions))
        return "positioning";
    if (angle ||
        (body.columnOf(Meaning::x) && body.columnOf(Meaning::y) && !body.columnOf(Meaning::deviation)))
        return "circular";
    if (body.columnOf(ColumnKind::senses))
        return "circular";
    const auto time = body.columnOf(Meaning::time);
    const bool positions = body.columnOf(Meaning::target) || body.columnOf(Meaning::run) ||
                           body.columnOf(Meaning::direction) || body.columnOf(ColumnKind::directions);
    const auto isTemperature = [](const TableColumn &column) {
        return column.meaning == Meaning::temperature ||
               (column.unit && column.unit->kind == UnitKind::temperature);
    };
    const bool temperature = std::ranges::any_of(body.columns, isTemperature);
    if (body.columnOf(ColumnKind::clock) && !positions)
        return temperature || !body.columnOf(Meaning::deviation) ? "temperatures" : "drift";
    if (!columns.empty() && body.columns[columns.front()].unit &&
        body.columns[columns.front()].unit->kind == UnitKind::time)
        return temperature ? "temperatures" : "drift";
    if (time && *time == columns.front() && !positions)
        return temperature ? "temperatures" : "drift";
    if (positions || body.blocks.front().numericHead)
        return "positioning";
    // Two columns without a word (three with a counter): points of a circle, if they are many.
    std::vector<std::size_t> data = columns;
    if (data.size() == 3 && isCounter(reading, data.front()))
        data.erase(data.begin());
    constexpr std::size_t fewPoints = 30;
    if (data.size() == 2 && body.rowCount() >= fewPoints) {
        origin = Origin::guessed;
        if (areOnCircle(reading, data[0], data[1]))
            return "circular";
        double low = INFINITY;
        double high = -INFINITY;
        for (const TableBlock &block : body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const TableCell *cell = reading.cell(row, data[0]);
                if (cell && cell->isNumber()) {
                    low = std::min(low, cell->value);
                    high = std::max(high, cell->value);
                }
            }
        }
        if (high - low >= 85 && high - low <= 800 && high <= 800 && low >= -800)
            return "circular";
    }
    return "positioning";
}

} // namespace

bool isAnything(QByteArrayView) {
    return true;
}

void readMeasurementTable(Choices &choices, Imported &imported) {
    TableReading reading(imported, choices);
    Origin origin = Origin::recognised;
    const std::string found = kindOf(reading, origin);
    const auto kind = choices.settle("kind", found, origin);
    if (kind.origin == Origin::guessed)
        reading.remark(
            RemarkGrade::assumption,
            {kind.value == "circular"
                 ? REPORT_TEXT("report", "Kind: nothing in the file says it; read as a circular test.")
                 : REPORT_TEXT("report", "Kind: nothing in the file says it; read as a positioning test.")},
            0, "kind");
    if (kind.value == "circular")
        readCircles(reading);
    else if (kind.value == "positioning")
        readPositioning(reading);
    else
        readSeries(reading, kind.value == "temperatures");
    const FileNotes &notes = reading.notes;
    imported.machine.name = notes.machine;
    imported.machine.serialNumber = notes.serialNumber;
    imported.operatorName = notes.operatorName;
    if (imported.test) {
        imported.test->date = notes.date;
        if (!notes.dateText.empty()) {
            imported.test->remarks = notes.dateText;
            reading.remark(
                RemarkGrade::note,
                {REPORT_TEXT("report", "The date %1 is no ISO date; it stays as text in the remarks."),
                 {notes.dateText}});
        }
    }
    if (notes.ignored > 0)
        reading.remark(RemarkGrade::note, {REPORT_TEXT("report", "Lines of text that were not used: %1."),
                                           {Number{static_cast<double>(notes.ignored), Quantity::count}}});
}

void readTextTable(const ImportSource &source, Choices &choices, Imported &imported) {
    DecodedText decoded = decodeText(source.bytes, chosenOf<Encoding>(encodings, choices.chosen("encoding")));
    choices.settle("encoding", encodings[static_cast<std::size_t>(decoded.encoding.value)],
                   decoded.encoding.origin);
    if (decoded.encoding.origin == Origin::guessed)
        imported.remarks.push_back(
            {RemarkGrade::assumption,
             {REPORT_TEXT("report", "Encoding: the text is not UTF-8; read as Windows-1252.")},
             0,
             0,
             "encoding"});
    TableOptions options;
    options.delimiter = chosenOf<Delimiter>(delimiters, choices.chosen("delimiter"));
    options.decimalMark = chosenOf<DecimalMark>(marks, choices.chosen("decimalMark"));
    imported.table = readTable(std::move(decoded.text), options);
    const CellTable &table = imported.table;
    choices.settle("delimiter", delimiters[static_cast<std::size_t>(table.delimiter.value)],
                   table.delimiter.origin);
    choices.settle("decimalMark", marks[static_cast<std::size_t>(table.decimalMark.value)],
                   table.decimalMark.origin);
    if (table.decimalMark.origin == Origin::guessed || table.delimiter.origin == Origin::guessed)
        imported.remarks.push_back(
            {RemarkGrade::assumption,
             {table.decimalMark.value == DecimalMark::comma
                  ? REPORT_TEXT("report", "Decimal mark: the numbers can be read in several ways; the comma "
                                          "is taken as decimal mark.")
                  : REPORT_TEXT("report", "Decimal mark: the numbers can be read in several ways; the point "
                                          "is taken as decimal mark.")},
             0,
             0,
             "decimalMark"});
    readMeasurementTable(choices, imported);
}

} // namespace palmer
