// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/filterchip.h"

#include "ui/elidedlabel.h"
#include "ui/theme.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int chipHeight = 24;
constexpr double chipRadius = 4;
constexpr int padding = 10;
constexpr int signSize = 12;
constexpr int chipGap = 6;
constexpr int widest = 200;
constexpr int least = 48;

} // namespace

FilterChip::FilterChip(QWidget *parent)
    : QAbstractButton(parent)
    , m_menu(new QMenu(this)) {
    setCheckable(true);
    setFont(themeFont(TextSize::base));
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::clicked, this, &FilterChip::openMenu); // with the space bar
}

void FilterChip::setContent(const QString &name, const QString &shown) {
    setChecked(!shown.isEmpty());
    setText(shown.isEmpty() ? name : shown);
    setAccessibleName(shown.isEmpty() ? name : name + QStringLiteral(": ") + shown);
    setToolTip(shown.isEmpty() ? QString() : tr("%1 (Delete takes the filter away)").arg(shown));
    updateGeometry();
    update();
}

QSize FilterChip::sizeHint() const {
    constexpr int rounding = 4;
    const int width = fontMetrics().horizontalAdvance(text()) + rounding + 2 * padding + chipGap + signSize;
    return {std::clamp(width, least, widest), chipHeight};
}

QSize FilterChip::minimumSizeHint() const {
    return {least, chipHeight};
}

void FilterChip::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = token(Token::accent, palette());
    const bool isPressed = isDown() || m_menu->isVisible();
    const bool isStrong = hasFocus();
    painter.setPen(QPen(isStrong || isChecked() || isPressed ? accent : token(Token::lineStrong, palette()),
                        isStrong ? 2 : 1));
    painter.setBrush(isChecked() || isPressed ? selectedGround(palette())
                     : underMouse()           ? token(Token::hover, palette())
                                              : palette().color(QPalette::Base));
    const double half = isStrong ? 1 : 0.5;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), chipRadius, chipRadius);
    const QRect sign(width() - padding - signSize, 0, signSize, height());
    const QRect room(padding, 0, sign.left() - chipGap - padding, height());
    painter.setPen(palette().color(QPalette::Text));
    drawElided(painter, room, Qt::AlignLeft, text());
    drawLineIcon(painter, sign, isChecked() ? QStringLiteral("close") : QStringLiteral("down"),
                 isChecked() ? accent : palette().color(QPalette::Text));
}

bool FilterChip::isOnCross(const QPoint &place) const {
    return isChecked() && rect().contains(place) && place.x() >= width() - padding - signSize - chipGap / 2;
}

void FilterChip::openMenu() {
    m_menu->popup(mapToGlobal(QPoint(0, height())));
}

void FilterChip::mousePressEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_clearing = isOnCross(event->position().toPoint());
    if (!m_clearing)
        openMenu();
}

void FilterChip::mouseReleaseEvent(QMouseEvent *event) {
    if (m_clearing && isOnCross(event->position().toPoint()))
        emit cleared();
    m_clearing = false;
}

void FilterChip::keyPressEvent(QKeyEvent *event) {
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (isChecked())
            emit cleared();
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Down:
        openMenu();
        return;
    default:
        QAbstractButton::keyPressEvent(event);
    }
}

} // namespace palmer::ui
