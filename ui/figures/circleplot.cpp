// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/circleplot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palmer::ui {

namespace {

constexpr double deepestCircleZoom = 500; ///< times
constexpr double millimetresPerPixel = 25.4 / 96;

/// The nearest view that shows nothing outside the figure and is within the zoom limit.
CircleView viewWithin(CircleView view, QSizeF size) {
    view.zoom = std::clamp(view.zoom, 1.0, deepestCircleZoom);
    const double free = 1 - 1 / view.zoom;
    const double x = size.width() / 2 * free;
    const double y = size.height() / 2 * free;
    return {std::clamp(view.x, -x, x), std::clamp(view.y, -y, y), view.zoom};
}

} // namespace

void CirclePlot::fitFigure() {
    const double step = millimetresPerPixel / devicePixelRatioF(); // one step per device pixel
    const QSizeF size = plotArea().size() * millimetresPerPixel;
    if (!m_figure || m_figure->size != size || m_figure->pointStep != step) {
        const double before = m_figure ? m_figure->figureRadius : 0;
        m_figure = wholeFigure(size, step);
        if (before > 0) {
            m_view.x *= m_figure->figureRadius / before;
            m_view.y *= m_figure->figureRadius / before;
        }
    }
    m_view = viewWithin(m_view, m_figure->size);
    if (m_figure->view != m_view)
        m_figure = withView(std::move(*m_figure), paths(), m_view, m_language);
}

void CirclePlot::discardFigure() {
    m_figure.reset();
    discardPicture();
}

void CirclePlot::setView(const CircleView &view) {
    const CircleView next = m_figure ? viewWithin(view, m_figure->size) : view;
    if (next == m_view)
        return;
    m_view = next;
    discardPicture();
}

QRectF CirclePlot::range() const {
    QRectF range(QPointF(), whole().size() / m_view.zoom);
    range.moveCenter({m_view.x, m_view.y});
    return range;
}

/// Panning keeps the zoom exactly, as the points then need not be made again.
void CirclePlot::setRange(const QRectF &range) {
    const QRectF next = rangeWithin(range, whole(), deepestZoom());
    const double zoom = whole().width() / next.width();
    const bool isSame = std::abs(zoom - m_view.zoom) < 1e-9 * zoom;
    setView({next.center().x(), next.center().y(), isSame ? m_view.zoom : zoom});
}

QRectF CirclePlot::whole() const {
    if (!m_figure)
        return {};
    const QSizeF size = m_figure->size;
    return {QPointF(-size.width() / 2, -size.height() / 2), size};
}

QSizeF CirclePlot::deepestZoom() const {
    return {deepestCircleZoom, deepestCircleZoom};
}

} // namespace palmer::ui
