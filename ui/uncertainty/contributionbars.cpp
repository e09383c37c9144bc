#include "ui/uncertainty/contributionbars.h"

#include "ui/figures/style.h"
#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

void ContributionBars::paint(QPainter *painter, const QStyleOptionViewItem &option,
                             const QModelIndex &index) const {
    constexpr double barHeight = 9;
    const double part = index.data(partRole).toDouble();
    if (!(part > 0))
        return;
    QRectF bar(option.rect);
    bar.adjust(6, (bar.height() - barHeight) / 2, -6, 0);
    bar.setHeight(barHeight);
    const QColor secondary = token(Token::secondaryText, option.palette);
    const QColor ground = option.palette.color(QPalette::Base);
    painter->fillRect(bar, blend(token(Token::line, option.palette), ground, 0.7));
    bar.setWidth(bar.width() * part);
    painter->fillRect(bar, index.row() == 0 ? token(Token::accent, option.palette)
                                            : blend(secondary, ground, 0.5));
}

} // namespace palmer::ui
