// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/register/filterchip.h"
#include "ui/register/testfilters.h"

#include <QPushButton>
#include <set>

namespace palmer::ui {

/// The filters above the tests of a machine, and how many of the tests pass them.
class FilterBar : public QWidget {
    Q_OBJECT

public:
    FilterBar();

    /// The tests to choose values from. If none has the chosen axis, the first axis is chosen: a trend has
    /// only one.
    void setTests(const std::vector<ListedTest> &tests);
    [[nodiscard]] const TestFilters &filters() const { return m_filters; }
    [[nodiscard]] bool anyChosen() const { return m_clear->isEnabled(); }
    void clear();
    /// Shows the chosen values and the number of tests that pass.
    void showChosen(std::size_t passing);

signals:
    void chosen(bool axis); ///< another value; `axis`: also or only of the axis

private:
    void fillMenu(TestFilters::Property property);
    void choose(TestFilters::Property property, const QString &value);

    TestFilters m_filters;
    std::array<std::set<QString>, TestFilters::count> m_values; ///< to choose from
    std::size_t m_tests = 0;
    std::array<FilterChip *, TestFilters::count> m_chips{};
    QLabel *m_count = made<ElidedLabel>("shownCount", TextSize::small);
    QPushButton *m_clear = made<QPushButton>("clearFilters", trait::link);
};

} // namespace palmer::ui
