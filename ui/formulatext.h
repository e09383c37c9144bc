// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/words/formula.h"

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRect>

namespace palmer::ui {

// Formulas and symbols on screen: subscripts set lower, arrows and overlined letters in a font that has them,
// the bar over B drawn.

/// Width of a formula in the font, pixels.
[[nodiscard]] double formulaWidth(const Formula &formula, const QFont &font);

/// Draws a formula on one line in the area. Spans of a direction are in its colour.
void drawFormula(QPainter &painter, const QRectF &area, Qt::Alignment alignment, const Formula &formula,
                 const QFont &font, const QColor &colour, bool strong = false);

/// Draws a formula in lines broken at spaces to the width of the area, from the top; returns their height.
/// Without painter it only measures. `palette` gives the colours of the directions.
double drawFormulaLines(QPainter *painter, const QRectF &area, const Formula &formula, const QFont &font,
                        const QColor &colour, const QPalette &palette, double indent = 0);

} // namespace palmer::ui
