// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "ui/forms/sectionhead.h"

#include "document/savedocument.h"
#include "ui/circles/circlespage.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/forms/field.h"
#include "ui/readings/readingsmodel.h"
#include "ui/readings/readingspage.h"
#include "ui/welcome/recentfiles.h"

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

/// The parts of a window that F6 walks, as they follow one another.
constexpr std::array panes{"navigation", "pageTabs", "page", "figureView", "resultsPanel", "findingsPanel"};

QString paneOf(const ShownWindow &shown) {
    const QWidget *focused = QApplication::focusWidget();
    for (const char *name : panes) {
        const QWidget *pane =
            name == QLatin1StringView("page") ? shown.find("pageTabs")->parentWidget() : shown.find(name);
        const bool inPage = name == QLatin1StringView("page");
        if (focused && (pane == focused || pane->isAncestorOf(focused)) &&
            !(inPage && shown.find("pageTabs") == focused))
            return QString::fromLatin1(name);
    }
    return {};
}

void setText(QLineEdit *edit, const QString &text) {
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
}

} // namespace

/// What can be done without a mouse, and where the keyboard is afterwards.
class KeyboardTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }
    void f6WalksThePanes();
    void whereTheKeyboardIsIsSeen_data();
    void whereTheKeyboardIsIsSeen();
    void ctrlTabDoesTheSame();
    void aClickOnATabGivesThePageTheKeyboard();
    void escClosesTheExplanationFromAnywhere_data();
    void escClosesTheExplanationFromAnywhere();
    void tabLeavesTheReadingsAtTheirEnd();
    void aFileIsOpenedWithTheKeyboardInTheNavigation();
    void ctrlHomeClearsTheSelection();
    void tabWalksTheFieldsAsTheyStand_data();
    void tabWalksTheFieldsAsTheyStand();
    void undoLeavesOnlyTheCurrentCellSelected_data();
    void undoLeavesOnlyTheCurrentCellSelected();
    void undoBringsTheReadingIntoView();
    void undoTakesBackWhatIsBeingTypedFirst();
    void afterUndoOfTheOnlyArcItCanBePastedAgain();
    void undoBringsTheFieldIntoView();
    void undoBringsTheAgreementIntoView();
    void undoBringsThePointOfACircleIntoView();
    void undoBringsTheTargetIntoView();
    void undoBringsTheTestIntoView();
    void everyShortcutIsListed();
    void menusChangeOnlyWhatIsInView();
    void shortcutsNameTheCommandAlone();
    void buttonsOfAgreedPointsNameTheirPoint();
    void standardButtonsHaveAKey_data();
    void standardButtonsHaveAKey();
};

void KeyboardTest::f6WalksThePanes() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    shown.find("navigation")->setFocus();
    QStringList walked;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        walked << paneOf(shown);
        QTest::keyClick(shown.window, Qt::Key_F6);
    }
    QCOMPARE(walked,
             QStringList({"navigation", "pageTabs", "page", "figureView", "resultsPanel", "findingsPanel"}));
    QCOMPARE(paneOf(shown), u"navigation"_s); // round and round
    QStringList back;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        QTest::keyClick(shown.window, Qt::Key_F6, Qt::ShiftModifier);
        back << paneOf(shown);
    }
    std::ranges::reverse(walked);
    QCOMPARE(back, walked);
}

void KeyboardTest::whereTheKeyboardIsIsSeen_data() {
    QTest::addColumn<QString>("list");
    QTest::newRow("results") << u"results"_s;
    QTest::newRow("findings") << u"findings"_s;
}

/// Nothing of them is selected when the keyboard comes there first.
void KeyboardTest::whereTheKeyboardIsIsSeen() {
    QFETCH(QString, list);
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *view = shown.find<QAbstractItemView>(list.toLatin1());
    QTRY_VERIFY(view->model()->rowCount() > 1);
    const auto firstRow = [view] {
        const QRect row = view->visualRect(view->model()->index(0, 0));
        return view->viewport()->grab(QRect(0, row.top(), view->viewport()->width(), row.height())).toImage();
    };
    const QImage before = firstRow();
    view->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(view->hasFocus());
    QVERIFY(firstRow() != before);
}

void KeyboardTest::ctrlTabDoesTheSame() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *view = shown.find<QTableView>("readings");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Tab, Qt::ControlModifier);
    QCOMPARE(paneOf(shown), u"figureView"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(view->hasFocus());
}

void KeyboardTest::aClickOnATabGivesThePageTheKeyboard() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *tabs = shown.find<QTabBar>("pageTabs");
    for (const int tab : {1, 3, 4, 0, 0}) {
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(tab).center());
        QTRY_VERIFY2(!tabs->hasFocus(), qPrintable(QString::number(tab)));
        QCOMPARE(paneOf(shown), u"page"_s);
    }
    QVERIFY(shown.find("readings")->hasFocus());
}

void KeyboardTest::escClosesTheExplanationFromAnywhere_data() {
    QTest::addColumn<QByteArray>("where");
    for (const char *name : {"readings", "results", "navigation", "findings", "figureCanvas", "pageTabs",
                             "edition", "addTestButton"})
        QTest::newRow(name) << QByteArray(name);
}

void KeyboardTest::escClosesTheExplanationFromAnywhere() {
    QFETCH(QByteArray, where);
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    Selection &selection = shown.window->workplace().selection();
    selection.setParameter(u"A"_s);
    auto *widget = shown.find(where.constData());
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_Escape);
    QCOMPARE(selection.parameter(), QString());
}

void KeyboardTest::tabLeavesTheReadingsAtTheirEnd() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *view = shown.find<QTableView>("readings");
    const auto *model = view->model();
    int last = model->columnCount() - 1;
    while (view->isColumnHidden(last))
        --last;
    view->setFocus();
    view->setCurrentIndex(model->index(model->rowCount() - 1, last - 1));
    QTest::keyClick(view, Qt::Key_Tab);
    QVERIFY(view->hasFocus());
    QCOMPARE(view->currentIndex().column(), last);
    QTest::keyClick(view, Qt::Key_Tab);
    QVERIFY(!view->hasFocus());
    QCOMPARE(view->currentIndex(), model->index(model->rowCount() - 1, last));
    view->setFocus();
    view->setCurrentIndex(model->index(0, 0));
    QTest::keyClick(view, Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(!view->hasFocus());
    // From a cell that is being typed, too; what was typed is taken.
    view->setFocus();
    view->setCurrentIndex(model->index(model->rowCount() - 1, ReadingsModel::firstReadingColumn));
    for (int column = ReadingsModel::firstReadingColumn; column < last; ++column)
        QTest::keyClick(view, Qt::Key_Tab);
    QTest::keyClicks(view, u"1.5"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QTRY_VERIFY(!view->isAncestorOf(QApplication::focusWidget()) && !view->hasFocus());
}

void KeyboardTest::aFileIsOpenedWithTheKeyboardInTheNavigation() {
    const ShownWindow shown;
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    shown.window->openFile(examplePath("rotary-axis"));
    QTRY_VERIFY(shown.find("navigation")->hasFocus());
}

void KeyboardTest::ctrlHomeClearsTheSelection() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *view = shown.find<QTableView>("readings");
    view->setFocus();
    for (const auto &[key, row] :
         {std::pair(Qt::Key_Home, 0), std::pair(Qt::Key_End, view->model()->rowCount() - 1)}) {
        view->selectionModel()->setCurrentIndex(view->model()->index(3, 4),
                                                QItemSelectionModel::ClearAndSelect);
        QTest::keyClick(view, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(view->selectionModel()->selectedIndexes().size(), 2);
        QTest::keyClick(view, key, Qt::ControlModifier);
        QCOMPARE(view->currentIndex().row(), row);
        QCOMPARE(view->selectionModel()->selectedIndexes().size(), 1);
    }
}

void KeyboardTest::tabWalksTheFieldsAsTheyStand_data() {
    QTest::addColumn<Page>("page");
    QTest::addColumn<QByteArray>("form");
    QTest::newRow("conditions, built for the test") << Page::conditions << QByteArray("conditionsPage");
    QTest::newRow("limits, built for the edition") << Page::limits << QByteArray("limitsPage");
    QTest::newRow("machine, made when first shown") << Page::machine << QByteArray("machinePage");
    QTest::newRow("identification") << Page::identification << QByteArray("identificationPage");
}

/// From field to field in the order they stand in: downwards, and in a row to the right.
void KeyboardTest::tabWalksTheFieldsAsTheyStand() {
    QFETCH(Page, page);
    QFETCH(QByteArray, form);
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    shown.window->workplace().showPage(page);
    QCoreApplication::processEvents();
    auto *whole = shown.find(form.constData());
    QList<QWidget *> fields;
    for (const auto *field : whole->findChildren<Field *>()) {
        if (field->isVisible()) // not folded away
            fields << field->edit();
    }
    QVERIFY(fields.size() > 5);
    fields.first()->setFocus(Qt::TabFocusReason);
    QList<QWidget *> walked{fields.first()};
    for (int i = 0; i < 400 && walked.size() < fields.size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY2(whole->isAncestorOf(QApplication::focusWidget()), "the walk leaves the page");
        if (fields.contains(QApplication::focusWidget()))
            walked << QApplication::focusWidget();
    }
    QCOMPARE(walked.size(), fields.size());
    QTest::qWait(20); // fields that came into view have their places
    for (qsizetype i = 1; i < walked.size(); ++i) {
        const QPoint before = walked[i - 1]->mapTo(whole, QPoint());
        const QPoint now = walked[i]->mapTo(whole, QPoint());
        // The page may have scrolled in between: places are compared now.
        QVERIFY2(now.y() > before.y() || (now.y() == before.y() && now.x() > before.x()),
                 qPrintable(u"%1 (%3, %4) after %2 (%5, %6)"_s
                                .arg(walked[i]->accessibleName(), walked[i - 1]->accessibleName())
                                .arg(now.x())
                                .arg(now.y())
                                .arg(before.x())
                                .arg(before.y())));
    }
}

void KeyboardTest::undoLeavesOnlyTheCurrentCellSelected_data() {
    QTest::addColumn<Qt::KeyboardModifiers>("redoKeys");
    QTest::addColumn<Qt::Key>("redoKey");
    QTest::newRow("redo by Ctrl+Y") << Qt::KeyboardModifiers(Qt::ControlModifier) << Qt::Key_Y;
    QTest::newRow("redo by Ctrl+Shift+Z") << (Qt::ControlModifier | Qt::ShiftModifier) << Qt::Key_Z;
}

/// With Ctrl held a table would add each cell to what is selected, and Delete erase them all.
void KeyboardTest::undoLeavesOnlyTheCurrentCellSelected() {
    QFETCH(Qt::KeyboardModifiers, redoKeys);
    QFETCH(Qt::Key, redoKey);
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    QWindow *keys = shown.window->windowHandle(); // as the desktop sends them: the modifiers are known
    auto *view = shown.find<QTableView>("readings");
    view->setFocus();
    const QModelIndex first = view->model()->index(0, 2);
    view->setCurrentIndex(first);
    for (const QString &typed : {u"1.1"_s, u"2.2"_s, u"3.1"_s}) {
        QTest::keyClicks(view, typed.left(1)); // opens the editor
        QTest::keyClicks(QApplication::focusWidget(), typed.mid(1));
        QTest::keyClick(keys, Qt::Key_Return);
    }
    QTRY_COMPARE(shown.window->model().undoStack()->count(), 3);
    const auto selected = [&] { return view->selectionModel()->selectedIndexes(); };
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(selected(), QModelIndexList{view->currentIndex()});
    }
    QCOMPARE(shown.window->model().undoStack()->index(), 0);
    QCOMPARE(view->currentIndex(), first);
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(keys, redoKey, redoKeys);
        QCOMPARE(selected(), QModelIndexList{view->currentIndex()});
    }
    QCOMPARE(shown.window->model().undoStack()->index(), 3);
    QTest::keyClick(keys, Qt::Key_Delete);
    QCOMPARE(shown.window->model().undoStack()->count(), 4);
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    const TestPointer before = shown.window->model().document()->tests.front();
    QTest::keyClick(keys, Qt::Key_Y, Qt::ControlModifier);
    const auto missing = [](const TestPointer &test) {
        int count = 0;
        for (const Run &run : std::get<PositioningMeasurement>(test->measurement).runs)
            count += static_cast<int>(std::ranges::count_if(
                run.deviations, [](const auto &reading) { return !reading.has_value(); }));
        return count;
    };
    QCOMPARE(missing(shown.window->model().document()->tests.front()), missing(before) + 1);
    // What was selected together and erased comes back with one cell selected.
    view->setCurrentIndex(first);
    QTest::keyClick(keys, Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(keys, Qt::Key_Delete);
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(selected(), QModelIndexList{first});
}

void KeyboardTest::undoBringsTheReadingIntoView() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    Selection &selection = shown.window->workplace().selection();
    auto *view = shown.find<QTableView>("readings");
    view->setFocus();
    const QModelIndex cell = view->model()->index(4, 5);
    view->setCurrentIndex(cell);
    const auto place = selection.reading();
    QTest::keyClicks(view, u"12"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_COMPARE(shown.window->model().undoStack()->count(), 1);
    view->setCurrentIndex(view->model()->index(0, 2));
    shown.window->workplace().showPage(Page::limits);
    shown.find<QAction>("undo")->trigger();
    QCOMPARE(selection.page(), Page::readings);
    QCOMPARE(selection.reading(), place);
    QCOMPARE(view->currentIndex(), cell);
    view->setCurrentIndex(view->model()->index(0, 2));
    shown.window->workplace().showPage(Page::machine);
    shown.find<QAction>("redo")->trigger();
    QCOMPARE(selection.page(), Page::readings);
    QCOMPARE(view->currentIndex(), cell);
}

/// A text that is refused is no step: undo would change another field instead.
void KeyboardTest::undoTakesBackWhatIsBeingTypedFirst() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    QWindow *keys = shown.window->windowHandle();
    shown.window->workplace().showPage(Page::conditions);
    QCoreApplication::processEvents();
    QList<Field *> fields = shown.find("conditionsPage")->findChildren<Field *>();
    const auto editOf = [&](const QString &label) {
        for (const Field *field : fields) {
            if (field->edit()->accessibleName() == label)
                return qobject_cast<QLineEdit *>(field->edit());
        }
        return static_cast<QLineEdit *>(nullptr);
    };
    QLineEdit *title = editOf(u"Title of the test"_s);
    QLineEdit *time = editOf(u"Time of day"_s);
    QVERIFY(title && time);
    setText(title, u"AAA"_s);
    const QString before = time->text();
    setText(time, u"11:2x"_s);
    const auto isRefused = [&] { return qobject_cast<Field *>(time->parentWidget())->isRefused(); };
    QVERIFY(isRefused());
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(time->text(), before);
    QVERIFY(!isRefused() && time->hasFocus());
    QCOMPARE(title->text(), u"AAA"_s);
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(title->text() != u"AAA"_s);
    // Likewise in a cell: the reading typed before stays.
    shown.window->workplace().showPage(Page::readings);
    auto *view = shown.find<QTableView>("readings");
    const auto type = [&](const QModelIndex &cell, const QString &text) {
        view->setFocus();
        view->setCurrentIndex(cell);
        QTest::keyClicks(view, text.left(1)); // opens the editor
        QTest::keyClicks(QApplication::focusWidget(), text.mid(1));
    };
    const QModelIndex reading = view->model()->index(0, ReadingsModel::firstReadingColumn);
    const QModelIndex position = view->model()->index(1, ReadingsModel::positionColumn);
    const QString old = position.data().toString();
    type(reading, u"1.5"_s);
    QTest::keyClick(keys, Qt::Key_Return);
    type(position, u"5x"_s);
    QTest::keyClick(keys, Qt::Key_Return);
    QVERIFY(!position.data(ReadingsModel::refusedRole).toString().isEmpty());
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(position.data().toString(), old);
    QCOMPARE(reading.data().toString(), u"1.5"_s);
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(reading.data().toString() != u"1.5"_s);
}

void KeyboardTest::afterUndoOfTheOnlyArcItCanBePastedAgain() {
    const ShownWindow shown(examplePath("iso230-4-full-circles-xy"), {1600, 1000});
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    QWindow *keys = shown.window->windowHandle();
    const auto arcs = [&] {
        return std::get<CircularMeasurement>(shown.window->model().document()->tests.at(0)->measurement).arcs;
    };
    const std::vector<Arc> all = arcs();
    shown.window->model().edit("none", [](Document &document) {
        auto test = std::make_shared<palmer::Test>(*document.tests[0]);
        std::get<CircularMeasurement>(test->measurement).arcs.clear();
        document.tests[0] = std::move(test);
    });
    shown.window->workplace().circles().addArcs({all.front()});
    QTRY_VERIFY(shown.find("points")->isVisible());
    shown.find("points")->setFocus();
    QTest::keyClick(keys, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(arcs().empty());
    QVERIFY2(shown.find("newArcButton")->hasFocus(), qPrintable(paneOf(shown)));
    bool pasted = false;
    connect(shown.find<QAction>("pasteArc"), &QAction::triggered, this, [&pasted] { pasted = true; });
    QTimer closer; // a dialog asks for the points
    connect(&closer, &QTimer::timeout, this, [] {
        if (QWidget *dialog = QApplication::activeModalWidget())
            dialog->close();
    });
    closer.start(20);
    QTest::keyClick(keys, Qt::Key_V, Qt::ControlModifier);
    QVERIFY(pasted);
}

void KeyboardTest::undoBringsTheFieldIntoView() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    Selection &selection = shown.window->workplace().selection();
    for (const auto &[page, form] :
         {std::pair(Page::conditions, "conditionsPage"), std::pair(Page::limits, "limitsPage"),
          std::pair(Page::uncertainty, "uncertaintyPage"), std::pair(Page::machine, "machinePage")}) {
        shown.window->workplace().showPage(page);
        for (auto *head : shown.find(form)->findChildren<SectionHead *>())
            head->click(); // of this file all is stated
        QLineEdit *edit = nullptr;
        for (auto *candidate : shown.find(form)->findChildren<QLineEdit *>()) {
            if (candidate->isVisible() && !candidate->text().isEmpty())
                edit = candidate;
        }
        QVERIFY(edit);
        const QString before = edit->text();
        setText(edit, u"7"_s);
        const QPointer<QLineEdit> changed = edit;
        shown.window->workplace().showPage(Page::readings);
        shown.find<QAction>("undo")->trigger();
        QCOMPARE(selection.page(), page);
        QTRY_VERIFY(changed && changed->hasFocus());
        QCOMPARE(changed->text(), before);
    }
}

void KeyboardTest::undoBringsTheAgreementIntoView() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    const Selection &selection = shown.window->workplace().selection();
    shown.window->workplace().showPage(Page::agreedPoints);
    const auto comesBack = [&](QLineEdit *edit, const QString &typed) {
        const QString before = edit->text();
        setText(edit, typed);
        QCOMPARE(edit->text(), typed);
        for (const char *step : {"undo", "redo", "undo"}) {
            shown.find("field.agreedPoints.feed")->setFocus(); // the last of the page
            shown.window->workplace().showPage(Page::limits);
            shown.find<QAction>(step)->trigger();
            QCOMPARE(selection.page(), Page::agreedPoints);
            // The text and the number of an agreement stand in one row.
            const auto *field = shown.find("field.agreedPoints.gradient");
            QVERIFY2(field->hasFocus() || edit->hasFocus(), step);
            QCOMPARE(edit->text(), QByteArray(step) == "undo" ? before : typed);
        }
    };
    comesBack(shown.find<QLineEdit>("field.agreedPoints.gradient"), u"7 K"_s);
    comesBack(shown.find<QLineEdit>("value.gradient"), u"0.5"_s);
}

void KeyboardTest::undoBringsThePointOfACircleIntoView() {
    const ShownWindow shown(examplePath("iso230-4-full-circles-xy"), {1600, 1000});
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    const Selection &selection = shown.window->workplace().selection();
    auto *view = shown.find<QTableView>("points");
    QVERIFY(view->isVisible());
    const QModelIndex cell = view->model()->index(700, 2);
    view->setCurrentIndex(cell);
    QVERIFY(view->model()->setData(cell, u"3.25"_s, Qt::EditRole));
    QTRY_COMPARE(shown.window->model().undoStack()->count(), 1);
    for (const char *step : {"undo", "redo"}) {
        view->setCurrentIndex(view->model()->index(2, 2));
        shown.window->workplace().showPage(Page::limits);
        shown.find<QAction>(step)->trigger();
        QCOMPARE(selection.page(), Page::readings);
        QCOMPARE(selection.reading(), (ReadingPlace{0, 700}));
        QCOMPARE(view->currentIndex().row(), 700);
        QVERIFY(view->hasFocus());
    }
}

void KeyboardTest::undoBringsTheTargetIntoView() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *view = shown.find<QTableView>("readings");
    const QModelIndex cell = view->model()->index(3, ReadingsModel::positionColumn);
    view->setFocus();
    view->setCurrentIndex(cell);
    const double position =
        std::get<PositioningMeasurement>(shown.window->model().document()->tests[0]->measurement).targets[3];
    const QString typed = QString::number(position + 0.5);
    QTest::keyClicks(view, typed.left(1)); // opens the editor
    QTest::keyClicks(QApplication::focusWidget(), typed.mid(1));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_COMPARE(shown.window->model().undoStack()->count(), 1);
    for (const char *step : {"undo", "redo"}) {
        view->setCurrentIndex(view->model()->index(0, 4));
        shown.window->workplace().showPage(Page::limits);
        shown.find<QAction>(step)->trigger();
        QCOMPARE(shown.window->workplace().selection().page(), Page::readings);
        QCOMPARE(view->currentIndex(), cell);
        QVERIFY(view->hasFocus());
    }
}

void KeyboardTest::undoBringsTheTestIntoView() {
    const ShownWindow shown(examplePath("rotary-axis"));
    Workplace &workplace = shown.window->workplace();
    const std::string title = shown.window->model().document()->tests[0]->title;
    shown.find<QAction>("duplicateTest")->trigger();
    auto *dialog = shown.find<QInputDialog>("renameDialog");
    dialog->setTextValue(u"again"_s);
    dialog->accept();
    QCOMPARE(shown.window->model().document()->tests[1]->title, "again");
    QCOMPARE(shown.window->model().document()->tests[0]->title, title);
    QCOMPARE(workplace.selection().test(), std::size_t(1));
    shown.find<QAction>("undo")->trigger();
    QCOMPARE(workplace.selection().test(), std::size_t(0));
    workplace.showPage(Page::machine);
    shown.find<QAction>("redo")->trigger();
    QCOMPARE(workplace.selection().test(), std::size_t(1));
    QCOMPARE(workplace.selection().page(), Page::readings);
}

void KeyboardTest::everyShortcutIsListed() {
    const ShownWindow shown(examplePath("rotary-axis"));
    shown.find<QAction>("shortcuts")->trigger();
    auto *dialog = shown.window->findChild<ShortcutsDialog *>();
    QVERIFY(dialog && dialog->isVisible());
    QString listed;
    const auto *tree = dialog->findChild<QTreeWidget *>();
    QVERIFY(tree->visualItemRect(tree->topLevelItem(0)->child(0)).height() >= 20); // not cramped
    for (int group = 0; group < tree->topLevelItemCount(); ++group) {
        for (int row = 0; row < tree->topLevelItem(group)->childCount(); ++row)
            listed += tree->topLevelItem(group)->child(row)->text(1) + u'\n';
    }
    int seen = 0;
    for (const QAction *action : shown.window->findChildren<QAction *>()) {
        if (action->associatedObjects().isEmpty() || action->shortcut().isEmpty() ||
            qobject_cast<QLineEdit *>(action->parent()))
            continue;
        ++seen;
        QVERIFY2(listed.contains(action->shortcut().toString(QKeySequence::NativeText)),
                 qPrintable(action->text()));
    }
    QVERIFY(seen > 20);
}

/// On another page it would not be seen what they change.
void KeyboardTest::menusChangeOnlyWhatIsInView() {
    for (const char *example : {"x-axis-as-found-as-left", "iso230-4-full-circles-xy"}) {
        const ShownWindow shown(examplePath(example));
        Workplace &workplace = shown.window->workplace();
        const auto enabled = [&] {
            QStringList names;
            for (const QList<QAction *> &list :
                 {workplace.readings().editActions(), workplace.readings().testActions(),
                  workplace.circles().testActions()}) {
                for (const QAction *action : list) {
                    if (action->isEnabled() && !action->isSeparator())
                        names << action->objectName();
                }
            }
            return names;
        };
        QVERIFY(!enabled().isEmpty());
        workplace.showPage(Page::conditions);
        QCOMPARE(enabled(), QStringList());
        workplace.showPage(Page::machine);
        QCOMPARE(enabled(), QStringList());
        workplace.showPage(Page::readings);
        QVERIFY(!enabled().isEmpty());
    }
}

/// A command, not what it would do just now.
void KeyboardTest::shortcutsNameTheCommandAlone() {
    QMenuBar bar;
    QAction *undo = bar.addMenu("&Edit")->addAction(u"&Annuler\u00A0: saisie d’un relevé"_s);
    undo->setShortcut(QKeySequence::Undo);
    const ShortcutsDialog dialog(bar, nullptr, false);
    QCOMPARE(dialog.findChild<QTreeWidget *>()->topLevelItem(0)->child(0)->text(0), u"Annuler"_s);
}

void KeyboardTest::buttonsOfAgreedPointsNameTheirPoint() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    shown.window->workplace().showPage(Page::agreedPoints);
    QStringList names;
    for (const auto *button : shown.find("agreedPointsPage")->findChildren<QToolButton *>()) {
        if (button->isCheckable())
            names << button->accessibleName();
    }
    QVERIFY(names.size() >= 20);
    QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), names.size()); // no two are called alike
}

void KeyboardTest::standardButtonsHaveAKey_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::addColumn<QString>("discard");
    QTest::newRow("in English") << Language::Id::english << u"&Discard"_s;
    QTest::newRow("in French") << Language::Id::french << u"&Ne pas enregistrer"_s;
}

void KeyboardTest::standardButtonsHaveAKey() {
    QFETCH(Language::Id, language);
    QFETCH(QString, discard);
    setWindowLanguage(language);
    QMessageBox box(QMessageBox::Question, u"a"_s, u"b"_s,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    box.open();
    QCOMPARE(box.button(QMessageBox::Discard)->text(), discard);
    QInputDialog asking;
    asking.open();
    QSet<QChar> keys;
    for (const auto *dialog : {static_cast<QDialog *>(&box), static_cast<QDialog *>(&asking)}) {
        keys.clear();
        for (const auto *button : dialog->findChildren<QPushButton *>()) {
            const qsizetype mark = button->text().indexOf(u'&');
            QVERIFY2(mark >= 0, qPrintable(button->text()));
            const QChar key = button->text()[mark + 1].toLower();
            QVERIFY2(!keys.contains(key), qPrintable(button->text()));
            keys += key;
        }
        QVERIFY(keys.size() > 1);
    }
}

QTEST_MAIN(KeyboardTest)
#include "keyboardtest.moc"
