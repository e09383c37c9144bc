// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chip.h"

#include <QFontMetrics>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int chipHeight = 22;
constexpr int chipMarkWidth = 22;
constexpr int margin = 9;

} // namespace

Chip::Chip(QWidget *parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Chip::setContent(const QString &text, const QString &icon, Token colour, Token ground) {
    m_text = text;
    m_icon = icon;
    m_colour = colour;
    m_ground = ground;
    setAccessibleName(text);
    updateGeometry();
    update();
}

QSize Chip::sizeHint() const {
    const int mark = m_icon.isEmpty() ? margin : chipMarkWidth + 4;
    return {QFontMetrics(themeFont(TextSize::small)).horizontalAdvance(m_text) + mark + margin, chipHeight};
}

void Chip::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(token(m_ground, palette()));
    painter.drawRoundedRect(rect(), 4, 4);
    const QColor colour = token(m_colour, palette());
    int left = margin;
    if (!m_icon.isEmpty()) {
        drawLineIcon(painter, QRect(5, 0, chipMarkWidth - 2, height()), m_icon, colour);
        left = chipMarkWidth + 4;
    }
    painter.setFont(themeFont(TextSize::small));
    painter.setPen(colour);
    const QRect room = rect().adjusted(left, 0, 0, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(m_text, Qt::ElideRight, room.width()));
}

} // namespace palmer::ui
