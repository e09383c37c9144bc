// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <span>

namespace palmer {

/// How a centre c sees points P, against how the origin sees them: the angle from P to P − c in degrees
/// (−180 … 180; 0 of the origin and of c themselves) and the distance |P − c| in mm. Quick where
/// |c| is below a thousandth of |P|. As many of each as points. Wide registers are used where the processor
/// has them; the numbers are the same on all.
void aboutCentre(PointsView points, Point centre, std::span<double> turns, std::span<double> distances);
/// With the registers every processor has.
void aboutCentreNarrow(PointsView points, Point centre, std::span<double> turns, std::span<double> distances);

} // namespace palmer
