// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/measurement/readingplace.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace palmer {

// What a user does to the readings of a positioning test. Each function changes the measurement it is given
// and keeps what the file format demands: targets ascend strictly, every run has a place for every target, a
// reading set aside is null in its run. Deviations in mm, rotary: degrees. Places that the measurement does
// not have are passed over.

/// Whether the measurement has such a run and such a target.
[[nodiscard]] bool holds(const PositioningMeasurement &measurement, const ReadingPlace &place);

/// The deviation at that place; null where it is missing or was set aside.
[[nodiscard]] std::optional<double> readingAt(const PositioningMeasurement &measurement,
                                              const ReadingPlace &place);

/// What was set aside at that place; null for none.
[[nodiscard]] const ExcludedReading *excludedAt(const PositioningMeasurement &measurement,
                                                const ReadingPlace &place);

/// What was typed at that place and is no number; null for none.
[[nodiscard]] const RefusedReading *refusedAt(const PositioningMeasurement &measurement,
                                              const ReadingPlace &place);

/// Puts a deviation there, or nothing; what was set aside or refused at that place is replaced by it.
void setReading(PositioningMeasurement &measurement, const ReadingPlace &place,
                std::optional<double> deviation);

/// Keeps a text that is no number: shown at that place, and missing in every statistic.
void setRefused(PositioningMeasurement &measurement, const ReadingPlace &place, const std::string &text);

/// Sets the readings aside that have a value. Nothing is lost: value and reason stay in the file.
void setAside(PositioningMeasurement &measurement, std::span<const ReadingPlace> places,
              const std::string &reason);

/// Takes readings that were set aside back.
void bringBack(PositioningMeasurement &measurement, std::span<const ReadingPlace> places);

/// Why a position cannot be that of a target: "ascending" is what the file demands.
enum class TargetProblem { none, notFinite, notAbovePrevious, notBelowNext };

/// Whether target `index` may move to `position` (mm, rotary: degrees).
[[nodiscard]] TargetProblem problemOfTarget(const PositioningMeasurement &measurement, std::size_t index,
                                            double position);

/// Moves a target; its deviations stay. False, and no change, where problemOfTarget has one.
bool setTarget(PositioningMeasurement &measurement, std::size_t index, double position);

/// Puts targets in the place of those there are; the readings of a number stay with it. Readings of
/// surplus targets go. False, and no change, unless they ascend strictly.
bool setTargets(PositioningMeasurement &measurement, std::span<const double> positions);

/// A new target before `index` (at the end for the number of targets), halfway to its neighbours, beyond the
/// ends as far as the next interval goes; without readings. Returns its index.
std::size_t insertTarget(PositioningMeasurement &measurement, std::size_t index);

/// Targets that nothing was read at in any run, set aside or refused readings included; none as long as a run
/// is empty, for it is still to be measured.
[[nodiscard]] std::vector<std::size_t> unmeasuredTargets(const PositioningMeasurement &measurement);

/// Removes targets with their readings.
void removeTargets(PositioningMeasurement &measurement, std::span<const std::size_t> indices);

/// New runs without readings before run `index` (at the end for the number of runs): one, or at the end of a
/// test that is approached from both sides one each way, ↑ first.
void insertRun(PositioningMeasurement &measurement, std::size_t index, Direction approach);
void addRuns(PositioningMeasurement &measurement);

/// Removes runs with their readings.
void removeRuns(PositioningMeasurement &measurement, std::span<const std::size_t> indices);

/// Lets `change` alter a copy of the measurement of a positioning test and puts it in its place: tests are
/// shared between documents and never changed where they are. Nothing happens where there is no such test.
void editReadings(Document &document, std::size_t index,
                  const std::function<void(PositioningMeasurement &)> &change);

} // namespace palmer
