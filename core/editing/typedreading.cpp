// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/typedreading.h"

#include "document/bounds.h"
#include "editing/editreadings.h"
#include "import/layouts/phrases.h"
#include "language/decimals.h"
#include "tables/contenterror.h"
#include "tables/table.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace palmer {

const Unit &unitOfHeading(const SaidUnit &said, UnitKind kind) {
    if (!said.unit || said.unit->kind != kind)
        refuseContent(REPORT_TEXT("report", "the heading says “%1”, which these numbers are not read in"),
                      said.words());
    return *said.unit;
}

namespace {

/// Reads a list of targets from a table.
class TargetList {
public:
    TargetList(const CellTable &table, const Axis &axis, const DisplayUnits &units)
        : m_table(table)
        , m_axis(axis)
        , m_units(units) {}

    /// False for a line that is neither a heading of targets nor numbers.
    bool take(const TableRow &row) {
        const auto cells = m_table.cells(row);
        return targets.empty() && std::ranges::none_of(cells, &TableCell::isNumber) ? takeHeading(cells)
                                                                                    : takeNumbers(cells);
    }

    /// Another unit than the heading says.
    void choose(const Unit *unit) { m_chosen = unit; }

    [[nodiscard]] ImportChoice unit() const {
        if (m_chosen)
            return {"positionUnit", m_chosen->word, Origin::chosen};
        if (m_unit)
            return {"positionUnit", m_unit->word, Origin::recognised};
        return {"positionUnit", usualUnits(m_axis.motion, m_units)["positionUnit"], Origin::guessed};
    }

    std::vector<double> targets;

private:
    bool takeHeading(std::span<const TableCell> cells) {
        for (std::size_t c = 0; c < cells.size() && !m_column; ++c) {
            const std::string_view cell = m_table.text(cells[c]);
            const Meaning meaning = readHeading(cell).meaning;
            const bool isTarget = meaning == Meaning::target || meaning == Meaning::place;
            const SaidUnit said = saidUnit(cell);
            if (isTarget)
                m_column = c;
            if (!said.isSaid() || (!isTarget && cells.size() > 1))
                continue;
            m_unit = m_chosen ? m_chosen : &unitOfHeading(said, unitKindOf(m_axis.motion));
        }
        return m_column || m_unit; // otherwise words without a meaning for the numbers below
    }

    bool takeNumbers(std::span<const TableCell> cells) {
        const std::size_t before = targets.size();
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (cells[c].size == 0 || (m_column && c != *m_column))
                continue;
            const std::string_view cell = m_table.text(cells[c]);
            const QString typed = QString::fromUtf8(cell.data(), static_cast<qsizetype>(cell.size()));
            const Unit *unit = m_chosen ? m_chosen : m_unit;
            const auto number =
                enteredNumber(typed, unit ? Quantity::number : positionQuantity(m_axis), m_units).value;
            if (!number)
                return false;
            targets.push_back(unit ? unit->toBase(*number) : *number);
        }
        return targets.size() > before; // else the column has no target in this line
    }

    const CellTable &m_table;
    const Axis &m_axis;
    const DisplayUnits &m_units;
    std::optional<std::size_t> m_column; ///< the one that headings call targets
    const Unit *m_unit = nullptr;        ///< that a heading says
    const Unit *m_chosen = nullptr;
};

} // namespace

std::optional<PastedTargets> targetsFrom(const std::string &text, const Axis &axis, const DisplayUnits &units,
                                         const ImportOptions &answers) {
    const CellTable table = readTable(text, {{}, {}, false});
    TargetList list(table, axis, units);
    if (const auto answer = answers.find("positionUnit"); answer != answers.end())
        list.choose(unitOf(answer->second));
    if (!std::ranges::all_of(table.rows(), [&](const TableRow &row) { return list.take(row); }))
        return std::nullopt;
    PastedTargets result;
    result.taken = list.targets.size();
    result.units.push_back(list.unit());
    result.targets = std::move(list.targets);
    return result;
}

double deviationFrom(double target, double position) {
    constexpr double grid = 1e9;
    return std::round((position - target) * grid) / grid;
}

NumberEntry typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                         std::optional<double> target) {
    const QStringView typed = text.trimmed();
    if (typed == u"-" || typed == u"–" || typed == u"−")
        return {};
    NumberEntry entry =
        enteredNumber(typed, target ? positionQuantity(axis) : deviationQuantity(axis), units);
    if (target && entry.value)
        entry.value = deviationFrom(*target, *entry.value);
    if (entry.value && !(std::abs(*entry.value) <= mostOfReading))
        return {{}, REPORT_TEXT("report", "a reading beyond any machine")};
    return entry;
}

TargetEntry typedTarget(QStringView text, const PositioningMeasurement &measurement, std::size_t target,
                        const DisplayUnits &units) {
    const Quantity quantity = positionQuantity(measurement.axis);
    const NumberEntry typed = enteredNumber(text, quantity, units);
    if (typed.refusal)
        return {{}, Message{*typed.refusal}};
    if (!typed.value)
        return {{}, Message{REPORT_TEXT("report", "a target needs a position")}};
    switch (problemOfTarget(measurement, target, *typed.value)) {
    case TargetProblem::notFinite:
        return {{}, Message{REPORT_TEXT("report", "not a number")}};
    case TargetProblem::notAbovePrevious:
        return {{},
                Message{REPORT_TEXT("report", "not above the target before, %1"),
                        {Number{measurement.targets[target - 1], quantity}}}};
    case TargetProblem::notBelowNext:
        return {{},
                Message{REPORT_TEXT("report", "not below the next target, %1"),
                        {Number{measurement.targets[target + 1], quantity}}}};
    case TargetProblem::none:
        break;
    }
    return {typed.value, {}};
}

} // namespace palmer
