// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws bars below each other into `area` (points): names at the left, bars on their scale, numbers at the
/// right, the scale below. Names that are too long for their third of the width are cut.
FigureTransform drawBarFigure(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium);

/// One bar in `rect`, which is the whole scale: `part` (0 … 1) of it. In whatever units the painter has.
void drawBar(QPainter &painter, const QRectF &rect, double part, bool first, Medium medium);

/// Height of the figure on the printed page, mm.
[[nodiscard]] double printedHeight(const BarFigure &figure);

} // namespace palmer
