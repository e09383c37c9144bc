// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chip.h"
#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/register/machinelist.h"

#include <QComboBox>

class QMenu;

namespace palmer::ui {

/// The head above the tests of a machine: its name and facts, the interval of its tests and when one is due.
class MachineHead : public QWidget {
    Q_OBJECT

public:
    MachineHead();

    void setMachine(const MachineRow *machine); ///< null: none
    /// Offers the intervals in a menu.
    void fillIntervals(QMenu &menu);
    void retranslate();

signals:
    void intervalChosen(int months); ///< 0: none

private:
    QLabel *m_name = made<ElidedLabel>("machineName", TextSize::title); ///< names may be long
    QLabel *m_facts = made<ElidedLabel>("machineFacts", TextSize::small, trait::secondary);
    QLabel *m_intervalLabel = made<QLabel>("intervalLabel", TextSize::small);
    QComboBox *m_interval = made<QComboBox>("interval");
    Chip *m_due = made<Chip>("due");
};

} // namespace palmer::ui
