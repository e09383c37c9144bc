#pragma once

#include "kernel/measurement/positioning.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// What the machine is to do: approach the targets of a plan and stop at each.
struct CycleProgram {
    std::string axis = "X"; ///< letter of the axis, with a number where it has one ("X1")
    Motion motion = Motion::linear;
    std::vector<double> targets; ///< mm or degrees, ascending
    int decimals = 3;
    int runs = 5;
    Cycle cycle = Cycle::standard;
    std::optional<double> feed; ///< mm/min or °/min; null: rapid
    double dwell = 5;           ///< s at each target, > 0: the instrument takes its reading then
    double approach = 1;        ///< mm or degrees beyond the target before it is approached, > 0
};

} // namespace palmer
