// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/style.h"

namespace palmer {

// Axes of a plot, points.
inline constexpr double tickLength = 1.2 * mm;
inline constexpr double tickGap = 1.0 * mm;     ///< between a tick and its number, perpendicular to the axis
inline constexpr double tickRow = 3.5 * mm;     ///< centre of the numbers below the plot
inline constexpr double titleCentre = 2.3 * mm; ///< of the rotated title, from the left edge

// Mark that follows the pointer, pixels.
inline constexpr double pointerReach = 14;
inline constexpr double ringRadius = 6.5;

} // namespace palmer
