// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/startbutton.h"

#include "ui/elidedlabel.h"
#include "ui/theme.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <cmath>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int textHeight = 56;
constexpr int lineHeight = 18;
constexpr int pictureHeight = 74; // all of the page is in sight at 768
constexpr int pictureMargin = 16;

// Illustration only, not a measurement; values from 0 to 1.
constexpr int points = 11;
constexpr std::array upward{0.62, 0.45, 0.80, 0.38, 0.97, 0.72, 0.80, 0.72, 0.84, 0.80, 0.83};
constexpr std::array downward{0.38, 0.16, 0.58, 0.26, 0.98, 0.76, 0.76, 0.74, 0.70, 0.68, 0.54};

void drawBand(QPainter &painter, const QRectF &area, const std::array<double, points> &heights,
              const QColor &colour, Qt::PenStyle style) {
    QPolygonF mean;
    QPolygonF upper;
    QPolygonF lower;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double x = area.left() + area.width() * static_cast<double>(i) / (points - 1);
        const double y = area.top() + area.height() * heights.at(i) * 0.9;
        const double half = area.height() * (0.07 + 0.006 * static_cast<double>(i));
        mean << QPointF(x, y);
        upper << QPointF(x, y - half);
        lower.prepend(QPointF(x, y + half));
    }
    QColor ground = colour;
    ground.setAlphaF(0.14F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawPolygon(upper + lower);
    painter.setPen(QPen(colour, 2, style));
    painter.drawPolyline(mean);
}

void drawTrace(QPainter &painter, const QPointF &centre, double radius, double squareness,
               const QColor &colour) {
    constexpr int steps = 120;
    QPolygonF trace;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 2 * M_PI * i / steps;
        const double r = radius * (1 + squareness * std::sin(2 * angle));
        trace << centre + QPointF(r * std::cos(angle), -r * std::sin(angle));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 2));
    painter.drawPolyline(trace);
}

} // namespace

StartButton::StartButton(QString icon, QWidget *parent, Picture picture)
    : QAbstractButton(parent)
    , m_icon(std::move(icon))
    , m_picture(picture) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    setMinimumSize(StartButton::sizeHint());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize StartButton::sizeHint() const {
    return {200, textHeight + (m_picture == Picture::none ? 0 : lineHeight + pictureHeight)};
}

void StartButton::setTexts(const QString &title, const QString &detail, const QString &shortcut) {
    setText(title);
    m_detail = detail;
    m_shortcut = shortcut;
    setAccessibleName(QString(title).remove(u'&'));
    describe();
}

void StartButton::setStandard(const QString &standard) {
    m_standard = standard;
    describe();
}

void StartButton::describe() {
    setAccessibleDescription(m_standard.isEmpty() ? m_detail : m_standard + QStringLiteral(", ") + m_detail);
    update();
}

void StartButton::paintPicture(QPainter &painter, const QRectF &area) const {
    const QColor line = token(Token::line, palette());
    const QColor up = token(Token::up, palette());
    const QColor down = token(Token::down, palette());
    if (m_picture == Picture::deviation) {
        painter.setPen(QPen(line, 1));
        for (int i = 0; i <= 3; ++i) {
            const double y = std::round(area.top() + area.height() * i / 3) + 0.5;
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
        drawBand(painter, area, downward, down, Qt::DashLine);
        drawBand(painter, area, upward, up, Qt::SolidLine);
        return;
    }
    const double radius = area.height() / 2 * 0.78;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(line, 1));
    for (const double ring : {1.2, 0.84})
        painter.drawEllipse(area.center(), radius * ring, radius * ring);
    painter.drawLine(area.center() - QPointF(radius * 1.3, 0), area.center() + QPointF(radius * 1.3, 0));
    painter.drawLine(area.center() - QPointF(0, radius * 1.2), area.center() + QPointF(0, radius * 1.2));
    painter.setPen(QPen(token(Token::secondaryText, palette()), 1));
    painter.drawEllipse(area.center(), radius, radius);
    drawTrace(painter, area.center(), radius, 0.1, up);
    drawTrace(painter, area.center(), radius, -0.1, down);
}

/// Painted once: hover and focus change only the background.
const QPixmap &StartButton::picture() {
    const double ratio = devicePixelRatioF();
    const QSize wanted(width(), height() - textHeight - lineHeight);
    if (m_painted.isNull() || m_painted.devicePixelRatio() != ratio) {
        m_painted = QPixmap((QSizeF(wanted) * ratio).toSize());
        m_painted.setDevicePixelRatio(ratio);
        m_painted.fill(Qt::transparent);
        QPainter painter(&m_painted);
        painter.setRenderHint(QPainter::Antialiasing);
        paintPicture(painter, QRectF(pictureMargin, pictureMargin, width() - 2.0 * pictureMargin,
                                     wanted.height() - pictureMargin - 4.0));
    }
    return m_painted;
}

void StartButton::resizeEvent(QResizeEvent *event) {
    m_painted = {};
    QAbstractButton::resizeEvent(event);
}

void StartButton::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange)
        m_painted = {};
    QAbstractButton::changeEvent(event);
}

void StartButton::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = token(Token::accent, palette());
    const double border = hasFocus() ? 2 : 1;
    painter.setPen(QPen(hasFocus() ? accent : token(Token::line, palette()), border));
    painter.setBrush(underMouse() || isDown() ? token(Token::hover, palette())
                                              : palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(border / 2, border / 2, -border / 2, -border / 2), 6, 6);
    const bool large = m_picture != Picture::none;
    const int top = height() - textHeight - (large ? lineHeight : 0);
    if (large)
        painter.drawPixmap(0, 0, picture());
    const int left = large ? pictureMargin : 48;
    const QRect upper(left, top + 9, width() - left - 12, lineHeight);
    const QRect lower(left, height() - 9 - lineHeight, upper.width(), lineHeight);
    if (!large)
        drawLineIcon(painter, QRect(8, top, 36, textHeight), m_icon, accent);
    const QFont titleFont = themeFont(TextSize::head);
    const int title = QFontMetrics(titleFont).size(Qt::TextShowMnemonic, text()).width();
    painter.setFont(themeFont(TextSize::tiny));
    const int keys = painter.fontMetrics().horizontalAdvance(m_shortcut) + 8;
    const bool above = title + keys <= upper.width(); // otherwise the shortcut moves down
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawText(above ? upper : lower, Qt::AlignRight | Qt::AlignVCenter, m_shortcut);
    painter.setFont(themeFont(TextSize::small));
    drawElided(painter, lower.adjusted(0, 0, above ? 0 : -keys, 0), Qt::AlignLeft, m_detail);
    if (large) {
        const QRect middle(left, (upper.top() + lower.top()) / 2, upper.width(), lineHeight);
        drawElided(painter, middle, Qt::AlignLeft, m_standard);
    }
    painter.setFont(titleFont);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect room = upper.adjusted(0, 0, above ? -keys : 0, 0);
    painter.drawText(
        room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic,
        painter.fontMetrics().elidedText(text(), Qt::ElideRight, room.width(), Qt::TextShowMnemonic));
}

} // namespace palmer::ui
