// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/targetstatisticsview.h"

#include "print/fonts.h"
#include "ui/formulatext.h"
#include "ui/theme.h"

#include <QPainter>
#include <QStringList>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int rowHeight = 20; // lets eleven targets be in sight at 768
constexpr int symbolWidth = 36;
constexpr int statisticsColumnWidth = 64;
constexpr int leastStatisticsColumn = 52;
constexpr int betweenNumbers = 10; ///< keeps neighbours apart

} // namespace

void TargetStatisticsView::setRows(const QString &unit, const QString &both, std::vector<Row> rows) {
    m_unit = unit;
    m_both = both;
    m_rows = std::move(rows);
    QStringList lines;
    for (const Row &row : m_rows)
        lines << QStringLiteral("%1: ↑ %2, ↓ %3, %4 %5")
                     .arg(row.symbol.plain(), row.values[0], row.values[1], both, row.values[2]);
    setAccessibleDescription(lines.join(QStringLiteral("; ")));
    updateGeometry();
    update();
}

/// As wide as the longest number: in small units numbers have many digits.
int TargetStatisticsView::columnWidth(int least) const {
    int widest = least - betweenNumbers;
    for (const Row &row : m_rows) {
        for (const QString &value : row.values)
            widest = std::max(widest, fontMetrics().horizontalAdvance(value) + 1);
    }
    return widest + betweenNumbers;
}

QSize TargetStatisticsView::sizeHint() const {
    return {symbolWidth + 3 * columnWidth(statisticsColumnWidth),
            rowHeight * (static_cast<int>(m_rows.size()) + 1)};
}

QSize TargetStatisticsView::minimumSizeHint() const {
    return {symbolWidth + 3 * columnWidth(leastStatisticsColumn),
            rowHeight * (static_cast<int>(m_rows.size()) + 1)};
}

void TargetStatisticsView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    const QColor secondary = token(Token::secondaryText, palette());
    const double column = (width() - symbolWidth) / 3.0;
    const auto cell = [&](int k, int row) {
        return QRectF(symbolWidth + k * column, row * rowHeight, column - 2, rowHeight - 1);
    };
    painter.setFont(themeFont(TextSize::small));
    painter.setPen(secondary);
    painter.drawText(QRectF(2, 0, symbolWidth, rowHeight - 1), Qt::AlignLeft | Qt::AlignVCenter, m_unit);
    painter.drawText(cell(2, 0), Qt::AlignRight | Qt::AlignVCenter, m_both);
    painter.setFont(paperFont(13, true));
    painter.setPen(token(Token::up, palette()));
    painter.drawText(cell(0, 0), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("↑"));
    painter.setPen(token(Token::downText, palette()));
    painter.drawText(cell(1, 0), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("↓"));
    painter.setPen(token(Token::lineStrong, palette()));
    painter.drawLine(0, rowHeight - 1, width(), rowHeight - 1);
    for (int r = 0; r < static_cast<int>(m_rows.size()); ++r) {
        const Row &row = m_rows[static_cast<std::size_t>(r)];
        const QColor text = palette().color(QPalette::Text);
        drawFormula(painter, QRectF(2, (r + 1) * rowHeight + 1, symbolWidth, rowHeight - 1), Qt::AlignLeft,
                    row.symbol, font(), text);
        painter.setFont(font());
        for (int k = 0; k < 3; ++k) {
            const QString &value = row.values[static_cast<std::size_t>(k)];
            painter.setPen(value == QStringLiteral("–") ? secondary : text);
            painter.drawText(cell(k, r + 1), Qt::AlignRight | Qt::AlignVCenter, value);
        }
        painter.setPen(token(Token::line, palette()));
        painter.drawLine(0, (r + 2) * rowHeight - 1, width(), (r + 2) * rowHeight - 1);
    }
}

} // namespace palmer::ui
