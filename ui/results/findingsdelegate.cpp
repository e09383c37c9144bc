// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/findingsdelegate.h"

#include "ui/results/findingsmodel.h"
#include "ui/theme.h"

#include <QAbstractItemView>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int findingMarkWidth = 22;
constexpr int arrowWidth = 18;

struct Look {
    const char *icon = nullptr;
    Token colour = Token::secondaryText;
};

Look lookOf(Grade grade) {
    switch (grade) {
    case Grade::requirement:
        return {"miss", Token::bad};
    case Grade::recommendation:
        return {"warn", Token::unsure};
    case Grade::note:
        break;
    }
    return {"info", Token::secondaryText};
}

} // namespace

QSize FindingsDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const {
    return {100, findingRowHeight};
}

void FindingsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                             const QModelIndex &index) const {
    const FindingsModel::Line &line = static_cast<const FindingsModel *>(index.model())->line(index.row());
    const QPalette &palette = option.palette;
    const QRect row = option.rect;
    // With the keyboard, a row becomes current before it is selected.
    const auto *list = qobject_cast<const QAbstractItemView *>(option.widget);
    const bool current = list && list->hasFocus() && list->currentIndex() == index;
    if (current)
        painter->fillRect(row, selectedGround(palette));
    else if (option.state & QStyle::State_MouseOver)
        painter->fillRect(row, token(Token::hover, palette));
    painter->setPen(token(Token::line, palette));
    painter->drawLine(row.bottomLeft(), row.bottomRight());
    const Look look = lookOf(line.grade);
    drawLineIcon(*painter, QRect(row.left(), row.top(), 16, row.height()), QString::fromLatin1(look.icon),
                 token(look.colour, palette));
    const QColor secondary = token(Token::secondaryText, palette);
    drawLineIcon(*painter, QRect(row.right() - 15, row.top(), 14, row.height()), QStringLiteral("right"),
                 secondary);

    QFont font = themeFont(TextSize::small);
    painter->setFont(font);
    const QFontMetrics metrics(font);
    const int clauseWidth = line.clause.isEmpty() ? 0 : metrics.horizontalAdvance(line.clause) + 6;
    painter->setPen(secondary);
    painter->drawText(row.adjusted(0, 0, -arrowWidth, 0), Qt::AlignRight | Qt::AlignVCenter, line.clause);
    const QRect room = row.adjusted(findingMarkWidth, 0, -arrowWidth - clauseWidth, 0);
    painter->setPen(palette.color(QPalette::Text));
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(line.text, Qt::ElideRight, room.width()));
}

} // namespace palmer::ui
