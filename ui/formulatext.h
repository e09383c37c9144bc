// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/words/formula.h"

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRect>

namespace palmer::ui {

// Formulas and symbols on the screen: subscripts set lower, arrows and overlined letters in the font that has
// them, the bar over B drawn.

/// Width of a formula in the font, pixels.
[[nodiscard]] double formulaWidth(const Formula &formula, const QFont &font);

/// Draws a formula on one line into the area. Spans of a direction take its colour.
void drawFormula(QPainter &painter, const QRectF &area, Qt::Alignment alignment, const Formula &formula,
                 const QFont &font, const QColor &colour, bool strong = false);

/// Draws a formula broken at its spaces into lines of the width of the area, from the top; returns the height
/// it took. Without painter it only measures. `palette` gives the colours of the directions.
double drawFormulaLines(QPainter *painter, const QRectF &area, const Formula &formula, const QFont &font,
                        const QColor &colour, const QPalette &palette, double indent = 0);

} // namespace palmer::ui
