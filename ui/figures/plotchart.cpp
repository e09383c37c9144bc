// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/plotchart.h"

#include "ui/theme.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QPainter>
#include <utility>

namespace palmer::ui {

void setUpChart(QChartView &view, const QMargins &margins) {
    view.setRenderHint(QPainter::Antialiasing);
    view.setFrameShape(QFrame::NoFrame);
    view.setViewportUpdateMode(QGraphicsView::FullViewportUpdate); // the foreground covers the whole chart
    view.chart()->legend()->hide();
    view.chart()->layout()->setContentsMargins(0, 0, 0, 0);
    view.chart()->setMargins(margins);
    view.chart()->setBackgroundRoundness(0);
}

PlotChart::PlotChart(QWidget *parent, const QMargins &margins)
    : PlotGestures(parent) {
    setUpChart(*this, margins);
}

void PlotChart::setRange(const QRectF &range) {
    if (m_range.isEmpty())
        return;
    const QRectF next = rangeWithin(range, whole(), deepestZoom());
    if (next == m_range)
        return;
    m_range = next;
    hover({});
    showRange();
    viewport()->update();
}

QRectF PlotChart::plotArea() const {
    return chart()->plotArea();
}

QPointF PlotChart::valueAt(const QPointF &place) const {
    const QRectF plot = plotArea();
    return {m_range.left() + (place.x() - plot.left()) / plot.width() * m_range.width(),
            m_range.top() + (plot.bottom() - place.y()) / plot.height() * m_range.height()};
}

QPointF PlotChart::placeOf(const QPointF &value) const {
    const QRectF plot = plotArea();
    return {plot.left() + (value.x() - m_range.left()) / m_range.width() * plot.width(),
            plot.bottom() - (value.y() - m_range.top()) / m_range.height() * plot.height()};
}

QPointF PlotChart::keyStep() const {
    constexpr double share = 0.1; // of the view
    return {share * plotArea().width(), share * plotArea().height()};
}

void PlotChart::drag(const QPointF &from, const QPointF & /*last*/, const QPointF &to) {
    if (!plotArea().contains(from))
        return;
    m_frame = QRectF(from, to).normalized() & plotArea();
    if (deepestZoom().height() == 1) { // y is never zoomed
        m_frame.setTop(plotArea().top());
        m_frame.setBottom(plotArea().bottom());
    }
    hover({});
    viewport()->update();
}

void PlotChart::drop(const QPointF & /*from*/, const QPointF & /*to*/) {
    constexpr double least = 4; // a thinner frame would zoom to the limit
    const QRectF frame = std::exchange(m_frame, {});
    if (frame.width() >= least && frame.height() >= least)
        setRange(QRectF(valueAt(frame.topLeft()), valueAt(frame.bottomRight())).normalized());
    viewport()->update();
}

void PlotChart::drawForeground(QPainter *painter, const QRectF &) {
    painter->save();
    paintOver(*painter);
    painter->restore();
    if (!m_frame.isNull()) {
        painter->setPen(QPen(token(Token::accent, palette()), 1, Qt::DashLine));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(m_frame);
    }
    paintFocus(*painter, *this);
}

void PlotChart::focusInEvent(QFocusEvent *event) {
    QChartView::focusInEvent(event);
    viewport()->update();
}

void PlotChart::focusOutEvent(QFocusEvent *event) {
    QChartView::focusOutEvent(event);
    viewport()->update();
}

} // namespace palmer::ui
