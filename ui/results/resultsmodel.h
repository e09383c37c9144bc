// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/tables/resulttable.h"

#include <QAbstractTableModel>

namespace palmer::ui {

/// The results of a test as rows: symbol, name, value, ± U, limit, decision scale, verdict; beside them those
/// of the same test before or after an adjustment, where there is one.
class ResultsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        symbol,
        name,
        other, ///< of the other role; with the next and `change` only where the table has one
        otherUncertainty,
        value,
        uncertainty,
        change,
        limit,
        scale,
        verdict,
        columns
    };
    [[nodiscard]] static bool isNumber(int column);

    using QAbstractTableModel::QAbstractTableModel;

    void setTable(const ResultTable &table);
    void retranslate();
    [[nodiscard]] const ResultTable &table() const { return m_table; }
    [[nodiscard]] const ResultLine &line(int row) const {
        return m_table.lines[static_cast<std::size_t>(row)];
    }
    enum class Names { full, brief, narrow }; ///< full: as in the standard
    [[nodiscard]] QString nameOf(int row, Names names) const;
    void setNames(Names names);
    [[nodiscard]] int rowOf(const QString &id) const; ///< −1: none

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    ResultTable m_table;
    Names m_names = Names::brief;
};

} // namespace palmer::ui
