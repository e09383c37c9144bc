// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QBrush>
#include <QColor>
#include <QPen>

namespace palmer {

/// What a figure is drawn on. Paper stays readable in black and white: dashes and markers tell what colours
/// tell.
enum class Medium { screenLight, screenDark, paper };

/// The parts of a figure that have a look of their own.
enum class FigureRole {
    background,
    text,
    grid,
    zeroLine,
    axis,
    up,   ///< x̄↑
    down, ///< x̄↓
    mean,
    upEdge, ///< edges of the limits x̄ ± c·s
    downEdge,
    upMarker, ///< outline
    downMarker,
    reading, ///< outline of the open marks
    dimension,
    leader,
    counterclockwise,
    clockwise,
    ring, ///< divisions of a circle figure, and its spokes
    nominal,
    planeAxis, ///< of a circle figure
    envelope,
    limit,
    centre,        ///< the mark +
    drift,         ///< readings at rest
    bar,           ///< of a bar figure
    firstBar,      ///< what is to be improved first
    barGround,     ///< from the end of a bar to that of its scale
    histogram,     ///< inside the interval that is stated
    histogramTail, ///< outside of it
    evaluated,     ///< value evaluated from the readings
    trialMean,     ///< mean of the trials
    guardBand,     ///< outline of the band about a limit
    guardFill,
    synthetic, ///< what sources of a diagnosis make
    residual,  ///< lines that lie on one another: the width
};

constexpr double pointsPerMillimetre = 72 / 25.4;
constexpr double mm = pointsPerMillimetre;
constexpr double pointsPerPixel = 72.0 / 96.0; ///< of a screen

/// Colour, width and dashes of a role; widths in points.
[[nodiscard]] QPen figurePen(FigureRole role, Medium medium);
[[nodiscard]] QColor figureColor(FigureRole role, Medium medium);

/// Of test `layer` among several over one another: colours and dashes tell them apart.
[[nodiscard]] QPen layerPen(int layer, Medium medium);

/// `colour` laid over `ground` with an opacity of `strength`, 0 … 1; opaque.
[[nodiscard]] QColor blend(const QColor &colour, const QColor &ground, double strength);

/// Fill between the limits of one direction, or where those of both lie over each other. Opaque: archival PDF
/// and some printers do not know transparency.
[[nodiscard]] QColor bandColor(bool up, bool down, Medium medium);

} // namespace palmer
