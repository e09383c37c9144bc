// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/style.h"

namespace palmer {

/// Measures of a plot with straight axes and of what is around it, points.
struct FrameMeasures {
    double title = 0;           ///< centre of the title of x, below the plot; 0: next to the numbers
    double legend = 0;          ///< centre of the first row of the legend, below the plot
    double sampleWidth = 0;     ///< in the legend
    double sampleHeight = 0;    ///< 0: only lines
    double sampleGap = 0;       ///< between a sample and its text
    double entryGap = 0;        ///< between two entries, at most
    double leastEntryGap = 0;   ///< if the legend is in one row
    bool numbersInArea = false; ///< true: numbers of x at the ends are moved into the area
    double numbers = 3.5 * mm;  ///< centre of the numbers of x, below `numbersFrom`
    double numbersFrom = 0;     ///< below the plot
    double tick = 1.2 * mm;     ///< length
    double tickGap = 1.0 * mm;  ///< between a tick of y and its number
};

// clang-format off
//                                            title     legend     sample: width, height, gap  gap, least      in area
inline constexpr FrameMeasures curveOnPaper  {8.1 * mm, 13.4 * mm, 10 * mm, 3 * mm, 2 * mm,   14 * mm, 3.5 * mm};
inline constexpr FrameMeasures curveOnScreen {0,        23,        22,      3 * mm, 4.5,      18,  4.5, false, 9.75};
inline constexpr FrameMeasures lineFrame     {7.4 * mm, 12 * mm,   10 * mm, 0,      2 * mm,   7 * mm,  7 * mm};
inline constexpr FrameMeasures histogramFrame{7.8 * mm, 13 * mm, 5 * mm, 2.6 * mm, 1.5 * mm, 5 * mm, 1.5 * mm, true};
inline constexpr FrameMeasures barFrame      {8.1 * mm, 13 * mm,   7 * mm, 0,      1.5 * mm, 5 * mm,  5 * mm};
// clang-format on
inline constexpr FrameMeasures trendFrame{
    .numbers = 3.2 * mm / 1.6, .numbersFrom = 0.8 * mm, .tick = 0.8 * mm, .tickGap = 0.7 * mm};

inline constexpr double titleCentre = 2.3 * mm; ///< of the rotated title, from the left edge
inline constexpr double legendPitch = 4.2 * mm; ///< between rows
inline constexpr double dotRadius = 0.8 * mm;   ///< of a value

// Mark that follows the pointer, pixels.
inline constexpr double pointerReach = 14;
inline constexpr double ringRadius = 6.5;

} // namespace palmer
