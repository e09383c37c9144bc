// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/measuringcycle.h"

#include "editing/editreadings.h"
#include "kernel/measurement/readingsaside.h"

namespace palmer {

namespace {

/// Number of a place in the cycle, and the inverse: both orders traverse a rectangle line by line; the
/// standard cycle reverses every run from the negative side.
std::size_t numberOf(const PositioningMeasurement &measurement, const ReadingPlace &place) {
    const std::size_t targets = measurement.targets.size();
    if (measurement.cycle == Cycle::step)
        return place.target * measurement.runs.size() + place.run;
    const bool down = measurement.runs[place.run].approach == Direction::negative;
    return place.run * targets + (down ? targets - 1 - place.target : place.target);
}

ReadingPlace placeOf(const PositioningMeasurement &measurement, std::size_t number) {
    const std::size_t targets = measurement.targets.size();
    const std::size_t runs = measurement.runs.size();
    if (measurement.cycle == Cycle::step)
        return {number % runs, number / runs};
    const std::size_t run = number / targets;
    const bool down = measurement.runs[run].approach == Direction::negative;
    return {run, down ? targets - 1 - number % targets : number % targets};
}

} // namespace

std::optional<ReadingPlace> nextInCycle(const PositioningMeasurement &measurement,
                                        const ReadingPlace &place) {
    if (!holds(measurement, place))
        return std::nullopt;
    const std::size_t next = numberOf(measurement, place) + 1;
    if (next == measurement.runs.size() * measurement.targets.size())
        return std::nullopt;
    return placeOf(measurement, next);
}

std::optional<ReadingPlace> previousInCycle(const PositioningMeasurement &measurement,
                                            const ReadingPlace &place) {
    if (!holds(measurement, place))
        return std::nullopt;
    const std::size_t number = numberOf(measurement, place);
    if (number == 0)
        return std::nullopt;
    return placeOf(measurement, number - 1);
}

std::optional<ReadingPlace> firstOfCycle(const PositioningMeasurement &measurement) {
    if (measurement.runs.empty() || measurement.targets.empty())
        return std::nullopt;
    return placeOf(measurement, 0);
}

std::optional<ReadingPlace> firstMissing(const PositioningMeasurement &measurement) {
    const ReadingsAside aside(measurement);
    auto place = firstOfCycle(measurement);
    while (place && (readingAt(measurement, *place) || aside.at(place->run, place->target)))
        place = nextInCycle(measurement, *place);
    return place;
}

} // namespace palmer
