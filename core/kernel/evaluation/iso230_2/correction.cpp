// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/correction.h"

namespace palmer::iso230_2 {

std::optional<std::vector<double>> correctionsTo20(const PositioningMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    if (measurement.axis.motion != Motion::linear || measurement.targets.empty() ||
        conditions.correctionTo20 != CorrectionTo20::appliedHere)
        return std::nullopt;
    const auto expansion = differentialExpansion(conditions);
    if (!expansion)
        return std::nullopt;
    const double origin = measurement.conditions.referencePosition.value_or(measurement.targets.front());
    std::vector<double> result;
    result.reserve(measurement.targets.size());
    for (const double target : measurement.targets)
        result.push_back(-(target - origin) * *expansion);
    return result;
}

At20 lengthsAt20(const PositioningMeasurement &measurement) {
    return measurement.axis.motion == Motion::linear
               ? palmer::lengthsAt20(measurement.conditions.common, measurementTravel(measurement))
               : At20::hold;
}

} // namespace palmer::iso230_2
