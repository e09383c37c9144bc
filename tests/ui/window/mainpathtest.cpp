// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "ui/forms/field.h"
#include "ui/model/page.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
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
        QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : m_shown.window.data(),
                        key, with);
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
    [[nodiscard]] int gestures() const { return clicks + keys + fields; }

    int clicks = 0;
    int keys = 0;
    int fields = 0;

private:
    const ShownWindow &m_shown;
};

/// The readings of a test as a spreadsheet has them, µm.
QString readingsOf(const Test &test) {
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
        const QString readings = readingsOf(*document().tests[0]);
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
