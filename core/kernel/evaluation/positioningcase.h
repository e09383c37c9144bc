// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/drift.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/surroundings.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The longest short axis, and the zone that has the full test of a longer one: 2 000 mm, 360°.
[[nodiscard]] constexpr double longestShort(Motion motion) {
    return motion == Motion::linear ? 2000 : 360;
}

/// The travel of the axis, mm, rotary: degrees: as stated, and never less than the measurement travel, which
/// the axis has gone.
[[nodiscard]] double judgedAxisTravel(const PositioningMeasurement &measurement);

/// The axis is longer than a short one.
[[nodiscard]] bool isLongAxis(const PositioningMeasurement &measurement);

/// A zone is stated and all targets lie in it, its ends included.
[[nodiscard]] bool isInsideZone(const PositioningMeasurement &measurement);

/// A positioning test and all that its requirements look at. Owns nothing.
struct PositioningCase {
    const Test &test;
    const PositioningMeasurement &measurement;
    const Surroundings &surroundings;
    const Edition &edition;
    std::span<const TargetStatistics> statistics;
    const std::optional<DriftStatistic> &drift;
    int positiveRuns = 0;
    int negativeRuns = 0;
    std::string withoutUncertainty = {}; ///< as resultsWithoutUncertainty

    [[nodiscard]] const PositioningConditions &conditions() const { return measurement.conditions; }
    [[nodiscard]] const Conditions &common() const { return measurement.conditions.common; }
    [[nodiscard]] bool linear() const { return measurement.axis.motion == Motion::linear; }

    /// As judgedAxisTravel.
    [[nodiscard]] double travel() const;
    /// The axis is longer than a short one.
    [[nodiscard]] bool longAxis() const;
    /// All targets lie in the agreed zone of a long axis: judged as a short one.
    [[nodiscard]] bool zoneTest() const;
    /// What the number of targets is asked for: the zone of a zone test, else the travel.
    [[nodiscard]] double judgedTravel() const;
    /// A test of a long axis over its whole travel.
    [[nodiscard]] bool wholeTravelOfLongAxis() const { return longAxis() && !zoneTest(); }

    [[nodiscard]] bool agreed(std::string_view point) const;
};

} // namespace palmer
