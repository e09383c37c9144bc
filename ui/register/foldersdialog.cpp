// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/foldersdialog.h"

#include "ui/madewidgets.h"
#include "ui/register/folderlist.h"

#include <QDialogButtonBox>
#include <QLabel>

namespace palmer::ui {

FoldersDialog::FoldersDialog(const QStringList &folders, QWidget *parent)
    : QDialog(parent)
    , m_list(new FolderList(folders)) {
    constexpr int width = 520;
    setWindowTitle(tr("Folders of the register"));
    setObjectName(QStringLiteral("registerFolders"));
    auto *explanation =
        new QLabel(tr("Palmer reads the test files and reports in these folders and below them, and "
                      "never changes them. What you say of machines it keeps beside them, in "
                      "palmer-machines.json."));
    explanation->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    inColumn(this, styleMargins, styleSpacing, {explanation, m_list, buttons});
    resize(width, sizeHint().height());
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QStringList FoldersDialog::folders() const {
    return m_list->folders();
}

void FoldersDialog::addFolder(const QString &folder) {
    m_list->addFolder(folder);
}

} // namespace palmer::ui
