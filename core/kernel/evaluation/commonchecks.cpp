// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/commonchecks.h"

#include "kernel/evaluation/agreedpoints.h"
#include "kernel/measurement/conditions.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::common {

namespace {

constexpr double margin = 0.5;    ///< °C
constexpr double rounding = 1e-9; ///< for differences of temperatures

bool specified(const Conditions &conditions, const Test &test) {
    return conditions.warmUp.specifiedBy != SpecifiedBy::notStated || isAgreed(test, "warmUp");
}

} // namespace

bool mayBeControlled(const Conditions &conditions) {
    return conditions.temperatureControlled.value_or(true);
}

Judgement temperature(const Conditions &conditions, Text outside) {
    const TemperatureSpan air = temperatureSpan(conditions, SensorMeasures::air);
    const auto worst = air.farthest();
    if (!worst || std::abs(*worst - referenceTemperature) <= margin + rounding)
        return air.complete ? Judgement::met() : Judgement::undeclared();
    if (!conditions.temperatureControlled)
        return Judgement::undeclared();
    return Judgement::unmet({outside, {Number{*worst, Quantity::temperature, -1}}});
}

Judgement correction(const Conditions &conditions, At20 lengths,
                     Message (*notCorrected)(const OtherTemperature &away)) {
    if (lengths == At20::hold)
        return Judgement::met();
    const auto away = awayFrom20(conditions);
    if (!away || conditions.correctionTo20 == CorrectionTo20::notStated)
        return Judgement::undeclared();
    return Judgement::unmet(notCorrected(*away));
}

Judgement otherAxes(const Conditions &conditions) {
    return isBlank(conditions.otherAxes) ? Judgement::unmet() : Judgement::met();
}

Judgement warmUpOrSetUp(const Conditions &conditions, const Test &test) {
    switch (conditions.warmUp.kind) {
    case WarmUpKind::setUpOnly:
        return Judgement::met();
    case WarmUpKind::dryRun:
        return specified(conditions, test) ? Judgement::met() : Judgement::unmet();
    case WarmUpKind::procedure:
        return specified(conditions, test) ? Judgement::met() : Judgement::undeclared();
    case WarmUpKind::notStated:
        break;
    }
    return Judgement::undeclared();
}

Judgement warmUpStated(const Conditions &conditions, const Test &test) {
    switch (conditions.warmUp.kind) {
    case WarmUpKind::setUpOnly:
    case WarmUpKind::dryRun:
        return Judgement::met();
    case WarmUpKind::procedure:
        return specified(conditions, test) ? Judgement::met() : Judgement::undeclared();
    case WarmUpKind::notStated:
        break;
    }
    return Judgement::unmet();
}

bool allStated(const Point3 &point) {
    return std::ranges::all_of(point, [](const auto &x) { return x.has_value(); });
}

bool instrumentPosition(const Conditions &conditions) {
    return !isBlank(conditions.instrumentPosition) ||
           (allStated(conditions.toolOffset) && allStated(conditions.workpieceOffset));
}

bool machineSensorsPlaced(const Conditions &conditions) {
    const auto isOfMachine = [](const Sensor &sensor) { return sensor.measures == SensorMeasures::machine; };
    return std::ranges::any_of(conditions.sensors, isOfMachine) &&
           std::ranges::none_of(conditions.sensors, [&](const Sensor &sensor) {
               const bool mayBe = isOfMachine(sensor) || sensor.measures == SensorMeasures::notStated;
               return mayBe && isBlank(sensor.position);
           });
}

bool sensorsNamed(const Conditions &conditions) {
    return std::ranges::find(conditions.sensors, SensorMeasures::notStated, &Sensor::measures) ==
           conditions.sensors.end();
}

bool anyTemperature(const Conditions &conditions, SensorMeasures what) {
    return temperatureSpan(conditions, what).lowest.has_value();
}

Judgement temperaturesAtStartAndEnd(const Conditions &conditions) {
    static constexpr std::array<Text, 3> names{Text{}, REPORT_TEXT("report", "temperatures at the start"),
                                               REPORT_TEXT("report", "temperatures at the end")};
    unsigned missing = 0;
    for (const Sensor &sensor : conditions.sensors) {
        const auto start = startTemperature(sensor);
        const auto end = endTemperature(sensor);
        if (start || end)
            missing |= missingOf(start, end);
    }
    return Judgement::lacking(State::unmet, missing, names);
}

Judgement expansionStated(const Conditions &conditions) {
    static constexpr std::array<Text, 3> names{
        Text{}, REPORT_TEXT("report", "coefficient of thermal expansion of the machine"),
        REPORT_TEXT("report", "coefficient of thermal expansion of the instrument")};
    return Judgement::lacking(
        State::unmet, missingOf(conditions.expansion.machine, conditions.expansion.instrument), names);
}

Judgement uncertainty(const std::string &results) {
    if (results.empty())
        return Judgement::met();
    return {State::unmet, {}, {}, results};
}

Judgement offsetsStated(const Conditions &conditions) {
    static constexpr std::array<Text, 3> names{
        Text{}, REPORT_TEXT("report", "offset of the measuring line to the tool reference"),
        REPORT_TEXT("report", "offset of the measuring line to the workpiece reference")};
    return Judgement::lacking(
        State::unmet, missingOf(allStated(conditions.toolOffset), allStated(conditions.workpieceOffset)),
        names);
}

} // namespace palmer::common
