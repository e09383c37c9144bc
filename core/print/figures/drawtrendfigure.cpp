// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawtrendfigure.h"

#include "print/figures/drawtext.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>

namespace palmer {

namespace {

constexpr double markRadius = 0.75 * mm;
constexpr double capWidth = 0.7 * mm;
constexpr double trendTickLength = 0.8 * mm;
constexpr double trendTickGap = 0.7 * mm;
constexpr double hatchHeight = 1.2 * mm;
constexpr double hatchStep = 0.9 * mm;
constexpr double labelWidth = 15 * mm; ///< of a row label
constexpr double panelGap = 2.5 * mm;
constexpr double titleHeight = 4.2 * mm;
constexpr double trendTickRow = 3.2 * mm;
constexpr double thin = 0.12 * mm;
constexpr double bandStrength = 0.13;

QPolygonF triangleAt(QPointF place, double radius) {
    return {place + QPointF(0, -radius), place + QPointF(radius, 0.8 * radius),
            place + QPointF(-radius, 0.8 * radius)};
}

class PanelPainter {
public:
    PanelPainter(QPainter &painter, const QRectF &area, const TrendPanel &panel, Medium medium, bool large)
        : p(painter)
        , m_panel(panel)
        , m_medium(medium)
        , m_large(large) {
        double widest = 0;
        for (const Tick &tick : panel.y.ticks)
            widest = std::max(widest, textWidth(tick.label));
        const double left = widest + trendTickGap + trendTickLength;
        const double above = titleHeight + (large ? titleHeight : 0);
        m_area = area;
        m_plot = area.adjusted(left, above, -1 * mm, -(trendTickLength + trendTickRow + 1.5 * mm));
    }

    FigureTransform draw() {
        if (m_plot.width() <= 0 || m_plot.height() <= 0)
            return {};
        p.setRenderHint(QPainter::Antialiasing);
        drawGround();
        p.save();
        p.setClipRect(m_plot, Qt::IntersectClip);
        drawInside();
        p.restore();
        drawValues();
        drawNotBefore();
        drawAxes();
        drawTitle();
        const double sx = m_plot.width() / (m_panel.x.to - m_panel.x.from);
        const double sy = -m_plot.height() / (m_panel.y.to - m_panel.y.from);
        return {m_plot,
                QTransform(sx, 0, 0, sy, m_plot.left() - m_panel.x.from * sx,
                           m_plot.bottom() - m_panel.y.from * sy),
                0};
    }

private:
    [[nodiscard]] double x(double value) const {
        return m_plot.left() + (value - m_panel.x.from) / (m_panel.x.to - m_panel.x.from) * m_plot.width();
    }
    [[nodiscard]] double y(double value) const {
        return m_plot.bottom() - (value - m_panel.y.from) / (m_panel.y.to - m_panel.y.from) * m_plot.height();
    }
    [[nodiscard]] QPointF at(const QPointF &point) const { return {x(point.x()), y(point.y())}; }
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }
    [[nodiscard]] QColor ground() const { return colour(FigureRole::background); }
    [[nodiscard]] double wide(double small, double large) const { return (m_large ? large : small) * mm; }

    void setPen(FigureRole role, double width, Qt::PenStyle style = Qt::SolidLine) {
        p.setPen(QPen(colour(role), width, style, Qt::FlatCap));
        p.setBrush(Qt::NoBrush);
    }

    [[nodiscard]] QPolygonF polygon(const std::vector<QPointF> &points) const {
        QPolygonF result;
        for (const QPointF &point : points)
            result << at(point);
        return result;
    }

    void drawGround() {
        const double today = std::clamp(x(m_panel.today), m_plot.left(), m_plot.right());
        p.fillRect(QRectF(QPointF(today, m_plot.top()), m_plot.bottomRight()),
                   blend(colour(FigureRole::text), ground(), 0.05));
        setPen(FigureRole::grid, thin);
        for (const Tick &tick : m_panel.y.ticks)
            p.drawLine(QPointF(m_plot.left(), y(tick.value)), QPointF(m_plot.right(), y(tick.value)));
        if (m_large) {
            setPen(FigureRole::axis, thin);
            p.drawLine(QPointF(today, m_plot.top()), QPointF(today, m_plot.bottom()));
        }
    }

    void drawInside() {
        if (!m_panel.band.empty()) {
            QPolygonF band;
            for (const BandPoint &point : m_panel.band)
                band << at({point.x, point.upper});
            for (auto point = m_panel.band.rbegin(); point != m_panel.band.rend(); ++point)
                band << at({point->x, point->lower});
            p.setPen(Qt::NoPen);
            p.setBrush(blend(colour(FigureRole::up), ground(), bandStrength));
            p.drawPolygon(band);
        }
        setPen(FigureRole::text, thin, Qt::DashLine);
        for (const TrendIntervention &one : m_panel.interventions)
            p.drawLine(QPointF(x(one.x), m_plot.top()), QPointF(x(one.x), m_plot.bottom()));
        for (const auto &limit : m_panel.limits)
            drawLimit(limit);
        setPen(FigureRole::guardBand, thin);
        for (const auto &joined : m_panel.joined)
            p.drawPolyline(polygon(joined));
        setPen(FigureRole::up, wide(0.35, 0.5));
        p.drawPolyline(polygon(m_panel.line));
        setPen(FigureRole::up, wide(0.35, 0.5), Qt::DashLine);
        p.drawPolyline(polygon(m_panel.later));
    }

    void drawLimit(const std::vector<QPointF> &limit) {
        const QPolygonF steps = polygon(limit);
        if (m_large) {
            setPen(FigureRole::limit, thin);
            for (qsizetype i = 0; i + 1 < steps.size(); ++i) {
                if (steps[i].y() != steps[i + 1].y())
                    continue;
                const double length = steps[i + 1].x() - steps[i].x();
                for (int stroke = 0; stroke * hatchStep < length; ++stroke) {
                    const QPointF foot = steps[i] + QPointF(stroke * hatchStep, 0);
                    p.drawLine(foot, foot + QPointF(hatchHeight, -hatchHeight));
                }
            }
        }
        setPen(FigureRole::limit, wide(0.35, 0.5));
        p.drawPolyline(steps);
    }

    void drawValues() {
        for (const TrendValue &value : m_panel.values) {
            const QPointF place(x(value.x), y(value.y));
            const bool other = value.mark == TrendMark::otherSeries;
            const FigureRole role = other ? FigureRole::guardBand : FigureRole::up;
            if (value.expanded) {
                const double top = std::max(y(value.y + *value.expanded), m_plot.top());
                const double bottom = std::min(y(value.y - *value.expanded), m_plot.bottom());
                setPen(role, wide(0.15, 0.2));
                p.drawLine(QPointF(place.x(), top), QPointF(place.x(), bottom));
                if (m_large) {
                    p.drawLine(QPointF(place.x() - capWidth, top), QPointF(place.x() + capWidth, top));
                    p.drawLine(QPointF(place.x() - capWidth, bottom), QPointF(place.x() + capWidth, bottom));
                }
            }
            setPen(role, wide(0.25, 0.3));
            p.setBrush(value.mark == TrendMark::asLeft ? colour(role) : ground());
            const double radius = m_large ? 1.4 * markRadius : markRadius;
            if (other)
                p.drawRect(QRectF(place.x() - radius, place.y() - radius, 2 * radius, 2 * radius));
            else if (value.mark == TrendMark::noRole)
                p.drawPolygon(triangleAt(place, radius));
            else
                p.drawEllipse(place, radius, radius);
            if (value.exceeds)
                drawCross(place - QPointF(3 * radius, 0), radius);
        }
    }

    void drawCross(QPointF place, double radius) {
        setPen(FigureRole::text, 0.4 * mm);
        p.drawLine(place + QPointF(-radius, -radius), place + QPointF(radius, radius));
        p.drawLine(place + QPointF(-radius, radius), place + QPointF(radius, -radius));
    }

    void drawNotBefore() {
        if (!m_panel.notBefore)
            return;
        const QPointF place = at(*m_panel.notBefore);
        setPen(FigureRole::up, wide(0.2, 0.3), Qt::DotLine);
        p.drawLine(place, QPointF(place.x(), m_plot.bottom()));
        const double radius = 1.3 * markRadius;
        setPen(FigureRole::up, wide(0.25, 0.35));
        p.setBrush(ground());
        p.drawPolygon(QPolygonF{place + QPointF(0, -radius), place + QPointF(radius, 0),
                                place + QPointF(0, radius), place + QPointF(-radius, 0)});
    }

    void drawAxes() {
        setPen(FigureRole::axis, 0.2 * mm);
        p.drawLine(m_plot.topLeft(), m_plot.bottomLeft());
        p.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        for (const Tick &tick : m_panel.x.ticks) {
            setPen(FigureRole::axis, 0.2 * mm);
            p.drawLine(QPointF(x(tick.value), m_plot.bottom()),
                       QPointF(x(tick.value), m_plot.bottom() + trendTickLength));
            drawText(p,
                     {x(tick.value) - textWidth(tick.label) / 2,
                      m_plot.bottom() + trendTickLength + trendTickRow / 1.6},
                     tick.label, colour(FigureRole::text));
        }
        for (const Tick &tick : m_panel.y.ticks)
            drawText(p,
                     {m_plot.left() - trendTickLength - trendTickGap - textWidth(tick.label), y(tick.value)},
                     tick.label, colour(FigureRole::text));
    }

    void drawTitle() {
        const double line = m_area.top() + titleHeight / 2;
        TextLine symbol{{m_panel.y.symbol}};
        if (!m_panel.y.subscript.isEmpty())
            symbol.push_back({m_panel.y.subscript, true});
        if (m_large)
            symbol.push_back({QStringLiteral(" (") + m_panel.y.unit + QLatin1Char(')')});
        // Starts at the axis labels, because "G(b)" with its index is wider than they are.
        drawText(p, {m_area.left(), line}, symbol, colour(FigureRole::text), true);
        const double width = textWidth(m_panel.statement, m_panel.isFirst);
        drawText(p, {m_area.right() - 1 * mm - width, line}, m_panel.statement, colour(FigureRole::text),
                 m_panel.isFirst);
        if (!m_large)
            return;
        double free = m_area.left();
        for (const TrendIntervention &one : m_panel.interventions) {
            const double wanted = x(one.x) - textWidth(one.name) / 2;
            if (wanted < free)
                continue; // its line is drawn anyway
            drawText(p, {wanted, line + titleHeight}, one.name, colour(FigureRole::text));
            free = wanted + textWidth(one.name) + 1 * mm;
        }
    }

    QPainter &p;
    const TrendPanel &m_panel;
    Medium m_medium;
    bool m_large;
    QRectF m_area;
    QRectF m_plot;
};

/// Draws the legend sample number `index`, in the order of the texts.
void drawSample(QPainter &p, std::size_t index, QPointF place, Medium medium) {
    const double half = 3 * mm;
    const QColor text = figureColor(FigureRole::text, medium);
    const QColor blue = figureColor(FigureRole::up, medium);
    const QColor grey = figureColor(FigureRole::guardBand, medium);
    const QColor ground = figureColor(FigureRole::background, medium);
    const auto line = [&](const QColor &colour, double width, Qt::PenStyle style = Qt::SolidLine) {
        p.setPen(QPen(colour, width * mm, style, Qt::FlatCap));
    };
    switch (index) {
    case 0:
    case 1:
        line(blue, 0.25);
        p.drawLine(place - QPointF(0, 1.3 * mm), place + QPointF(0, 1.3 * mm));
        p.setBrush(index == 1 ? blue : ground);
        p.drawEllipse(place, markRadius, markRadius);
        break;
    case 2:
        line(grey, 0.25);
        p.setBrush(ground);
        p.drawRect(QRectF(place.x() - markRadius, place.y() - markRadius, 2 * markRadius, 2 * markRadius));
        break;
    case 3:
        line(text, 0.4);
        p.drawLine(place - QPointF(half, 0), place + QPointF(half, 0));
        break;
    case 4:
        p.fillRect(QRectF(place.x() - half, place.y() - 1 * mm, 2 * half, 2 * mm),
                   blend(blue, ground, bandStrength));
        line(blue, 0.4);
        p.drawLine(place - QPointF(half, 0), place + QPointF(half, 0));
        break;
    case 5:
        line(text, 0.12, Qt::DashLine);
        p.drawLine(place - QPointF(0, 1.5 * mm), place + QPointF(0, 1.5 * mm));
        break;
    default:
        line(blue, 0.25);
        p.setBrush(ground);
        p.drawPolygon(triangleAt(place, markRadius));
    }
}

constexpr std::size_t samples = 7;

} // namespace

FigureTransform drawTrendFigure(QPainter &painter, const QRectF &area, const TrendFigure &figure,
                                Medium medium) {
    const bool large = figure.label.isEmpty();
    const QColor text = figureColor(FigureRole::text, medium);
    const double label = large ? 0 : labelWidth;
    constexpr double cells = 4;
    const bool hasLegend = !figure.legend.empty();
    const double legendRow = 4.2 * mm;
    const std::size_t legendRows = (figure.legend.size() + 2) / 3;
    const double below = large && hasLegend ? static_cast<double>(legendRows) * legendRow : 0;
    const double cell = large ? area.width() : (area.width() - label - (cells - 1) * panelGap) / cells;
    FigureTransform result;
    double left = area.left() + label;
    for (const TrendPanel &panel : figure.panels) {
        const QRectF place(left, area.top(), cell, area.height() - below);
        result = PanelPainter(painter, place, panel, medium, large).draw();
        left += cell + panelGap;
    }
    if (!large) {
        drawText(painter, {area.left(), area.top() + 8 * mm}, figure.label, text, true);
        drawText(painter, {area.left(), area.top() + 12 * mm}, figure.note, text);
    }
    const double column = large ? area.width() / 3 : 0;
    for (std::size_t i = 0; i < std::min(figure.legend.size(), samples); ++i) {
        const auto row = static_cast<double>(i);
        const std::size_t line = i / 3;
        const QPointF place =
            large ? QPointF(area.left() + static_cast<double>(i % 3) * column + 4 * mm,
                            area.bottom() - below + (static_cast<double>(line) + 0.5) * legendRow)
                  : QPointF(left + 4 * mm, area.top() + (row + 1) * 3.6 * mm);
        drawSample(painter, i, place, medium);
        drawText(painter, place + QPointF(4.5 * mm, 0), figure.legend[i], text);
    }
    return result;
}

} // namespace palmer
