// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/shortcutsdialog.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTreeWidget>
#include <utility>

namespace palmer::ui {

namespace {

QString plain(QString text) {
    return text.remove(u'&').remove(u'…');
}

QString keysOf(const QAction &action) {
    QStringList keys;
    for (const QKeySequence &shortcut : action.shortcuts())
        keys << shortcut.toString(QKeySequence::NativeText);
    return keys.join(QStringLiteral(", "));
}

QString key(QKeyCombination keys) {
    return QKeySequence(keys).toString(QKeySequence::NativeText);
}

/// Command without its current object, as in "Undo: entry of a reading".
QString commandOf(const QAction &action) {
    return plain(action.text()).section(u':', 0, 0).trimmed();
}

/// Lists the actions with a shortcut, including those of submenus.
void listActions(QTreeWidgetItem &group, const QMenu &menu) {
    for (const QAction *action : menu.actions()) {
        if (action->menu())
            listActions(group, *action->menu());
        else if (!action->shortcut().isEmpty())
            group.addChild(new QTreeWidgetItem({commandOf(*action), keysOf(*action)}));
    }
}

} // namespace

ShortcutsDialog::ShortcutsDialog(const QMenuBar &menus, QWidget *parent, bool hasReadings)
    : QDialog(parent)
    , m_list(made<QTreeWidget>("shortcutList", this)) {
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    m_list->setAccessibleName(tr("Keyboard shortcuts"));
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Command"), tr("Keys")});
    m_list->setRootIsDecorated(false);
    m_list->setItemsExpandable(false);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setProperty("roomy", true);
    addMenus(menus);
    if (hasReadings)
        addTable();
    m_list->expandAll();
    m_list->header()->setStretchLastSection(true);
    m_list->resizeColumnToContents(0);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    inColumn(this, {pageMargin, pageMargin, pageMargin, pageMargin}, styleSpacing, {{m_list, 1}, buttons});
    resize(560, 560);
}

void ShortcutsDialog::addMenus(const QMenuBar &menus) {
    for (const QAction *title : menus.actions()) {
        if (!title->menu())
            continue;
        auto *group = new QTreeWidgetItem({plain(title->text())});
        listActions(*group, *title->menu());
        if (group->childCount() == 0) {
            delete group;
            continue;
        }
        group->setFont(0, themeFont(TextSize::head));
        m_list->addTopLevelItem(group);
    }
}

void ShortcutsDialog::addTable() {
    auto *group = new QTreeWidgetItem({tr("Table of readings")});
    group->setFont(0, themeFont(TextSize::head));
    for (const auto &[what, keys] : std::initializer_list<std::pair<QString, QString>>{
             {tr("next reading of the measuring cycle"), key(Qt::Key_Return)},
             {tr("the one before"), key(Qt::SHIFT | Qt::Key_Return)},
             {tr("to the right, to the left"),
              key(Qt::Key_Tab) + QStringLiteral(", ") + key(Qt::SHIFT | Qt::Key_Tab)},
             {tr("edit the reading"), key(Qt::Key_F2)},
             {tr("restore the reading; close an explanation"), key(Qt::Key_Escape)},
             {tr("first, last cell"),
              key(Qt::CTRL | Qt::Key_Home) + QStringLiteral(", ") + key(Qt::CTRL | Qt::Key_End)}})
        group->addChild(new QTreeWidgetItem({what, keys}));
    m_list->addTopLevelItem(group);
}

} // namespace palmer::ui
