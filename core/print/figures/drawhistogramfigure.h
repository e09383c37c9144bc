// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a histogram into `area` (points) over its axis: bars, darker inside the interval that contains 95.45
/// % of the values, the evaluated value as a line, the mean dashed, and the legend below.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const HistogramFigure &figure, Medium medium);

/// Draws only the bars and the line of the evaluated value, for a table row. Any unit of the painter; `line`:
/// width of the line.
void drawHistogramBars(QPainter &painter, const QRectF &plot, const HistogramFigure &figure, Medium medium,
                       double line);

} // namespace palmer
