// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chip.h"

#include "ui/elidedlabel.h"

#include <QFontMetrics>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int chipHeight = 24;
constexpr int chipMarkWidth = 22;
constexpr int margin = 9;
constexpr int arrowWidth = 14;

int leftOf(const QString &icon) {
    return icon.isEmpty() ? margin : chipMarkWidth + 4;
}

QSize sizeOf(const QString &text, const QString &icon) {
    return {QFontMetrics(themeFont(TextSize::small)).horizontalAdvance(text) + leftOf(icon) + margin,
            chipHeight};
}

/// Ground and icon; a pen that is set draws the border of the focus.
void paint(QPainter &painter, const QWidget &chip, const QString &icon, const QColor &colour,
           const QColor &ground) {
    painter.setRenderHint(QPainter::Antialiasing);
    if (painter.pen().width() < 2)
        painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(chip.rect().adjusted(1, 1, -1, -1), 4, 4);
    if (!icon.isEmpty())
        drawLineIcon(painter, QRect(5, 0, chipMarkWidth - 2, chip.height()), icon, colour);
}

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
    return sizeOf(m_text, m_icon);
}

void Chip::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    paint(painter, *this, m_icon, token(m_colour, palette()), token(m_ground, palette()));
    drawElided(painter, rect().adjusted(leftOf(m_icon), 0, 0, 0), Qt::AlignLeft, m_text,
               themeFont(TextSize::small), token(m_colour, palette()));
}

LinkChip::LinkChip(QWidget *parent)
    : QAbstractButton(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
}

void LinkChip::setContent(const QString &text, const QString &icon, Token colour, Token ground) {
    m_icon = icon;
    m_colour = colour;
    m_ground = ground;
    setText(text);
    setAccessibleName(text);
    updateGeometry();
}

QSize LinkChip::sizeHint() const {
    return sizeOf(text(), m_icon) + QSize(arrowWidth, 0);
}

void LinkChip::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    const QColor colour = token(m_colour, palette());
    if (hasFocus())
        painter.setPen(QPen(token(Token::accent, palette()), 2));
    paint(painter, *this, m_icon, colour, token(m_ground, palette()));
    QFont underlined = themeFont(TextSize::small);
    underlined.setUnderline(true);
    drawElided(painter, rect().adjusted(leftOf(m_icon), 0, -arrowWidth, 0), Qt::AlignLeft, text(), underlined,
               colour);
    drawLineIcon(painter, QRect(width() - arrowWidth - 2, 0, arrowWidth, height()), QStringLiteral("right"),
                 colour);
}

} // namespace palmer::ui
