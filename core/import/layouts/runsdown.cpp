// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/placedpass.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "import/noteform.h"

#include <algorithm>

namespace palmer {

namespace {

class RunsDownReader {
public:
    explicit RunsDownReader(TableReading &reading)
        : m(reading) {
        const auto directions =
            m.body.columnsWhere([this](const TableColumn &column) { return m.body.saysDirections(column); });
        if (!directions.empty())
            m_directions = directions.front();
    }

    FoundPasses read() {
        m_found.isByLine = true;
        std::optional<std::uint32_t> head = m.body.blocks.front().numericHead;
        for (const TableBlock &block : m.body.blocks) {
            std::size_t first = 0;
            if (block.numericHead) {
                head = block.numericHead;
            } else if (!head) {
                head = block.rows.front();
                first = 1;
            }
            readTargets(*head);
            if (block.directionHead)
                readDirections(*head, *block.directionHead);
            m_titled = directionOfBlock(m, block).stated;
            for (std::size_t i = first; i < block.rows.size(); ++i)
                readRun(block.rows[i]);
        }
        keepUnderstood();
        takeUnitOfCells();
        takeColumns();
        listOtherHeads();
        listOtherColumns();
        return std::move(m_found);
    }

private:
    /// The unit of a temperature or time beside the readings.
    [[nodiscard]] static bool isOtherUnit(const Unit *unit) {
        return unit && unit->kind != UnitKind::length && unit->kind != UnitKind::angle;
    }

    void readTargets(std::uint32_t head) {
        m_targets.clear();
        std::string words;
        const auto cells = m.table().cells(m.row(head));
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (cells[c].isNumber())
                m_targets.push_back({c, cells[c].value});
            else if (cells[c].kind == CellKind::text) {
                const std::string_view text = m.table().text(cells[c]);
                if (c < m.body.columns.size())
                    m.body.columns[c].heading = text;
                if (words.size() < 200 && !isOtherUnit(unitIn(text)))
                    words += ' ' + std::string(text);
            }
            m.setRole(head, c, cells[c].isNumber() ? CellRole::position : CellRole::head);
        }
        if (m.table().unitOfRow().unit && m.table().unitOfRow().row == head)
            m_found.positionUnit = {m.table().unitOfRow().unit};
        if (!m_found.positionUnit.isSaid())
            m_found.positionUnit = saidUnit(words);
        for (const TableCell &cell : cells) {
            if (cell.kind == CellKind::grouped || cell.kind == CellKind::broken)
                m.remarkNoTarget(head, m.table().text(cell));
        }
    }

    /// Each column that names a direction has the target above it, or that of the column before.
    void readDirections(std::uint32_t head, std::uint32_t directions) {
        std::vector<Target> targets;
        std::optional<double> position;
        const auto cells = m.table().cells(m.row(directions));
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const auto own = m.numberAt(head, c);
            position = own ? own : position;
            const auto direction =
                isDirectionCell(m.table(), cells[c]) ? directionOf(m.table().text(cells[c])) : std::nullopt;
            if (position && direction)
                targets.push_back({c, *position, direction});
        }
        m_targets = std::move(targets);
    }

    /// The words before the readings: "Run 2 ↓ (µm)".
    [[nodiscard]] std::string labelOf(std::uint32_t row) const {
        std::string label;
        for (std::size_t c = 0; !m_targets.empty() && c < m_targets.front().column; ++c)
            label += ' ' + std::string(m.cellText(row, c));
        return label;
    }

    void readRun(std::uint32_t row) {
        const std::string label = labelOf(row);
        const HeadingWords heading = readHeading(label);
        const SaidUnit said = saidUnit(label);
        if (heading.meaning == Meaning::statistic || heading.meaning == Meaning::other ||
            heading.meaning == Meaning::temperature || isOtherUnit(said.unit)) {
            m.remarks.note({"", m.row(row).line},
                           REPORT_TEXT("report", "The line “%1” is not read: it holds no readings."),
                           excerpt(label));
            return;
        }
        if (!m_targets.empty() && m_targets.front().direction) {
            for (const Direction direction : {Direction::positive, Direction::negative})
                takeRun(row, direction, {heading, said, label, m.row(row).line});
            return;
        }
        PlacedPass placed;
        placed.direction = m_titled;
        if (m_directions) {
            placed.direction = m.body.directionIn(m.cellText(row, *m_directions));
            m_found.hasHints |= !m.body.directionWords.empty();
        } else if (heading.direction) {
            placed.direction = heading.direction;
        }
        placed.number = heading.number.value_or(0);
        for (const Target &target : m_targets)
            placed.add(m, row, target.position, target.column);
        m_found.passes.push_back(std::move(placed));
        m_labels.push_back({heading, said, label, m.row(row).line});
    }

    struct Label {
        HeadingWords words;
        SaidUnit unit;
        std::string text;
        std::uint32_t line = 0;
    };

    /// The readings of one direction in a line with both.
    void takeRun(std::uint32_t row, Direction direction, const Label &label) {
        PlacedPass placed;
        placed.direction = direction;
        placed.number = label.words.number.value_or(0);
        for (const Target &target : m_targets) {
            if (target.direction == direction)
                placed.add(m, row, target.position, target.column);
        }
        m_found.passes.push_back(std::move(placed));
        m_labels.push_back(label);
    }

    /// Removes lines with unknown words if other lines name their run or direction; an abbreviation is a
    /// direction next to its opposite.
    void keepUnderstood() {
        const auto isKnown = [](const Label &label) {
            return label.words.unknownWords == 0 && label.words.words > 0;
        };
        const bool anyKnown = std::ranges::any_of(m_labels, isKnown);
        bool up = false;
        bool down = false;
        for (const Label &label : m_labels) {
            const auto direction = label.words.direction ? label.words.direction : label.words.hint;
            up |= direction == Direction::positive;
            down |= direction == Direction::negative;
        }
        std::vector<PlacedPass> kept;
        for (std::size_t i = 0; i < m_labels.size(); ++i) {
            const Label &label = m_labels[i];
            if (anyKnown && !isKnown(label) && !label.words.direction && !(label.words.hint && up && down)) {
                m.remarks.problem({"unread", label.line},
                                  REPORT_TEXT("report", "“%1” names no run; the line was not read."),
                                  excerpt(label.text));
                continue;
            }
            if (!m_found.passes[i].direction && label.words.hint && up && down) {
                m_found.passes[i].direction = label.words.hint;
                m_found.hasSenses |= label.words.namesSense;
                m_found.hasHints |= !label.words.isClearHint(isStated(
                    *label.words.hint == Direction::positive ? Direction::negative : Direction::positive));
            }
            takeLabel(label);
            kept.push_back(std::move(m_found.passes[i]));
        }
        m_found.passes = std::move(kept);
    }

    [[nodiscard]] bool isStated(Direction wanted) const {
        return std::ranges::any_of(m_labels,
                                   [&](const Label &label) { return label.words.direction == wanted; });
    }

    void takeLabel(const Label &label) {
        if (!m_found.unit.isSaid())
            m_found.unit = label.unit;
        else if (label.unit.isSaid() && label.unit != m_found.unit)
            m.remarks.problem({"unread", label.line},
                              REPORT_TEXT("report", "The unit of this line is not that of the others: %1."),
                              excerpt(label.unit.words()));
        const char *content = label.words.meaning == Meaning::deviation ? "deviations"
                              : label.words.meaning == Meaning::actual  ? "positions"
                                                                        : "";
        if (m_found.content.empty())
            m_found.content = content;
    }

    /// Lines above the targets that were taken for headings head nothing here.
    void listOtherHeads() {
        const auto isUsed = [this](std::uint32_t head) {
            return std::ranges::any_of(m.body.blocks, [head](const TableBlock &block) {
                return block.numericHead == head || block.directionHead == head || block.rows.front() == head;
            });
        };
        for (const std::uint32_t head : m.body.columnHeads) {
            const HeadingWords title = readTitle(m.textOf(head));
            if (isUsed(head) || (title.isTitle() && title.direction))
                continue;
            const bool isRead = readForm({{}, {}, m.textOf(head)}, m.notes); // "Deviation (nm)"
            (isRead ? m.notes.used : m.notes.unused).add(m.row(head).line, m.textOf(head));
        }
    }

    /// Takes the unit stated by the readings if it is the same for all.
    void takeUnitOfCells() {
        const Unit *said = nullptr;
        for (const Target &target : m_targets) {
            const Unit *unit = m.table().unitOfColumn(target.column).unit;
            if (said && unit != said)
                return;
            said = unit;
        }
        if (said)
            m_found.unit = {said};
    }

    void takeColumns() {
        m.result.columns = m.columnsAs({});
        for (ImportColumn &column : m.result.columns)
            column.unit = nullptr; // those of the headings belong to something else
        if (m_directions)
            m.result.columns[*m_directions].role = ColumnRole::direction;
        for (const auto &[column, position, direction] : m_targets) {
            if (column >= m.result.columns.size())
                continue;
            m.result.columns[column].role = ColumnRole::run;
            m.result.columns[column].direction = direction;
        }
        m.choices.resolve("columns", wordOf(m.result.columns), Origin::recognised);
    }

    /// "Temperatur (°C)", "Mean" behind the targets: columns without a target.
    void listOtherColumns() {
        if (m_targets.empty())
            return;
        m.remarkUnread(
            [&](std::size_t c) {
                return c < m_targets.front().column || m.result.columns[c].role != ColumnRole::ignored;
            },
            [&](std::size_t c) {
                const HeadingWords heading = readHeading(m.body.columns[c].heading);
                return m.body.columns[c].isNumeric() &&
                       isOneOf(heading.meaning, {Meaning::unknown, Meaning::deviation, Meaning::reading,
                                                 Meaning::run, Meaning::actual});
            });
    }

    struct Target {
        std::size_t column = 0;
        double position = 0;
        std::optional<Direction> direction = {}; ///< of the column
    };

    TableReading &m;
    FoundPasses m_found;
    std::optional<std::size_t> m_directions;
    std::vector<Target> m_targets;
    std::vector<Label> m_labels;
    std::optional<Direction> m_titled;
};

} // namespace

FoundPasses readRunsDown(TableReading &reading) {
    return RunsDownReader(reading).read();
}

} // namespace palmer
