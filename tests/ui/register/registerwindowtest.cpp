// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/register/registerwindow.h"
#include "core/register/postgresqlserver.h"
#include "core/register/registerdata.h"
#include "ui/help/helpwindow.h"
#include "ui/register/curvechart.h"
#include "ui/register/filterchip.h"
#include "ui/register/folderlist.h"
#include "ui/register/foldersdialog.h"
#include "ui/register/machinelist.h"
#include "ui/register/numbertag.h"
#include "ui/register/registerservice.h"
#include "ui/register/registersettings.h"
#include "ui/register/testtable.h"
#include "ui/register/trendchart.h"
#include "ui/register/troubledfiles.h"
#include "ui/theme.h"
#include "ui/window/shownwindow.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFileDialog>
#include <QGraphicsTextItem>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QSet>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

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
        QVERIFY(find<QWidget>("ghostRows")->isVisible());
        QVERIFY(!find<QLineEdit>("machineSearch")->isEnabled());
        QVERIFY(!find<QListView>("machines")->isVisible());
        scan();
        QVERIFY(!find<QPushButton>("chooseFolder")->isVisible());
        QVERIFY(!find<QWidget>("ghostRows")->isVisible());
        QVERIFY(find<QLineEdit>("machineSearch")->isEnabled());
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
        QVERIFY(!find<QLabel>("noMachine")->isVisible());
        QTest::keyClicks(find<QLineEdit>("machineSearch"), "!!0");
        QCOMPARE(machines->model()->rowCount(), 0);
        QVERIFY(find<QLabel>("noMachine")->isVisible());
        QCOMPARE(find<QLabel>("noMachine")->text(), QString("No machine found"));
        find<QLineEdit>("machineSearch")->clear();
        QVERIFY(!find<QLabel>("noMachine")->isVisible());
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
        auto *limits = find<FilterChip>("filterLimits");
        QVERIFY(limits->isChecked());
        QCOMPARE(limits->text(), QString("exceeded"));
        // Its ✕ takes the filter away, the rest of it does not.
        QTest::mouseClick(limits, Qt::LeftButton, {}, QPoint(limits->width() - 16, limits->height() / 2));
        QVERIFY(!limits->isChecked());
        QVERIFY(!limits->menu()->isVisible());
        QCOMPARE(tests->model()->rowCount(), 8);
        choose("filterLimits", "exceeded");
        QTest::keyClick(limits, Qt::Key_Delete);
        QVERIFY(!limits->isChecked());
        choose("filterAxis", "Y");
        m_window->findChild<QAction *>("clearAllFilters")->trigger();
        QCOMPARE(tests->model()->rowCount(), 8);
        QVERIFY(!m_window->findChild<QAction *>("clearAllFilters")->isEnabled());
    }

    void noStateMakesItWiderThanItMayBe_data() {
        QTest::addColumn<Language::Id>("language");
        QTest::addColumn<bool>("isEmpty");
        QTest::newRow("first use, English") << Language::Id::english << true;
        QTest::newRow("first use, French") << Language::Id::french << true;
        QTest::newRow("English") << Language::Id::english << false;
        QTest::newRow("French") << Language::Id::french << false;
    }
    /// 960 × 600: what any window of the program may be made to.
    void noStateMakesItWiderThanItMayBe() {
        QFETCH(Language::Id, language);
        QFETCH(bool, isEmpty);
        setWindowLanguage(language);
        if (!isEmpty) {
            Sample sample;
            sample.machine = QString("A machine of a long name ").repeated(12).toStdString();
            sample.serial = "0";
            writeFile(folder() + "/long.palmer", fileOf(sample));
            scan();
        }
        const auto isNarrow = [this](const char *state) {
            m_window->resize(960, 600);
            QCoreApplication::processEvents();
            QVERIFY2(
                m_window->width() <= 960 && m_window->height() <= 600,
                qPrintable(QString("%1: %2 × %3").arg(state).arg(m_window->width()).arg(m_window->height())));
        };
        isNarrow("at first");
        if (isEmpty)
            return;
        m_window->resize(1600, 900); // and back from wide
        isNarrow("after wide");
        auto *machines = find<QListView>("machines");
        for (int row = 0; row < machines->model()->rowCount(); ++row) {
            machines->setCurrentIndex(machines->model()->index(row, 0));
            settle();
            isNarrow("of a machine");
        }
        for (const char *filter :
             {"filterSince", "filterEdition", "filterPurpose", "filterRole", "filterLimits"}) {
            auto *menu = find<FilterChip>(filter)->menu();
            emit menu->aboutToShow();
            menu->actions().back()->trigger();
        }
        isNarrow("with filters");
        find<QPushButton>("clearFilters")->click();
        machines->setCurrentIndex(machines->model()->index(1, 0));
        settle();
        find<QTableView>("tests")->selectAll();
        m_window->findChild<QAction *>("compareCurves")->trigger();
        isNarrow("with curves");
        QVERIFY(find<TaggedChart>("curves")->height() >= 80);
        QVERIFY(!find<TrendChart>("trendChart")->isVisible());
        QVERIFY(!find<QPushButton>("evaluateUnder")->isVisible()); // it stands in the menu
        m_window->resize(1400, 800);
        QCoreApplication::processEvents();
        QVERIFY(find<TrendChart>("trendChart")->isVisible());
        QVERIFY(find<QPushButton>("evaluateUnder")->isVisible());
    }

    void menusHoldWhatTheWindowCan() {
        scan();
        QStringList titles;
        for (const QAction *action : m_window->menuBar()->actions()) {
            titles << action->text().remove('&');
            QVERIFY2(action->menu() && !action->menu()->actions().isEmpty(), qPrintable(action->text()));
        }
        QCOMPARE(titles, (QStringList{"Register", "Machine", "Test", "View", "Help"}));
        // Of one menu no two letters are alike, in either language.
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            setWindowLanguage(language);
            QCoreApplication::processEvents();
            const auto lettersDiffer = [](const QList<QAction *> &actions) {
                QStringList letters;
                for (const QAction *action : actions) {
                    if (const qsizetype at = action->text().indexOf('&'); at >= 0)
                        letters << action->text().mid(at + 1, 1).toLower();
                }
                const qsizetype all = letters.size();
                letters.removeDuplicates();
                return letters.size() == all;
            };
            QVERIFY(lettersDiffer(m_window->menuBar()->actions()));
            for (const QAction *action : m_window->menuBar()->actions())
                QVERIFY2(lettersDiffer(action->menu()->actions()), qPrintable(action->text()));
        }
        // Machines one after another, and the search.
        auto *machines = find<QListView>("machines");
        m_window->findChild<QAction *>("nextMachine")->trigger();
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 2"));
        m_window->findChild<QAction *>("nextMachine")->trigger(); // there is none
        QCOMPARE(machines->currentIndex().row(), 1);
        m_window->findChild<QAction *>("previousMachine")->trigger();
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 1"));
        // The interval, as in the head.
        auto *intervals = m_window->findChild<QMenu *>("intervals");
        emit intervals->aboutToShow();
        QCOMPARE(intervals->actions().size(), find<QComboBox>("interval")->count());
        intervals->actions()[4]->trigger();
        settle();
        QCOMPARE(find<QComboBox>("interval")->currentIndex(), 4);
        QVERIFY(find<QWidget>("due")->isVisible());
        // The trend alone, both ways.
        auto *alone = m_window->findChild<QAction *>("trendAlone");
        alone->trigger();
        QVERIFY(!find<QTableView>("tests")->isVisible());
        find<QToolButton>("maximiseTrend")->click();
        QVERIFY(!alone->isChecked());
        QVERIFY(find<QTableView>("tests")->isVisible());
        // Help opens with its page.
        m_window->findChild<QAction *>("help")->trigger();
        auto *help = m_window->findChild<HelpWindow *>();
        QVERIFY(help && help->isVisible());
        QCOMPARE(help->currentPage(), QString("register"));
    }

    void machinesWithoutSerialNumberSaySo() {
        Sample sample;
        sample.machine = "Unknown";
        sample.serial = "";
        writeFile(folder() + "/unknown.palmer", fileOf(sample));
        scan();
        auto *machines = find<QListView>("machines");
        QCOMPARE(machines->model()->rowCount(), 3);
        const QModelIndex last = machines->model()->index(2, 0);
        QVERIFY(last.data(Qt::AccessibleTextRole).toString().contains("not identified"));
        machines->setCurrentIndex(last);
        settle();
        QVERIFY(find<QLabel>("machineFacts")->text().contains("not identified"));
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Unknown"));
    }

    /// Two machines are shown with what identifies them, and become one.
    void machinesAreJoined() {
        scan();
        auto *join = m_window->findChild<QAction *>("joinMachines");
        QVERIFY(join->isEnabled());
        join->trigger();
        auto *dialog = m_window->findChild<QInputDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(dialog->labelText().startsWith("1. Machine 1 · Maker A · CU 1000\n"));
        QCOMPARE(dialog->comboBoxItems(), QStringList{"2. Machine 2 · Maker A · CU 1000"});
        auto *list = dialog->findChild<QListView *>();
        QTest::keyClick(list, Qt::Key_Return); // nothing is chosen beforehand
        settle();
        QVERIFY(dialog->isVisible());
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        settle();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 1);
        QCOMPARE(find<QLabel>("total")->text(), QString("1 machine · 9 tests"));
        QVERIFY(!join->isEnabled());
        QVERIFY(QFile::exists(folder() + "/palmer-machines.json"));
        QVERIFY2(find<QLabel>("machineFacts")->text().endsWith(" · joined with Machine 2"),
                 qPrintable(find<QLabel>("machineFacts")->text()));
        find<QLineEdit>("machineSearch")->setText("machine 2"); // as either is called
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 1);
        // And parted again.
        auto *part = m_window->findChild<QAction *>("separateMachines");
        QVERIFY(part->isEnabled());
        part->trigger();
        QTRY_VERIFY(m_window->findChild<QInputDialog *>());
        dialog = m_window->findChild<QInputDialog *>();
        QCOMPARE(dialog->comboBoxItems(), QStringList{"Machine 2 · Maker A · CU 1000"});
        list = dialog->findChild<QListView *>();
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        settle();
        find<QLineEdit>("machineSearch")->clear();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2);
        QVERIFY(join->isEnabled() && !part->isEnabled());
    }

    /// With the ending that was not typed; the status bar says where.
    void theHistoryIsSaved() {
        scan();
        const QString path = m_dir->filePath("history");
        QTimer::singleShot(0, m_window.get(), [&] {
            auto *number = qobject_cast<QInputDialog *>(QApplication::activeModalWidget());
            QVERIFY(number);
            QTimer::singleShot(0, m_window.get(), [&] {
                auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                dialog->selectFile(path);
                QMetaObject::invokeMethod(dialog, "accept");
            });
            number->accept();
        });
        m_window->findChild<QAction *>("history")->trigger();
        settle();
        QVERIFY(QFile::exists(path + ".pdf") && !QFile::exists(path));
        QVERIFY2(m_window->statusBar()->currentMessage().endsWith("history.pdf"),
                 qPrintable(m_window->statusBar()->currentMessage()));
    }

    /// An axis of one machine comes first by its name and says nothing of the type.
    void aTypeTestBeginsWithMostMachines() {
        Sample sample;
        sample.machine = sample.serial = "Machine 1";
        sample.axis = "B";
        writeFile(folder() + "/b.palmer", fileOf(sample));
        scan();
        m_window->findChild<QAction *>("typeTest")->trigger();
        settle();
        const auto *dialog = m_window->findChild<QDialog *>("typeDialog");
        QVERIFY(dialog);
        QCOMPARE(dialog->findChild<QComboBox *>("typeParameter")->itemText(0), QString("B · A"));
        QCOMPARE(dialog->findChild<QComboBox *>("typeParameter")->currentText(), QString("X · A"));
    }

    /// A drive that is not connected: one is asked before its tests go.
    void mostOfAFolderIsRemovedOnlyWhenAsked() {
        scan();
        for (int i = 0; i < 5; ++i)
            QVERIFY(QFile::remove(folder() + QString("/%1.palmer").arg(m_files - i)));
        m_service->rescan(RegisterService::Prune::yes);
        settle();
        QCOMPARE(m_service->result().tests, 9);
        auto *all = m_window->findChild<QPushButton *>("removeAllTheSame");
        QVERIFY(all && all->isVisible());
        all->click();
        settle();
        QCOMPARE(m_service->result().tests, 4);
    }

    /// From the first folder to closing without a mouse, seen in the dark; keys go the way of the system's.
    void drivenByKeysAloneInTheDark() {
        const auto back = qScopeGuard([before = themeChoice()] { setThemeChoice(before); });
        setThemeChoice(ThemeChoice::dark);
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
        const auto focused = [] {
            const QWidget *widget = QApplication::focusWidget();
            return widget ? widget->objectName() : QString();
        };
        const auto target = [this] { // a menu that closes leaves no window the keys for a moment
            QWindow *window = QGuiApplication::focusWindow();
            return window ? window : m_window->windowHandle();
        };
        const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = {}) {
            QTest::keyClick(target(), key, with);
        };
        const auto type = [&](const char *text) {
            for (; *text; ++text)
                QTest::keyClick(target(), *text);
        };
        const auto tabTo = [&](const QString &name) {
            QStringList walked;
            while (focused() != name && walked.size() < 60) {
                walked << focused();
                press(Qt::Key_Tab);
            }
            return walked.size() < 60 ? QString() : name + " is not among " + walked.join(", ");
        };
        QCOMPARE(focused(), QString("chooseFolder"));
        scan();
        auto *machines = find<QListView>("machines");
        auto *tests = find<QTableView>("tests");
        QCOMPARE(focused(), QString("machineSearch"));
        // One round, in the order of reading.
        for (const char *name :
             {"allMachines", "machines", "interval", "filterAxis", "filterLimits", "tests", "parameter A",
              "evaluateUnder", "copyTrend", "maximiseTrend", "trendChart", "foldersButton", "rescanButton",
              "joinMachinesButton", "historyButton", "machineSearch"})
            QCOMPARE(tabTo(name), QString());
        // From the search to the opened test.
        type("machine 2");
        press(Qt::Key_Down);
        QCOMPARE(focused(), QString("machines"));
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 2"));
        press(Qt::Key_Return);
        QCOMPARE(focused(), QString("tests"));
        const QSignalSpy opened(m_window.get(), &RegisterWindow::openAsked);
        press(Qt::Key_Enter, Qt::KeypadModifier);
        QCOMPARE(opened.size(), 1);
        press(Qt::Key_Escape);
        QCOMPARE(machines->model()->rowCount(), 2);
        QVERIFY(find<QLineEdit>("machineSearch")->text().isEmpty());
        // What is to be done.
        QCOMPARE(tabTo("allMachines"), QString());
        press(Qt::Key_Right);
        QCOMPARE(focused(), QString("machinesToDo"));
        QCOMPARE(machines->model()->rowCount(), 1); // that of the exceeded limit
        press(Qt::Key_Left);
        QCOMPARE(machines->model()->rowCount(), 2);
        press(Qt::Key_Up, Qt::AltModifier);
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 1"));
        // Filters, order and several tests of the table.
        QCOMPARE(tabTo("filterPurpose"), QString());
        press(Qt::Key_Down);
        auto *menu = find<FilterChip>("filterPurpose")->menu();
        QVERIFY(menu->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!menu->isVisible());
        press(Qt::Key_Return);
        for (int i = 0; i < 2; ++i) // all, then the first purpose
            press(Qt::Key_Down);
        press(Qt::Key_Return);
        QVERIFY(find<FilterChip>("filterPurpose")->isChecked());
        QCOMPARE(tests->model()->rowCount(), 1);
        press(Qt::Key_Delete);
        QCOMPARE(tests->model()->rowCount(), 7);
        const QString newest = tests->model()->index(0, TestTableModel::dateColumn).data().toString();
        press(Qt::Key_T, Qt::AltModifier);
        press(Qt::Key_S); // by date, the other way round
        press(Qt::Key_Return);
        QCOMPARE(tests->model()->index(6, TestTableModel::dateColumn).data().toString(), newest);
        QCOMPARE(tabTo("tests"), QString());
        press(Qt::Key_Down);
        press(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(selected().size(), 2);
        QCOMPARE(tabTo("compareCurvesButton"), QString());
        press(Qt::Key_Return);
        QVERIFY(find<TaggedChart>("curves")->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!find<TaggedChart>("curves")->isVisible());
        // The trend.
        QCOMPARE(tabTo("parameter A"), QString());
        press(Qt::Key_Right);
        QVERIFY(find<QLabel>("trendTitle")->text().startsWith("Trend of E"));
        m_service->rescan();
        settle();
        QCOMPARE(focused(), QString("parameter E"));
        QCOMPARE(tabTo("trendChart"), QString());
        auto *chart = find<TrendChart>("trendChart");
        const QRectF whole = chart->range();
        press(Qt::Key_Plus);
        QVERIFY(chart->range().width() < whole.width());
        press(Qt::Key_0);
        QCOMPARE(chart->range(), whole);
        press(Qt::Key_F11);
        QVERIFY(!tests->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(tests->isVisible());
        // Texts that carry their colours have those of the dark.
        const auto shows = [this](const char *name, Token colour) {
            return find<QLabel>(name)->text().contains(token(colour, m_window->palette()).name());
        };
        QVERIFY(shows("trendLegend", Token::accent));
        QVERIFY(shows("trendFacts", Token::secondaryText));
        // Joining, first thought better of, and the end.
        for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Return}) {
            QCOMPARE(tabTo("joinMachinesButton"), QString());
            press(Qt::Key_Return);
            QTRY_VERIFY(QApplication::activeModalWidget());
            QVERIFY(QTest::qWaitForWindowActive(QApplication::activeModalWidget(), patience)); // has the keys
            if (key == Qt::Key_Return)
                press(Qt::Key_Down); // to the other machine
            press(key);
            QTRY_VERIFY(!QApplication::activeModalWidget());
            settle();
            m_window->activateWindow(); // as a window manager does
            QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
            QCOMPARE(machines->model()->rowCount(), key == Qt::Key_Escape ? 2 : 1);
        }
        QTest::keySequence(target(), QKeySequence(QKeySequence::Close));
        QVERIFY(!m_window->isVisible());
    }

    /// A test that the trend shows as another series has that mark in the table, too.
    void theTableHasTheMarksOfTheTrend() {
        Sample sample;
        sample.machine = sample.serial = "Machine 1";
        sample.date = "2022-01-01";
        sample.feed = 500;
        sample.level = 9.9; // readings of its own
        writeFile(folder() + "/slow.palmer", fileOf(sample));
        scan();
        const auto *model = find<QTableView>("tests")->model();
        QCOMPARE(model->rowCount(), 8);
        for (int row = 0; row < model->rowCount(); ++row) {
            const auto mark =
                model->index(row, TestTableModel::markColumn).data(TestTableModel::markRole).toInt();
            const QString date = model->index(row, TestTableModel::dateColumn).data().toString();
            QVERIFY2((static_cast<TrendMark>(mark) == TrendMark::otherSeries) == date.contains("2022"),
                     qPrintable(date));
        }
    }

    void theStatusBarCounts() {
        scan();
        auto *tests = find<QTableView>("tests");
        QCOMPARE(find<QLabel>("shownAndChosen")->text(), QString("7 tests shown"));
        tests->selectRow(0);
        QCOMPARE(find<QLabel>("shownAndChosen")->text(), QString("7 tests shown · 1 chosen"));
        QCOMPARE(find<QLabel>("total")->text(), QString("2 machines · 9 tests"));
    }

    /// What one has chosen stays chosen while other files come in.
    void whatIsChosenStaysChosen() {
        scan();
        auto *tests = find<QTableView>("tests");
        tests->selectRow(3);
        Sample sample;
        sample.machine = "Machine 3";
        sample.serial = "Machine 3";
        writeFile(folder() + "/new.palmer", fileOf(sample));
        m_service->rescan();
        settle();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 3);
        QCOMPARE(selected().size(), 1);
        QCOMPARE(selected().front().row(), 3);
    }

    void vanishedFilesAreTakenOutByHand() {
        scan();
        const QString last = QString("/%1.palmer").arg(m_files);
        QVERIFY(QFile::remove(folder() + last)); // all of machine 2
        m_service->rescan();
        settle();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2);
        auto *troubled = find<QPushButton>("unreadable");
        QVERIFY(troubled->isVisible());
        QCOMPARE(troubled->text(), QString("1 file not found"));
        troubled->click();
        settle();
        auto *dialog = m_window->findChild<TroubledFiles *>();
        QVERIFY(dialog);
        const auto *list = dialog->findChild<QTreeWidget *>("troubledList");
        QCOMPARE(list->topLevelItemCount(), 1);
        QVERIFY(list->topLevelItem(0)->text(0).endsWith(last));
        QCOMPARE(list->topLevelItem(0)->text(1), QString("not found any more"));
        dialog->findChild<QPushButton *>("removeNotFound")->click();
        settle();
        QVERIFY(!troubled->isVisible());
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 1);
    }

    /// Stopped, what was read is there, and nothing goes on by itself; Rescan reads the rest.
    /// The register is an index over its folders: the tests of one that is removed go with it.
    void aFolderThatIsRemovedTakesItsTestsAlong() {
        QTemporaryDir second;
        Sample sample;
        sample.machine = sample.serial = "Machine 3";
        writeFile(second.filePath("third.palmer"), fileOf(sample));
        QVERIFY(QDir(folder()).mkpath("inner"));
        sample.machine = sample.serial = "Machine 4";
        writeFile(folder() + "/inner/fourth.palmer", fileOf(sample));
        const auto rows = [this] { return find<QListView>("machines")->model()->rowCount(); };
        m_window->setFolders({folder(), second.path()});
        QTRY_COMPARE(rows(), 4);
        m_window->setFolders({folder()});
        QTRY_COMPARE(rows(), 3);
        m_window->setFolders({folder() + "/inner"}); // the inner one stays
        QTRY_COMPARE(rows(), 1);
        QTRY_COMPARE(find<QLabel>("machineName")->text(), QString("Machine 4"));
        m_window->setFolders({});
        QTRY_COMPARE(rows(), 0);
        m_window->setFolders({folder()});
        QTRY_COMPARE(rows(), 3);
    }

    void aScanIsStoppedAndGoesOn() {
        for (int i = 0; i < 400; ++i) {
            Sample sample;
            sample.machine = "Many " + std::to_string(i % 20);
            sample.serial = sample.machine;
            sample.date = QDate(2020, 1, 1).addDays(i).toString(Qt::ISODate).toStdString();
            writeFile(folder() + QString("/many%1.palmer").arg(i), fileOf(sample));
        }
        bool shown = false;
        connect(m_service.get(), &RegisterService::progressed, m_window.get(), [&](int done, int total) {
            if (done == total || shown)
                return;
            shown = true;
            QVERIFY(find<QWidget>("scanProgress")->isVisible());
            QVERIFY(find<QLabel>("scanState")->text().startsWith("reading "));
            QVERIFY(find<QPushButton>("stopScan")->isVisible());
            find<QPushButton>("stopScan")->click();
        });
        m_window->setFolders({folder()});
        settle();
        if (!shown)
            QSKIP("all was read in one go");
        QVERIFY(!find<QWidget>("stopScan")->isVisible());
        QVERIFY(!find<QWidget>("scanProgress")->isVisible());
        const int read = m_service->result().tests;
        if (m_service->isStopped()) {
            QVERIFY(find<QLabel>("scanState")->text().endsWith("reading stopped"));
            QVERIFY(read > 0 && read <= 409);
        }
        m_service->rescan();
        settle();
        QVERIFY(!m_service->isStopped());
        QVERIFY(m_service->scannedAt().isValid());
        QCOMPARE(m_service->result().tests, 409);
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 22);
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

    void theCommonTravelIsWhole() {
        for (const char *date : {"2025-05-20", "2026-05-19"}) {
            Sample sample;
            sample.machine = sample.serial = "Q9";
            sample.date = date;
            sample.travel = 720.5;
            writeFile(folder() + QString("/%1.palmer").arg(date), fileOf(sample));
        }
        scan();
        find<QLineEdit>("machineSearch")->setText("Q9");
        settle();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Q9"));
        find<QTableView>("tests")->selectAll();
        m_window->findChild<QAction *>("compareCurves")->trigger();
        const QList<QLabel *> labels = find<CurveComparison>("curveComparison")->findChildren<QLabel *>();
        QVERIFY(std::ranges::any_of(
            labels, [](const QLabel *label) { return label->text() == "common travel 0 to 720.5\u00a0mm"; }));
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
        QTRY_COMPARE(find<QListView>("machines")->model()->rowCount(), 3);
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
        QCOMPARE(opened.front().at(1).toULongLong(), 0ULL);
    }

    void theTestIsOpenedAndNotOnlyItsFile() {
        Sample sample;
        sample.machine = "Machine 9";
        sample.serial = "Machine 9";
        Document document = readDocument(fileOf(sample));
        sample.axis = "Z";
        Test second = *readDocument(fileOf(sample)).tests[0];
        second.id = "second";
        document.tests.push_back(std::make_shared<const Test>(second));
        writeFile(folder() + "/two.palmer", writeDocument(document));
        scan();
        auto *machines = find<QListView>("machines");
        machines->setCurrentIndex(machines->model()->index(2, 0));
        settle();
        choose("filterAxis", "Z");
        QSignalSpy opened(m_window.get(), &RegisterWindow::openAsked);
        auto *tests = find<QTableView>("tests");
        QCOMPARE(tests->model()->rowCount(), 1);
        tests->selectRow(0);
        m_window->findChild<QAction *>("openTest")->trigger();
        QCOMPARE(opened.size(), 1);
        QCOMPARE(opened.front().at(1).toULongLong(), 1ULL);
        // The window of the file shows it, also where the file is open already.
        const QString path = opened.front().front().toString();
        ShownWindow other;
        for (const std::size_t test : {std::size_t(1), std::size_t(0), std::size_t(1)}) {
            other.window->openFile(path, test);
            QTRY_COMPARE(other.window->workplace().selection().test(), test);
        }
        other.window->openFile(path); // as it was looked at
        QCOMPARE(other.window->workplace().selection().test(), std::size_t(1));
    }

    void theTrendIsMaximisedAndRestored() {
        scan();
        auto *button = find<QToolButton>("maximiseTrend");
        const int before = find<TrendChart>("trendChart")->height();
        button->click();
        QCoreApplication::processEvents();
        QVERIFY(!find<QTableView>("tests")->isVisible());
        QVERIFY(!find<QListView>("machines")->isVisible());
        QVERIFY(find<QLabel>("machineName")->isVisible());
        QVERIFY(find<TrendChart>("trendChart")->height() > before + 100);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QCoreApplication::processEvents();
        QVERIFY(find<QTableView>("tests")->isVisible());
        QVERIFY(find<QListView>("machines")->isVisible());
        QCOMPARE(find<TrendChart>("trendChart")->height(), before);
        QVERIFY(!button->isChecked());
    }

    void theMarkTellsTheRole() {
        scan();
        const auto *model = find<QTableView>("tests")->model(); // sorted: through another model
        for (int row = 0; row < model->rowCount(); ++row)
            QCOMPARE(model->index(row, TestTableModel::markColumn).data(TestTableModel::markRole).toInt() ==
                         static_cast<int>(TrendMark::asLeft),
                     model->index(row, TestTableModel::roleColumn).data().toString() == "as left");
        QVERIFY(!find<QLabel>("trendLegend")->text().contains(u'△'));
    }

    /// Neither as found nor as left: a mark of its own, in table, trend and legend.
    void aTestWithoutRoleHasAMarkOfItsOwn() {
        Sample sample;
        sample.machine = sample.serial = "Machine 0";
        sample.role = "notStated";
        writeFile(folder() + "/alone.palmer", fileOf(sample));
        scan();
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 0"));
        QCOMPARE(find<QTableView>("tests")
                     ->model()
                     ->index(0, TestTableModel::markColumn)
                     .data(TestTableModel::markRole)
                     .toInt(),
                 static_cast<int>(TrendMark::noRole));
        QCOMPARE(find<TrendChart>("trendChart")->panel().values.front().mark, TrendMark::noRole);
        QVERIFY(find<QLabel>("trendLegend")->text().contains(u'△'));
        QCOMPARE(find<QLabel>("shownCount")->text(), QString("1 of 1 test"));
        setWindowLanguage(Language::Id::french);
        QCoreApplication::processEvents();
        QCOMPARE(find<QLabel>("shownCount")->text(), QString("1 sur 1 essai"));
    }

    /// What stands at the right is a machine of the list.
    void theRightSideIsOfTheList() {
        for (int i = 1; i <= m_files; ++i)
            QFile::remove(folder() + QString("/%1.palmer").arg(i));
        for (const auto &[machine, level] : {std::pair("Fine", 3.0), std::pair("Late", 40.0)}) {
            Sample sample;
            sample.machine = sample.serial = machine;
            sample.level = level;
            writeFile(folder() + QString("/%1.palmer").arg(machine), fileOf(sample));
        }
        scan();
        auto *machines = find<QListView>("machines");
        const auto *name = find<QLabel>("machineName");
        QCOMPARE(name->text(), QString("Fine"));
        find<QToolButton>("machinesToDo")->click();
        settle();
        QCOMPARE(machines->model()->rowCount(), 1);
        QCOMPARE(name->text(), QString("Late"));
        QTest::keyClicks(find<QLineEdit>("machineSearch"), "nowhere");
        settle();
        QCOMPARE(machines->model()->rowCount(), 0);
        QCOMPARE(name->text(), QString());
        QCOMPARE(find<QTableView>("tests")->model()->rowCount(), 0);
        find<QLineEdit>("machineSearch")->clear();
        settle();
        QCOMPARE(name->text(), QString("Late"));
    }

    void numbersFitInAllUnits_data() {
        QTest::addColumn<DisplayUnits>("units");
        QTest::addColumn<bool>("rotary");
        for (const bool rotary : {false, true}) {
            for (const auto &[name, lengths, angles] :
                 {std::tuple("usual", LengthDisplay::micrometres, AngleDisplay::arcSeconds),
                  std::tuple("mm, degrees", LengthDisplay::millimetres, AngleDisplay::degrees),
                  std::tuple("inches", LengthDisplay::inches, AngleDisplay::arcSeconds)})
                QTest::newRow(qPrintable(QString("%1, %2").arg(name, rotary ? "rotary" : "linear")))
                    << DisplayUnits{lengths, angles} << rotary;
        }
    }
    /// A number that is cut is another number: in the table, at the axes and in the facts.
    void numbersFitInAllUnits() {
        QFETCH(DisplayUnits, units);
        QFETCH(bool, rotary);
        if (rotary)
            QVERIFY(QFile::copy(EXAMPLES "rotary-axis.palmer", folder() + "/rotary.palmer"));
        setWindowUnits(units);
        const auto restored = qScopeGuard([] { setWindowUnits({}); });
        scan();
        if (rotary) {
            auto *machines = find<QListView>("machines");
            for (int row = 0; row < machines->model()->rowCount(); ++row) {
                machines->setCurrentIndex(machines->model()->index(row, 0));
                settle();
                if (find<TrendChart>("trendChart")->trend().angular)
                    break;
            }
            QVERIFY(find<TrendChart>("trendChart")->trend().angular);
        }
        auto *tests = find<QTableView>("tests");
        const QFontMetrics base(themeFont(palmer::ui::TextSize::base));
        const QFontMetrics small(themeFont(palmer::ui::TextSize::small));
        for (int column = TestTableModel::firstResult; column < tests->model()->columnCount() - 2; ++column) {
            for (int row = 0; row < tests->model()->rowCount() && !tests->isColumnHidden(column); ++row) {
                const QModelIndex cell = tests->model()->index(row, column);
                const QString value = cell.data().toString();
                const QString u = cell.data(TestTableModel::uncertaintyRole).toString();
                const int wanted = base.horizontalAdvance(value) + small.horizontalAdvance(u);
                QVERIFY2(wanted + valueGap + 2 * resultPadding <= tests->columnWidth(column),
                         qPrintable(value + " ± " + u));
            }
        }
        auto *chart = find<TrendChart>("trendChart");
        chart->grab(); // lays it out
        QStringList drawn;
        for (const QGraphicsItem *item : chart->scene()->items()) {
            const auto *label = qgraphicsitem_cast<const QGraphicsTextItem *>(item);
            if (!label || !label->isVisible() || label->toPlainText().isEmpty())
                continue;
            drawn << label->toPlainText();
            QVERIFY2(chart->sceneRect().contains(label->sceneBoundingRect().center()),
                     qPrintable(label->toPlainText()));
            QVERIFY2(label->sceneBoundingRect().left() >= -4, qPrintable(label->toPlainText()));
        }
        QVERIFY(!chart->panel().x.ticks.empty()); // also of a few months
        for (const Tick &tick : chart->panel().y.ticks)
            QVERIFY2(drawn.contains(tick.label), qPrintable(tick.label + " of " + drawn.join(' ')));
        QCOMPARE(QSet<QString>(drawn.begin(), drawn.end()).size(), drawn.size()); // no two are alike
        QTextDocument facts;
        facts.setDefaultFont(find<QLabel>("trendFacts")->font());
        facts.setHtml(find<QLabel>("trendFacts")->text());
        facts.setTextWidth(find<QLabel>("trendFacts")->contentsRect().width());
        QVERIFY2(facts.size().width() <= find<QLabel>("trendFacts")->contentsRect().width() + 0.5,
                 qPrintable(QString::number(facts.size().width())));
    }

    /// Lengths and angles in one column have their units at the numbers, and are sorted apart.
    void lengthsBesideAnglesSayTheirUnits() {
        const auto listed = [](const std::string &axis, bool angular, double value) {
            ListedTest one;
            one.test.axis = axis;
            one.test.angular = angular;
            RegisteredResult result;
            result.id = "A";
            result.value = value;
            one.test.results = {result};
            return one;
        };
        const auto heading = [](const TestTableModel &model) {
            return model.headerData(TestTableModel::firstResult, Qt::Horizontal, Qt::DisplayRole).toString();
        };
        const auto cell = [](const TestTableModel &model, int row, int role) {
            return model.index(row, TestTableModel::firstResult).data(role);
        };
        TestTableModel model;
        model.setTests({listed("X", false, 0.0088), listed("C", true, 0.002)}); // newest first
        QVERIFY2(!heading(model).contains(u'µ') && !heading(model).contains(u'″'),
                 qPrintable(heading(model)));
        QVERIFY(cell(model, 0, Qt::DisplayRole).toString().endsWith(u'″'));
        QVERIFY(cell(model, 1, Qt::DisplayRole).toString().endsWith("µm"));
        QVERIFY(cell(model, 0, TestTableModel::sortRole).toDouble() >
                cell(model, 1, TestTableModel::sortRole).toDouble());
        model.setTests({listed("X", false, 0.0088)});
        QVERIFY(heading(model).contains("µm"));
        QVERIFY(!cell(model, 0, Qt::DisplayRole).toString().contains("µm"));
    }

    void aMachineWithoutNameSaysSo() { QCOMPARE(MachineRow().title(), QString("without name")); }

    void theAxesOfCurvesSayTheirUnits() {
        scan();
        m_window->resize(1366, 768);
        auto *tests = find<QTableView>("tests");
        QItemSelection some;
        for (const int row : {0, 5})
            some.select(tests->model()->index(row, 0), tests->model()->index(row, 5));
        tests->selectionModel()->select(some,
                                        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        m_window->findChild<QAction *>("compareCurves")->trigger();
        QCoreApplication::processEvents();
        // Whole rows of the list, all of two tests, and nothing to be scrolled aside.
        const auto *list = find<QLabel>("curveList");
        QVERIFY(list->parentWidget()->height() >= list->sizeHint().height());
        QVERIFY2(
            list->sizeHint().width() <= list->parentWidget()->width(),
            qPrintable(QString("%1 of %2").arg(list->sizeHint().width()).arg(list->parentWidget()->width())));
        auto *difference = find<TaggedChart>("curveDifference");
        QCOMPARE(difference->chart()->axes(Qt::Horizontal).front()->titleText(), QString("P mm"));
        difference->grab();
        bool anyBelow = false;
        for (const QGraphicsItem *item : difference->scene()->items()) {
            const auto *label = qgraphicsitem_cast<const QGraphicsTextItem *>(item);
            const QString text = label ? label->toPlainText() : QString();
            QVERIFY2(!text.startsWith('-'), qPrintable(text)); // a hyphen is no minus
            anyBelow = anyBelow || text.startsWith(u'−');
        }
        QVERIFY(anyBelow);
        const int before = find<TrendChart>("trendChart")->height();
        find<QToolButton>("closeComparison")->click();
        QCoreApplication::processEvents();
        QVERIFY(find<TrendChart>("trendChart")->height() <= before);
    }

    void theListIsWiderInAVeryWideWindow() {
        scan();
        auto *machines = find<QListView>("machines");
        m_window->resize(1280, 800);
        QCoreApplication::processEvents();
        QCOMPARE(machines->width(), 248);
        m_window->resize(1600, 900);
        QCoreApplication::processEvents();
        QCOMPARE(machines->width(), 264);
        m_window->resize(1599, 900);
        QCoreApplication::processEvents();
        QCOMPARE(machines->width(), 248);
    }

    void allCurvesAreNamed() {
        scan();
        m_window->resize(1600, 1000);
        auto *tests = find<QTableView>("tests");
        QItemSelection some;
        for (const int row : {0, 1, 2})
            some.select(tests->model()->index(row, 0), tests->model()->index(row, 5));
        tests->selectionModel()->select(some,
                                        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        m_window->findChild<QAction *>("compareCurves")->trigger();
        QCoreApplication::processEvents();
        const auto *list = find<QLabel>("curveList");
        QVERIFY2(list->parentWidget()->height() >= list->sizeHint().height(),
                 qPrintable(QString::number(list->parentWidget()->height())));
    }

    void numbersOfCurvesKeepApart() {
        scan();
        auto *tests = find<QTableView>("tests");
        QItemSelection some;
        for (const int row : {0, 1, 2, 3}) // much alike: their ends stand close
            some.select(tests->model()->index(row, 0),
                        tests->model()->index(row, tests->model()->columnCount() - 1));
        tests->selectionModel()->select(some, QItemSelectionModel::ClearAndSelect);
        m_window->findChild<QAction *>("compareCurves")->trigger();
        auto *curves = find<TaggedChart>("curves");
        curves->grab(); // lays it out
        const std::vector<QPointF> places = curves->tagPlaces();
        QCOMPARE(places.size(), std::size_t(4));
        std::vector<double> heights;
        for (const QPointF &place : places) {
            QVERIFY(place.x() > curves->chart()->plotArea().right());
            QVERIFY(place.x() + tagRadius <= curves->width());
            heights.push_back(place.y());
        }
        std::ranges::sort(heights);
        for (std::size_t i = 1; i < heights.size(); ++i)
            QVERIFY2(heights[i] - heights[i - 1] >= leastTagDistance - 1e-9, qPrintable(QString::number(i)));
        QVERIFY(find<TaggedChart>("curveDifference")->box().contains("µm"));
    }

    void lowChartsCutNoLabelsOff() {
        scan();
        m_window->resize(1100, 560);
        auto *tests = find<QTableView>("tests");
        QItemSelection both;
        for (const int row : {0, 1})
            both.select(tests->model()->index(row, 0),
                        tests->model()->index(row, tests->model()->columnCount() - 1));
        tests->selectionModel()->select(both, QItemSelectionModel::ClearAndSelect);
        m_window->findChild<QAction *>("compareCurves")->trigger();
        QCoreApplication::processEvents();
        for (const char *name : {"trendChart", "curves", "curveDifference"}) {
            auto *chart = find<QChartView>(name);
            for (const int height : {120, 135, 150, 180}) {
                chart->resize(chart->width(), height);
                chart->grab(); // lays it out
                for (const QGraphicsItem *item : chart->scene()->items()) {
                    const auto *label = qgraphicsitem_cast<const QGraphicsTextItem *>(item);
                    const QString text = label ? label->toPlainText() : QString();
                    QVERIFY2(!text.contains("...") && !text.contains(u'…'),
                             qPrintable(QString("%1 at %2: %3").arg(name).arg(height).arg(text)));
                }
            }
        }
    }

    void allColumnsFindRoom() {
        scan();
        auto *tests = find<QTableView>("tests");
        for (const int width : {1024, 1280, 1600, 1024}) {
            setWindowLanguage(width == 1024 ? Language::Id::french : Language::Id::english);
            m_window->resize(width, 768);
            QCoreApplication::processEvents();
            int used = 0;
            for (int column = 0; column < tests->model()->columnCount(); ++column)
                used += tests->isColumnHidden(column) ? 0 : tests->columnWidth(column);
            QVERIFY2(
                used <= tests->viewport()->width() + 1,
                qPrintable(QString("%1: %2 of %3").arg(width).arg(used).arg(tests->viewport()->width())));
            QVERIFY(!tests->isColumnHidden(tests->model()->columnCount() - 2)); // the verdict
            QCOMPARE(tests->isColumnHidden(tests->model()->columnCount() - 1), tests->width() < 1000);
            QVERIFY(!tests->isColumnHidden(TestTableModel::firstResult));
            const QModelIndex date = tests->model()->index(0, TestTableModel::dateColumn);
            QVERIFY(tests->fontMetrics().horizontalAdvance(date.data().toString()) <
                    tests->columnWidth(TestTableModel::dateColumn));
            QVERIFY(!date.data(TestTableModel::iconRole).isValid()); // it would be cut for a mark
        }
    }

    void foldersInTheSettings() {
        QTemporaryDir second;
        m_service->setFolders({folder(), second.path()});
        RegisterSettings settings(*m_service);
        QVERIFY(settings.findChild<QLabel *>("registerIndex")->text().contains(m_service->address()));
        auto *list = settings.findChild<QListWidget *>("folders");
        QCOMPARE(list->count(), 2);
        list->setCurrentRow(1);
        settings.findChild<QPushButton *>("removeFolder")->click();
        QCOMPARE(m_service->folders(), QStringList(folder()));
        settings.findChild<FolderList *>()->addFolder(second.path());
        QCOMPARE(m_service->folders(), (QStringList{folder(), second.path()}));
        settle();
    }

    void aServerThatIsNotThereChangesNothing_data() {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("password");
        QTest::newRow("nobody listens") << "postgresql://someone@127.0.0.1:1/tests"
                                        << "s3cret";
        QTest::newRow("password in the address") << "postgresql://someone:s3cret@127.0.0.1:1/tests"
                                                 << "";
        QTest::newRow("a # in it") << "postgresql://someone:x#s3cret@127.0.0.1:1/tests"
                                   << "";
        QTest::newRow("no name") << "postgresql://someone@127.0.0.1:1"
                                 << "s3cret";
        QTest::newRow("another scheme") << "mysql://someone@127.0.0.1/tests"
                                        << "s3cret";
    }
    void aServerThatIsNotThereChangesNothing() {
        QFETCH(QString, address);
        QFETCH(QString, password);
        const QString before = m_service->address();
        RegisterSettings settings(*m_service);
        auto *place = settings.findChild<QComboBox *>("registerPlace");
        place->setCurrentIndex(1);
        emit place->activated(1);
        settings.findChild<QLineEdit *>("registerServer")->setText(address);
        settings.findChild<QLineEdit *>("registerPassword")->setText(password);
        settings.findChild<QPushButton *>("registerConnect")->click();
        QTRY_VERIFY(!settings.isBusy());
        const QString said = settings.findChild<QLabel *>("registerOutcome")->text();
        QVERIFY(!said.isEmpty() && !said.contains(u'\n'));
        QVERIFY2(!said.contains("s3cret"), qPrintable(said));
        QCOMPARE(m_service->address(), before);
    }

    void theRegisterMovesToAnotherPlace() {
        scan();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2);
        const QString other = m_dir->filePath("other.sqlite");
        QSignalSpy changed(m_service.get(), &RegisterService::changed);
        m_service->setAddress(other);
        QCOMPARE(m_service->address(), other);
        QTRY_VERIFY(m_service->scannedAt().isValid());
        settle();
        QVERIFY(!changed.isEmpty());
        QVERIFY(QFileInfo::exists(other));
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2); // made anew from the files
    }

    void aServerThatIsThereKeepsTheRegister() {
        const testdata::PostgresqlServer server;
        if (!server.problem().isEmpty())
            QSKIP(qPrintable("no PostgreSQL server to try with: " + server.problem()));
        scan();
        {
            RegisterSettings settings(*m_service);
            settings.findChild<QLineEdit *>("registerServer")->setText(server.address());
            settings.findChild<QLineEdit *>("registerPassword")
                ->setText("s3cret"); // which it does not ask for
            settings.findChild<QPushButton *>("registerConnect")->click();
            QTRY_VERIFY(!settings.isBusy());
            QVERIFY2(m_service->address().startsWith("postgresql://"),
                     qPrintable(settings.findChild<QLabel *>("registerOutcome")->text()));
            QVERIFY(!settings.findChild<QLabel *>("registerIndex")->text().contains("s3cret"));
            QVERIFY(!settings.findChild<QLineEdit *>("registerServer")->text().contains("s3cret"));
        }
        QTRY_VERIFY(m_service->scannedAt().isValid());
        settle();
        QCOMPARE(find<QListView>("machines")->model()->rowCount(), 2);
        QCOMPARE(find<QLabel>("machineName")->text(), QString("Machine 1"));
        m_window.reset(); // before the server goes
        m_service.reset();
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
            reg.database().execute("delete from register where name like 'machines in %'");
            reg.finish();
        }
        m_service->rescan();
        settle();
        QCOMPARE(find<QComboBox>("interval")->currentData().toInt(), 6);
    }

    void unreadableFilesAreNamed() {
        writeFile(folder() + "/broken.palmer", "{");
        scan();
        QVERIFY(find<QPushButton>("unreadable")->isVisible());
        QVERIFY(find<QPushButton>("unreadable")->toolTip().contains("broken.palmer"));
        m_window->findChild<QAction *>("troubledFiles")->trigger();
        settle();
        auto *dialog = m_window->findChild<TroubledFiles *>();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(!dialog->findChild<QPushButton *>("removeNotFound")->isEnabled());
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
        QTRY_VERIFY(m_window->isQuiet());
        QCoreApplication::processEvents();
        QTRY_VERIFY(m_window->isQuiet());
    }
    void scan() {
        m_window->setFolders({folder()});
        QTRY_VERIFY(m_service->scannedAt().isValid());
        settle();
    }
    void choose(const char *filter, const QString &word) {
        auto *menu = find<FilterChip>(filter)->menu();
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
