#include "kernel/evaluation/iso230_4/correction.h"

namespace palmer::iso230_4 {

namespace {

constexpr double reference = 20; ///< °C

/// α·(T − 20) in parts of one; null where it cannot be said.
std::optional<double> expansion(const Conditions &conditions, std::optional<double> alpha,
                                SensorMeasures what) {
    if (!alpha)
        return std::nullopt;
    if (*alpha == 0)
        return 0.0;
    const auto temperature = meanTemperature(conditions, what);
    if (!temperature)
        return std::nullopt;
    return 1e-6 * *alpha * (*temperature - reference);
}

} // namespace

std::optional<double> correctionTo20(const CircularMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    if (conditions.correctionTo20 != CorrectionTo20::appliedHere)
        return std::nullopt;
    const auto instrument =
        expansion(conditions, conditions.expansion.instrument, SensorMeasures::instrument);
    const auto machine = expansion(conditions, conditions.expansion.machine, SensorMeasures::machine);
    if (!instrument || !machine)
        return std::nullopt;
    return measurement.nominalRadius * (*instrument - *machine);
}

bool awayFrom20(const CircularMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    for (const SensorMeasures what : {SensorMeasures::machine, SensorMeasures::instrument}) {
        const auto temperature = meanTemperature(conditions, what);
        if (temperature && *temperature != reference)
            return true;
    }
    return false;
}

bool isCorrected(const CircularMeasurement &measurement) {
    return measurement.conditions.common.correctionTo20 == CorrectionTo20::appliedByInstrument ||
           correctionTo20(measurement).has_value();
}

} // namespace palmer::iso230_4
