// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/page.h"
#include "ui/quiettable.h"
#include "ui/verdictmark.h"

#include <QString>
#include <optional>
#include <vector>

namespace palmer::ui {

/// A title, a page of the report or a test.
struct NavigationRow {
    QString name;
    QString detail;         ///< second line
    QString icon;           ///< name of the line icon
    int count = 0;          ///< missing statements
    VerdictMark mark;       ///< limits
    VerdictMark accordance; ///< with the edition
    QString role;           ///< as found, as left
    std::optional<Page> page;
    std::optional<std::size_t> test;

    [[nodiscard]] bool isHead() const { return !page && !test; }
    bool operator==(const NavigationRow &) const = default;
};

/// Content of a window's navigation: the pages of the report with the number of missing statements, then the
/// tests with name, date, standard and the marks of limits and accordance.
class NavigationModel : public RowModel<NavigationRow> {
    Q_OBJECT

public:
    enum Role {
        iconRole = Qt::UserRole + 1, ///< name of the line icon
        markRole,                    ///< line icon of the limits
        accordanceRole,              ///< line icon of the accordance
    };

    using RowModel::RowModel;

    void show(const EvaluatedDocument &evaluated);
    void retranslate();

    /// Row of a report page, or of a test.
    [[nodiscard]] QModelIndex indexOf(Page page) const;
    [[nodiscard]] QModelIndex indexOfTest(std::size_t test) const;
    /// Page or test of a row; null for titles.
    [[nodiscard]] std::optional<Page> pageAt(const QModelIndex &index) const;
    [[nodiscard]] std::optional<std::size_t> testAt(const QModelIndex &index) const;

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

protected:
    [[nodiscard]] QVariant cell(const NavigationRow &row, int column, int role) const override;

private:
    /// `before`: what the rows that are there were made of; empty where none of them holds.
    [[nodiscard]] std::vector<NavigationRow> rows(const EvaluatedDocument &before) const;
    [[nodiscard]] const NavigationRow *unchanged(std::size_t test, const EvaluatedDocument &before) const;
    void rebuild(const EvaluatedDocument &before);

    EvaluatedDocument m_evaluated;
};

/// The line icon of a kind of test.
[[nodiscard]] QString testIcon(const Test &test);

/// "ISO 230-2:2006" without the part common to all tests: "230-2".
[[nodiscard]] QString shortStandard(const std::string &edition);

} // namespace palmer::ui
