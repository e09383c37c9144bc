// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/correctionto20.h"

#include "kernel/measurement/referencetemperature.h"

#include <cmath>

namespace palmer {

namespace {

constexpr double negligible = 0.05e-3; ///< mm

/// α·(θ − 20) in parts of one.
std::optional<double> expansion(const Conditions &conditions, std::optional<double> alpha,
                                SensorMeasures what) {
    if (!alpha)
        return std::nullopt;
    if (*alpha == 0)
        return 0.0;
    const auto theta = meanTemperature(conditions, what);
    if (!theta)
        return std::nullopt;
    return 1e-6 * *alpha * (*theta - referenceTemperature);
}

/// The mean of what is known: a start or an end alone says, too, that it was not at 20 °C.
std::optional<double> knownMean(const Conditions &conditions, SensorMeasures what) {
    double sum = 0;
    int count = 0;
    for (const Sensor &sensor : conditions.sensors) {
        const auto start = startTemperature(sensor);
        const auto end = endTemperature(sensor);
        if (sensor.measures != what || (!start && !end))
            continue;
        sum += start && end ? (*start + *end) / 2 : start.value_or(end.value_or(0));
        ++count;
    }
    return count ? std::optional(sum / count) : std::nullopt;
}

} // namespace

std::optional<double> differentialExpansion(const Conditions &conditions) {
    const auto machine = expansion(conditions, conditions.expansion.machine, SensorMeasures::machine);
    const auto instrument =
        expansion(conditions, conditions.expansion.instrument, SensorMeasures::instrument);
    if (!machine || !instrument)
        return std::nullopt;
    return *machine - *instrument;
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

std::optional<MeanTemperature> awayFrom20(const Conditions &conditions, double margin) {
    constexpr double rounding = 1e-9; // of means and differences of temperatures
    for (const SensorMeasures what : {SensorMeasures::machine, SensorMeasures::instrument}) {
        if (what == SensorMeasures::instrument && conditions.expansion.instrument == 0.0)
            continue;
        const auto theta = knownMean(conditions, what);
        if (theta && std::abs(*theta - referenceTemperature) > margin + rounding)
            return MeanTemperature{what, *theta};
    }
    return std::nullopt;
}

bool isWrongAwayFrom20(const Conditions &conditions, double length) {
    if (isCorrectedTo20(conditions))
        return false;
    if (conditions.correctionTo20 == CorrectionTo20::appliedHere)
        return true;
    if (!awayFrom20(conditions))
        return false;
    const auto difference = differentialExpansion(conditions);
    return !difference || !(std::abs(*difference) * length < negligible);
}

} // namespace palmer
