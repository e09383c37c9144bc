// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QDialog>

namespace palmer::ui {

/// All shortcuts of a window: those read from its menus, and the keys of the readings table if it has one.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutsDialog(const QMenuBar &menus, QWidget *parent = nullptr, bool hasReadings = true);

private:
    void addMenus(const QMenuBar &menus);
    void addTable();

    QTreeWidget *m_list;
};

} // namespace palmer::ui
