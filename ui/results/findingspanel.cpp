// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/findingspanel.h"

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QToolButton>

namespace palmer::ui {

namespace {

constexpr int usualRows = 3;
constexpr int findingRowHeight = 24;
constexpr int findingMarkWidth = 22;
constexpr int arrowWidth = 18;

struct FindingLook {
    const char *icon = nullptr;
    Token colour = Token::secondaryText;
};

FindingLook lookOf(Grade grade) {
    switch (grade) {
    case Grade::requirement:
        return {"miss", Token::bad};
    case Grade::recommendation:
        return {"warn", Token::unsure};
    case Grade::note:
        break;
    }
    return {"info", Token::secondaryText};
}

/// Draws a finding: mark of its grade, sentence, clause on the right.
class FindingsDelegate : public RowDelegate {
public:
    explicit FindingsDelegate(QObject *parent)
        : RowDelegate(parent, rule) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override {
        return {100, findingRowHeight};
    }

    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override {
        return isCurrentRow(option, index)              ? selectedGround(option.palette)
               : option.state & QStyle::State_MouseOver ? token(Token::hover, option.palette)
                                                        : QColor();
    }

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        const FindingRow &line = static_cast<const FindingsModel *>(index.model())->line(index.row());
        const QRect row = option.rect;
        const FindingLook look = lookOf(line.grade);
        const QColor secondary = token(Token::secondaryText, option.palette);
        drawLineIcon(painter, QRect(row.left(), row.top(), 16, row.height()), QLatin1StringView(look.icon),
                     token(look.colour, option.palette));
        drawLineIcon(painter, QRect(row.right() - 15, row.top(), 14, row.height()), QStringLiteral("right"),
                     secondary);
        const QFont font = themeFont(TextSize::small);
        const int clause = line.clause.isEmpty() ? 0 : QFontMetrics(font).horizontalAdvance(line.clause) + 6;
        drawElided(painter, row.adjusted(0, 0, -arrowWidth, 0), Qt::AlignRight, line.clause, font, secondary);
        drawElided(painter, row.adjusted(findingMarkWidth, 0, -arrowWidth - clause, 0), Qt::AlignLeft,
                   line.text, font, option.palette.color(QPalette::Text));
    }
};

} // namespace

FindingsPanel::FindingsPanel(Selection &, QWidget *parent)
    : Translated(parent)
    , m_title(new QLabel(this))
    , m_summary(made<ElidedLabel>("findingsSummary", trait::secondary, this))
    , m_fold(made<QToolButton>("foldFindings", trait::iconOnly, trait::strongFocus, this))
    , m_list(made<QListView>("findings", this)) {
    setObjectName(QStringLiteral("findingsPanel"));
    m_summary->setSeparator(QStringLiteral(" · "));
    connect(m_fold, &QToolButton::clicked, this, [this] { setFolded(!m_folded); });

    m_list->setModel(&m_model);
    m_list->setItemDelegate(new FindingsDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_list->setMouseTracking(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setRows(usualRows);
    connect(m_list, &QAbstractItemView::clicked, this, &FindingsPanel::activate);
    connect(m_list, &QAbstractItemView::activated, this, [this](const QModelIndex &index) {
        // A click was already reported.
        if (m_list->hasFocus() && !(QGuiApplication::mouseButtons() & Qt::LeftButton))
            activate(index);
    });

    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_go = new QAction(m_list);
    m_copy = new QAction(m_list);
    m_list->addActions({m_go, m_copy});
    connect(m_go, &QAction::triggered, this, [this] { activate(m_list->currentIndex()); });
    connect(m_copy, &QAction::triggered, this, [this] {
        if (const QModelIndex current = m_list->currentIndex(); current.isValid()) {
            const FindingRow &line = m_model.line(current.row());
            QGuiApplication::clipboard()->setText((line.text + u' ' + line.clause).trimmed());
        }
    });

    auto *head = inRow(8, {m_title, {m_summary, 1}, m_fold});
    inColumn(this, {pageMargin, 2, 4, 4}, 2, {head, m_list});
    retranslate();
}

void FindingsPanel::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void FindingsPanel::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

void FindingsPanel::setPage(Page page) {
    m_page = page;
    refresh();
}

void FindingsPanel::setFolded(bool folded) {
    if (m_folded == folded)
        return;
    m_folded = folded;
    retranslate();
    emit foldedChanged(folded);
}

void FindingsPanel::setRows(int rows) {
    m_list->setFixedHeight(rows * findingRowHeight);
}

void FindingsPanel::activate(const QModelIndex &index) {
    if (!index.isValid())
        return;
    const FindingRow line = m_model.line(index.row());
    emit activated(line.page, line.id);
}

void FindingsPanel::refresh() {
    m_model.show(m_evaluated, m_test, m_page, m_language);
    m_summary->setText(m_model.summary());
}

void FindingsPanel::retranslate() {
    m_title->setText(tr("Findings"));
    m_title->setFont(themeFont(TextSize::head));
    m_summary->setFont(themeFont(TextSize::small));
    m_list->setVisible(!m_folded);
    m_fold->setIcon(lineIcon(m_folded ? QStringLiteral("left") : QStringLiteral("down")));
    const QString what = m_folded ? tr("Show the findings") : tr("Fold the findings away");
    nameWidget(*m_fold, what);
    m_list->setAccessibleName(tr("Findings"));
    m_go->setText(tr("&Go to the statement"));
    m_copy->setText(tr("&Copy the text"));
    refresh();
}

} // namespace palmer::ui
