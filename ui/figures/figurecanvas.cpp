// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figurecanvas.h"

#include "print/figures/metrics.h"
#include "ui/figures/canvaslabel.h"
#include "ui/figures/zoomkeys.h"
#include "ui/theme.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double markWidth = 18;
constexpr double leastRange = 1e-3; ///< share of the whole range

Interval within(const Interval &wanted, const FigureAxis &whole) {
    const double all = whole.to - whole.from;
    const double span = std::clamp(wanted.to - wanted.from, leastRange * all, all);
    const double centre = (wanted.from + wanted.to) / 2;
    const double from = std::clamp(centre - span / 2, whole.from, whole.to - span);
    return {from, from + span};
}

} // namespace

std::array<Interval, 2> rangesWithin(const CurveFigure &whole, const Interval &x, const Interval &y) {
    return {within(x, whole.x), within(y, whole.y)};
}

FigureCanvas::FigureCanvas(Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("figureCanvas"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigureCanvas::setFigure(const CurveFigure &figure, FigureReadings readings) {
    m_readings = std::move(readings);
    if (m_figure != figure) {
        m_figure = figure;
        m_drawn = {};
    }
    update();
}

void FigureCanvas::clear() {
    m_figure.reset();
    m_readings = {};
    m_marking = {};
    m_drawn = {};
    update();
}

void FigureCanvas::setMarking(const FigureMarking &marking) {
    m_marking = marking;
    update();
}

void FigureCanvas::setHoverLabel(const QString &label) {
    m_hoverLabel = label;
    update();
}

void FigureCanvas::drawAnew() {
    const double ratio = devicePixelRatioF();
    if (!m_drawn.isNull() && m_drawn.size() == (QSizeF(size()) * ratio).toSize())
        return;
    m_drawn = QPixmap((QSizeF(size()) * ratio).toSize());
    m_drawn.setDevicePixelRatio(ratio);
    m_drawn.fill(palette().color(QPalette::Base));
    if (!m_figure)
        return;
    QPainter painter(&m_drawn);
    m_transform = drawFigure(painter, QRectF(rect()), *m_figure,
                             isDark(palette()) ? Medium::screenDark : Medium::screenLight);
}

QPointF FigureCanvas::shown(const FigureReading &reading) const {
    QPointF at = m_transform.map(reading.x, reading.y);
    if (m_figure && !m_figure->readings.empty())
        at.rx() += reading.role == CurveRole::up ? -m_transform.readingShift : m_transform.readingShift;
    return at;
}

std::optional<QPointF> FigureCanvas::shownAt(const ReadingPlace &place) const {
    std::optional<QPointF> at;
    m_readings.each([&](const FigureReading &reading) {
        if (reading.place == place && !at)
            at = shown(reading);
    });
    return at && m_transform.plotArea.adjusted(-1, -1, 1, 1).contains(*at) ? at : std::nullopt;
}

std::optional<QPointF> FigureCanvas::placeOf(const ReadingPlace &reading) {
    drawAnew();
    return m_figure ? shownAt(reading) : std::nullopt;
}

std::optional<FigureReading> FigureCanvas::nearest(QPointF at) const {
    std::optional<FigureReading> found;
    double least = pointerReach;
    m_readings.each([&](const FigureReading &reading) {
        const QPointF away = shown(reading) - at;
        if (std::abs(away.x()) >= least || std::abs(away.y()) >= least)
            return;
        const double distance = std::hypot(away.x(), away.y());
        if (distance < least && m_transform.plotArea.contains(shown(reading))) {
            least = distance;
            found = reading;
        }
    });
    return found;
}

// ---- Painting --------------------------------------------------------------------------------------------

void FigureCanvas::paintEvent(QPaintEvent *) {
    drawAnew();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_drawn);
    if (!m_figure)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarking(painter);
    paintHover(painter);
    if (hasFocus()) {
        painter.setPen(QPen(token(Token::accent, palette()), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
}

void FigureCanvas::paintHover(QPainter &painter) const {
    const auto place = m_selection.hovered();
    if (!place)
        return;
    const std::optional<QPointF> at = shownAt(*place);
    if (!at)
        return;
    const QColor accent = token(Token::accent, palette());
    painter.setPen(QPen(accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(*at, ringRadius, ringRadius);
    if (!m_hoverLabel.isEmpty())
        paintCanvasLabel(painter, *this, *at, m_hoverLabel, accent);
}

void FigureCanvas::paintMarking(QPainter &painter) const {
    if (m_marking.label.isEmpty())
        return;
    const QRectF plot = m_transform.plotArea;
    const QColor colour = token(Token::explanation, palette());
    QColor ground = colour;
    ground.setAlphaF(0.14F);
    painter.save();
    painter.setClipRect(plot);
    for (const double position : m_marking.positions) {
        const double x = m_transform.map(position, 0).x();
        painter.fillRect(QRectF(x - markWidth / 2, plot.top(), markWidth, plot.height()), ground);
    }
    painter.restore();
    QPointF beside(plot.center().x(), plot.top() + 16);
    if (m_marking.dimension) {
        const Dimension &dimension = *m_marking.dimension;
        const QPointF lower = m_transform.map(dimension.lowerPosition, dimension.lower);
        const QPointF upper = m_transform.map(dimension.upperPosition, dimension.upper);
        const bool oneTarget = dimension.lowerPosition == dimension.upperPosition;
        // Next to a single target, otherwise at the edge with leaders from both ends.
        const double x =
            oneTarget ? std::max(plot.left() + 6, lower.x() - markWidth / 2 - 4) : plot.right() - 10;
        painter.save();
        painter.setClipRect(plot.adjusted(-2, -2, 2, 2));
        painter.setPen(QPen(colour, 1, Qt::DashLine));
        painter.drawLine(lower, QPointF(x, lower.y()));
        painter.drawLine(upper, QPointF(x, upper.y()));
        painter.setPen(QPen(colour, 2));
        painter.drawLine(QPointF(x, lower.y()), QPointF(x, upper.y()));
        for (const double y : {lower.y(), upper.y()})
            painter.drawLine(QPointF(x - 4, y), QPointF(x + 4, y));
        painter.restore();
        beside = QPointF(x, std::clamp((lower.y() + upper.y()) / 2, plot.top() + 12, plot.bottom() - 12));
        if (x > plot.center().x()) // keeps the label away from the targets
            beside.rx() -=
                28 + QFontMetrics(themeFont(TextSize::tiny)).horizontalAdvance(m_marking.label) + 12;
    }
    paintCanvasLabel(painter, *this, beside, m_marking.label, colour);
}

// ---- Pointer and keys ------------------------------------------------------------------------------------

void FigureCanvas::zoom(double factor, QPointF about) {
    if (!m_figure)
        return;
    drawAnew();
    const QPointF at = m_transform.toData(about);
    const auto scaled = [factor](double from, double to, double centre) {
        return Interval{centre + (from - centre) * factor, centre + (to - centre) * factor};
    };
    emit rangesWanted(scaled(m_figure->x.from, m_figure->x.to, at.x()),
                      scaled(m_figure->y.from, m_figure->y.to, at.y()));
}

void FigureCanvas::zoomBy(int steps) {
    drawAnew();
    zoom(std::pow(zoomStep, -steps), m_transform.plotArea.center());
}

void FigureCanvas::pan(QPointF by) {
    if (!m_figure)
        return;
    drawAnew();
    const QPointF moved = m_transform.toData(QPointF(0, 0)) - m_transform.toData(by);
    emit rangesWanted({m_figure->x.from + moved.x(), m_figure->x.to + moved.x()},
                      {m_figure->y.from + moved.y(), m_figure->y.to + moved.y()});
}

void FigureCanvas::mousePressEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_drag = event->position();
    m_dragged = false;
}

void FigureCanvas::mouseMoveEvent(QMouseEvent *event) {
    if (m_drag && (event->buttons() & Qt::LeftButton)) {
        const QPointF by = event->position() - *m_drag;
        if (m_dragged || by.manhattanLength() >= QApplication::startDragDistance()) {
            m_dragged = true;
            m_drag = event->position();
            pan(by);
        }
        return;
    }
    drawAnew();
    const std::optional<FigureReading> found = nearest(event->position());
    m_selection.setHovered(found ? std::optional(found->place) : std::nullopt);
}

void FigureCanvas::mouseReleaseEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_drag.reset();
    if (!m_dragged) {
        if (const std::optional<FigureReading> found = nearest(event->position()))
            m_selection.setReading(found->place);
    }
}

void FigureCanvas::mouseDoubleClickEvent(QMouseEvent *) {
    emit fitWanted();
}

void FigureCanvas::wheelEvent(QWheelEvent *event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0)
        zoom(std::pow(zoomStep, -steps), event->position());
    event->accept(); // even at the zoom limit, so that the area around the figure never scrolls
}

void FigureCanvas::keyPressEvent(QKeyEvent *event) {
    const bool isTaken = takeZoomKey(*event, {[this](int steps) { zoomBy(steps); },
                                              [this](QPointF by) { pan(by); }, [this] { emit fitWanted(); }});
    if (!isTaken)
        QWidget::keyPressEvent(event);
}

void FigureCanvas::leaveEvent(QEvent *) {
    m_selection.setHovered({});
}

void FigureCanvas::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange) {
        m_drawn = {};
        update();
    }
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
