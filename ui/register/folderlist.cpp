// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/folderlist.h"

#include "ui/madewidgets.h"

#include <QFileDialog>
#include <QListWidget>
#include <QPushButton>

namespace palmer::ui {

FolderList::FolderList(const QStringList &folders, QWidget *parent)
    : Translated(parent)
    , m_list(made<QListWidget>("folders"))
    , m_add(made<QPushButton>("addFolder"))
    , m_remove(made<QPushButton>("removeFolder")) {
    m_list->addItems(folders);
    m_remove->setEnabled(false);
    auto *row = inRow(styleSpacing, {m_add, m_remove, Placed::stretch()});
    inColumn(this, noMargins, styleSpacing, {m_list, row});
    retranslate();
    connect(m_list, &QListWidget::itemSelectionChanged, this,
            [this] { m_remove->setEnabled(!m_list->selectedItems().isEmpty()); });
    connect(m_add, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose a folder"));
        if (!folder.isEmpty())
            addFolder(folder);
    });
    connect(m_remove, &QPushButton::clicked, this, [this] {
        qDeleteAll(m_list->selectedItems());
        emit changed();
    });
}

QStringList FolderList::folders() const {
    QStringList result;
    for (int i = 0; i < m_list->count(); ++i)
        result << m_list->item(i)->text();
    return result;
}

void FolderList::addFolder(const QString &folder) {
    if (!m_list->findItems(folder, Qt::MatchExactly).isEmpty())
        return;
    m_list->addItem(folder);
    emit changed();
}

void FolderList::retranslate() {
    m_list->setAccessibleName(tr("Folders of the register"));
    m_add->setText(tr("&Add folder…"));
    m_remove->setText(tr("&Remove"));
}

} // namespace palmer::ui
