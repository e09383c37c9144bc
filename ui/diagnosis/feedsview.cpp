// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis/feedsview.h"

#include "ui/figures/drawfigure.h"
#include "ui/theme.h"

#include <QEvent>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr double millimetresPerPixel = 25.4 / 96;
constexpr int keyHeight = 22;

} // namespace

FeedsView::FeedsView(QWidget *parent)
    : QWidget(parent) {
    setObjectName(QStringLiteral("feedsView"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FeedsView::show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
                     const Language &language) {
    m_tests = tests;
    m_paths = paths;
    m_language = language;
    m_drawn = {};
    update();
}

CircleFigure FeedsView::figure() const {
    CircleFigureOptions options;
    options.size = QSizeF(width(), height() - keyHeight) * millimetresPerPixel;
    options.pointStep = millimetresPerPixel / devicePixelRatioF();
    return feedsFigure(m_tests, m_paths, m_language, options);
}

void FeedsView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    if (m_tests.empty())
        return painter.fillRect(rect(), palette().color(QPalette::Base));
    const double ratio = devicePixelRatioF();
    const QSize wanted = (QSizeF(size()) * ratio).toSize();
    if (m_drawn.size() != wanted) {
        m_drawn = QPixmap(wanted);
        m_drawn.setDevicePixelRatio(ratio);
        QPainter drawing(&m_drawn);
        drawing.fillRect(rect(), palette().color(QPalette::Base));
        CircleFigure circles = figure();
        const std::vector<CircleLegendEntry> key = std::exchange(circles.legend, {});
        const Medium medium = isDark(palette()) ? Medium::screenDark : Medium::screenLight;
        drawFigure(drawing, QRectF(0, 0, width(), height() - keyHeight), circles, medium);
        drawKey(drawing, key, medium);
    }
    painter.drawPixmap(0, 0, m_drawn);
}

/// Below the circles, side by side.
void FeedsView::drawKey(QPainter &painter, const std::vector<CircleLegendEntry> &entries,
                        Medium medium) const {
    painter.setFont(themeFont(TextSize::tiny));
    const double part = width() / std::max<double>(1, static_cast<double>(entries.size()));
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF place(part * static_cast<double>(i), height() - keyHeight, part, keyHeight);
        painter.setPen(layerPen(entries[i].layer, medium));
        painter.drawLine(place.topLeft() + QPointF(2, 3), place.topRight() + QPointF(-4, 3));
        painter.setPen(palette().color(QPalette::Text));
        // The unit stands once where it has no room each time.
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
