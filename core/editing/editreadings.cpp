// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/editreadings.h"

#include "document/edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace palmer {

namespace {

constexpr double firstInterval = 100; ///< mm or degrees, if there is no other interval

/// Excluded and refused readings count runs and targets from 1.
template <class Beside>
bool isAt(const Beside &reading, const ReadingPlace &place) {
    return reading.run == static_cast<int>(place.run) + 1 &&
           reading.target == static_cast<int>(place.target) + 1;
}

template <class Beside>
const Beside *find(const std::vector<Beside> &readings, const ReadingPlace &place) {
    const auto found =
        std::ranges::find_if(readings, [&](const Beside &reading) { return isAt(reading, place); });
    return found == readings.end() ? nullptr : &*found;
}

void forget(PositioningMeasurement &measurement, const ReadingPlace &place) {
    const auto there = [&](const auto &reading) { return isAt(reading, place); };
    std::erase_if(measurement.excluded, there);
    std::erase_if(measurement.refused, there);
}

/// Existing indices in descending order without repetition, so that removing one does not shift the others.
std::vector<std::size_t> fromTheEnd(std::span<const std::size_t> indices, std::size_t size) {
    const std::set<std::size_t, std::greater<>> ordered(indices.begin(), indices.end());
    std::vector<std::size_t> result(ordered.begin(), ordered.end());
    std::erase_if(result, [size](std::size_t index) { return index >= size; });
    return result;
}

enum class Index { run, target };

template <class Beside>
int &indexOf(Beside &reading, Index which) {
    return which == Index::run ? reading.run : reading.target;
}

/// Shifts runs (targets) from `index`, counted from 0, up by one.
void shiftUp(PositioningMeasurement &measurement, Index which, std::size_t index) {
    const auto shift = [&](auto &readings) {
        for (auto &reading : readings) {
            if (indexOf(reading, which) > static_cast<int>(index))
                ++indexOf(reading, which);
        }
    };
    shift(measurement.excluded);
    shift(measurement.refused);
}

/// Removes run (target) `index` and shifts those after it down.
void shiftDown(PositioningMeasurement &measurement, Index which, std::size_t index) {
    const int removed = static_cast<int>(index) + 1;
    const auto shift = [&](auto &readings) {
        std::erase_if(readings, [&](auto &reading) { return indexOf(reading, which) == removed; });
        for (auto &reading : readings) {
            if (indexOf(reading, which) > removed)
                --indexOf(reading, which);
        }
    };
    shift(measurement.excluded);
    shift(measurement.refused);
}

/// Gives every run an entry for every target.
void complete(PositioningMeasurement &measurement) {
    for (Run &run : measurement.runs)
        run.deviations.resize(measurement.targets.size());
}

bool ascends(std::span<const double> positions) {
    return std::ranges::all_of(positions, [](double p) { return std::isfinite(p); }) &&
           std::ranges::adjacent_find(positions, std::greater_equal<>()) == positions.end();
}

} // namespace

bool holds(const PositioningMeasurement &measurement, const ReadingPlace &place) {
    return place.run < measurement.runs.size() && place.target < measurement.targets.size();
}

std::optional<double> readingAt(const PositioningMeasurement &measurement, const ReadingPlace &place) {
    if (!holds(measurement, place) || place.target >= measurement.runs[place.run].deviations.size())
        return std::nullopt;
    return measurement.runs[place.run].deviations[place.target];
}

const ExcludedReading *excludedAt(const PositioningMeasurement &measurement, const ReadingPlace &place) {
    return find(measurement.excluded, place);
}

const RefusedReading *refusedAt(const PositioningMeasurement &measurement, const ReadingPlace &place) {
    return find(measurement.refused, place);
}

void setReading(PositioningMeasurement &measurement, const ReadingPlace &place,
                std::optional<double> deviation) {
    if (!holds(measurement, place))
        return;
    if (!readingAt(measurement, place)) // an excluded or refused reading has no value
        forget(measurement, place);
    complete(measurement);
    measurement.runs[place.run].deviations[place.target] = deviation;
}

void setRefused(PositioningMeasurement &measurement, const ReadingPlace &place, const std::string &text) {
    if (!holds(measurement, place))
        return;
    setReading(measurement, place, std::nullopt);
    measurement.refused.push_back(
        {static_cast<int>(place.run) + 1, static_cast<int>(place.target) + 1, text});
}

void setAside(PositioningMeasurement &measurement, std::span<const ReadingPlace> places,
              const std::string &reason) {
    for (const ReadingPlace &place : places) {
        const auto value = readingAt(measurement, place);
        if (!value)
            continue;
        setReading(measurement, place, std::nullopt);
        measurement.excluded.push_back(
            {static_cast<int>(place.run) + 1, static_cast<int>(place.target) + 1, *value, reason});
    }
}

void bringBack(PositioningMeasurement &measurement, std::span<const ReadingPlace> places) {
    std::set<std::pair<int, int>> wanted;
    for (const ReadingPlace &place : places) {
        if (holds(measurement, place))
            wanted.emplace(static_cast<int>(place.run) + 1, static_cast<int>(place.target) + 1);
    }
    complete(measurement);
    std::erase_if(measurement.excluded, [&](const ExcludedReading &reading) {
        if (!wanted.contains({reading.run, reading.target}))
            return false;
        const auto target = static_cast<std::size_t>(reading.target) - 1;
        measurement.runs[static_cast<std::size_t>(reading.run) - 1].deviations[target] = reading.value;
        return true;
    });
}

TargetProblem problemOfTarget(const PositioningMeasurement &measurement, std::size_t index, double position) {
    const auto &targets = measurement.targets;
    if (!std::isfinite(position))
        return TargetProblem::notFinite;
    if (index > 0 && index <= targets.size() && !(targets[index - 1] < position))
        return TargetProblem::notAbovePrevious;
    if (index + 1 < targets.size() && !(position < targets[index + 1]))
        return TargetProblem::notBelowNext;
    return TargetProblem::none;
}

bool setTarget(PositioningMeasurement &measurement, std::size_t index, double position) {
    if (index >= measurement.targets.size() ||
        problemOfTarget(measurement, index, position) != TargetProblem::none)
        return false;
    measurement.targets[index] = position;
    return true;
}

bool setTargets(PositioningMeasurement &measurement, std::span<const double> positions) {
    if (!ascends(positions))
        return false;
    measurement.targets.assign(positions.begin(), positions.end());
    complete(measurement);
    const auto beyond = [&](const auto &reading) {
        return reading.target > static_cast<int>(positions.size());
    };
    std::erase_if(measurement.excluded, beyond);
    std::erase_if(measurement.refused, beyond);
    return true;
}

std::size_t insertTarget(PositioningMeasurement &measurement, std::size_t index) {
    complete(measurement);
    auto &targets = measurement.targets;
    index = std::min(index, targets.size());
    double position = 0;
    if (targets.size() == 1)
        position = index == 0 ? targets.front() - firstInterval : targets.back() + firstInterval;
    else if (!targets.empty() && index == 0)
        position = 2 * targets[0] - targets[1];
    else if (!targets.empty() && index == targets.size())
        position = 2 * targets[index - 1] - targets[index - 2];
    else if (!targets.empty())
        position = std::midpoint(targets[index - 1], targets[index]);
    targets.insert(targets.begin() + static_cast<std::ptrdiff_t>(index), position);
    for (Run &run : measurement.runs)
        run.deviations.insert(run.deviations.begin() + static_cast<std::ptrdiff_t>(index), std::nullopt);
    shiftUp(measurement, Index::target, index);
    return index;
}

std::vector<std::size_t> unmeasuredTargets(const PositioningMeasurement &measurement) {
    const auto isEmpty = [](const Run &run) {
        return std::ranges::none_of(run.deviations, [](const auto &reading) { return reading.has_value(); });
    };
    std::vector<std::size_t> targets = targetsWithoutReading(measurement);
    if (measurement.runs.empty() || std::ranges::any_of(measurement.runs, isEmpty))
        targets.clear();
    std::erase_if(targets, [&](std::size_t target) {
        const auto isThere = [&](const auto &reading) {
            return reading.target == static_cast<int>(target) + 1;
        };
        return std::ranges::any_of(measurement.excluded, isThere) ||
               std::ranges::any_of(measurement.refused, isThere);
    });
    return targets;
}

void removeTargets(PositioningMeasurement &measurement, std::span<const std::size_t> indices) {
    complete(measurement);
    for (const std::size_t index : fromTheEnd(indices, measurement.targets.size())) {
        measurement.targets.erase(measurement.targets.begin() + static_cast<std::ptrdiff_t>(index));
        for (Run &run : measurement.runs)
            run.deviations.erase(run.deviations.begin() + static_cast<std::ptrdiff_t>(index));
        shiftDown(measurement, Index::target, index);
    }
}

void insertRun(PositioningMeasurement &measurement, std::size_t index, Direction approach) {
    index = std::min(index, measurement.runs.size());
    Run run{approach, {}};
    run.deviations.resize(measurement.targets.size());
    measurement.runs.insert(measurement.runs.begin() + static_cast<std::ptrdiff_t>(index), std::move(run));
    shiftUp(measurement, Index::run, index);
}

void addRuns(PositioningMeasurement &measurement) {
    const auto has = [&](Direction approach) {
        return std::ranges::any_of(measurement.runs,
                                   [approach](const Run &run) { return run.approach == approach; });
    };
    const bool none = measurement.runs.empty();
    const bool up = none || has(Direction::positive);
    const bool down = none || has(Direction::negative);
    if (up)
        insertRun(measurement, measurement.runs.size(), Direction::positive);
    if (down)
        insertRun(measurement, measurement.runs.size(), Direction::negative);
}

void removeRuns(PositioningMeasurement &measurement, std::span<const std::size_t> indices) {
    for (const std::size_t index : fromTheEnd(indices, measurement.runs.size())) {
        measurement.runs.erase(measurement.runs.begin() + static_cast<std::ptrdiff_t>(index));
        shiftDown(measurement, Index::run, index);
    }
}

void editReadings(Document &document, std::size_t index,
                  const std::function<void(PositioningMeasurement &)> &change) {
    editMeasurement(document, index, change);
}

} // namespace palmer
