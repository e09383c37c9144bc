// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawlinefigure.h"

#include "print/figures/drawtext.h"
#include "print/figures/metrics.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>

namespace palmer {

namespace {

constexpr double lineTitleRow = 7.4 * mm; ///< below the plot
constexpr double lineLegendRow = 12 * mm; ///< first row
constexpr double legendPitch = 4.2 * mm;
constexpr double lineSampleWidth = 10 * mm;
constexpr double lineSampleGap = 2 * mm;
constexpr double entryGap = 7 * mm;
constexpr double endLabelGap = 0.8 * mm;
constexpr double topMargin = 1.6 * mm;
constexpr double rightMargin = 6 * mm;

FigureRole penRole(LineRole role) {
    switch (role) {
    case LineRole::measuredUp:
        return FigureRole::upEdge;
    case LineRole::measuredDown:
        return FigureRole::downEdge;
    case LineRole::predictedUp:
    case LineRole::machine:
        return FigureRole::up;
    case LineRole::predictedDown:
    case LineRole::instrument:
        return FigureRole::down;
    case LineRole::counterclockwise:
        return FigureRole::counterclockwise;
    case LineRole::clockwise:
        return FigureRole::clockwise;
    case LineRole::air:
        break;
    }
    return FigureRole::mean;
}

class LineFigurePainter {
public:
    LineFigurePainter(QPainter &painter, const QRectF &area, const LineFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_area(area) {
        double widest = 0;
        for (const Tick &tick : figure.y.ticks)
            widest = std::max(widest, textWidth(tick.label));
        const double left = titleCentre + figureTextSize + widest + tickGap + tickLength;
        const double room = area.width() - left - rightMargin;
        double used = 0;
        for (const FigureLine &line : figure.lines) {
            if (line.name.isEmpty())
                continue;
            m_hasLegend = true;
            const double width = lineSampleWidth + lineSampleGap + textWidth(nameOf(line)) + entryGap;
            if (used > 0 && used + width > room) {
                ++m_rows;
                used = 0;
            }
            used += width;
        }
        const double title = figure.x.quantity.isEmpty() ? lineLegendRow - lineTitleRow : 0;
        const double bottom =
            (m_hasLegend ? lineLegendRow + m_rows * legendPitch : lineTitleRow + titleCentre) - title;
        m_legendRow = lineLegendRow - title;
        m_plot = QRectF(area.left() + left, area.top() + topMargin, room, area.height() - topMargin - bottom);
    }

    FigureTransform draw() {
        if (m_plot.width() <= 0 || m_plot.height() <= 0)
            return {};
        p.setRenderHint(QPainter::Antialiasing);
        p.setRenderHint(QPainter::TextAntialiasing);
        drawGrid();
        p.save();
        p.setClipRect(m_plot, Qt::IntersectClip);
        for (const FigureLine &line : m_figure.lines)
            drawLine(line);
        p.restore();
        drawLabels();
        drawAxes();
        drawLegend();
        const double sx = m_plot.width() / (m_figure.x.to - m_figure.x.from);
        const double sy = -m_plot.height() / (m_figure.y.to - m_figure.y.from);
        return {m_plot,
                QTransform(sx, 0, 0, sy, m_plot.left() - m_figure.x.from * sx,
                           m_plot.bottom() - m_figure.y.from * sy),
                0};
    }

private:
    [[nodiscard]] static QString nameOf(const FigureLine &line) {
        return line.label.isEmpty() ? line.name : line.label + QStringLiteral("  ") + line.name;
    }
    [[nodiscard]] double x(double value) const {
        return m_plot.left() + (value - m_figure.x.from) / (m_figure.x.to - m_figure.x.from) * m_plot.width();
    }
    [[nodiscard]] double y(double value) const {
        return m_plot.bottom() -
               (value - m_figure.y.from) / (m_figure.y.to - m_figure.y.from) * m_plot.height();
    }
    [[nodiscard]] QPen pen(FigureRole role) const { return figurePen(role, m_medium); }
    [[nodiscard]] QPen penOf(const FigureLine &line) const { return linePen(line.role, m_medium); }
    [[nodiscard]] QColor text() const { return figureColor(FigureRole::text, m_medium); }

    void drawGrid() {
        for (const Tick &tick : m_figure.y.ticks) {
            p.setPen(pen(tick.value == 0 ? FigureRole::zeroLine : FigureRole::grid));
            p.drawLine(QPointF(m_plot.left(), y(tick.value)), QPointF(m_plot.right(), y(tick.value)));
        }
    }

    void drawLine(const FigureLine &line) {
        QPolygonF points;
        points.reserve(static_cast<qsizetype>(line.points.size()));
        for (const QPointF &point : line.points)
            points.append({x(point.x()), y(point.y())});
        p.setBrush(Qt::NoBrush);
        p.setPen(penOf(line));
        p.drawPolyline(points);
    }

    /// Draws labels at the ends of the lines; those at the edge are kept apart.
    void drawLabels() {
        struct Label {
            double at = 0;
            QString text;
        };
        std::vector<Label> labels;
        for (const FigureLine &line : m_figure.lines) {
            if (line.label.isEmpty() || line.points.empty())
                continue;
            const QPointF end(x(line.points.back().x()) + endLabelGap, y(line.points.back().y()));
            if (end.x() < m_plot.right() - figureTextSize) // ends before the others
                drawText(p, end, line.label, text());
            else
                labels.push_back({end.y(), line.label});
        }
        std::ranges::stable_sort(labels, {}, &Label::at);
        double last = m_plot.top() - figureTextSize;
        for (Label &label : labels) {
            label.at = std::max(label.at, last + figureTextSize);
            last = label.at;
            drawText(p, {m_plot.right() + endLabelGap, label.at}, label.text, text());
        }
    }

    void drawAxes() {
        p.setPen(pen(FigureRole::axis));
        p.drawLine(m_plot.topLeft(), m_plot.bottomLeft());
        p.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        for (const Tick &tick : m_figure.x.ticks) {
            p.setPen(pen(FigureRole::axis));
            p.drawLine(QPointF(x(tick.value), m_plot.bottom()),
                       QPointF(x(tick.value), m_plot.bottom() + tickLength));
            drawText(p, {x(tick.value) - textWidth(tick.label) / 2, m_plot.bottom() + tickRow}, tick.label,
                     text());
        }
        for (const Tick &tick : m_figure.y.ticks) {
            p.setPen(pen(FigureRole::axis));
            p.drawLine(QPointF(m_plot.left(), y(tick.value)),
                       QPointF(m_plot.left() - tickLength, y(tick.value)));
            drawText(p, {m_plot.left() - tickLength - tickGap - textWidth(tick.label), y(tick.value)},
                     tick.label, text());
        }
        if (!m_figure.x.quantity.isEmpty()) {
            const TextLine across = titleOf(m_figure.x);
            drawText(p, {m_plot.center().x() - textWidth(across) / 2, m_plot.bottom() + lineTitleRow}, across,
                     text());
        }
        const TextLine along = titleOf(m_figure.y);
        p.save();
        p.translate(m_area.left() + titleCentre, m_plot.center().y());
        p.rotate(-90);
        drawText(p, {-textWidth(along) / 2, 0}, along, text());
        p.restore();
    }

    [[nodiscard]] static TextLine titleOf(const FigureAxis &axis) {
        return {{axis.symbol.isEmpty() ? axis.quantity : axis.quantity + QLatin1Char(' ') + axis.symbol},
                {axis.subscript, true},
                {axis.unit.isEmpty() ? QString() : QStringLiteral(" (") + axis.unit + QLatin1Char(')')}};
    }

    void drawLegend() {
        double left = m_plot.left();
        double row = m_plot.bottom() + m_legendRow - 0.5 * mm;
        for (const FigureLine &line : m_figure.lines) {
            if (line.name.isEmpty())
                continue;
            const double width = lineSampleWidth + lineSampleGap + textWidth(nameOf(line)) + entryGap;
            if (left > m_plot.left() && left + width > m_plot.right()) {
                left = m_plot.left();
                row += legendPitch;
            }
            p.setPen(penOf(line));
            p.drawLine(QPointF(left, row), QPointF(left + lineSampleWidth, row));
            drawText(p, {left + lineSampleWidth + lineSampleGap, row}, nameOf(line), text());
            left += width;
        }
    }

    QPainter &p;
    const LineFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    QRectF m_plot;
    int m_rows = 1;
    bool m_hasLegend = false;
    double m_legendRow = lineLegendRow;
};

} // namespace

QPen linePen(LineRole role, Medium medium) {
    QPen pen = figurePen(penRole(role), medium);
    if (role == LineRole::counterclockwise || role == LineRole::clockwise)
        pen.setWidthF(figurePen(FigureRole::residual, medium).widthF());
    return pen;
}

FigureTransform drawLineFigure(QPainter &painter, const QRectF &area, const LineFigure &figure,
                               Medium medium) {
    return LineFigurePainter(painter, area, figure, medium).draw();
}

} // namespace palmer
