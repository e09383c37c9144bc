// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/columnroles.h"

#include "ui/measures.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QStandardItemModel>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr int roleWidth = 104;
constexpr int widestRole = 208;
constexpr int mostFitted = 200; ///< columns whose widths fit their texts

constexpr std::array roles{ColumnRole::target,  ColumnRole::run,       ColumnRole::deviation,
                           ColumnRole::actual,  ColumnRole::direction, ColumnRole::number,
                           ColumnRole::angle,   ColumnRole::radius,    ColumnRole::x,
                           ColumnRole::y,       ColumnRole::time,      ColumnRole::temperature,
                           ColumnRole::nominal, ColumnRole::statistic, ColumnRole::ignored};

QString nameOf(ColumnRole role) {
    switch (role) {
    case ColumnRole::ignored:
        return ColumnRoles::tr("not read");
    case ColumnRole::target:
        return ColumnRoles::tr("target");
    case ColumnRole::actual:
        return ColumnRoles::tr("position");
    case ColumnRole::deviation:
        return ColumnRoles::tr("deviation");
    case ColumnRole::run:
        return ColumnRoles::tr("run");
    case ColumnRole::direction:
        return ColumnRoles::tr("direction");
    case ColumnRole::number:
        return ColumnRoles::tr("run number");
    case ColumnRole::angle:
        return ColumnRoles::tr("angle");
    case ColumnRole::radius:
        return ColumnRoles::tr("radius");
    case ColumnRole::x:
        return ColumnRoles::tr("x coordinate");
    case ColumnRole::y:
        return ColumnRoles::tr("y coordinate");
    case ColumnRole::time:
        return ColumnRoles::tr("time");
    case ColumnRole::temperature:
        return ColumnRoles::tr("temperature");
    case ColumnRole::nominal:
        return ColumnRoles::tr("nominal value");
    case ColumnRole::statistic:
        return ColumnRoles::tr("statistic");
    }
    return {};
}

/// True for columns of a circle: their directions are senses.
bool areOfCircle(const std::vector<ImportColumn> &columns) {
    return std::ranges::any_of(columns, [](const ImportColumn &column) {
        return column.role == ColumnRole::angle || column.role == ColumnRole::x;
    });
}

/// "run 2 ↑", "radius ↺"
QString nameOf(const ImportColumn &column, bool isOfCircle) {
    QString name = nameOf(column.role);
    if (column.number > 0)
        name += QStringLiteral(" %1").arg(column.number);
    const bool isPositive = column.direction == Direction::positive;
    if (column.direction && isOfCircle)
        name += isPositive ? QStringLiteral(" ↺") : QStringLiteral(" ↻");
    else if (column.direction)
        name += isPositive ? QStringLiteral(" ↑") : QStringLiteral(" ↓");
    return name;
}

} // namespace

ColumnRoles::ColumnRoles(QWidget *parent)
    : QTableView(parent)
    , m_model(new QStandardItemModel(this)) {
    setModel(m_model);
    setObjectName(QStringLiteral("importColumns"));
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(NoEditTriggers);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setCornerButtonEnabled(false);
    setHorizontalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fieldHeight);
    horizontalHeader()->setDefaultSectionSize(roleWidth);
    horizontalHeader()->setMinimumSectionSize(roleWidth);
    horizontalHeader()->setMaximumSectionSize(widestRole);
    horizontalHeader()->setSectionsClickable(true);
    horizontalHeader()->setTextElideMode(Qt::ElideRight);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QTableView::clicked, this, [this](const QModelIndex &at) { openMenu(at.column()); });
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &ColumnRoles::openMenu);
}

void ColumnRoles::showColumns(const std::vector<ImportColumn> &columns) {
    const int current = currentIndex().column();
    m_columns = columns;
    const int count = static_cast<int>(columns.size());
    m_model->clear();
    m_model->setRowCount(count > 0 ? 1 : 0);
    m_model->setColumnCount(count);
    for (int c = 0; c < count; ++c) {
        const ImportColumn &column = columns[static_cast<std::size_t>(c)];
        const QString heading =
            column.heading.empty() ? tr("column %1").arg(c + 1) : QString::fromStdString(column.heading);
        auto *head = new QStandardItem(heading);
        head->setToolTip(heading);
        m_model->setHorizontalHeaderItem(c, head);
        auto *item = new QStandardItem(nameOf(column, areOfCircle(columns)) + QStringLiteral(" ▾"));
        item->setToolTip(tr("What the column “%1” is; click to change it").arg(heading));
        item->setData(QStringLiteral("%1: %2").arg(heading, nameOf(column, areOfCircle(columns))),
                      Qt::AccessibleTextRole);
        item->setTextAlignment(Qt::AlignCenter);
        if (column.direction)
            item->setForeground(
                token(*column.direction == Direction::positive ? Token::up : Token::downText, palette()));
        else if (column.role == ColumnRole::ignored || column.role == ColumnRole::statistic)
            item->setForeground(token(Token::secondaryText, palette()));
        m_model->setItem(0, c, item);
    }
    if (count <= mostFitted)
        resizeColumnsToContents();
    if (current >= 0 && current < count)
        setCurrentIndex(m_model->index(0, current));
    constexpr int scrollBar = 12;
    setFixedHeight(horizontalHeader()->sizeHint().height() + fieldHeight + scrollBar);
    setVisible(count > 0);
}

void ColumnRoles::keyPressEvent(QKeyEvent *event) {
    const bool opens =
        event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (opens && currentIndex().isValid())
        openMenu(currentIndex().column());
    else
        QTableView::keyPressEvent(event);
}

void ColumnRoles::openMenu(int column) {
    const auto at = static_cast<std::size_t>(column);
    if (at >= m_columns.size())
        return;
    const ImportColumn &now = m_columns[at];
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("roleMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](ColumnRole role, std::optional<Direction> direction) {
        ImportColumn wanted{role, direction, 0, now.unit, now.heading};
        QAction *action = menu->addAction(nameOf(wanted, areOfCircle(m_columns)));
        action->setCheckable(true);
        action->setChecked(now.role == role && now.direction == direction);
        action->setData(QString::fromStdString(wordOf({wanted})));
        wanted.number = now.role == role ? now.number : 0;
        connect(action, &QAction::triggered, this, [this, column, wanted] { choose(column, wanted); });
    };
    for (const ColumnRole role : roles) {
        add(role, {});
        const ImportColumn any{role};
        if (!any.hasReadings() && !(any.canHaveDirection() && areOfCircle(m_columns)))
            continue;
        add(role, Direction::positive);
        add(role, Direction::negative);
    }
    const QRect cell = visualRect(m_model->index(0, column));
    menu->popup(viewport()->mapToGlobal(cell.bottomLeft()));
}

void ColumnRoles::choose(int column, const ImportColumn &role) {
    std::vector<ImportColumn> columns = m_columns;
    columns[static_cast<std::size_t>(column)] = role;
    emit rolesChosen(QString::fromStdString(wordOf(columns)));
}

} // namespace palmer::ui
