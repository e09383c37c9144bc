// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/startlist.h"

#include "ui/elidedlabel.h"
#include "ui/welcome/examples.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

const StartEntry &startEntry(const QModelIndex &index) {
    return static_cast<const StartModel *>(index.model())->row(index.row());
}

class StartDelegate : public RowDelegate {
public:
    explicit StartDelegate(StartList *list)
        : RowDelegate(list, focusFrame)
        , m_list(*list) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override {
        return m_list.isCompact() ? m_list.compactSize() : QSize(200, StartList::rowHeight);
    }

    /// A click opens a file: none stays selected.
    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &) const override {
        return option.state & QStyle::State_MouseOver ? token(Token::hover, option.palette) : QColor();
    }

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        const StartEntry &entry = startEntry(index);
        const QRect area = option.rect;
        const QColor text = option.palette.color(QPalette::WindowText);
        const QColor secondary = token(Token::secondaryText, option.palette);
        const QFont small = themeFont(TextSize::small);
        if (m_list.isCompact()) { // one line: name and year
            drawLineIcon(painter, QRect(area.left() + 12, area.top(), 16, area.height()), entry.icon, text);
            drawElided(painter, area.adjusted(0, 0, -12, 0), Qt::AlignRight, entry.right, small, secondary);
            const int year = painter.fontMetrics().horizontalAdvance(entry.right) + 8;
            drawElided(painter, area.adjusted(36, 0, -12 - year, 0), Qt::AlignLeft, entry.name,
                       themeFont(TextSize::base), text);
            return;
        }
        if (index.row() > 0) {
            painter.setPen(token(Token::line, option.palette));
            painter.drawLine(area.left() + 44, area.top(), area.right() - 12, area.top());
        }
        const QRect upper(area.left(), area.top() + 8, area.width(), 18);
        const QRect lower(area.left(), area.top() + 28, area.width(), 18);
        drawLineIcon(painter, QRect(area.left() + 12, upper.top(), 20, upper.height()), entry.icon, text);
        constexpr int left = 44;
        constexpr int dateWidth = 96;
        drawElided(painter, upper.adjusted(left, 0, -dateWidth, 0), Qt::AlignLeft, entry.name,
                   themeFont(TextSize::base), text);
        drawElided(painter, upper.adjusted(left, 0, -12, 0), Qt::AlignRight, entry.right, small, secondary);
        int marks = area.right() - 12; // limits and accordance, side by side
        for (const VerdictMark &mark : {entry.accordance, entry.mark}) {
            if (mark.icon.isEmpty())
                continue;
            marks -= 20;
            drawLineIcon(painter, QRect(marks + 4, lower.top(), 16, lower.height()), mark.icon,
                         token(mark.colour, option.palette));
        }
        drawElided(painter, QRect(QPoint(area.left() + left, lower.top()), QPoint(marks - 4, lower.bottom())),
                   Qt::AlignLeft, entry.detail, small, secondary);
    }

private:
    const StartList &m_list;
};

constexpr int leastColumn = 235; ///< of a list in columns

} // namespace

QVariant StartModel::cell(const StartEntry &entry, int, int role) const {
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
    connect(this, &QListView::clicked, this, &StartList::choose);
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

void StartList::choose(const QModelIndex &index) {
    emit chosen(startEntry(index).path);
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
        choose(currentIndex());
        return;
    }
    QListView::keyPressEvent(event);
}

} // namespace palmer::ui
