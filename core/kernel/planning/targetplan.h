// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/positioning.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace palmer {

/// Input of a plan of targets. Lengths in mm, for rotary axes in degrees.
struct TargetRequest {
    TargetRule rule = TargetRule::nominalInterval;
    Motion motion = Motion::linear;
    double from = 0;              ///< first end of the measurement travel
    double travel = 0;            ///< length of the measurement travel, > 0
    double perMetre = 5;          ///< targets per metre, linear axes only; > 0
    std::optional<double> period; ///< of the cyclic errors (pitch), > 0; null: unknown
    /// Travel of the axis, if stated: for a short axis it determines the number of targets.
    std::optional<double> axisTravel = {};
    std::optional<Interval> axisRange = {}; ///< ends of the axis, if stated
    std::optional<Interval> zone = {};      ///< zone of a long axis, of which the plan is the full test
    int decimals = 3;                       ///< of the positions: the resolution of the axis, 0 … 9
    std::uint64_t seed = 1;
};

struct TargetPlan {
    std::vector<double> targets; ///< strictly ascending; empty if the request cannot be met
    /// Nominal interval p; null for quarter turns with free targets.
    std::optional<double> interval;
    /// Largest |r| (1988: length of the range of r), mm or degrees; for quarter turns the length of each part
    /// of the travel that gets one free target.
    double randomPart = 0;
    int runs = 5;        ///< approaches per direction
    bool ofTest = false; ///< the targets of a test, not chosen by a rule
    /// True if planned for 1988 without a usable pitch: the bound of ± 30 % is from ISO 230-2:2006.
    bool boundOf2006 = false;
};

/// A request and its plan.
struct PlannedMeasurement {
    TargetRequest request;
    TargetPlan plan;
};

/// Largest number of targets in a plan.
inline constexpr std::size_t mostTargets = 10'000;

/// Returns the targets of a test by the rules of ISO 230-2 (positioning of linear axes: 4.2, 4.3.2).
///
/// Number: linear max(5, ⌈perMetre · travel in metres⌉); rotary 3 up to 90°, 5 up to 180°, 8 above; beyond a
/// full turn 8 per turn plus the end. Random part: drawn for every target, uniform within ± the period or
/// half of it, so that all phases of the periodic error are equally likely, and never beyond ± 30 % of the
/// interval. This bound applies if the period is unknown and keeps the targets apart if it is long (a rule of
/// 2006; 1988 has none of its own, and the plan says so). 1988: within [0, p) after the N-th pitch. 1988,
/// rotary with any travel: all multiples of 90° in the travel, and one free target in each third of it, or in
/// each third of a turn if it is longer. All targets lie inside the measurement travel; the nominal interval
/// leaves room at its ends, so that every random part is free. The end of a full turn is its beginning and
/// has no target of its own. Positions are rounded to the resolution, staying inside. The same seed gives the
/// same plan on every machine. Approaches: 5 per direction; 1 over more than 2 000 mm or 360° (1988: mm),
/// where the standard also asks for a full test of an agreed zone with 5. If the axis travel is not stated,
/// the plan allows for random parts that leave less than that. Random parts are drawn again until the plan
/// meets the requirements of its edition on targets and approaches. Bad input (travel or number not positive
/// or not finite, more than 10 000 targets, a resolution too coarse to separate the targets) gives a plan
/// without targets.
[[nodiscard]] TargetPlan planTargets(const TargetRequest &request);

/// Returns the request for an axis with these ends whose targets are approached from both sides: the travel
/// between the ends less the approach distance on either side. A rotary axis of a full turn or more has no
/// ends; with quarter turns (1988) the targets include both ends, and the axis extends beyond them.
[[nodiscard]] TargetRequest withinAxis(TargetRequest request, const Interval &ends, double approach);

/// Returns all measurements an axis needs: the requested travel and, for a long axis, also the full test of a
/// zone of 2 000 mm (360°), in the middle by default. A zone in the request is used for it, unless the travel
/// lies inside (the request then is that test). Empty if the request cannot be met. 1988 has no long rotary
/// axes.
[[nodiscard]] std::vector<PlannedMeasurement> planMeasurements(TargetRequest request,
                                                               std::optional<Interval> zone = {});

/// One stop of the measuring cycle: target, run (both from 0) and direction of approach.
struct Stop {
    std::size_t target = 0;
    int run = 0;
    Direction approach = Direction::positive;

    bool operator==(const Stop &) const = default;
};

/// Returns the stops of a cycle in chronological order. Standard: ↑ 1 … m, ↓ m … 1, repeated for each run.
/// Step: all runs at each target, alternating between positive and negative approach.
[[nodiscard]] std::vector<Stop> measuringCycle(std::size_t targets, int runs, Cycle cycle);

} // namespace palmer
