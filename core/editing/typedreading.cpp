// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/typedreading.h"

#include "document/bounds.h"
#include "document/documenterror.h"
#include "editing/editreadings.h"
#include "language/decimals.h"

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
