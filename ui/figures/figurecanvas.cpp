// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figurecanvas.h"

#include "print/figures/metrics.h"
#include "ui/figures/canvaslabel.h"
#include "ui/theme.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double markWidth = 18;
constexpr double deepestCurveZoom = 1000; ///< times

} // namespace

std::array<Interval, 2> rangesWithin(const CurveFigure &whole, const Interval &x, const Interval &y) {
    const QRectF range = rangeWithin({QPointF(x.from, y.from), QPointF(x.to, y.to)},
                                     rangeOf(whole.x, whole.y), {deepestCurveZoom, deepestCurveZoom});
    return {Interval{range.left(), range.right()}, Interval{range.top(), range.bottom()}};
}

FigureCanvas::FigureCanvas(Selection &selection, QWidget *parent)
    : PlotCanvas(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("figureCanvas"));
}

void FigureCanvas::setFigure(const CurveFigure &figure, FigureReadings readings) {
    m_readings = std::move(readings);
    if (m_figure != figure) {
        m_figure = figure;
        discardPicture();
    }
    update();
}

void FigureCanvas::clear() {
    m_figure.reset();
    m_readings = {};
    m_marking = {};
    discardPicture();
}

void FigureCanvas::setMarking(const FigureMarking &marking) {
    m_marking = marking;
    update();
}

void FigureCanvas::setHoverLabel(const QString &label) {
    m_hoverLabel = label;
    update();
}

void FigureCanvas::drawPicture(QPainter &painter) {
    if (m_figure)
        m_transform = drawFigure(painter, QRectF(rect()), *m_figure, screenMedium(palette()));
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

std::optional<ReadingPlace> FigureCanvas::nearest(QPointF at) const {
    std::optional<ReadingPlace> found;
    double least = pointerReach;
    m_readings.each([&](const FigureReading &reading) {
        const QPointF away = shown(reading) - at;
        if (std::abs(away.x()) >= least || std::abs(away.y()) >= least)
            return;
        const double distance = std::hypot(away.x(), away.y());
        if (distance < least && m_transform.plotArea.contains(shown(reading))) {
            least = distance;
            found = reading.place;
        }
    });
    return found;
}

// ---- Painting --------------------------------------------------------------------------------------------

void FigureCanvas::paintOver(QPainter &painter) {
    if (!m_figure)
        return;
    paintMarking(painter);
    const auto hovered = m_selection.hovered();
    if (const auto at = hovered ? shownAt(*hovered) : std::nullopt)
        paintPointed(painter, *this, *at, m_hoverLabel);
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

void FigureCanvas::setRange(const QRectF &range) {
    emit rangesWanted({range.left(), range.right()}, {range.top(), range.bottom()});
}

void FigureCanvas::hover(const std::optional<QPointF> &at) {
    m_selection.setHovered(at ? nearest(*at) : std::nullopt);
}

void FigureCanvas::click(const QPointF &at) {
    if (const auto found = nearest(at))
        m_selection.setReading(*found);
}

} // namespace palmer::ui
