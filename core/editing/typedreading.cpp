// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/typedreading.h"

#include "document/bounds.h"
#include "document/documenterror.h"
#include "editing/editreadings.h"
#include "import/layouts/phrases.h"
#include "language/decimals.h"
#include "tables/table.h"

#include <algorithm>
#include <cmath>

namespace palmer {

const Unit &unitOfHeading(const SaidUnit &said, UnitKind kind) {
    if (!said.unit || said.unit->kind != kind)
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "the heading says “%1”, which these numbers are not read in"),
                     {said.words()},
                     {}});
    return *said.unit;
}

std::optional<std::vector<double>> targetsFrom(const std::string &text, const Axis &axis,
                                               const DisplayUnits &units) {
    TableOptions options;
    options.comments = false;
    const CellTable table = readTable(text, options);
    std::optional<std::size_t> column;
    const Unit *unit = nullptr;
    std::vector<double> targets;
    for (const TableRow &row : table.rows()) {
        const auto cells = table.cells(row);
        const bool isHeading = targets.empty() && std::ranges::none_of(cells, &TableCell::isNumber);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::string_view cell = table.text(cells[c]);
            if (cell.empty() || (!isHeading && column && c != *column))
                continue;
            if (isHeading) {
                const Meaning meaning = readHeading(cell).meaning;
                const bool isTarget = !column && (meaning == Meaning::target || meaning == Meaning::place);
                column = isTarget ? c : column;
                const SaidUnit said = saidUnit(cell);
                if (said.isSaid() && (isTarget || cells.size() == 1)) {
                    if (!said.unit || said.unit->kind != unitKindOf(axis.motion))
                        return std::nullopt;
                    unit = said.unit;
                }
                continue;
            }
            const QString typed = QString::fromUtf8(cell.data(), static_cast<qsizetype>(cell.size()));
            const NumberEntry number =
                enteredNumber(typed, unit ? Quantity::number : positionQuantity(axis), units);
            if (!number.value)
                return std::nullopt;
            targets.push_back(unit ? unit->toBase(*number.value) : *number.value);
        }
        if (isHeading && !column && !unit && !cells.empty())
            return std::nullopt; // words that say nothing of the numbers below
    }
    return targets;
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
