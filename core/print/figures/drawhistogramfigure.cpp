// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawkinds.h"

#include "print/figures/plotframe.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr double histogramSide = 2 * mm;
constexpr double histogramTop = 2 * mm;
constexpr double histogramFoot = 17 * mm; ///< numbers, title and legend below the plot

class HistogramPainter {
public:
    HistogramPainter(QPainter &painter, const QRectF &area, const HistogramFigure &figure, Medium medium)
        : p(painter)
        , m_figure(figure)
        , m_area(area)
        , m_frame(painter, area, area.adjusted(histogramSide, histogramTop, -histogramSide, -histogramFoot),
                  figure.x, {}, medium, histogramFrame)
        , m_medium(medium) {}

    FigureTransform draw() {
        if (!m_frame.begin())
            return {};
        drawHistogramBars(p, m_frame.plot(), m_figure, m_medium, m_frame.pen(FigureRole::evaluated).widthF());
        p.setPen(m_frame.pen(FigureRole::trialMean));
        m_frame.drawVertical(m_figure.mean);
        const QPen axis = m_frame.axisPen(Qt::FlatCap);
        p.setPen(axis);
        p.drawLine(m_frame.plot().bottomLeft(), m_frame.plot().bottomRight());
        m_frame.drawX(axis);
        m_frame.drawXTitle({{QStringLiteral("%1 (%2)").arg(m_figure.x.symbol, m_figure.x.unit)}});
        const auto entry = [this](Sample sample, const QString &text) {
            return PlotEntry{histogramFrame.sampleWidth, text,
                             [this, sample](const QRectF &box) { drawSample(box, sample); }};
        };
        m_frame.drawLegendRow(std::array{entry(Sample::evaluated, m_figure.evaluatedText),
                                         entry(Sample::mean, m_figure.meanText),
                                         entry(Sample::coverage, m_figure.coverageText)},
                              m_area.width());
        return m_frame.transform();
    }

private:
    enum class Sample { evaluated, mean, coverage };

    void drawSample(const QRectF &box, Sample sample) {
        if (sample == Sample::coverage) {
            p.fillRect(box, m_frame.colour(FigureRole::histogram));
            return;
        }
        p.setPen(m_frame.pen(sample == Sample::evaluated ? FigureRole::evaluated : FigureRole::trialMean));
        p.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    }

    QPainter &p;
    const HistogramFigure &m_figure;
    QRectF m_area;
    PlotFrame m_frame;
    Medium m_medium;
};

} // namespace

FigureTransform drawKind(QPainter &painter, const QRectF &area, const HistogramFigure &figure,
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
