// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a circle figure into `area`, in points; the part of drawFigure for this kind. The figure keeps its
/// proportions and is drawn as large as it fits. On paper the key is below, on a screen in the corners if it
/// has room next to the circles. If the figure is reduced, the nominal circle shrinks and the deviations keep
/// the stated magnification.
FigureTransform drawKind(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium);

/// Right limit for a text in the upper left corner: the left end of the sense labels outside the circles,
/// otherwise the right end of the area; in points, like the area.
[[nodiscard]] double leftOfSenses(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                  Medium medium);

/// Least height, mm with the key, at which a circle figure can keep its magnification.
[[nodiscard]] double leastHeight(const CircleFigure &figure);

} // namespace palmer
