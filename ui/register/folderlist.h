// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QListWidget;
class QPushButton;

namespace palmer::ui {

/// The folders of the register, with buttons to add and remove them.
class FolderList : public QWidget {
    Q_OBJECT

public:
    explicit FolderList(const QStringList &folders, QWidget *parent = nullptr);

    [[nodiscard]] QStringList folders() const;
    /// A folder already in the list changes nothing.
    void addFolder(const QString &folder);

signals:
    void changed();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QListWidget *m_list;
    QPushButton *m_add;
    QPushButton *m_remove;
};

} // namespace palmer::ui
