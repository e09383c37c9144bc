// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis/feedsview.h"

#include "figures/circlefigure.h"
#include "print/figures/drawfigure.h"
#include "ui/figures/circlecanvas.h"
#include "ui/figures/zoomkeys.h"
#include "ui/theme.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace palmer::ui {

namespace {

constexpr double millimetresPerPixel = 25.4 / 96;
constexpr int keyHeight = 22;

} // namespace

FeedsView::FeedsView(QWidget *parent)
    : QWidget(parent) {
    setObjectName(QStringLiteral("feedsView"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
}

void FeedsView::show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
                     const Language &language) {
    const bool same = tests.data() == m_tests.data() && tests.size() == m_tests.size();
    m_tests = tests;
    m_paths = paths;
    m_language = language;
    m_whole.reset();
    if (!same)
        m_view = {};
    m_drawn = {};
    update();
}

void FeedsView::makeWhole() {
    CircleFigureOptions options;
    options.size = QSizeF(width(), height() - keyHeight) * millimetresPerPixel;
    options.pointStep = millimetresPerPixel / devicePixelRatioF();
    if (m_whole && m_whole->size == options.size && m_whole->pointStep == options.pointStep)
        return;
    const double before = m_whole ? m_whole->figureRadius : 0;
    m_whole = feedsFigure(m_tests, m_paths, m_language, options);
    if (before > 0) { // keeps the same point in the middle
        m_view.x *= m_whole->figureRadius / before;
        m_view.y *= m_whole->figureRadius / before;
    }
    m_drawn = {};
}

CircleFigure FeedsView::figure() {
    makeWhole();
    m_view = CircleCanvas::within(m_view, *m_whole);
    return m_view == CircleView{} ? *m_whole : withView(*m_whole, m_paths, m_view, m_language);
}

void FeedsView::setView(const CircleView &view) {
    const CircleView next = m_whole ? CircleCanvas::within(view, *m_whole) : view;
    if (next == m_view)
        return;
    m_view = next;
    m_drawn = {};
    update();
}

void FeedsView::zoom(double factor, const QPointF &about) {
    drawAnew();
    if (!m_whole)
        return;
    const QPointF at = m_transform.toData(about);
    CircleView wanted = m_view;
    wanted.zoom = m_view.zoom / factor;
    const double zoomed = CircleCanvas::within(wanted, *m_whole).zoom;
    const double shrink = m_view.zoom / zoomed; // keeps the point under the pointer in place
    setView({at.x() + (m_view.x - at.x()) * shrink, at.y() + (m_view.y - at.y()) * shrink, zoomed});
}

void FeedsView::pan(const QPointF &by) {
    drawAnew();
    if (!m_whole)
        return;
    const QPointF moved = m_transform.toData(QPointF(0, 0)) - m_transform.toData(by);
    setView({m_view.x + moved.x(), m_view.y + moved.y(), m_view.zoom});
}

void FeedsView::drawAnew() {
    if (m_tests.empty())
        return;
    makeWhole();
    const double ratio = devicePixelRatioF();
    const QSize wanted = (QSizeF(size()) * ratio).toSize();
    if (m_drawn.size() == wanted)
        return;
    CircleFigure circles = figure();
    const std::vector<CircleLegendEntry> key = std::exchange(circles.legend, {});
    m_drawn = QPixmap(wanted);
    m_drawn.setDevicePixelRatio(ratio);
    QPainter drawing(&m_drawn);
    drawing.fillRect(rect(), palette().color(QPalette::Base));
    const Medium medium = isDark(palette()) ? Medium::screenDark : Medium::screenLight;
    m_transform = drawFigure(drawing, QRectF(0, 0, width(), height() - keyHeight), circles, medium);
    drawKey(drawing, key, medium);
}

void FeedsView::paintEvent(QPaintEvent *) {
    drawAnew();
    QPainter painter(this);
    if (m_tests.empty())
        return painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.drawPixmap(0, 0, m_drawn);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(token(Token::accent, palette()), 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
}

// ---- Pointer and keys ------------------------------------------------------------------------------------

void FeedsView::mousePressEvent(QMouseEvent *event) {
    if (event->button() == Qt::LeftButton)
        m_drag = event->position();
}

void FeedsView::mouseMoveEvent(QMouseEvent *event) {
    if (!m_drag || !(event->buttons() & Qt::LeftButton))
        return;
    const QPointF from = std::exchange(*m_drag, event->position());
    pan(event->position() - from);
}

void FeedsView::mouseReleaseEvent(QMouseEvent *) {
    m_drag.reset();
}

void FeedsView::mouseDoubleClickEvent(QMouseEvent *) {
    fit();
}

void FeedsView::wheelEvent(QWheelEvent *event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0)
        zoom(std::pow(zoomStep, -steps), event->position());
    event->accept();
}

void FeedsView::keyPressEvent(QKeyEvent *event) {
    const bool isTaken = takeZoomKey(*event, {[this](int steps) {
                                                  zoom(std::pow(zoomStep, -steps),
                                                       QRectF(0, 0, width(), height() - keyHeight).center());
                                              },
                                              [this](QPointF by) { pan(by); }, [this] { fit(); }});
    if (!isTaken)
        QWidget::keyPressEvent(event);
}

void FeedsView::focusInEvent(QFocusEvent *event) {
    QWidget::focusInEvent(event);
    update();
}

void FeedsView::focusOutEvent(QFocusEvent *event) {
    QWidget::focusOutEvent(event);
    update();
}

/// Draws the legend below the circles, side by side.
void FeedsView::drawKey(QPainter &painter, const std::vector<CircleLegendEntry> &entries,
                        Medium medium) const {
    painter.setFont(themeFont(TextSize::tiny));
    const double part = width() / std::max<double>(1, static_cast<double>(entries.size()));
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF place(part * static_cast<double>(i), height() - keyHeight, part, keyHeight);
        painter.setPen(layerPen(entries[i].layer, medium));
        painter.drawLine(place.topLeft() + QPointF(2, 3), place.topRight() + QPointF(-4, 3));
        painter.setPen(palette().color(QPalette::Text));
        // Without space for all units, only the first entry has one.
        const QString text = i > 0 && painter.fontMetrics().horizontalAdvance(entries[i].text) > part - 4
                                 ? entries[i].text.section(u'\u00A0', 0, 0)
                                 : entries[i].text;
        painter.drawText(place.adjusted(2, 5, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
    }
}

void FeedsView::changeEvent(QEvent *event) {
    if (event->type() == QEvent::PaletteChange) {
        m_drawn = {};
        update();
    }
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
