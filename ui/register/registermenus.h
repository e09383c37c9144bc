// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QCoreApplication>

namespace palmer::ui {

/// The menus of the register window with their shortcuts. The window connects the actions.
struct RegisterMenus {
    Q_DECLARE_TR_FUNCTIONS(palmer::ui::RegisterMenus)

public:
    explicit RegisterMenus(QMainWindow &window);

    /// Adds the most frequent actions in groups.
    void fill(QToolBar &bar) const;
    void retranslate() const;

    QMenu *registerMenu = nullptr;
    QMenu *machineMenu = nullptr;
    QMenu *testMenu = nullptr;
    QMenu *viewMenu = nullptr;
    QMenu *helpMenu = nullptr;
    QMenu *intervals = nullptr;
    QMenu *under = nullptr; ///< editions for evaluating all tests
    QMenu *sorting = nullptr;

    QAction *folders = nullptr;
    QAction *rescan = nullptr;
    QAction *troubled = nullptr; ///< files that cannot be read or found
    QAction *close = nullptr;
    QAction *find = nullptr;
    QAction *previous = nullptr;
    QAction *next = nullptr;
    QAction *join = nullptr;
    QAction *separate = nullptr; ///< from a machine that was joined
    QAction *history = nullptr;
    QAction *type = nullptr; ///< the machines of one type
    QAction *open = nullptr;
    QAction *compare = nullptr;
    QAction *clear = nullptr;
    QAction *trendAlone = nullptr;
    QAction *french = nullptr;
    QAction *english = nullptr;
    QAction *help = nullptr;
    QAction *shortcuts = nullptr;
    QAction *about = nullptr;
};

} // namespace palmer::ui
