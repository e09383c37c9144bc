#pragma once

#include "ui/figures/drawfigure.h"

namespace palmer::ui {

/// Draws a curve figure into `area`, in points; the part of drawFigure for this kind.
FigureTransform drawCurveFigure(QPainter &painter, const QRectF &area, const CurveFigure &figure,
                                Medium medium);

} // namespace palmer::ui
