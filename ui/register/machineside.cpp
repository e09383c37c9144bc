// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/machineside.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"

#include <QButtonGroup>
#include <QShortcut>
#include <QSignalBlocker>
#include <algorithm>

namespace palmer::ui {

MachineSide::MachineSide() {
    setMinimumWidth(200);
    makeList();
    inColumn(this, noMargins, 0, {makeHead(), {m_list, 1}, {m_ghosts, 1}});
    connect(m_search, &QLineEdit::textChanged, this, &MachineSide::filter);
}

QLayout *MachineSide::makeHead() {
    m_search->setClearButtonEnabled(true);
    m_search->setEnabled(false); // until there is a machine
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Return, Qt::Key_Enter})
        new QShortcut(
            key, m_search, m_list, [this] { m_list->setFocus(Qt::ShortcutFocusReason); }, Qt::WidgetShortcut);
    m_search->addAction(lineIcon(QStringLiteral("search"), QPalette::PlaceholderText),
                        QLineEdit::LeadingPosition);
    auto *choice = new QButtonGroup(this);
    auto *switches = inRow(0, {});
    for (QToolButton *button : {m_all, m_toDo}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        choice->addButton(button);
        switches->addWidget(button);
    }
    m_all->setChecked(true);
    connect(choice, &QButtonGroup::buttonClicked, this, &MachineSide::filter);
    return inColumn(nullptr, {pageMargin, 10, pageMargin, 8}, 8, {m_title, m_search, switches, m_noMachine});
}

void MachineSide::makeList() {
    m_list->setModel(m_machines);
    m_list->setItemDelegate(new MachineDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_list->setMinimumHeight(0);
    m_list->setMouseTracking(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
        new QShortcut(key, m_list, this, &MachineSide::testsWanted, Qt::WidgetShortcut);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &index) {
                if (index.isValid())
                    choose(index.row());
            });
}

void MachineSide::retranslate() {
    m_search->setPlaceholderText(tr("Machine, serial number, type"));
    m_search->setAccessibleName(tr("Search machines"));
    m_list->setAccessibleName(tr("Machines"));
}

void MachineSide::showState(bool isScanning) {
    const bool any = m_machines->machineCount() > 0;
    const int listed = m_machines->machineCount();
    m_title->setText(tr("Machines") + (listed == 0 ? QString() : QStringLiteral("  %1").arg(listed)));
    m_all->setText(tr("All"));
    m_toDo->setText(tr("To do %1").arg(m_machines->toDoCount()));
    sayIfNone(isScanning);
    const bool isFirst = any && !m_search->isEnabled();
    m_search->setEnabled(any);
    if (isFirst)
        m_search->setFocus();
    m_ghosts->setVisible(!any);
    m_list->setVisible(any);
    m_all->setVisible(any);
    m_toDo->setVisible(any);
}

void MachineSide::sayIfNone(bool isScanning) {
    m_noMachine->setText(m_machines->machineCount() > 0 ? tr("No machine found")
                         : isScanning                   ? tr("The folders are being read…")
                                                        : tr("No machine yet"));
    m_noMachine->setVisible(m_machines->rowCount() == 0);
}

int MachineSide::rowOf(const QString &identity) const {
    int row = m_machines->rowCount() - 1;
    while (row >= 0 && m_machines->row(row).machine.identity != identity)
        --row;
    return row;
}

const MachineRow *MachineSide::chosen() const {
    const int row = rowOf(m_chosen);
    return row < 0 ? nullptr : &m_machines->row(row);
}

void MachineSide::setMachines(std::vector<MachineRow> machines) {
    const QSignalBlocker blocker(m_list->selectionModel());
    m_machines->setRows(std::move(machines));
    if (m_machines->rowCount() == 0) {
        m_chosen.clear();
    } else {
        const int row = std::max(rowOf(m_chosen), 0);
        m_chosen = m_machines->row(row).machine.identity;
        m_list->selectionModel()->setCurrentIndex(m_machines->index(row),
                                                  QItemSelectionModel::ClearAndSelect);
    }
    m_list->viewport()->update();
}

void MachineSide::filter() {
    m_machines->setFilter(m_search->text(),
                          m_toDo->isChecked() ? MachineModel::Show::toDo : MachineModel::Show::all);
    sayIfNone(false);
    const int row = rowOf(m_chosen.isEmpty() ? m_before : m_chosen);
    if (m_machines->rowCount() > 0) // the machine shown on the right must be in the list
        m_list->setCurrentIndex(m_machines->index(std::max(row, 0)));
    else
        choose(-1);
}

/// −1: none. It is chosen again once it is back in the list.
void MachineSide::choose(int row) {
    const QString identity = row < 0 ? QString() : m_machines->row(row).machine.identity;
    if (identity == m_chosen)
        return;
    if (row < 0)
        m_before = m_chosen;
    m_chosen = identity;
    emit machineChosen();
}

void MachineSide::moveBy(int rows) {
    const int row = m_list->currentIndex().row() + rows;
    if (row >= 0 && row < m_machines->rowCount())
        m_list->setCurrentIndex(m_machines->index(row));
}

void MachineSide::startSearch() {
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

} // namespace palmer::ui
