// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "print/figures/plotframe.h"
#include "print/fonts.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double rowPitch = 5.6;   ///< mm
constexpr double headHeight = 5.6; ///< mm: column titles
constexpr double footHeight = 12;  ///< mm: scale, its numbers and its title
constexpr double barHeight = 1.9 * mm;
constexpr double limitHeight = 3.4 * mm;
constexpr double capHeight = 1.4 * mm; ///< of an error bar
constexpr double columnGap = 3.2 * mm;

class BarFigurePainter {
public:
    BarFigurePainter(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_area(area)
        , m_entries(entriesOf())
        , m_frame(painter, area, plotIn(area), figure.x, {}, medium, barFrame) {}

    FigureTransform draw() {
        if (!m_frame.begin())
            return {};
        drawHead();
        const auto rows = static_cast<double>(m_figure.bars.size());
        const double pitch = rows == 0 ? 0 : std::min(rowPitch * mm, m_frame.plot().height() / rows);
        m_frame.setHeight(pitch * rows);
        m_frame.drawVerticalGrid();
        for (const BarLine &line : m_figure.lines) {
            p.setPen(penOf(line));
            m_frame.drawVertical(line.at);
        }
        // Rows closer than their text: only some of them are named.
        const auto named =
            static_cast<std::size_t>(std::ceil(figureTextSize / std::max(pitch, figureTextSize / 100.0)));
        for (std::size_t i = 0; i < m_figure.bars.size(); ++i) {
            const double row = m_frame.plot().top() + (static_cast<double>(i) + 0.5) * pitch;
            if (i % named == 0)
                drawTexts(m_figure.bars[i], row);
            if (m_figure.dots)
                drawDot(m_figure.bars[i], row, pitch);
            else
                drawBar(p,
                        QRectF(m_frame.plot().left(), row - barHeight / 2, m_frame.plot().width(), barHeight),
                        m_figure.bars[i].size / m_figure.x.to, m_figure.bars[i].first, m_medium);
        }
        const QPen axis = m_frame.axisPen(Qt::FlatCap);
        p.setPen(axis);
        p.drawLine(m_frame.plot().bottomLeft(), m_frame.plot().bottomRight());
        p.drawLine(m_frame.plot().topLeft(), m_frame.plot().bottomLeft());
        m_frame.drawX(axis);
        m_frame.drawXTitle(
            axisTitle(m_figure.x, {},
                      (isBudget() ? QStringLiteral(" (%1, k\u00A0=\u00A02)") : QStringLiteral(" (%1)"))
                          .arg(m_figure.x.unit)));
        m_frame.drawLegendRows(m_entries, barFrame.legend);
        return m_frame.transform();
    }

private:
    static TextLine nameOf(const Bar &bar) { return {{bar.name}, {bar.subscript, true}}; }
    [[nodiscard]] TextLine valueTitle() const {
        return axisTitle(m_figure.x, {}, QStringLiteral(", ") + m_figure.x.unit);
    }
    /// The contributions to an uncertainty have shares; other bars none.
    [[nodiscard]] bool isBudget() const { return !m_figure.shareTitle.isEmpty(); }
    [[nodiscard]] QString shareTitle() const {
        return isBudget() ? m_figure.shareTitle + QStringLiteral(", %") : QString();
    }
    [[nodiscard]] QColor text() const { return m_frame.colour(FigureRole::text); }

    [[nodiscard]] QPen penOf(const BarLine &line) const {
        return figurePen(line.chosen ? FigureRole::evaluated : FigureRole::trialMean, m_medium);
    }

    [[nodiscard]] std::vector<PlotEntry> entriesOf() {
        std::vector<PlotEntry> entries;
        const auto add = [&](const QString &text, std::function<void(const QRectF &)> draw) {
            if (!text.isEmpty())
                entries.push_back({barFrame.sampleWidth, text, std::move(draw)});
        };
        if (m_figure.dots) {
            add(m_figure.dots->dot, [this](const QRectF &box) {
                drawError(box.left(), box.right(), box.top(), capHeight);
                drawMark(box.center());
            });
            add(m_figure.dots->limit, [this](const QRectF &box) { drawLimit(box.center(), limitHeight); });
        }
        for (const BarLine &line : m_figure.lines) {
            add(line.text, [this, pen = penOf(line)](const QRectF &box) {
                p.setPen(pen);
                p.drawLine(box.topLeft(), box.topRight());
            });
        }
        return entries;
    }

    /// Area of the bars; measures the columns next to it.
    [[nodiscard]] QRectF plotIn(const QRectF &area) {
        for (const Bar &bar : m_figure.bars) {
            m_nameWidth = std::max(m_nameWidth, textWidth(nameOf(bar), bar.first));
            m_valueWidth = std::max(m_valueWidth, textWidth(bar.value, bar.first));
            m_shareWidth = std::max(m_shareWidth, textWidth(bar.share, bar.first));
        }
        m_valueWidth = std::max(m_valueWidth, textWidth(valueTitle(), true));
        m_shareWidth = std::max(m_shareWidth, textWidth(shareTitle(), true));
        m_nameWidth = std::min(m_nameWidth, 0.42 * area.width());
        const double left = area.left() + m_nameWidth + columnGap;
        const double right = area.right() - m_valueWidth - m_shareWidth - 2 * columnGap;
        const double legend = legendRows(m_entries, right - left, barFrame) * legendPitch;
        return {left, area.top() + headHeight * mm, right - left,
                area.height() - (headHeight + footHeight) * mm - legend};
    }
    [[nodiscard]] double valueEdge() const { return m_area.right() - m_shareWidth - columnGap; }

    void drawRight(double edge, double row, const TextLine &line, bool bold) {
        drawText(p, {edge - textWidth(line, bold), row}, line, text(), bold);
    }

    void drawHead() {
        const double row = m_area.top() + headHeight * mm / 2;
        drawRight(valueEdge(), row, valueTitle(), true);
        drawRight(m_area.right(), row, {{shareTitle()}}, true);
        if (!m_figure.note.isEmpty()) {
            const double room = valueEdge() - m_valueWidth - columnGap - m_area.left();
            const QString note =
                QFontMetricsF(paperFont(figureTextSize)).elidedText(m_figure.note, Qt::ElideRight, room);
            drawText(p, {m_area.left(), row}, note, text());
        }
    }

    void drawTexts(const Bar &bar, double row) {
        Bar shown = bar;
        const QFontMetricsF metrics(paperFont(figureTextSize, bar.first));
        if (textWidth(nameOf(bar), bar.first) > m_nameWidth + 0.5) {
            shown.name = metrics.elidedText(bar.name, Qt::ElideRight, m_nameWidth);
            shown.subscript.clear();
        }
        drawText(p, {m_area.left(), row}, nameOf(shown), text(), bar.first);
        drawRight(valueEdge(), row, {{bar.value}}, bar.first);
        drawRight(m_area.right(), row, {{bar.share}}, bar.first);
    }

    void drawDot(const Bar &bar, double row, double pitch) {
        if (bar.limit)
            drawLimit({m_frame.x(*bar.limit), row}, std::min(limitHeight, pitch));
        if (bar.expanded)
            drawError(std::max(m_frame.x(bar.size - *bar.expanded), m_frame.plot().left()),
                      m_frame.x(bar.size + *bar.expanded), row, std::min(capHeight, pitch));
        drawMark({m_frame.x(bar.size), row});
    }
    void drawError(double left, double right, double row, double cap) {
        p.setPen(m_frame.pen(FigureRole::upEdge));
        p.drawLine(QPointF(left, row), QPointF(right, row));
        for (const double end : {left, right})
            p.drawLine(QPointF(end, row - cap / 2), QPointF(end, row + cap / 2));
    }
    void drawMark(QPointF place) {
        p.setPen(Qt::NoPen);
        p.setBrush(m_frame.colour(FigureRole::up));
        p.drawEllipse(place, dotRadius, dotRadius);
        p.setBrush(Qt::NoBrush);
    }
    void drawLimit(QPointF place, double height) {
        QPen pen = m_frame.pen(FigureRole::centre);
        pen.setCapStyle(Qt::FlatCap);
        p.setPen(pen);
        p.drawLine(place - QPointF(0, height / 2), place + QPointF(0, height / 2));
    }

    QPainter &p;
    const BarFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    double m_nameWidth = 0;
    double m_valueWidth = 0;
    double m_shareWidth = 0;
    std::vector<PlotEntry> m_entries;
    PlotFrame m_frame;
};

} // namespace

FigureTransform drawKind(QPainter &painter, const QRectF &area, const BarFigure &figure, Medium medium) {
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
    constexpr double highest = 200; // of a page
    const double legend = (figure.lines.empty() ? 0 : 1) + (figure.dots ? 1 : 0);
    return std::min(highest, headHeight + footHeight + legend * legendPitch / mm +
                                 rowPitch * static_cast<double>(figure.bars.size()));
}

} // namespace palmer
