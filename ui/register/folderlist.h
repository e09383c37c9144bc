// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QStringList>
#include <QWidget>

namespace palmer::ui {

/// The folders of the register, with buttons to add and remove them.
class FolderList : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit FolderList(const QStringList &folders, QWidget *parent = nullptr);

    [[nodiscard]] QStringList folders() const;
    /// A folder already in the list changes nothing.
    void addFolder(const QString &folder);

signals:
    void changed();

private:
    void retranslate() final;

    QListWidget *m_list;
    QPushButton *m_add;
    QPushButton *m_remove;
};

} // namespace palmer::ui
