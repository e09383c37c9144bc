// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis/feedsview.h"

#include "figures/circlefigure.h"
#include "ui/theme.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int keyHeight = 22;

} // namespace

FeedsView::FeedsView(QWidget *parent)
    : CirclePlot(parent) {
    setObjectName(QStringLiteral("feedsView"));
}

void FeedsView::show(std::span<const DiagnosedTest> tests, std::span<const PathProfile> paths,
                     const Language &language) {
    const bool same = tests.data() == m_tests.data() && tests.size() == m_tests.size();
    m_tests = tests;
    m_paths = paths;
    m_language = language;
    discardFigure();
    if (!same)
        fit();
}

CircleFigure FeedsView::wholeFigure(QSizeF size, double pointStep) const {
    CircleFigureOptions options;
    options.size = size;
    options.pointStep = pointStep;
    return feedsFigure(m_tests, m_paths, m_language, options);
}

CircleFigure FeedsView::figure() {
    fitFigure();
    return *m_figure;
}

QRectF FeedsView::plotArea() const {
    return QRectF(rect()).adjusted(0, 0, 0, -keyHeight);
}

void FeedsView::drawPicture(QPainter &painter) {
    if (m_tests.empty())
        return;
    CircleFigure circles = figure();
    const std::vector<CircleLegendEntry> key = std::exchange(circles.legend, {});
    const Medium medium = screenMedium(palette());
    m_transform = drawFigure(painter, plotArea(), circles, medium);
    drawKey(painter, key, medium);
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

} // namespace palmer::ui
