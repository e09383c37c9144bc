// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>

class QListWidget;
class QPushButton;

namespace palmer::ui {

/// Which folders the register is made of.
class FoldersDialog : public QDialog {
    Q_OBJECT

public:
    explicit FoldersDialog(const QStringList &folders, QWidget *parent = nullptr);

    [[nodiscard]] QStringList folders() const;
    void addFolder(const QString &folder);

private:
    QListWidget *m_list;
    QPushButton *m_remove;
};

} // namespace palmer::ui
