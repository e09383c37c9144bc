// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/page.h"
#include "ui/verdictmark.h"

#include <QAbstractListModel>
#include <QString>
#include <optional>
#include <vector>

namespace palmer::ui {

/// Content of a window's navigation: the pages of the report with the number of missing statements, then the
/// tests with name, date, standard and the marks of limits and accordance.
class NavigationModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        headRole = Qt::UserRole + 1, ///< bool: a title, which cannot be selected
        detailRole,                  ///< second line
        iconRole,                    ///< name of the line icon
        countRole,                   ///< missing statements
        markRole,                    ///< line icon of the limits
        markColourRole,              ///< its Token, as int
        accordanceRole,              ///< line icon of the accordance
        accordanceColourRole,        ///< its Token, as int
    };

    using QAbstractListModel::QAbstractListModel;

    void show(const EvaluatedDocument &evaluated);
    void retranslate();

    /// Row of a report page, or of a test.
    [[nodiscard]] QModelIndex indexOf(Page page) const;
    [[nodiscard]] QModelIndex indexOfTest(std::size_t test) const;
    /// Page or test of a row; null for titles.
    [[nodiscard]] std::optional<Page> pageAt(const QModelIndex &index) const;
    [[nodiscard]] std::optional<std::size_t> testAt(const QModelIndex &index) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    struct Row {
        QString name;
        QString detail;
        QString icon;
        int count = 0;
        VerdictMark mark;       ///< limits
        VerdictMark accordance; ///< with the edition
        QString role;           ///< as found, as left
        std::optional<Page> page;
        std::optional<std::size_t> test;

        [[nodiscard]] bool isHead() const { return !page && !test; }
        bool operator==(const Row &) const = default;
    };

    [[nodiscard]] std::vector<Row> rows() const;
    void rebuild();
    [[nodiscard]] const Row *rowAt(const QModelIndex &index) const;

    EvaluatedDocument m_evaluated;
    std::vector<Row> m_rows;
};

/// The line icon of a kind of test.
[[nodiscard]] QString testIcon(const Test &test);

/// "ISO 230-2:2006" without the part common to all tests: "230-2".
[[nodiscard]] QString shortStandard(const std::string &edition);

} // namespace palmer::ui
