// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/takestatements.h"

#include "document/copyfields.h"
#include "document/edits.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace palmer {

namespace {

/// Agreed points that hold for every axis of a machine.
constexpr std::array<std::string_view, 8> commonPoints{"gradient", "warmUp",    "feed",           "cycle",
                                                       "dwell",    "stepCycle", "testParameters", "results"};

/// True if both use the same instruments and statements: the same kind, and axes of the same motion.
bool areAlike(const Test &test, const Test &other) {
    return kindOf(test) == kindOf(other) && motionOf(test) == motionOf(other);
}

} // namespace

void takeStatements(Test &test, const Test &from) {
    Conditions *conditions = conditionsOf(test);
    const Conditions *stated = conditionsOf(from);
    if (!conditions || !stated)
        return;
    const bool areOfOneSort = areAlike(test, from);
    test.decisionRule = from.decisionRule;
    test.purpose = from.purpose;
    copyFields(*conditions, *stated, shared);
    conditions->sensors.clear();
    for (const Sensor &sensor : stated->sensors) {
        if (areOfOneSort || sensor.measures != SensorMeasures::instrument)
            conditions->sensors.push_back({sensor.measures, sensor.position, {}, {}, {}});
    }
    if (areOfOneSort) {
        test.instruments = from.instruments;
        std::visit(
            [&](auto &measurement) {
                using Measurement = std::decay_t<decltype(measurement)>;
                copyFields(measurement, std::get<Measurement>(from.measurement), alike);
            },
            test.measurement);
    }
    for (const AgreedPoint &point : from.agreedPoints) {
        const bool common = std::ranges::find(commonPoints, point.point) != commonPoints.end();
        if (common && (areOfOneSort || point.point == "warmUp"))
            test.agreedPoints.push_back(point);
    }
}

} // namespace palmer
