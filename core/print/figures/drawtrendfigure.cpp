// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "print/figures/plotframe.h"
#include "print/fonts.h"

#include <QFontMetricsF>
#include <algorithm>

namespace palmer {

namespace {

constexpr double markRadius = 0.75 * mm;
constexpr double capWidth = 0.7 * mm;
constexpr double hatchHeight = 1.2 * mm;
constexpr double hatchStep = 0.9 * mm;
constexpr double labelWidth = 15 * mm; ///< of a row label
constexpr double panelGap = 2.5 * mm;
constexpr double titleHeight = 5.2 * mm; ///< above it no number of the axis
constexpr double titleLine = 2.1 * mm;   ///< middle of its text
constexpr double trendTickRow = 3.2 * mm;
constexpr double thin = 0.12 * mm;
constexpr double bandStrength = 0.13;

QRectF squareAt(QPointF place, double radius) {
    return {place.x() - radius, place.y() - radius, 2 * radius, 2 * radius};
}

QPolygonF triangleAt(QPointF place, double radius) {
    return {place + QPointF(0, -radius), place + QPointF(radius, 0.8 * radius),
            place + QPointF(-radius, 0.8 * radius)};
}

class PanelPainter {
public:
    PanelPainter(QPainter &painter, const QRectF &area, const TrendPanel &panel, Medium medium, bool large)
        : p(painter)
        , m_panel(panel)
        , m_large(large)
        , m_area(area)
        , m_frame(painter, area,
                  area.adjusted(widthOfNumbers(panel.y, trendFrame, 0),
                                titleHeight + (large ? titleHeight : 0), -1 * mm,
                                -(trendFrame.tick + trendTickRow + 1.5 * mm)),
                  panel.x, panel.y, medium, trendFrame)
        , m_plot(m_frame.plot()) {}

    FigureTransform draw() {
        if (!m_frame.begin())
            return {};
        drawGround();
        m_frame.inside([&] { drawInside(); });
        drawValues();
        drawNotBefore();
        setPen(FigureRole::axis, 0.2 * mm);
        const QPen axis = p.pen();
        m_frame.drawEdges();
        m_frame.drawX(axis);
        m_frame.drawY({}, AxisParts::numbers);
        drawTitle();
        return m_frame.transform();
    }

private:
    [[nodiscard]] QColor colour(FigureRole role) const { return m_frame.colour(role); }
    [[nodiscard]] QColor ground() const { return colour(FigureRole::background); }
    [[nodiscard]] double wide(double small, double large) const { return (m_large ? large : small) * mm; }

    void setPen(FigureRole role, double width, Qt::PenStyle style = Qt::SolidLine) {
        p.setPen(QPen(colour(role), width, style, Qt::FlatCap));
        p.setBrush(Qt::NoBrush);
    }

    void drawGround() {
        const double today = std::clamp(m_frame.x(m_panel.today), m_plot.left(), m_plot.right());
        p.fillRect(QRectF(QPointF(today, m_plot.top()), m_plot.bottomRight()),
                   blend(colour(FigureRole::text), ground(), 0.05));
        setPen(FigureRole::grid, thin);
        for (const Tick &tick : m_panel.y.ticks)
            m_frame.drawHorizontal(tick.value);
        if (m_large) {
            setPen(FigureRole::axis, thin);
            p.drawLine(QPointF(today, m_plot.top()), QPointF(today, m_plot.bottom()));
        }
    }

    void drawInside() {
        if (!m_panel.band.empty()) {
            p.setPen(Qt::NoPen);
            p.setBrush(blend(colour(FigureRole::up), ground(), bandStrength));
            p.drawPolygon(m_frame.outline(m_panel.band));
        }
        setPen(FigureRole::text, thin, Qt::DashLine);
        for (const TrendIntervention &one : m_panel.interventions)
            m_frame.drawVertical(one.x);
        for (const auto &limit : m_panel.limits)
            drawLimit(limit);
        setPen(FigureRole::guardBand, thin);
        for (const auto &joined : m_panel.joined)
            p.drawPolyline(m_frame.polyline(joined));
        setPen(FigureRole::up, wide(0.35, 0.5));
        p.drawPolyline(m_frame.polyline(m_panel.line));
        setPen(FigureRole::up, wide(0.35, 0.5), Qt::DashLine);
        p.drawPolyline(m_frame.polyline(m_panel.later));
    }

    void drawLimit(const std::vector<QPointF> &limit) {
        const QPolygonF steps = m_frame.polyline(limit);
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
            const QPointF place = m_frame.at({value.x, value.y});
            const bool other = value.mark == TrendMark::otherSeries;
            const FigureRole role = other ? FigureRole::guardBand : FigureRole::up;
            if (value.expanded) {
                const double top = std::max(m_frame.y(value.y + *value.expanded), m_plot.top());
                const double bottom = std::min(m_frame.y(value.y - *value.expanded), m_plot.bottom());
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
                p.drawRect(squareAt(place, radius));
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
        const QPointF place = m_frame.at(*m_panel.notBefore);
        setPen(FigureRole::up, wide(0.2, 0.3), Qt::DotLine);
        p.drawLine(place, QPointF(place.x(), m_plot.bottom()));
        const double radius = 1.3 * markRadius;
        setPen(FigureRole::up, wide(0.25, 0.35));
        p.setBrush(ground());
        p.drawPolygon(QPolygonF{place + QPointF(0, -radius), place + QPointF(radius, 0),
                                place + QPointF(0, radius), place + QPointF(-radius, 0)});
    }

    void drawTitle() {
        const double line = m_area.top() + titleLine;
        const QString unit = QStringLiteral(" (") + m_panel.unitName + QLatin1Char(')');
        const TextLine symbol = axisTitle(m_panel.y, {}, m_large ? unit : QString());
        // Starts at the axis labels, because "G(b)" with its index is wider than they are.
        drawText(p, {m_area.left(), line}, symbol, colour(FigureRole::text), true);
        const double width = textWidth(m_panel.statement, m_panel.isFirst);
        drawText(p, {m_area.right() - 1 * mm - width, line}, m_panel.statement, colour(FigureRole::text),
                 m_panel.isFirst);
        if (!m_large)
            return;
        double free = m_area.left();
        for (const TrendIntervention &one : m_panel.interventions) {
            const double wanted = m_frame.x(one.x) - textWidth(one.name) / 2;
            if (wanted < free)
                continue; // its line is drawn anyway
            drawText(p, {wanted, line + titleHeight}, one.name, colour(FigureRole::text));
            free = wanted + textWidth(one.name) + 1 * mm;
        }
    }

    QPainter &p;
    const TrendPanel &m_panel;
    bool m_large;
    QRectF m_area;
    PlotFrame m_frame;
    const QRectF &m_plot;
};

void drawSample(QPainter &p, TrendSign sign, QPointF place, Medium medium) {
    constexpr QPointF half(3 * mm, 0);
    const QColor text = figureColor(FigureRole::text, medium);
    const QColor blue = figureColor(FigureRole::up, medium);
    const QColor ground = figureColor(FigureRole::background, medium);
    const auto line = [&](const QColor &colour, double width, Qt::PenStyle style = Qt::SolidLine) {
        p.setPen(QPen(colour, width * mm, style, Qt::FlatCap));
    };
    switch (sign) {
    case TrendSign::asFound:
    case TrendSign::asLeft:
        line(blue, 0.25);
        p.drawLine(place - QPointF(0, 1.3 * mm), place + QPointF(0, 1.3 * mm));
        p.setBrush(sign == TrendSign::asLeft ? blue : ground);
        return p.drawEllipse(place, markRadius, markRadius);
    case TrendSign::otherSeries:
        line(figureColor(FigureRole::guardBand, medium), 0.25);
        p.setBrush(ground);
        return p.drawRect(squareAt(place, markRadius));
    case TrendSign::limit:
        line(text, 0.4);
        return p.drawLine(place - half, place + half);
    case TrendSign::line:
        p.fillRect(QRectF(place.x() - half.x(), place.y() - 1 * mm, 2 * half.x(), 2 * mm),
                   blend(blue, ground, bandStrength));
        line(blue, 0.4);
        return p.drawLine(place - half, place + half);
    case TrendSign::intervention:
        line(text, 0.12, Qt::DashLine);
        return p.drawLine(place - QPointF(0, 1.5 * mm), place + QPointF(0, 1.5 * mm));
    case TrendSign::noRole:
        line(blue, 0.25);
        p.setBrush(ground);
        return p.drawPolygon(triangleAt(place, markRadius));
    }
}

/// Breaks a note between its entries; an entry wider than a line is elided.
QStringList linesOf(const QString &note, double width) {
    const QFontMetricsF metrics(paperFont(figureTextSize));
    const QString between = QStringLiteral(" · ");
    QStringList lines;
    for (const QString &entry : note.split(between, Qt::SkipEmptyParts)) {
        const bool fits =
            !lines.isEmpty() && metrics.horizontalAdvance(lines.back() + between + entry) <= width;
        if (fits)
            lines.back() += between + entry;
        else
            lines << metrics.elidedText(entry, Qt::ElideRight, width);
    }
    return lines;
}

} // namespace

FigureTransform drawKind(QPainter &painter, const QRectF &area, const TrendFigure &figure, Medium medium) {
    const bool large = figure.label.isEmpty();
    const QColor text = figureColor(FigureRole::text, medium);
    const double label = large ? 0 : labelWidth;
    constexpr double cells = 4;
    const bool hasLegend = !figure.legend.empty();
    const std::size_t legendRows = (figure.legend.size() + 2) / 3;
    const QStringList lines = large ? linesOf(figure.note, area.width()) : QStringList();
    const double note = static_cast<double>(lines.size()) * legendPitch;
    const double below = note + (large && hasLegend ? static_cast<double>(legendRows) * legendPitch : 0);
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
    for (qsizetype i = 0; i < lines.size(); ++i)
        drawText(painter, {area.left(), area.bottom() - note + (static_cast<double>(i) + 0.5) * legendPitch},
                 lines[i], text);
    const double column = large ? area.width() / 3 : 0;
    for (std::size_t i = 0; i < figure.legend.size(); ++i) {
        const auto row = static_cast<double>(i);
        const std::size_t line = i / 3;
        const QPointF place =
            large ? QPointF(area.left() + static_cast<double>(i % 3) * column + 4 * mm,
                            area.bottom() - below + (static_cast<double>(line) + 0.5) * legendPitch)
                  : QPointF(left + 4 * mm, area.top() + (row + 1) * 3.6 * mm);
        drawSample(painter, figure.legend[i].sign, place, medium);
        drawText(painter, place + QPointF(4.5 * mm, 0), figure.legend[i].text, text);
    }
    return result;
}

} // namespace palmer
