// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/canvaslabel.h"

#include "print/figures/metrics.h"
#include "ui/theme.h"

#include <QPainter>
#include <algorithm>

namespace palmer::ui {

void paintCanvasLabel(QPainter &painter, const QWidget &canvas, QPointF beside, const QString &text,
                      const QColor &colour) {
    painter.setFont(themeFont(TextSize::tiny));
    const QSizeF size(painter.fontMetrics().horizontalAdvance(text) + 12.0,
                      painter.fontMetrics().height() + 4.0);
    QRectF label(QPointF(beside.x() + 14, beside.y() - size.height() / 2), size);
    if (label.right() > canvas.width() - 2)
        label.moveRight(beside.x() - 14);
    label.moveLeft(std::max(2.0, label.left()));
    label.moveTop(std::clamp(label.top(), 2.0, std::max(2.0, canvas.height() - size.height() - 2)));
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(canvas.palette().color(QPalette::Base));
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(canvas.palette().color(QPalette::Text));
    painter.drawText(label, Qt::AlignCenter, text);
}

void paintPointed(QPainter &painter, const QWidget &canvas, QPointF at, const QString &text) {
    const QColor accent = token(Token::accent, canvas.palette());
    painter.setPen(QPen(accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, ringRadius, ringRadius);
    if (!text.isEmpty())
        paintCanvasLabel(painter, canvas, at, text, accent);
}

} // namespace palmer::ui
