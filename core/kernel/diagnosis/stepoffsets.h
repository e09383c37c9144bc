// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influencefit.h"

namespace palmer {

/// Where the steps of backlash and play lie beside the reversals by the angles of the file: the same way
/// round in both senses if all angles are turned, behind in the direction of travel if the path lags.
struct StepOffsets {
    bool seen = false; ///< there are steps
    Rotation rotation;
    double lag = 0;      ///< degrees behind the reversal, in the direction of travel
    double lagBound = 0; ///< it cannot be off by more
};

constexpr double stepReach = 4.9; ///< degrees from a reversal

/// `far` is fitted to rows farther than stepReach from a reversal; the offsets are those at which its
/// steps, with a spike of any height behind each, match the readings near the reversals: mean and spread of
/// their likelihood over ± 4°, so that a step is known no closer than the readings stand apart. With one
/// sense rotation and lag are the same; it counts as lag for commanded angles, as rotation otherwise.
[[nodiscard]] StepOffsets stepOffsets(const PathRows &rows, const InfluenceFit &far, bool commanded);

} // namespace palmer
