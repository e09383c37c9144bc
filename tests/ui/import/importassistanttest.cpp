// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/import/importassistant.h"

#include "document/sha256.h"
#include "import/choices.h"
#include "import/layouts/columnrole.h"
#include "kernel/evaluation/edition.h"
#include "ui/elidedlabel.h"
#include "ui/remarklist.h"
#include "ui/window/shownwindow.h"
#include "ui/windowlanguage.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;

namespace {

QByteArray bytesOf(const char *name) {
    QFile file(QString(DATA) + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no %s", name);
    return file.readAll();
}

const PositioningMeasurement &positioning(const Test &test) {
    return std::get<PositioningMeasurement>(test.measurement);
}

void pick(const QWidget &dialog, const QString &box, const QString &word) {
    auto *words = dialog.findChild<QComboBox *>(box);
    QVERIFY2(words, qPrintable(box));
    words->setCurrentIndex(words->findData(word));
    QVERIFY2(words->currentIndex() >= 0, qPrintable(word));
    emit words->activated(words->currentIndex());
}

void type(const QWidget &dialog, const QString &field, const QString &text) {
    auto *edit = dialog.findChild<QLineEdit *>(field);
    QVERIFY2(edit, qPrintable(field));
    edit->setText(text);
    edit->setModified(true);
    emit edit->editingFinished();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // what was said before
}

QPushButton *importButton(const QWidget &dialog) {
    return dialog.findChild<QPushButton *>("acceptImport");
}

/// Answers every question as it is proposed, by clicks; data that were not read are left out.
void answerAll(const ImportAssistant &dialog) {
    for (int i = 0; i < 10 && !dialog.imported().questions.empty(); ++i) {
        if (auto *leave = dialog.findChild<QPushButton *>("answer.unread.leave"))
            leave->click();
        dialog.findChild<QPushButton *>("confirmAll")->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        // A doubt is confirmed by itself.
        const std::vector<Question> &open = dialog.imported().questions;
        if (auto *one = open.empty() ? nullptr
                                     : dialog.findChild<QPushButton *>("confirm." +
                                                                       QString::fromStdString(open[0].id)))
            one->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(dialog.imported().questions.empty());
}

QStringList openQuestions(const ImportAssistant &dialog) {
    QStringList ids;
    for (const Question &question : dialog.imported().questions)
        ids << QString::fromStdString(question.id);
    ids.sort();
    return ids;
}

/// Clicks on the role of a column (from 0) and on a word of the menu that opens.
void pickRole(const ImportAssistant &dialog, int column, const QString &word) {
    auto *columns = dialog.findChild<QTableView *>("importColumns");
    const QModelIndex cell = columns->model()->index(0, column);
    columns->scrollTo(cell);
    QTest::mouseClick(columns->viewport(), Qt::LeftButton, {}, columns->visualRect(cell).center());
    auto *menu = columns->findChild<QMenu *>("roleMenu");
    QVERIFY(menu && menu->isVisible());
    for (QAction *action : menu->actions()) {
        if (action->data().toString() == word) {
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return;
        }
    }
    QFAIL(qPrintable(word));
}

QString roleShown(const ImportAssistant &dialog, int column) {
    return dialog.findChild<QTableView *>("importColumns")->model()->index(0, column).data().toString();
}

/// Answers what is asked of the assistant that the window shows, and imports.
void importShown(const ShownWindow &shown);

/// The assistant that the window shows.
ImportAssistant &assistantOf(const ShownWindow &shown) {
    auto *dialog = shown.window->findChild<ImportAssistant *>();
    if (!dialog || !dialog->isVisible())
        qFatal("no assistant");
    return *dialog;
}

void importShown(const ShownWindow &shown) {
    answerAll(assistantOf(shown));
    importButton(assistantOf(shown))->click();
}

} // namespace

/// The import assistant, alone and in the window.
class ImportAssistantTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        setWindowLanguage(Language::Id::english);
        QFile::remove(importProfilesPath());
    }

    void showsTextTableChoicesAndRemarks() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        QCOMPARE(importButton(dialog)->text(), QString("&Import 23 readings"));
        QVERIFY(dialog.findChild<QLabel *>("guessed.sign")->isVisible());
        QVERIFY(!dialog.findChild<QLabel *>("guessed.unit")->isVisible()); // the file says µm
        const auto *raw = dialog.findChild<QAbstractItemView *>("importRaw")->model();
        QCOMPARE(raw->index(3, 0).data().toString(), QString("0,00;-3,0;2,3;-2,0;1,1;-1,9;3,2"));
        const auto pieces = qobject_cast<const RawTextModel *>(raw)->pieces(3);
        QCOMPARE(pieces[0].role, CellRole::position);
        QCOMPARE(pieces[2].role, CellRole::positive);
        QCOMPARE(pieces[4].role, CellRole::negative);
        QVERIFY(qobject_cast<const RawTextModel *>(raw)->isProblem(6)); // "-4,,7"
        const auto *table = dialog.findChild<QAbstractItemView *>("importTable")->model();
        QCOMPARE(table->rowCount(), 4);
        QCOMPARE(table->columnCount(), 7);
        QCOMPARE(table->index(0, 1).data().toString(), QString("−3.0"));
        QCOMPARE(table->index(3, 6).data().toString(), QString("–"));
    }

    void linesStandAsInTheFile_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("lines");
        const QStringList three{"a;1", "", "b;2"};
        QTest::newRow("\\n") << QByteArray("a;1\n\nb;2\n") << three;
        QTest::newRow("no end of the last") << QByteArray("a;1\n\nb;2") << three;
        QTest::newRow("\\r\\n") << QByteArray("a;1\r\n\r\nb;2\r\n") << three;
        QTest::newRow("\\r") << QByteArray("a;1\r\rb;2\r") << three;
        QTest::newRow("all of them") << QByteArray("a;1\r\n\rb;2\nc") << QStringList{"a;1", "", "b;2", "c"};
        QTest::newRow("nothing") << QByteArray() << QStringList();
    }
    void linesStandAsInTheFile() {
        QFETCH(QByteArray, text);
        QFETCH(QStringList, lines);
        Imported imported;
        imported.text = text.toStdString();
        RawTextModel model;
        const TextLines of = linesOf(imported);
        model.show(imported, of);
        QStringList shown;
        for (int row = 0; row < model.rowCount(); ++row)
            shown << model.index(row).data().toString();
        QCOMPARE(shown, lines);
    }

    void chosenWordsAreNotCut() {
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            setWindowLanguage(language);
            ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
            dialog.resize(1280, 760);
            dialog.show();
            QTest::qWait(10);
            for (const auto *box : dialog.findChildren<ElidedBox *>())
                QCOMPARE(box->shownText(), box->currentText());
            // Where there is no room for them they end in "…".
            auto *narrow = dialog.findChild<ElidedBox *>("import.layout");
            narrow->setFixedWidth(90);
            QTest::qWait(10);
            QVERIFY2(narrow->shownText().endsWith(u'…'), qPrintable(narrow->shownText()));
        }
    }

    void aConfirmedGuessIsNoGuess() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        const Imported before = dialog.imported();
        dialog.findChild<QPushButton *>("confirm.directions")->click();
        QVERIFY(!dialog.findChild<QLabel *>("guessed.directions")->isVisible());
        QVERIFY(*dialog.imported().test == *before.test);
        QVERIFY(dialog.imported().questions.size() < before.questions.size());
    }

    void anotherChoiceReadsAnew() {
        ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "bare.txt", nullptr);
        const auto first = [&] { return positioning(*dialog.imported().test).runs[0]; };
        QCOMPARE(first().deviations[0], std::optional(-0.003));
        pick(dialog, "import.unit", "mm");
        QCOMPARE(first().deviations[0], std::optional(-3.0));
        pick(dialog, "import.sign", "targetMinusActual");
        QCOMPARE(first().deviations[0], std::optional(3.0));
        pick(dialog, "import.directions", "sideBySide");
        QCOMPARE(positioning(*dialog.imported().test).runs[0].approach, Direction::positive);
        QCOMPARE(dialog.findChild<QComboBox *>("import.directions")->currentData().toString(),
                 QString("sideBySide"));
    }

    void whatCannotBeReadUnderAChoiceIsSaidAndNotAccepted() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        pick(dialog, "import.delimiter", "bar");
        QVERIFY(!importButton(dialog)->isEnabled());
        QVERIFY(!dialog.findChild<QLabel *>("importRefusal")->text().isEmpty());
        pick(dialog, "import.delimiter", "semicolon");
        answerAll(dialog);
        QVERIFY(importButton(dialog)->isEnabled());
        QCOMPARE(importButton(dialog)->text(), QString("&Import 23 readings"));
    }

    void everyQuestionBlocksUntilItIsAnswered() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        const QStringList asked = openQuestions(dialog);
        QCOMPARE(asked, (QStringList{"content", "directions", "positionUnit", "unread"}));
        // Each is answered alone, in turn; the last one opens the way.
        for (int i = 0; i < asked.size(); ++i) {
            QVERIFY(!importButton(dialog)->isEnabled());
            dialog.accept();
            QCOMPARE(dialog.result(), int(QDialog::Rejected));
            QVERIFY(dialog.findChild<QWidget *>("question." + asked[i]));
            auto *button = dialog.findChild<QPushButton *>("confirm." + asked[i]);
            if (asked[i] == "unread")
                button = dialog.findChild<QPushButton *>("answer.unread.leave");
            QVERIFY(button);
            button->click();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCOMPARE(openQuestions(dialog), asked.mid(i + 1));
            QVERIFY(!dialog.findChild<QWidget *>("question." + asked[i]));
        }
        QVERIFY(importButton(dialog)->isEnabled());
        QVERIFY(!dialog.findChild<QPushButton *>("confirmAll")->isVisible());
        importButton(dialog)->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
    }

    /// Remarks, too, have a link that says so; the keyboard goes on to what is left, or to the import.
    void confirmAllConfirmsAllThatItSays() {
        ImportAssistant dialog("P;1;2;3;4;5;6\n0;0,001;0,002;0,0015;0,003;0,001;0,002\n"
                               "100;0,002;0,003;0,0025;0,004;0,002;0,003\n"
                               "200;0,003;0,004;0,0035;0,005;0,003;0,004\n",
                               "bare.csv", nullptr);
        dialog.show();
        QVERIFY(dialog.findChild<QPushButton *>("confirm.sign"));
        auto *all = dialog.findChild<QPushButton *>("confirmAll");
        all->setFocus();
        all->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(openQuestions(dialog), QStringList());
        for (const auto *button : dialog.findChildren<QPushButton *>())
            QVERIFY2(!button->objectName().startsWith("confirm."), qPrintable(button->objectName()));
        QCOMPARE(dialog.focusWidget(), importButton(dialog));
    }

    void confirmAllLeavesOutNoData() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        const Test before = *dialog.imported().test;
        dialog.findChild<QPushButton *>("confirmAll")->click();
        QCOMPARE(openQuestions(dialog), QStringList{"unread"});
        QVERIFY(!importButton(dialog)->isEnabled());
        QVERIFY(!dialog.findChild<QPushButton *>("confirmAll")->isVisible());
        QVERIFY(*dialog.imported().test == before);
    }

    void anotherAnswerIsTaken() {
        ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "bare.txt", nullptr);
        dialog.show();
        const auto first = [&] { return positioning(*dialog.imported().test).runs[0].deviations[0]; };
        QCOMPARE(first(), std::optional(-0.003));
        auto *answers = dialog.findChild<QMenu *>("answers.unit");
        QVERIFY(answers);
        for (QAction *action : answers->actions()) {
            QVERIFY(action->data().toString() != "um"); // that is the proposal beside it
            if (action->data().toString() == "nm") {
                action->trigger();
                break;
            }
        }
        QCOMPARE(first(), std::optional(-0.000003));
        QVERIFY(!openQuestions(dialog).contains("unit"));
    }

    void aRoleIsChangedByOneClick() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        const auto &runs = [&]() -> const std::vector<Run> & {
            return positioning(*dialog.imported().test).runs;
        };
        QCOMPARE(runs().size(), std::size_t(6));
        QVERIFY2(roleShown(dialog, 0).startsWith("target"), qPrintable(roleShown(dialog, 0)));
        QVERIFY2(roleShown(dialog, 6).contains("↓"), qPrintable(roleShown(dialog, 6)));
        pickRole(dialog, 6, "ignored");
        QVERIFY2(roleShown(dialog, 6).startsWith("not read"), qPrintable(roleShown(dialog, 6)));
        QCOMPARE(runs().size(), std::size_t(5));
        QCOMPARE(dialog.findChild<QAbstractItemView *>("importTable")->model()->columnCount(), 6);
        QVERIFY(importButton(dialog)->text().contains("20"));
        pickRole(dialog, 5, "run-");
        QVERIFY2(roleShown(dialog, 5).contains("↓"), qPrintable(roleShown(dialog, 5)));
        QCOMPARE(std::ranges::count(runs(), Direction::positive, &Run::approach), 2);
        QCOMPARE(std::ranges::count(runs(), Direction::negative, &Run::approach), 3);
        // By the keyboard, too.
        auto *columns = dialog.findChild<QTableView *>("importColumns");
        columns->setCurrentIndex(columns->model()->index(0, 6));
        QTest::keyClick(columns, Qt::Key_Return);
        QVERIFY(columns->findChild<QMenu *>("roleMenu"));
    }

    void rolesAreRememberedInAProfile() {
        {
            ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
            dialog.show();
            pickRole(dialog, 6, "ignored");
            QVERIFY(dialog.saveProfile("five runs"));
        }
        const ImportOptions saved = readImportProfiles(importProfilesPath()).at("five runs");
        QCOMPARE(saved.size(), std::size_t(1)); // no guess that nobody has confirmed
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "other.csv", nullptr);
        auto *profiles = dialog.findChild<QComboBox *>("import.profile");
        profiles->setCurrentIndex(profiles->findText("five runs"));
        emit profiles->activated(profiles->currentIndex());
        QCOMPARE(positioning(*dialog.imported().test).runs.size(), std::size_t(5));
        QVERIFY(roleShown(dialog, 6).startsWith("not read"));
        QVERIFY(openQuestions(dialog).contains("positionUnit"));
    }

    void everySheetCanBeChosen() {
        ImportAssistant dialog(bytesOf("workbooks/cover-and-hidden.xlsx"), "w.xlsx", nullptr);
        dialog.show();
        auto *sheets = dialog.findChild<QComboBox *>("import.sheet");
        QVERIFY(sheets && sheets->isVisible());
        QCOMPARE(sheets->count(), int(dialog.imported().sheets.size()));
        QVERIFY(sheets->count() > 2);
        QVERIFY(sheets->itemText(sheets->count() - 1).contains("hidden"));
        QVERIFY(!sheets->itemText(0).contains("hidden"));
        QVERIFY(dialog.imported().test);
        const QString read = sheets->currentText();
        // A sheet without a measurement is shown with the reason, and the way back stays open.
        const int count = sheets->count();
        for (int i = 0; i < count; ++i) {
            sheets = dialog.findChild<QComboBox *>("import.sheet");
            sheets->setCurrentIndex(i);
            emit sheets->activated(i);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            const auto *reason = dialog.findChild<QLabel *>("importRefusal");
            QCOMPARE(reason != nullptr, !dialog.imported().test);
            QCOMPARE(dialog.findChild<QComboBox *>("import.sheet")->currentIndex(), i);
        }
        sheets = dialog.findChild<QComboBox *>("import.sheet");
        sheets->setCurrentIndex(sheets->findText(read));
        emit sheets->activated(sheets->currentIndex());
        QVERIFY(dialog.imported().test);
    }

    void aFileWithoutMeasurementIsShownWithWhatIsMissing_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("words alone") << bytesOf("refused/words.txt");
        QTest::newRow("one column") << bytesOf("refused/one-column.csv");
        QTest::newRow("times that fall") << bytesOf("refused/times-fall.csv");
        QTest::newRow("one number") << QByteArray("Machine;HAAS\nPages;3\n");
        QTest::newRow("beyond every axis")
            << QByteArray("Target (mm);Deviation (mm) ↑;Deviation (mm) ↓\n0;2000000;0\n10;2;3\n20;1;1\n");
    }

    void aFileWithoutMeasurementIsShownWithWhatIsMissing() {
        QFETCH(QByteArray, bytes);
        ImportAssistant dialog(bytes, "file.csv", nullptr);
        dialog.show();
        const auto *reason = dialog.findChild<QLabel *>("importRefusal");
        QVERIFY(reason && !reason->text().isEmpty());
        QVERIFY(!importButton(dialog)->isEnabled());
        QVERIFY(dialog.findChild<QAbstractItemView *>("importRaw")->model()->rowCount() > 0);
        QVERIFY(dialog.findChild<QPushButton *>("importOther")->isEnabled());
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        // Another file in its place can be imported.
        dialog.takeFile(bytesOf("tables/circle-radius.csv"), "circle.csv");
        answerAll(dialog);
        QVERIFY(importButton(dialog)->isEnabled());
    }

    void unknownColumnsAreNamedAboveThem() {
        ImportAssistant dialog("Target (mm);Std (mm)\n1;2\n2;3\n3;5\n", "file.csv", nullptr);
        dialog.show();
        QVERIFY(dialog.findChild<QLabel *>("importRefusal"));
        QVERIFY(dialog.findChild<QTableView *>("importColumns")->isVisible());
        pickRole(dialog, 1, "run+");
        QVERIFY(!dialog.findChild<QLabel *>("importRefusal"));
        QCOMPARE(positioning(*dialog.imported().test).targets, (std::vector<double>{1, 2, 3}));
        answerAll(dialog);
        QVERIFY(importButton(dialog)->isEnabled());
    }

    void textsBeyondATestFileAreRefused() {
        // One character more than a line may have; the limit itself comes in.
        const auto file = [](int length) {
            return "HEADER::\nTARGET DATA::\nTargets : 0 100\nUSER-TEXT::\nMachine : " +
                   QByteArray(length, 'm') + "\nDEVIATIONS::\n1 1 1.5\n1 2 2.5\nEOF::\n";
        };
        ImportAssistant whole(file(4096), "a.rtl", nullptr);
        QVERIFY(!whole.findChild<QLabel *>("importRefusal"));
        QCOMPARE(whole.imported().machine.name.size(), std::size_t(4096));
        ImportAssistant beyond(file(4097), "a.rtl", nullptr);
        QVERIFY(beyond.findChild<QLabel *>("importRefusal"));
        QVERIFY2(beyond.findChild<QLabel *>("importRefusal")->text().contains("no more than"),
                 qPrintable(beyond.findChild<QLabel *>("importRefusal")->text()));
        QVERIFY(!importButton(beyond)->isEnabled());
    }

    void theWindowStandsOnTheReadings() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        auto &workplace = *shown.window->findChild<Workplace *>();
        workplace.showPage(Page::uncertainty);
        shown.window->importFiles({QString(DATA) + "tables/typical.csv"});
        importShown(shown);
        QCOMPARE(workplace.selection().page(), Page::readings);
        QCOMPARE(workplace.selection().test(), shown.window->model().document()->tests.size() - 1);
    }

    void remembersChoicesUnderAName() {
        {
            ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "bare.txt", nullptr);
            pick(dialog, "import.unit", "mm");
            answerAll(dialog);
            QVERIFY(dialog.saveProfile("laser"));
            QCOMPARE(dialog.findChild<QComboBox *>("import.profile")->currentText(), QString("laser"));
            dialog.accept();
        }
        // The same kind of file begins with the profile used last, which can be seen and left.
        ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "next.txt", nullptr);
        QCOMPARE(dialog.findChild<QComboBox *>("import.profile")->currentText(), QString("laser"));
        QCOMPARE(positioning(*dialog.imported().test).runs[0].deviations[0], std::optional(-3.0));
        auto *profiles = dialog.findChild<QComboBox *>("import.profile");
        profiles->setCurrentIndex(0);
        emit profiles->activated(0);
        QCOMPARE(positioning(*dialog.imported().test).runs[0].deviations[0], std::optional(-0.003));
    }

    /// An edition can stand in a profile that was written by hand: what does not fit the kind of the next
    /// file is said, and without the profile the file can be imported.
    void aProfileForAnAxisIsNoDeadEndForACircle() {
        saveImportProfiles({{"axis of 2006", {{"edition", "ISO 230-2:2006"}}}}, importProfilesPath());
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        auto *profiles = dialog.findChild<QComboBox *>("import.profile");
        profiles->setCurrentIndex(profiles->findText("axis of 2006"));
        emit profiles->activated(profiles->currentIndex());
        const auto *refusal = dialog.findChild<QLabel *>("importRefusal");
        QVERIFY(refusal);
        QVERIFY2(refusal->text().contains("ISO 230-2:2006") && refusal->text().contains("ISO 230-4:2005"),
                 qPrintable(refusal->text()));
        QVERIFY(!importButton(dialog)->isEnabled());
        profiles->setCurrentIndex(0);
        emit profiles->activated(0);
        answerAll(dialog);
        QVERIFY(importButton(dialog)->isEnabled());
        QCOMPARE(dialog.imported().test->edition, std::string("ISO 230-4:2005"));
    }

    void temperaturesWithoutATestAreRefused() {
        ImportAssistant dialog(bytesOf("tables/temperatures.csv"), "t.csv", nullptr);
        answerAll(dialog);
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        QVERIFY(dialog.findChild<QLabel *>("importRefusal")->text().contains("need a test"));
    }

    void comesIntoTheOpenFileAsOneStep() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        const Document before = *shown.window->model().document();
        shown.window->importFiles({QString(DATA) + "tables/typical.csv"});
        importShown(shown);
        const auto &tests = shown.window->model().document()->tests;
        QCOMPARE(tests.size(), before.tests.size() + 1);
        QCOMPARE(positioning(*tests.back()).targets.size(), std::size_t(4));
        QCOMPARE(tests.back()->imports[0].fileName, std::string("typical.csv"));
        QCOMPARE(shown.window->model().undoStack()->count(), 1);
        shown.window->model().undoStack()->undo();
        QVERIFY(*shown.window->model().document() == before);
    }

    void anOpenedMeasurementMakesANewFile() {
        const ShownWindow shown;
        shown.window->openFile(QString(DATA) + "tables/circle-radius.csv");
        importShown(shown);
        QVERIFY(shown.window->hasDocument());
        QCOMPARE(shown.window->model().document()->tests.size(), std::size_t(1));
        QVERIFY(shown.window->model().isModified());
    }

    void aClickOnAnotherTableReadsIt() {
        ImportAssistant dialog("Position (mm);↑ (µm);↓ (µm)\n0;1;2\n100;3;4\n200;5;6\n\n"
                               "Limit switch;Angle\n1;7.5\n2;8.5\n3;9.5\n\n"
                               "Target (mm);Forward (µm);Reverse (µm);Forward (µm);Reverse (µm)\n"
                               "0;11;12;13;14\n50;15;16;17;18\n",
                               "x.csv", nullptr);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto firstReading = [&] {
            return *positioning(*dialog.imported().test).runs.front().deviations.front() * 1000;
        };
        auto *lines = dialog.findChild<QListView *>("importRaw");
        const auto click = [&](int line) {
            const QModelIndex at = lines->model()->index(line - 1, 0);
            lines->scrollTo(at);
            QTest::mouseClick(lines->viewport(), Qt::LeftButton, {}, lines->visualRect(at).center());
        };
        const double offered = firstReading();
        QVERIFY(!openQuestions(dialog).filter("table").isEmpty());
        click(5); // between the tables: nothing happens
        QCOMPARE(firstReading(), offered);
        click(12);
        QCOMPARE(firstReading(), 11.0);
        QVERIFY(openQuestions(dialog).filter("table").isEmpty());
        QVERIFY(lines->model()->index(1, 0).data(Qt::ToolTipRole).toString().contains("read this table"));
        QVERIFY(!lines->model()->index(12, 0).data(Qt::ToolTipRole).isValid()); // it is read
        lines->setCurrentIndex(lines->model()->index(2, 0));
        QTest::keyClick(lines, Qt::Key_Return);
        QCOMPARE(firstReading(), 1.0);
    }

    void severalFilesComeOneAfterTheOther() {
        const ShownWindow shown;
        shown.window->importFiles({QString(DATA) + "tables/typical.csv", QString(DATA) + "refused/test.xcal",
                                   QString(DATA) + "tables/circle-radius.csv",
                                   QString(DATA) + "tables/temperatures.csv"});
        const auto says = [&shown](const QString &text) {
            const auto labels = assistantOf(shown).findChildren<QLabel *>();
            return std::ranges::any_of(labels,
                                       [&](const QLabel *label) { return label->text().contains(text); });
        };
        QVERIFY(says("3 files follow"));
        importShown(shown);
        // The refused one is said and stops nothing; the next goes into what the first has opened.
        QVERIFY(shown.window->findChild<QMessageBox *>("errorBox"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!assistantOf(shown).wantsNewDocument());
        importShown(shown);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        importShown(shown);
        const auto &tests = shown.window->model().document()->tests;
        QCOMPARE(tests.size(), std::size_t(2));
        QVERIFY(std::holds_alternative<CircularMeasurement>(tests[1]->measurement));
        QVERIFY(!positioning(*tests[0]).conditions.common.sensors.empty());
        QCOMPARE(shown.window->model().undoStack()->count(), 2);
    }

    void filesCanBeDropped() {
        const ShownWindow shown;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString(DATA) + "tables/typical.csv")});
        QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(shown.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(shown.window, &drop);
        importShown(shown);
        QVERIFY(shown.window->hasDocument());
    }

    void theClipboardIsAFileToo() {
        const ShownWindow shown;
        QGuiApplication::clipboard()->setText(QString::fromUtf8(bytesOf("tables/typical.csv")));
        shown.find<QAction>("importClipboard")->trigger();
        QCOMPARE(importButton(assistantOf(shown))->text(), QString("&Import 23 readings"));
        // Another text in its place; one that is nothing is shown with the reason.
        QGuiApplication::clipboard()->setText(QString::fromUtf8(bytesOf("tables/circle-radius.csv")));
        assistantOf(shown).findChild<QPushButton *>("importPaste")->click();
        QVERIFY(std::holds_alternative<CircularMeasurement>(assistantOf(shown).imported().test->measurement));
        QGuiApplication::clipboard()->setText("nothing");
        assistantOf(shown).findChild<QPushButton *>("importPaste")->click();
        QVERIFY(!assistantOf(shown).findChild<QLabel *>("importRefusal")->text().isEmpty());
        QVERIFY(!assistantOf(shown).imported().test);
        QVERIFY(!importButton(assistantOf(shown))->isEnabled());
    }

    void theBytesAreKeptOnRequest() {
        const QByteArray bytes = bytesOf("tables/typical.csv");
        ImportAssistant dialog(bytes, "typical.csv", nullptr);
        Document without;
        dialog.addTo(without);
        QVERIFY(!without.tests[0]->imports[0].data);
        QCOMPARE(without.tests[0]->imports[0].sha256, sha256(bytes));
        dialog.findChild<QCheckBox *>("keepBytes")->setChecked(true);
        Document with;
        dialog.addTo(with);
        QCOMPARE(QByteArray::fromBase64(QByteArray::fromStdString(*with.tests[0]->imports[0].data)), bytes);
    }

    void everyChoiceCanBeMade_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("choices");
        QTest::newRow("table of an axis")
            << "tables/bare-alternating.txt"
            << QStringList{"delimiter", "decimalMark",  "layout", "directions",    "content",
                           "unit",      "positionUnit", "sign",   "correctionTo20"};
        QTest::newRow("ballbar") << "b5r/typical-absolute.b5r"
                                 << QStringList{"unit",           "startAngle", "arc",  "calibrated",
                                                "correctionTo20", "feed",       "plane"};
    }

    void everyChoiceCanBeMade() {
        QFETCH(QString, file);
        QFETCH(QStringList, choices);
        ImportAssistant dialog(bytesOf(qPrintable(file)), file, nullptr);
        dialog.show();
        for (const QString &choice : choices) {
            const auto *box = dialog.findChild<QWidget *>("import." + choice);
            QVERIFY2(box && box->isVisible() && box->isEnabled(), qPrintable(choice));
        }
    }

    void aHugeFileIsRefusedWithoutReadingIt() {
        QTemporaryDir folder;
        QFile huge(folder.filePath("huge.csv"));
        QVERIFY(huge.open(QIODevice::WriteOnly));
        if (!huge.resize(qint64(2) << 30))
            QSKIP("no sparse files here");
        huge.close();
        const ShownWindow shown;
        shown.window->importFiles({huge.fileName()});
        QTRY_VERIFY(shown.window->findChild<QMessageBox *>("errorBox"));
        QVERIFY(!shown.window->hasDocument());
    }

    void aRefusedFileIsOneSentence() {
        const ShownWindow shown;
        shown.window->importFiles({QString(DATA) + "refused/test.xcal"});
        auto *box = shown.window->findChild<QMessageBox *>("errorBox");
        QVERIFY(box && box->informativeText().contains("Renishaw CARTO"));
        box->close();
        QVERIFY(!shown.window->hasDocument());
    }

    /// One rule for a plane: two different axes.
    void anImpossiblePlaneIsRefused() {
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        answerAll(dialog);
        for (const char *plane : {"XX", "X", "1Y", "xX", "XYZ"}) {
            type(dialog, "import.plane", plane);
            QVERIFY2(!importButton(dialog)->isEnabled(), plane);
            const QString said = dialog.findChild<QLabel *>("importRefusal")->text();
            QVERIFY2(said.contains(plane) && said.contains("two different axes"), qPrintable(said));
        }
        type(dialog, "import.plane", "yz");
        QVERIFY(importButton(dialog)->isEnabled());
        QCOMPARE(std::get<CircularMeasurement>(dialog.imported().test->measurement).plane, (Plane{"Y", "Z"}));
    }

    /// A sentence says the name of a field, as it stands above it.
    void aRefusalNamesTheFieldAsItsLabel() {
        setWindowLanguage(Language::Id::french);
        int typed = 0;
        for (const ImportKey &key : importKeys()) {
            if (key.value != ImportValue::number)
                continue;
            ++typed;
            try {
                requireKnown({{key.key, "abc"}});
                QFAIL(key.key);
            } catch (const Error &error) {
                const QString said = windowLanguage().sentence(error.message);
                QVERIFY2(said.startsWith(windowLanguage().text(key.name)), qPrintable(said));
                QVERIFY2(!said.contains(key.key), qPrintable(said));
            }
        }
        QVERIFY(typed > 5);
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        answerAll(dialog);
        type(dialog, "import.nominalRadius", "abc");
        const QString said = dialog.findChild<QLabel *>("importRefusal")->text();
        QVERIFY2(said.startsWith("Rayon nominal (mm) ne peut pas être abc"), qPrintable(said));
        pick(dialog, "import.layout", "series");
        type(dialog, "import.nominalRadius", "");
        const QString other = dialog.findChild<QLabel *>("importRefusal")->text();
        QVERIFY2(other.startsWith("Disposition") && !other.contains("series"), qPrintable(other));
    }

    /// Numbers stand in the fields as the remarks say them, and can be changed as they stand.
    void numbersAreThoseOfTheLanguage() {
        setWindowLanguage(Language::Id::french);
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        answerAll(dialog);
        type(dialog, "import.nominalRadius", "3067.7");
        auto *radius = dialog.findChild<QLineEdit *>("import.nominalRadius");
        QCOMPARE(radius->text(), windowLanguage().number(3067.7, Quantity::number));
        QVERIFY(radius->text().contains(u','));
        type(dialog, "import.nominalRadius", QString(radius->text()).replace(",7", ",8"));
        QCOMPARE(std::get<CircularMeasurement>(dialog.imported().test->measurement).nominalRadius, 3067.8);
    }

    /// Another layout: its field stays where it is, and keeps the focus; the columns are what it says.
    void nothingJumpsWithAnotherLayout() {
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        answerAll(dialog);
        dialog.show();
        QCoreApplication::processEvents();
        auto *layout = dialog.findChild<QComboBox *>("import.layout");
        layout->setFocus();
        for (const char *word : {"xy", "angleDeviation", "xy", "angleRadius", "series", "angleRadius"}) {
            const QPoint before = layout->mapTo(&dialog, QPoint());
            const int width = dialog.width();
            pick(dialog, "import.layout", word);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCoreApplication::processEvents();
            QCOMPARE(dialog.findChild<QComboBox *>("import.layout"), layout);
            // The small screen of the test lets the dialog follow its longest row.
            const QPoint after = layout->mapTo(&dialog, QPoint());
            const double expected = double(before.x()) * dialog.width() / width;
            QVERIFY2(std::abs(after.y() - before.y()) < 4, word); // the same row
            QVERIFY2(std::abs(after.x() - expected) < 6,
                     qPrintable(QString("%1: %2 to %3").arg(word).arg(before.x()).arg(after.x())));
            QCOMPARE(dialog.focusWidget(), layout);
            const auto roles = dialog.imported().columns;
            const auto has = [&](ColumnRole role) {
                return std::ranges::find(roles, role, &ImportColumn::role) != roles.end();
            };
            if (QString(word) != "series")
                QVERIFY2(has(ColumnRole::x) == (QString(word) == "xy") &&
                             has(ColumnRole::radius) == (QString(word) == "angleRadius"),
                         word);
        }
    }

    void theEditionIsChosenAmongThoseOfItsKind() {
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        answerAll(dialog);
        const auto *editions = dialog.findChild<QComboBox *>("import.edition");
        QVERIFY(editions);
        QCOMPARE(editions->count(), static_cast<int>(editionsOf(Kind::circular).size()));
        QCOMPARE(editions->currentData().toString(), QString("ISO 230-4:2005"));
        pick(dialog, "import.edition", "ISO 230-4:1996");
        QCOMPARE(dialog.imported().test->edition, std::string("ISO 230-4:1996"));
    }

    /// What was answered beside an error is no question any more.
    void confirmedQuestionsAreGoneBesideAnError() {
        ImportAssistant dialog(bytesOf("tables/circle-radius.csv"), "circle.csv", nullptr);
        QVERIFY(!openQuestions(dialog).isEmpty());
        type(dialog, "import.nominalRadius", "abc");
        QVERIFY(dialog.findChild<QLabel *>("importRefusal"));
        dialog.findChild<QPushButton *>("confirmAll")->click();
        for (const Question &question : dialog.imported().questions)
            QVERIFY2(!canBeConfirmed(question), question.id.c_str());
    }

    void speaksFrench() {
        setWindowLanguage(Language::Id::french);
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        QCOMPARE(dialog.findChild<QComboBox *>("import.delimiter")->accessibleName(), QString("Séparateur"));
    }
};

QTEST_MAIN(ImportAssistantTest)
#include "importassistanttest.moc"
