// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/testfacts.h"

#include "kernel/measurement/readingsaside.h"

#include <algorithm>

namespace palmer {

namespace {

std::size_t countReadings(const PositioningMeasurement &measurement) {
    std::size_t count = 0;
    for (const Run &run : measurement.runs)
        count += run.deviations.size();
    return count;
}

std::size_t countReadings(const CircularMeasurement &measurement) {
    std::size_t count = 0;
    for (const Arc &arc : measurement.arcs)
        count += arc.angles.size();
    return count;
}

std::size_t countReadings(const DriftMeasurement &measurement) {
    return measurement.times.size();
}

bool isIncomplete(const PositioningMeasurement &measurement) {
    const ReadingsAside aside(measurement);
    for (std::size_t run = 0; run < measurement.runs.size(); ++run) {
        const auto &deviations = measurement.runs[run].deviations;
        for (std::size_t target = 0; target < deviations.size(); ++target) {
            if (!deviations[target] && !aside.at(run, target))
                return true;
        }
    }
    return measurement.runs.empty() || measurement.targets.empty();
}

bool isIncomplete(const auto & /*measurement*/) {
    return false;
}

auto *conditionsWithin(auto &test) {
    using Found = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(test)>>,
                                     const Conditions, Conditions>;
    return std::visit(
        [](auto &measurement) -> Found * {
            if constexpr (requires { measurement.conditions; })
                return &measurement.conditions.common;
            else
                return nullptr;
        },
        test.measurement);
}

} // namespace

const Axis *axisOf(const Test &test) {
    return std::visit(
        [](const auto &measurement) -> const Axis * {
            if constexpr (requires { measurement.axis; })
                return &measurement.axis;
            else
                return nullptr;
        },
        test.measurement);
}

Motion motionOf(const Test &test) {
    const Axis *axis = axisOf(test);
    return axis ? axis->motion : Motion::linear;
}

Quantity deviationQuantity(const Test &test) {
    return motionOf(test) == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
}

Quantity feedQuantity(const Test &test) {
    return motionOf(test) == Motion::linear ? Quantity::feed : Quantity::angularFeed;
}

std::string axesOf(const Test &test) {
    return std::visit(
        [](const auto &measurement) -> std::string {
            if constexpr (requires { measurement.plane; })
                return measurement.plane.first + measurement.plane.second;
            else
                return measurement.axis.name;
        },
        test.measurement);
}

Conditions *conditionsOf(Test &test) {
    return conditionsWithin(test);
}

const Conditions *conditionsOf(const Test &test) {
    return conditionsWithin(test);
}

bool isJudged(const Test &test) {
    return conditionsOf(test); // an edition asks for them
}

const UncertaintyMethod *methodOf(const Test &test) {
    const UncertaintyMethod *method = nullptr;
    withUncertainty(test, [&](const auto &inputs) { method = &inputs.method; });
    return method;
}

const std::string *driftTestOf(const Test &test) {
    const std::string *id = nullptr;
    withUncertainty(test, [&](const auto &inputs) { id = inputs.driftTest ? &*inputs.driftTest : nullptr; });
    return id;
}

std::optional<double> rangeOf(const DriftMeasurement &measurement) {
    if (measurement.deviations.empty())
        return std::nullopt;
    const auto [low, high] = std::ranges::minmax(measurement.deviations);
    return high - low;
}

std::size_t readingsOf(const Test &test) {
    return std::visit([](const auto &measurement) { return countReadings(measurement); }, test.measurement);
}

bool isUnfinished(const Test &test) {
    return std::visit([](const auto &measurement) { return isIncomplete(measurement); }, test.measurement);
}

} // namespace palmer
