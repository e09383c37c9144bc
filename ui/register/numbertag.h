// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <QColor>
#include <QPalette>
#include <QPointF>

class QPainter;

namespace palmer::ui {

/// The number of a chosen test in table, trend and curves: a filled circle in the colour of its curve.
inline constexpr double tagRadius = 8;
inline constexpr double leastTagDistance = 19; ///< between the centres of two, px

/// The colour of a curve, indexed from 0.
[[nodiscard]] QColor curveColour(std::size_t curve, const QPalette &palette);

/// `number` from 1.
void drawNumberTag(QPainter &painter, const QPointF &centre, int number, const QPalette &palette);

/// The mark of a test of the first series by its role: as found hollow, as left filled, not stated a
/// triangle.
inline constexpr double trendMarkRadius = 4.2;
void drawRoleMark(QPainter &painter, const QPointF &centre, TrendMark mark, const QColor &colour,
                  const QPalette &palette);

} // namespace palmer::ui
