// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/targetbarsview.h"

#include "print/figures/style.h"
#include "ui/formulatext.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr double titleHeight = 18;
constexpr double labelHeight = 14;
constexpr double numberHeight = 16;
constexpr double leastNumberWidth = 14; ///< below it only some targets are numbered

} // namespace

TargetBarsView::TargetBarsView(Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection) {
    setObjectName(QStringLiteral("targetBars"));
}

void TargetBarsView::setBars(const std::optional<TargetBars> &bars, const QString &title) {
    m_bars = bars;
    m_title = title;
    setVisible(bars.has_value());
    if (bars) {
        QStringList values;
        for (std::size_t i = 0; i < bars->labels.size(); ++i)
            values << QStringLiteral("%1: %2").arg(QString::number(i + 1), bars->labels[i]);
        setAccessibleName(bars->title.plain() + QStringLiteral(" ") + title);
        setAccessibleDescription(values.join(QStringLiteral("; ")));
    }
    update();
}

QRectF TargetBarsView::plot() const {
    return {0, titleHeight + labelHeight, static_cast<double>(width()),
            height() - titleHeight - labelHeight - numberHeight};
}

void TargetBarsView::paintEvent(QPaintEvent *) {
    if (!m_bars || m_bars->values.empty())
        return;
    QPainter painter(this);
    const QColor secondary = token(Token::secondaryText, palette());
    const QColor explanation = token(Token::explanation, palette());
    const QColor bar = blend(secondary, palette().color(QPalette::Base), 0.5);
    const QFont tiny = themeFont(TextSize::tiny);
    const double titleWidth = formulaWidth(m_bars->title, tiny);
    drawFormula(painter, QRectF(0, 0, width(), titleHeight), Qt::AlignLeft, m_bars->title, tiny, secondary);
    painter.setFont(tiny);
    painter.setPen(secondary);
    painter.drawText(QRectF(titleWidth, 0, width() - titleWidth, titleHeight - 2),
                     Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral(" ") + m_title);

    double least = 0;
    double most = 0;
    for (const auto &value : m_bars->values) {
        least = std::min(least, value.value_or(0));
        most = std::max(most, value.value_or(0));
    }
    const double span = most > least ? most - least : 1;
    const QRectF area = plot();
    const auto y = [&](double value) { return area.top() + (most - value) / span * area.height(); };
    const double step = area.width() / static_cast<double>(m_bars->values.size());
    const double gap = std::min(4.0, step * 0.25);
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(leastNumberWidth / step)));
    for (std::size_t i = 0; i < m_bars->values.size(); ++i) {
        const bool ruling = m_bars->ruling == i;
        const double left = area.left() + static_cast<double>(i) * step;
        if (m_bars->values[i]) {
            const double value = *m_bars->values[i];
            painter.fillRect(QRectF(QPointF(left + gap / 2, std::min(y(value), y(0))),
                                    QPointF(left + step - gap / 2, std::max(y(value), y(0)))),
                             ruling ? explanation : bar);
            if (ruling) {
                painter.setFont(tiny);
                painter.setPen(explanation);
                const double width = painter.fontMetrics().horizontalAdvance(m_bars->labels[i]) + 2.0;
                const double at = std::clamp(left + step / 2 - width / 2, area.left(), area.right() - width);
                painter.drawText(QRectF(at, y(std::max(value, 0.0)) - labelHeight, width, labelHeight),
                                 Qt::AlignCenter, m_bars->labels[i]);
            }
        }
        if (ruling ||
            (i % stride == 0 &&
             !(m_bars->ruling && *m_bars->ruling<i + stride && * m_bars->ruling> i && stride > 1))) {
            painter.setFont(tiny);
            painter.setPen(ruling ? explanation : secondary);
            painter.drawText(QRectF(left - 8, area.bottom() + 1, step + 16, numberHeight), Qt::AlignCenter,
                             QString::number(i + 1));
        }
    }
    painter.setPen(secondary);
    painter.drawLine(QPointF(area.left(), y(0)), QPointF(area.right(), y(0)));
}

void TargetBarsView::mousePressEvent(QMouseEvent *event) {
    if (!m_bars || m_bars->values.empty() || width() == 0)
        return;
    const auto count = static_cast<double>(m_bars->values.size());
    const double at = event->position().x() / width() * count;
    m_selection.setTarget(static_cast<std::size_t>(std::clamp(at, 0.0, count - 1)));
}

} // namespace palmer::ui
