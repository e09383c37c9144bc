// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws bars below each other into `area` (points): names on the left, bars on their scale, numbers on the
/// right, the scale below. Names wider than a third of the area are elided.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium);

/// Draws one bar over `part` (0 … 1) of `rect`, which represents the whole scale. Any unit of the painter.
void drawBar(QPainter &painter, const QRectF &rect, double part, bool first, Medium medium);

/// Printed height of the figure, mm.
[[nodiscard]] double printedHeight(const BarFigure &figure);

} // namespace palmer
