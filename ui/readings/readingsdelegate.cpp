#include "ui/readings/readingsdelegate.h"

#include "ui/readings/readingsmodel.h"
#include "ui/theme.h"

#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int textMargin = 8;
constexpr int rulingBar = 3;

/// A thin colour over a ground, opaque.
QColor tint(const QColor &colour, const QColor &ground, double strength) {
    const auto mix = [strength](int a, int b) { return qRound(a * strength + b * (1 - strength)); };
    return QColor(mix(colour.red(), ground.red()), mix(colour.green(), ground.green()),
                  mix(colour.blue(), ground.blue()));
}

} // namespace

void ReadingsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                             const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    const QRect cell = option.rect;
    const auto *model = static_cast<const ReadingsModel *>(index.model());
    const bool computed = index.column() >= model->computedColumn();
    const bool ruling = std::ranges::find(m_ruling, index.row()) != m_ruling.end();
    const bool selected = (option.state & QStyle::State_Selected) != 0;
    const bool current = m_current == index;
    const QColor base = palette.color(QPalette::Base);
    const QColor accent = token(Token::accent, palette);

    QColor ground = computed ? tint(palette.color(QPalette::Window), base, 0.6) : base;
    if (ruling)
        ground = tint(token(Token::explanation, palette), base, 0.13);
    else if (selected && !current)
        ground = tint(accent, base, 0.26);
    else if (m_current.isValid() && m_current.row() == index.row() && !current)
        ground = tint(accent, base, 0.13);
    painter->fillRect(cell, ground);

    painter->setPen(token(Token::line, palette));
    painter->drawLine(cell.bottomLeft(), cell.bottomRight());
    if (index.data(ReadingsModel::groupEndRole).toBool()) {
        painter->setPen(tint(palette.color(QPalette::Text), base, 0.22));
        painter->drawLine(cell.topRight(), cell.bottomRight());
    }
    if (ruling && index.column() == ReadingsModel::numberColumn)
        painter->fillRect(QRect(cell.left(), cell.top(), rulingBar, cell.height()),
                          token(Token::explanation, palette));

    const bool excluded = index.data(ReadingsModel::excludedRole).toBool();
    const bool missing = index.data(ReadingsModel::missingRole).toBool();
    QFont font = option.font;
    font.setStrikeOut(excluded);
    font.setBold(ruling && !computed);
    painter->setFont(font);
    const bool secondary =
        excluded || missing || computed || (index.column() == ReadingsModel::numberColumn && !ruling);
    painter->setPen(secondary ? token(Token::secondaryText, palette) : palette.color(QPalette::Text));
    painter->drawText(cell.adjusted(2, 0, -textMargin, 0), Qt::AlignRight | Qt::AlignVCenter,
                      index.data(Qt::DisplayRole).toString());

    const bool hovered = m_hovered == index;
    if (!current && !hovered)
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const double width = current ? 2 : 1;
    painter->setPen(QPen(accent, width));
    painter->setBrush(Qt::NoBrush);
    const double inset = current ? 1 : 1.5;
    painter->drawRoundedRect(QRectF(cell).adjusted(inset, inset, -inset - 1, -inset - 1), 3, 3);
    painter->restore();
}

} // namespace palmer::ui
