// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/correctiontext.h"

#include "kernel/evaluation/correctionto20.h"
#include "kernel/measurement/testfacts.h"
#include "report/words/wording.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// The expanding length, mm; 0: none.
double expandingLength(const PositioningMeasurement &measurement) {
    if (measurement.axis.motion != Motion::linear || measurement.targets.empty())
        return 0;
    const double origin = measurement.conditions.referencePosition.value_or(measurement.targets.front());
    double farthest = 0;
    for (const double target : measurement.targets)
        farthest = std::max(farthest, std::abs(target - origin));
    return farthest;
}

double expandingLength(const CircularMeasurement &measurement) {
    return measurement.nominalRadius;
}

double expandingLength(const Unjudged auto & /*measurement*/) {
    return 0;
}

/// True if a measurement has results that a correction made here can change.
bool takesCorrection(const PositioningMeasurement &measurement) {
    return measurement.axis.motion == Motion::linear;
}

bool takesCorrection(const CircularMeasurement &measurement) {
    return measurement.source == SignalSource::external;
}

bool takesCorrection(const Unjudged auto & /*measurement*/) {
    return false;
}

} // namespace

Text correctionText(const Test &test) {
    const Conditions *conditions = conditionsOf(test);
    const CorrectionTo20 stated = conditions ? conditions->correctionTo20 : CorrectionTo20::notStated;
    const bool isMade =
        std::visit([](const auto &measurement) { return takesCorrection(measurement); }, test.measurement) &&
        conditions && isCorrectedTo20(*conditions);
    return stated == CorrectionTo20::appliedHere && !isMade
               ? REPORT_TEXT("report", "to be applied here, but nothing is corrected")
               : correctionText(stated);
}

QString correctionSizeText(const Test &test, const Language &language) {
    const double length =
        std::visit([](const auto &measurement) { return expandingLength(measurement); }, test.measurement);
    const Conditions *conditions = conditionsOf(test);
    if (!conditions || !(length > 0))
        return {};
    const auto expansion = differentialExpansion(*conditions);
    if (!expansion)
        return {};
    const auto text = [&](double value, Quantity quantity, int decimals) {
        return language.quantity(value, quantity, decimals).toStdString();
    };
    return language.sentence(
        REPORT_TEXT_FOR("report", "%1 over %2", "the differential expansion over a length"),
        {text(std::abs(*expansion) * length, Quantity::deviation, 1), text(length, Quantity::position, -1)});
}

} // namespace palmer
