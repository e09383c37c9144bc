// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/correction.h"

namespace palmer::iso230_4 {

std::optional<double> correctionTo20(const CircularMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    if (conditions.correctionTo20 != CorrectionTo20::appliedHere)
        return std::nullopt;
    const auto expansion = differentialExpansion(conditions);
    if (!expansion)
        return std::nullopt;
    return -measurement.nominalRadius * *expansion;
}

At20 lengthsAt20(const CircularMeasurement &measurement) {
    return palmer::lengthsAt20(measurement.conditions.common, measurement.nominalRadius);
}

} // namespace palmer::iso230_4
