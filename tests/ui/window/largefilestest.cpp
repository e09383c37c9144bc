// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/kernel/evaluation/circulardata.h"
#include "ui/window/shownwindow.h"

#include "document/savedocument.h"
#include "document/windowthread.h"
#include "ui/comparison/comparisonpage.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/import/importassistant.h"
#include "ui/workbar.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <csignal>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

using namespace palmer;
using namespace palmer::ui;

namespace {

constexpr int targets = 400;
constexpr int largeRuns = 100; ///< each way

double deviationOf(int target, int run, bool up) { // µm
    return 0.01 * target + 0.1 * (run % 7) + (up ? 0 : 2);
}

QByteArray largeTable() {
    QByteArray text = "P mm";
    for (int j = 1; j <= largeRuns; ++j)
        text += QString(";%1 ↑ µm;%1 ↓ µm").arg(j).toUtf8();
    text += '\n';
    for (int i = 0; i < targets; ++i) {
        text += QByteArray::number(i);
        for (int j = 0; j < largeRuns; ++j)
            for (const bool up : {true, false})
                text += ';' + QByteArray::number(deviationOf(i, j, up), 'f', 2);
        text += '\n';
    }
    return text;
}

Document largeDocument(int runs = largeRuns) {
    PositioningMeasurement measurement;
    for (int i = 0; i < targets; ++i)
        measurement.targets.push_back(i);
    for (int j = 0; j < runs; ++j) {
        for (const bool up : {true, false}) {
            Run run;
            run.approach = up ? Direction::positive : Direction::negative;
            for (int i = 0; i < targets; ++i)
                run.deviations.push_back(deviationOf(i, j, up) / 1000);
            measurement.runs.push_back(std::move(run));
        }
    }
    Test test;
    test.id = "large";
    test.edition = "ISO 230-2:2014";
    test.measurement = std::move(measurement);
    Document document;
    document.tests = {std::make_shared<const Test>(std::move(test))};
    return document;
}

} // namespace

/// Files that take longer to read than a window may stand still.
class LargeFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        prepareApplication();
        QVERIFY(m_folder.isValid());
        QFile file(table());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(largeTable());
        file.close();
        QVERIFY(isLargeFile(QFileInfo(table()).size()));
        QFile small(smallTable());
        QVERIFY(small.open(QIODevice::WriteOnly));
        small.write("P mm;1 ↑ µm;1 ↓ µm\n0;1,0;2,0\n100;3,0;4,0\n");
        small.close();
        saveDocument(largeDocument(), document());
        QVERIFY(isLargeFile(QFileInfo(document()).size()));
    }
    void init() { setWindowLanguage(Language::Id::english); }

    void measurementsAreReadBesideTheWindow() {
        const WindowThread thisThread;
        const ShownWindow shown;
        shown.window->importFiles({table()});
        QVERIFY(!assistantOf(shown)); // not yet
        QVERIFY(shown.find<QLabel>("statusState")->text().contains("large.csv"));
        QVERIFY(!shown.find("workBar")->isVisible()); // nor does anything blink
        QTRY_VERIFY(assistantOf(shown));
        QCOMPARE(shown.find<QLabel>("statusState")->text().contains("large.csv"), false);
        const Imported &imported = assistantOf(shown)->imported();
        const auto &measurement = std::get<PositioningMeasurement>(imported.test->measurement);
        QCOMPARE(measurement.targets.size(), std::size_t{targets});
        QCOMPARE(measurement.runs.size(), std::size_t{2 * largeRuns});
        QVERIFY(std::abs(*measurement.runs[3].deviations[7] - deviationOf(7, 1, false) / 1000) < 1e-9);
    }

    void whatTakesLongHasABarWithCancel() {
        WorkBar bar;
        bar.begin("reading");
        QVERIFY(!bar.isVisible());
        QTRY_VERIFY(bar.isVisible());
        bar.end();
        QVERIFY(!bar.isVisible());
        bar.begin("reading");
        bar.end(); // done at once: it never appears
        QTest::qWait(400);
        QVERIFY(!bar.isVisible());
    }

    void whatIsDoneIsCounted() {
        const auto progress = std::make_shared<ReadProgress>();
        WorkBar bar;
        const auto *count = bar.findChild<QLabel *>("workCount");
        const auto *strip = bar.findChild<QProgressBar *>();
        bar.begin("reading", progress);
        QTRY_VERIFY(bar.isVisible());
        QVERIFY(!count->isVisible()); // of how much is not known yet
        QCOMPARE(strip->maximum(), 0);
        progress->of = 66 << 20;
        progress->done = 33 << 19;
        QTRY_COMPARE(count->text(), QString("16.5 of 66.0 MiB"));
        QVERIFY(count->isVisible());
        QCOMPARE(4 * strip->value(), strip->maximum());
        setWindowLanguage(Language::Id::french);
        QTRY_COMPARE(count->text(), QString("16,5 sur 66,0\u00A0Mio"));
        setWindowLanguage(Language::Id::english);
        progress->done = 66 << 20; // all is read and not yet understood
        QTRY_COMPARE(count->text(), QString("66.0 of 66.0 MiB"));
        QCOMPARE(strip->maximum(), 0);
        progress->unit = ReadProgress::Unit::trials;
        progress->of = 0;
        progress->done = 900;
        QTRY_COMPARE(count->text(), QString("900 trials"));
        progress->of = 990;
        QTRY_COMPARE(count->text(), QString("900 of 990 trials"));
        bar.end();
        bar.begin("importing");
        QVERIFY(!count->isVisibleTo(&bar)); // of another work
    }

    /// Whether it is a test file is looked for beside the window, too.
    void aLargeMeasurementThatIsOpenedIsImported() {
        const ShownWindow shown;
        shown.window->openFile(table());
        QVERIFY(!assistantOf(shown)); // not yet
        QVERIFY(shown.find<QLabel>("statusState")->text().contains("large.csv"));
        QTRY_VERIFY(assistantOf(shown));
        QVERIFY(!shown.window->hasDocument());
    }

    void cancelledMeasurementsNeverCome() {
        const ShownWindow shown;
        shown.window->importFiles({table(), table()});
        shown.find<QPushButton>("cancelWork")->click();
        QVERIFY(!shown.find<QLabel>("statusState")->text().contains("large.csv"));
        // Behind what was cancelled: when this is there, the other would have been.
        shown.window->openFile(document());
        QTRY_VERIFY(shown.window->hasDocument());
        QVERIFY(!assistantOf(shown));
        QCOMPARE(shown.window->model().document()->tests.size(), std::size_t{1});
        shown.window->importFiles({smallTable()});
        QTRY_VERIFY(assistantOf(shown));
        QCOMPARE(
            std::get<PositioningMeasurement>(assistantOf(shown)->imported().test->measurement).targets.size(),
            std::size_t{2});
    }

    void aCancelledFileIsNotOpened() {
        const ShownWindow shown;
        shown.window->openFile(document());
        QVERIFY(!shown.window->hasDocument());
        QVERIFY(shown.find<QLabel>("statusState")->text().contains("large.palmer"));
        shown.find<QPushButton>("cancelWork")->click();
        shown.window->importFiles({table()}); // behind it
        QTRY_VERIFY(assistantOf(shown));
        QVERIFY(!shown.window->hasDocument());
        // And it can be opened again.
        assistantOf(shown)->reject();
        shown.window->openFile(document());
        QTRY_VERIFY(shown.window->hasDocument());
    }

    /// And not in the turn in which the file comes: here it never does.
    void pagesAreMadeWhileAFileIsRead() {
        const ShownWindow shown;
        QVERIFY(!shown.window->findChild<Workplace *>());
        shown.window->openFile(document());
        QVERIFY(!shown.window->findChild<Workplace *>());
        shown.find<QPushButton>("cancelWork")->click();
        QTRY_VERIFY(shown.window->findChild<Workplace *>());
        QVERIFY(!shown.window->hasDocument());
    }

    void filesComeInTheirOrder() {
        const WindowThread thisThread;
        const ShownWindow shown;
        shown.window->importFiles({table(), smallTable()});
        QTRY_VERIFY(assistantOf(shown));
        QCOMPARE(
            std::get<PositioningMeasurement>(assistantOf(shown)->imported().test->measurement).targets.size(),
            std::size_t{targets});
        assistantOf(shown)->reject();
        QTRY_VERIFY(assistantOf(shown) &&
                    std::get<PositioningMeasurement>(assistantOf(shown)->imported().test->measurement)
                            .targets.size() == 2);
    }

    void theWindowGoesWhileItReads() {
        const WindowThread thisThread;
        const ShownWindow shown;
        shown.window->importFiles({table()});
        shown.window->openFile(document());
    }

    void anotherChoiceIsReadBesideTheAssistant() {
        ImportAssistant dialog(largeTable(), "large.csv", nullptr);
        const auto first = [&] {
            return *std::get<PositioningMeasurement>(dialog.imported().test->measurement)
                        .runs[1]
                        .deviations[0];
        };
        const double before = first();
        dialog.choose("unit", "mm");
        QCOMPARE(first(), before); // as it was, until it is read
        QVERIFY(!dialog.findChild<QPushButton *>("acceptImport")->isEnabled());
        QTRY_VERIFY(std::abs(first() - 1000 * before) < 1e-9);
    }

    void aLargeMeasurementIsTakenBesideTheWindow() {
        ImportAssistant dialog(largeTable(), "large.csv", nullptr);
        dialog.show();
        const auto *import = dialog.findChild<QPushButton *>("acceptImport");
        for (int i = 0; i < 5 && !import->isEnabled(); ++i) { // an answer may raise the next question
            dialog.confirmAll();
            QTest::qWait(1);
            QTRY_VERIFY(import->isEnabled() || !dialog.imported().questions.empty());
        }
        QTRY_VERIFY(import->isEnabled());
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected)); // not yet
        QVERIFY(dialog.isVisible() && !import->isEnabled());
        dialog.findChild<QPushButton *>("cancelWork")->click();
        QVERIFY(dialog.isVisible() && import->isEnabled()); // all as it was
        dialog.accept();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        Document first;
        dialog.addTo(first);
        QCOMPARE(first.tests.size(), std::size_t{1});
        QVERIFY(first.tests[0]->measurement == dialog.imported().test->measurement);
        QVERIFY(!first.tests[0]->imports.empty());
        Document second;
        dialog.addTo(second);
        QCOMPARE(second.tests[0], first.tests[0]); // nothing is copied on the thread of the window
        Document other = largeDocument();
        dialog.addTo(other); // another than it was accepted for
        QCOMPARE(other.tests.size(), std::size_t{2});
    }

    void aCancelledChoiceIsAsItWas() {
        ImportAssistant dialog(largeTable(), "large.csv", nullptr);
        auto *unit = dialog.findChild<QComboBox *>("import.unit");
        QVERIFY(unit);
        const int before = unit->currentIndex();
        const int other = unit->findData("mm");
        QVERIFY(other >= 0 && other != before);
        unit->setCurrentIndex(other);
        emit unit->activated(other);
        dialog.findChild<QPushButton *>("cancelWork")->click();
        QCOMPARE(dialog.findChild<QComboBox *>("import.unit")->currentIndex(), before);
        dialog.choose("sign", "targetMinusActual"); // behind it
        const auto first = [&] {
            return *std::get<PositioningMeasurement>(dialog.imported().test->measurement)
                        .runs[1]
                        .deviations[0];
        };
        QTRY_VERIFY(first() < 0);
        QVERIFY(std::abs(first() + deviationOf(0, 0, false) / 1000) < 1e-9); // still µm
    }

    void longWorkOnTheThreadOfTheWindowIsNoticed() {
        QVERIFY(!isEndedBy([] { requireBackground(fewReadings + 1); }));
        const WindowThread thisThread;
        QVERIFY(!isEndedBy([] { requireBackground(fewReadings); }));
        QVERIFY(isEndedBy([] { requireBackground(fewReadings + 1); }));
        QVERIFY(isEndedBy([] { requireBackground(largeDocument()); }));
    }

    /// Whatever is chosen of the menus, and all that follows until what opened is closed: the assertion of
    /// requireBackground() would end this program.
    void nothingOfTheMenusIsLongWorkOnTheThreadOfTheWindow_data() {
        QTest::addColumn<palmer::Test>("test");
        QTest::newRow("axis") << *largeDocument(30).tests[0];
        QTest::newRow("circle") << testdata::longPair(6000);
    }
    void nothingOfTheMenusIsLongWorkOnTheThreadOfTheWindow() {
        QFETCH(palmer::Test, test);
        Document document;
        document.tests = {std::make_shared<const palmer::Test>(test)};
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        const QString path = m_folder.filePath("menus.palmer");
        saveDocument(document, path);
        const WindowThread thisThread;
        const ShownWindow shown(path);
        QTRY_VERIFY(shown.window->hasDocument());
        const auto rest = [&] {
            do {
                QTest::qWait(1);
            } while (shown.window->evaluator().isBusy() || closeWhatIsOpen(*shown.window));
        };
        QTimer modal;
        connect(&modal, &QTimer::timeout, this, [&] {
            if (QApplication::activeModalWidget())
                closeWhatIsOpen(*shown.window);
        });
        modal.start(30);
        auto *undo = shown.window->findChild<QAction *>("undo");
        int tried = 0;
        for (QAction *action : shown.window->findChildren<QAction *>()) {
            const QString name = action->objectName();
            if (name.isEmpty() || action->menu() || name == "quit" || name == "close")
                continue;
            shown.window->model().edit("title", [](Document &changed) {
                auto edited = std::make_shared<palmer::Test>(*changed.tests[0]);
                edited->title += ".";
                changed.tests[0] = std::move(edited);
            });
            rest();
            if (!action->isEnabled())
                continue;
            action->trigger();
            ++tried;
            rest();
            while (undo->isEnabled())
                undo->trigger();
            rest();
        }
        QVERIFY(tried > 50);
        QVERIFY(QFile(path).size() > 0);
    }

    void otherFilesAreComparedBesideTheWindow() {
        const WindowThread thisThread;
        const ShownWindow shown(document());
        QTRY_VERIFY(shown.window->hasDocument());
        CompareDialog dialog(shown.window->evaluator().current(), 0);
        QVERIFY(dialog.addFile(document()));
        ComparisonPage page(shown.window->model());
        QVERIFY(!page.addFile(m_folder.filePath("none.palmer")));
    }

private:
    /// True if the function ends the program that runs it: another one, made for it.
    static bool isEndedBy(const std::function<void()> &work) {
        const pid_t child = fork();
        if (child == 0) {
            std::signal(SIGABRT, SIG_DFL);
            close(STDERR_FILENO); // what abort() says is not about this program
            work();
            _exit(0);
        }
        int state = 0;
        return child < 0 || waitpid(child, &state, 0) != child || !WIFEXITED(state);
    }

    /// Closes the dialogs and windows but that one; false if there are none.
    static bool closeWhatIsOpen(const MainWindow &kept) {
        bool any = false;
        for (QWidget *widget : QApplication::topLevelWidgets()) {
            if (widget == &kept || !widget->isVisible())
                continue;
            widget->close();
            any = true;
        }
        return any;
    }

    static ImportAssistant *assistantOf(const ShownWindow &shown) {
        for (auto *assistant : shown.window->findChildren<ImportAssistant *>())
            if (assistant->isVisible())
                return assistant;
        return nullptr;
    }
    [[nodiscard]] QString table() const { return m_folder.filePath("large.csv"); }
    [[nodiscard]] QString smallTable() const { return m_folder.filePath("small.csv"); }
    [[nodiscard]] QString document() const { return m_folder.filePath("large.palmer"); }

    QTemporaryDir m_folder;
};

QTEST_MAIN(LargeFilesTest)
#include "largefilestest.moc"
