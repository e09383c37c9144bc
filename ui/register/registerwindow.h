// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/background.h"
#include "ui/register/historypdf.h"
#include "ui/register/machinelist.h"
#include "ui/register/registermenus.h"

#include <QMainWindow>
#include <vector>

class QSplitter;
class QStackedWidget;

namespace palmer::ui {

class CurveComparison;
class FilterBar;
class HelpWindow;
class MachineHead;
class MachineSide;
class RegisterService;
class RegisterStatus;
class TestsView;
class TrendView;

/// The register: machines on the left, then the tests of one of them, the trend of a parameter and
/// superimposed curves. Shows the register, which is read in the background; computes nothing.
class RegisterWindow : public QMainWindow {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RegisterWindow)

public:
    explicit RegisterWindow(RegisterService &service, QWidget *parent = nullptr);
    ~RegisterWindow() override;

    void setFolders(const QStringList &folders);
    /// True while no query is running.
    [[nodiscard]] bool isQuiet() const;

signals:
    void openAsked(const QString &path, std::size_t test); ///< test of a file, index from 0

protected:
    void changeEvent(QEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeRight();
    QWidget *makeTests();
    QWidget *makeTrend();
    void makeActions();
    void retranslate();

    void loadMachines();
    void takeMachines(std::vector<MachineRow> rows);
    void forgetEdition();
    void showMachine();
    void loadTests();
    void takeTests(std::vector<ListedTest> tests);
    void showTests();
    void fitTrend();
    void fillEditions();
    void showTrend();
    void showChosen();
    void showState();
    [[nodiscard]] QString trendAxis() const;
    void openChosen();
    void compareCurves(bool compare);
    void giveRoomToCurves(bool compare);
    void evaluateUnder(const std::string &edition);
    void chooseFolders();
    void addFolder();
    void setInterval(int months);
    void saveHistory();
    void showTroubledFiles();
    void showHelp();

    RegisterService &m_service;
    QStackedWidget *m_stack = nullptr; ///< first use, or the register's content
    MachineSide *m_side = nullptr;
    FilterBar *m_filters = nullptr;
    TestsView *m_tests = nullptr;
    TrendView *m_trend = nullptr;
    CurveComparison *m_comparison = nullptr;
    QSplitter *m_parts = nullptr;
    QSplitter *m_stacked = nullptr; ///< tests above trend
    QList<int> m_heights;           ///< of tests and trend, before curves were compared
    MachineHead *m_head = nullptr;
    QWidget *m_testsPart = nullptr;
    RegisterStatus *m_status = nullptr;
    RegisterMenus m_menus;
    HistoryPdf m_history;
    HelpWindow *m_help = nullptr;

    std::vector<ListedTest> m_allTests; ///< of the chosen machine
    std::vector<ListedTest> m_anew;     ///< tests of the axis evaluated under m_edition
    std::string m_edition;              ///< empty: each test's own
    Background m_machineLane;
    Background m_testLane;
    Background m_filesLane;
};

} // namespace palmer::ui
