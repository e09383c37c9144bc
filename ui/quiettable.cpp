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
            drawElided(painter, room, alignment, text);
    }
    painter.setPen(token(Token::lineStrong, palette()));
    painter.drawLine(0, height() - 1, viewport()->width(), height() - 1);
}

void makeQuiet(QTableView &table, int rowHeight, int headHeight) {
    table.setHorizontalHeader(new QuietHeader(&table));
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(rowHeight);
    table.horizontalHeader()->setFixedHeight(headHeight);
    table.horizontalHeader()->setHighlightSections(false);
}

void RowDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                        const QModelIndex &index) const {
    const QRect area = option.rect;
    const QPalette &palette = option.palette;
    painter->save();
    if (const QColor colour = ground(option, index); colour.isValid())
        painter->fillRect(area, colour);
    if ((m_parts & selectedBar) && (option.state & QStyle::State_Selected))
        painter->fillRect(QRect(area.topLeft(), QSize(3, area.height())), token(Token::accent, palette));
    if ((m_parts & focusFrame) && (option.state & QStyle::State_HasFocus)) {
        painter->setPen(QPen(token(Token::accent, palette), 2));
        painter->drawRect(area.adjusted(1, 1, -1, -1));
    }
    if (m_parts & rule) {
        painter->setPen(token(Token::line, palette));
        painter->drawLine(area.bottomLeft(), area.bottomRight());
    }
    paintContent(*painter, option, index);
    painter->restore();
}

QColor RowDelegate::ground(const QStyleOptionViewItem &option, const QModelIndex &) const {
    return option.state & QStyle::State_Selected    ? selectedGround(option.palette)
           : option.state & QStyle::State_MouseOver ? token(Token::hover, option.palette)
                                                    : QColor();
}

bool RowDelegate::isCurrentRow(const QStyleOptionViewItem &option, const QModelIndex &index) {
    const auto *view = qobject_cast<const QAbstractItemView *>(option.widget);
    return view && view->hasFocus() && view->currentIndex().row() == index.row();
}

QColor QuietDelegate::ground(const QStyleOptionViewItem &option, const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    return index.data(refusedRole).toBool()        ? token(Token::badGround, palette)
           : option.state & QStyle::State_Selected ? selectedGround(palette)
           : index == m_hovered                    ? token(Token::hover, palette)
                                                   : palette.color(QPalette::Base);
}

void QuietDelegate::paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                                 const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    const QVariant font = index.data(Qt::FontRole);
    const QVariant colour = index.data(Qt::ForegroundRole);
    drawElided(painter, option.rect.adjusted(tablePadding, 0, -tablePadding, 0),
               alignmentOf(index.data(Qt::TextAlignmentRole)), index.data().toString(),
               font.isValid() ? font.value<QFont>() : option.font,
               index.data(refusedRole).toBool() ? token(Token::bad, palette)
               : colour.isValid()               ? colour.value<QColor>()
                                                : palette.color(QPalette::Text));
    const bool hovered = index == m_hovered;
    if (hovered || (option.state & QStyle::State_HasFocus)) {
        painter.setPen(QPen(token(Token::accent, palette), hovered ? 1 : 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(option.rect.adjusted(1, 1, -1, -2));
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
