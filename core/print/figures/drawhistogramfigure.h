// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a histogram into `area` (points) over its axis: bars, darker inside the interval that holds 95.45 %
/// of the values, the evaluated value as a line, the mean dashed, and what these are below.
FigureTransform drawHistogramFigure(QPainter &painter, const QRectF &area, const HistogramFigure &figure,
                                    Medium medium);

/// The bars and the line of the evaluated value alone, as they fit into a row of a table. In whatever units
/// the painter has; `line`: width of the line.
void drawHistogramBars(QPainter &painter, const QRectF &plot, const HistogramFigure &figure, Medium medium,
                       double line);

} // namespace palmer
