// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/linechart.h"

#include "figures/thinning.h"
#include "figures/ticks.h"
#include "print/figures/drawlinefigure.h"
#include "ui/figures/canvaslabel.h"
#include "ui/figures/zoomkeys.h"
#include "ui/theme.h"

#include <QApplication>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLegend>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double chartReach = 16; ///< around the pointer, pixels
constexpr double chartRingRadius = 5;
constexpr double deepestChartZoom = 2000; ///< times
constexpr double ticksOfWidth = 90;       ///< pixels per tick of x
constexpr double ticksOfHeight = 28;
constexpr std::size_t fewPoints = 12; ///< up to which each point is marked
constexpr double markerSize = 4;
constexpr std::size_t leastParts = 200; ///< of a drawn line

Medium mediumOf(const QPalette &palette) {
    return isDark(palette) ? Medium::screenDark : Medium::screenLight;
}

QPen onScreen(QPen pen) {
    pen.setWidthF(pen.widthF() / pointsPerPixel);
    return pen;
}

} // namespace

LineChart::LineChart(QWidget *parent)
    : QChartView(parent) {
    setRenderHint(QPainter::Antialiasing);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    chart()->legend()->hide();
    chart()->setMargins({0, 8, 16, 0}); // for half of the last labels
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    m_x = new QCategoryAxis(this);
    m_y = new QCategoryAxis(this);
    for (QCategoryAxis *axis : {m_x, m_y})
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    chart()->addAxis(m_x, Qt::AlignBottom);
    chart()->addAxis(m_y, Qt::AlignLeft);
}

void LineChart::setFigure(const LineFigure &figure, const Language &language, const QString &empty) {
    const bool same = figure.x == m_figure.x && figure.y == m_figure.y && !m_range.isNull();
    m_figure = figure;
    m_language = language;
    m_empty = empty;
    m_pointed.reset();
    if (!same)
        m_range = whole();
    build();
}

QRectF LineChart::whole() const {
    return {QPointF(m_figure.x.from, m_figure.y.from), QPointF(m_figure.x.to, m_figure.y.to)};
}

/// Builds series, colours and axes for a new figure or palette.
void LineChart::build() {
    const Medium medium = mediumOf(palette());
    const QColor text = figureColor(FigureRole::text, medium);
    chart()->removeAllSeries();
    chart()->setBackgroundBrush(palette().color(QPalette::Base));
    chart()->setBackgroundPen(Qt::NoPen);
    const bool few = std::ranges::all_of(
        m_figure.lines, [](const FigureLine &line) { return line.points.size() < fewPoints; });
    for (const FigureLine &line : m_figure.lines) {
        auto *series = new QLineSeries;
        series->setName(line.name);
        series->setPen(onScreen(linePen(line.role, medium)));
        series->setPointsVisible(few);
        series->setMarkerSize(markerSize);
        chart()->addSeries(series);
        series->attachAxis(m_x);
        series->attachAxis(m_y);
    }
    for (QCategoryAxis *axis : {m_x, m_y}) {
        axis->setVisible(!m_figure.lines.empty());
        axis->setLabelsFont(themeFont(TextSize::tiny));
        axis->setTruncateLabels(false); // an elided number is useless: leaves out labels
        axis->setLabelsColor(text);
        axis->setTitleFont(themeFont(TextSize::tiny));
        axis->setTitleBrush(text);
        axis->setLinePen(onScreen(figurePen(FigureRole::axis, medium)));
        axis->setGridLinePen(onScreen(figurePen(FigureRole::grid, medium)));
        const FigureAxis &content = axis == m_x ? m_figure.x : m_figure.y;
        QString title = content.quantity;
        if (!content.symbol.isEmpty())
            title += u' ' + content.symbol + content.subscript;
        if (!content.unit.isEmpty() && !title.isEmpty())
            title += QStringLiteral(" (") + content.unit + u')';
        axis->setTitleText(title);
        axis->setTitleVisible(!title.isEmpty());
    }
    m_x->setGridLineVisible(false);
    fillAxes();
    fillLines();
    viewport()->update();
}

void LineChart::fillAxes() {
    fillAxis(*m_x, m_figure.x, m_range.left(), m_range.right());
    fillAxis(*m_y, m_figure.y, m_range.top(), m_range.bottom());
}

void LineChart::fillAxis(QCategoryAxis &axis, const FigureAxis &content, double from, double to) {
    for (const QString &label : axis.categoriesLabels())
        axis.remove(label);
    if (!(to > from))
        return;
    FigureAxis shown = content;
    const bool whole = from == content.from && to == content.to;
    const bool across = &axis == m_x;
    const double room = across ? width() / ticksOfWidth : height() / ticksOfHeight;
    if (!whole || !across)
        palmer::setRange(shown, from, to, std::max(2.0, room),
                         content.angle ? TickSteps::angles : TickSteps::values, m_language);
    axis.setStartValue(from);
    axis.setRange(from, to);
    for (const Tick &tick : shown.ticks)
        axis.append(tick.label, tick.value);
}

void LineChart::fillLines() {
    const auto all = chart()->series();
    const auto parts = std::max<std::size_t>(leastParts, static_cast<std::size_t>(std::max(0, width())));
    for (qsizetype i = 0; i < all.size(); ++i) {
        const std::vector<QPointF> &points = m_figure.lines[static_cast<std::size_t>(i)].points;
        QList<QPointF> shown;
        if (points.size() <= 4 * parts) {
            shown = QList<QPointF>(points.begin(), points.end());
        } else {
            for (const std::size_t place : thinnedPlaces(
                     points.size(), m_range.left(), m_range.right(), parts,
                     [&](std::size_t k) { return points[k].x(); },
                     [&](std::size_t k) { return points[k].y(); }))
                shown.append(points[place]);
        }
        qobject_cast<QLineSeries *>(all[i])->replace(shown);
    }
}

// ---- View ------------------------------------------------------------------------------------------------

void LineChart::setRange(const QRectF &range) {
    const QRectF home = whole();
    QRectF next = range.normalized();
    next.setWidth(std::clamp(next.width(), home.width() / deepestChartZoom, home.width()));
    next.setHeight(std::clamp(next.height(), home.height() / deepestChartZoom, home.height()));
    next.moveLeft(std::clamp(next.left(), home.left(), home.right() - next.width()));
    next.moveTop(std::clamp(next.top(), home.top(), home.bottom() - next.height()));
    if (next.size() == home.size())
        next = home;
    if (next == m_range || m_figure.lines.empty())
        return;
    m_range = next;
    m_pointed.reset();
    fillAxes();
    fillLines();
    viewport()->update();
}

void LineChart::fit() {
    setRange(whole());
}

QPointF LineChart::valueAt(const QPointF &place) const {
    const QRectF plot = chart()->plotArea();
    const double right = (place.x() - plot.left()) / plot.width();
    const double up = (plot.bottom() - place.y()) / plot.height();
    return {m_range.left() + right * m_range.width(), m_range.top() + up * m_range.height()};
}

QPointF LineChart::placeOf(const QPointF &value) const {
    const QRectF plot = chart()->plotArea();
    return {plot.left() + (value.x() - m_range.left()) / m_range.width() * plot.width(),
            plot.bottom() - (value.y() - m_range.top()) / m_range.height() * plot.height()};
}

void LineChart::zoom(double factor, const QPointF &about) {
    const QPointF at = valueAt(about);
    const QPointF corner(at.x() + (m_range.left() - at.x()) * factor,
                         at.y() + (m_range.top() - at.y()) * factor);
    setRange({corner, m_range.size() * factor});
}

void LineChart::zoomBy(int steps) {
    zoom(std::pow(zoomStep, -steps), chart()->plotArea().center());
}

// ---- Points ----------------------------------------------------------------------------------------------

std::optional<LineChart::Place> LineChart::nearest(const QPointF &place) const {
    if (m_figure.lines.empty() || !chart()->plotArea().contains(place))
        return std::nullopt;
    const double half = chartReach / chart()->plotArea().width() * m_range.width();
    const double x = valueAt(place).x();
    std::optional<Place> found;
    double least = chartReach;
    for (std::size_t k = 0; k < m_figure.lines.size(); ++k) {
        const std::vector<QPointF> &points = m_figure.lines[k].points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (std::abs(points[i].x() - x) > half)
                continue;
            const QPointF away = placeOf(points[i]) - place;
            const double far = std::hypot(away.x(), away.y());
            if (far < least) {
                least = far;
                found = Place{k, i};
            }
        }
    }
    return found;
}

QString LineChart::words(const Place &place) const {
    const FigureLine &line = m_figure.lines[place.line];
    const QPointF at = line.points[place.point];
    if (m_readOut)
        return m_readOut(line, at);
    constexpr int decimals = 2;
    const auto number = [&](double value, const FigureAxis &axis) {
        const QString digits = m_language.number(value, Quantity::number, decimals);
        return axis.unit.isEmpty() ? digits : digits + QStringLiteral("\u00A0") + axis.unit;
    };
    return number(at.x(), m_figure.x) + QStringLiteral("  ") + number(at.y(), m_figure.y);
}

QString LineChart::readOutAt(const QPointF &place) const {
    const auto found = nearest(place);
    return found ? words(*found) : QString();
}

void LineChart::point(const std::optional<Place> &place) {
    if (place == m_pointed)
        return;
    m_pointed = place;
    viewport()->update();
}

void LineChart::drawForeground(QPainter *painter, const QRectF &) {
    const QColor accent = token(Token::accent, palette());
    painter->setBrush(Qt::NoBrush);
    if (m_figure.lines.empty()) {
        painter->setFont(themeFont(TextSize::small));
        painter->setPen(token(Token::secondaryText, palette()));
        painter->drawText(QRectF(viewport()->rect()), Qt::AlignCenter | Qt::TextWordWrap, m_empty);
    }
    if (m_pressed && m_dragged) {
        painter->setPen(QPen(accent, 1, Qt::DashLine));
        painter->drawRect(QRectF(*m_pressed, *m_dragged).normalized());
    }
    if (m_pointed) {
        const QPointF at = placeOf(m_figure.lines[m_pointed->line].points[m_pointed->point]);
        painter->setPen(QPen(accent, 2));
        painter->drawEllipse(at, chartRingRadius, chartRingRadius);
        paintCanvasLabel(*painter, *this, at, words(*m_pointed), accent);
    }
    if (hasFocus()) {
        painter->setPen(QPen(accent, 2));
        painter->drawRoundedRect(QRectF(viewport()->rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
}

// ---- Pointer and keys ------------------------------------------------------------------------------------

void LineChart::mousePressEvent(QMouseEvent *event) {
    if (event->button() == Qt::LeftButton && chart()->plotArea().contains(event->position()))
        m_pressed = event->position();
}

void LineChart::mouseMoveEvent(QMouseEvent *event) {
    if (m_pressed && (event->buttons() & Qt::LeftButton)) {
        if (m_dragged ||
            (event->position() - *m_pressed).manhattanLength() >= QApplication::startDragDistance())
            m_dragged = event->position();
        point({});
        viewport()->update();
        return;
    }
    point(nearest(event->position()));
}

void LineChart::mouseReleaseEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    const auto from = std::exchange(m_pressed, {});
    const auto to = std::exchange(m_dragged, {});
    if (from && to)
        setRange(QRectF(valueAt(*from), valueAt(*to)));
    viewport()->update();
}

void LineChart::mouseDoubleClickEvent(QMouseEvent *) {
    fit();
}

void LineChart::wheelEvent(QWheelEvent *event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0)
        zoom(std::pow(zoomStep, -steps), event->position());
    event->accept(); // even at the zoom limit, so that the area around the chart never scrolls
}

void LineChart::keyPressEvent(QKeyEvent *event) {
    constexpr double pan = 0.1; // share of the view
    const auto move = [&](double x, double y) {
        setRange(m_range.translated(x * pan * m_range.width(), y * pan * m_range.height()));
    };
    switch (event->key()) {
    case Qt::Key_Plus:
        return zoomBy(1);
    case Qt::Key_Minus:
        return zoomBy(-1);
    case Qt::Key_0:
        return fit();
    case Qt::Key_Left:
        return move(-1, 0);
    case Qt::Key_Right:
        return move(1, 0);
    case Qt::Key_Up:
        return move(0, 1);
    case Qt::Key_Down:
        return move(0, -1);
    default:
        event->ignore();
    }
}

void LineChart::leaveEvent(QEvent *event) {
    point({});
    QChartView::leaveEvent(event);
}

void LineChart::focusInEvent(QFocusEvent *event) {
    QChartView::focusInEvent(event);
    viewport()->update();
}

void LineChart::focusOutEvent(QFocusEvent *event) {
    QChartView::focusOutEvent(event);
    viewport()->update();
}

void LineChart::changeEvent(QEvent *event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        build();
}

} // namespace palmer::ui
