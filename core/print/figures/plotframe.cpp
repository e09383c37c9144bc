// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/plotframe.h"

#include <algorithm>
#include <utility>

namespace palmer {

TextLine axisTitle(const FigureAxis &axis, const QString &before, const QString &after) {
    return {{before + axis.symbol}, {axis.subscript, true}, {after}};
}

TextLine axisTitle(const FigureAxis &axis) {
    return axisTitle(axis,
                     axis.symbol.isEmpty() || axis.quantity.isEmpty() ? axis.quantity
                                                                      : axis.quantity + QLatin1Char(' '),
                     axis.unit.isEmpty() ? QString() : QStringLiteral(" (") + axis.unit + QLatin1Char(')'));
}

double widthOfNumbers(const FigureAxis &y, const FrameMeasures &measures, double start) {
    double widest = 0;
    for (const Tick &tick : y.ticks)
        widest = std::max(widest, textWidth(tick.label));
    return start + widest + measures.tickGap + measures.tick;
}

double widthOf(const PlotEntry &entry, const FrameMeasures &measures) {
    return entry.sampleWidth + measures.sampleGap + textWidth(entry.text);
}

int legendRows(std::span<const PlotEntry> entries, double room, const FrameMeasures &measures) {
    double used = 0;
    int rows = entries.empty() ? 0 : 1;
    for (const PlotEntry &entry : entries) {
        const double width = widthOf(entry, measures) + measures.entryGap;
        if (used > 0 && used + width > room) {
            ++rows;
            used = 0;
        }
        used += width;
    }
    return rows;
}

PlotFrame::PlotFrame(QPainter &painter, const QRectF &area, const QRectF &plot, FigureAxis x,
                     const std::optional<FigureAxis> &y, Medium medium, const FrameMeasures &measures)
    : p(painter)
    , m_area(area)
    , m_plot(plot)
    , m_x(std::move(x))
    , m_y(y.value_or(FigureAxis()))
    , m_hasY(y.has_value())
    , m_medium(medium)
    , m_measures(measures) {}

bool PlotFrame::begin() {
    if (m_plot.width() <= 0 || m_plot.height() <= 0)
        return false;
    p.setRenderHint(QPainter::Antialiasing);
    p.setRenderHint(QPainter::TextAntialiasing);
    return true;
}

QPen PlotFrame::axisPen(Qt::PenCapStyle cap) const {
    QPen axis = pen(FigureRole::axis);
    axis.setCapStyle(cap);
    return axis;
}

bool PlotFrame::shows(const QPointF &point) const {
    return point.x() >= m_x.from && point.x() <= m_x.to && point.y() >= m_y.from && point.y() <= m_y.to;
}

QPolygonF PlotFrame::polyline(std::span<const QPointF> points) const {
    QPolygonF result;
    result.reserve(static_cast<qsizetype>(points.size()));
    for (const QPointF &point : points)
        result << at(point);
    return result;
}

QPolygonF PlotFrame::outline(std::span<const BandPoint> band) const {
    QPolygonF result;
    result.reserve(2 * static_cast<qsizetype>(band.size()));
    for (const BandPoint &point : band)
        result << at({point.x, point.upper});
    for (auto point = band.rbegin(); point != band.rend(); ++point)
        result << at({point->x, point->lower});
    return result;
}

FigureTransform PlotFrame::transform(double readingShift) const {
    const double sx = m_plot.width() / (m_x.to - m_x.from);
    const double sy = m_hasY ? -m_plot.height() / (m_y.to - m_y.from) : 1;
    const double top = m_hasY ? m_plot.bottom() - m_y.from * sy : m_plot.top();
    return {m_plot, QTransform(sx, 0, 0, sy, m_plot.left() - m_x.from * sx, top), readingShift};
}

void PlotFrame::inside(const std::function<void()> &draw) {
    p.save();
    p.setClipRect(m_plot, Qt::IntersectClip);
    draw();
    p.restore();
}

void PlotFrame::drawVertical(double value) {
    p.drawLine(QPointF(x(value), m_plot.top()), QPointF(x(value), m_plot.bottom()));
}

void PlotFrame::drawHorizontal(double value) {
    p.drawLine(QPointF(m_plot.left(), y(value)), QPointF(m_plot.right(), y(value)));
}

void PlotFrame::drawVerticalGrid() {
    p.setPen(pen(FigureRole::grid));
    for (const Tick &tick : m_x.ticks)
        drawVertical(tick.value);
}

void PlotFrame::drawHorizontalGrid() {
    for (const Tick &tick : m_y.ticks) {
        p.setPen(pen(tick.value == 0 ? FigureRole::zeroLine : FigureRole::grid));
        drawHorizontal(tick.value);
    }
}

void PlotFrame::drawEdges() {
    p.drawLine(m_plot.topLeft(), m_plot.bottomLeft());
    p.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
}

void PlotFrame::drawX(const QPen &axis, AxisParts parts) {
    const double row = m_plot.bottom() + m_measures.numbersFrom + m_measures.numbers;
    for (const Tick &tick : m_x.ticks) {
        const double at = x(tick.value);
        if (parts != AxisParts::numbers) {
            p.setPen(axis);
            p.drawLine(QPointF(at, m_plot.bottom()), QPointF(at, m_plot.bottom() + m_measures.tick));
        }
        if (parts == AxisParts::ticks)
            continue;
        const double width = textWidth(tick.label);
        double left = at - width / 2;
        if (m_measures.numbersInArea)
            left = std::clamp(left, m_area.left(), m_area.right() - width);
        drawText(p, {left, row}, tick.label, colour(FigureRole::text));
    }
}

void PlotFrame::drawY(const QPen &axis, AxisParts parts) {
    const double end = m_plot.left() - m_measures.tick;
    for (const Tick &tick : m_y.ticks) {
        const double at = y(tick.value);
        if (parts != AxisParts::numbers) {
            p.setPen(axis);
            p.drawLine(QPointF(m_plot.left(), at), QPointF(end, at));
        }
        if (parts != AxisParts::ticks)
            drawText(p, {end - m_measures.tickGap - textWidth(tick.label), at}, tick.label,
                     colour(FigureRole::text));
    }
}

void PlotFrame::drawXTitle(const TextLine &title) {
    drawText(p, {m_plot.center().x() - textWidth(title) / 2, m_plot.bottom() + m_measures.title}, title,
             colour(FigureRole::text));
}

void PlotFrame::drawYTitle(const TextLine &title) {
    p.save();
    p.translate(m_area.left() + titleCentre, m_plot.center().y());
    p.rotate(-90);
    drawText(p, {-textWidth(title) / 2, 0}, title, colour(FigureRole::text));
    p.restore();
}

void PlotFrame::drawLegendRow(std::span<const PlotEntry> entries, double room, std::optional<double> start) {
    double width = 0;
    for (const PlotEntry &entry : entries)
        width += widthOf(entry, m_measures);
    const auto gaps = static_cast<double>(std::max<std::size_t>(entries.size(), 2) - 1);
    if (start) { // a long legend begins further left
        const double place = std::clamp(m_area.right() - width - gaps * m_measures.leastEntryGap,
                                        m_area.left(), std::max(m_area.left(), *start));
        room += *start - place;
        start = place;
    }
    const double gap = std::clamp((room - width) / gaps, m_measures.leastEntryGap, m_measures.entryGap);
    double left = start ? *start : std::max(m_area.left(), m_plot.center().x() - (width + gap * gaps) / 2);
    const double row = m_plot.bottom() + m_measures.legend;
    const double height = m_measures.sampleHeight;
    for (const PlotEntry &entry : entries) {
        entry.drawSample(QRectF(left, row - height / 2, entry.sampleWidth, height));
        left += entry.sampleWidth + m_measures.sampleGap;
        drawText(p, {left, row}, entry.text, colour(FigureRole::text));
        left += textWidth(entry.text) + gap;
    }
}

void PlotFrame::drawLegendRows(std::span<const PlotEntry> entries, double below) {
    double left = m_plot.left();
    double row = m_plot.bottom() + below - 0.5 * mm;
    for (const PlotEntry &entry : entries) {
        const double width = widthOf(entry, m_measures) + m_measures.entryGap;
        if (left > m_plot.left() && left + width > m_plot.right()) {
            left = m_plot.left();
            row += legendPitch;
        }
        entry.drawSample(QRectF(left, row, entry.sampleWidth, 0));
        drawText(p, {left + entry.sampleWidth + m_measures.sampleGap, row}, entry.text,
                 colour(FigureRole::text));
        left += width;
    }
}

} // namespace palmer
