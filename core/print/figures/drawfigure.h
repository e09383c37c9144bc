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

/// Maps the data of a drawn figure to the units of its painter.
struct FigureTransform {
    QRectF plotArea;
    QTransform toPainter;    ///< from axis units (circles: mm from their centre); invertible
    double readingShift = 0; ///< marks of readings are this far left (↑) or right (↓) of their target

    [[nodiscard]] QPointF map(double x, double y) const { return toPainter.map(QPointF(x, y)); }
    [[nodiscard]] QPointF toData(const QPointF &place) const { return toPainter.inverted().map(place); }
};

/// Printed size of the figure, mm.
[[nodiscard]] QSizeF paperSize(const Figure &figure);

/// Paints a figure of any kind, on screen, page or file. On paper the painter is scaled to points (1/72 inch)
/// and `rect` is in points; on a screen one unit is a pixel at 96 dpi, whatever the device has. On screens
/// the background is filled, and dimensions next to the plot are drawn if they fit. Vectors stay vectors.
/// Requires a QApplication.
FigureTransform drawFigure(QPainter &painter, const QRectF &rect, const Figure &figure, Medium medium);

} // namespace palmer
