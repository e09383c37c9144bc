// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerpage.h"

#include "kernel/measurement/testfacts.h"
#include "register/reevaluate.h"
#include "register/sincelast.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"

#include <QAction>
#include <QMenu>
#include <algorithm>

namespace palmer::ui {

namespace {

/// True if nothing shown has changed.
bool sameTests(const std::vector<ListedTest> &a, const std::vector<ListedTest> &b) {
    const auto samePlace = [](const TestPlace &one, const TestPlace &other) {
        return one.path == other.path && one.test == other.test && one.state == other.state;
    };
    return std::ranges::equal(a, b, [&](const ListedTest &one, const ListedTest &other) {
        return one.id == other.id && one.machine == other.machine && one.test.digest == other.test.digest &&
               std::ranges::equal(one.places, other.places, samePlace);
    });
}

/// The tests of an axis or plane.
std::vector<ListedTest> testsOf(const QString &axis, const std::vector<ListedTest> &tests) {
    std::vector<ListedTest> list;
    std::ranges::copy_if(tests, std::back_inserter(list), [&](const ListedTest &test) {
        return QString::fromStdString(test.test.axis) == axis;
    });
    return list;
}

} // namespace

RegisterPage::RegisterPage(const RegisterMenus &menus, QWidget *parent)
    : QWidget(parent)
    , m_menus(menus)
    , m_trend(new TrendView(menus)) {
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    inColumn(this, noMargins, 0, {m_head, {m_stacked, 1}});
    m_testsPart = makeTests();
    makeTrend();
    m_stacked->setSizes({280, 360});
    menus.under->setEnabled(false);
    connect(m_head, &MachineHead::intervalChosen, this, &RegisterPage::intervalChosen);
    connect(menus.intervals, &QMenu::aboutToShow, this,
            [this] { m_head->fillIntervals(*m_menus.intervals); });
    connect(menus.open, &QAction::triggered, this, &RegisterPage::openChosen);
    connect(menus.compare, &QAction::toggled, this, &RegisterPage::compareCurves);
    connect(menus.under, &QMenu::aboutToShow, this, &RegisterPage::fillEditions);
    connect(menus.sorting, &QMenu::aboutToShow, this, [this] { m_table->fillSorting(*m_menus.sorting); });
    connect(menus.clear, &QAction::triggered, m_filters, &FilterBar::clear);
    connect(menus.trendAlone, &QAction::toggled, m_testsPart, &QWidget::setHidden);
}

QWidget *RegisterPage::makeTests() {
    auto *part = new QWidget(m_stacked);
    connect(m_filters, &FilterBar::chosen, this, [this](bool axis) {
        if (axis)
            forgetEdition();
        showTests();
    });
    connect(m_table, &TestsView::openAsked, this, &RegisterPage::openChosen);
    connect(m_table, &TestsView::chosenChanged, this, &RegisterPage::showChosen);
    auto *layout = inColumn(part, noMargins, 0, {m_filters});
    auto *framed = inRow(nullptr, {pageMargin, 0, pageMargin, 8}, styleSpacing, {m_table});
    layout->addLayout(framed, 1);
    return part;
}

/// The trend with its facts, or next to it the curves that are compared.
void RegisterPage::makeTrend() {
    m_comparison->hide();
    connect(m_comparison, &CurveComparison::closed, this, [this] { m_menus.compare->setChecked(false); });
    connect(m_trend, &TrendView::testChosen, m_table, &TestsView::choose);
    connect(m_trend, &TrendView::othersShown, m_table, &TestsView::setOtherSeries);
    inRow(new QWidget(m_stacked), noMargins, 0, {{m_trend, 3}, {m_comparison, 3}});
}

void RegisterPage::retranslate() {
    m_trend->retranslate();
    m_head->retranslate();
    m_table->retranslate();
    showTests();
}

void RegisterPage::setMachine(const MachineRow *machine) {
    m_head->setMachine(machine);
}

void RegisterPage::setTests(std::vector<ListedTest> tests) {
    m_menus.under->setEnabled(!tests.empty());
    if (sameTests(tests, m_tests))
        return;
    m_tests = std::move(tests);
    m_filters->setTests(m_tests);
    showTests();
    findChanges();
}

void RegisterPage::findChanges() {
    m_changeLane.cancel();
    m_changeLane.start(
        [this, tests = m_tests](const Background::Job &job) {
            for (std::size_t i = tests.size(); i-- > 0 && !job.stop().stop_requested();) {
                const auto last = lastBefore(tests, i);
                auto change = last ? sinceLast(tests[*last], tests[i]) : nullptr;
                if (change)
                    job.post([this, id = tests[i].id, change] {
                        if (const auto test = std::ranges::find(m_tests, id, &ListedTest::id);
                            test != m_tests.end())
                            test->sinceLast = change;
                        m_table->setSinceLast(id, change);
                    });
            }
        },
        [] {});
}

void RegisterPage::forgetEdition() {
    m_lane.cancel();
    m_edition.clear();
    m_anew.clear();
}

void RegisterPage::fillEditions() {
    m_menus.under->clear();
    m_menus.under->addAction(tr("Each test under its own edition"), this, [this] { evaluateUnder({}); });
    for (const Edition *edition : editions()) {
        const bool fits = std::ranges::any_of(m_tests, [&](const ListedTest &test) {
            return test.test.kind == edition->kind && QString::fromStdString(test.test.axis) == trendAxis();
        });
        if (fits)
            m_menus.under->addAction(QString::fromUtf8(edition->word), this,
                                     [this, word = std::string(edition->word)] { evaluateUnder(word); });
    }
}

void RegisterPage::evaluateUnder(const std::string &edition) {
    forgetEdition();
    m_edition = edition;
    if (edition.empty()) {
        showTrend();
        return;
    }
    m_lane.start(
        [list = testsOf(trendAxis(), m_tests), edition](const Background::Job &) mutable {
            (void)reevaluate(list, *findEdition(edition));
            return list;
        },
        [this](std::vector<ListedTest> anew) {
            m_anew = std::move(anew);
            showTrend();
        });
}

void RegisterPage::showTests() {
    std::vector<ListedTest> shown;
    for (const ListedTest &test : m_tests) {
        if (m_filters->filters().passes(test))
            shown.push_back(test);
    }
    m_filters->showChosen(shown.size());
    m_menus.clear->setEnabled(m_filters->anyChosen());
    m_table->setTests(std::move(shown));
    showTrend();
    showChosen();
}

/// A narrow window shows curves instead of the trend, and editions only in the menu.
void RegisterPage::fit() {
    constexpr int wide = 1180;
    const bool isWide = window()->width() >= wide;
    m_trend->showEditions(isWide);
    m_trend->setVisible(isWide || !m_menus.compare->isChecked());
}

QString RegisterPage::trendAxis() const {
    const QString &chosen = m_filters->filters().chosen[TestFilters::axis];
    if (!chosen.isEmpty())
        return chosen;
    return m_tests.empty() ? QString() : QString::fromStdString(m_tests.back().test.axis);
}

void RegisterPage::showTrend() {
    const QString axis = trendAxis();
    std::vector<ListedTest> list = testsOf(axis, m_edition.empty() ? m_tests : m_anew);
    std::erase_if(list, [this](const ListedTest &test) {
        return !m_filters->filters().passes(TestFilters::since, test);
    });
    const bool isAxis = !list.empty() && traitsOf(list.front().test.kind).isOfAxis; // else a plane, "XY"
    QString about = isAxis ? tr("%1 axis").arg(axis) : axis;
    if (!m_edition.empty())
        about += QStringLiteral(" · ") + QString::fromStdString(m_edition);
    m_trend->setTests(std::move(list), about);
}

void RegisterPage::showChosen() {
    const auto chosen = m_table->chosen();
    std::map<QString, int> digests;
    std::map<int, int> numbers;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        digests.emplace(chosen[i]->test.digest, static_cast<int>(i) + 1);
        if (chosen.size() > 1)
            numbers.emplace(chosen[i]->id, static_cast<int>(i) + 1);
    }
    m_table->setNumbers(std::move(numbers));
    m_trend->setChosen(digests);
    m_menus.open->setEnabled(chosen.size() == 1);
    const bool comparable =
        chosen.size() > 1 && std::ranges::all_of(chosen, [&](const ListedTest *test) {
            return test->test.axis == chosen.front()->test.axis && !test->test.curve.empty();
        });
    m_menus.compare->setEnabled(comparable || m_menus.compare->isChecked());
    if (m_menus.compare->isChecked() && comparable) {
        std::vector<ListedTest> list;
        list.reserve(static_cast<std::size_t>(chosen.size()));
        for (const ListedTest *test : chosen)
            list.push_back(*test);
        m_comparison->setTests(std::move(list));
    }
    emit chosenChanged();
}

void RegisterPage::compareCurves(bool compare) {
    m_trend->showFacts(!compare);
    m_comparison->setVisible(compare);
    fit();
    showChosen();
    giveRoomToCurves(compare);
}

/// Two charts and a list need more height than the trend, whose height is restored later.
void RegisterPage::giveRoomToCurves(bool compare) {
    constexpr int leastTests = 150; // filters, header and some rows
    if (!compare) {
        if (!m_heights.isEmpty())
            m_stacked->setSizes(m_heights);
        m_heights.clear();
        return;
    }
    const QList<int> heights = m_stacked->sizes();
    const int all = heights[0] + heights[1];
    const int wanted = std::min(m_comparison->wantedHeight(), all - leastTests);
    if (wanted <= heights[1])
        return;
    m_heights = heights;
    m_stacked->setSizes({all - wanted, wanted});
}

void RegisterPage::openChosen() {
    const auto chosen = m_table->chosen();
    if (chosen.size() != 1)
        return;
    const TestPlace &place = chosen.front()->places.front();
    emit openAsked(place.path, static_cast<std::size_t>(std::max(place.test - 1, 0)));
}

} // namespace palmer::ui
