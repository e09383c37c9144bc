// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/navigation/navigationlist.h"

#include "ui/theme.h"

#include <QEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace palmer::ui {

namespace {

constexpr int margin = 16;
constexpr int iconWidth = 16;
constexpr int textLeft = 40;
constexpr int markWidth = 32;

class NavigationDelegate : public QStyledItemDelegate {
public:
    explicit NavigationDelegate(NavigationList &list)
        : QStyledItemDelegate(&list)
        , m_list(list) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const override {
        const bool head = index.data(NavigationModel::headRole).toBool();
        if (m_list.isRail())
            return {NavigationList::railWidth, head ? 8 : 40};
        if (head)
            return {NavigationList::fullWidth, index.row() == 0 ? 36 : 32};
        return {NavigationList::fullWidth,
                index.data(NavigationModel::detailRole).toString().isEmpty() ? 28 : 44};
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override {
        painter->save();
        if (index.data(NavigationModel::headRole).toBool())
            paintHead(*painter, option, index);
        else
            paintRow(*painter, option, index);
        painter->restore();
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
        painter.drawText(option.rect.adjusted(margin, 0, -margin, -6), Qt::AlignLeft | Qt::AlignBottom,
                         index.data().toString());
    }

    void paintRow(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) const {
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        if (selected) {
            painter.fillRect(option.rect, selectedGround(option.palette));
            painter.fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                             token(Token::accent, option.palette));
        } else if (option.state.testFlag(QStyle::State_MouseOver)) {
            painter.fillRect(option.rect, token(Token::hover, option.palette));
        }
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter.setPen(QPen(token(Token::accent, option.palette), 2));
            painter.drawRect(option.rect.adjusted(1, 1, -1, -1));
        }
        if (m_list.isRail())
            paintIcon(painter, option, RowMarks(option, index), selected);
        else
            paintWords(painter, option, index, selected);
    }

    /// Icon, marks and count of a row, shown next to its name.
    struct RowMarks {
        RowMarks(const QStyleOptionViewItem &option, const QModelIndex &index)
            : icon(index.data(NavigationModel::iconRole).toString())
            , mark(index.data(NavigationModel::markRole).toString())
            , markColour(token(static_cast<Token>(index.data(NavigationModel::markColourRole).toInt()),
                               option.palette))
            , accordance(index.data(NavigationModel::accordanceRole).toString())
            , accordanceColour(
                  token(static_cast<Token>(index.data(NavigationModel::accordanceColourRole).toInt()),
                        option.palette))
            , count(index.data(NavigationModel::countRole).toInt()) {}

        QString icon;
        QString mark;
        QColor markColour;
        QString accordance;
        QColor accordanceColour;
        int count;
    };

    /// Icon of the collapsed list, with the marks on its corners.
    static void paintIcon(QPainter &painter, const QStyleOptionViewItem &option, const RowMarks &marks,
                          bool selected) {
        drawLineIcon(painter, option.rect, marks.icon, option.palette.color(QPalette::WindowText));
        if (!marks.mark.isEmpty()) {
            const QRect corner(option.rect.center() + QPoint(4, 2), QSize(14, 14));
            painter.setPen(Qt::NoPen);
            painter.setBrush(selected ? selectedGround(option.palette)
                                      : option.palette.color(QPalette::Window));
            painter.drawEllipse(corner);
            drawLineIcon(painter, corner, marks.mark, marks.markColour);
        }
        if (!marks.accordance.isEmpty()) {
            drawLineIcon(painter, QRect(option.rect.center() + QPoint(6, -15), QSize(14, 14)),
                         marks.accordance, marks.accordanceColour);
        } else if (marks.count > 0) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(token(Token::unsure, option.palette));
            painter.drawEllipse(QRect(option.rect.center() + QPoint(6, -12), QSize(6, 6)));
        }
    }

    static void paintWords(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index,
                           bool selected) {
        const RowMarks marks(option, index);
        const QColor text = option.palette.color(QPalette::WindowText);
        const QString detail = index.data(NavigationModel::detailRole).toString();
        const QRect top(option.rect.left(), option.rect.top() + (detail.isEmpty() ? 0 : 4),
                        option.rect.width(), detail.isEmpty() ? option.rect.height() : 20);
        drawLineIcon(painter, QRect(margin, top.top(), iconWidth, top.height()), marks.icon, text);
        QFont font = themeFont(TextSize::base);
        if (selected)
            font.setWeight(QFont::DemiBold);
        painter.setFont(font);
        painter.setPen(text);
        const int right = marks.mark.isEmpty() && marks.count == 0 ? margin / 2 : markWidth;
        const QRect nameArea = top.adjusted(textLeft, 0, -right, 0);
        painter.drawText(
            nameArea, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, nameArea.width()));
        const QRect markArea(option.rect.right() - markWidth + 4, top.top(), 20, top.height());
        if (!marks.mark.isEmpty())
            drawLineIcon(painter, markArea, marks.mark, marks.markColour);
        painter.setFont(themeFont(TextSize::tiny));
        if (marks.count > 0)
            paintBadge(painter, markArea, marks.count, option.palette);
        if (!detail.isEmpty()) {
            painter.setPen(token(Token::secondaryText, option.palette));
            const int room = marks.accordance.isEmpty() ? margin / 2 : markWidth;
            const QRect area(option.rect.left() + textLeft, option.rect.top() + 22,
                             option.rect.width() - textLeft - room, 16);
            painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                             painter.fontMetrics().elidedText(detail, Qt::ElideRight, area.width()));
            if (!marks.accordance.isEmpty())
                drawLineIcon(painter, QRect(markArea.left(), area.top(), markArea.width(), area.height()),
                             marks.accordance, marks.accordanceColour);
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
    : QListView(parent)
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

void NavigationList::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QListView::changeEvent(event);
}

void NavigationList::retranslate() {
    setAccessibleName(tr("Pages of the report, tests"));
    m_model.retranslate();
}

} // namespace palmer::ui
