// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"
#include "ui/forms/sheetmodel.h"

class QLabel;
class QTableView;

namespace palmer::ui {

class TablePaste;

/// The acceptance sheet: its rule, what it comes to, its rows, typed, pasted or taken from a test.
class SheetPage : public Form {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SheetPage)

public:
    SheetPage(DocumentModel &model, QWidget *parent = nullptr);
    ~SheetPage() override; ///< destroys the table before its model

protected:
    void refreshOthers() override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeTable();
    void write(const char *name, const std::vector<SheetRow> &changed);
    void paste();
    void addRow();
    void removeRows();
    void chooseSource();
    void fitTable();
    void fitColumns();
    [[nodiscard]] int neededWidth(int column) const;
    [[nodiscard]] std::vector<SheetRow> rows() const;

    SheetModel m_rows;
    QLabel *m_summary;
    QLabel *m_reason;
    QTableView *m_table;
    QPushButton *m_link = nullptr;
    TablePaste *m_pasted;
    std::vector<int> m_widths; ///< of the columns, as they were fitted last
};

} // namespace palmer::ui
