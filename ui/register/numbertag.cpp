// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/numbertag.h"

#include "ui/theme.h"

#include <QPainter>
#include <algorithm>
#include <array>

namespace palmer::ui {

QColor curveColour(std::size_t curve, const QPalette &palette) {
    const std::array colours{palette.color(QPalette::Text), token(Token::explanation, palette),
                             token(Token::accent, palette), token(Token::downText, palette),
                             token(Token::ok, palette),     token(Token::secondaryText, palette)};
    return colours.at(curve % colours.size());
}

void drawNumberTag(QPainter &painter, const QPointF &centre, int number, const QPalette &palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(curveColour(static_cast<std::size_t>(std::max(number - 1, 0)), palette));
    painter.drawEllipse(centre, tagRadius, tagRadius);
    QFont font = themeFont(TextSize::tiny);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(palette.color(QPalette::Base));
    painter.drawText(QRectF(centre.x() - tagRadius, centre.y() - tagRadius, 2 * tagRadius, 2 * tagRadius),
                     Qt::AlignCenter, QString::number(number));
    painter.restore();
}

void drawRoleMark(QPainter &painter, const QPointF &centre, TrendMark mark, const QColor &colour,
                  const QPalette &palette) {
    constexpr double radius = trendMarkRadius;
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(mark == TrendMark::asLeft ? colour : palette.color(QPalette::Base));
    if (mark == TrendMark::otherSeries)
        painter.drawRect(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius));
    else if (mark == TrendMark::noRole)
        painter.drawPolygon(QPolygonF{centre + QPointF(0, -radius), centre + QPointF(radius, 0.8 * radius),
                                      centre + QPointF(-radius, 0.8 * radius)});
    else
        painter.drawEllipse(centre, radius, radius);
}

} // namespace palmer::ui
