#include "kernel/evaluation/iso230_2/correction.h"

namespace palmer::iso230_2 {

namespace {

constexpr double reference = 20; ///< °C

/// Expansion of machine against instrument per mm, without unit; null where a value is missing.
std::optional<double> differentialExpansion(const PositioningMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    const auto thetaMachine = meanTemperature(conditions, SensorMeasures::machine);
    const auto &[machine, instrument] = conditions.expansion;
    if (!thetaMachine || !machine || !instrument)
        return std::nullopt;
    double ofInstrument = 0;
    if (*instrument != 0) {
        const auto thetaInstrument = meanTemperature(conditions, SensorMeasures::instrument);
        if (!thetaInstrument)
            return std::nullopt;
        ofInstrument = *instrument * (*thetaInstrument - reference);
    }
    return 1e-6 * (*machine * (*thetaMachine - reference) - ofInstrument);
}

bool appliedHere(const PositioningMeasurement &measurement) {
    return measurement.axis.motion == Motion::linear &&
           measurement.conditions.common.correctionTo20 == CorrectionTo20::appliedHere;
}

} // namespace

std::optional<std::vector<double>> correctionsTo20(const PositioningMeasurement &measurement) {
    if (!appliedHere(measurement) || measurement.targets.empty())
        return std::nullopt;
    const auto expansion = differentialExpansion(measurement);
    if (!expansion)
        return std::nullopt;
    const double origin = measurement.conditions.referencePosition.value_or(measurement.targets.front());
    std::vector<double> result;
    result.reserve(measurement.targets.size());
    for (const double target : measurement.targets)
        result.push_back(-(target - origin) * *expansion);
    return result;
}

bool isCorrected(const PositioningMeasurement &measurement) {
    return measurement.conditions.common.correctionTo20 == CorrectionTo20::appliedByInstrument ||
           (appliedHere(measurement) && differentialExpansion(measurement));
}

bool awayFrom20(const PositioningMeasurement &measurement) {
    const auto theta = meanTemperature(measurement.conditions.common, SensorMeasures::machine);
    return measurement.axis.motion == Motion::linear && theta && *theta != reference;
}

} // namespace palmer::iso230_2
