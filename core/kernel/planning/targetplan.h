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

/// What a plan of targets is made of. Lengths in mm, of rotary axes in degrees.
struct TargetRequest {
    TargetRule rule = TargetRule::nominalInterval;
    Motion motion = Motion::linear;
    double from = 0;              ///< first end of the measurement travel
    double travel = 0;            ///< length of the measurement travel, > 0
    double perMetre = 5;          ///< targets per metre, of linear axes; > 0
    std::optional<double> period; ///< of the cyclic errors (pitch), > 0; null: unknown
    /// Of the axis, where it is stated: that of a short axis is what the number of targets is asked for.
    std::optional<double> axisTravel = {};
    std::optional<Interval> axisRange = {}; ///< ends of the axis, where they are stated
    std::optional<Interval> zone = {};      ///< of a long axis: what is planned is the full test in it
    int decimals = 3;                       ///< of the positions: the resolution of the axis, 0 … 9
    std::uint64_t seed = 1;
};

struct TargetPlan {
    std::vector<double> targets; ///< strictly ascending; empty for a request that has no answer
    /// Nominal interval p; null: quarter turns and free targets have none.
    std::optional<double> interval;
    /// Largest |r| (1988: length of the range of r), mm or degrees; beside quarter turns the length of the
    /// parts of the travel of which each has a free target.
    double randomPart = 0;
    int runs = 5; ///< approaches each way
    /// Planned for 1988 without a pitch that fits: the bound of ± 30 % is that of ISO 230-2:2006.
    bool boundOf2006 = false;
};

/// A request and what it gave.
struct PlannedMeasurement {
    TargetRequest request;
    TargetPlan plan;
};

/// Most targets of one plan.
inline constexpr std::size_t mostTargets = 10'000;

/// The targets of a test, after the rules of ISO 230-2 (positioning of linear axes: 4.2, 4.3.2).
///
/// Number: linear max(5, ⌈perMetre · travel in metres⌉); rotary 3 up to 90°, 5 up to 180°, 8 above, beyond a
/// full turn 8 a turn and the end. Random part: new for every target, uniform within ± the period, or half
/// of it, so that each phase of the periodic error is as likely, and never beyond ± 30 % of the interval,
/// which holds where the period is unknown and keeps the targets apart where it is long (a rule of 2006,
/// which 1988 has none in place of: the plan says so); 1988 within [0, p) after the N-th pitch. 1988, rotary
/// of any travel: all multiples of 90° of the travel, and one chosen freely in each third of it, of longer
/// ones in each third of a turn. All targets lie inside the measurement travel, whose ends the nominal
/// interval leaves room for, so that every random part is free; the end of a full turn is its beginning and
/// has no target of its own. They are rounded to the resolution towards its inside. The same seed gives
/// the same plan on every machine. Approaches: 5 each way; 1 over more than 2 000 mm or 360° (1988: mm),
/// where the standard asks for a full test of an agreed zone besides, of which 5. That the random parts may
/// leave less than that is allowed for where the travel of the axis is not stated. A plan meets what its
/// edition asks of targets and approaches: random parts are drawn anew until it does. Bad input (travel or
/// number not positive, not finite, more than 10 000 targets, a resolution too coarse to tell the targets
/// apart) gives a plan without targets.
[[nodiscard]] TargetPlan planTargets(const TargetRequest &request);

/// The request for an axis with these ends, which approaches its targets from both sides: between them with
/// the approach distance on either side. A rotary axis of a full turn and more has no ends; that of quarter
/// turns (1988) is to reach both, and its ends lie beyond.
[[nodiscard]] TargetRequest withinAxis(TargetRequest request, const Interval &ends, double approach);

/// All that an axis is to be measured for: the travel asked for, and of a long axis the full test of a zone
/// of 2 000 mm (360°) besides, which lies in the middle where none is asked for. The zone of the request is
/// that one too, unless the travel lies inside. None where the request has no answer. 1988 has no long rotary
/// axes.
[[nodiscard]] std::vector<PlannedMeasurement> planMeasurements(TargetRequest request,
                                                               std::optional<Interval> zone = {});

/// One stop of the measuring cycle: which target is approached from which side in which run, from 0.
struct Stop {
    std::size_t target = 0;
    int run = 0;
    Direction approach = Direction::positive;

    bool operator==(const Stop &) const = default;
};

/// The stops of a cycle in the order of time. Standard: ↑ 1 … m, ↓ m … 1, again for each run. Step: at every
/// target all runs, from below and from above in turn.
[[nodiscard]] std::vector<Stop> measuringCycle(std::size_t targets, int runs, Cycle cycle);

} // namespace palmer
