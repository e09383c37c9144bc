// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "ui/dialogs/feeddialog.h"
#include "ui/dialogs/newcircledialog.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/dialogs/plandialog.h"

#include <QAbstractSpinBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

/// A field shows what was typed, letter by letter, or says below why it cannot be: nothing is rewritten or
/// clamped.
class TypedNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void everyFieldKeepsWhatIsTyped_data() {
        QTest::addColumn<QString>("dialog");
        for (const char *name : {"new test", "new circle", "feed", "plan"})
            QTest::newRow(name) << name;
    }

    void everyFieldKeepsWhatIsTyped() {
        QFETCH(QString, dialog);
        DocumentModel model;
        const std::unique_ptr<QDialog> shown = [&]() -> std::unique_ptr<QDialog> {
            const Language english(Language::Id::english);
            if (dialog == "new test")
                return std::make_unique<NewTestDialog>(english);
            if (dialog == "new circle")
                return std::make_unique<NewCircleDialog>(english);
            if (dialog == "feed")
                return std::make_unique<FeedDialog>();
            return std::make_unique<PlanDialog>(model, 0);
        }();
        shown->show();
        shown->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(shown.get()));
        QVERIFY(shown->findChildren<QAbstractSpinBox *>().isEmpty()); // they clamp in silence
        int fields = 0;
        for (auto *field : shown->findChildren<QLineEdit *>()) {
            if (!field->isVisible() || !(field->alignment() & Qt::AlignRight))
                continue;
            ++fields;
            field->setFocus();
            QVERIFY(field->hasFocus());
            for (const QString text :
                 {"20", "0", "-50", "980", "100", "1000000", "1e999", "4,,8", "0.25", "x"}) {
                field->selectAll();
                QTest::keyClick(field, Qt::Key_Backspace);
                QCOMPARE(field->text(), QString());
                for (qsizetype i = 0; i < text.size(); ++i) {
                    QTest::keyClick(field, text[i].toLatin1());
                    QCOMPARE(field->text(), text.left(i + 1));
                }
                if (text == "4,,8" || text == "x") {
                    const auto labels = shown->findChildren<QLabel *>();
                    QVERIFY2(std::ranges::any_of(labels,
                                                 [](const QLabel *label) {
                                                     return label->isVisible() &&
                                                            label->text().endsWith('.') &&
                                                            (label->objectName() == "refusal" ||
                                                             label->objectName().endsWith("Problem"));
                                                 }),
                             qPrintable(field->objectName() + ": " + text));
                }
            }
            field->selectAll();
            QTest::keyClicks(field, "20");
        }
        QVERIFY(fields >= 2);
    }

    void limitsAreSaid_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence"); ///< empty: taken
        QTest::newRow("a million targets") << "newCount"
                                           << "1000000"
                                           << "from 2 to 10\u202F000";
        QTest::newRow("as many as can be") << "newCount"
                                           << "10000"
                                           << "";
        QTest::newRow("one target") << "newCount"
                                    << "1"
                                    << "from 2 to";
        QTest::newRow("a hundred runs") << "newRuns"
                                        << "100"
                                        << "";
        QTest::newRow("a thousand runs") << "newRuns"
                                         << "1000"
                                         << "";
        QTest::newRow("more runs") << "newRuns"
                                   << "1001"
                                   << "from 1 to 1\u202F000";
        QTest::newRow("half a run") << "newRuns"
                                    << "2.5"
                                    << "whole number";
        QTest::newRow("first 20") << "newFirst"
                                  << "20"
                                  << "";
        QTest::newRow("first 0") << "newFirst"
                                 << "0"
                                 << "";
        QTest::newRow("first -50") << "newFirst"
                                   << "-50"
                                   << "";
        QTest::newRow("last 980") << "newLast"
                                  << "980"
                                  << "";
        QTest::newRow("last below the first") << "newLast"
                                              << "-980"
                                              << "above the first";
    }

    void limitsAreSaid() {
        QFETCH(QString, field);
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        NewTestDialog dialog{Language(Language::Id::english)};
        dialog.show();
        auto *edit = dialog.findChild<QLineEdit *>(field);
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QCOMPARE(edit->text(), text);
        const auto *problem = dialog.findChild<QLabel *>("newProblem");
        QCOMPARE(problem->isVisible(), !sentence.isEmpty());
        QVERIFY2(problem->text().contains(sentence), qPrintable(problem->text()));
        QCOMPARE(dialog.findChild<QPushButton *>("createTest")->isEnabled(), sentence.isEmpty());
        if (!sentence.isEmpty())
            return;
        const NewPositioningTest wanted = dialog.wanted();
        if (field == "newCount")
            QCOMPARE(wanted.targets.size(), text.toULongLong());
        else if (field == "newRuns")
            QCOMPARE(wanted.runs, text.toInt());
    }

    /// A list that was pasted says how it was read; another unit reads it anew.
    void aPastedListSaysItsUnit() {
        NewTestDialog dialog{Language(Language::Id::english)};
        dialog.show();
        auto *list = dialog.findChild<QPlainTextEdit *>("newTargets");
        const auto *bar = dialog.findChild<QWidget *>("pasteBar");
        list->setPlainText("0; 1; 2");
        QVERIFY(!bar->isVisible());
        QGuiApplication::clipboard()->setText("Target (mm)\n0\n1\n2\n");
        list->paste();
        QVERIFY(bar->isVisible());
        QCOMPARE(dialog.wanted().targets, (std::vector<double>{0, 1, 2}));
        auto *unit = dialog.findChild<QComboBox *>("paste.positionUnit");
        QCOMPARE(unit->currentData().toString(), QString("mm"));
        unit->setCurrentIndex(unit->findData("in"));
        emit unit->activated(unit->currentIndex());
        QCOMPARE(dialog.wanted().targets, (std::vector<double>{0, 25.4, 50.8}));
    }

    /// The random part keeps the last target before the end that was typed; a typed list has no such end.
    void whyTheLastTargetIsNotTheOneTyped() {
        NewTestDialog dialog{Language(Language::Id::english)};
        dialog.show();
        auto *last = dialog.findChild<QLineEdit *>("newLast");
        last->selectAll();
        QTest::keyClicks(last, "900");
        const auto *why = dialog.findChild<QLabel *>("newWhy");
        QVERIFY(why->isVisible() && dialog.wanted().targets.back() < 900);
        const QString text = why->text().replace(QChar(0xA0), ' ');
        QVERIFY2(text.contains("not 900 mm") && text.contains("random part"), qPrintable(text));
        dialog.findChild<QPlainTextEdit *>("newTargets")->setPlainText("0; 450; 900");
        QVERIFY(!why->isVisible());
    }

    /// What another first target has replaced comes back by one step.
    void aTypedListComesBack() {
        NewTestDialog dialog{Language(Language::Id::english)};
        dialog.show();
        auto *list = dialog.findChild<QPlainTextEdit *>("newTargets");
        const QString proposed = list->toPlainText();
        QVERIFY(!proposed.isEmpty());
        const QString typed = "0; 7; 11";
        list->selectAll();
        QTest::keyClicks(list, typed);
        QCOMPARE(list->toPlainText(), typed);
        auto *first = dialog.findChild<QLineEdit *>("newFirst");
        QCOMPARE(first->text(), QString("0")); // what is beside a list is said of it
        QCOMPARE(dialog.findChild<QLineEdit *>("newLast")->text(), QString("11"));
        QCOMPARE(dialog.findChild<QLineEdit *>("newCount")->text(), QString("3"));
        first->selectAll();
        QTest::keyClicks(first, "123");
        QVERIFY(list->toPlainText() != typed);
        QVERIFY(list->toPlainText() != proposed);
        QVERIFY(dialog.wanted().targets.front() >= 123); // its random part is another each time
        QTest::keyClick(list, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(list->toPlainText(), typed);
        QCOMPARE(dialog.wanted().targets, (std::vector<double>{0, 7, 11}));
    }
};

QTEST_MAIN(TypedNumbersTest)
#include "typednumberstest.moc"
