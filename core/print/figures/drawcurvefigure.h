// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a curve figure into `area`, in points; the part of drawFigure for this kind.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const CurveFigure &figure, Medium medium);

} // namespace palmer
