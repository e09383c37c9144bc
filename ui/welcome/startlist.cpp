#include "ui/welcome/startlist.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

namespace palmer::ui {

namespace {

class StartDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override {
        return {200, StartList::rowHeight};
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
        const int left = 44, rightWidth = 96;
        painter->setFont(themeFont(TextSize::base));
        painter->setPen(text);
        draw(*painter, upper.adjusted(left, 0, -rightWidth, 0), Qt::AlignLeft, index.data().toString());
        painter->setFont(themeFont(TextSize::small));
        painter->setPen(secondary);
        draw(*painter, upper.adjusted(left, 0, -12, 0), Qt::AlignRight,
             index.data(StartModel::rightRole).toString());
        draw(*painter, lower.adjusted(left, 0, -40, 0), Qt::AlignLeft,
             index.data(StartModel::detailRole).toString());
        const QString mark = index.data(StartModel::markRole).toString();
        if (!mark.isEmpty()) {
            drawLineIcon(
                *painter, QRect(area.right() - 28, lower.top(), 16, lower.height()), mark,
                token(static_cast<Token>(index.data(StartModel::markColourRole).toInt()), option.palette));
        }
        painter->restore();
    }

private:
    static void draw(QPainter &painter, const QRect &area, Qt::Alignment alignment, const QString &text) {
        painter.drawText(area, static_cast<int>(alignment | Qt::AlignVCenter),
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, area.width()));
    }
};

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
    case Qt::ToolTipRole:
        return entry.path.startsWith(u':') ? QString() : entry.path;
    case Qt::AccessibleTextRole: {
        QStringList parts{entry.name, entry.detail, entry.right, entry.mark.word};
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

QSize StartList::sizeHint() const {
    return {200, rowHeight * std::min(model()->rowCount(), m_mostRows)};
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
