// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/readingblock.h"

#include "document/documenterror.h"
#include "editing/editreadings.h"
#include "editing/pastedtable.h"
#include "editing/typedreading.h"
#include "import/layouts/phrases.h"
#include "kernel/measurement/readingsaside.h"
#include "language/decimals.h"
#include "tables/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace palmer {

namespace {

constexpr double sameTarget = 1e-6; ///< mm or degrees

/// A line of the block; null: an empty line, which still counts.
using BlockLine = std::optional<TableRow>;

bool hasNumber(const CellTable &table, const TableRow &row) {
    return std::ranges::any_of(table.cells(row), &TableCell::isNumber);
}

double inBase(double shown, Quantity quantity, const DisplayUnits &units) {
    std::array<char, 400> buffer{}; // the longest double without exponent
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown, std::chars_format::fixed);
    return fromShown(std::string_view(buffer.data(), static_cast<std::size_t>(end - buffer.data())), quantity,
                     units);
}

class Paste {
public:
    Paste(PositioningMeasurement measurement, std::string text, BlockPlace place, const BlockChoices &choices)
        : m_place(std::move(place))
        , m_choices(choices)
        , m_position(positionQuantity(measurement.axis)) {
        m_result.measurement = std::move(measurement);
        const bool hasTabs = text.find('\t') != std::string::npos;
        m_table = readTable(std::move(text), {hasTabs ? std::optional(Delimiter::tab) : choices.delimiter,
                                              choices.decimalMark, false});
        m_result.decimalMark = m_table.decimalMark;
        m_result.delimiter = m_table.delimiter.value;
        takeLines();
    }

    PastedBlock run() {
        if (m_lines.empty()) {
            m_result.remarks.push_back({REPORT_TEXT("report", "there are no numbers in what was copied")});
            return std::move(m_result);
        }
        if (const auto named = readNamed()) {
            putNamed(*named);
        } else {
            leaveOutKnownColumns();
            putTargets();
            for (std::size_t i = 0; i < m_lines.size(); ++i)
                putLine(i);
        }
        remark();
        return std::move(m_result);
    }

private:
    /// Takes the lines below the headings, each in its place: a reading may be missing at the first target,
    /// too.
    void takeLines() {
        std::size_t headings = 0;
        std::uint32_t next = 1;
        bool hasValue = false;
        for (const TableRow &row : m_table.rows()) {
            if (m_lines.empty())
                noteNames(row);
            if (m_lines.empty() && isHeading(row, headings > 0)) {
                ++headings;
                readHeadings(row);
                next = row.line + 1;
                continue;
            }
            hasValue = hasValue || hasNumber(m_table, row) || isFirstRefused(row);
            // Empty cells of several columns are tabs.
            const bool countsEmpty = !m_lines.empty() || row.count <= 1 || m_table.text().starts_with('\t');
            for (; countsEmpty && next < row.line; ++next)
                m_lines.emplace_back();
            m_lines.emplace_back(row);
            next = row.line + 1;
            for (const TableCell &cell : m_table.cells(row))
                m_result.hasMarks =
                    m_result.hasMarks || m_table.text(cell).find_first_of(",.") != std::string_view::npos;
        }
        if (!hasValue)
            m_lines.clear();
        if (headings > 0 && hasValue)
            m_result.remarks.push_back(
                {REPORT_TEXT("report", "lines of headings left out: %1"), {wholeNumber(headings)}});
    }

    /// True for words, and below them for a ruled or an empty line; words for "none" are missing readings.
    [[nodiscard]] bool isHeading(const TableRow &row, bool isBelowHeading) const {
        if (hasNumber(m_table, row) || isFirstRefused(row))
            return false;
        const auto cells = m_table.cells(row);
        const auto isLayout = [this](const TableCell &cell) {
            return cell.kind == CellKind::empty || m_table.text(cell).starts_with("--");
        };
        return std::ranges::any_of(cells, [](const auto &cell) { return cell.kind == CellKind::text; }) ||
               (isBelowHeading && std::ranges::all_of(cells, isLayout));
    }

    /// Notes headings that name targets, also in a row of targets headed by their name.
    void noteNames(const TableRow &row) {
        const auto cells = m_table.cells(row);
        m_namesTargets |= std::ranges::any_of(cells, [this](const TableCell &cell) {
            const Meaning meaning = readHeading(m_table.text(cell)).meaning;
            return meaning == Meaning::target || meaning == Meaning::place;
        });
    }

    void readHeadings(const TableRow &row) {
        const auto cells = m_table.cells(row);
        m_said.resize(std::max(m_said.size(), cells.size()));
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (const SaidUnit said = saidUnit(m_table.text(cells[c])); said.isSaid())
                m_said[c] = said;
        }
    }

    /// The unit for the numbers of a column from its heading; null if there is none.
    [[nodiscard]] const Unit *unitOfColumn(std::size_t cell) const {
        const std::size_t left = firstRunOfBlock - std::min(m_place.column, firstRunOfBlock);
        const std::size_t first = std::max(m_skipped, left); // column with readings
        if (!m_choices.unitsOfHeading)
            return nullptr;
        while (cell > first && (cell >= m_said.size() || !m_said[cell].isSaid()))
            --cell;
        if (cell >= m_said.size() || !m_said[cell].isSaid())
            return nullptr;
        return &unitOfHeading(m_said[cell], unitKindOf(m_result.measurement.axis.motion));
    }

    /// The number of a cell in mm or degrees.
    [[nodiscard]] double inBase(double value, std::size_t cell, Quantity quantity) const {
        const Unit *unit = unitOfColumn(cell);
        return unit ? unit->toBase(value) : palmer::inBase(value, quantity, m_choices.units);
    }

    /// True for a line of readings that are not numbers but look like them: not a heading.
    [[nodiscard]] bool isFirstRefused(const TableRow &row) const {
        return std::ranges::any_of(m_table.cells(row), [](const TableCell &cell) {
            return cell.kind == CellKind::broken || cell.kind == CellKind::grouped;
        });
    }

    [[nodiscard]] const TableCell *cellAt(const BlockLine &line, std::size_t column) const {
        if (!line || column >= line->count)
            return nullptr;
        return &m_table.cells(*line)[column];
    }

    /// True if a column of the block equals `expected` in every row.
    template <class Expected>
    [[nodiscard]] bool columnIs(std::size_t column, const Expected &expected) const {
        const auto &targets = m_result.measurement.targets;
        if (m_lines.empty() || m_place.row + m_lines.size() > targets.size())
            return false;
        for (std::size_t i = 0; i < m_lines.size(); ++i) {
            const TableCell *cell = cellAt(m_lines[i], column);
            if (!cell || !cell->isNumber() || !expected(cell->value, m_place.row + i))
                return false;
        }
        return true;
    }

    void leaveOutKnownColumns() {
        if (m_place.column < firstRunOfBlock)
            return;
        const auto isTargetIn = [this](std::size_t column) {
            return [this, column](double value, std::size_t row) {
                const double target = m_result.measurement.targets[row];
                return std::abs(inBase(value, column, m_position) - target) < sameTarget;
            };
        };
        const auto isNumber = [](double value, std::size_t row) {
            return value == static_cast<double>(row + 1);
        };
        // Not for a single column: small targets may look like readings.
        const bool wide =
            std::ranges::all_of(m_lines, [](const BlockLine &line) { return line && line->count > 1; });
        if (m_lines.size() < 2 || !wide)
            return;
        if (columnIs(0, isTargetIn(0)))
            m_skipped = 1;
        else if (columnIs(0, isNumber) && columnIs(1, isTargetIn(1)))
            m_skipped = 2;
        if (m_skipped > 0)
            m_result.remarks.push_back(
                {REPORT_TEXT("report", "the target positions that the block begins with are left out")});
    }

    /// The table column of a cell of the block.
    [[nodiscard]] std::size_t columnOf(std::size_t cell) const { return m_place.column + cell - m_skipped; }

    /// Reads a table whose headings name the target column as a file is read.
    [[nodiscard]] std::optional<Imported> readNamed() const {
        if (!m_choices.unitsOfHeading || !m_namesTargets)
            return std::nullopt;
        ImportOptions known{
            {"kind", "positioning"},
            {"motion", m_result.measurement.axis.motion == Motion::linear ? "linear" : "rotary"}};
        if (m_choices.decimalMark)
            known["decimalMark"] = *m_choices.decimalMark == DecimalMark::point ? "point" : "comma";
        known.insert(m_choices.answers.begin(), m_choices.answers.end());
        try {
            Imported imported = readPastedTable(
                m_table.text(), known, usualUnits(m_result.measurement.axis.motion, m_choices.units));
            const auto &block = std::get<PositioningMeasurement>(imported.test->measurement);
            const bool movesTargets = m_place.column < firstRunOfBlock && !isBare();
            if (!movesTargets ||
                std::ranges::all_of(block.targets, [this](double t) { return placeOf(t).has_value(); }))
                return imported;
        } catch (const Error &) { // then pasted cell by cell
        }
        return std::nullopt;
    }

    /// Puts each run of the block into the next column of its direction, each reading to its target; nothing
    /// if the block raises questions.
    void putNamed(const Imported &imported) {
        m_result.questions = doubtsOf(imported);
        m_result.remarks.clear(); // its heading lines were not skipped
        if (!m_result.questions.empty())
            return;
        m_result.remarks = remarksOfPaste(imported);
        const auto &block = std::get<PositioningMeasurement>(imported.test->measurement);
        const std::vector<std::optional<std::size_t>> targets = placesOf(block.targets);
        const bool areStated = std::ranges::none_of(
            imported.questions, [](const Question &question) { return question.id == "directions"; });
        std::vector<std::size_t> free(m_place.runs.begin() + firstColumn(), m_place.runs.end());
        for (const Run &run : block.runs) {
            const auto next = std::ranges::find_if(free, [&](std::size_t each) {
                return !areStated || m_result.measurement.runs[each].approach == run.approach;
            });
            for (std::size_t i = 0; i < run.deviations.size(); ++i) {
                if (next != free.end() && targets[i])
                    put({*next, *targets[i]}, run.deviations[i]);
                else
                    m_result.left += run.deviations[i] ? 1 : 0;
            }
            if (next != free.end())
                free.erase(next);
        }
        for (const ImportColumn &column : imported.columns) {
            if (column.hasReadings())
                noteUnit(column.unit);
        }
        m_result.remarks.push_back(
            {REPORT_TEXT("report", "put by target and direction, as the headings say")});
    }

    [[nodiscard]] std::ptrdiff_t firstColumn() const {
        const std::size_t first = m_place.column > firstRunOfBlock ? m_place.column - firstRunOfBlock : 0;
        return static_cast<std::ptrdiff_t>(std::min(first, m_place.runs.size()));
    }

    /// True if nothing has been entered yet.
    [[nodiscard]] bool isBare() const {
        const PositioningMeasurement &m = m_result.measurement;
        return m.refused.empty() && m.excluded.empty() && std::ranges::all_of(m.runs, [](const Run &run) {
                   return std::ranges::none_of(run.deviations,
                                               [](const auto &each) { return each.has_value(); });
               });
    }

    /// The index of the test's target at that position; null if there is none.
    [[nodiscard]] std::optional<std::size_t> placeOf(double target) const {
        const std::vector<double> &all = m_result.measurement.targets;
        const auto found =
            std::ranges::find_if(all, [target](double each) { return std::abs(each - target) < sameTarget; });
        return found == all.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - all.begin()));
    }

    /// Target indices of a block's positions; a test without readings adopts its targets.
    [[nodiscard]] std::vector<std::optional<std::size_t>> placesOf(const std::vector<double> &block) {
        std::vector<std::optional<std::size_t>> places;
        const auto place = [&] {
            places.clear();
            std::ranges::transform(block, std::back_inserter(places),
                                   [this](double t) { return placeOf(t); });
            return std::ranges::all_of(places, [](const auto &each) { return each.has_value(); });
        };
        if (!place() && isBare() && setTargets(m_result.measurement, block)) {
            m_result.targets = block.size();
            place();
        }
        return places;
    }

    void putTargets() {
        if (m_place.column > positionColumnOfBlock)
            return;
        const std::size_t column = positionColumnOfBlock - m_place.column;
        std::vector<double> targets = m_result.measurement.targets;
        targets.resize(std::min(targets.size(), m_place.row));
        const bool any = std::ranges::any_of(m_lines, [&](const BlockLine &line) {
            const TableCell *cell = cellAt(line, column);
            return cell && cell->kind != CellKind::empty;
        });
        if (!any)
            return;
        for (const BlockLine &line : m_lines) {
            const TableCell *cell = cellAt(line, column);
            if (!cell || !cell->isNumber()) {
                m_result.remarks.push_back(
                    {REPORT_TEXT("report", "a target position in the block is no number: the targets stay")});
                return;
            }
            targets.push_back(inBase(cell->value, column, m_position));
        }
        const auto &old = m_result.measurement.targets;
        for (std::size_t row = targets.size(); row < old.size(); ++row)
            targets.push_back(old[row]);
        if (setTargets(m_result.measurement, targets))
            m_result.targets = m_lines.size();
        else
            m_result.remarks.push_back(
                {REPORT_TEXT("report", "the target positions of the block do not ascend: the targets stay")});
    }

    void putLine(std::size_t number) {
        const BlockLine &line = m_lines[number];
        const std::size_t row = m_place.row + number;
        const std::size_t cells = line ? line->count : 0;
        if (!line && isOneColumn() && m_place.column >= firstRunOfBlock)
            put(row, m_place.column, {});
        for (std::size_t cell = m_skipped; cell < cells; ++cell) {
            const std::size_t column = columnOf(cell);
            if (column < firstRunOfBlock)
                continue;
            put(row, column, m_table.cells(*line)[cell]);
        }
    }

    /// In a single column an empty cell is an empty line.
    [[nodiscard]] bool isOneColumn() const {
        return std::ranges::all_of(m_lines, [](const BlockLine &line) { return !line || line->count <= 1; });
    }

    void put(std::size_t row, std::size_t column, const TableCell &cell) {
        if (column - firstRunOfBlock < m_place.runs.size() && row < m_result.measurement.targets.size())
            put({m_place.runs[column - firstRunOfBlock], row}, cell, column - m_place.column + m_skipped);
        else
            m_result.left += cell.kind != CellKind::empty ? 1 : 0;
    }

    /// True if the reading is excluded and must not be overwritten.
    [[nodiscard]] bool isAside(const ReadingPlace &place, bool isNone) {
        if (!m_aside)
            m_aside.emplace(m_result.measurement); // the targets are final by now
        const bool isAside = m_aside->at(place.run, place.target);
        m_result.aside += isAside && !isNone ? 1 : 0;
        return isAside;
    }

    void erase(const ReadingPlace &place, bool byWord) {
        PositioningMeasurement &m = m_result.measurement;
        const std::size_t held = readingAt(m, place) || refusedAt(m, place) ? 1 : 0;
        m_result.erased += held;
        m_result.erasedByWords += byWord ? held : 0;
        setReading(m, place, std::nullopt);
    }

    void put(const ReadingPlace &place, const std::optional<double> &deviation) {
        if (isAside(place, !deviation))
            return;
        if (!deviation) {
            erase(place, false);
            return;
        }
        ++m_result.readings;
        m_allZero = m_allZero && *deviation == 0;
        setReading(m_result.measurement, place, *deviation);
    }

    void put(const ReadingPlace &place, const TableCell &cell, std::size_t number) {
        const bool none = cell.kind == CellKind::empty || cell.kind == CellKind::missing;
        if (isAside(place, none))
            return;
        if (none) {
            m_missing += cell.kind == CellKind::missing ? 1 : 0;
            erase(place, cell.kind == CellKind::missing);
        } else if (cell.isNumber()) {
            ++m_result.readings;
            m_allZero = m_allZero && cell.value == 0;
            m_largest = std::max(m_largest, std::abs(cell.value));
            noteUnit(unitOfColumn(number));
            setReading(m_result.measurement, place, deviation(cell.value, place.target, number));
        } else {
            ++m_result.refused;
            setRefused(m_result.measurement, place, std::string(m_table.text(cell)));
        }
    }

    void noteUnit(const Unit *unit) {
        if (unit && std::ranges::find(m_units, unit) == m_units.end())
            m_units.push_back(unit);
    }

    [[nodiscard]] double deviation(double shown, std::size_t target, std::size_t cell) const {
        switch (m_choices.content) {
        case BlockContent::deviations:
            return inBase(shown, cell, deviationQuantity(m_result.measurement.axis));
        case BlockContent::longDeviations:
            return inBase(shown, cell, m_position);
        case BlockContent::positions:
            break;
        }
        return deviationFrom(m_result.measurement.targets[target], inBase(shown, cell, m_position));
    }

    void remark() {
        auto &remarks = m_result.remarks;
        for (const Unit *unit : m_units)
            remarks.push_back(
                {REPORT_TEXT("report", "read in %1, as the heading says"), {std::string(unit->sign)}});
        if (m_units.size() == 1)
            m_result.unit = m_units.front();
        for (const auto &[number, text] :
             {std::pair(m_missing, REPORT_TEXT("report", "marks of missing readings: %1")),
              std::pair(m_result.refused, REPORT_TEXT("report", "no numbers, kept in red: %1")),
              std::pair(m_result.aside,
                        REPORT_TEXT("report", "readings set aside keep value and reason, not taken: %1")),
              std::pair(m_result.left, REPORT_TEXT("report", "outside the table and not taken: %1"))}) {
            if (number > 0)
                remarks.push_back({text, {wholeNumber(number)}});
        }
        if (m_result.readings > 1 && m_allZero)
            remarks.push_back({REPORT_TEXT("report", "all readings are zero")});
        else if (looksLong())
            remarks.push_back({REPORT_TEXT("report", "all readings are very small: is this the unit?")});
    }

    /// Not all deviations of a machine in µm are below 0.1: these are mm.
    [[nodiscard]] bool looksLong() const {
        return m_choices.content == BlockContent::deviations && m_units.empty() && m_result.readings > 3 &&
               m_largest < 0.1 && m_choices.units.lengths != LengthDisplay::millimetres;
    }

    BlockPlace m_place;
    BlockChoices m_choices;
    Quantity m_position;
    PastedBlock m_result;
    std::optional<ReadingsAside> m_aside; ///< of m_result
    CellTable m_table;
    std::vector<BlockLine> m_lines;
    bool m_namesTargets = false;       ///< by the headings
    std::vector<SaidUnit> m_said;      ///< by the headings, per column of the block
    std::vector<const Unit *> m_units; ///< the units among them that were used for readings
    std::size_t m_skipped = 0;         ///< leading cells of each line that hold the targets
    std::size_t m_missing = 0;         ///< cells with a word for "none"
    bool m_allZero = true;
    double m_largest = 0;
};

} // namespace

PastedBlock pasteBlock(PositioningMeasurement measurement, std::string text, BlockPlace place,
                       const BlockChoices &choices) {
    return Paste(std::move(measurement), std::move(text), std::move(place), choices).run();
}

} // namespace palmer
