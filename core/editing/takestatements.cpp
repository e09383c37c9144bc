// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/takestatements.h"

#include "document/edits.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace palmer {

namespace {

/// Points of agreement that hold for every axis of a machine.
constexpr std::array<std::string_view, 8> commonPoints{"gradient", "warmUp",    "feed",           "cycle",
                                                       "dwell",    "stepCycle", "testParameters", "results"};

void take(Conditions &conditions, const Conditions &from) {
    conditions.warmUp = from.warmUp;
    conditions.compensation = from.compensation;
    conditions.load = from.load;
    conditions.levelled = from.levelled;
    conditions.complete = from.complete;
    conditions.unloaded = from.unloaded;
    conditions.soak = from.soak;
    conditions.shielded = from.shielded;
    conditions.temperatureControlled = from.temperatureControlled;
    conditions.stabilised = from.stabilised;
    conditions.instrumentCompensation = from.instrumentCompensation;
    conditions.thermalGuidelines = from.thermalGuidelines;
    conditions.expansion = from.expansion;
    conditions.correctionTo20 = from.correctionTo20;
    conditions.sensors.clear();
    for (const Sensor &sensor : from.sensors)
        conditions.sensors.push_back({sensor.measures, sensor.position, {}, {}, {}});
}

void take(PositioningMeasurement &measurement, const PositioningMeasurement &from) {
    PositioningConditions &conditions = measurement.conditions;
    conditions.dwell = from.conditions.dwell;
    conditions.feed = from.conditions.feed;
    conditions.feedMode = from.conditions.feedMode;
    conditions.approachDistance = from.conditions.approachDistance;
    conditions.continuousDevice = from.conditions.continuousDevice;
    PositioningUncertaintyInputs &uncertainty = measurement.uncertainty;
    uncertainty.method = from.uncertainty.method;
    uncertainty.device = from.uncertainty.device;
    uncertainty.temperatureRange = from.uncertainty.temperatureRange;
    uncertainty.expansionRange = from.uncertainty.expansionRange;
    uncertainty.trials = from.uncertainty.trials;
}

void take(CircularMeasurement &measurement, const CircularMeasurement &from) {
    measurement.conditions.smoothing = from.conditions.smoothing;
    measurement.conditions.recentredBetweenRuns = from.conditions.recentredBetweenRuns;
    const CircularUncertaintyInputs &stated = from.uncertainty;
    CircularUncertaintyInputs &uncertainty = measurement.uncertainty;
    uncertainty.method = stated.method;
    uncertainty.displacement = stated.displacement;
    uncertainty.resolution = stated.resolution;
    uncertainty.pointNoise = stated.pointNoise;
    uncertainty.sameSensor = stated.sameSensor;
    uncertainty.temperatureStandardUncertainty = stated.temperatureStandardUncertainty;
    uncertainty.expansionStandardUncertainty = stated.expansionStandardUncertainty;
    uncertainty.trials = stated.trials;
}

/// Whether they are made with the same instruments and state the same: of one kind, of axes of one motion.
bool areAlike(const Test &test, const Test &other) {
    return kindOf(test) == kindOf(other) && motionOf(test) == motionOf(other);
}

} // namespace

void takeStatements(Test &test, const Test &from) {
    Conditions *conditions = conditionsOf(test);
    const Conditions *stated = conditionsOf(from);
    if (!conditions || !stated)
        return;
    take(*conditions, *stated);
    test.decisionRule = from.decisionRule;
    test.purpose = from.purpose;
    const bool alike = areAlike(test, from);
    if (!alike) {
        conditions->expansion.instrument.reset();
        conditions->correctionTo20 = CorrectionTo20::notStated;
        conditions->instrumentCompensation = InstrumentCompensation::notStated;
        std::erase_if(conditions->sensors,
                      [](const Sensor &sensor) { return sensor.measures == SensorMeasures::instrument; });
    } else {
        test.instruments = from.instruments;
        std::visit(
            [&](auto &measurement) {
                using Measurement = std::decay_t<decltype(measurement)>;
                if constexpr (!std::is_same_v<Measurement, DriftMeasurement>)
                    take(measurement, std::get<Measurement>(from.measurement));
            },
            test.measurement);
    }
    for (const AgreedPoint &point : from.agreedPoints) {
        const bool common = std::ranges::find(commonPoints, point.point) != commonPoints.end();
        if (common && (alike || point.point == "warmUp"))
            test.agreedPoints.push_back(point);
    }
}

} // namespace palmer
