// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/figures/drawfigure.h"

#include <QPainter>
#include <QPolygonF>
#include <optional>
#include <vector>

namespace palmer {

[[nodiscard]] double radians(double degrees);

/// Points per mm of a circle figure and of its key. The key is never reduced, because its letters are not.
struct CircleUnits {
    double figure = 1;
    double key = 1;
};

/// Frame of a circle figure: maps directions and radii (degrees and mm from the centre) to the painter, and
/// draws the lines that may leave the view. On paper the figure may be reduced: see drawKind().
class CircleFrame {
public:
    /// Precondition: painter and figure outlive the frame.
    CircleFrame(QPainter &painter, const QRectF &area, const CircleFigure &figure, Medium medium);
    ~CircleFrame() = default;
    CircleFrame(const CircleFrame &) = delete;
    CircleFrame &operator=(const CircleFrame &) = delete;

    [[nodiscard]] QPainter &painter() { return p; }
    /// The figure as drawn, with the radii of the reduced one.
    [[nodiscard]] const CircleFigure &figure() const { return m_figure; }
    [[nodiscard]] Medium medium() const { return m_medium; }
    [[nodiscard]] bool onPaper() const { return m_medium == Medium::paper; }
    /// True if the figure is not zoomed.
    [[nodiscard]] bool whole() const { return m_figure.view.zoom <= 1; }
    [[nodiscard]] const QRectF &plot() const { return m_plot; }
    [[nodiscard]] const CircleUnits &units() const { return m_units; }
    [[nodiscard]] double scale() const { return m_scale; } ///< points per mm of the figure in view
    [[nodiscard]] QPointF centre() const { return m_centre; }
    [[nodiscard]] QPen pen(FigureRole role) const { return figurePen(role, m_medium); }
    [[nodiscard]] QPen pen(FigureRole role, Qt::PenCapStyle cap) const;
    [[nodiscard]] QPen pen(Sense sense) const;
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }

    /// Point in a direction (degrees) at a distance from the centre (mm).
    [[nodiscard]] QPointF polar(double degrees, double radius) const {
        return placeOn(directionOf(degrees), radius);
    }
    [[nodiscard]] static QPointF directionOf(double degrees);
    [[nodiscard]] QPointF placeOn(QPointF ray, double radius) const {
        return m_centre + ray * (radius * m_scale);
    }
    [[nodiscard]] QPointF place(const TracePoint &point) const {
        return polar(point.angle, m_figure.radius(point.deviation));
    }
    [[nodiscard]] QPolygonF chainOf(const std::vector<TracePoint> &points) const;
    /// Directions at parts 0 … 1 of the sector; `whole` if the figure has no sector.
    [[nodiscard]] std::vector<double> angles(std::vector<double> parts, std::vector<double> whole) const;

    /// Draws a polyline, clipped to the surroundings of the view: the painter cannot handle far coordinates.
    void drawChain(const QPolygonF &chain);
    /// In a raster image, draws separate lines with round caps: this looks like round joins, which take many
    /// times as long where the line crosses itself.
    void stroke(const QPolygonF &chain);
    [[nodiscard]] bool isPicture() const;
    void drawCircle(double deviation, FigureRole role);
    /// Length and width in points.
    void drawArrowHead(QPointF tip, double degrees, double length, double width, const QColor &fill);

private:
    void flush(QPolygonF &piece);
    [[nodiscard]] Interval anglesInView() const;

    QPainter &p;
    CircleUnits m_units;
    std::optional<CircleFigure> m_smaller; ///< drawn instead of the figure, if reduced
    const CircleFigure &m_figure;
    Medium m_medium;
    QRectF m_plot;
    QRectF m_guard; ///< long lines are clipped to this
    double m_scale;
    QPointF m_centre;
};

} // namespace palmer
