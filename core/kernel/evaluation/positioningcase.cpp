// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/positioningcase.h"

#include "kernel/evaluation/agreedpoints.h"

#include <algorithm>

namespace palmer {

double judgedAxisTravel(const PositioningMeasurement &measurement) {
    return std::max(measurement.axis.travel.value_or(0), measurementTravel(measurement));
}

bool isLongAxis(const PositioningMeasurement &measurement) {
    return judgedAxisTravel(measurement) > longestShort(measurement.axis.motion);
}

bool isInsideZone(const PositioningMeasurement &measurement) {
    const auto &targets = measurement.targets;
    const auto &zone = measurement.zone;
    return zone && !targets.empty() && targets.front() >= zone->from && targets.back() <= zone->to;
}

double PositioningCase::travel() const {
    return judgedAxisTravel(measurement);
}

bool PositioningCase::longAxis() const {
    return isLongAxis(measurement);
}

bool PositioningCase::zoneTest() const {
    return longAxis() && isInsideZone(measurement);
}

double PositioningCase::judgedTravel() const {
    return zoneTest() ? measurement.zone->to - measurement.zone->from : travel();
}

bool PositioningCase::agreed(std::string_view point) const {
    return isAgreed(test, point);
}

} // namespace palmer
