// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/columnrole.h"

#include <QTableView>
#include <vector>

class QStandardItemModel;

namespace palmer::ui {

/// The columns of a table as in the file, each with its role; a click or Return opens a menu of all roles.
/// Hidden if a file has no columns.
class ColumnRoles : public QTableView {
    Q_OBJECT

public:
    explicit ColumnRoles(QWidget *parent);

    void showColumns(const std::vector<ImportColumn> &columns);

signals:
    /// The user chose a role; all roles in the format of the choice "columns".
    void rolesChosen(const QString &columns);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void openMenu(int column);
    void choose(int column, const ImportColumn &role);

    std::vector<ImportColumn> m_columns;
    QStandardItemModel *m_model;
};

} // namespace palmer::ui
