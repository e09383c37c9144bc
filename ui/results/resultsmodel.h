// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/tables/resulttable.h"
#include "ui/quiettable.h"

#include <string_view>
#include <vector>

namespace palmer::ui {

/// The results of a test as rows, next to those of the same test before or after an adjustment, if any.
class ResultsModel : public RowModel<ResultLine> {
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

    explicit ResultsModel(QObject *parent = nullptr);

    void setTable(const ResultTable &table, const Language &language);
    void retranslate();
    [[nodiscard]] const ResultTable &table() const { return m_table; }
    [[nodiscard]] const ResultLine &line(int row) const { return this->row(row); }
    enum class Names { full, brief, narrow }; ///< full: as in the standard
    [[nodiscard]] static QString nameOf(const ResultLine &line, Names names);
    [[nodiscard]] QString nameOf(int row, Names names) const { return nameOf(line(row), names); }
    void setNames(Names names);
    [[nodiscard]] int rowOf(const QString &id) const; ///< −1 if there is none
    /// Pixels to the right of a number that align its decimal mark with those of its column.
    [[nodiscard]] int roomAfter(const QString &number, int place, const QFontMetrics &metrics) const;

    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    [[nodiscard]] QVariant cell(const ResultLine &line, int place, int role) const override;

private:
    ResultTable m_table;
    Language m_language{Language::Id::english};
    Names m_names = Names::brief;
    std::vector<QString> m_fractions; ///< the longest of each column, with its decimal mark
};

} // namespace palmer::ui
