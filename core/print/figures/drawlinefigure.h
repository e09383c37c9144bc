// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a line figure into `area`, in points; see drawFigure(). The legend takes as many rows as needed.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const LineFigure &figure, Medium medium);

/// Colour, width (points) and dashes of a line.
[[nodiscard]] QPen linePen(LineRole role, Medium medium);

} // namespace palmer
