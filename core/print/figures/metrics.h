// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/style.h"

namespace palmer {

// Of the axes of a plot, points.
inline constexpr double tickLength = 1.2 * mm;
inline constexpr double tickGap = 1.0 * mm;     ///< from a tick to its number, across
inline constexpr double tickRow = 3.5 * mm;     ///< centre of the numbers below the plot
inline constexpr double titleCentre = 2.3 * mm; ///< of the rotated title, from the left edge

// Of the mark that follows the pointer, pixels.
inline constexpr double pointerReach = 14;
inline constexpr double ringRadius = 6.5;

} // namespace palmer
