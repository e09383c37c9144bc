// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <map>
#include <vector>

namespace palmer {

/// A line of a list whose column of directions has numbers.
struct CodedTarget {
    double code = 0;
    double run = 0; ///< 0 if the table does not number the runs
    double target = 0;
};

/// Meaning of the numbers in a column of directions: +1 and −1, or two of 0, 1, 2.
struct DirectionCodes {
    enum class Origin {
        stated,  ///< +1 and −1
        ordered, ///< targets ascend under one code and descend under the other
        usual,   ///< a single code
        unclear, ///< the order says nothing, or something against the usual reading
    };
    std::map<double, Direction> directions;
    Origin origin = Origin::usual;
};

/// The lines are in file order.
[[nodiscard]] DirectionCodes directionCodes(const std::vector<CodedTarget> &lines);

} // namespace palmer
