// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/numberaxis.h"

#include "ui/theme.h"

#include <QCategoryAxis>
#include <QChart>

namespace palmer::ui {

QCategoryAxis *makeNumberAxis(const FigureAxis &range, const QPalette &palette, const QString &title) {
    auto *axis = new QCategoryAxis;
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    axis->setLabelsColor(token(Token::secondaryText, palette));
    axis->setLabelsFont(themeFont(TextSize::tiny));
    axis->setTruncateLabels(false); // an elided number is useless; a low chart leaves out some labels instead
    axis->setTitleFont(themeFont(TextSize::tiny));
    axis->setTitleBrush(token(Token::secondaryText, palette));
    axis->setTitleText(title);
    axis->setTitleVisible(!title.isEmpty());
    axis->setGridLineColor(token(Token::line, palette));
    axis->setLinePenColor(token(Token::secondaryText, palette));
    axis->setRange(range.from, range.to);
    fillTicks(*axis, range);
    return axis;
}

void fillTicks(QCategoryAxis &axis, const FigureAxis &range) {
    for (const QString &label : axis.categoriesLabels())
        axis.remove(label);
    axis.setStartValue(axis.min());
    for (const Tick &tick : range.ticks) {
        if (tick.value >= axis.min() && tick.value <= axis.max())
            axis.append(tick.label, tick.value);
    }
}

void clear(QChart &chart) {
    chart.removeAllSeries();
    for (QAbstractAxis *axis : chart.axes()) {
        chart.removeAxis(axis);
        delete axis;
    }
}

} // namespace palmer::ui
