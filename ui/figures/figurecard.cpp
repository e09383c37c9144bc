// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figurecard.h"

#include "print/figures/drawfigure.h"
#include "ui/theme.h"

namespace palmer::ui {

void FigureCard::setFigure(std::optional<Figure> figure) {
    if (m_figure == figure)
        return;
    m_figure = std::move(figure);
    discardPicture();
}

void FigureCard::drawPicture(QPainter &painter) {
    if (m_figure)
        drawFigure(painter, QRectF(rect()), *m_figure, screenMedium(palette()));
}

} // namespace palmer::ui
