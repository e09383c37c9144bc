// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "print/figures/style.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

class QPainter;

namespace palmer {

/// Where a drawn figure put its data, in the units of the painter it was drawn with.
struct FigureTransform {
    QRectF plotArea;
    QTransform toPainter;    ///< from the units of the axes (circles: mm from their centre); invertible
    double readingShift = 0; ///< marks of readings stand this much left (↑) or right (↓) of their target

    [[nodiscard]] QPointF map(double x, double y) const { return toPainter.map(QPointF(x, y)); }
    [[nodiscard]] QPointF toData(const QPointF &place) const { return toPainter.inverted().map(place); }
};

/// Size of the figure on the printed page, mm.
[[nodiscard]] QSizeF paperSize(const Figure &figure);

/// The one way to paint a figure, on screen, page and file. On paper the painter is scaled to points (1/72
/// inch) and `rect` is given in points; on a screen one unit is a pixel of 96 to the inch, whatever the
/// device really has. On screens the background is filled; dimensions beside the plot are drawn where there
/// is room for them. Vectors stay vectors. Needs a QApplication.
FigureTransform drawFigure(QPainter &painter, const QRectF &rect, const Figure &figure, Medium medium);

} // namespace palmer
