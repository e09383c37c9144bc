// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "kernel/words/text.h"
#include "print/figures/plotframe.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double endLabelGap = 0.8 * mm;
constexpr double topMargin = 1.6 * mm;
constexpr double rightMargin = 6 * mm;

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
        const double room = area.width() - left - rightMargin;
        const double below = m_entries.empty()
                                 ? lineFrame.title + titleCentre
                                 : lineFrame.legend + legendRows(m_entries, room, lineFrame) * legendPitch;
        const double bottom = below - heightSaved();
        return {area.left() + left, area.top() + topMargin, room, area.height() - topMargin - bottom};
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
                drawText(p, end, line.label, text);
            else
                labels.push_back({end.y(), line.label});
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
