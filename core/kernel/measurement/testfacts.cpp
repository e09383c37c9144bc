// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/testfacts.h"

#include "kernel/measurement/readingsaside.h"

#include <algorithm>
#include <array>
#include <utility>

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
    const std::size_t series = measurement.channels.size() + measurement.temperatures.size();
    return measurement.times.size() * std::max<std::size_t>(series, 1);
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

bool isIncomplete(const CircularMeasurement & /*measurement*/) {
    return false;
}

bool isIncomplete(const DriftMeasurement & /*measurement*/) {
    return false;
}

} // namespace

Test testOf(Kind kind) {
    static const auto measurements = []<std::size_t... kinds>(std::index_sequence<kinds...>) {
        return std::array{decltype(Test::measurement)(std::in_place_index<kinds>)...};
    }
    (std::make_index_sequence<allKinds.size()>());
    Test test;
    test.measurement = measurements.at(static_cast<std::size_t>(kind));
    return test;
}

const KindOfTest &traitsOf(Kind kind) {
    static constexpr std::array rows{
        // in the order of allKinds
        KindOfTest{.name = REPORT_TEXT("report", "positioning test"),
                   .isJudged = true,
                   .isOfAxis = true,
                   .hasTargets = true},
        KindOfTest{.name = REPORT_TEXT("report", "circular test"), .isJudged = true},
        KindOfTest{.name = REPORT_TEXT("report", "drift test"), .isOfAxis = true},
    };
    static_assert(rows.size() == allKinds.size());
    return rows.at(static_cast<std::size_t>(kind));
}

const Axis *axisOf(const Test &test) {
    return partOr<const Axis *>(nullptr, test.measurement,
                                [](auto &m) -> decltype(&m.axis) { return &m.axis; });
}

Motion motionOf(const Test &test) {
    const Axis *axis = axisOf(test);
    return axis ? axis->motion : Motion::linear;
}

Quantity deviationQuantity(const DriftChannel &channel) {
    return channel.quantity == ChannelQuantity::deviation ? Quantity::deviation : Quantity::angularDeviation;
}

Quantity deviationQuantity(const DriftMeasurement &measurement) {
    if (!measurement.channels.empty())
        return deviationQuantity(mainChannel(measurement));
    return measurement.axis.motion == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
}

Quantity deviationQuantity(const Test &test) {
    if (const auto *drift = std::get_if<DriftMeasurement>(&test.measurement))
        return deviationQuantity(*drift);
    return motionOf(test) == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
}

Quantity feedQuantity(const Test &test) {
    return motionOf(test) == Motion::linear ? Quantity::feed : Quantity::angularFeed;
}

std::string axesOf(const Test &test) {
    const Axis *axis = axisOf(test);
    return axis ? axis->name
                : partOr<std::string>({}, test.measurement, [](auto &m) -> decltype(m.plane.first) {
                      return m.plane.first + m.plane.second;
                  });
}

Conditions *conditionsOf(Test &test) {
    return partOr<Conditions *>(nullptr, test.measurement, [](auto &m) -> decltype(&m.conditions.common) {
        return &m.conditions.common;
    });
}

const Conditions *conditionsOf(const Test &test) {
    return partOr<const Conditions *>(
        nullptr, test.measurement,
        [](auto &m) -> decltype(&m.conditions.common) { return &m.conditions.common; });
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

std::vector<DriftChannel> channelsOf(const DriftMeasurement &measurement) {
    if (!measurement.channels.empty() || measurement.deviations.empty())
        return measurement.channels;
    return {{measurement.axis.name,
             measurement.axis.motion == Motion::linear ? ChannelQuantity::deviation
                                                       : ChannelQuantity::angularDeviation,
             {measurement.deviations.begin(), measurement.deviations.end()}}};
}

DriftChannel mainChannel(const DriftMeasurement &measurement) {
    std::vector<DriftChannel> channels = channelsOf(measurement);
    const auto named = std::ranges::find(channels, measurement.axis.name, &DriftChannel::name);
    return channels.empty() ? DriftChannel() : std::move(named == channels.end() ? channels.front() : *named);
}

std::optional<double> rangeOf(const DriftMeasurement &measurement) {
    const DriftChannel channel = mainChannel(measurement);
    std::optional<Interval> range;
    int count = 0;
    for (const std::optional<double> &value : channel.values) {
        if (!value)
            continue;
        range = range ? Interval{std::min(range->from, *value), std::max(range->to, *value)}
                      : Interval{*value, *value};
        ++count;
    }
    return count > 1 ? std::optional(range->to - range->from) : std::nullopt;
}

std::size_t readingsOf(const Test &test) {
    return std::visit([](const auto &measurement) { return countReadings(measurement); }, test.measurement);
}

bool isUnfinished(const Test &test) {
    return std::visit([](const auto &measurement) { return isIncomplete(measurement); }, test.measurement);
}

bool asksPerMetre(const Test &test) {
    const bool linear = motionOf(test) == Motion::linear;
    return partOr(false, test.measurement,
                  [linear](auto &m) -> decltype(m.uncertainty.device.perMetre.has_value()) {
                      return linear || m.uncertainty.device.perMetre.value_or(0) != 0;
                  });
}

bool areOfSameAxis(const Test &a, const Test &b) {
    return isJudged(a) && kindOf(a) == kindOf(b) && axesOf(a) == axesOf(b);
}

} // namespace palmer
