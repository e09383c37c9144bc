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

/// The longest short axis, which is also the zone for the full test of a longer one: 2 000 mm, 360°.
[[nodiscard]] constexpr double longestShort(Motion motion) {
    return motion == Motion::linear ? 2000 : 360;
}

/// Returns the axis travel, mm, rotary: degrees: as stated, but at least the measurement travel actually
/// covered.
[[nodiscard]] double judgedAxisTravel(const PositioningMeasurement &measurement);

/// True if the axis is longer than a short one.
[[nodiscard]] bool isLongAxis(const PositioningMeasurement &measurement);

/// True if a zone is stated and contains all targets, ends included.
[[nodiscard]] bool isInsideZone(const PositioningMeasurement &measurement);

/// A positioning test with all inputs of its requirements. Owns nothing.
struct PositioningCase {
    const Test &test;
    const PositioningMeasurement &measurement;
    const Surroundings &surroundings;
    const Edition &edition;
    std::span<const TargetStatistics> statistics;
    const std::optional<DriftStatistic> &drift;
    int positiveRuns = 0;
    int negativeRuns = 0;
    std::string withoutUncertainty = {}; ///< from resultsWithoutUncertainty

    [[nodiscard]] const PositioningConditions &conditions() const { return measurement.conditions; }
    [[nodiscard]] const Conditions &common() const { return measurement.conditions.common; }
    [[nodiscard]] bool linear() const { return measurement.axis.motion == Motion::linear; }

    /// Returns judgedAxisTravel().
    [[nodiscard]] double travel() const;
    /// True if the axis is longer than a short one.
    [[nodiscard]] bool longAxis() const;
    /// True if all targets lie in the agreed zone of a long axis: judged as a short one.
    [[nodiscard]] bool zoneTest() const;
    /// Returns the travel that determines the number of targets: the zone for a zone test.
    [[nodiscard]] double judgedTravel() const;
    /// True for a test of a long axis over its whole travel.
    [[nodiscard]] bool wholeTravelOfLongAxis() const { return longAxis() && !zoneTest(); }

    [[nodiscard]] bool agreed(std::string_view point) const;
};

} // namespace palmer
