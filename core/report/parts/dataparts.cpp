// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "kernel/evaluation/instrumentresult.h"
#include "kernel/evaluation/targetvalue.h"
#include "language/decimals.h"
#include "language/rounding.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>

namespace palmer {

namespace {

constexpr double positionWidth = 19;
constexpr double directionsGap = 5;
constexpr double digitWidth = 1.67; ///< mm, at 8.5 pt
constexpr double readingPadding = 2;
constexpr std::size_t mostRunsSideBySide = 7;
constexpr std::size_t rowsOfAGroup = 5;
constexpr double narrowestReading = 12;
constexpr std::size_t mostRows = 2000; ///< of readings or targets printed by default; more are packed

/// Adds a row to a table that gets so many of them.
void addRow(Table &table, std::size_t of, std::vector<Cell> row) {
    if (of > mostRows)
        table.packed.append(row);
    else
        table.rows.push_back(std::move(row));
}

Phrase indexed(const QString &base, const QString &index, const QString &after = {}) {
    std::vector<Span> spans{{base}, {index, true}};
    if (!after.isEmpty())
        spans.push_back({after});
    return Phrase(std::move(spans));
}

/// Width of column i, mm: for two digits, and more for each further digit.
double widthOfNumbers(const PositioningMeasurement &measurement) {
    const qsizetype digits = QString::number(measurement.targets.size()).size();
    return 7 + 2.0 * static_cast<double>(std::max<qsizetype>(0, digits - 2));
}

Column targetColumn(const PositioningPart &part) {
    return columnOf(Phrase({{letterOfTargets(part.edition()), false, true}}),
                    widthOfNumbers(part.measurement), Alignment::right);
}

Column positionColumn(const PositioningPart &part) {
    return columnOf(indexed(QStringLiteral("P"), letterOfTargets(part.edition())), positionWidth,
                    Alignment::decimal, part.write.language().unit(part.along()));
}

void addGroupRules(Table &table) {
    for (std::size_t row = rowsOfAGroup; row < table.rowCount(); row += rowsOfAGroup)
        table.rulesAfter.push_back(row - 1);
}

/// Targets (from 1) that rule R↑, R↓, R, B etc.: bold cells in the table per target.
std::set<std::pair<std::string, int>> rulingCells(const TestEvaluation &evaluation) {
    std::set<std::pair<std::string, int>> cells;
    for (const TargetTerm &term : evaluation.edition->targetTerms) {
        for (const Parameter &parameter : evaluation.parameters) {
            if (parameter.ruling[0] && std::string_view(term.largest) == parameter.term.id)
                cells.emplace(term.id, parameter.ruling[0]->target);
        }
    }
    return cells;
}

/// Runs of a direction in the order of measurement.
std::vector<const Run *> runsOf(const PositioningMeasurement &measurement, Direction direction) {
    std::vector<const Run *> runs;
    for (const Run &run : measurement.runs) {
        if (run.approach == direction)
            runs.push_back(&run);
    }
    return runs;
}

bool printsAllRows(const PositioningPart &part) {
    return std::ranges::find(part.head().include, ReportExtra::allReadings) != part.head().include.end();
}

void addLeftOut(std::vector<Block> &blocks, const Writer &write, std::size_t rows) {
    blocks.emplace_back(Paragraph{write.language().sentence(
        {REPORT_TEXT_COUNTED(
             "report", "Left out: %n row(s), for a report prints no more than %1 of them unasked. The test "
                       "file holds all readings. To print the rows as well, choose “All readings” for the "
                       "report, or write “allReadings” under “include” in the test file."),
         {wholeNumber(mostRows)},
         static_cast<int>(rows)})});
}

class ReadingTables {
public:
    /// Rows of all tables together; if these are too many, a lower bound is enough.
    static std::size_t leastRows(const PositioningMeasurement &measurement) {
        const std::size_t up = runsOf(measurement, Direction::positive).size();
        const std::size_t down = runsOf(measurement, Direction::negative).size();
        const std::size_t targets = measurement.targets.size();
        if (up > 0 && down > 0 && std::max(up, down) <= mostRunsSideBySide)
            return targets;
        const std::size_t atATime = runsAtATime(measurement, narrowestReading);
        return targets * ((up + atATime - 1) / atATime + (down + atATime - 1) / atATime);
    }

    explicit ReadingTables(const PositioningPart &part)
        : m_part(part)
        , m_up(runsOf(part.measurement, Direction::positive))
        , m_down(runsOf(part.measurement, Direction::negative))
        , m_decimals(readingDecimals(part.measurement))
        , m_positionDecimals(positionDecimals(part.measurement)) {
        qsizetype longest = 0;
        for (const Run &run : part.measurement.runs) {
            for (const auto &deviation : run.deviations) {
                if (deviation)
                    longest = std::max(longest, reading(*deviation).size());
            }
        }
        m_columnWidth = static_cast<double>(longest) * digitWidth + readingPadding;
    }

    /// Appends the readings to a table per target; returns false and adds nothing if they do not fit.
    [[nodiscard]] bool appendedTo(Table &table) const {
        constexpr std::size_t numberAndPosition = 2;
        double width = std::max(m_columnWidth, narrowestReading);
        for (const std::vector<Cell> &row : table.rows) {
            for (std::size_t i = numberAndPosition; i < row.size(); ++i)
                width = std::max(width, widthOf(row[i].text.plain()));
        }
        const std::size_t columns = table.columns.size() - numberAndPosition + m_up.size() + m_down.size();
        const double gaps = directionsGap * (m_up.empty() || m_down.empty() ? 1 : 2);
        if (static_cast<double>(columns) * width > roomForReadings(m_part.measurement) - gaps)
            return false;
        addColumns(table, Direction::positive, 0, m_up.size());
        addColumns(table, Direction::negative, 0, m_down.size());
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            for (const std::vector<const Run *> &shown : {m_up, m_down}) {
                for (const Run *run : shown)
                    table.rows[i].emplace_back(readingOf(*run, i));
            }
        }
        return true;
    }

    [[nodiscard]] std::vector<Table> tables() const {
        const double room = roomForReadings(m_part.measurement);
        const std::size_t most = std::max(m_up.size(), m_down.size());
        const bool sideBySide =
            most <= mostRunsSideBySide && !m_up.empty() && !m_down.empty() &&
            static_cast<double>(m_up.size() + m_down.size()) * m_columnWidth <= room - directionsGap;
        std::vector<Table> result;
        if (sideBySide) {
            Table table = base();
            addColumns(table, Direction::positive, 0, m_up.size());
            addColumns(table, Direction::negative, 0, m_down.size());
            std::vector<const Run *> shown = m_up;
            shown.insert(shown.end(), m_down.begin(), m_down.end());
            addRows(table, shown);
            result.push_back(std::move(table));
            return result;
        }
        const std::size_t atATime =
            runsAtATime(m_part.measurement, std::max(m_columnWidth, narrowestReading));
        const auto runsOfEach = [&](Direction direction) { // balanced
            const std::size_t count = runs(direction).size();
            const std::size_t parts = std::max<std::size_t>((count + atATime - 1) / atATime, 1);
            return (count + parts - 1) / parts;
        };
        const std::size_t widest = std::max(runsOfEach(Direction::positive), runsOfEach(Direction::negative));
        for (const Direction direction : {Direction::positive, Direction::negative}) {
            const std::size_t count = runs(direction).size();
            for (std::size_t first = 0; first < count; first += runsOfEach(direction)) {
                Table table = base();
                const std::size_t shown = std::min(runsOfEach(direction), count - first);
                addColumns(table, direction, first, shown);
                if (shown < widest)
                    setOnGrid(table, widest);
                const auto from = runs(direction).begin() + static_cast<std::ptrdiff_t>(first);
                addRows(table, {from, from + static_cast<std::ptrdiff_t>(shown)});
                result.push_back(std::move(table));
            }
        }
        return result;
    }

private:
    static double widthOf(const QString &number) {
        return static_cast<double>(number.size()) * digitWidth + readingPadding;
    }
    static double roomForReadings(const PositioningMeasurement &measurement) {
        return textWidth - widthOfNumbers(measurement) - positionWidth;
    }
    static std::size_t runsAtATime(const PositioningMeasurement &measurement, double columnWidth) {
        return static_cast<std::size_t>(std::max(1.0, roomForReadings(measurement) / columnWidth));
    }

    [[nodiscard]] const std::vector<const Run *> &runs(Direction direction) const {
        return direction == Direction::positive ? m_up : m_down;
    }

    [[nodiscard]] QString reading(double value) const {
        return m_part.write.language().number(value, m_part.deviation(), m_decimals);
    }

    [[nodiscard]] Table base() const {
        Table table;
        table.columns = {targetColumn(m_part), positionColumn(m_part)};
        return table;
    }

    /// The row of each target with its readings of these runs.
    void addRows(Table &table, const std::vector<const Run *> &shown) const {
        const auto &targets = m_part.measurement.targets;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            std::vector<Cell> row{
                QString::number(i + 1),
                m_part.write.language().number(targets[i], m_part.along(), m_positionDecimals)};
            for (const Run *run : shown)
                row.emplace_back(readingOf(*run, i));
            row.resize(table.columns.size(), blankCell());
            addRow(table, targets.size(), std::move(row));
        }
        addGroupRules(table);
    }

    [[nodiscard]] QString readingOf(const Run &run, std::size_t target) const {
        const auto &deviations = run.deviations;
        return target < deviations.size() && deviations[target] ? reading(*deviations[target]) : QString();
    }

    void addColumns(Table &table, Direction direction, std::size_t first, std::size_t count) const {
        if (count == 0)
            return;
        const QString unit = m_part.write.language().unit(m_part.deviation());
        table.spanners.push_back({table.columns.size(), count,
                                  Phrase({{QStringLiteral("x")},
                                          {QStringLiteral("ij"), true},
                                          {arrow(direction)},
                                          {QStringLiteral(", ") + unit, false, false, true}})});
        const QString run = letterOfRuns(m_part.edition());
        for (std::size_t j = first; j < first + count; ++j) {
            Column column{QString(), run + QStringLiteral("\u00A0=\u00A0") + QString::number(j + 1),
                          Alignment::decimal};
            if (j == first && table.columns.size() > 2)
                column.gapBefore = directionsGap;
            table.columns.push_back(column);
        }
    }

    /// Gives fewer runs the widths they have in the other tables, with a blank column at the right.
    void setOnGrid(Table &table, std::size_t columns) const {
        for (Column &column : table.columns) {
            if (column.width <= 0)
                column.width = roomForReadings(m_part.measurement) / static_cast<double>(columns);
        }
        table.columns.push_back(flexibleColumn(QString(), 0));
    }

    const PositioningPart &m_part;
    std::vector<const Run *> m_up;
    std::vector<const Run *> m_down;
    int m_decimals;
    int m_positionDecimals;
    double m_columnWidth = 0;
};

/// Number of each run within its direction, from 1.
std::vector<int> numbersInDirection(const PositioningMeasurement &measurement) {
    std::vector<int> numbers;
    int ups = 0;
    int downs = 0;
    for (const Run &run : measurement.runs)
        numbers.push_back(run.approach == Direction::positive ? ++ups : ++downs);
    return numbers;
}

/// "2006"; the full designation if the year is not enough to identify the edition.
QString shortEdition(const char *word) {
    QString designation = QString::fromUtf8(word);
    for (const QString &family : {QStringLiteral("ISO 230-2:"), QStringLiteral("ISO 230-4:")}) {
        if (designation.startsWith(family))
            return designation.mid(family.size());
    }
    return designation;
}

struct EditionColumn {
    const Edition *edition = nullptr;
    TestEvaluationPointer evaluation;
};

/// In the order in which editions are offered, whatever that of the test.
std::vector<EditionColumn> editionColumns(const TestPart &part) {
    std::vector<EditionColumn> columns{{&part.edition(), part.evaluated.tests[part.index]}};
    for (std::size_t i = 0; part.views && i < part.views->size(); ++i) {
        const Edition *edition = findEdition(part.head().editions[i]);
        const auto shown = [&](const EditionColumn &column) { return column.edition == edition; };
        if (!edition || edition->kind != part.edition().kind || std::ranges::any_of(columns, shown))
            continue;
        columns.push_back({edition, (*part.views)[i].tests[part.index]});
    }
    std::ranges::sort(columns, {}, [](const EditionColumn &column) {
        return std::ranges::find(editions(), column.edition) - editions().begin();
    });
    return columns;
}

/// The same quantity of an axis under other names.
constexpr std::array counterparts{std::pair{"P", "A"}, std::pair{"Pa", "M"}, std::pair{"Psmax", "R"},
                                  std::pair{"Umax", "B"}, std::pair{"Umean", "Bmean"}};

/// Id of the row of a parameter: that of its counterpart in ISO 230-2, if it has one.
std::string rowOfEditions(const Parameter &parameter) {
    const auto found = std::ranges::find_if(
        counterparts, [&](const auto &pair) { return parameter.term.id == std::string_view(pair.first); });
    return found == counterparts.end() ? parameterId(parameter) : found->second;
}

/// Ids of the rows, in the order of the edition that has most.
std::vector<std::string> rowsOfEditions(const std::vector<EditionColumn> &columns, const ReportHead &head) {
    std::vector<std::vector<std::string>> lists;
    for (const EditionColumn &column : columns) {
        lists.emplace_back();
        for (const Parameter &parameter : column.evaluation->parameters) {
            if (isPrinted(parameter, head))
                lists.back().push_back(rowOfEditions(parameter));
        }
    }
    std::ranges::stable_sort(lists, std::greater(), &std::vector<std::string>::size);
    std::vector<std::string> rows;
    for (const auto &list : lists) {
        for (const std::string &id : list) {
            if (std::ranges::find(rows, id) == rows.end())
                rows.push_back(id);
        }
    }
    return rows;
}

bool hasScatter(const PositioningPart &part) {
    return std::max(part.results.positiveRuns, part.results.negativeRuns) > 1;
}

/// With one run per direction the means are the readings.
bool meansAreReadings(const PositioningPart &part) {
    return !hasScatter(part) && part.results.corrections.empty() && !part.leavesOut(ReportPart::targetTable);
}

QString targetNote(const PositioningPart &part) {
    if (hasScatter(part))
        return part.write.say(
            REPORT_TEXT("report", "factor %1; bold: the value governing the axis parameter"),
            {Number{part.edition().c, Quantity::number, -1}});
    QStringList notes;
    if (meansAreReadings(part))
        notes << part.write.text(REPORT_TEXT("report", "n = 1: the means are the readings"));
    notes << part.write.text(REPORT_TEXT("report", "bold: the value governing the axis parameter"));
    return notes.join(part.write.semicolon());
}

} // namespace

Table targetTable(const PositioningPart &part, bool mayBePacked) {
    const auto &targets = part.results.targets;
    const Writer &write = part.write;
    const Edition &edition = part.edition();
    const int places = positionDecimals(part.measurement);
    const int digits = statisticDecimals(part.measurement);
    const auto ruling = rulingCells(part.evaluation);
    Table table;
    table.columns = {targetColumn(part), positionColumn(part)};
    std::vector<const char *> ids;
    for (const TargetTerm &term : edition.targetTerms) {
        if (!isShown(term, part.results))
            continue;
        ids.push_back(term.id);
        table.columns.push_back(
            {symbolPhrase(term.symbol), write.language().unit(part.deviation()), Alignment::decimal});
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        std::vector<Cell> row{QString::number(i + 1),
                              write.language().number(part.measurement.targets[i], part.along(), places)};
        for (const char *id : ids) {
            const auto value = targetValue(id, targets[i], edition.c);
            Cell cell(value ? write.language().number(*value, part.deviation(), digits) : QString());
            cell.bold = ruling.contains({id, static_cast<int>(i) + 1});
            row.push_back(std::move(cell));
        }
        addRow(table, mayBePacked ? targets.size() : 0, std::move(row));
    }
    return table;
}

namespace {

Table groupedTargets(const PositioningPart &part) {
    Table table = targetTable(part, true);
    addGroupRules(table);
    return table;
}

/// Splits a table of few columns and many rows into two halves side by side; returns it unchanged if they do
/// not fit or are too long for one page.
Table inHalves(Table table) {
    constexpr std::size_t fewest = 16;
    constexpr std::size_t most = 40;
    constexpr double gap = 8; // mm
    constexpr std::size_t numberAndPosition = 2;
    const std::vector<Column> again = table.columns;
    const std::size_t columns = again.size();
    const std::size_t count = table.rowCount();
    const double fixed = 2 * (again[0].width + again[1].width) + gap;
    const double room = (textWidth - fixed) / (2 * static_cast<double>(columns - numberAndPosition));
    if (count < fewest || count > most || room < narrowestReading)
        return table;
    const std::size_t groups = ((count + 1) / 2 + rowsOfAGroup - 1) / rowsOfAGroup;
    const std::size_t half = groups * rowsOfAGroup;
    table.columns.insert(table.columns.end(), again.begin(), again.end());
    table.columns[columns].gapBefore = gap;
    for (std::size_t i = 0; i < half; ++i) {
        std::vector<Cell> &row = table.rows[i];
        if (half + i < count)
            std::ranges::move(table.rows[half + i], std::back_inserter(row));
        else
            row.insert(row.end(), columns, blankCell());
    }
    table.rows.resize(half);
    table.rulesAfter.clear();
    addGroupRules(table);
    table.unbroken = true;
    return table;
}

/// "positional deviations x_ij", and whether they are uncorrected.
Phrase readingsNote(const PositioningPart &part) {
    const Writer &write = part.write;
    Phrase note = indexed(write.text(part.edition().deviations) + QStringLiteral(" x"), QStringLiteral("ij"));
    if (!part.results.corrections.empty())
        note.spans.push_back({QStringLiteral(", ") +
                              write.text(REPORT_TEXT("report", "as read, without the correction to 20 °C"))});
    return note;
}

bool printsTargets(const PositioningPart &part) {
    return !part.leavesOut(ReportPart::targetTable) && !part.results.targets.empty();
}

bool printsReadings(const PositioningPart &part) {
    return !part.leavesOut(ReportPart::readings) && !part.measurement.runs.empty() && !meansAreReadings(part);
}

/// The limits of the deviations of each direction and their half widths, as the edition of 1988 tabulates
/// them: x̄ + 3s, x̄ − 3s, 3s.
Table limitsOfTargets(const PositioningPart &part) {
    const Language &language = part.write.language();
    const Edition &edition = part.edition();
    const QString letter = letterOfTargets(edition);
    const int digits = statisticDecimals(part.measurement);
    const QString factor = language.number(edition.c, Quantity::number, -1);
    Table table;
    table.columns = {targetColumn(part), positionColumn(part)};
    for (std::size_t i = 0; i < part.results.targets.size(); ++i)
        table.rows.push_back(
            {QString::number(i + 1),
             language.number(part.measurement.targets[i], part.along(), positionDecimals(part.measurement))});
    for (const Direction direction : {Direction::positive, Direction::negative}) {
        if (runsOf(part.measurement, direction).size() < 2)
            continue;
        const QString towards = arrow(direction);
        const auto add = [&](Phrase title, auto value) {
            table.columns.push_back({std::move(title), language.unit(part.deviation()), Alignment::decimal});
            for (std::size_t i = 0; i < table.rows.size(); ++i) {
                const TargetStatistics &target = part.results.targets[i];
                const double shown =
                    value(direction == Direction::positive ? target.positive : target.negative);
                table.rows[i].emplace_back(
                    std::isfinite(shown) ? language.number(shown, part.deviation(), digits) : QString());
            }
        };
        const auto limit = [&](const QString &sign) {
            return Phrase({{QStringLiteral("x̄")},
                           {letter, true},
                           {towards + sign + factor + u's'},
                           {letter, true},
                           {towards}});
        };
        add(limit(QStringLiteral(" + ")),
            [&](const DirectionStatistics &s) { return s.mean + edition.c * s.s; });
        add(limit(QStringLiteral(" − ")),
            [&](const DirectionStatistics &s) { return s.mean - edition.c * s.s; });
        add(Phrase({{factor + u's'}, {letter, true}, {towards}}),
            [&](const DirectionStatistics &s) { return edition.c * s.s; });
    }
    addGroupRules(table);
    return table;
}

void addTargetTable(std::vector<Block> &blocks, const PositioningPart &part) {
    const std::size_t count = part.results.targets.size();
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Results per target position")),
               targetNote(part));
    if (count > mostRows && !printsAllRows(part))
        addLeftOut(blocks, part.write, count);
    else
        blocks.emplace_back(inHalves(groupedTargets(part)));
    if (part.edition().rangeMethod && hasScatter(part) && count <= mostRows)
        blocks.emplace_back(limitsOfTargets(part));
}

void addReadingTables(std::vector<Block> &blocks, const PositioningPart &part) {
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Readings")), readingsNote(part));
    const bool all = printsAllRows(part);
    std::size_t rows = ReadingTables::leastRows(part.measurement);
    std::vector<Table> tables;
    if (all || rows <= mostRows) {
        tables = ReadingTables(part).tables();
        rows = tables.size() * part.measurement.targets.size();
    }
    if (!all && rows > mostRows) {
        addLeftOut(blocks, part.write, rows);
        return;
    }
    for (Table &table : tables)
        blocks.emplace_back(std::move(table));
}

/// Adds both in one table if they fit; otherwise returns false and adds nothing.
bool addTargetsWithReadings(std::vector<Block> &blocks, const PositioningPart &part) {
    if (!printsTargets(part) || !printsReadings(part) || part.results.targets.size() > mostRows)
        return false;
    Table table = groupedTargets(part);
    if (!ReadingTables(part).appendedTo(table))
        return false;
    Phrase note(targetNote(part) + part.write.semicolon());
    note += readingsNote(part);
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Results and readings per target position")),
               std::move(note));
    blocks.emplace_back(std::move(table));
    return true;
}

} // namespace

void addTargetsAndReadings(std::vector<Block> &blocks, const PositioningPart &part) {
    if (addTargetsWithReadings(blocks, part))
        return;
    if (printsTargets(part))
        addTargetTable(blocks, part);
    if (printsReadings(part))
        addReadingTables(blocks, part);
}

int pagesOfAllReadings(const Document &document) {
    constexpr std::size_t rowsOfAPage = 48;
    const auto isOut = [&](ReportPart part) {
        return std::ranges::find(document.report.leaveOut, part) != document.report.leaveOut.end();
    };
    std::size_t rows = 0;
    const auto add = [&](std::size_t more) { rows += more > mostRows ? more : 0; };
    const auto addTables = [&](const auto &measurement) {
        if constexpr (requires { measurement.targets; }) {
            if (!isOut(ReportPart::targetTable))
                add(measurement.targets.size());
            if (!isOut(ReportPart::readings) && !measurement.runs.empty())
                add(ReadingTables::leastRows(measurement));
            add(measurement.excluded.size());
        }
    };
    for (const TestPointer &test : document.tests)
        std::visit(addTables, test->measurement);
    return static_cast<int>((rows + rowsOfAPage - 1) / rowsOfAPage);
}

void addExcludedReadings(std::vector<Block> &blocks, const PositioningPart &part) {
    const PositioningMeasurement &measurement = part.measurement;
    if (measurement.excluded.empty())
        return;
    const Writer &write = part.write;
    const QString unit = write.language().unit(part.deviation());
    const int places = positionDecimals(measurement);
    Table table;
    table.columns = {
        targetColumn(part), positionColumn(part),
        columnOf(letterOfRuns(part.edition()), 12, Alignment::right),
        columnOf(indexed(QStringLiteral("x"), QStringLiteral("ij")), 25, Alignment::decimal, unit),
        write.flexible(REPORT_TEXT("report", "Reason"), 112)};
    const std::vector<int> numbers = numbersInDirection(measurement);
    int decimals = readingDecimals(measurement);
    for (const ExcludedReading &reading : measurement.excluded) // these may have more
        decimals =
            std::max(decimals, limitDecimals(reading.value, part.deviation(), write.language().units()));
    const std::size_t shown =
        printsAllRows(part) ? measurement.excluded.size() : std::min(mostRows, measurement.excluded.size());
    for (const ExcludedReading &reading : std::span(measurement.excluded).first(shown)) {
        const auto target = static_cast<std::size_t>(reading.target) - 1;
        const auto run = static_cast<std::size_t>(reading.run) - 1;
        table.rows.push_back({QString::number(reading.target),
                              target < measurement.targets.size()
                                  ? write.language().number(measurement.targets[target], part.along(), places)
                                  : QString(),
                              run < numbers.size()
                                  ? QString::number(numbers[run]) + arrow(measurement.runs[run].approach)
                                  : QString(),
                              write.language().number(reading.value, part.deviation(), decimals),
                              QString::fromStdString(reading.reason)});
    }
    addHeading(blocks, write.text(REPORT_TEXT("report", "Excluded readings")),
               write.text(REPORT_TEXT("report", "set aside: they have no part in the results")));
    blocks.emplace_back(std::move(table));
    if (shown < measurement.excluded.size())
        addLeftOut(blocks, write, measurement.excluded.size() - shown);
}

std::optional<Table> editionsTable(const TestPart &part, bool narrow) {
    const std::vector<EditionColumn> columns = editionColumns(part);
    if (columns.size() < 2)
        return std::nullopt;
    const Writer &write = part.write;
    Table table;
    QString unit;
    for (const std::string &row : rowsOfEditions(columns, part.head())) {
        Phrase symbols;
        std::vector<Cell> cells{Cell()};
        for (const EditionColumn &column : columns) {
            const auto &parameters = column.evaluation->parameters;
            const auto found =
                std::ranges::find_if(parameters, [&](const Parameter &p) { return rowOfEditions(p) == row; });
            if (found == parameters.end()) {
                cells.emplace_back();
                continue;
            }
            unit = write.language().unit(found->term.quantity);
            const Phrase symbol = symbolPhrase(*found);
            if (symbols.spans.empty())
                symbols = symbol;
            else if (symbols.plain() != symbol.plain()) {
                symbols += Phrase(QStringLiteral(", "));
                symbols += symbol;
            }
            cells.emplace_back(
                found->value ? printedNumbers(*found, part.test, part.document(), write.language()).value
                             : QString());
        }
        cells.front() = boldCell(symbols);
        table.rows.push_back(std::move(cells));
    }
    const bool scatter = hasScatter(part.evaluation);
    table.columns.push_back({QString(), unit, Alignment::left, true, 20});
    for (const EditionColumn &column : columns) {
        QString factor;
        if (column.edition->c > 0 && scatter)
            factor = narrow ? QStringLiteral("c\u00A0=\u00A0") +
                                  write.language().number(column.edition->c, Quantity::number)
                            : write.say(REPORT_TEXT("report", "factor %1"),
                                        {Number{column.edition->c, Quantity::number, -1}});
        table.columns.push_back(columnOf(shortEdition(column.edition->word), 0, Alignment::decimal, factor));
    }
    return table;
}

QString reasonsOfDifferences(const TestPart &part) {
    constexpr double equal = 1e-9; // mm, degrees
    const std::vector<EditionColumn> columns = editionColumns(part);
    QStringList byFactor;
    QStringList byDefinition;
    for (const std::string &row : rowsOfEditions(columns, part.head())) {
        std::map<double, double> values; // by factor
        QString symbol;
        bool isDefined = false;
        bool isOther = false; // a counterpart of another definition, or with another estimate of s
        for (const EditionColumn &column : columns) {
            const auto &parameters = column.evaluation->parameters;
            const auto found = std::ranges::find_if(
                parameters, [&](const Parameter &p) { return rowOfEditions(p) == row && p.value; });
            if (found == parameters.end())
                continue;
            symbol = symbol.isEmpty() ? symbolPhrase(*found).plain() : symbol;
            const auto [known, isNew] = values.try_emplace(column.edition->c, *found->value);
            isDefined |= std::abs(known->second - *found->value) > equal;
            isOther |= parameterId(*found) != row ||
                       deviationMethod(*column.evaluation) != deviationMethod(*columns.front().evaluation);
        }
        const bool differs = std::ranges::any_of(
            values, [&](const auto &each) { return std::abs(each.second - values.begin()->second) > equal; });
        if (isDefined || (differs && isOther))
            byDefinition << symbol;
        else if (differs)
            byFactor << symbol;
    }
    const auto sentence = [&](const Text &words, const QStringList &symbols) {
        return symbols.isEmpty() ? QString() : part.write.say(words, enumerated(part.write, symbols));
    };
    return joined({sentence(REPORT_TEXT("report", "Differences by the factor of s: %1."), byFactor),
                   sentence(REPORT_TEXT("report", "Differences by the definitions of the editions: %1."),
                            byDefinition)},
                  QStringLiteral(" "));
}

void addEditions(std::vector<Block> &blocks, const TestPart &part) {
    auto table = editionsTable(part);
    if (!table)
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Comparison of editions")),
               part.write.say(REPORT_TEXT("report", "edition of the test: %1; the others without verdict"),
                              {std::string(part.edition().word)}));
    blocks.emplace_back(std::move(*table));
    if (const QString reasons = reasonsOfDifferences(part); !reasons.isEmpty())
        blocks.emplace_back(Paragraph{reasons, TextSize::small});
}

void addRemarks(std::vector<Block> &blocks, const TestPart &part, const QString &remarks) {
    if (remarks.isEmpty())
        return;
    addHeading(blocks, part.write.text(REPORT_TEXT("report", "Remarks")));
    blocks.emplace_back(Paragraph{remarks});
}

namespace {

/// Results stated by the instruments' programs, next to our own ones if available, and their difference.
Table instrumentResultsTable(const TestPart &part) {
    const Writer &write = part.write;
    const Language &language = write.language();
    Table table;
    table.columns = {write.flexible(REPORT_TEXT("report", "Result stated by the instrument’s program"), 60),
                     write.column(REPORT_TEXT("report", "Value"), 19, Alignment::decimal),
                     write.column(REPORT_TEXT("report", "Unit"), 16),
                     write.column(REPORT_TEXT("report", "Here"), 18),
                     write.column(REPORT_TEXT("report", "Value here"), 27, Alignment::right),
                     write.column(REPORT_TEXT("report", "Here − stated"), 27, Alignment::right)};
    constexpr int decimals = 2; // of µm; programs state one
    for (const InstrumentResult &result : instrumentResults(part.test, part.evaluation)) {
        const ImportedResult &stated = *result.stated;
        const std::string name =
            part.test.imports.size() > 1 ? result.file->fileName + ": " + stated.name : stated.name;
        std::vector<Cell> row{
            QString::fromStdString(name),
            language.number(stated.value, Quantity::number,
                            limitDecimals(stated.value, Quantity::number, language.units())),
            QString::fromStdString(stated.unit)};
        if (const Parameter *ours = result.ours) {
            row.emplace_back(QString::fromStdString(plainSymbol(*ours)));
            const PrintedNumbers printed = printedNumbers(*ours, part.test, part.document(), language);
            row.emplace_back(withUnit(printed.value, ours->term.quantity, language));
            row.emplace_back(language.quantity(*ours->value - result.value, ours->term.quantity, decimals));
        } else {
            row.insert(row.end(), 3, Cell());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

void addImports(std::vector<Block> &blocks, const TestPart &part) {
    const auto &imports = part.test.imports;
    if (imports.empty())
        return;
    const Writer &write = part.write;
    Table files;
    files.columns = {write.flexible(REPORT_TEXT("report", "File"), 63),
                     columnOf(QStringLiteral("SHA-256"), 112)};
    for (const ImportedFile &file : imports)
        files.rows.push_back({QString::fromStdString(file.fileName), QString::fromStdString(file.sha256)});
    addHeading(blocks, write.text(REPORT_TEXT("report", "Origin of the data")));
    blocks.emplace_back(std::move(files));
    for (const ImportedFile &file : imports) {
        if (file.signAssumed == true)
            blocks.emplace_back(Paragraph{
                write.say(
                    REPORT_TEXT("report",
                                "“%1” does not say the sign of its deviations; read as actual − target."),
                    {file.fileName}),
                TextSize::small});
    }
    Table results = instrumentResultsTable(part);
    if (!results.rows.empty())
        blocks.emplace_back(std::move(results));
}

} // namespace palmer
