// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/background.h"
#include "ui/register/curvechart.h"
#include "ui/register/filterbar.h"
#include "ui/register/machinehead.h"
#include "ui/register/testsview.h"
#include "ui/register/trendview.h"
#include "ui/thinsplitter.h"

namespace palmer::ui {

/// The page of a machine: its head, its tests with their filters, and below them the trend of one axis or
/// the curves of the chosen tests.
class RegisterPage : public QWidget {
    Q_OBJECT

public:
    /// Connects and enables the actions on tests, editions, curves and filters.
    explicit RegisterPage(const RegisterMenus &menus, QWidget *parent = nullptr);

    void setMachine(const MachineRow *machine); ///< null: none
    /// Selection and trend stay if nothing shown has changed.
    void setTests(std::vector<ListedTest> tests);
    /// Each test is shown under its own edition again.
    void forgetEdition();
    /// Arranges trend and curves for the width of the window.
    void fit();
    void goToTests() { m_table->setFocus(Qt::ShortcutFocusReason); }
    void retranslate();
    [[nodiscard]] int shownCount() const { return m_table->count(); }
    [[nodiscard]] int chosenCount() const { return static_cast<int>(m_table->chosen().size()); }
    /// True while tests are evaluated under an edition.
    [[nodiscard]] bool isBusy() const { return m_lane.isBusy(); }

signals:
    void intervalChosen(int months);                       ///< 0: none
    void openAsked(const QString &path, std::size_t test); ///< test of a file, index from 0
    void chosenChanged();

private:
    QWidget *makeTests();
    void makeTrend();
    void fillEditions();
    void evaluateUnder(const std::string &edition);
    void findChanges();
    void showTests();
    void showTrend();
    void showChosen();
    void compareCurves(bool compare);
    void giveRoomToCurves(bool compare);
    void openChosen();
    [[nodiscard]] QString trendAxis() const;

    const RegisterMenus &m_menus;
    MachineHead *m_head = new MachineHead;
    FilterBar *m_filters = new FilterBar;
    TestsView *m_table = new TestsView;
    TrendView *m_trend;
    CurveComparison *m_comparison = new CurveComparison;
    QWidget *m_testsPart;
    QSplitter *m_stacked = new ThinSplitter(Qt::Vertical); ///< tests above trend
    QList<int> m_heights;            ///< of tests and trend, before curves were compared
    std::vector<ListedTest> m_tests; ///< of the machine
    std::vector<ListedTest> m_anew;  ///< tests of the axis evaluated under m_edition
    std::string m_edition;           ///< empty: each test's own
    Background m_lane;
    Background m_changeLane; ///< compares each test with the last one, the newest first
};

} // namespace palmer::ui
