// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/register/registerwindow.h"
#include "core/register/registerdata.h"
#include "ui/register/curvechart.h"
#include "ui/register/foldersdialog.h"
#include "ui/register/registerservice.h"
#include "ui/register/testtable.h"
#include "ui/register/trendchart.h"
#include "ui/window/shownwindow.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;
using palmer::testdata::fileOf;
using palmer::testdata::Sample;
using palmer::testdata::writeFile;

/// The window of the register over files of a folder, as its users drive it.
class RegisterWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        setWindowLanguage(Language::Id::english);
        m_dir = std::make_unique<QTemporaryDir>();
        const auto add = [this](const std::string &machine, const std::string &axis, const std::string &date,
                                double level, const std::string &purpose, const std::string &role) {
            Sample sample;
            sample.machine = machine;
            sample.serial = machine;
            sample.axis = axis;
            sample.date = date;
            sample.level = level;
            sample.purpose = purpose;
            sample.role = role;
            writeFile(folder() + QString("/%1.palmer").arg(++m_files), fileOf(sample));
        };
        add("Machine 1", "X", "2023-11-21", 10.6, "periodic", "asFound");
        add("Machine 1", "X", "2024-02-13", 19.3, "afterCollision", "asFound");
        add("Machine 1", "X", "2024-04-16", 9.4, "afterRepair", "asLeft");
        add("Machine 1", "X", "2024-11-19", 10.5, "periodic", "asFound");
        add("Machine 1", "X", "2025-05-20", 10.7, "periodic", "asFound");
        add("Machine 1", "X", "2025-11-18", 11.8, "periodic", "asFound");
        add("Machine 1", "X", "2026-05-19", 12.0, "periodic", "asFound");
        add("Machine 1", "Y", "2026-05-19", 7.0, "periodic", "asFound");
        add("Machine 2", "X", "2026-05-19", 25.0, "periodic", "asFound");
        m_service = std::make_unique<RegisterService>(m_dir->filePath("register.sqlite"), QStringList{});
        m_window = std::make_unique<RegisterWindow>(*m_service);
        m_window->resize(1280, 800);
        m_window->show();
    }
    void cleanup() {
        m_window.reset();
        m_service.reset();
    }

    void emptyItAsksForAFolder() {
        settle();
        QVERIFY(find<QPushButton>("chooseFolder")->isVisible());
        QVERIFY(!m_window->findChild<QAction *>("rescan")->isEnabled());
        QVERIFY(!m_window->findChild<QAction *>("openTest")->isEnabled());
        QVERIFY(!m_window->findChild<QAction *>("compareCurves")->isEnabled());
        QVERIFY(!m_window->findChild<QAction *>("history")->isEnabled());
        QVERIFY(find<QLabel>("scanState")->text().contains("No folder"));
    }

    void machinesAndTheirTests() {
        scan();
        auto *machines = find<QListView>("machines");
        auto *tests = find<QTableView>("tests");
        const QAbstractItemModelTester list(machines->model(),
                                            QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QAbstractItemModelTester table(tests->model(),
                                             QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(machines->model()->rowCount(), 2);
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 1"));
        QCOMPARE(tests->model()->rowCount(), 7); // of the first axis
        QCOMPARE(tests->model()->index(0, TestTableModel::dateColumn).data().toString(),
                 QString("19\u00A0May\u00A02026"));
        QCOMPARE(find<QLabel>("shownCount")->text(), QString("7 of 8 tests"));
        machines->setCurrentIndex(machines->model()->index(1, 0));
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 2"));
        QCOMPARE(tests->model()->rowCount(), 1);
        QTest::keyClicks(find<QLineEdit>("machineSearch"), "machine 2");
        QCOMPARE(machines->model()->rowCount(), 1);
        QTest::keyClicks(find<QLineEdit>("machineSearch"), "!!0");
        QCOMPARE(machines->model()->rowCount(), 0);
        find<QLineEdit>("machineSearch")->clear();
        find<QToolButton>("machinesToDo")->click(); // that of the exceeded limit
        QCOMPARE(machines->model()->rowCount(), 1);
    }

    void filters() {
        scan();
        auto *tests = find<QTableView>("tests");
        choose("filterPurpose", "periodic check");
        QCOMPARE(tests->model()->rowCount(), 5);
        choose("filterSince", "since 2025");
        QCOMPARE(tests->model()->rowCount(), 3);
        find<QPushButton>("clearFilters")->click();
        QCOMPARE(tests->model()->rowCount(), 8);
        choose("filterLimits", "exceeded");
        QCOMPARE(tests->model()->rowCount(), 1);
        QVERIFY(find<QPushButton>("filterLimits")->isChecked());
    }

    void theTrendIsThatOfTheKernel() {
        scan();
        auto *chart = find<TrendChart>("trendChart");
        QCOMPARE(chart->panel().values.size(), std::size_t{7});
        QCOMPARE(chart->panel().interventions.size(), std::size_t{2});
        QVERIFY(!chart->panel().line.empty());
        QVERIFY(chart->panel().statement.startsWith("not before"));
        QVERIFY(chart->label(0).contains("21\u00A0Nov\u00A02023"));
        QVERIFY(find<QLabel>("trendFacts")->text().contains("not before"));
        find<QToolButton>("parameter R")->click();
        QCOMPARE(chart->panel().symbol, QString("R"));
        // A click on a point chooses its test.
        find<QToolButton>("parameter A")->click();
        emit chart->testChosen(digest(0));
        QCOMPARE(selected().size(), 1);
        // All under one edition.
        auto *menu = find<QPushButton>("evaluateUnder")->menu();
        emit menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->text() == "ISO 230-2:1988")
                action->trigger();
        }
        settle();
        QVERIFY(find<QLabel>("trendTitle")->text().contains("ISO 230-2:1988"));
        QCOMPARE(chart->panel().values.size(), std::size_t{7});
    }

    void zoomAndBack() {
        scan();
        auto *chart = find<TrendChart>("trendChart");
        const QPointF middle = chart->chart()->plotArea().center();
        QWheelEvent wheel(middle, chart->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        const double before = chart->chart()->mapToValue(chart->chart()->plotArea().topLeft()).x();
        QCoreApplication::sendEvent(chart->viewport(), &wheel);
        QVERIFY(chart->chart()->mapToValue(chart->chart()->plotArea().topLeft()).x() > before + 0.01);
        chart->showAll();
        QVERIFY(std::abs(chart->chart()->mapToValue(chart->chart()->plotArea().topLeft()).x() - before) <
                1e-6);
    }

    void curvesOverEachOther() {
        scan();
        auto *tests = find<QTableView>("tests");
        auto *compare = m_window->findChild<QAction *>("compareCurves");
        QVERIFY(!compare->isEnabled());
        QItemSelection both;
        for (const int row : {4, 5}) // repair and collision
            both.select(tests->model()->index(row, 0),
                        tests->model()->index(row, tests->model()->columnCount() - 1));
        tests->selectionModel()->select(both, QItemSelectionModel::ClearAndSelect);
        QVERIFY(compare->isEnabled());
        compare->trigger();
        auto *comparison = find<CurveComparison>("curveComparison");
        QVERIFY(comparison->isVisible());
        QVERIFY(comparison->difference());
        // The later one less the earlier: 9.4 − 19.3 at the end of the axis.
        QCOMPARE(comparison->difference()->largest->position, 1000.0);
        QVERIFY(std::abs(*comparison->difference()->largest->value + 0.0099) < 1e-9);
        find<QToolButton>("closeComparison")->click();
        QVERIFY(!comparison->isVisible());
    }

    void whatIsSavedAppearsAtOnce() {
        scan();
        Sample sample;
        sample.machine = "Machine 3";
        sample.serial = "Machine 3";
        const QString path = folder() + "/new.palmer";
        writeFile(path, fileOf(sample));
        m_service->fileSaved(path);
        settle();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 3);
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 1")); // what is looked at stays
        // Elsewhere it is none of the register's business.
        writeFile(m_dir->filePath("elsewhere.palmer"), fileOf(sample));
        m_service->fileSaved(m_dir->filePath("elsewhere.palmer"));
        QVERIFY(!m_service->isScanning());
    }

    void anotherProgramWritesIntoTheFolder() {
        scan();
        Sample sample;
        sample.machine = "Machine 4";
        sample.serial = "Machine 4";
        writeFile(folder() + "/other.palmer", fileOf(sample));
        QTRY_COMPARE_WITH_TIMEOUT(find<QListView>("machines")->model()->rowCount(), 3, 60'000);
    }

    void aTestIsOpened() {
        scan();
        QSignalSpy opened(m_window.get(), &RegisterWindow::openAsked);
        auto *tests = find<QTableView>("tests");
        tests->selectRow(2);
        QVERIFY(m_window->findChild<QAction *>("openTest")->isEnabled());
        m_window->findChild<QAction *>("openTest")->trigger();
        QCOMPARE(opened.size(), 1);
        QVERIFY(opened.front().front().toString().startsWith(folder()));
    }

    void anIntervalIsKept() {
        scan();
        auto *interval = find<QComboBox>("interval");
        interval->setCurrentIndex(interval->findData(6));
        emit interval->activated(interval->currentIndex());
        settle();
        QVERIFY(find<QWidget>("due")->isVisible());
        // An index made anew knows it again.
        {
            Register reg(m_service->address(), Register::Open::rebuild);
            reg.database().execute("update machine set months = null");
        }
        m_service->rescan();
        settle();
        QCOMPARE(find<QComboBox>("interval")->currentData().toInt(), 6);
    }

    void unreadableFilesAreNamed() {
        writeFile(folder() + "/broken.palmer", "{");
        scan();
        QVERIFY(find<QLabel>("unreadable")->isVisible());
        QVERIFY(find<QLabel>("unreadable")->toolTip().contains("broken.palmer"));
    }

    void bothLanguages() {
        scan();
        setWindowLanguage(Language::Id::french);
        QCoreApplication::processEvents();
        QCOMPARE(m_window->findChild<QAction *>("history")->text().remove('&'), QString("Historique…"));
        QCOMPARE(find<QTableView>("tests")
                     ->model()
                     ->headerData(TestTableModel::roleColumn, Qt::Horizontal)
                     .toString(),
                 QString("Rôle"));
        QVERIFY(find<TrendChart>("trendChart")->panel().statement.startsWith("pas avant"));
    }

    void foldersAreChosen() {
        FoldersDialog dialog({"/a", "/b"});
        dialog.addFolder("/b");
        dialog.addFolder("/c");
        QCOMPARE(dialog.folders(), (QStringList{"/a", "/b", "/c"}));
    }

private:
    [[nodiscard]] QString folder() const { return m_dir->filePath("files"); }
    template <class Widget>
    [[nodiscard]] Widget *find(const char *name) const {
        auto *found = m_window->findChild<Widget *>(QLatin1StringView(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    /// Until nothing is being read, and what was read is shown.
    void settle() const {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isQuiet(), 60'000);
        QCoreApplication::processEvents();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isQuiet(), 60'000);
    }
    void scan() {
        m_window->setFolders({folder()});
        QTRY_VERIFY_WITH_TIMEOUT(m_service->scannedAt().isValid(), 60'000);
        settle();
    }
    void choose(const char *filter, const QString &word) {
        auto *menu = find<QPushButton>(filter)->menu();
        emit menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->text() == word) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable("no " + word));
    }
    [[nodiscard]] QModelIndexList selected() const {
        return find<QTableView>("tests")->selectionModel()->selectedRows();
    }
    [[nodiscard]] QString digest(int row) const {
        const auto *model = m_window->findChild<TestTableModel *>();
        return model->test(row).test.digest;
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<RegisterService> m_service;
    std::unique_ptr<RegisterWindow> m_window;
    int m_files = 0;
};

QTEST_MAIN(RegisterWindowTest)
#include "registerwindowtest.moc"
