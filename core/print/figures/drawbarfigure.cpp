// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawbarfigure.h"

#include "print/figures/drawtext.h"
#include "print/figures/metrics.h"
#include "print/fonts.h"

#include <QFontMetricsF>
#include <algorithm>

namespace palmer {

namespace {

constexpr double rowPitch = 5.6;   ///< mm
constexpr double headHeight = 5.6; ///< mm: column titles
constexpr double footHeight = 12;  ///< mm: scale, its numbers and its title
constexpr double barHeight = 1.9 * mm;
constexpr double columnGap = 3.2 * mm;
constexpr double scaleTitleRow = 8.1 * mm; ///< centre of the scale title

class BarFigurePainter {
public:
    BarFigurePainter(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_area(area) {
        for (const Bar &bar : figure.bars) {
            m_nameWidth = std::max(m_nameWidth, textWidth(nameOf(bar), bar.first));
            m_valueWidth = std::max(m_valueWidth, textWidth(bar.value, bar.first));
            m_shareWidth = std::max(m_shareWidth, textWidth(bar.share, bar.first));
        }
        m_valueWidth = std::max(m_valueWidth, textWidth(valueTitle(), true));
        m_shareWidth = std::max(m_shareWidth, textWidth(shareTitle(), true));
        m_nameWidth = std::min(m_nameWidth, 0.42 * area.width());
        const double left = area.left() + m_nameWidth + columnGap;
        const double right = area.right() - m_valueWidth - m_shareWidth - 2 * columnGap;
        m_plot = QRectF(left, area.top() + headHeight * mm, right - left,
                        area.height() - (headHeight + footHeight) * mm);
    }

    FigureTransform draw() {
        if (m_plot.width() <= 0 || m_plot.height() <= 0)
            return {};
        p.setRenderHint(QPainter::Antialiasing);
        p.setRenderHint(QPainter::TextAntialiasing);
        drawHead();
        const double pitch =
            m_figure.bars.empty()
                ? 0
                : std::min(rowPitch * mm, m_plot.height() / static_cast<double>(m_figure.bars.size()));
        m_plot.setHeight(pitch * static_cast<double>(m_figure.bars.size()));
        drawGrid();
        for (std::size_t i = 0; i < m_figure.bars.size(); ++i)
            drawRow(m_figure.bars[i], m_plot.top() + (static_cast<double>(i) + 0.5) * pitch);
        drawScale();
        const double scale = m_plot.width() / (m_figure.x.to - m_figure.x.from);
        return {m_plot, QTransform(scale, 0, 0, 1, m_plot.left() - m_figure.x.from * scale, m_plot.top()), 0};
    }

private:
    static TextLine nameOf(const Bar &bar) { return {{bar.name}, {bar.subscript, true}}; }
    [[nodiscard]] TextLine valueTitle() const {
        return {{m_figure.x.symbol}, {m_figure.x.subscript, true}, {QStringLiteral(", ") + m_figure.x.unit}};
    }
    [[nodiscard]] QString shareTitle() const { return m_figure.shareTitle + QStringLiteral(", %"); }
    [[nodiscard]] double x(double value) const {
        return m_plot.left() + (value - m_figure.x.from) / (m_figure.x.to - m_figure.x.from) * m_plot.width();
    }
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }
    [[nodiscard]] double valueEdge() const { return m_area.right() - m_shareWidth - columnGap; }

    void drawRight(double edge, double row, const TextLine &line, bool bold) {
        drawText(p, {edge - textWidth(line, bold), row}, line, colour(FigureRole::text), bold);
    }

    void drawHead() {
        const double row = m_area.top() + headHeight * mm / 2;
        drawRight(valueEdge(), row, valueTitle(), true);
        drawRight(m_area.right(), row, {{shareTitle()}}, true);
        if (!m_figure.note.isEmpty()) {
            const double room = valueEdge() - m_valueWidth - columnGap - m_area.left();
            const QString note =
                QFontMetricsF(paperFont(figureTextSize)).elidedText(m_figure.note, Qt::ElideRight, room);
            drawText(p, {m_area.left(), row}, note, colour(FigureRole::text));
        }
    }

    void drawGrid() {
        p.setPen(figurePen(FigureRole::grid, m_medium));
        for (const Tick &tick : m_figure.x.ticks)
            p.drawLine(QPointF(x(tick.value), m_plot.top()), QPointF(x(tick.value), m_plot.bottom()));
    }

    void drawRow(const Bar &bar, double row) {
        Bar shown = bar;
        const QFontMetricsF metrics(paperFont(figureTextSize, bar.first));
        if (textWidth(nameOf(bar), bar.first) > m_nameWidth + 0.5) {
            shown.name = metrics.elidedText(bar.name, Qt::ElideRight, m_nameWidth);
            shown.subscript.clear();
        }
        drawText(p, {m_area.left(), row}, nameOf(shown), colour(FigureRole::text), bar.first);
        drawBar(p, QRectF(m_plot.left(), row - barHeight / 2, m_plot.width(), barHeight),
                bar.size / m_figure.x.to, bar.first, m_medium);
        drawRight(valueEdge(), row, {{bar.value}}, bar.first);
        drawRight(m_area.right(), row, {{bar.share}}, bar.first);
    }

    void drawScale() {
        const QColor text = colour(FigureRole::text);
        QPen axis = figurePen(FigureRole::axis, m_medium);
        axis.setCapStyle(Qt::FlatCap);
        p.setPen(axis);
        p.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        p.drawLine(m_plot.topLeft(), m_plot.bottomLeft());
        for (const Tick &tick : m_figure.x.ticks) {
            p.setPen(axis);
            const double at = x(tick.value);
            p.drawLine(QPointF(at, m_plot.bottom()), QPointF(at, m_plot.bottom() + tickLength));
            drawText(p, {at - textWidth(tick.label) / 2, m_plot.bottom() + tickRow}, tick.label, text);
        }
        const TextLine title{{m_figure.x.symbol},
                             {m_figure.x.subscript, true},
                             {QStringLiteral(" (%1, k\u00A0=\u00A02)").arg(m_figure.x.unit)}}; // in a budget
        drawText(p, {m_plot.center().x() - textWidth(title) / 2, m_plot.bottom() + scaleTitleRow}, title,
                 text);
    }

    QPainter &p;
    const BarFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    QRectF m_plot;
    double m_nameWidth = 0;
    double m_valueWidth = 0;
    double m_shareWidth = 0;
};

} // namespace

FigureTransform drawBarFigure(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium) {
    return BarFigurePainter(painter, area, figure, medium).draw();
}

void drawBar(QPainter &painter, const QRectF &rect, double part, bool first, Medium medium) {
    QRectF bar = rect;
    bar.setWidth(rect.width() * std::clamp(part, 0.0, 1.0));
    if (medium != Medium::paper)
        painter.fillRect(QRectF(bar.topRight(), rect.bottomRight()),
                         figureColor(FigureRole::barGround, medium));
    painter.fillRect(bar, figureColor(first ? FigureRole::firstBar : FigureRole::bar, medium));
}

double printedHeight(const BarFigure &figure) {
    return headHeight + footHeight + rowPitch * static_cast<double>(figure.bars.size());
}

} // namespace palmer
