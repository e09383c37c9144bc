// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/searchbox.h"

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/quiettable.h"
#include "ui/theme.h"

#include <QAction>
#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <array>

namespace palmer::ui {

namespace {

constexpr int boxWidth = 236;
constexpr int panelWidth = 560;
constexpr int searchRowHeight = 26;
constexpr int mostOfGroup = 7;
constexpr int mostRows = 16;
constexpr int placeWidth = 110;
constexpr int valueWidth = 130;

} // namespace

/// A head of a group, with the number of its answers, or an answer.
struct SearchRow {
    SearchHit hit;
    bool isHead = false;
};

class SearchModel : public RowModel<SearchRow> {
public:
    using RowModel::RowModel;

    void show(const std::vector<SearchHit> &hits, const std::array<QString, 4> &heads) {
        std::vector<SearchRow> rows;
        for (auto at = hits.begin(); at != hits.end();) {
            const SearchGroup group = at->entry.group;
            const auto next =
                std::find_if(at, hits.end(), [&](const SearchHit &hit) { return hit.entry.group != group; });
            const auto count = next - at;
            SearchRow head;
            head.isHead = true;
            head.hit.entry.name = heads.at(static_cast<std::size_t>(group));
            head.hit.entry.place = SearchBox::tr("%n answer(s)", nullptr, static_cast<int>(count));
            rows.push_back(std::move(head));
            for (auto each = at; each != next && each - at < mostOfGroup; ++each)
                rows.push_back({*each, false});
            at = next;
        }
        reset(std::move(rows));
    }

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override {
        return index.isValid() && row(index.row()).isHead ? Qt::ItemFlags(Qt::NoItemFlags)
                                                          : RowModel::flags(index);
    }

protected:
    [[nodiscard]] QVariant cell(const SearchRow &row, int, int role) const override {
        const SearchEntry &entry = row.hit.entry;
        if (role == Qt::DisplayRole)
            return entry.name;
        if (role == Qt::AccessibleTextRole)
            return QStringList{entry.name, entry.value, entry.place}.join(QStringLiteral(", "));
        return {};
    }
};

namespace {

/// Name with the match in bold, value, place.
class SearchDelegate : public RowDelegate {
public:
    using RowDelegate::RowDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override {
        return {100, searchRowHeight};
    }

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        const SearchRow &row = static_cast<const SearchModel *>(index.model())->row(index.row());
        const SearchEntry &entry = row.hit.entry;
        const QColor secondary = token(Token::secondaryText, option.palette);
        const QRect area = option.rect.adjusted(pageMargin, 0, -pageMargin, 0);
        if (row.isHead) {
            drawElided(painter, area, Qt::AlignRight, entry.place, themeFont(TextSize::tiny), secondary);
            drawElided(painter, area, Qt::AlignLeft, entry.name.toUpper(), themeFont(TextSize::tiny),
                       secondary);
            return;
        }
        const QFont base = themeFont(TextSize::base);
        const QFont small = themeFont(TextSize::small);
        drawElided(painter, area, Qt::AlignRight, entry.place, small, secondary);
        const QColor stated =
            entry.isMissing ? token(Token::unsure, option.palette) : option.palette.color(QPalette::Text);
        drawElided(painter, area.adjusted(area.width() - placeWidth - valueWidth, 0, -placeWidth, 0),
                   Qt::AlignRight, entry.value, small, stated);
        QRect name = area.adjusted(0, 0, -placeWidth - valueWidth - 8, 0);
        QFont bold = base;
        bold.setWeight(QFont::DemiBold);
        const auto draw = [&](const QString &text, const QFont &font, const QColor &colour) {
            drawElided(painter, name, Qt::AlignLeft, text, font, colour);
            name.setLeft(std::min(name.left() + QFontMetrics(font).horizontalAdvance(text), name.right()));
        };
        const qsizetype begin = std::max<qsizetype>(row.hit.begin, 0);
        const QColor text = option.palette.color(QPalette::Text);
        draw(entry.name.first(begin), base, text);
        draw(entry.name.mid(begin, row.hit.length), bold, token(Token::accent, option.palette));
        draw(entry.name.mid(begin + row.hit.length), base, text);
    }
};

} // namespace

SearchBox::SearchBox(QWidget *parent)
    : Translated(parent)
    , m_model(new SearchModel(this)) {
    setObjectName(QStringLiteral("searchBox"));
    setMaximumWidth(boxWidth);
    setMinimumWidth(boxWidth / 3);
    setFixedHeight(fieldHeight);
    m_icon = addAction(lineIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(this, &QLineEdit::textEdited, this, &SearchBox::find);
    retranslate();
}

void SearchBox::find() {
    const std::vector<SearchHit> hits = search(m_entries, text());
    if (!m_panel) {
        m_panel = made<QFrame>("searchPanel", window());
        m_panel->setFrameShape(QFrame::StyledPanel);
        m_panel->setAutoFillBackground(true);
        m_panel->setBackgroundRole(QPalette::Base);
        m_list = made<QListView>("searchList", m_panel);
        m_list->setModel(m_model);
        m_list->setItemDelegate(new SearchDelegate(m_list));
        m_list->setFrameShape(QFrame::NoFrame);
        m_list->setUniformItemSizes(true);
        m_list->setFocusPolicy(Qt::NoFocus);
        m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        m_keys = made<QLabel>("searchKeys", trait::secondary, m_panel);
        m_keys->setContentsMargins(pageMargin, 0, 0, 0);
        inColumn(m_panel, {1, 4, 1, 4}, 4, {m_list, m_keys});
        connect(m_list, &QListView::clicked, this, [this] { go(true); });
        retranslate();
    }
    m_model->show(hits, {tr("Fields"), tr("Results"), tr("Findings"), tr("Settings and commands")});
    const bool any = !text().trimmed().isEmpty();
    m_panel->setVisible(any);
    emit said(any ? tr("search: %n answer(s)", nullptr, static_cast<int>(hits.size())) : QString());
    if (!any)
        return;
    const QWidget *frame = window();
    const int rows = std::clamp(m_model->rowCount(), 1, mostRows);
    const QPoint below = mapTo(frame, QPoint(width(), height() + 2));
    const int wide = std::min(panelWidth, frame->width() - 16);
    const int high =
        std::min(rows * searchRowHeight + m_keys->sizeHint().height() + 16, frame->height() - below.y() - 8);
    m_panel->setGeometry(std::max(8, below.x() - wide), below.y(), wide, high);
    m_panel->raise();
    step(1);
}

/// To the next or previous answer, over the heads.
void SearchBox::step(int by) {
    if (!m_list)
        return;
    int row = m_list->currentIndex().isValid() ? m_list->currentIndex().row()
              : by > 0                         ? -1
                                               : m_model->rowCount();
    do
        row += by;
    while (row >= 0 && row < m_model->rowCount() && m_model->row(row).isHead);
    if (row >= 0 && row < m_model->rowCount())
        m_list->setCurrentIndex(m_model->index(row));
}

void SearchBox::go(bool closes) {
    const QModelIndex current = m_list && m_panel->isVisible() ? m_list->currentIndex() : QModelIndex();
    if (!current.isValid())
        return;
    const std::function<void()> go = m_model->row(current.row()).hit.entry.go;
    if (closes)
        end();
    if (go)
        go();
    if (!closes)
        setFocus();
}

void SearchBox::end() {
    clear();
    if (m_panel)
        m_panel->hide();
    emit said({});
}

bool SearchBox::event(QEvent *event) {
    // Keys of the window that mean something here.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
            event->accept();
            return true;
        }
    }
    return Translated::event(event);
}

void SearchBox::keyPressEvent(QKeyEvent *event) {
    switch (event->key()) {
    case Qt::Key_Down:
        return step(1);
    case Qt::Key_Up:
        return step(-1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return go(!(event->modifiers() & Qt::ControlModifier));
    case Qt::Key_Escape:
        return end();
    default:
        Translated::keyPressEvent(event);
    }
}

void SearchBox::focusInEvent(QFocusEvent *event) {
    if (m_source && text().isEmpty())
        m_entries = m_source();
    Translated::focusInEvent(event);
}

void SearchBox::focusOutEvent(QFocusEvent *event) {
    if (m_panel && event->reason() != Qt::ActiveWindowFocusReason && event->reason() != Qt::PopupFocusReason)
        m_panel->hide();
    Translated::focusOutEvent(event);
}

void SearchBox::retranslate() {
    setPlaceholderText(tr("Search (Ctrl+F)"));
    setAccessibleName(tr("Search fields, results, findings and settings"));
    setToolTip(accessibleName());
    m_icon->setText(accessibleName());
    if (!m_keys)
        return;
    m_keys->setFont(themeFont(TextSize::tiny));
    m_keys->setText(tr("↑↓ choose · Enter go there · Ctrl+Enter without closing · Esc close"));
    m_list->setAccessibleName(accessibleName());
}

} // namespace palmer::ui
