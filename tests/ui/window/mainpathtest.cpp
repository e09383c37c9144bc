// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "core/register/registerdata.h"
#include "ui/forms/field.h"
#include "ui/model/page.h"
#include "ui/window/liketest.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

/// Works in the window as a hand does, and counts: a click, a key with its modifiers, a field that is typed.
class Hand {
public:
    explicit Hand(const ShownWindow &shown)
        : m_shown(shown) {}

    void click(QWidget &button) {
        ++clicks;
        QTest::mouseClick(&button, Qt::LeftButton);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        ++keys;
        QTest::keyClick(focused(), key, with);
    }
    void write(const QString &text) {
        for (const QChar letter : text) // the first one may open an editor
            QTest::keyClicks(focused(), letter);
    }
    /// A command of a menu, by its shortcut if it has one: a click to open the menu and one to choose else.
    void command(const char *action) {
        auto *named = m_shown.find<QAction>(action);
        if (named->shortcut().isEmpty())
            clicks += 2;
        else
            ++keys;
        named->trigger();
    }
    void type(const QString &key, int index, const QString &text) {
        ++fields;
        QList<QLineEdit *> found;
        for (auto *field : m_shown.find("conditionsPage")->findChildren<Field *>()) {
            if (field->edit()->objectName().startsWith(u"field.%1."_s.arg(key)))
                found << qobject_cast<QLineEdit *>(field->edit());
        }
        if (index >= found.size() || !found[index])
            qFatal("no field %s", qPrintable(key));
        found[index]->setFocus(Qt::TabFocusReason);
        QTest::keyClicks(found[index], text);
        QTest::keyClick(found[index], Qt::Key_Return);
    }
    /// Answers what has the focus: a number, a date, words, the first choice.
    void answer() {
        QWidget *at = focused();
        const QString name = at->objectName();
        if (auto *line = qobject_cast<QLineEdit *>(at)) {
            const bool isNumber = line->alignment().testFlag(Qt::AlignRight);
            QTest::keyClicks(at, name.contains(u"range") || name.contains(u"zone") ? u"0 … 500"_s
                                 : isNumber                                        ? u"20"_s
                                 : name.contains(u"ate")                           ? u"today"_s
                                                                                   : u"stated"_s);
            press(Qt::Key_Return);
        } else if (qobject_cast<QPlainTextEdit *>(at)) {
            QTest::keyClicks(at, "stated");
        } else if (qobject_cast<QComboBox *>(at)) {
            press(Qt::Key_Down);
        } else {
            press(Qt::Key_Space);
        }
        ++fields;
    }
    [[nodiscard]] int gestures() const { return clicks + keys + fields; }

    [[nodiscard]] QWidget *focused() const {
        QWidget *at =
            QApplication::focusWidget() ? QApplication::focusWidget() : m_shown.window->focusWidget();
        return at ? at : m_shown.window.data();
    }

    int clicks = 0;
    int keys = 0;
    int fields = 0;

private:
    const ShownWindow &m_shown;
};

/// The readings of a test as a spreadsheet has them, µm.
QString readingTexts(const Test &test) {
    const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    QStringList lines;
    for (std::size_t target = 0; target < measurement.targets.size(); ++target) {
        QStringList cells;
        for (const Run &run : measurement.runs)
            cells << QString::number(run.deviations[target].value_or(0) * 1000, 'f', 1);
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n');
}

/// True if every reading was taken.
bool isMeasured(const PositioningMeasurement &measurement) {
    return std::ranges::all_of(measurement.runs, [](const Run &run) {
        return std::ranges::all_of(run.deviations, [](const auto &reading) { return reading.has_value(); });
    });
}

int missing(const ShownWindow &shown, std::size_t test) {
    return countMissing(shown.window->evaluator().current(), test, Page::conditions) +
           countMissing(shown.window->evaluator().current(), test, Page::agreedPoints);
}

} // namespace

/// How many gestures the main path takes.
class MainPathTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }

    /// The same axis again, in the same file.
    void aRepeatTakesTwelveGesturesAtMost() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        const auto document = [&]() -> const Document & { return *shown.window->model().document(); };
        const int open = missing(shown, 0);
        const QString readings = readingTexts(*document().tests[0]);
        const std::size_t repeated = 1;
        Hand hand(shown);
        hand.command("repeatTest");
        QCOMPARE(shown.window->workplace().selection().test(), repeated);
        QVERIFY(missing(shown, repeated) > open); // what was measured that day
        QGuiApplication::clipboard()->setText(readings);
        shown.window->workplace().beginTyping();
        hand.press(Qt::Key_V, Qt::ControlModifier);
        hand.command("page2");
        QTest::qWait(20);
        hand.type(u"date"_s, 0, u"today"_s);
        // Air has no sensor in this example: machine and instrument, start and end.
        for (const int place : {3, 4, 6, 7})
            hand.type(u"sensors"_s, place, u"20.5"_s);
        const Test &test = *document().tests[repeated];
        const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        QVERIFY(measurement.runs == std::get<PositioningMeasurement>(document().tests[0]->measurement).runs);
        QVERIFY(test.date && test.limits == document().tests[0]->limits);
        qInfo("repeat: %d clicks, %d keys, %d fields", hand.clicks, hand.keys, hand.fields);
        QVERIFY2(missing(shown, repeated) <= open, qPrintable(QString::number(missing(shown, repeated))));
        QVERIFY2(hand.gestures() + 1 <= 12, // with Ctrl+S
                 qPrintable(QString::number(hand.gestures())));
    }

    /// A new test of the axis: what the last one states is taken in one click.
    void aNewTestTakesWhatTheLastOneStates() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        const std::size_t added = shown.window->model().document()->tests.size();
        Hand hand(shown);
        QTimer::singleShot(0, shown.window, [] {
            auto *dialog = QApplication::activeModalWidget();
            dialog->findChild<QLineEdit *>("newAxis")->setText("X");
            dialog->findChild<QCheckBox *>("takeStatements")->setChecked(false);
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        hand.command("addTest");
        const int before = missing(shown, added);
        hand.command("page2");
        QTest::qWait(20);
        hand.click(*shown.find<QPushButton>("likeLast"));
        const int after = missing(shown, added);
        QVERIFY2(after < before, qPrintable(u"%1 → %2"_s.arg(before).arg(after)));
        const Document &document = *shown.window->model().document();
        QVERIFY(!document.tests[added]->date);
        QCOMPARE(document.tests[added]->instruments, document.tests[0]->instruments);
        QVERIFY(std::get<PositioningMeasurement>(document.tests[added]->measurement).axis.positionFeedback ==
                std::get<PositioningMeasurement>(document.tests[1]->measurement).axis.positionFeedback);
        qInfo("new test: %d missing, %d after one click, %d gestures", before, after, hand.gestures());
        hand.click(*shown.find<QPushButton>("undoLike"));
        QCOMPARE(missing(shown, added), before);
    }

    /// The register offers the newest test of the machine, rather one of the same axis, and never the file
    /// itself.
    void theRegisterKnowsTheLastTest() {
        const QTemporaryDir folder;
        const auto add = [&](const QString &name, const char *serial, const char *axis, const char *date) {
            testdata::Sample sample;
            sample.serial = serial;
            sample.axis = axis;
            sample.date = date;
            testdata::writeFile(folder.filePath(name), testdata::fileOf(sample));
        };
        add(u"older.palmer"_s, "000-017", "X", "2024-02-13");
        add(u"last.palmer"_s, "000-017", "X", "2025-04-16");
        add(u"otherAxis.palmer"_s, "000-017", "Y", "2025-06-01");
        add(u"otherMachine.palmer"_s, "000-018", "X", "2026-01-01");
        add(u"own.palmer"_s, "000-017", "X", "2026-02-02");
        const QString address = folder.filePath(u"register.sqlite"_s);
        {
            Register made(address);
            QCOMPARE(scan(made, {folder.path()}).tests, 5);
        }
        const QString own = folder.filePath(u"own.palmer"_s);
        QFile file(own);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto open = std::make_shared<const Document>(readDocument(file.readAll()));
        const auto like = lastTestOfMachine(open, 0, own, address);
        QVERIFY(like);
        QCOMPARE(QFileInfo(like->file).fileName(), u"last.palmer"_s);
        QCOMPARE(QString::fromStdString(*like->document->tests[like->test]->date), u"2025-04-16"_s);
        // A document that names no machine takes the one that was chosen.
        Document nameless = *open;
        nameless.machine = {};
        const auto without = std::make_shared<const Document>(std::move(nameless));
        QVERIFY(!lastTestOfMachine(without, 0, own, address));
        const QStringList machines = machinesOfRegister(address);
        QCOMPARE(machines.size(), 2);
        for (const QString &machine : machines) {
            const auto chosen = lastTestOfMachine(without, 0, own, address, machine);
            QVERIFY(chosen);
            QCOMPARE(QString::fromStdString(chosen->document->machine.serialNumber),
                     machine.section(u" · "_s, -1));
        }
    }

    /// From nothing to the report without the pointer.
    void theKeyboardAloneIsEnough() {
        const ShownWindow shown({}, {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        Hand hand(shown);
        QTimer::singleShot(300, shown.window, [&] { // the dialog is active by then
            QWidget *dialog = QApplication::activeModalWidget();
            hand.keys += 3;
            QTest::keyClick(dialog, Qt::Key_R, Qt::AltModifier);
            QTest::keyClicks(dialog->focusWidget(), "2");
            QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
        });
        hand.press(Qt::Key_N, Qt::ControlModifier);
        QVERIFY(shown.window->hasDocument());
        shown.window->activateWindow(); // as a window manager does
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        const auto test = [&]() -> const Test & { return *shown.window->model().document()->tests[0]; };
        const auto &measured = [&]() -> const PositioningMeasurement & {
            return std::get<PositioningMeasurement>(test().measurement);
        };
        const auto readings = measured().targets.size() * measured().runs.size();
        for (std::size_t i = 0; i < readings; ++i) { // Return goes to the next one of the cycle
            hand.write(i % 3 == 0 ? u"1.2"_s : u"-0.4"_s);
            hand.press(Qt::Key_Return);
        }
        QVERIFY(isMeasured(measured()));
        hand.press(Qt::Key_4, Qt::ControlModifier);
        hand.press(Qt::Key_Tab);
        while (!qobject_cast<QLineEdit *>(QApplication::focusWidget()) && hand.keys < 1000)
            hand.press(Qt::Key_Tab);
        hand.write(u"20"_s);
        hand.press(Qt::Key_Return);
        QVERIFY(hasLimits(test().limits));
        hand.press(Qt::Key_2, Qt::ControlModifier);
        const auto open = [&] { return countMissing(shown.window->evaluator().current()); };
        QTRY_VERIFY(!shown.window->evaluator().isBusy());
        const int asked = open();
        QVERIFY(asked > 5);
        const auto left = [&] {
            QStringList ids;
            for (const Finding &finding : shown.window->evaluator().current().tests[0]->findings) {
                const bool isMethod =
                    finding.id == "uncertainty"; // chosen with its inputs, no single statement
                if (lackOf(finding) == Lack::required && !isMethod)
                    ids << QString::fromStdString(finding.id);
            }
            return ids;
        };
        for (int i = 0; i < 3 * asked && !left().isEmpty(); ++i) {
            hand.press(Qt::Key_F8);
            hand.answer();
            QTRY_VERIFY(!shown.window->evaluator().isBusy());
        }
        QVERIFY2(left().isEmpty(), qPrintable(left().join(u", "_s)));
        QTimer::singleShot(500, shown.window, [] { // the dialog is active by then
            QWidget *dialog = QApplication::activeModalWidget();
            QCOMPARE(dialog->objectName(), u"reportDialog"_s);
            const auto *save = dialog->findChild<QPushButton *>("savePdf");
            QVERIFY(save->isDefault()); // Return writes the PDF
            QTest::keyClick(dialog, Qt::Key_Escape);
        });
        hand.press(Qt::Key_P, Qt::ControlModifier);
        QCOMPARE(hand.clicks, 0);
        qInfo("new test to report: %d keys besides %d readings, %d statements", hand.keys - int(readings),
              int(readings), asked);
    }

    /// The chip is the button to the next missing statement: its number is that of marks and badge.
    void theCountLeadsToWhatItCounts() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        shown.window->workplace().showPage(Page::conditions);
        QTest::qWait(20);
        auto *chip = shown.find("conditionsPage")->findChild<QAbstractButton *>("missingChip");
        const int counted = countMissing(shown.window->evaluator().current(), 0, Page::conditions);
        QVERIFY(chip->isVisible() && chip->text().startsWith(QString::number(counted)));
        int marked = 0;
        for (auto *field : shown.find("conditionsPage")->findChildren<Field *>())
            marked += field->isRequired();
        QCOMPARE(marked, counted);
        chip->setFocus();
        QTest::keyClick(chip, Qt::Key_Return);
        const auto isMarked = [] {
            const auto *field = QApplication::focusWidget()
                                    ? qobject_cast<Field *>(QApplication::focusWidget()->parentWidget())
                                    : nullptr;
            return field && field->isRequired();
        };
        QTRY_VERIFY(isMarked());
        auto *unmet = shown.find<QAbstractButton>("accordanceChip");
        QTest::mouseClick(unmet, Qt::LeftButton);
        QTRY_VERIFY(shown.find("findings")->hasFocus());
    }
};

QTEST_MAIN(MainPathTest)
#include "mainpathtest.moc"
