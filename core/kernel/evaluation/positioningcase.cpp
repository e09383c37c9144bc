#include "kernel/evaluation/positioningcase.h"

#include "kernel/evaluation/agreedpoints.h"

namespace palmer {

bool isLongAxis(const PositioningMeasurement &measurement) {
    return measurement.axis.travel.value_or(measurementTravel(measurement)) >
           (measurement.axis.motion == Motion::linear ? 2000.0 : 360.0);
}

double PositioningCase::travel() const {
    return measurement.axis.travel.value_or(measurementTravel(measurement));
}

bool PositioningCase::longAxis() const {
    return isLongAxis(measurement);
}

bool PositioningCase::zoneTest() const {
    return longAxis() && measurement.zone && !measurement.targets.empty() &&
           measurement.targets.front() >= measurement.zone->from &&
           measurement.targets.back() <= measurement.zone->to;
}

double PositioningCase::judgedTravel() const {
    return zoneTest() ? measurement.zone->to - measurement.zone->from : travel();
}

bool PositioningCase::agreed(std::string_view point) const {
    return isAgreed(test, point);
}

} // namespace palmer
