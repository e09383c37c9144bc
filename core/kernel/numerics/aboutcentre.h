// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <span>

namespace palmer {

/// Compares points P seen from a centre c with the view from the origin: the angle from P to P − c in degrees
/// (−180 … 180; 0 for the origin and for c itself) and the distance |P − c| in mm. Fast while |c| is below a
/// thousandth of |P|. Output spans have the size of `points`. Uses wide registers if the processor has them;
/// results are identical on all.
void aboutCentre(PointsView points, Point centre, std::span<double> turns, std::span<double> distances);
/// Uses only the registers every processor has.
void aboutCentreNarrow(PointsView points, Point centre, std::span<double> turns, std::span<double> distances);

} // namespace palmer
