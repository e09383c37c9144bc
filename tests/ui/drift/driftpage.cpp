// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/drift/driftpage.h"
#include "ui/drift/driftmodel.h"
#include "ui/figures/figureview.h"
#include "ui/navigation/navigationlist.h"
#include "ui/window/pagetabs.h"
#include "ui/window/shownwindow.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;

namespace {

Document withDrift() {
    Test drift;
    drift.id = "d1";
    drift.title = "at rest";
    DriftMeasurement readings;
    readings.axis.name = "X";
    readings.times = {0, 60, 120};
    readings.deviations = {0.0, 0.0032, 0.001};
    drift.measurement = readings;
    Test positioning;
    positioning.id = "x1";
    positioning.edition = "ISO 230-2:2006";
    PositioningMeasurement measurement;
    measurement.axis.name = "X";
    measurement.targets = {0, 100};
    measurement.runs = {{Direction::positive, {0.001, 0.002}}};
    measurement.uncertainty.driftTest = "d1";
    positioning.measurement = measurement;
    Document document;
    document.tests.push_back(std::make_shared<const Test>(positioning));
    document.tests.push_back(std::make_shared<const Test>(drift));
    return document;
}

/// The page that edits a document, as in a window.
struct Edited {
    explicit Edited(Document document = withDrift())
        : page(model, selection) {
        QObject::connect(&model, &DocumentModel::changed, &page,
                         [this] { page.show(evaluate(model.document()), 1); });
        model.setDocument(std::move(document), {});
        page.resize(500, 500);
        page.QWidget::show();
        table = page.findChild<QTableView *>("driftReadings");
    }
    const DriftMeasurement &drift() {
        return std::get<DriftMeasurement>(model.document()->tests[1]->measurement);
    }
    QString label(const char *name) { return page.findChild<QLabel *>(name)->text(); }
    bool enter(int row, int column, const QString &text) {
        return table->model()->setData(table->model()->index(row, column), text, Qt::EditRole);
    }

    DocumentModel model;
    Selection selection;
    DriftPage page;
    QTableView *table = nullptr;
};

} // namespace

/// The page of a drift test, and the window around it.
class DriftPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        prepareApplication();
        setWindowLanguage(Language::Id::english);
    }

    void showsTheRangeAndWhoTakesIt() {
        Edited edited;
        QVERIFY2(edited.label("driftRange").contains("3.20"), qPrintable(edited.label("driftRange")));
        QVERIFY(edited.label("driftTakenBy").contains("X axis"));
        QCOMPARE(edited.table->model()->rowCount(), 4); // and one for the next reading
        QCOMPARE(edited.table->model()->index(1, 1).data().toString(), QString("3.2"));
    }

    void theModelIsWellBehaved() {
        Edited edited;
        QAbstractItemModelTester tester(edited.table->model(),
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
        edited.enter(1, 1, "5");
        edited.enter(3, 0, "180");
        edited.enter(3, 1, "1");
        QCOMPARE(edited.table->model()->rowCount(), 5);
    }

    void aReadingIsChangedAndUndone() {
        Edited edited;
        QVERIFY(edited.enter(1, 1, "5,4"));
        QCOMPARE(edited.drift().deviations[1], 0.0054);
        QVERIFY(edited.label("driftRange").contains("5.40"));
        edited.model.undoStack()->undo();
        QCOMPARE(edited.drift().deviations[1], 0.0032);
    }

    void aNewReadingNeedsBothNumbers() {
        Edited edited;
        QVERIFY(edited.enter(3, 0, "180"));
        QCOMPARE(edited.drift().times.size(), std::size_t{3});
        QVERIFY(edited.enter(3, 0, "180.5")); // shown as typed, although the times have no decimals
        QCOMPARE(edited.table->model()->index(3, 0).data().toString(), QString("180.5"));
        QVERIFY(edited.enter(3, 0, "180"));
        QVERIFY(edited.enter(3, 1, "-2"));
        QCOMPARE(edited.drift().times.back(), 180.0);
        QCOMPARE(edited.drift().deviations.back(), -0.002);
    }

    /// Enter goes on, and the table keeps the keyboard while it grows.
    void readingsAreTypedOneAfterTheOther() {
        QTest::failOnWarning(QRegularExpression("editor"));
        Edited edited;
        edited.page.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&edited.page));
        edited.table->setFocus();
        edited.table->setCurrentIndex(edited.table->model()->index(3, 0));
        const auto type = [&](const QString &text, int row, int column) {
            QTest::keyClicks(edited.table, text.first(1));
            QTRY_VERIFY(QApplication::focusWidget() != edited.table);
            QTest::keyClicks(QApplication::focusWidget(), text.sliced(1));
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            QTRY_COMPARE(edited.table->currentIndex(), edited.table->model()->index(row, column));
            QTRY_VERIFY(edited.table->hasFocus());
        };
        type("180", 3, 1);
        type("4", 4, 0);
        type("240", 4, 1);
        type("much", 4, 1); // what is refused is to be typed again
        type("6", 5, 0);
        QCOMPARE(edited.drift().times, (std::vector<double>{0, 60, 120, 180, 240}));
        QCOMPARE(edited.drift().deviations.back(), 0.006);
    }

    void whatIsNoNumberIsRefusedInWords_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("words") << "much";
        QTest::newRow("infinite") << "1e999";
        QTest::newRow("nothing") << "";
    }

    void whatIsNoNumberIsRefusedInWords() {
        QFETCH(QString, text);
        Edited edited;
        const DriftMeasurement before = edited.drift();
        QVERIFY(!edited.enter(1, 1, text));
        QCOMPARE(edited.drift(), before);
        auto *reason = edited.page.findChild<QLabel *>("driftReason");
        QVERIFY(reason->isVisible() && !reason->text().isEmpty());
        QVERIFY(edited.enter(1, 1, "1"));
        QVERIFY(!reason->isVisible());
    }

    /// By one step, and not after another one.
    void aRefusedTextIsTakenBack() {
        Edited edited;
        const QModelIndex cell = edited.table->model()->index(1, 1);
        const QString old = cell.data().toString();
        const auto *reason = edited.page.findChild<QLabel *>("driftReason");
        QVERIFY(!edited.page.undoRefused());
        QVERIFY(!edited.enter(1, 1, "much"));
        QCOMPARE(cell.data().toString(), QString("much"));
        QVERIFY(edited.page.undoRefused());
        QCOMPARE(cell.data().toString(), old);
        QVERIFY(!reason->isVisible());
        QVERIFY(!edited.page.undoRefused());
        QVERIFY(!edited.enter(1, 1, "much"));
        QVERIFY(edited.enter(2, 1, "3"));
        QVERIFY(!edited.page.undoRefused());
        QCOMPARE(cell.data().toString(), QString("much"));
    }

    void readingsArePastedAndRemoved() {
        Edited edited;
        edited.table->setCurrentIndex(edited.table->model()->index(3, 0));
        QGuiApplication::clipboard()->setText("180\t4\n240\t6");
        QTest::keyClick(edited.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(edited.drift().times, (std::vector<double>{0, 60, 120, 180, 240}));
        QCOMPARE(edited.drift().deviations.back(), 0.006);
        edited.table->selectAll();
        QTest::keyClick(edited.table, Qt::Key_Delete);
        QVERIFY(edited.drift().times.empty());
        QVERIFY(edited.label("driftRange").contains("No readings"));
        edited.model.undoStack()->undo();
        QCOMPARE(edited.drift().times.size(), std::size_t{5});
        QGuiApplication::clipboard()->setText("no numbers at all");
        QTest::keyClick(edited.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(edited.drift().times.size(), std::size_t{5});
        QVERIFY(edited.page.findChild<QLabel *>("driftReason")->isVisible());
    }

    /// Paste is heard wherever the page has the focus, and takes channels and temperatures.
    void theWholePageHearsPaste() {
        Edited edited;
        QVERIFY(QTest::qWaitForWindowActive(&edited.page, patience));
        QGuiApplication::clipboard()->setText(
            "Time (s)\tX (µm)\tY (µm)\tAir (°C)\n0\t1\t2\t20\n60\t3\t4\t21");
        auto *button = edited.page.findChild<QWidget *>("pasteDrift");
        button->setFocus();
        QTest::keyClick(button, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(edited.drift().channels.size(), std::size_t{2});
        QCOMPARE(edited.drift().temperatures.size(), std::size_t{1});
        QCOMPARE(edited.table->model()->columnCount(), 4);
    }

    /// The bar says in which units a paste was read; another one pastes anew, and Undo takes back that alone.
    void theBarChangesAPasteAndTakesItBack() {
        Edited edited;
        const DriftMeasurement before = edited.drift();
        const auto paste = [&](const char *text) {
            edited.table->setCurrentIndex(edited.table->model()->index(0, 0));
            QGuiApplication::clipboard()->setText(text);
            QTest::keyClick(edited.table, Qt::Key_V, Qt::ControlModifier);
        };
        const auto pick = [&](const char *box, const char *word) {
            auto *words = edited.page.findChild<QComboBox *>(box);
            words->setCurrentIndex(words->findData(word));
            emit words->activated(words->currentIndex());
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        };
        const auto bar = [&](const char *name) { return edited.page.findChild<QWidget *>(name); };
        paste("Time (min)\tDeviation (mm)\n0\t0.001\n1\t0.004");
        QCOMPARE(edited.drift().times[1], 60.0);
        QCOMPARE(edited.drift().deviations[1], 0.004);
        QVERIFY(bar("pasteBar")->isVisible() && bar("pasteUndo")->isVisible());
        pick("paste.unit", "um");
        QCOMPARE(edited.drift().deviations[1], 0.000004);
        pick("paste.timeUnit", "h");
        QCOMPARE(edited.drift().times[1], 3600.0);
        QTest::mouseClick(bar("pasteUndo"), Qt::LeftButton);
        QCOMPARE(edited.drift(), before);
        edited.model.edit("a step before", [](Document &document) { document.machine.name = "M"; });
        paste("Time (s)\tDeviation (µm)\n0\t1\n60\t3");
        const DriftMeasurement pasted = edited.drift();
        paste("Time (s)\tDeviation (µm)\n0\t1\n60\t3"); // changes nothing: no step of its own
        QCOMPARE(edited.drift(), pasted);
        QVERIFY(!bar("pasteUndo")->isVisible());
        // What is doubted is asked, and nothing is put; an answer that is no word of a list is typed.
        paste("0\t0\t5\n1\t60\t6\n2\t120\t7");
        QCOMPARE(edited.drift(), pasted);
        QVERIFY(bar("pasteQuestions")->isVisible());
        // The typed answer begins as the proposal; a refused one leaves the question.
        edited.page.findChild<QPushButton *>("other.columns")->click();
        auto *answer = edited.page.findChild<QInputDialog *>("answerDialog");
        QCOMPARE(answer->textValue(), QString("ignored,time,deviation"));
        answer->setTextValue("minutes");
        answer->accept();
        QCOMPARE(edited.drift(), pasted);
        QVERIFY(edited.page.findChild<QLabel *>("driftReason")->isVisible());
        QVERIFY(bar("pasteQuestions")->isVisible());
        auto *confirm = edited.page.findChild<QPushButton *>("confirm.columns");
        QVERIFY(confirm);
        QTest::mouseClick(confirm, Qt::LeftButton);
        QVERIFY(!edited.page.findChild<QLabel *>("driftReason")->isVisible());
        QCOMPARE(edited.drift().times[2], 120.0);
        QCOMPARE(edited.drift().deviations[2], 0.007);
        QVERIFY(!bar("pasteQuestions")->isVisible());
    }

    void theWindowShowsPageAndCurve() {
        const ShownWindow shown(examplePath("long-axis-with-zone"));
        Workplace &workplace = shown.window->workplace();
        auto *tabs = shown.find<PageTabs>("pageTabs");
        workplace.showTest(0);
        auto *action = shown.find<QAction>("page5"); // the page of the uncertainty has its key
        QCOMPARE(action->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_5));
        action->trigger();
        QCOMPARE(workplace.selection().page(), Page::uncertainty);
        QCOMPARE(tabs->currentIndex(), 4);
        shown.find<QAction>("addDrift")->trigger();
        auto *page = shown.find<DriftPage>("driftPage");
        QVERIFY(page->isVisible());
        // Readings and thermal behaviour, nothing else
        for (int tab = 0; tab < tabs->count(); ++tab)
            QCOMPARE(tabs->isTabVisible(tab), tab == 0 || tab == tabs->count() - 1);
        workplace.showPage(Page::limits);
        QCOMPARE(workplace.selection().page(), Page::readings);
        QGuiApplication::clipboard()->setText("0\t0\n60\t3\n120\t1");
        QTest::keyClick(page->findChild<QTableView *>("driftReadings"), Qt::Key_V, Qt::ControlModifier);
        const auto figure = shown.find<FigureView>("figureView")->figure();
        QVERIFY(figure);
        QCOMPARE(figure->curves.size(), std::size_t{1});
        QCOMPARE(figure->curves[0].points.size(), std::size_t{3});
        QCOMPARE(figure->dimensions.size(), std::size_t{1});
        // Back to a positioning test all its pages are there again: the last two are of circles and drift
        // tests.
        workplace.showTest(0);
        for (int tab = 0; tab < tabs->count(); ++tab)
            QCOMPARE(tabs->isTabVisible(tab), tab + 2 < tabs->count());
    }
};

QTEST_MAIN(DriftPageTest)
#include "driftpage.moc"
