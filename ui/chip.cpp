// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chip.h"

#include "ui/elidedlabel.h"

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
    drawElided(painter, rect().adjusted(left, 0, 0, 0), Qt::AlignLeft, m_text, themeFont(TextSize::small),
               colour);
}

} // namespace palmer::ui
