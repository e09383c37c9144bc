// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registermenus.h"

#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace palmer::ui {

namespace {

QAction *added(QMenu &menu, const char *name, const char *icon = nullptr, const QKeySequence &keys = {}) {
    auto *action = new QAction(menu.parentWidget()->window());
    action->setObjectName(QString::fromLatin1(name));
    if (icon)
        action->setIcon(lineIcon(QString::fromLatin1(icon)));
    action->setShortcut(keys);
    menu.addAction(action);
    return action;
}

} // namespace

RegisterMenus::RegisterMenus(QMainWindow &window) {
    QMenuBar &bar = *window.menuBar();
    for (QMenu **menu : {&registerMenu, &machineMenu, &testMenu, &viewMenu, &helpMenu})
        *menu = bar.addMenu(QString());
    folders = added(*registerMenu, "folders", "folder");
    rescan = added(*registerMenu, "rescan", "redo", QKeySequence::Refresh);
    troubled = added(*registerMenu, "troubledFiles", "miss");
    registerMenu->addSeparator();
    close = added(*registerMenu, "closeRegister", nullptr, QKeySequence::Close);
    find = added(*machineMenu, "findMachine", "search", QKeySequence::Find);
    previous = added(*machineMenu, "previousMachine", nullptr, QKeySequence(Qt::ALT | Qt::Key_Up));
    next = added(*machineMenu, "nextMachine", nullptr, QKeySequence(Qt::ALT | Qt::Key_Down));
    machineMenu->addSeparator();
    intervals = machineMenu->addMenu(QString());
    intervals->setObjectName(QStringLiteral("intervals"));
    join = added(*machineMenu, "joinMachines", "link");
    separate = added(*machineMenu, "separateMachines");
    history = added(*machineMenu, "history", "report", QKeySequence::Print);
    type = added(*machineMenu, "typeTest", "bars");
    open = added(*testMenu, "openTest", "open", QKeySequence::Open);
    compare = added(*testMenu, "compareCurves", "curves");
    compare->setCheckable(true);
    testMenu->addSeparator();
    under = testMenu->addMenu(QString());
    sorting = testMenu->addMenu(QString());
    sorting->setObjectName(QStringLiteral("sorting"));
    clear = added(*testMenu, "clearAllFilters");
    trendAlone = added(*viewMenu, "trendAlone", "maxi", QKeySequence(Qt::Key_F11));
    trendAlone->setCheckable(true);
    viewMenu->addSeparator();
    french = added(*viewMenu, "speakFrench");
    english = added(*viewMenu, "speakEnglish");
    for (QAction *action : {french, english})
        action->setCheckable(true);
    help = added(*helpMenu, "help", "ques", QKeySequence(Qt::Key_F1));
    shortcuts = added(*helpMenu, "shortcuts");
    helpMenu->addSeparator();
    about = added(*helpMenu, "about");
    QObject::connect(french, &QAction::triggered, [] { setWindowLanguage(Language::Id::french); });
    QObject::connect(english, &QAction::triggered, [] { setWindowLanguage(Language::Id::english); });
}

void RegisterMenus::fill(QToolBar &bar) const {
    bar.addAction(folders);
    bar.addAction(rescan);
    bar.addSeparator();
    bar.addAction(open);
    bar.addAction(compare);
    bar.addSeparator();
    bar.addAction(join);
    bar.addAction(history);
    for (QAction *action : bar.actions()) {
        if (action->isSeparator())
            continue;
        QWidget *button = bar.widgetForAction(action);
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setFocusPolicy(Qt::TabFocus);
    }
}

void RegisterMenus::retranslate() const {
    registerMenu->setTitle(tr("&Register"));
    machineMenu->setTitle(tr("&Machine"));
    testMenu->setTitle(tr("&Test"));
    viewMenu->setTitle(tr("&View"));
    helpMenu->setTitle(tr("&Help"));
    intervals->setTitle(tr("&Interval"));
    under->setTitle(tr("&Evaluate all under…"));
    sorting->setTitle(tr("&Sort by"));
    folders->setText(tr("&Folders…"));
    rescan->setText(tr("&Rescan"));
    troubled->setText(tr("Files with &troubles…"));
    close->setText(tr("&Close"));
    find->setText(tr("&Search machines"));
    previous->setText(tr("&Previous machine"));
    next->setText(tr("&Next machine"));
    join->setText(tr("&Join with another…"));
    separate->setText(tr("S&eparate from another…"));
    history->setText(tr("&History report…"));
    type->setText(tr("&Type test…"));
    open->setText(tr("&Open test"));
    compare->setText(tr("&Compare curves"));
    clear->setText(tr("C&lear filters"));
    trendAlone->setText(tr("&Trend alone"));
    french->setText(QStringLiteral("&Français"));
    english->setText(QStringLiteral("&English"));
    french->setChecked(windowLanguage().id() == Language::Id::french);
    english->setChecked(windowLanguage().id() == Language::Id::english);
    help->setText(tr("&Help"));
    shortcuts->setText(tr("&Keyboard shortcuts"));
    about->setText(tr("&About Palmer"));
}

} // namespace palmer::ui
