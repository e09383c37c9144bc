// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/takestatements.h"

#include "document/copyfields.h"
#include "document/edits.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

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

void forgetDay(Test &test) {
    test.date.reset();
    test.time.reset();
    test.declaredAccordance = {};
    test.remarks.clear();
    if (Conditions *conditions = conditionsOf(test)) {
        for (Sensor &sensor : conditions->sensors)
            sensor = {sensor.measures, sensor.position, {}, {}, {}};
    }
    if (auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement)) {
        measurement->conditions.gradientPerHour.reset();
        measurement->conditions.gradientHoursBefore.reset();
        measurement->conditions.airPressure.reset();
        measurement->conditions.airHumidity.reset();
    }
    withUncertainty(test, [](auto &inputs) {
        inputs.environmentalVariation.reset();
        inputs.driftTest.reset();
    });
}

bool areOfOneAxis(const Test &test, const Test &other) {
    return areAlike(test, other) && axesOf(test) == axesOf(other);
}

std::optional<std::size_t> lastTestLike(const Document &document, std::size_t index) {
    const Test &test = *document.tests[index];
    std::optional<std::size_t> best;
    const auto rank = [&](std::size_t at) {
        const Test &other = *document.tests[at];
        return std::tuple(areOfOneAxis(test, other), areAlike(test, other), other.date.value_or(""),
                          other.time.value_or(""));
    };
    for (std::size_t at = 0; at < document.tests.size(); ++at) {
        if (at != index && isJudged(*document.tests[at]) && (!best || rank(at) >= rank(*best)))
            best = at;
    }
    return isJudged(test) ? best : std::nullopt;
}

namespace {

/// The instruments of a test of the source, under the ids that they have or get in the document.
std::vector<std::string> instrumentsLike(Document &document, const Document &source, const Test &from) {
    std::vector<std::string> ids;
    for (const std::string &named : from.instruments) {
        const auto used = std::ranges::find(source.instruments, named, &Instrument::id);
        if (used == source.instruments.end())
            continue;
        auto own = std::ranges::find_if(document.instruments, [&](Instrument instrument) {
            instrument.id = used->id;
            return instrument == *used;
        });
        if (own == document.instruments.end()) {
            addInstrument(document, *used);
            own = document.instruments.end() - 1;
        }
        ids.push_back(own->id);
    }
    return ids;
}

void fill(PositioningMeasurement &measurement, const PositioningMeasurement &like) {
    copyFields(measurement.axis, like.axis, nothing, Copied::whatIsMissing);
    copyFields(measurement.conditions, like.conditions, nothing, Copied::whatIsMissing);
    copyFields(measurement.uncertainty, like.uncertainty, nothing, Copied::whatIsMissing);
    if (!measurement.cycle)
        measurement.cycle = like.cycle;
    if (!measurement.zone)
        measurement.zone = like.zone;
    if (measurement.targets == like.targets && measurement.targetChoice == TargetChoice())
        measurement.targetChoice = like.targetChoice;
}

void fill(CircularMeasurement &measurement, const CircularMeasurement &like) {
    copyFields(measurement.conditions, like.conditions, nothing, Copied::whatIsMissing);
    copyFields(measurement.uncertainty, like.uncertainty, nothing, Copied::whatIsMissing);
    if (measurement.positionFeedback.empty())
        measurement.positionFeedback = like.positionFeedback;
    if (measurement.specified == decltype(measurement.specified)())
        measurement.specified = like.specified;
    if (measurement.referenceLength == decltype(measurement.referenceLength)())
        measurement.referenceLength = like.referenceLength;
}

void fill(Unjudged auto & /*measurement*/, const Unjudged auto & /*like*/) {}

} // namespace

void fillLike(Document &document, std::size_t index, const Document &source, std::size_t from) {
    const Test &stated = *source.tests[from];
    copyFields(document.machine, source.machine, nothing, Copied::whatIsMissing);
    if (!isJudged(*document.tests[index]) || !isJudged(stated))
        return;
    Test like = *document.tests[index];
    if (areOfOneAxis(like, stated)) {
        like = stated;
    } else { // only what all tests of the machine have in common
        like.measurement = testOf(kindOf(like)).measurement;
        like.agreedPoints.clear();
        if (auto *measurement = std::get_if<PositioningMeasurement>(&like.measurement))
            measurement->axis = axisOf(*document.tests[index]) ? *axisOf(*document.tests[index]) : Axis();
        takeStatements(like, stated);
    }
    forgetDay(like);
    std::vector<std::string> instruments;
    if (document.tests[index]->instruments.empty() && !like.instruments.empty())
        instruments = instrumentsLike(document, source, stated);
    editTest(document, index, [&](Test &test) {
        if (test.instruments.empty())
            test.instruments = instruments;
        if (test.purpose == Purpose::notStated)
            test.purpose = like.purpose;
        if (test.limits.empty()) {
            test.limits = like.limits;
            if (test.decisionRule == DecisionRule())
                test.decisionRule = like.decisionRule;
        }
        for (const AgreedPoint &point : like.agreedPoints) {
            if (std::ranges::find(test.agreedPoints, point.point, &AgreedPoint::point) ==
                test.agreedPoints.end())
                test.agreedPoints.push_back(point);
        }
        std::visit(
            [&](auto &measurement) {
                using Measurement = std::decay_t<decltype(measurement)>;
                fill(measurement, std::get<Measurement>(like.measurement));
            },
            test.measurement);
    });
}

} // namespace palmer
