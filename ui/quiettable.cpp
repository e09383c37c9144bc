// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quiettable.h"

#include "ui/elidedlabel.h"
#include "ui/formulatext.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

namespace {

Qt::Alignment alignmentOf(const QVariant &value) {
    return value.isValid() ? static_cast<Qt::Alignment>(value.toInt()) : Qt::AlignLeft | Qt::AlignVCenter;
}

} // namespace

QuietHeader::QuietHeader(QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent) {}

void QuietHeader::paintEvent(QPaintEvent *) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    painter.setFont(themeFont(TextSize::small));
    const QFontMetrics metrics(painter.font());
    for (int column = 0; column < count(); ++column) {
        const QRect section(sectionViewportPosition(column), 0, sectionSize(column), height());
        if (section.right() < 0 || section.left() > viewport()->width())
            continue;
        const QRect room = section.adjusted(tablePadding, 0, -tablePadding, -2);
        const QVariant colour = model()->headerData(column, Qt::Horizontal, Qt::ForegroundRole);
        painter.setPen(colour.isValid() ? colour.value<QColor>() : token(Token::secondaryText, palette()));
        const QString text = model()->headerData(column, Qt::Horizontal).toString();
        const Qt::Alignment alignment =
            alignmentOf(model()->headerData(column, Qt::Horizontal, Qt::TextAlignmentRole));
        if (namesSymbol(text))
            drawFormula(painter, room, alignment, formulaFrom(text), painter.font(), painter.pen().color());
        else
            painter.drawText(room, alignment, metrics.elidedText(text, Qt::ElideRight, room.width()));
    }
    painter.setPen(token(Token::lineStrong, palette()));
    painter.drawLine(0, height() - 1, viewport()->width(), height() - 1);
}

void QuietDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    const bool hovered = index == m_hovered;
    const bool refused = index.data(refusedRole).toBool();
    painter->fillRect(option.rect, refused                                 ? token(Token::badGround, palette)
                                   : option.state & QStyle::State_Selected ? selectedGround(palette)
                                   : hovered                               ? token(Token::hover, palette)
                                                                           : palette.color(QPalette::Base));
    painter->setPen(token(Token::line, palette));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const QVariant colour = index.data(Qt::ForegroundRole);
    painter->setFont(option.font);
    painter->setPen(refused            ? token(Token::bad, palette)
                    : colour.isValid() ? colour.value<QColor>()
                                       : palette.color(QPalette::Text));
    const QRect room = option.rect.adjusted(tablePadding, 0, -tablePadding, 0);
    painter->drawText(room, alignmentOf(index.data(Qt::TextAlignmentRole)),
                      option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, room.width()));
    if (hovered || (option.state & QStyle::State_HasFocus)) {
        painter->setPen(QPen(token(Token::accent, palette), hovered ? 1 : 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option.rect.adjusted(1, 1, -1, -2));
    }
}

void QuietDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const {
    constexpr auto filled = "filled";
    if (editor->property(filled).toBool())
        return;
    editor->setProperty(filled, true);
    QStyledItemDelegate::setEditorData(editor, index);
}

} // namespace palmer::ui
