// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/circleframe.h"

#include "print/figures/clip.h"

#include <QPaintEngine>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace palmer {

namespace {

constexpr qsizetype longChain = 4;
/// Flatness of a circle approximated by chords, points.
constexpr double flatness = 0.02;
constexpr double drawnSmaller = 1 - 1e-6; ///< a figure below this fraction of its size counts as reduced

CircleUnits unitsOf(const CircleFigure &figure, const QRectF &area, Medium medium) {
    const double keyHeight = medium == Medium::paper ? figure.keyHeight : 0;
    const double both =
        std::min(area.width() / figure.size.width(), area.height() / (figure.size.height() + keyHeight));
    if (medium != Medium::paper || both >= mm)
        return {both, both};
    constexpr double least = 0.1 * mm;
    const double height = area.height() - keyHeight * mm;
    return {
        std::clamp(height / figure.size.height(), least, std::max(least, area.width() / figure.size.width())),
        mm};
}

/// The figure to be drawn at a scale `less` < 1 with the same magnification on paper: the distance between
/// the nominal circle and the figure radius keeps its size, everything else shrinks.
CircleFigure withMagnificationKept(const CircleFigure &figure, double less) {
    CircleFigure result = figure;
    result.magnification = figure.magnification / less;
    result.plotRadius = figure.figureRadius - (figure.figureRadius - figure.plotRadius) / less;
    return result;
}

} // namespace

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

CircleFrame::CircleFrame(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium)
    : p(painter)
    , m_units(unitsOf(figure, area, medium))
    , m_smaller(medium == Medium::paper && m_units.figure < drawnSmaller * mm
                    ? std::optional(withMagnificationKept(figure, m_units.figure / mm))
                    : std::nullopt)
    , m_figure(m_smaller ? *m_smaller : figure)
    , m_medium(medium)
    , m_plot(area) // on a screen the space around the figure belongs to the picture
    , m_scale(m_units.figure * figure.view.zoom) {
    if (onPaper()) {
        m_plot.setSize(figure.size * m_units.figure);
        m_plot.moveLeft(area.left() + (area.width() - m_plot.width()) / 2);
    }
    m_guard = m_plot.adjusted(-20, -20, 20, 20);
    m_centre = m_plot.center() +
               QPointF(-figure.view.x - figure.home.x(), figure.view.y + figure.home.y()) * m_scale;
}

QPen CircleFrame::pen(FigureRole role, Qt::PenCapStyle cap) const {
    QPen line = pen(role);
    line.setCapStyle(cap);
    return line;
}

QPen CircleFrame::pen(Sense sense) const {
    return pen(pathRole(sense));
}

QPointF CircleFrame::directionOf(double degrees) {
    const double angle = radians(degrees);
    return {std::cos(angle), -std::sin(angle)};
}

QPolygonF CircleFrame::chainOf(const std::vector<TracePoint> &points) const {
    QPolygonF chain;
    chain.reserve(static_cast<qsizetype>(points.size()));
    for (const TracePoint &point : points)
        chain << place(point);
    return chain;
}

std::vector<double> CircleFrame::angles(std::vector<double> parts, std::vector<double> whole) const {
    if (!m_figure.sector)
        return whole;
    for (double &part : parts)
        part = m_figure.sector->from + part * (m_figure.sector->to - m_figure.sector->from);
    return parts;
}

void CircleFrame::drawChain(const QPolygonF &chain) {
    QPolygonF piece;
    piece.reserve(chain.size());
    for (qsizetype i = 1; i < chain.size(); ++i) {
        QPointF a = chain[i - 1];
        QPointF b = chain[i];
        if (!clip(a, b, m_guard)) {
            flush(piece);
            continue;
        }
        if (piece.isEmpty() || piece.back() != a) {
            flush(piece);
            piece << a;
        }
        piece << b;
    }
    flush(piece);
}

void CircleFrame::flush(QPolygonF &piece) {
    if (piece.size() > 1)
        stroke(piece);
    piece.clear();
}

bool CircleFrame::isPicture() const {
    return p.paintEngine() && p.paintEngine()->type() == QPaintEngine::Raster;
}

void CircleFrame::stroke(const QPolygonF &chain) {
    if (!isPicture() || chain.size() < longChain || p.pen().capStyle() != Qt::RoundCap) {
        p.drawPolyline(chain);
        return;
    }
    QList<QLineF> lines;
    lines.reserve(chain.size() - 1);
    for (qsizetype i = 1; i < chain.size(); ++i)
        lines.append({chain[i - 1], chain[i]});
    p.drawLines(lines);
}

void CircleFrame::drawCircle(double deviation, FigureRole role) {
    const double radius = m_figure.radius(deviation) * m_scale;
    if (radius <= 0)
        return;
    p.setPen(pen(role));
    p.setBrush(Qt::NoBrush);
    if (whole()) {
        p.drawEllipse(m_centre, radius, radius);
        return;
    }
    // Only the visible part, as chords: a circle a thousand times the view is too much for the painter.
    const double step = 2 * std::acos(std::max(0.5, 1 - flatness / radius));
    const auto [from, to] = anglesInView();
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
    QPolygonF chain;
    chain.reserve(parts + 1);
    for (int i = 0; i <= parts; ++i) {
        const double angle = from + (to - from) * i / parts;
        chain << m_centre + QPointF(std::cos(angle), -std::sin(angle)) * radius;
    }
    drawChain(chain);
}

/// Range of directions from the centre of the circles to the view, radians.
Interval CircleFrame::anglesInView() const {
    if (m_guard.contains(m_centre))
        return {0, 2 * std::numbers::pi};
    const QPointF towards = m_guard.center() - m_centre;
    const double middle = std::atan2(-towards.y(), towards.x());
    Interval result{middle, middle};
    for (const QPointF corner :
         {m_guard.topLeft(), m_guard.topRight(), m_guard.bottomLeft(), m_guard.bottomRight()}) {
        const QPointF way = corner - m_centre;
        const double angle =
            middle + std::remainder(std::atan2(-way.y(), way.x()) - middle, 2 * std::numbers::pi);
        result = {std::min(result.from, angle), std::max(result.to, angle)};
    }
    return result;
}

void CircleFrame::drawArrowHead(QPointF tip, double degrees, double length, double width,
                                const QColor &fill) {
    const QPointF along = directionOf(degrees);
    const QPointF across(-along.y(), along.x());
    p.setPen(Qt::NoPen);
    p.setBrush(fill);
    p.drawPolygon(
        QPolygonF{tip, tip - length * along + width / 2 * across, tip - length * along - width / 2 * across});
}

} // namespace palmer
