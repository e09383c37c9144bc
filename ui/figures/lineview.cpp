// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/lineview.h"

#include "print/figures/drawfigure.h"
#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

void LineView::setFigure(const LineFigure &figure) {
    m_figure = figure;
    update();
}

void LineView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    drawFigure(painter, rect(), m_figure, isDark(palette()) ? Medium::screenDark : Medium::screenLight);
}

} // namespace palmer::ui
