// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/foldersdialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace palmer::ui {

FoldersDialog::FoldersDialog(const QStringList &folders, QWidget *parent)
    : QDialog(parent)
    , m_list(new QListWidget)
    , m_remove(new QPushButton(tr("&Remove"))) {
    constexpr int width = 520;
    setWindowTitle(tr("Folders of the register"));
    setObjectName(QStringLiteral("registerFolders"));
    auto *explanation =
        new QLabel(tr("Palmer reads the test files and reports in these folders and below them, and "
                      "never writes into them."));
    explanation->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("folders"));
    m_list->addItems(folders);
    auto *add = new QPushButton(tr("&Add folder…"));
    add->setObjectName(QStringLiteral("addFolder"));
    m_remove->setObjectName(QStringLiteral("removeFolder"));
    auto *row = new QHBoxLayout;
    row->addWidget(add);
    row->addWidget(m_remove);
    row->addStretch();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(explanation);
    layout->addWidget(m_list);
    layout->addLayout(row);
    layout->addWidget(buttons);
    resize(width, sizeHint().height());
    m_remove->setEnabled(false);
    connect(m_list, &QListWidget::itemSelectionChanged, this,
            [this] { m_remove->setEnabled(!m_list->selectedItems().isEmpty()); });
    connect(add, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose a folder"));
        if (!folder.isEmpty())
            addFolder(folder);
    });
    connect(m_remove, &QPushButton::clicked, this, [this] { qDeleteAll(m_list->selectedItems()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QStringList FoldersDialog::folders() const {
    QStringList result;
    for (int i = 0; i < m_list->count(); ++i)
        result << m_list->item(i)->text();
    return result;
}

void FoldersDialog::addFolder(const QString &folder) {
    if (m_list->findItems(folder, Qt::MatchExactly).isEmpty())
        m_list->addItem(folder);
}

} // namespace palmer::ui
