// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "ui/figures/style.h"

#include <QPainter>
#include <QRectF>

namespace palmer::ui {

/// Edges of the limits and curves of a figure, painted by Qt Charts in a scene: vectors, clipped to `plot`,
/// which is the range of the axes and lies in `area`; both in points of the painter. A curve or band of one
/// target is none.
void paintCurves(QPainter &painter, const QRectF &area, const QRectF &plot, const CurveFigure &figure,
                 Medium medium);

} // namespace palmer::ui
