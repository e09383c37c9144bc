// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/figures/drawfigure.h"

namespace palmer::ui {

/// Draws a circle figure into `area`, in points; the part of drawFigure for this kind. The figure keeps its
/// proportions: where the area has others it is drawn as large as it fits. On paper the key stands below, on
/// a screen in the corners, as far as it has room there beside the circles.
FigureTransform drawCircleFigure(QPainter &painter, const QRectF &area, const CircleFigure &figure,
                                 Medium medium);

} // namespace palmer::ui
