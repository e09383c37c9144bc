// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

// Painters of drawFigure, one per kind of figure; `area` in points.

/// Means, limits, readings and dimensions.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const CurveFigure &figure, Medium medium);

/// The legend takes as many rows as needed.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const LineFigure &figure, Medium medium);

/// The figure keeps its proportions and is drawn as large as it fits. On paper the key is below, on a screen
/// in the corners if it has room next to the circles. If the figure is reduced, the nominal circle shrinks
/// and the deviations keep the stated magnification.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium);

/// Bars below each other: names on the left, bars on their scale, numbers on the right, the scale below.
/// Names wider than a third of the area are elided.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium);

/// A histogram over its axis: bars, darker inside the interval that contains 95.45 % of the values, the
/// evaluated value as a line, the mean dashed, and the legend below.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const HistogramFigure &figure, Medium medium);

/// A row of small trends, or a single one with its names and legend.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const TrendFigure &figure, Medium medium);

/// Colour, width (points) and dashes of a line.
[[nodiscard]] QPen linePen(LineRole role, Medium medium);

/// Right limit for a text in the upper left corner: the left end of the sense labels outside the circles,
/// otherwise the right end of the area; in points, like the area.
[[nodiscard]] double leftOfSenses(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                  Medium medium);

/// Least height, mm with the key, at which a circle figure can keep its magnification.
[[nodiscard]] double leastHeight(const CircleFigure &figure);

/// Draws one bar over `part` (0 … 1) of `rect`, which represents the whole scale. Any unit of the painter.
void drawBar(QPainter &painter, const QRectF &rect, double part, bool first, Medium medium);

/// Printed height of the figure, mm.
[[nodiscard]] double printedHeight(const BarFigure &figure);

/// Draws only the bars and the line of the evaluated value, for a table row. Any unit of the painter; `line`:
/// width of the line.
void drawHistogramBars(QPainter &painter, const QRectF &plot, const HistogramFigure &figure, Medium medium,
                       double line);

} // namespace palmer
