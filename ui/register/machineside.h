// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/madewidgets.h"
#include "ui/register/firstuse.h"
#include "ui/register/machinelist.h"

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QToolButton>

namespace palmer::ui {

/// The left side of the register: the list of machines with its search and filters.
class MachineSide : public QWidget {
    Q_OBJECT

public:
    MachineSide();

    /// The chosen machine stays chosen if it is still listed, otherwise the first is. Emits no signal.
    void setMachines(std::vector<MachineRow> machines);
    [[nodiscard]] const MachineModel &machines() const { return *m_machines; }
    /// The chosen machine, always a listed one; null if the list is empty.
    [[nodiscard]] const MachineRow *chosen() const;

    void startSearch();
    void endSearch() { m_search->clear(); } ///< all machines again
    void moveBy(int rows);                  ///< to another machine of the list
    /// Texts and widgets for the current list; `isScanning`: machines may follow.
    void showState(bool isScanning);
    void retranslate();

signals:
    void machineChosen(); ///< another one, or none
    void testsWanted();   ///< those of the chosen one, by Enter

private:
    QLayout *makeHead();
    void makeList();
    void filter();
    void choose(int row);
    void sayIfNone(bool isScanning);
    [[nodiscard]] int rowOf(const QString &identity) const; ///< −1 if not listed

    MachineModel *m_machines = new MachineModel(this);
    QLabel *m_title = made<QLabel>("machinesTitle", TextSize::head);
    QLineEdit *m_search = made<QLineEdit>("machineSearch");
    QToolButton *m_all = made<QToolButton>("allMachines", trait::checkable);
    QToolButton *m_toDo = made<QToolButton>("machinesToDo", trait::checkable);
    QLabel *m_noMachine = made<QLabel>("noMachine", TextSize::base, trait::wrapped);
    QListView *m_list = made<QListView>("machines");
    GhostRows *m_ghosts = made<GhostRows>("ghostRows");
    QString m_chosen; ///< identity; empty: none
    QString m_before; ///< chosen before the list became empty
};

} // namespace palmer::ui
