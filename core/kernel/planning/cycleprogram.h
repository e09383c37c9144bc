// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/targetplan.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// A program for the machine: approach the targets of a plan and stop at each.
struct CycleProgram {
    std::string axis = "X"; ///< letter of the axis, with its number if any ("X1")
    Motion motion = Motion::linear;
    std::vector<double> targets; ///< mm or degrees, ascending
    int decimals = 3;            ///< of all positions, 0 … 9
    int runs = 5;
    Cycle cycle = Cycle::standard;
    std::optional<double> feed; ///< mm/min or °/min; null: rapid
    double dwell = 5;           ///< s at each target, > 0: the instrument takes its reading during this time
    double approach = 1;        ///< overtravel before a target is approached, mm or degrees, > 0
    std::optional<Direction> only = {}; ///< of a test of one direction; null: both
};

/// Returns `program` adapted to another plan of the same measurement: its targets and, for a zone, its runs.
[[nodiscard]] CycleProgram programOf(const PlannedMeasurement &planned, CycleProgram program);

/// A move of the axis: to a target, where it stops, or beyond one, to reverse.
struct Move {
    double position = 0;      ///< mm or degrees
    std::optional<Stop> stop; ///< null: no stop
};

/// Returns the position where the axis reverses to reach a target from its side: at least the approach
/// distance beyond it, rounded to the program's decimals away from the target and never equal to it.
[[nodiscard]] double turningPoint(const CycleProgram &program, double target, Direction approach);

/// Returns all moves of the measuring cycle in chronological order. Before each reversal the axis goes to the
/// turning point of the target, so that every target is reached from its own side.
[[nodiscard]] std::vector<Move> cyclePath(const CycleProgram &program);

/// Returns the lowest and the highest position of the cycle; both 0 without targets.
[[nodiscard]] Interval movedThrough(const CycleProgram &program);

/// How far a cycle moves beyond its axis, mm or degrees; 0: it does not, or the axis is not known.
struct Overtravel {
    double below = 0;
    double above = 0;

    [[nodiscard]] bool any() const { return below > 0 || above > 0; }
};

/// Compares the cycle with the ends of the axis as the request has them; without them with its travel: what
/// is too much counts as above. A rotary axis of a full turn or more has no ends.
[[nodiscard]] Overtravel overtravelOf(const CycleProgram &program, const TargetRequest &request);

} // namespace palmer
