// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picturewidget.h"

#include "ui/theme.h"

#include <QEvent>
#include <QPainter>

namespace palmer::ui {

void PictureWidget::drawAnew() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (pixels.isEmpty() || (m_picture.size() == pixels && m_picture.devicePixelRatio() == ratio))
        return;
    m_picture = QPixmap(pixels);
    m_picture.setDevicePixelRatio(ratio);
    m_picture.fill(palette().color(QPalette::Base));
    QPainter painter(&m_picture);
    drawPicture(painter);
}

void PictureWidget::discardPicture() {
    m_picture = {};
    update();
}

void PictureWidget::paintEvent(QPaintEvent *) {
    drawAnew();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter);
    paintFocus(painter, *this);
}

void PictureWidget::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange ||
        event->type() == QEvent::FontChange)
        discardPicture();
    QWidget::changeEvent(event);
}

void paintFocus(QPainter &painter, const QWidget &canvas) {
    if (!canvas.hasFocus())
        return;
    painter.setPen(QPen(token(Token::accent, canvas.palette()), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(canvas.rect()).adjusted(1, 1, -1, -1), 3, 3);
}

} // namespace palmer::ui
