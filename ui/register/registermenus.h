// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace palmer::ui {

/// The menus of the window of the register: what stands in them, with its keys. The window connects them.
struct RegisterMenus {
    Q_DECLARE_TR_FUNCTIONS(palmer::ui::RegisterMenus)

public:
    explicit RegisterMenus(QMainWindow &window);

    /// The actions one needs most, in groups.
    void fill(QToolBar &bar) const;
    void retranslate() const;

    QMenu *registerMenu = nullptr;
    QMenu *machineMenu = nullptr;
    QMenu *testMenu = nullptr;
    QMenu *viewMenu = nullptr;
    QMenu *helpMenu = nullptr;
    QMenu *intervals = nullptr;
    QMenu *under = nullptr; ///< editions to evaluate all tests under

    QAction *folders = nullptr;
    QAction *rescan = nullptr;
    QAction *troubled = nullptr; ///< files that cannot be read or are not found
    QAction *close = nullptr;
    QAction *find = nullptr;
    QAction *previous = nullptr;
    QAction *next = nullptr;
    QAction *history = nullptr;
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
