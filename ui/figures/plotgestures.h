// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "ui/picturewidget.h"

#include <QRectF>
#include <optional>

namespace palmer::ui {

inline constexpr double zoomStep = 1.25; ///< factor per wheel step or key

/// The ranges of two axes. The top of the rectangle is the lowest value of y.
[[nodiscard]] QRectF rangeOf(const FigureAxis &x, const FigureAxis &y);

/// `wanted` limited to the whole, and to a depth of zoom in each direction (times).
[[nodiscard]] QRectF rangeWithin(const QRectF &wanted, const QRectF &whole, QSizeF deepest);

/// Zoom, pan and hover, the same for all plots. The wheel zooms about the pointer, plus and minus about the
/// middle; dragging and arrows move; a double click or 0 shows the whole. A plot says what is in view and
/// what lies under the pointer. `Widget` is a PictureWidget or a QChartView.
template <class Widget>
class PlotGestures : public Widget {
public:
    explicit PlotGestures(QWidget *parent);

    /// The range in view, in the units of the axes; null without content.
    [[nodiscard]] virtual QRectF range() const = 0;
    virtual void setRange(const QRectF &range) = 0;
    /// Shows the whole.
    virtual void fit() { setRange(whole()); }
    /// Zooms in about the middle by so many wheel steps, or out if negative.
    void zoomBy(int steps);

protected:
    /// Brings range and positions up to date before they are used.
    virtual void layOut() {}
    /// The range without zoom; null if setRange's receiver limits it.
    [[nodiscard]] virtual QRectF whole() const { return {}; }
    [[nodiscard]] virtual QSizeF deepestZoom() const { return {1, 1}; } ///< times, per direction
    [[nodiscard]] virtual QRectF plotArea() const = 0;
    [[nodiscard]] virtual QPointF valueAt(const QPointF &place) const = 0;
    /// Pixels by which an arrow key moves the content.
    [[nodiscard]] virtual QPointF keyStep() const { return {40, 40}; }
    /// The pointer is here without a button, or has left.
    virtual void hover(const std::optional<QPointF> & /*at*/) {}
    /// A left click without drag.
    virtual void click(const QPointF & /*at*/) {}
    /// Part of a drag that began at `from`; by default it moves the content.
    virtual void drag(const QPointF &from, const QPointF &last, const QPointF &to);
    virtual void drop(const QPointF & /*from*/, const QPointF & /*to*/) {}

    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void zoom(double steps, const std::optional<QPointF> &about = {});
    void pan(const QPointF &by);

    std::optional<QPointF> m_pressed;
    std::optional<QPointF> m_dragged; ///< last position of a drag
};

using PlotCanvas = PlotGestures<PictureWidget>;

} // namespace palmer::ui
