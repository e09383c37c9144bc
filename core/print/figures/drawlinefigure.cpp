// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "kernel/words/text.h"
#include "print/figures/plotframe.h"

#include <algorithm>
#include <utility>

namespace palmer {

namespace {

constexpr double endLabelGap = 0.8 * mm;
constexpr double topMargin = 1.6 * mm;
constexpr double rightMargin = 6 * mm;
constexpr double mostLabel = 30 * mm;      ///< at the end of a line
constexpr double bandLabelRoom = 3.2 * mm; ///< above the plot
constexpr double arrowGap = 1.6 * mm;      ///< between a band and the arrow of its span
constexpr double arrowLength = 1.3 * mm;
constexpr double arrowWidth = 0.9 * mm;

FigureRole penRole(LineRole role) {
    return inOrder(role, {FigureRole::upEdge, FigureRole::downEdge, FigureRole::up, FigureRole::down,
                          FigureRole::up, FigureRole::down, FigureRole::mean, FigureRole::counterclockwise,
                          FigureRole::clockwise, FigureRole::residual});
}

class LineFigurePainter {
public:
    LineFigurePainter(QPainter &painter, const QRectF &area, const LineFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_entries(entriesOf())
        , m_frame(painter, area, plotIn(area), figure.x, figure.y, medium, lineFrame) {}

    FigureTransform draw() {
        if (!m_frame.begin())
            return {};
        if (m_figure.band)
            drawBand(*m_figure.band);
        m_frame.drawHorizontalGrid();
        m_frame.inside([&] {
            p.setBrush(Qt::NoBrush);
            for (const FigureLine &line : m_figure.lines) {
                const QPen pen = linePen(line.role, m_medium);
                p.setPen(pen);
                if (!line.dots) {
                    p.drawPolyline(m_frame.polyline(line.points));
                    continue;
                }
                p.setBrush(pen.color());
                for (const QPointF &point : line.points)
                    p.drawEllipse(m_frame.at(point), dotRadius, dotRadius);
                p.setBrush(Qt::NoBrush);
            }
        });
        if (m_figure.band && m_figure.span)
            drawSpan(*m_figure.band, *m_figure.span);
        drawLabels();
        const QPen axis = m_frame.pen(FigureRole::axis);
        p.setPen(axis);
        m_frame.drawEdges();
        m_frame.drawX(axis);
        m_frame.drawY(axis);
        if (hasTitle())
            m_frame.drawXTitle(axisTitle(m_figure.x));
        m_frame.drawYTitle(axisTitle(m_figure.y));
        m_frame.drawLegendRows(m_entries, lineFrame.legend - heightSaved());
        return m_frame.transform();
    }

private:
    [[nodiscard]] bool hasTitle() const { return !m_figure.x.quantity.isEmpty(); }
    [[nodiscard]] double heightSaved() const { return hasTitle() ? 0 : lineFrame.legend - lineFrame.title; }

    [[nodiscard]] std::vector<PlotEntry> entriesOf() {
        std::vector<PlotEntry> entries;
        for (const FigureLine &line : m_figure.lines) {
            if (line.name.isEmpty())
                continue;
            const QString name =
                line.label.isEmpty() ? line.name : line.label + QStringLiteral("  ") + line.name;
            entries.push_back({lineFrame.sampleWidth, name, [this, role = line.role](const QRectF &box) {
                                   p.setPen(linePen(role, m_medium));
                                   p.drawLine(box.topLeft(), box.topRight());
                               }});
        }
        return entries;
    }

    [[nodiscard]] QRectF plotIn(const QRectF &area) const {
        const double left = widthOfNumbers(m_figure.y, lineFrame, titleCentre + figureTextSize);
        double right = rightMargin;
        for (const FigureLine &line : m_figure.lines)
            right = std::max(right, textWidth(endLabel(line)) + endLabelGap);
        const double room = area.width() - left - right;
        const double below = m_entries.empty()
                                 ? lineFrame.title + titleCentre
                                 : lineFrame.legend + legendRows(m_entries, room, lineFrame) * legendPitch;
        const double bottom = below - heightSaved();
        const double top = topMargin + (m_figure.band && !m_figure.band->label.isEmpty() ? bandLabelRoom : 0);
        return {area.left() + left, area.top() + top, room, area.height() - top - bottom};
    }

    /// As much of the label as there is room for at the end of its line.
    static QString endLabel(const FigureLine &line) {
        QString label = line.label;
        for (qsizetype size = label.size(); size > 0 && textWidth(label) > mostLabel;) {
            size -= line.label[size - 1].isLowSurrogate() ? 2 : 1;
            label = line.label.first(size) + u'…';
        }
        return label;
    }

    /// The label ends at the band, or begins there where it would leave the plot.
    void drawBand(const FigureBand &band) {
        const QRectF &plot = m_frame.plot();
        const QRectF shade(QPointF(m_frame.x(band.from), plot.top()),
                           QPointF(m_frame.x(band.to), plot.bottom()));
        p.fillRect(shade, m_frame.colour(FigureRole::guardFill));
        if (band.label.isEmpty())
            return;
        const double width = textWidth(band.label);
        const double least = plot.left();
        const double left = std::clamp(shade.right() - width, least, std::max(least, plot.right() - width));
        drawText(p, {left, plot.top() - bandLabelRoom / 2}, band.label, m_frame.colour(FigureRole::text));
    }

    void drawSpan(const FigureBand &band, const FigureSpan &span) {
        const QRectF &plot = m_frame.plot();
        QPen dashed = m_frame.pen(FigureRole::dimension);
        dashed.setStyle(Qt::DashLine);
        const double width = textWidth(span.label) + endLabelGap;
        const bool isRight = m_frame.x(band.to) + arrowGap + width < plot.right();
        const double arrow = isRight ? m_frame.x(band.to) + arrowGap : m_frame.x(band.from) - arrowGap;
        const double low = m_frame.y(span.low);
        const double high = m_frame.y(span.high);
        p.setPen(dashed);
        for (const double y : {low, high})
            p.drawLine(QPointF(isRight ? m_frame.x(band.from) : arrow, y),
                       QPointF(isRight ? arrow : m_frame.x(band.to), y));
        QPen line = m_frame.pen(FigureRole::dimension);
        line.setCapStyle(Qt::FlatCap);
        p.setPen(line);
        p.drawLine(QPointF(arrow, low), QPointF(arrow, high));
        if (low - high > 2 * arrowLength) {
            p.setPen(Qt::NoPen);
            p.setBrush(m_frame.colour(FigureRole::dimension));
            for (const auto &[tip, away] : {std::pair(low, -arrowLength), std::pair(high, arrowLength)})
                p.drawPolygon(QPolygonF{{arrow, tip},
                                        {arrow - arrowWidth / 2, tip + away},
                                        {arrow + arrowWidth / 2, tip + away}});
            p.setBrush(Qt::NoBrush);
        }
        const double left = isRight ? arrow + endLabelGap : arrow - width;
        p.fillRect(QRectF(left, (low + high - figureTextSize) / 2, width - endLabelGap, figureTextSize),
                   m_frame.colour(FigureRole::background));
        drawText(p, {left, (low + high) / 2}, span.label, m_frame.colour(FigureRole::text));
    }

    /// Draws labels at the ends of the lines; those at the edge are kept apart.
    void drawLabels() {
        struct Label {
            double at = 0;
            QString text;
        };
        const QRectF &plot = m_frame.plot();
        const QColor text = m_frame.colour(FigureRole::text);
        std::vector<Label> labels;
        for (const FigureLine &line : m_figure.lines) {
            if (line.label.isEmpty() || line.points.empty())
                continue;
            const QPointF end = m_frame.at(line.points.back()) + QPointF(endLabelGap, 0);
            if (end.x() < plot.right() - figureTextSize) // ends before the others
                drawText(p, end, endLabel(line), text);
            else
                labels.push_back({end.y(), endLabel(line)});
        }
        std::ranges::stable_sort(labels, {}, &Label::at);
        double last = plot.top() - figureTextSize;
        for (Label &label : labels) {
            label.at = std::max(label.at, last + figureTextSize);
            last = label.at;
            drawText(p, {plot.right() + endLabelGap, label.at}, label.text, text);
        }
    }

    QPainter &p;
    const LineFigure &m_figure;
    Medium m_medium;
    std::vector<PlotEntry> m_entries;
    PlotFrame m_frame;
};

} // namespace

QPen linePen(LineRole role, Medium medium) {
    QPen pen = figurePen(penRole(role), medium);
    if (role == LineRole::counterclockwise || role == LineRole::clockwise)
        pen.setWidthF(figurePen(FigureRole::residual, medium).widthF());
    return pen;
}

FigureTransform drawKind(QPainter &painter, const QRectF &area, const LineFigure &figure, Medium medium) {
    return LineFigurePainter(painter, area, figure, medium).draw();
}

} // namespace palmer
