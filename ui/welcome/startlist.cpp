// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/startlist.h"

#include "ui/welcome/examples.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

namespace palmer::ui {

namespace {

class StartDelegate : public QStyledItemDelegate {
public:
    explicit StartDelegate(StartList *list)
        : QStyledItemDelegate(list)
        , m_list(*list) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override {
        return m_list.isCompact() ? m_list.compactSize() : QSize(200, StartList::rowHeight);
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override {
        painter->save();
        const QRect area = option.rect;
        if (option.state.testFlag(QStyle::State_MouseOver))
            painter->fillRect(area, token(Token::hover, option.palette));
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->setPen(QPen(token(Token::accent, option.palette), 2));
            painter->drawRect(area.adjusted(1, 1, -1, -1));
        }
        if (m_list.isCompact()) {
            paintLine(*painter, option, index);
            painter->restore();
            return;
        }
        if (index.row() > 0) {
            painter->setPen(token(Token::line, option.palette));
            painter->drawLine(area.left() + 44, area.top(), area.right() - 12, area.top());
        }
        const QColor text = option.palette.color(QPalette::WindowText);
        const QColor secondary = token(Token::secondaryText, option.palette);
        const QRect upper(area.left(), area.top() + 8, area.width(), 18);
        const QRect lower(area.left(), area.top() + 28, area.width(), 18);
        drawLineIcon(*painter, QRect(area.left() + 12, upper.top(), 20, upper.height()),
                     index.data(StartModel::iconRole).toString(), text);
        constexpr int left = 44;
        constexpr int rightWidth = 96;
        painter->setFont(themeFont(TextSize::base));
        painter->setPen(text);
        draw(*painter, upper.adjusted(left, 0, -rightWidth, 0), Qt::AlignLeft, index.data().toString());
        painter->setFont(themeFont(TextSize::small));
        painter->setPen(secondary);
        draw(*painter, upper.adjusted(left, 0, -12, 0), Qt::AlignRight,
             index.data(StartModel::rightRole).toString());
        int marks = area.right() - 12; // limits and accordance, side by side
        for (const auto &[iconRole, colourRole] :
             {std::pair(StartModel::accordanceRole, StartModel::accordanceColourRole),
              std::pair(StartModel::markRole, StartModel::markColourRole)}) {
            const QString mark = index.data(iconRole).toString();
            if (mark.isEmpty())
                continue;
            marks -= 20;
            drawLineIcon(*painter, QRect(marks + 4, lower.top(), 16, lower.height()), mark,
                         token(static_cast<Token>(index.data(colourRole).toInt()), option.palette));
        }
        draw(*painter, QRect(QPoint(area.left() + left, lower.top()), QPoint(marks - 4, lower.bottom())),
             Qt::AlignLeft, index.data(StartModel::detailRole).toString());
        painter->restore();
    }

private:
    /// One line: name and year.
    static void paintLine(QPainter &painter, const QStyleOptionViewItem &option, const QModelIndex &index) {
        const QRect area = option.rect;
        const QColor text = option.palette.color(QPalette::WindowText);
        drawLineIcon(painter, QRect(area.left() + 12, area.top(), 16, area.height()),
                     index.data(StartModel::iconRole).toString(), text);
        painter.setFont(themeFont(TextSize::small));
        painter.setPen(token(Token::secondaryText, option.palette));
        const QString year = index.data(StartModel::rightRole).toString();
        const int yearWidth = painter.fontMetrics().horizontalAdvance(year) + 8;
        draw(painter, area.adjusted(0, 0, -12, 0), Qt::AlignRight, year);
        painter.setFont(themeFont(TextSize::base));
        painter.setPen(text);
        draw(painter, area.adjusted(36, 0, -12 - yearWidth, 0), Qt::AlignLeft, index.data().toString());
    }

    static void draw(QPainter &painter, const QRect &area, Qt::Alignment alignment, const QString &text) {
        painter.drawText(area, static_cast<int>(alignment | Qt::AlignVCenter),
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, area.width()));
    }

    const StartList &m_list;
};

constexpr int leastColumn = 270; ///< of a list in columns

} // namespace

void StartModel::setEntries(std::vector<StartEntry> entries) {
    beginResetModel();
    m_entries = std::move(entries);
    endResetModel();
}

int StartModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

QVariant StartModel::data(const QModelIndex &index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const StartEntry &entry = m_entries[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return entry.name;
    case Qt::ToolTipRole: {
        QStringList lines{isExample(entry.path) ? exampleDetail(entry.path) : entry.path, entry.mark.word,
                          entry.accordance.word};
        lines.removeAll(QString());
        return lines.join(u'\n');
    }
    case Qt::AccessibleTextRole: {
        QStringList parts{entry.name, isExample(entry.path) ? exampleDetail(entry.path) : entry.detail,
                          entry.right, entry.mark.word, entry.accordance.word};
        parts.removeAll(QString());
        return parts.join(QStringLiteral(", "));
    }
    case detailRole:
        return entry.detail;
    case rightRole:
        return entry.right;
    case iconRole:
        return entry.icon;
    case markRole:
        return entry.mark.icon;
    case markColourRole:
        return static_cast<int>(entry.mark.colour);
    case accordanceRole:
        return entry.accordance.icon;
    case accordanceColourRole:
        return static_cast<int>(entry.accordance.colour);
    case pathRole:
        return entry.path;
    default:
        return {};
    }
}

StartList::StartList(StartModel &model, int mostRows, QWidget *parent)
    : QListView(parent)
    , m_mostRows(mostRows) {
    setModel(&model);
    setItemDelegate(new StartDelegate(this));
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    viewport()->setAutoFillBackground(false);
    connect(this, &QListView::clicked, this,
            [this](const QModelIndex &index) { emit chosen(index.data(StartModel::pathRole).toString()); });
    connect(&model, &QAbstractItemModel::modelReset, this, [this] { updateGeometry(); });
}

StartList::StartList(StartModel &model, QWidget *parent)
    : StartList(model, 0, parent) {
    setFlow(QListView::TopToBottom);
    setWrapping(true);
    setResizeMode(QListView::Adjust);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

int StartList::columns() const {
    return std::max(1, std::min(width() / leastColumn, model()->rowCount()));
}

QSize StartList::compactSize() const {
    return {width() / columns(), lineHeight};
}

QSize StartList::sizeHint() const {
    if (!isCompact())
        return {200, rowHeight * std::min(model()->rowCount(), m_mostRows)};
    const int lines = (model()->rowCount() + columns() - 1) / columns();
    return {leastColumn, lineHeight * lines + 2}; // Qt wraps a row that fills the last pixel
}

QSize StartList::minimumSizeHint() const {
    return isCompact() ? sizeHint() : QSize(200, rowHeight);
}

void StartList::resizeEvent(QResizeEvent *event) {
    QListView::resizeEvent(event);
    if (isCompact() && event->oldSize().width() != event->size().width()) {
        scheduleDelayedItemsLayout();
        updateGeometry();
    }
}

/// Looks the same in active and inactive windows: avoids painting twice at the start.
bool StartList::viewportEvent(QEvent *event) {
    if (event->type() == QEvent::WindowActivate || event->type() == QEvent::WindowDeactivate)
        return true;
    return QListView::viewportEvent(event);
}

void StartList::keyPressEvent(QKeyEvent *event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && currentIndex().isValid()) {
        emit chosen(currentIndex().data(StartModel::pathRole).toString());
        return;
    }
    QListView::keyPressEvent(event);
}

} // namespace palmer::ui
