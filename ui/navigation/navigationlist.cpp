// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/navigation/navigationlist.h"

#include "ui/elidedlabel.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int iconWidth = 16;
constexpr int textLeft = 40;
constexpr int markWidth = 32;

const NavigationRow &rowAt(const QModelIndex &index) {
    return static_cast<const NavigationModel *>(index.model())->row(index.row());
}

class NavigationDelegate : public RowDelegate {
public:
    explicit NavigationDelegate(NavigationList &list)
        : RowDelegate(&list, selectedBar | focusFrame)
        , m_list(list) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const override {
        const bool head = rowAt(index).isHead();
        if (m_list.isRail())
            return {NavigationList::railWidth, head ? 8 : 40};
        if (head)
            return {NavigationList::fullWidth, index.row() == 0 ? 36 : 32};
        return {NavigationList::fullWidth, rowAt(index).detail.isEmpty() ? 28 : 44};
    }

    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override {
        return rowAt(index).isHead() ? QColor() : RowDelegate::ground(option, index);
    }

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        const NavigationRow &row = rowAt(index);
        if (row.isHead())
            paintHead(painter, option, index);
        else if (m_list.isRail())
            paintIcon(painter, option, row);
        else
            paintWords(painter, option, row);
    }

private:
    void paintHead(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const {
        if (m_list.isRail()) {
            if (index.row() > 0) {
                painter.setPen(token(Token::line, option.palette));
                painter.drawLine(option.rect.left() + 12, option.rect.center().y(), option.rect.right() - 12,
                                 option.rect.center().y());
            }
            return;
        }
        QFont font = themeFont(TextSize::tiny);
        font.setWeight(QFont::DemiBold);
        font.setCapitalization(QFont::AllUppercase);
        painter.setFont(font);
        painter.setPen(token(Token::secondaryText, option.palette));
        painter.drawText(option.rect.adjusted(pageMargin, 0, -pageMargin, -6),
                         Qt::AlignLeft | Qt::AlignBottom, index.data().toString());
    }

    /// Icon of the collapsed list, with the marks on its corners.
    static void paintIcon(QPainter &painter, const QStyleOptionViewItem &option, const NavigationRow &row) {
        drawLineIcon(painter, option.rect, row.icon, option.palette.color(QPalette::WindowText));
        if (!row.mark.icon.isEmpty()) {
            const QRect corner(option.rect.center() + QPoint(4, 2), QSize(14, 14));
            painter.setPen(Qt::NoPen);
            painter.setBrush(option.state & QStyle::State_Selected ? selectedGround(option.palette)
                                                                   : option.palette.color(QPalette::Window));
            painter.drawEllipse(corner);
            drawLineIcon(painter, corner, row.mark.icon, token(row.mark.colour, option.palette));
        }
        if (!row.accordance.icon.isEmpty()) {
            drawLineIcon(painter, QRect(option.rect.center() + QPoint(6, -15), QSize(14, 14)),
                         row.accordance.icon, token(row.accordance.colour, option.palette));
        } else if (row.count > 0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(token(Token::unsure, option.palette));
            painter.drawEllipse(QRect(option.rect.center() + QPoint(6, -12), QSize(6, 6)));
        }
    }

    static void paintWords(QPainter &painter, const QStyleOptionViewItem &option, const NavigationRow &row) {
        const QColor text = option.palette.color(QPalette::WindowText);
        const QRect top(option.rect.left(), option.rect.top() + (row.detail.isEmpty() ? 0 : 4),
                        option.rect.width(), row.detail.isEmpty() ? option.rect.height() : 20);
        drawLineIcon(painter, QRect(pageMargin, top.top(), iconWidth, top.height()), row.icon, text);
        QFont font = themeFont(TextSize::base);
        if (option.state & QStyle::State_Selected)
            font.setWeight(QFont::DemiBold);
        const int right = row.mark.icon.isEmpty() && row.count == 0 ? pageMargin / 2 : markWidth;
        drawElided(painter, top.adjusted(textLeft, 0, -right, 0), Qt::AlignLeft, row.name, font, text);
        const QRect markArea(option.rect.right() - markWidth + 4, top.top(), 20, top.height());
        if (!row.mark.icon.isEmpty())
            drawLineIcon(painter, markArea, row.mark.icon, token(row.mark.colour, option.palette));
        painter.setFont(themeFont(TextSize::tiny));
        if (row.count > 0)
            paintBadge(painter, markArea, row.count, option.palette);
        if (!row.detail.isEmpty()) {
            const int room = row.accordance.icon.isEmpty() ? pageMargin / 2 : markWidth;
            const QRect area(option.rect.left() + textLeft, option.rect.top() + 22,
                             option.rect.width() - textLeft - room, 16);
            drawElided(painter, area, Qt::AlignLeft, row.detail, painter.font(),
                       token(Token::secondaryText, option.palette));
            if (!row.accordance.icon.isEmpty())
                drawLineIcon(painter, QRect(markArea.left(), area.top(), markArea.width(), area.height()),
                             row.accordance.icon, token(row.accordance.colour, option.palette));
        }
    }

    static void paintBadge(QPainter &painter, const QRect &area, int count, const QPalette &palette) {
        QRect badge(0, 0, 20, 20);
        badge.moveCenter(area.center());
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(token(Token::unsureGround, palette));
        painter.drawEllipse(badge);
        painter.setPen(token(Token::unsure, palette));
        painter.drawText(badge, Qt::AlignCenter, QString::number(count));
    }

    NavigationList &m_list;
};

} // namespace

NavigationList::NavigationList(NavigationModel &model, QWidget *parent)
    : Translated(parent)
    , m_model(model) {
    setObjectName(QStringLiteral("navigation"));
    setModel(&model);
    setItemDelegate(new NavigationDelegate(*this));
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
    setMinimumWidth(railWidth);
    retranslate();
}

void NavigationList::setRail(bool rail) {
    if (m_rail == rail)
        return;
    m_rail = rail;
    scheduleDelayedItemsLayout();
    viewport()->update();
}

void NavigationList::setCurrentRow(const QModelIndex &index) {
    m_silent = true;
    setCurrentIndex(index);
    m_silent = false;
}

void NavigationList::currentChanged(const QModelIndex &current, const QModelIndex &previous) {
    QListView::currentChanged(current, previous);
    if (m_silent)
        return;
    if (const auto page = m_model.pageAt(current))
        emit pageChosen(*page);
    if (const auto test = m_model.testAt(current))
        emit testChosen(*test);
}

void NavigationList::retranslate() {
    setAccessibleName(tr("Pages of the report, tests"));
    m_model.retranslate();
}

} // namespace palmer::ui
