// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/plotgestures.h"

#include <QApplication>
#include <QChartView>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace palmer::ui {

QRectF rangeOf(const FigureAxis &x, const FigureAxis &y) {
    return {QPointF(x.from, y.from), QPointF(x.to, y.to)};
}

QRectF rangeWithin(const QRectF &wanted, const QRectF &whole, QSizeF deepest) {
    constexpr double nearlyAll = 1 - 1e-12; // rounding never leaves a range just short of the whole
    const auto within = [](double centre, double span, double from, double all, double depth) {
        if (span > all * nearlyAll)
            return std::pair(from, all);
        span = std::max(span, all / depth);
        return std::pair(std::clamp(centre - span / 2, from, std::max(from, from + all - span)), span);
    };
    const auto [left, width] =
        within(wanted.center().x(), wanted.width(), whole.left(), whole.width(), deepest.width());
    const auto [top, height] =
        within(wanted.center().y(), wanted.height(), whole.top(), whole.height(), deepest.height());
    return {left, top, width, height};
}

template <class Widget>
PlotGestures<Widget>::PlotGestures(QWidget *parent)
    : Widget(parent) {
    this->setMouseTracking(true);
    this->setFocusPolicy(Qt::StrongFocus);
    this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

/// Keeps the value at `about` (by default the middle) in place.
template <class Widget>
void PlotGestures<Widget>::zoom(double steps, const std::optional<QPointF> &about) {
    layOut();
    const QRectF now = range();
    if (steps == 0 || now.isEmpty())
        return;
    const QRectF all = whole();
    const auto factor = [&](double span, double most, double depth) {
        const double wanted = std::pow(zoomStep, -steps);
        return all.isNull() ? wanted : std::clamp(wanted, most / depth / span, most / span);
    };
    const double right = factor(now.width(), all.width(), deepestZoom().width());
    const double up = factor(now.height(), all.height(), deepestZoom().height());
    const QPointF at = valueAt(about.value_or(plotArea().center()));
    setRange({at.x() + (now.left() - at.x()) * right, at.y() + (now.top() - at.y()) * up, now.width() * right,
              now.height() * up});
}

template <class Widget>
void PlotGestures<Widget>::zoomBy(int steps) {
    zoom(steps);
}

template <class Widget>
void PlotGestures<Widget>::pan(const QPointF &by) {
    layOut();
    if (const QRectF now = range(); !now.isEmpty())
        setRange(now.translated(valueAt({0, 0}) - valueAt(by)));
}

template <class Widget>
void PlotGestures<Widget>::drag(const QPointF & /*from*/, const QPointF &last, const QPointF &to) {
    pan(to - last);
}

template <class Widget>
void PlotGestures<Widget>::mousePressEvent(QMouseEvent *event) {
    if (event->button() == Qt::LeftButton)
        m_pressed = event->position();
}

template <class Widget>
void PlotGestures<Widget>::mouseMoveEvent(QMouseEvent *event) {
    const QPointF at = event->position();
    if (!m_pressed || !(event->buttons() & Qt::LeftButton)) {
        layOut();
        hover(at);
    } else if (m_dragged || (at - *m_pressed).manhattanLength() >= QApplication::startDragDistance()) {
        const QPointF last = std::exchange(m_dragged, at).value_or(*m_pressed);
        drag(*m_pressed, last, at);
    }
}

template <class Widget>
void PlotGestures<Widget>::mouseReleaseEvent(QMouseEvent *event) {
    if (event->button() != Qt::LeftButton)
        return;
    const auto from = std::exchange(m_pressed, {});
    const auto to = std::exchange(m_dragged, {});
    if (from && to)
        drop(*from, *to);
    else if (from)
        click(event->position());
}

template <class Widget>
void PlotGestures<Widget>::mouseDoubleClickEvent(QMouseEvent *) {
    fit();
}

template <class Widget>
void PlotGestures<Widget>::wheelEvent(QWheelEvent *event) {
    zoom(event->angleDelta().y() / 120.0, event->position());
    event->accept(); // even at the zoom limit, so that the area around the plot never scrolls
}

template <class Widget>
void PlotGestures<Widget>::keyPressEvent(QKeyEvent *event) {
    const QPointF step = keyStep();
    switch (event->key()) {
    case Qt::Key_Plus:
        return zoom(1);
    case Qt::Key_Minus:
        return zoom(-1);
    case Qt::Key_0:
        return fit();
    case Qt::Key_Left:
        return pan({step.x(), 0});
    case Qt::Key_Right:
        return pan({-step.x(), 0});
    case Qt::Key_Up:
        return pan({0, step.y()});
    case Qt::Key_Down:
        return pan({0, -step.y()});
    default:
        event->ignore();
    }
}

template <class Widget>
void PlotGestures<Widget>::leaveEvent(QEvent *event) {
    hover({});
    Widget::leaveEvent(event);
}

template class PlotGestures<PictureWidget>;
template class PlotGestures<QChartView>;

} // namespace palmer::ui
