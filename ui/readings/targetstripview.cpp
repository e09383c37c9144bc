// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/targetstripview.h"

#include "print/figures/style.h"
#include "print/fonts.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QtMath>
#include <algorithm>
#include <set>
#include <utility>

namespace palmer::ui {

namespace {

constexpr double leftMargin = 24; ///< for ↑ ↓
constexpr double stripRightMargin = 8;
constexpr double bottomMargin = 20; ///< for the numbers
constexpr double labelSpace = 6;    ///< between numbers
constexpr double laneShare = 0.25;  ///< of the height
constexpr double dotRadius = 3.2;
constexpr double diamondHalf = 4.4;
constexpr std::size_t mostJoined = 1000; ///< readings; lines between more would only be a smear
constexpr double pointerReach = 9;       ///< around the pointer

} // namespace

TargetStripView::TargetStripView(Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("targetStrip"));
    setMouseTracking(true);
    connect(&selection, &Selection::hoveredChanged, this, [this] { update(); });
}

void TargetStripView::setStrip(const TargetStrip &strip, std::size_t target) {
    m_strip = strip;
    m_target = target;
    update();
}

QRectF TargetStripView::plot() const {
    return {leftMargin, 4, width() - leftMargin - stripRightMargin, height() - bottomMargin - 4};
}

double TargetStripView::x(double value) const {
    const QRectF area = plot();
    return area.left() + (value - m_strip.axis.from) / (m_strip.axis.to - m_strip.axis.from) * area.width();
}

/// ↑ above, ↓ below with space for B between; a single direction is centred.
QRectF TargetStripView::laneArea(std::size_t lane) const {
    const QRectF area = plot();
    const double height = area.height() * laneShare;
    const double top = m_strip.lanes.size() == 1 ? area.center().y() - height / 2
                       : lane == 0               ? area.top() + 2
                                                 : area.bottom() - height - 6;
    return {area.left(), top, area.width(), height};
}

/// Readings in the order of the runs from top to bottom.
QPointF TargetStripView::place(std::size_t lane, std::size_t reading) const {
    const QRectF area = laneArea(lane);
    const auto &readings = m_strip.lanes[lane].readings;
    const double step = area.height() / (static_cast<double>(readings.size()) + 1);
    return {x(readings[reading].value), area.top() + step * (static_cast<double>(reading) + 1)};
}

/// Indices of the readings that later ones do not cover; all if they are few.
std::vector<std::size_t> TargetStripView::uncovered(std::size_t lane) const {
    constexpr double cell = 3; // px: dots closer than this cannot be told apart
    const auto &readings = m_strip.lanes[lane].readings;
    std::vector<std::size_t> result;
    std::set<std::pair<int, int>> taken;
    for (std::size_t k = readings.size(); k-- > 0;) {
        const QPointF at = place(lane, k) / cell;
        const bool isFree = taken.emplace(qFloor(at.x()), qFloor(at.y())).second;
        const ReadingPlace reading{readings[k].run, m_target};
        if (isFree || readings.size() <= mostJoined || readings[k].isAside ||
            m_selection.hovered() == reading)
            result.push_back(k);
    }
    std::ranges::reverse(result);
    return result;
}

void TargetStripView::paintLane(QPainter &painter, std::size_t lane) const {
    const StripLane &shown = m_strip.lanes[lane];
    const bool up = shown.role == CurveRole::up;
    const Medium medium = screenMedium(palette());
    const QColor colour = token(up ? Token::up : Token::down, palette());
    const QRectF area = laneArea(lane);

    painter.setFont(paperFont(14, true));
    painter.setPen(token(up ? Token::up : Token::downText, palette()));
    painter.drawText(QRectF(0, area.top(), leftMargin - 6, area.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     up ? QStringLiteral("↑") : QStringLiteral("↓"));

    painter.setPen(Qt::NoPen);
    if (shown.lower && shown.upper)
        painter.fillRect(
            QRectF(QPointF(x(*shown.lower), area.top()), QPointF(x(*shown.upper), area.bottom())),
            bandColor(up, !up, medium));
    if (shown.mean) {
        painter.setPen(QPen(colour, 2));
        painter.drawLine(QPointF(x(*shown.mean), area.top()), QPointF(x(*shown.mean), area.bottom()));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1));
    std::optional<QPointF> before;
    for (std::size_t k = 0; k < shown.readings.size() && shown.readings.size() <= mostJoined; ++k) {
        if (shown.readings[k].isAside)
            continue;
        if (before)
            painter.drawLine(*before, place(lane, k));
        before = place(lane, k);
    }
    for (const std::size_t k : uncovered(lane)) {
        const QPointF at = place(lane, k);
        if (shown.readings[k].isAside) { // a cross, as it is struck through in the table
            painter.setPen(QPen(token(Token::secondaryText, palette()), 1.4));
            painter.drawLine(at + QPointF(-dotRadius, -dotRadius), at + QPointF(dotRadius, dotRadius));
            painter.drawLine(at + QPointF(-dotRadius, dotRadius), at + QPointF(dotRadius, -dotRadius));
        } else if (up) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(at, dotRadius, dotRadius);
        } else {
            painter.setPen(QPen(colour, 1.4));
            painter.setBrush(palette().color(QPalette::Base));
            painter.drawPolygon(QPolygonF{at + QPointF(0, -diamondHalf), at + QPointF(diamondHalf, 0),
                                          at + QPointF(0, diamondHalf), at + QPointF(-diamondHalf, 0)});
        }
        const ReadingPlace reading{shown.readings[k].run, m_target};
        if (m_selection.hovered() == reading) {
            painter.setPen(QPen(token(Token::accent, palette()), 2));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(at, 7, 7);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void TargetStripView::paintReversal(QPainter &painter) const {
    if (m_strip.reversal.isEmpty())
        return;
    const double from = std::min(x(*m_strip.lanes[0].mean), x(*m_strip.lanes[1].mean));
    const double to = std::max(x(*m_strip.lanes[0].mean), x(*m_strip.lanes[1].mean));
    const double y = (laneArea(0).bottom() + laneArea(1).top()) / 2;
    painter.setPen(token(Token::secondaryText, palette()));
    painter.drawLine(QPointF(from, y), QPointF(to, y));
    painter.drawLine(QPointF(from, y - 4), QPointF(from, y + 4));
    painter.drawLine(QPointF(to, y - 4), QPointF(to, y + 4));
    painter.setFont(themeFont(TextSize::small));
    const double width = painter.fontMetrics().horizontalAdvance(m_strip.reversal) + 10.0;
    // Inside the dimension if it fits, otherwise next to it.
    double left = (from + to - width) / 2;
    if (to - from < width + 16)
        left = to + 4 + width < plot().right() ? to + 4 : from - 4 - width;
    const QRectF label(left, y - 9, width, 18);
    painter.fillRect(label, palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(label, Qt::AlignCenter, m_strip.reversal);
}

void TargetStripView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    const QRectF area = plot();
    painter.setFont(themeFont(TextSize::tiny));
    double lastRight = 0;
    for (const Tick &tick : m_strip.axis.ticks) {
        const double at = x(tick.value);
        painter.setPen(tick.value == 0 ? token(Token::secondaryText, palette())
                                       : token(Token::line, palette()));
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        // The numbers of a narrow range have many digits.
        const double half = painter.fontMetrics().horizontalAdvance(tick.label) / 2.0;
        if (at - half < lastRight || at + half + 1 > width()) // a clipped number would look like another one
            continue;
        lastRight = at + half + labelSpace;
        painter.setPen(token(Token::secondaryText, palette()));
        painter.drawText(QRectF(at - half - 1, area.bottom() + 2, 2 * half + 2, bottomMargin - 2),
                         Qt::AlignHCenter | Qt::AlignTop, tick.label);
    }
    for (std::size_t lane = 0; lane < m_strip.lanes.size(); ++lane)
        paintLane(painter, lane);
    paintReversal(painter);
}

void TargetStripView::mouseMoveEvent(QMouseEvent *event) {
    std::optional<ReadingPlace> nearest;
    double least = pointerReach;
    for (std::size_t lane = 0; lane < m_strip.lanes.size(); ++lane) {
        for (std::size_t k = 0; k < m_strip.lanes[lane].readings.size(); ++k) {
            const double distance = QLineF(place(lane, k), event->position()).length();
            if (distance < least) {
                least = distance;
                nearest = ReadingPlace{m_strip.lanes[lane].readings[k].run, m_target};
            }
        }
    }
    m_selection.setHovered(nearest);
}

void TargetStripView::mousePressEvent(QMouseEvent *event) {
    mouseMoveEvent(event);
    if (m_selection.hovered())
        m_selection.setReading(m_selection.hovered());
}

void TargetStripView::leaveEvent(QEvent *) {
    m_selection.setHovered({});
}

} // namespace palmer::ui
