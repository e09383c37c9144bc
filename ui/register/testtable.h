// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"
#include "ui/quiettable.h"

#include <map>
#include <set>
#include <vector>

namespace palmer::ui {

inline constexpr int valueGap = 4;      ///< between a value and its U, px
inline constexpr int resultPadding = 4; ///< on each side of a cell

/// The tests of a machine, one per row, with the main results of the axis in view.
class TestTableModel : public RowModel<ListedTest> {
    Q_OBJECT

public:
    explicit TestTableModel(QObject *parent = nullptr);

    enum Column { markColumn, dateColumn, axisColumn, editionColumn, purposeColumn, roleColumn, firstResult };
    /// markRole: TrendMark of the test's point in the trend.
    enum Role { sortRole = Qt::UserRole + 1, uncertaintyRole, iconRole, tokenRole, numberRole, markRole };

    void setTests(std::vector<ListedTest> tests);
    [[nodiscard]] const ListedTest &test(int row) const { return this->row(row); }
    /// Curve numbers of tests, from 1, shown in place of the point's mark.
    void setNumbers(std::map<int, int> numbers);
    /// Digests of tests that the trend shows as another series.
    void setOtherSeries(std::set<QString> digests);
    /// The changes of a test since the last one.
    void setSinceLast(int test, std::shared_ptr<const SinceLast> change);
    [[nodiscard]] const std::vector<std::string> &results() const { return m_results; }
    /// The longest texts of a result column, so that values and their U are aligned.
    struct Longest {
        QString value;
        QString uncertainty;
    };
    [[nodiscard]] Longest longest(std::size_t result) const;

    void retranslate();

protected:
    [[nodiscard]] QVariant cell(const ListedTest &listed, int column, int role) const override;

private:
    void makeColumns();

    std::vector<std::string> m_results; ///< IDs of the result columns
    std::map<int, int> m_numbers;       ///< by test ID
    std::set<QString> m_otherSeries;    ///< digests
};

/// Draws marks, values with U, and words with their mark.
class TestDelegate : public RowDelegate {
    Q_OBJECT

public:
    explicit TestDelegate(QObject *parent)
        : RowDelegate(parent, rule) {}

    /// Widths of the values in the result columns, px; U follows.
    void setValueWidths(std::vector<int> widths) { m_valueWidths = std::move(widths); }

protected:
    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override;

private:
    std::vector<int> m_valueWidths;
};

} // namespace palmer::ui
