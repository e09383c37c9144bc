// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>

namespace palmer::ui {

class FolderList;

/// Chooses the folders of the register.
class FoldersDialog : public QDialog {
    Q_OBJECT

public:
    explicit FoldersDialog(const QStringList &folders, QWidget *parent = nullptr);

    [[nodiscard]] QStringList folders() const;
    void addFolder(const QString &folder);

private:
    FolderList *m_list;
};

} // namespace palmer::ui
