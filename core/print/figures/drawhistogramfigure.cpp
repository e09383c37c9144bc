// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawhistogramfigure.h"

#include "print/figures/drawtext.h"
#include "print/figures/metrics.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palmer {

namespace {

constexpr double histogramSide = 2 * mm;
constexpr double histogramTop = 2 * mm;
constexpr double histogramFoot = 17 * mm;      ///< numbers, title and legend below the plot
constexpr double histogramTitleRow = 7.8 * mm; ///< centre, below the plot
constexpr double histogramLegendRow = 13 * mm;
constexpr double histogramSampleWidth = 5 * mm;
constexpr double histogramSampleHeight = 2.6 * mm;
constexpr double histogramSampleGap = 1.5 * mm;
constexpr double legendGap = 5 * mm; ///< upper bound
constexpr double leastLegendGap = 1.5 * mm;

class HistogramPainter {
public:
    HistogramPainter(QPainter &painter, const QRectF &area, const HistogramFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_medium(medium)
        , m_area(area)
        , m_plot(area.adjusted(histogramSide, histogramTop, -histogramSide, -histogramFoot)) {}

    FigureTransform draw() {
        if (m_plot.width() <= 0 || m_plot.height() <= 0)
            return {};
        p.setRenderHint(QPainter::Antialiasing);
        p.setRenderHint(QPainter::TextAntialiasing);
        drawHistogramBars(p, m_plot, m_figure, m_medium, figurePen(FigureRole::evaluated, m_medium).widthF());
        p.setPen(figurePen(FigureRole::trialMean, m_medium));
        p.drawLine(QPointF(x(m_figure.mean), m_plot.top()), QPointF(x(m_figure.mean), m_plot.bottom()));
        drawAxis();
        drawLegend();
        const double scale = m_plot.width() / (m_figure.x.to - m_figure.x.from);
        return {m_plot, QTransform(scale, 0, 0, 1, m_plot.left() - m_figure.x.from * scale, m_plot.top()), 0};
    }

private:
    enum class Sample { evaluated, mean, coverage };

    [[nodiscard]] double x(double value) const {
        return m_plot.left() + (value - m_figure.x.from) / (m_figure.x.to - m_figure.x.from) * m_plot.width();
    }
    [[nodiscard]] QColor colour(FigureRole role) const { return figureColor(role, m_medium); }

    void drawAxis() {
        QPen axis = figurePen(FigureRole::axis, m_medium);
        axis.setCapStyle(Qt::FlatCap);
        p.setPen(axis);
        p.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        for (const Tick &tick : m_figure.x.ticks) {
            p.setPen(axis);
            const double at = x(tick.value);
            p.drawLine(QPointF(at, m_plot.bottom()), QPointF(at, m_plot.bottom() + tickLength));
            const double width = textWidth(tick.label);
            const double left = std::clamp(at - width / 2, m_area.left(), m_area.right() - width);
            drawText(p, {left, m_plot.bottom() + tickRow}, tick.label, colour(FigureRole::text));
        }
        const QString title = QStringLiteral("%1 (%2)").arg(m_figure.x.symbol, m_figure.x.unit);
        drawText(p, {m_plot.center().x() - textWidth(title) / 2, m_plot.bottom() + histogramTitleRow}, title,
                 colour(FigureRole::text));
    }

    void drawSample(const QRectF &box, Sample sample) {
        if (sample == Sample::coverage) {
            p.fillRect(box, colour(FigureRole::histogram));
            return;
        }
        p.setPen(
            figurePen(sample == Sample::evaluated ? FigureRole::evaluated : FigureRole::trialMean, m_medium));
        p.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    }

    void drawLegend() {
        const std::array entries{std::pair(Sample::evaluated, m_figure.evaluatedText),
                                 std::pair(Sample::mean, m_figure.meanText),
                                 std::pair(Sample::coverage, m_figure.coverageText)};
        double width = 0;
        for (const auto &entry : entries)
            width += histogramSampleWidth + histogramSampleGap + textWidth(entry.second);
        const auto gaps = static_cast<double>(entries.size() - 1);
        const double gap = std::clamp((m_area.width() - width) / gaps, leastLegendGap, legendGap);
        double left = std::max(m_area.left(), m_plot.center().x() - (width + gap * gaps) / 2);
        const double row = m_plot.bottom() + histogramLegendRow;
        for (const auto &[sample, text] : entries) {
            drawSample(
                QRectF(left, row - histogramSampleHeight / 2, histogramSampleWidth, histogramSampleHeight),
                sample);
            left += histogramSampleWidth + histogramSampleGap;
            drawText(p, {left, row}, text, colour(FigureRole::text));
            left += textWidth(text) + gap;
        }
    }

    QPainter &p;
    const HistogramFigure &m_figure;
    Medium m_medium;
    QRectF m_area;
    QRectF m_plot;
};

} // namespace

FigureTransform drawHistogramFigure(QPainter &painter, const QRectF &area, const HistogramFigure &figure,
                                    Medium medium) {
    return HistogramPainter(painter, area, figure, medium).draw();
}

void drawHistogramBars(QPainter &painter, const QRectF &plot, const HistogramFigure &figure, Medium medium,
                       double line) {
    const double scale = plot.width() / (figure.x.to - figure.x.from);
    const auto x = [&](double value) { return plot.left() + (value - figure.x.from) * scale; };
    const long long most =
        figure.counts.empty() ? 0 : *std::max_element(figure.counts.begin(), figure.counts.end());
    for (std::size_t i = 0; most > 0 && i < figure.counts.size(); ++i) {
        if (figure.counts[i] == 0)
            continue;
        const double from = figure.from + figure.width * static_cast<double>(i);
        const double middle = from + figure.width / 2;
        const bool inside = middle >= figure.coverage.from && middle <= figure.coverage.to;
        const double height =
            plot.height() * static_cast<double>(figure.counts[i]) / static_cast<double>(most);
        // Keep a value without spread visible.
        const double width = std::max(figure.width * scale, line);
        painter.fillRect(QRectF(x(from), plot.bottom() - height, width, height),
                         figureColor(inside ? FigureRole::histogram : FigureRole::histogramTail, medium));
    }
    painter.setPen(QPen(figureColor(FigureRole::evaluated, medium), line, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x(figure.evaluated), plot.top()), QPointF(x(figure.evaluated), plot.bottom()));
}

} // namespace palmer
