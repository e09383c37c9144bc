// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "editing/sheetblock.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "report/parts/parts.h"
#include "ui/quiettable.h"

#include <functional>
#include <vector>

namespace palmer::ui {

/// The acceptance sheet as a table: the columns of the sheet, then picture, verdict and source. The row after
/// the last takes a new one.
class SheetModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { picture = sheetColumns, verdict, source, columns };
    /// Guard of the picture, name of the icon of the verdict; invalid: none.
    enum Role { guardRole = Qt::UserRole + 40, iconRole };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const EvaluatedDocument &evaluated, const Language &language);
    /// Callback that replaces the rows of the document.
    void setWriter(std::function<void(const std::vector<SheetRow> &rows)> write) {
        m_write = std::move(write);
    }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

signals:
    /// Why the typed text was refused; empty if it was accepted.
    void refusedText(const QString &reason);

private:
    [[nodiscard]] QString shown(std::size_t row, int column) const;
    [[nodiscard]] QString typed(const SheetRow &row, int column) const;

    EvaluatedDocument m_evaluated;
    std::vector<SheetResult> m_results;
    std::vector<SheetWords> m_words;
    std::vector<Cell> m_pictures;
    Language m_language{Language::Id::english};
    std::function<void(const std::vector<SheetRow> &)> m_write;
};

} // namespace palmer::ui

Q_DECLARE_METATYPE(palmer::Guard)
