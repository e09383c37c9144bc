// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/uncertainty/figurecard.h"

#include "print/figures/drawfigure.h"
#include "ui/rowtable.h"

#include <QEvent>
#include <QPainter>

namespace palmer::ui {

FigureCard::FigureCard(QWidget *parent)
    : QWidget(parent) {}

void FigureCard::setFigure(std::optional<Figure> figure) {
    if (m_figure == figure)
        return;
    m_figure = std::move(figure);
    m_drawn = {};
    update();
}

void FigureCard::paintEvent(QPaintEvent *) {
    if (!m_figure)
        return;
    const double ratio = devicePixelRatioF();
    const QSize size = (QSizeF(this->size()) * ratio).toSize();
    if (m_drawn.size() != size) {
        m_drawn = QPixmap(size);
        m_drawn.setDevicePixelRatio(ratio);
        QPainter painter(&m_drawn);
        drawFigure(painter, QRectF(rect()), *m_figure, screenMedium(palette()));
    }
    QPainter(this).drawPixmap(0, 0, m_drawn);
}

void FigureCard::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange) {
        m_drawn = {};
        update();
    }
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
