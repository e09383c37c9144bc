// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QBrush>
#include <QColor>
#include <QPen>

namespace palmer {

/// Output medium of a figure. Paper stays readable in black and white: dashes and markers repeat the
/// information of the colours.
enum class Medium { screenLight, screenDark, paper };

/// Parts of a figure with their own appearance.
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
    planeAxis, ///< in a circle figure
    envelope,
    limit,
    centre,        ///< mark +
    drift,         ///< readings at rest
    bar,           ///< in a bar figure
    firstBar,      ///< to be improved first
    barGround,     ///< from the end of a bar to the end of its scale
    histogram,     ///< inside the stated interval
    histogramTail, ///< outside the stated interval
    evaluated,     ///< value evaluated from the readings
    trialMean,     ///< mean of the trials
    guardBand,     ///< outline of the band about a limit
    guardFill,
    synthetic, ///< computed from sources of a diagnosis
    residual,  ///< width for overlapping lines
};

constexpr double pointsPerMillimetre = 72 / 25.4;
constexpr double mm = pointsPerMillimetre;
constexpr double pointsPerPixel = 72.0 / 96.0; ///< of a screen

/// The path of a sense; which of the two is heavy says its width.
[[nodiscard]] constexpr FigureRole pathRole(Sense sense) {
    return sense == Sense::counterclockwise ? FigureRole::counterclockwise : FigureRole::clockwise;
}

/// Colour, width and dashes of a role; widths in points.
[[nodiscard]] QPen figurePen(FigureRole role, Medium medium);
[[nodiscard]] QColor figureColor(FigureRole role, Medium medium);

/// Pen of test `layer` in a figure of several tests, which differ in colours and dashes.
[[nodiscard]] QPen layerPen(int layer, Medium medium);

/// `colour` laid over `ground` with an opacity of `strength`, 0 … 1; opaque.
[[nodiscard]] QColor blend(const QColor &colour, const QColor &ground, double strength);

/// Fill between the limits of one direction, or of the overlap of both. Opaque, because archival PDF and some
/// printers do not support transparency.
[[nodiscard]] QColor bandColor(bool up, bool down, Medium medium);

} // namespace palmer
