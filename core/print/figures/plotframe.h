// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"
#include "print/figures/drawtext.h"
#include "print/figures/metrics.h"

#include <QPolygonF>
#include <functional>
#include <optional>
#include <span>

namespace palmer {

/// Title of an axis: its symbol with its subscript between two texts.
[[nodiscard]] TextLine axisTitle(const FigureAxis &axis, const QString &before, const QString &after);

/// "Quantity symbol (unit)", without the parts that are empty.
[[nodiscard]] TextLine axisTitle(const FigureAxis &axis);

/// Width to the left of the plot for the ticks and numbers of y, points; `start`: width of what precedes
/// them.
[[nodiscard]] double widthOfNumbers(const FigureAxis &y, const FrameMeasures &measures, double start);

/// An entry of a legend; draws its sample into a box.
struct PlotEntry {
    double sampleWidth = 0;
    QString text;
    std::function<void(const QRectF &box)> drawSample;
};

/// Width of the sample and text of an entry, and of the gap between them.
[[nodiscard]] double widthOf(const PlotEntry &entry, const FrameMeasures &measures);

/// Rows that drawLegendRows() takes in a width.
[[nodiscard]] int legendRows(std::span<const PlotEntry> entries, double room, const FrameMeasures &measures);

/// Parts of an axis that are drawn in one pass over its ticks.
enum class AxisParts { ticks, numbers, both };

/// Frame of a figure with straight axes: maps data to the painter, and draws axes, ticks, numbers, grid
/// lines, titles and legend around the plot. Lengths in points, measured as the table of the kind of figure
/// says.
class PlotFrame {
public:
    /// A figure without values on y has no `y`. Precondition: the painter outlives the frame.
    PlotFrame(QPainter &painter, const QRectF &area, const QRectF &plot, FigureAxis x,
              const std::optional<FigureAxis> &y, Medium medium, const FrameMeasures &measures);

    /// Prepares the painter; false if there is no room for the plot.
    [[nodiscard]] bool begin();
    void setHeight(double height) { m_plot.setHeight(height); }

    [[nodiscard]] const QRectF &plot() const { return m_plot; }
    [[nodiscard]] QPen pen(FigureRole role) const { return figurePen(role, m_medium); }
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }
    [[nodiscard]] QPen axisPen(Qt::PenCapStyle cap) const;

    [[nodiscard]] double x(double value) const {
        return m_plot.left() + (value - m_x.from) / (m_x.to - m_x.from) * m_plot.width();
    }
    [[nodiscard]] double y(double value) const {
        return m_plot.bottom() - (value - m_y.from) / (m_y.to - m_y.from) * m_plot.height();
    }
    [[nodiscard]] QPointF at(const QPointF &point) const { return {x(point.x()), y(point.y())}; }
    /// True if a point is within the ranges of both axes.
    [[nodiscard]] bool shows(const QPointF &point) const;
    [[nodiscard]] QPolygonF polyline(std::span<const QPointF> points) const;
    [[nodiscard]] QPolygonF outline(std::span<const BandPoint> band) const;
    [[nodiscard]] FigureTransform transform(double readingShift = 0) const;

    /// Calls `draw` with the painter clipped to the plot.
    void inside(const std::function<void()> &draw);
    /// Lines across the plot at a value, in the current pen.
    void drawVertical(double value);
    void drawHorizontal(double value);
    void drawVerticalGrid();
    void drawHorizontalGrid();
    /// The left and lower edges, in the current pen.
    void drawEdges();
    void drawX(const QPen &axis, AxisParts parts = AxisParts::both);
    void drawY(const QPen &axis, AxisParts parts = AxisParts::both);
    void drawXTitle(const TextLine &title);
    /// Rotated, at the left edge of the area.
    void drawYTitle(const TextLine &title);
    /// Draws a legend in one row, its gaps chosen for `room`, centred if there is no start.
    void drawLegendRow(std::span<const PlotEntry> entries, double room, std::optional<double> start = {});
    /// Draws a legend in rows as wide as the plot, the first one `below` the plot.
    void drawLegendRows(std::span<const PlotEntry> entries, double below);

private:
    QPainter &p;
    QRectF m_area;
    QRectF m_plot;
    FigureAxis m_x;
    FigureAxis m_y;
    bool m_hasY;
    Medium m_medium;
    const FrameMeasures &m_measures;
};

} // namespace palmer
