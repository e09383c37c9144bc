#include "kernel/evaluation/positioningcase.h"

#include <algorithm>

namespace palmer {

double PositioningCase::travel() const {
    return measurement.axis.travel.value_or(measurementTravel(measurement));
}

bool PositioningCase::longAxis() const {
    return travel() > (linear() ? 2000.0 : 360.0);
}

bool PositioningCase::zoneTest() const {
    return longAxis() && measurement.zone && !measurement.targets.empty() &&
           measurement.targets.front() >= measurement.zone->from &&
           measurement.targets.back() <= measurement.zone->to;
}

double PositioningCase::judgedTravel() const {
    return zoneTest() ? measurement.zone->to - measurement.zone->from : travel();
}

const AgreedPoint *PositioningCase::agreedPoint(std::string_view point) const {
    const auto found = std::ranges::find(test.agreedPoints, point, &AgreedPoint::point);
    return found == test.agreedPoints.end() ? nullptr : &*found;
}

bool PositioningCase::agreed(std::string_view point) const {
    const AgreedPoint *found = agreedPoint(point);
    return found && found->state == AgreementState::agreed;
}

} // namespace palmer
