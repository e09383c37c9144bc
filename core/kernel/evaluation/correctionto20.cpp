// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/correctionto20.h"

#include "kernel/measurement/conditions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr double negligible = 0.05e-3; ///< mm
constexpr double margin = 0.05;        ///< °C: beyond it a value does not round to 20.0
constexpr double rounding = 1e-9;      ///< for differences of temperatures

/// θ of machine or instrument: mean, or at one time of the test.
using Theta = std::optional<double> (*)(const Conditions &, SensorMeasures);

std::optional<double> mean(const Conditions &conditions, SensorMeasures what) {
    return meanTemperature(conditions, what);
}

constexpr std::array<Theta, 4> times{
    [](const Conditions &c, SensorMeasures what) { return meanTemperature(c, what, startTemperature); },
    [](const Conditions &c, SensorMeasures what) { return meanTemperature(c, what, endTemperature); },
    [](const Conditions &c, SensorMeasures what) { return temperatureSpan(c, what).lowest; },
    [](const Conditions &c, SensorMeasures what) { return temperatureSpan(c, what).highest; }};

std::optional<double> differenceAt(const Conditions &conditions, Theta theta) {
    const auto expansion = [&](std::optional<double> alpha, SensorMeasures what) -> std::optional<double> {
        if (!alpha || *alpha == 0)
            return alpha;
        const auto value = theta(conditions, what);
        return value ? std::optional(1e-6 * *alpha * (*value - referenceTemperature)) : std::nullopt;
    };
    const auto machine = expansion(conditions.expansion.machine, SensorMeasures::machine);
    const auto instrument = expansion(conditions.expansion.instrument, SensorMeasures::instrument);
    return machine && instrument ? std::optional(*machine - *instrument) : std::nullopt;
}

/// True if a correction would be nil at every temperature of the test.
bool needsNoCorrection(const Conditions &conditions, double length) {
    return std::ranges::all_of(times, [&](Theta theta) {
        const auto difference = differenceAt(conditions, theta);
        return difference && std::abs(*difference) * length < negligible;
    });
}

} // namespace

std::optional<double> differentialExpansion(const Conditions &conditions) {
    return differenceAt(conditions, mean);
}

bool isCorrectedTo20(const Conditions &conditions) {
    switch (conditions.correctionTo20) {
    case CorrectionTo20::appliedByInstrument:
        return true;
    case CorrectionTo20::appliedHere:
        return differentialExpansion(conditions).has_value();
    case CorrectionTo20::notStated:
    case CorrectionTo20::notApplied:
        break;
    }
    return false;
}

std::optional<OtherTemperature> awayFrom20(const Conditions &conditions) {
    for (const SensorMeasures what : {SensorMeasures::machine, SensorMeasures::instrument}) {
        if (what == SensorMeasures::instrument && conditions.expansion.instrument == 0.0)
            continue;
        const auto theta = temperatureSpan(conditions, what).farthest();
        if (theta && std::abs(*theta - referenceTemperature) > margin + rounding)
            return OtherTemperature{what, *theta};
    }
    return std::nullopt;
}

At20 lengthsAt20(const Conditions &conditions, double length) {
    const auto isKnown = [&](SensorMeasures what) { return temperatureSpan(conditions, what).complete; };
    const bool away = awayFrom20(conditions).has_value();
    const bool known = isKnown(SensorMeasures::machine) &&
                       (conditions.expansion.instrument == 0.0 || isKnown(SensorMeasures::instrument));
    if (isCorrectedTo20(conditions) || (known && !away) || needsNoCorrection(conditions, length))
        return At20::hold;
    return away || conditions.correctionTo20 == CorrectionTo20::appliedHere ? At20::wrong : At20::open;
}

} // namespace palmer
