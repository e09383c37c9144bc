// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/tables/resulttable.h"

#include <QAbstractTableModel>
#include <string_view>
#include <vector>

namespace palmer::ui {

/// The results of a test as rows, next to those of the same test before or after an adjustment, if any.
class ResultsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// The columns, as in the report.
    [[nodiscard]] static const std::vector<const ResultColumn *> &columns();
    [[nodiscard]] static const ResultColumn &column(int place) {
        return *columns()[static_cast<std::size_t>(place)];
    }
    /// Index of a column by its key.
    [[nodiscard]] static int columnOf(std::string_view key);
    [[nodiscard]] static bool isNumber(int place) { return column(place).look == ResultLook::number; }

    using QAbstractTableModel::QAbstractTableModel;

    void setTable(const ResultTable &table, const Language &language);
    void retranslate();
    [[nodiscard]] const ResultTable &table() const { return m_table; }
    [[nodiscard]] const ResultLine &line(int row) const {
        return m_table.lines[static_cast<std::size_t>(row)];
    }
    enum class Names { full, brief, narrow }; ///< full: as in the standard
    [[nodiscard]] QString nameOf(int row, Names names) const;
    void setNames(Names names);
    [[nodiscard]] int rowOf(const QString &id) const; ///< −1 if there is none

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    ResultTable m_table;
    Language m_language{Language::Id::english};
    Names m_names = Names::brief;
};

} // namespace palmer::ui
