#pragma once

#include "figures/figure.h"
#include "ui/figures/style.h"

#include <QPainter>
#include <QRectF>

namespace palmer::ui {

/// The chart of a curve figure without its axes: bands, grid, edges and curves, clipped to `plot`, painted as
/// vectors by Qt Charts in a scene. `plot` lies in `area`; both in points of the painter. `gridX` and
/// `gridY`: where the lines of the grid lie, in units of the axes.
void paintChart(QPainter &painter, const QRectF &area, const QRectF &plot, const CurveFigure &figure,
                const std::vector<double> &gridX, const std::vector<double> &gridY, Medium medium);

} // namespace palmer::ui
