// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/figures/plotgestures.h"

#include <QChartView>
#include <QMargins>

namespace palmer::ui {

/// Leaves of a chart only the plot with its axes, smooth, with these margins.
void setUpChart(QChartView &view, const QMargins &margins);

/// A chart of Qt Charts with the gestures of all plots, except that dragging zooms to a frame.
class PlotChart : public PlotGestures<QChartView> {
    Q_OBJECT

public:
    PlotChart(QWidget *parent, const QMargins &margins);

    [[nodiscard]] QRectF range() const override { return m_range; }
    void setRange(const QRectF &range) override;

protected:
    /// Shows the range in series and axes.
    virtual void showRange() = 0;
    virtual void paintOver(QPainter &painter) = 0;
    /// Shows the whole of other content.
    void showWhole() { m_range = whole(); }
    [[nodiscard]] QPointF placeOf(const QPointF &value) const;

    [[nodiscard]] QRectF plotArea() const override;
    [[nodiscard]] QPointF valueAt(const QPointF &place) const override;
    [[nodiscard]] QPointF keyStep() const override;
    void drag(const QPointF &from, const QPointF &last, const QPointF &to) override;
    void drop(const QPointF &from, const QPointF &to) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    QRectF m_range;
    QRectF m_frame; ///< of a drag, pixels; null without
};

} // namespace palmer::ui
