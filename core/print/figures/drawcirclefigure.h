// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

namespace palmer {

/// Draws a circle figure into `area`, in points; the part of drawFigure for this kind. The figure keeps its
/// proportions: where the area has others it is drawn as large as it fits. On paper the key stands below, on
/// a screen in the corners, as far as it has room there beside the circles. Where it is drawn smaller than it
/// is, the nominal circle gives way and the deviations keep the magnification that is stated.
FigureTransform drawCircleFigure(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                 Medium medium);

/// Where a text in the upper left corner has to end: the left end of the letters of a sense that stand beside
/// the circles, else the right end of the area; in points, as the area.
[[nodiscard]] double leftOfSenses(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                  Medium medium);

/// The least height, mm with the key, at which a circle figure can keep its magnification.
[[nodiscard]] double leastHeight(const CircleFigure &figure);

} // namespace palmer
