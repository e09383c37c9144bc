// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/measurement/positioning.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace palmer {

// Edits of the readings of a positioning test. Each function changes the given measurement and keeps the
// invariants of the file format: targets ascend strictly, every run has an entry for every target, an
// excluded reading is null in its run. Deviations in mm, rotary: degrees. Places not in the measurement are
// ignored.

/// True if the measurement has such a run and target.
[[nodiscard]] bool holds(const PositioningMeasurement &measurement, const ReadingPlace &place);

/// The deviation at that place; null if missing or excluded.
[[nodiscard]] std::optional<double> readingAt(const PositioningMeasurement &measurement,
                                              const ReadingPlace &place);

/// The excluded reading at that place; null if there is none.
[[nodiscard]] const ExcludedReading *excludedAt(const PositioningMeasurement &measurement,
                                                const ReadingPlace &place);

/// The refused text at that place, which is not a number; null if there is none.
[[nodiscard]] const RefusedReading *refusedAt(const PositioningMeasurement &measurement,
                                              const ReadingPlace &place);

/// Sets a deviation, or null; replaces an excluded or refused reading at that place.
void setReading(PositioningMeasurement &measurement, const ReadingPlace &place,
                std::optional<double> deviation);

/// Stores a text that is not a number: shown at that place, and missing in all statistics.
void setRefused(PositioningMeasurement &measurement, const ReadingPlace &place, const std::string &text);

/// Excludes the readings that have a value. Value and reason stay in the file.
void setAside(PositioningMeasurement &measurement, std::span<const ReadingPlace> places,
              const std::string &reason);

/// Restores excluded readings.
void bringBack(PositioningMeasurement &measurement, std::span<const ReadingPlace> places);

/// Why a position is invalid for a target; the file format requires ascending targets.
enum class TargetProblem { none, notFinite, notAbovePrevious, notBelowNext };

/// Checks whether target `index` may move to `position` (mm, rotary: degrees).
[[nodiscard]] TargetProblem problemOfTarget(const PositioningMeasurement &measurement, std::size_t index,
                                            double position);

/// Moves a target; its deviations stay. False without a change if problemOfTarget reports a problem.
bool setTarget(PositioningMeasurement &measurement, std::size_t index, double position);

/// Replaces the targets; readings stay with their target number. Readings of surplus targets are removed.
/// False without a change unless the positions ascend strictly.
bool setTargets(PositioningMeasurement &measurement, std::span<const double> positions);

/// Inserts a target without readings before `index` (at the end if `index` is the number of targets), midway
/// between its neighbours, or beyond an end by the adjacent interval. Returns its index.
std::size_t insertTarget(PositioningMeasurement &measurement, std::size_t index);

/// Targets without readings in any run; excluded and refused ones count as readings. Empty while a run is
/// empty, as that is still to be measured.
[[nodiscard]] std::vector<std::size_t> unmeasuredTargets(const PositioningMeasurement &measurement);

/// Removes targets with their readings.
void removeTargets(PositioningMeasurement &measurement, std::span<const std::size_t> indices);

/// Inserts a run without readings before run `index`; addRuns appends one run, or if the test is
/// bidirectional one in each direction, ↑ first.
void insertRun(PositioningMeasurement &measurement, std::size_t index, Direction approach);
void addRuns(PositioningMeasurement &measurement);

/// Removes runs with their readings.
void removeRuns(PositioningMeasurement &measurement, std::span<const std::size_t> indices);

/// Replaces the measurement of a positioning test by a copy changed by `change`: tests are shared between
/// documents and immutable. Does nothing if there is no such test.
void editReadings(Document &document, std::size_t index,
                  const std::function<void(PositioningMeasurement &)> &change);

} // namespace palmer
