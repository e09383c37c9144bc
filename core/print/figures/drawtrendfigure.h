// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a row of small trends, or a single one with its names and legend. `area` in points.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const TrendFigure &figure, Medium medium);

} // namespace palmer
