// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "document/readdocument.h"
#include "document/writedocument.h"
#include "editing/measuringcycle.h"
#include "editing/newtest.h"
#include "kernel/planning/targetplan.h"
#include "ui/examples.h"
#include "ui/readings/readingspage.h"
#include "ui/window/rightside.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <cmath>
#include <random>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;

namespace {

const PositioningMeasurement &published() {
    // The doubles of the decimals, as typing gives them: 5.4/1000 need not be that of 0.0054.
    static const PositioningMeasurement exact = [] {
        Test test = example1988("ISO 230-2:1988");
        for (Run &run : testdata::measurement(test).runs) {
            for (auto &deviation : run.deviations)
                deviation = std::round(*deviation * 1e9) / 1e9;
        }
        return testdata::measurement(test);
    }();
    return exact;
}

Test publishedTest() {
    Test test = example1988("ISO 230-2:1988");
    testdata::measurement(test) = published();
    return test;
}

/// A window with one test in it, of which nothing is saved.
struct TypingWindow : ShownWindow {
    explicit TypingWindow(const Test &test)
        : ShownWindow(examplePath("one-direction")) {
        window->model().edit("prepare", [&](Document &document) {
            document.tests.clear();
            insertTest(document, 0, test);
        });
        window->model().undoStack()->clear();
        window->workplace().showPage(Page::readings);
        view = find<QTableView>("readings");
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window))
            qFatal("no active window to type in");
        view->setFocus();
    }

    [[nodiscard]] const PositioningMeasurement &measurement() const {
        return std::get<PositioningMeasurement>(window->model().document()->tests.at(0)->measurement);
    }

    void type(const QString &text) const {
        for (const QChar c : text)
            QTest::keyClick(QApplication::focusWidget(), c.toLatin1() ? c.toLatin1() : ' ');
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }

    void setCurrent(std::size_t run, std::size_t target) const {
        window->workplace().selection().setReading(ReadingPlace{run, target});
    }

    [[nodiscard]] std::optional<ReadingPlace> current() const {
        return window->workplace().selection().reading();
    }

    void paste(const QString &text) const {
        QGuiApplication::clipboard()->setText(text);
        press(Qt::Key_V, Qt::ControlModifier);
    }

    QTableView *view;
};

Test emptyTest(Cycle cycle = Cycle::standard) {
    Test test = example1988("ISO 230-2:1988");
    PositioningMeasurement &m = measurement(test);
    m.cycle = cycle;
    for (Run &run : m.runs)
        std::ranges::fill(run.deviations, std::nullopt);
    return test;
}

/// A reading as somebody types it: µm, with that decimal mark.
QString typedText(double deviation, char mark) {
    return QString::number(std::round(deviation * 1e4) / 10, 'f', 1).replace('.', mark);
}

/// The published readings as a spreadsheet copies them.
QString block(char mark, std::size_t first = 0, std::size_t count = 10) {
    QStringList lines;
    for (std::size_t i = 0; i < published().targets.size(); ++i) {
        QStringList cells;
        for (std::size_t j = first; j < first + count; ++j)
            cells << typedText(*published().runs[j].deviations[i], mark);
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

} // namespace

/// Readings typed, pasted and changed in the real window.
class TypingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }

    void aWholeTestByKeyboardAlone_data() {
        QTest::addColumn<Cycle>("cycle");
        QTest::addColumn<char>("mark");
        QTest::newRow("standard cycle, point") << Cycle::standard << '.';
        QTest::newRow("standard cycle, comma") << Cycle::standard << ',';
        QTest::newRow("step cycle") << Cycle::step << '.';
    }

    void aWholeTestByKeyboardAlone() {
        QFETCH(Cycle, cycle);
        QFETCH(char, mark);
        const TypingWindow typing(emptyTest(cycle));
        const Document empty = *typing.window->model().document();
        typing.window->workplace().beginTyping();
        auto place = firstOfCycle(typing.measurement());
        while (place) {
            QCOMPARE(typing.current(), place);
            typing.type(typedText(*published().runs[place->run].deviations[place->target], mark));
            const auto next = nextInCycle(typing.measurement(), *place);
            typing.press(Qt::Key_Return);
            place = next;
        }
        QVERIFY(typing.measurement().runs == published().runs);
        QCOMPARE(typing.window->model().undoStack()->count(), 110);

        // The results are those of the readings, and all of it can be undone and redone.
        const Document full = *typing.window->model().document();
        QVERIFY(!typing.window->evaluator().current().tests[0]->parameters.empty());
        typing.window->model().undoStack()->setIndex(0);
        QVERIFY(*typing.window->model().document() == empty);
        typing.window->model().undoStack()->setIndex(110);
        QVERIFY(*typing.window->model().document() == full);
    }

    void keysDoWhatTheySay() {
        const TypingWindow typing(emptyTest());
        typing.setCurrent(0, 10);
        typing.press(Qt::Key_Return); // from the top of run 1 ↑ to the top of run 1 ↓
        QCOMPARE(typing.current(), (ReadingPlace{1, 10}));
        typing.press(Qt::Key_Return);
        QCOMPARE(typing.current(), (ReadingPlace{1, 9}));
        typing.press(Qt::Key_Return, Qt::ShiftModifier);
        typing.press(Qt::Key_Return, Qt::ShiftModifier);
        QCOMPARE(typing.current(), (ReadingPlace{0, 10}));
        typing.press(Qt::Key_Tab);
        QCOMPARE(typing.current(), (ReadingPlace{1, 10}));
        typing.press(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(typing.current(), (ReadingPlace{0, 10}));

        // Typing replaces, F2 edits, Esc restores.
        typing.type("12");
        typing.press(Qt::Key_Tab);
        QCOMPARE(readingAt(typing.measurement(), {0, 10}), std::optional(0.012));
        typing.setCurrent(0, 10);
        typing.press(Qt::Key_F2);
        typing.press(Qt::Key_End);
        typing.type("3");
        typing.press(Qt::Key_Down);
        QCOMPARE(readingAt(typing.measurement(), {0, 10}), std::optional(0.123));
        typing.setCurrent(0, 10);
        typing.type("7");
        typing.press(Qt::Key_Escape);
        QCOMPARE(readingAt(typing.measurement(), {0, 10}), std::optional(0.123));
        QCOMPARE(typing.window->model().undoStack()->count(), 2);
        typing.press(Qt::Key_F2);
        typing.press(Qt::Key_Return); // nothing was changed
        QCOMPARE(typing.window->model().undoStack()->count(), 2);

        typing.setCurrent(0, 10);
        typing.press(Qt::Key_Delete);
        QCOMPARE(readingAt(typing.measurement(), {0, 10}), std::nullopt);
        QCOMPARE(typing.find<QAction>("undo")->text(), QString("&Undo: clear 1 reading"));
    }

    void textThatIsNoNumberStays() {
        const TypingWindow typing(publishedTest());
        typing.setCurrent(3, 8);
        typing.type("4,,8");
        typing.press(Qt::Key_Return);
        const QModelIndex cell = typing.view->model()->index(8, 5);
        QCOMPARE(cell.data().toString(), QString("4,,8"));
        QCOMPARE(cell.data(ReadingsModel::refusedRole).toString(), QString("two commas"));
        QCOMPARE(readingAt(typing.measurement(), {3, 8}), std::nullopt);
        auto *reason = typing.find<QLabel>("reason");
        QVERIFY(reason->isVisible() && reason->text().contains("two commas"));
        const auto &findings = typing.window->evaluator().current().tests[0]->findings;
        QVERIFY(std::ranges::any_of(findings, [](const Finding &f) { return f.id == "refusedReadings"; }));
        // It is part of the file, can be undone, and a number takes its place.
        QVERIFY(readDocument(writeDocument(*typing.window->model().document())) ==
                *typing.window->model().document());
        typing.setCurrent(3, 8);
        typing.press(Qt::Key_F2);
        typing.press(Qt::Key_Home);
        typing.press(Qt::Key_Right);
        typing.press(Qt::Key_Delete);
        typing.press(Qt::Key_Return);
        QCOMPARE(readingAt(typing.measurement(), {3, 8}), std::optional(0.0048));
        QVERIFY(!reason->isVisible());
        typing.window->model().undoStack()->undo();
        QCOMPARE(refusedAt(typing.measurement(), {3, 8})->text, std::string("4,,8"));
        typing.window->model().undoStack()->undo();
        QVERIFY(typing.measurement() == published());
    }

    void positionsAreTypedAsPositions() {
        const TypingWindow typing(emptyTest());
        typing.find<QToolButton>("showPositions")->click();
        typing.view->setFocus();
        typing.setCurrent(2, 1);
        typing.type("150,7154");
        typing.press(Qt::Key_Return);
        QCOMPARE(readingAt(typing.measurement(), {2, 1}), std::optional(0.0054));
        typing.find<QToolButton>("showDeviations")->click();
        QCOMPARE(typing.view->model()->index(1, 4).data().toString(), QString("5.4"));
    }

    void targetsAreMovedAndRefused() {
        const TypingWindow typing(publishedTest());
        const QModelIndex cell = typing.view->model()->index(1, ReadingsModel::positionColumn);
        typing.view->setCurrentIndex(cell);
        typing.type("150.8");
        typing.press(Qt::Key_Return);
        QCOMPARE(typing.measurement().targets[1], 150.8);
        QCOMPARE(typing.view->currentIndex(), cell.siblingAtRow(2));
        typing.view->setCurrentIndex(cell);
        typing.type("400");
        typing.press(Qt::Key_Return);
        QCOMPARE(typing.measurement().targets[1], 150.8);
        QCOMPARE(cell.data().toString(), QString("400"));
        QVERIFY(cell.data(ReadingsModel::refusedRole).toString().contains("300.85"));
        typing.view->setCurrentIndex(cell);
        typing.type("151");
        typing.press(Qt::Key_Return);
        QCOMPARE(typing.measurement().targets[1], 151.0);
        QVERIFY(cell.data(ReadingsModel::refusedRole).toString().isEmpty());
    }

    void blocksOfFourLocales_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("English: point") << block('.');
        QTest::newRow("French: comma") << block(',');
        QTest::newRow("Swedish: comma and typographical minus") << block(',').replace('-', "\u2212");
        QTest::newRow("Swiss: point, lines ended as on Windows") << block('.').replace("\n", "\r\n");
    }

    void blocksOfFourLocales() {
        QFETCH(QString, text);
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            setWindowLanguage(language);
            const TypingWindow typing(emptyTest());
            typing.setCurrent(0, 0);
            typing.paste(text);
            QVERIFY(typing.measurement().runs == published().runs);
            QCOMPARE(typing.window->model().undoStack()->count(), 1);
            QVERIFY(typing.find<QWidget>("pasteBar")->isVisible());
        }
    }

    void whatIsPastedStaysWhereItCameIn() {
        const TypingWindow typing(emptyTest());
        typing.setCurrent(0, 0);
        const auto place = [&] { return typing.view->mapTo(typing.window, QPoint(0, 0)); };
        const QPoint before = place();
        typing.paste("1,2\t3,4\n5,6\tabc");
        QVERIFY(typing.find<QWidget>("pasteBar")->isVisible());
        typing.window->grab(); // lays it out
        QCOMPARE(place(), before);
    }

    void theMenuOfTheTableOpensAtTargetsToo() {
        const TypingWindow typing(publishedTest());
        typing.setCurrent(0, 1);
        auto *frozen = typing.find<QTableView>("frozenReadings");
        const QRect cell = frozen->visualRect(typing.view->currentIndex().siblingAtColumn(1));
        QContextMenuEvent event(QContextMenuEvent::Mouse, cell.center(),
                                frozen->viewport()->mapToGlobal(cell.center()));
        QCoreApplication::sendEvent(frozen->viewport(), &event);
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        QVERIFY(menu);
        QVERIFY(menu->actions().contains(typing.find<QAction>("removeTargets")));
        menu->close();
    }

    void onePasteIsOneNamedStep() {
        const TypingWindow typing(emptyTest());
        typing.setCurrent(0, 0);
        typing.find<QToolButton>("groupByDirection")->click();
        typing.view->setFocus();
        QStringList up;
        for (std::size_t i = 0; i < 11; ++i) {
            QStringList cells;
            for (std::size_t j = 0; j < 10; j += 2)
                cells << typedText(*published().runs[j].deviations[i], '.');
            up << cells.join('\t');
        }
        typing.paste(up.join('\n'));
        QCOMPARE(typing.find<QAction>("undo")->text(), QString("&Undo: paste of 55 readings"));
        QVERIFY(typing.measurement().runs[8] == published().runs[8]);
        setWindowLanguage(Language::Id::french);
        QTRY_COMPARE(typing.find<QAction>("undo")->text(), QString("&Annuler\u00A0: collage de 55 relevés"));
        typing.find<QAction>("undo")->trigger();
        QVERIFY(!firstMissing(typing.measurement())->run && !firstMissing(typing.measurement())->target);
    }

    void decimalMarkAndContentAreChosenVisibly() {
        const TypingWindow typing(emptyTest());
        typing.setCurrent(0, 0);
        typing.paste("1,5\n2,25\n");
        QVERIFY(typing.find<QToolButton>("pasteComma")->isChecked());
        QCOMPARE(readingAt(typing.measurement(), {0, 0}), std::optional(0.0015));
        typing.find<QToolButton>("pastePoint")->click();
        QVERIFY(refusedAt(typing.measurement(), {0, 0}));
        QCOMPARE(typing.window->model().undoStack()->count(), 1);
        typing.find<QToolButton>("pasteComma")->click();
        auto *content = typing.find<QComboBox>("pasteContent");
        content->setCurrentIndex(1);
        emit content->activated(1);
        QCOMPARE(readingAt(typing.measurement(), {0, 0}), std::optional(1.5));
        QCOMPARE(typing.window->model().undoStack()->count(), 1);
        typing.view->setFocus();
        typing.type("1");
        typing.press(Qt::Key_Return);
        QVERIFY(!typing.find<QWidget>("pasteBar")->isVisible());
    }

    void theUnitOfTheHeadingIsReadAndShown() {
        const TypingWindow typing(emptyTest());
        typing.setCurrent(0, 0);
        typing.paste("Deviation (mm)\n0.0015\n0.0022\n");
        QCOMPARE(readingAt(typing.measurement(), {0, 0}), std::optional(0.0015));
        auto *content = typing.find<QComboBox>("pasteContent");
        QCOMPARE(content->currentText(), QString("Deviations mm"));
        QVERIFY(typing.find<QLabel>("pasteRemarks")->text().contains("read in mm, as the heading says"));
        emit content->activated(0);
        QCOMPARE(readingAt(typing.measurement(), {0, 0}), std::optional(0.0000015));
        QCOMPARE(content->currentIndex(), 0);
    }

    void copiesWhatCanBePasted() {
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            setWindowLanguage(language);
            const TypingWindow typing(publishedTest());
            auto &page = typing.window->workplace().readings();
            typing.view->selectionModel()->select(
                QItemSelection(typing.view->model()->index(0, 1), typing.view->model()->index(10, 11)),
                QItemSelectionModel::ClearAndSelect);
            typing.press(Qt::Key_C, Qt::ControlModifier);
            const QString copied = QGuiApplication::clipboard()->text();
            QCOMPARE(copied, page.copied());
            QVERIFY(copied.contains(language == Language::Id::french ? "1050,02\t-5,5" : "1050.02\t-5.5"));
            const TypingWindow other(emptyTest());
            other.view->setCurrentIndex(other.view->model()->index(0, 1));
            other.paste(copied);
            PositioningMeasurement expected = published();
            expected.cycle = Cycle::standard; // of the empty test: a block of readings does not say it
            QVERIFY(other.measurement() == expected);
            // Cutting leaves the same on the clipboard and takes it back in one step.
            other.view->selectionModel()->select(
                QItemSelection(other.view->model()->index(0, 2), other.view->model()->index(1, 3)),
                QItemSelectionModel::ClearAndSelect);
            other.press(Qt::Key_X, Qt::ControlModifier);
            QCOMPARE(QGuiApplication::clipboard()->text().count('\n'), 2);
            QVERIFY(!readingAt(other.measurement(), {0, 0}) && !readingAt(other.measurement(), {1, 1}));
            QCOMPARE(readingAt(other.measurement(), {0, 2}), readingAt(published(), {0, 2}));
            other.window->model().undoStack()->undo();
            QVERIFY(other.measurement() == expected);
        }
    }

    void setsAsideWithAReason() {
        const TypingWindow typing(publishedTest());
        typing.setCurrent(1, 1);
        typing.press(Qt::Key_E, Qt::ControlModifier);
        auto *dialog = typing.find<QInputDialog>("reasonDialog");
        dialog->setTextValue("beam interrupted");
        dialog->accept();
        const ExcludedReading *excluded = excludedAt(typing.measurement(), {1, 1});
        QVERIFY(excluded);
        QCOMPARE(excluded->reason, std::string("beam interrupted"));
        const QModelIndex cell = typing.view->model()->index(1, 3);
        QCOMPARE(cell.data().toString(), QString("5.4"));
        QVERIFY(cell.data(ReadingsModel::excludedRole).toBool());
        typing.press(Qt::Key_F2);
        typing.press(Qt::Key_Return); // looking at it changes nothing
        QVERIFY(excludedAt(typing.measurement(), {1, 1}));
        typing.setCurrent(1, 1);
        typing.press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(typing.measurement() == published());
    }

    /// Whatever is done over a reading set aside: it keeps value and reason, and it is said how to change it.
    void aReadingSetAsideIsNotLost_data() {
        QTest::addColumn<int>("way");
        QTest::newRow("typing") << 0;
        QTest::newRow("F2") << 1;
        QTest::newRow("Delete") << 2;
        QTest::newRow("Delete among others") << 3;
        QTest::newRow("cutting") << 4;
        QTest::newRow("pasting a number") << 5;
        QTest::newRow("pasting a dash") << 6;
        QTest::newRow("filling from above") << 7;
    }

    void aReadingSetAsideIsNotLost() {
        QFETCH(int, way);
        TypingWindow typing(publishedTest());
        const ReadingPlace place{1, 3};
        typing.window->model().edit("prepare", [&](Document &document) {
            editReadings(document, 0, [&](PositioningMeasurement &m) {
                setAside(m, std::vector{place}, "beam interrupted");
            });
        });
        const ExcludedReading aside = *excludedAt(typing.measurement(), place);
        typing.setCurrent(place.run, place.target);
        const QModelIndex cell = typing.view->currentIndex();
        if (way == 0) {
            typing.type("12");
        } else if (way == 1) {
            typing.press(Qt::Key_F2);
        } else if (way == 2) {
            typing.press(Qt::Key_Delete);
        } else if (way == 3) {
            typing.press(Qt::Key_Down, Qt::ShiftModifier);
            typing.press(Qt::Key_Delete);
            QVERIFY(!readingAt(typing.measurement(), {1, 4}));
        } else if (way == 4) {
            typing.press(Qt::Key_X, Qt::ControlModifier);
        } else if (way == 5) {
            typing.paste("7.7");
        } else if (way == 6) {
            typing.paste("-\n5");
            QVERIFY(readingAt(typing.measurement(), {1, 4}));
        } else if (way == 7) {
            typing.setCurrent(place.run, place.target - 1);
            typing.press(Qt::Key_Down, Qt::ShiftModifier);
            typing.press(Qt::Key_D, Qt::ControlModifier);
        }
        QVERIFY(!typing.view->findChild<QLineEdit *>("readingField"));
        QVERIFY(excludedAt(typing.measurement(), place));
        QCOMPARE(*excludedAt(typing.measurement(), place), aside);
        QVERIFY(!refusedAt(typing.measurement(), place));
        if (way <= 4 || way == 7) {
            const auto *reason = typing.view->findChild<QLabel *>("reason");
            QVERIFY(reason->isVisible());
            QVERIFY2(reason->text().contains("Ctrl+Shift+E"), qPrintable(reason->text()));
        }
        if (way == 5)
            QVERIFY(typing.find<QLabel>("pasteRemarks")->text().contains("set aside"));
        // Taken back, it is typed over as any other.
        typing.setCurrent(0, 0); // nothing else is selected
        typing.setCurrent(place.run, place.target);
        typing.press(Qt::Key_Up); // selects it alone, also where Ctrl was the last thing pressed
        typing.press(Qt::Key_Down);
        QCOMPARE(typing.view->currentIndex(), cell);
        typing.find<QAction>("bringBack")->trigger();
        QCOMPARE(readingAt(typing.measurement(), place), std::optional(aside.value));
        typing.type("12");
        typing.press(Qt::Key_Return);
        QCOMPARE(readingAt(typing.measurement(), place), std::optional(0.012));
        typing.window->model().undoStack()->undo();
        typing.window->model().undoStack()->undo();
        QCOMPARE(*excludedAt(typing.measurement(), place), aside);
    }

    void aPasteThatErasesSaysSo_data() {
        QTest::addColumn<QString>("block");
        QTest::addColumn<int>("erased");
        QTest::newRow("blanks") << "1\t\t3\n\t5\t6\n" << 2;
        QTest::newRow("dashes") << "1\t-\t3\n-\t5\t-\n" << 3;
        QTest::newRow("n/a") << "1\tn/a\t3\n" << 1;
        QTest::newRow("question mark") << "1\t?\t3\n" << 1;
        QTest::newRow("nothing") << "1\t2\t3\n" << 0;
    }

    void aPasteThatErasesSaysSo() {
        QFETCH(QString, block);
        QFETCH(int, erased);
        TypingWindow typing(publishedTest());
        const PositioningMeasurement before = typing.measurement();
        typing.setCurrent(0, 0);
        typing.paste(block);
        const QString summary = typing.find<QLabel>("pasteSummary")->text();
        QCOMPARE(summary.contains(QString("%1 erased").arg(erased)), erased > 0);
        QCOMPARE(summary.contains("erased"), erased > 0);
        // "n/a" is no empty cell.
        QCOMPARE(summary.contains("no number"), erased > 0 && block.contains(QRegularExpression("[-?a-z]")));
        QCOMPARE(summary.contains("empty cell"), erased > 0 && !summary.contains("no number"));
        typing.find<QToolButton>("pasteUndo")->click();
        QVERIFY(typing.measurement() == before);
        QVERIFY(!typing.find<QWidget>("pasteBar")->isVisible());
    }

    /// Under way the figure says how many readings it is of, and the status bar counts as the table does.
    void whatIsEnteredIsCounted() {
        TypingWindow typing(emptyTest());
        const auto note = [&] { return typing.find<QLabel>("figureNote")->text(); };
        const std::size_t targets = published().targets.size();
        QCOMPARE(typing.find<QLabel>("statusContent")->text(),
                 QString("%1 targets · 5 runs each way").arg(targets));
        QString block;
        for (std::size_t target = 0; target < targets; ++target)
            block += "1.5\t2.5\t3.5\t4.5\n";
        typing.setCurrent(0, 0);
        typing.paste(block);
        QTRY_VERIFY2(note().startsWith("n = 2 ·"), qPrintable(note()));
        typing.setCurrent(4, 0); // the third run upwards, one target
        typing.view->setFocus();
        typing.type("1.5");
        typing.press(Qt::Key_Return);
        QTRY_VERIFY2(note().startsWith("n = 2 … 3 ↑, 2 ↓ ·"), qPrintable(note()));
    }

    /// An undone paste has nothing more to choose: a choice would paste it once more.
    void undoClosesThePasteBar() {
        TypingWindow typing(publishedTest());
        typing.setCurrent(0, 0);
        typing.paste("1,5\t2,5\n3,5\t4,5\n");
        QVERIFY(typing.find<QWidget>("pasteBar")->isVisible());
        typing.find<QToolButton>("pastePoint")->click(); // under another choice it stays
        QVERIFY(typing.find<QWidget>("pasteBar")->isVisible());
        typing.find<QToolButton>("pasteComma")->click();
        typing.view->setFocus();
        typing.press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(typing.measurement() == published());
        QVERIFY(!typing.find<QWidget>("pasteBar")->isVisible());
    }

    void fillingFromNothingErasesNothing() {
        TypingWindow typing(publishedTest());
        typing.setCurrent(0, 0);
        typing.press(Qt::Key_Delete);
        const PositioningMeasurement before = typing.measurement();
        typing.press(Qt::Key_Down, Qt::ShiftModifier);
        typing.press(Qt::Key_D, Qt::ControlModifier);
        QVERIFY(typing.measurement() == before);
        QVERIFY(typing.view->findChild<QLabel *>("reason")->isVisible());
    }

    void fillsInsertsAndDeletes() {
        const TypingWindow typing(publishedTest());
        typing.view->selectionModel()->select(
            QItemSelection(typing.view->model()->index(2, 2), typing.view->model()->index(4, 2)),
            QItemSelectionModel::ClearAndSelect);
        typing.press(Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(readingAt(typing.measurement(), {0, 4}), readingAt(published(), {0, 2}));
        typing.find<QAction>("insertTargetBelow")->trigger();
        QCOMPARE(typing.measurement().targets.size(), std::size_t{12});
        typing.find<QToolButton>("addRunButton")->click();
        QCOMPARE(typing.measurement().runs.size(), std::size_t{12});
        typing.view->setCurrentIndex(typing.view->model()->index(0, 3));
        typing.find<QAction>("removeRuns")->trigger();
        QCOMPARE(typing.measurement().runs.size(), std::size_t{11});
        typing.view->setCurrentIndex(typing.view->model()->index(0, 2));
        typing.find<QAction>("removeTargets")->trigger();
        QCOMPARE(typing.measurement().targets.size(), std::size_t{11});
        typing.window->model().undoStack()->setIndex(0);
        QVERIFY(typing.measurement() == published());
    }

    void leavesOutTargetsWithoutReadings() {
        Test test = publishedTest();
        PositioningMeasurement &m = std::get<PositioningMeasurement>(test.measurement);
        for (Run &run : m.runs)
            run.deviations[2] = run.deviations[7] = std::nullopt;
        const TypingWindow typing(test);
        auto *leaveOut = typing.find<QToolButton>("leaveOutTargets");
        QVERIFY(leaveOut->isVisible());
        leaveOut->click();
        QCOMPARE(typing.measurement().targets.size(), m.targets.size() - 2);
        QVERIFY(targetsWithoutReading(typing.measurement()).empty());
        QVERIFY(!leaveOut->isVisible());
        typing.window->model().undoStack()->undo();
        QVERIFY(typing.measurement() == m);
        QVERIFY(leaveOut->isVisible());
    }

    void hintsAtATypingError() {
        const TypingWindow typing(publishedTest());
        typing.setCurrent(3, 6);
        typing.type("-45");
        typing.press(Qt::Key_Return);
        const QModelIndex cell = typing.view->model()->index(6, 5);
        QVERIFY(cell.data(ReadingsModel::outlierRole).toBool());
        QVERIFY(!cell.data(Qt::ToolTipRole).toString().isEmpty());
        QCOMPARE(readingAt(typing.measurement(), {3, 6}), std::optional(-0.045)); // and nothing is removed
    }

    /// Anything done a hundred times over: undone it is the beginning, redone the end.
    void undoToEmptyAndRedoToTheEnd() {
        const TypingWindow typing(publishedTest());
        const Document first = *typing.window->model().document();
        std::mt19937 random(230); // NOLINT: the same every time
        const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
        for (int step = 0; step < 100; ++step) {
            const int rows = typing.view->model()->rowCount();
            const int columns = static_cast<int>(typing.measurement().runs.size());
            if (rows > 0 && columns > 0)
                typing.view->setCurrentIndex(typing.view->model()->index(below(rows), 2 + below(columns)));
            typing.view->setFocus();
            switch (below(8)) {
            case 0:
                typing.press(Qt::Key_Delete);
                break;
            case 1:
                typing.paste("1.5\t2\n-3\tx\n");
                break;
            case 2:
                typing.find<QAction>("insertTargetAbove")->trigger();
                break;
            case 3:
                typing.find<QAction>("removeTargets")->trigger();
                break;
            case 4:
                typing.find<QAction>("insertRun")->trigger();
                break;
            case 5:
                typing.find<QAction>("removeRuns")->trigger();
                break;
            default:
                typing.type(QString::number(below(90)) + "." + QString::number(below(10)));
                typing.press(Qt::Key_Return);
            }
        }
        const Document last = *typing.window->model().document();
        QVERIFY(readDocument(writeDocument(last)) == last);
        QUndoStack &stack = *typing.window->model().undoStack();
        QVERIFY(stack.count() > 60);
        stack.setIndex(0);
        QVERIFY(*typing.window->model().document() == first);
        stack.setIndex(stack.count());
        QVERIFY(*typing.window->model().document() == last);
        const EvaluatedDocument fresh = evaluate(typing.window->model().document());
        const TestEvaluation &shown = *typing.window->evaluator().current().tests[0];
        QVERIFY(fresh.tests[0]->findings == shown.findings);
        QVERIFY(std::ranges::equal(fresh.tests[0]->parameters, shown.parameters, {}, &Parameter::value,
                                   &Parameter::value));
    }

    /// 12 000 readings are evaluated on a thread; who types meanwhile loses nothing.
    void editsWhileEvaluating() {
        Test test = largeTest();
        const PositioningMeasurement half = measurement(test);
        for (const Run &run : half.runs)
            measurement(test).runs.push_back(run);
        const TypingWindow typing(test);
        QTRY_VERIFY(!typing.window->evaluator().isBusy()); // shown
        int busy = 0;
        for (std::size_t i = 0; i < 40; ++i) {
            typing.setCurrent(0, i);
            typing.type("12.5");
            typing.press(Qt::Key_Return);
            busy += typing.window->evaluator().isBusy() ? 1 : 0;
        }
        QVERIFY(busy > 0);
        for (std::size_t i = 0; i < 40; ++i)
            QCOMPARE(readingAt(typing.measurement(), {0, i}), std::optional(0.0125));
        QTRY_VERIFY(!typing.window->evaluator().isBusy());
        QVERIFY(typing.window->evaluator().current().document == typing.window->model().document());
        QCOMPARE(typing.window->model().undoStack()->count(), 40);
    }

    /// The table shows the document that edits go to: of a large test only the results lag.
    void theTableIsNeverBehindTheDocument() {
        Test test = largeTest();
        const PositioningMeasurement half = measurement(test);
        for (const Run &run : half.runs)
            measurement(test).runs.push_back(run);
        const TypingWindow typing(test);
        QTRY_VERIFY(!typing.window->evaluator().isBusy());
        const QAbstractItemModel &table = *typing.view->model();
        const auto results = [&] { return typing.find<QTableView>("results")->model()->index(0, 2).data(); };
        const QVariant before = results();
        typing.setCurrent(0, 0);
        typing.find<QAction>("removeTargets")->trigger();
        QVERIFY(typing.window->evaluator().isBusy());
        QCOMPARE(table.rowCount(), 399);
        QCOMPARE(table.index(0, 1).data().toString(), QString("5")); // the second target is the first now
        QCOMPARE(results(), before);
        QVERIFY(typing.find<RightSide>("rightSide")->isComputing());
        typing.setCurrent(0, 0);
        typing.type("77.7");
        typing.press(Qt::Key_Return);
        QVERIFY(typing.window->evaluator().isBusy());
        QCOMPARE(table.index(0, 2).data().toString(), QString("77.7"));
        QCOMPARE(readingAt(typing.measurement(), {0, 0}), std::optional(0.0777));
        QCOMPARE(typing.measurement().targets.front(), 5.0);
        typing.window->model().undoStack()->undo();
        typing.window->model().undoStack()->undo();
        QCOMPARE(table.rowCount(), 400);
        QTRY_VERIFY(!typing.window->evaluator().isBusy());
        QVERIFY(!typing.find<RightSide>("rightSide")->isComputing());
        QCOMPARE(results(), before);
        // Between two tests the results of one never stand beside the readings of the other.
        Test small = publishedTest();
        small.id = "small";
        typing.window->model().edit("add", [&](Document &document) { insertTest(document, 1, small); });
        QTRY_VERIFY(!typing.window->evaluator().isBusy());
        typing.window->workplace().showTest(1);
        typing.window->model().edit("change", [](Document &document) {
            auto changed = std::make_shared<Test>(*document.tests[0]);
            std::get<PositioningMeasurement>(changed->measurement).runs[0].deviations[0] = 0.5;
            document.tests[0] = std::move(changed);
        });
        QVERIFY(typing.window->evaluator().isBusy());
        typing.window->workplace().showTest(0);
        QCOMPARE(typing.find<QTableView>("results")->model()->rowCount(), 0);
        QTRY_VERIFY(!typing.window->evaluator().isBusy());
        QVERIFY(typing.find<QTableView>("results")->model()->rowCount() > 0);
    }

    void aNewTestFromTheWindow() {
        const ShownWindow shown;
        QTimer::singleShot(0, shown.window, [] {
            auto *dialog = QApplication::activeModalWidget();
            QVERIFY(dialog);
            const auto field = [&](const char *name) {
                return dialog->findChild<QLineEdit *>(QLatin1StringView(name));
            };
            field("newAxis")->setText("Y");
            field("newTravel")->setText("1800");
            auto *list = dialog->findChild<QPlainTextEdit *>("newTargets");
            QCOMPARE(list->toPlainText().count(';'), 8); // five a metre
            field("newTravel")->setText("4000");
            QCOMPARE(dialog->findChild<QLineEdit *>("newRuns")->text(), "1"); // once over the whole of it
            field("newTravel")->setText("1800");
            QCOMPARE(dialog->findChild<QLineEdit *>("newRuns")->text(), "5");
            list->setPlainText("0 150,71 300,85");
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        shown.find<QAction>("new")->trigger();
        QVERIFY(shown.window->hasDocument());
        QVERIFY(shown.window->isWindowModified());
        const Document &document = *shown.window->model().document();
        const auto &m = std::get<PositioningMeasurement>(document.tests.at(0)->measurement);
        QCOMPARE(m.targets, (std::vector<double>{0, 150.71, 300.85}));
        QCOMPARE(m.axis.travel, std::optional(1800.0));
        QCOMPARE(m.runs.size(), std::size_t{10});
        QCOMPARE(shown.window->workplace().selection().reading(), (ReadingPlace{0, 0}));
        QCOMPARE(shown.window->focusWidget()->objectName(), QString("readings"));
    }

    void aSecondTestTakesOverWhatIsStated() {
        for (const bool taken : {true, false}) {
            palmer::Test first = positioningTest("ISO 230-2:2014", {0, 10}, {{0, 1}}, {{1, 2}});
            first.decisionRule.rule = Rule::iso14253_1;
            std::get<PositioningMeasurement>(first.measurement).axis.name = "X";
            const TypingWindow shown(first);
            QTimer::singleShot(0, shown.window, [taken] {
                auto *dialog = QApplication::activeModalWidget();
                QVERIFY(dialog);
                auto *name = dialog->findChild<QLineEdit *>("newAxis");
                QCOMPARE(name->text(), QString("Y"));
                QCOMPARE(name->selectedText(), QString("Y"));
                auto *box = dialog->findChild<QCheckBox *>("takeStatements");
                QVERIFY(box->isVisible() && box->isChecked());
                QVERIFY(box->text().contains("X"));
                box->setChecked(taken);
                QTest::keyClick(dialog, Qt::Key_Return);
            });
            shown.find<QAction>("addTest")->trigger();
            const Document &after = *shown.window->model().document();
            QCOMPARE(after.tests.size(), std::size_t{2});
            QCOMPARE(after.tests[1]->decisionRule.rule, taken ? Rule::iso14253_1 : Rule::simpleAcceptance);
            QCOMPARE(shown.window->model().undoStack()->count(), 1);
        }
    }

    void theTargetsOfANewTestAreChosenAfterItsEdition() {
        for (const bool typed : {false, true}) {
            const ShownWindow shown;
            QTimer::singleShot(0, shown.window, [typed] {
                auto *dialog = QApplication::activeModalWidget();
                QVERIFY(dialog);
                if (typed)
                    dialog->findChild<QPlainTextEdit *>("newTargets")->setPlainText("0 200 400 600 800");
                QTest::keyClick(dialog, Qt::Key_Return);
            });
            shown.find<QAction>("new")->trigger();
            const Document &document = *shown.window->model().document();
            const auto &m = std::get<PositioningMeasurement>(document.tests.at(0)->measurement);
            QCOMPARE(m.targetChoice.kind, typed ? TargetChoiceKind::notStated : TargetChoiceKind::free);
            if (typed)
                continue;
            // The seed in the file gives the same targets again.
            TargetRequest request;
            request.from = 1;
            request.travel = 998;
            request.seed = static_cast<std::uint64_t>(m.targetChoice.seed.value());
            QCOMPARE(m.targets, planTargets(request).targets);
            const auto &findings = shown.window->evaluator().current().tests[0]->findings;
            QVERIFY(std::ranges::none_of(findings, [](const Finding &f) { return f.id == "evenSpacing"; }));
        }
    }

    void testsAreRenamedRepeatedAndDeleted() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        DocumentModel &model = shown.window->model();
        shown.find<QAction>("renameTest")->trigger();
        auto *dialog = shown.find<QInputDialog>("renameDialog");
        dialog->setTextValue("as found");
        dialog->accept();
        QCOMPARE(model.document()->tests[0]->title, std::string("as found"));
        shown.find<QAction>("repeatTest")->trigger();
        QCOMPARE(model.document()->tests.size(), std::size_t{2});
        QCOMPARE(shown.window->workplace().selection().test(), std::size_t{1});
        shown.find<QAction>("deleteTest")->trigger();
        shown.find<QAction>("deleteTest")->trigger();
        QVERIFY(model.document()->tests.empty());
        QVERIFY(!shown.find<QAction>("deleteTest")->isEnabled());
        model.undoStack()->setIndex(0);
        QCOMPARE(model.document()->tests.size(), std::size_t{1});
        QVERIFY(!shown.window->isWindowModified());
    }
};

QTEST_MAIN(TypingTest)
#include "typing.moc"
