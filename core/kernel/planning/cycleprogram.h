// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/planning/targetplan.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// What the machine is to do: approach the targets of a plan and stop at each.
struct CycleProgram {
    std::string axis = "X"; ///< letter of the axis, with a number where it has one ("X1")
    Motion motion = Motion::linear;
    std::vector<double> targets; ///< mm or degrees, ascending
    int decimals = 3;            ///< of all positions, 0 … 9
    int runs = 5;
    Cycle cycle = Cycle::standard;
    std::optional<double> feed; ///< mm/min or °/min; null: rapid
    double dwell = 5;           ///< s at each target, > 0: the instrument takes its reading then
    double approach = 1;        ///< mm or degrees beyond the target before it is approached, > 0
};

/// The program of another plan of the same measurement: its targets, and of a zone its runs.
[[nodiscard]] CycleProgram programOf(const PlannedMeasurement &planned, CycleProgram program);

/// A move of the axis: to a target, where it rests, or beyond one, to turn round.
struct Move {
    double position = 0;      ///< mm or degrees
    std::optional<Stop> stop; ///< null: no rest
};

/// Where the axis turns round to reach a target from its side: at least the approach distance beyond it, as a
/// position of the decimals of the program, rounded away from the target, so that it never falls upon it.
[[nodiscard]] double turningPoint(const CycleProgram &program, double target, Direction approach);

/// All moves of the measuring cycle in the order of time: before the direction turns the axis goes to the
/// turning point of the target, so that every target is reached from its own side.
[[nodiscard]] std::vector<Move> cyclePath(const CycleProgram &program);

} // namespace palmer
