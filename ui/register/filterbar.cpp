// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/filterbar.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/windowlanguage.h"

#include <QMenu>

namespace palmer::ui {

FilterBar::FilterBar() {
    constexpr int filterHeight = 40;
    constexpr std::array names{"filterAxis", "filterSince",  "filterEdition",   "filterPurpose",
                               "filterRole", "filterLimits", "filterAccordance"};
    setFixedHeight(filterHeight);
    auto *row = inRow(this, {pageMargin, 8, pageMargin, 8}, 6, {});
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto property = static_cast<TestFilters::Property>(i);
        FilterChip *chip = m_chips.at(i) = made<FilterChip>(names.at(i));
        row->addWidget(chip);
        connect(chip->menu(), &QMenu::aboutToShow, this, [this, property] { fillMenu(property); });
        connect(chip, &FilterChip::cleared, this, [this, property] { choose(property, {}); });
    }
    m_count->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the width left by the chips
    m_count->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_count, 1);
    row->addWidget(m_clear);
    connect(m_clear, &QPushButton::clicked, this, &FilterBar::clear);
}

void FilterBar::setTests(const std::vector<ListedTest> &tests) {
    m_tests = tests.size();
    m_values = {};
    std::set<std::pair<Kind, QString>> axes;
    for (const ListedTest &test : tests) {
        for (std::size_t i = 0; i < m_values.size(); ++i)
            m_values.at(i).insert(TestFilters::valueOf(static_cast<TestFilters::Property>(i), test));
        axes.emplace(test.test.kind, QString::fromStdString(test.test.axis));
    }
    QString &axis = m_filters.chosen[TestFilters::axis];
    if (!axes.empty() && !m_values[TestFilters::axis].contains(axis))
        axis = axes.begin()->second;
}

void FilterBar::clear() {
    m_filters = {};
    emit chosen(true);
}

void FilterBar::choose(TestFilters::Property property, const QString &value) {
    m_filters.chosen.at(property) = value;
    emit chosen(property == TestFilters::axis);
}

void FilterBar::fillMenu(TestFilters::Property property) {
    QMenu *menu = m_chips.at(property)->menu();
    menu->clear();
    menu->addAction(tr("All"), this, [this, property] { choose(property, {}); });
    menu->addSeparator();
    for (const QString &value : m_values.at(property)) {
        if (value.isEmpty())
            continue;
        QAction *action = menu->addAction(TestFilters::nameOf(property, value), this,
                                          [this, property, value] { choose(property, value); });
        action->setCheckable(true);
        action->setChecked(value == m_filters.chosen.at(property));
    }
}

void FilterBar::showChosen(std::size_t passing) {
    const std::array names{tr("Axis"), tr("Since"),  tr("Edition"), tr("Purpose"),
                           tr("Role"), tr("Limits"), tr("Test")};
    bool any = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const QString &value = m_filters.chosen.at(i);
        any = any || !value.isEmpty();
        m_chips.at(i)->setContent(names.at(i), value.isEmpty() ? QString()
                                               : i == TestFilters::axis
                                                   ? tr("Axis %1").arg(value)
                                                   : TestFilters::nameOf(TestFilters::Property(i), value));
    }
    m_clear->setText(tr("Clear filters"));
    m_clear->setEnabled(any);
    const auto grouped = [](std::size_t number) {
        return windowLanguage().number(static_cast<double>(number), Quantity::count);
    };
    m_count->setText(
        tr("%1 of %2 test(s)", nullptr, static_cast<int>(m_tests)).arg(grouped(passing), grouped(m_tests)));
}

} // namespace palmer::ui
