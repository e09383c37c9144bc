// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/lineview.h"

#include "print/figures/drawfigure.h"
#include "ui/theme.h"

namespace palmer::ui {

void LineView::setFigure(const LineFigure &figure) {
    m_figure = figure;
    discardPicture();
}

void LineView::drawPicture(QPainter &painter) {
    drawFigure(painter, rect(), m_figure, screenMedium(palette()));
}

} // namespace palmer::ui
