// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "document/savedocument.h"
#include "editing/newtest.h"
#include "ui/welcome/recentfiles.h"

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>
#include <algorithm>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

void change(const ShownWindow &shown, const char *number) {
    shown.window->model().edit("rename the test",
                               [number](Document &document) { document.report.number = number; });
}

/// Presses a button of the box that asks on quitting.
void answer(const char *button) {
    QTimer::singleShot(0, qApp, [button] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        QVERIFY(box);
        QCOMPARE(box->objectName(), u"quitBox"_s);
        auto *pressed = box->findChild<QPushButton *>(QLatin1StringView(button));
        if (pressed)
            pressed->click();
        else
            box->reject();
    });
}

} // namespace

/// Files and windows: names that are proposed, the list of recent files, several windows, memory.
class FilesWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        prepareApplication();
        QApplication::setQuitOnLastWindowClosed(false); // boxes are still to be asked
    }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }
    void savingProposesAName_data();
    void savingProposesAName();
    void filesOfOneNameAreToldApart();
    void theListOfRecentFilesIsCleared();
    void saysThatAFileIsReadOnly();
    void oneQuestionForSeveralWindows(); // what is quit here ends the dialogs of tests behind it
    void undoIsBoundedByMemory();
    void saysThatAFileIsOpenElsewhere();
};

void FilesWindowTest::savingProposesAName_data() {
    QTest::addColumn<QString>("number");
    QTest::addColumn<QString>("machine");
    QTest::addColumn<QString>("proposed");
    QTest::newRow("the number of the report") << u"RE-2026-031"_s << u"M 1"_s << u"RE-2026-031.palmer"_s;
    QTest::newRow("else machine and test") << QString() << u"M 1"_s << u"M 1 C axis.palmer"_s;
    QTest::newRow("without what no file may be called")
        << u"17/2026: <a>"_s << u"M"_s << u"17-2026- -a-.palmer"_s;
}

void FilesWindowTest::savingProposesAName() {
    QFETCH(QString, number);
    QFETCH(QString, machine);
    QFETCH(QString, proposed);
    const ShownWindow shown(examplePath("rotary-axis"));
    shown.window->model().edit("rename the test", [&](Document &document) {
        document.report.number = number.toStdString();
        document.machine.name = machine.toStdString();
        auto test = std::make_shared<palmer::Test>(*document.tests[0]);
        test->title.clear();
        document.tests = {std::move(test)};
    });
    QString name;
    QTimer::singleShot(0, shown.window, [&name] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        name = dialog->findChild<QLineEdit *>(u"fileNameEdit"_s)->text();
        dialog->reject();
    });
    shown.find<QAction>("save")->trigger();
    QCOMPARE(name, proposed);
}

void FilesWindowTest::filesOfOneNameAreToldApart() {
    const auto file = [](const QString &path) {
        RecentFile made;
        made.path = path;
        return made;
    };
    const std::vector files{file(u"/a/x/f.palmer"_s), file(u"/b/x/f.palmer"_s), file(u"/b/y/f.palmer"_s),
                            file(u"/b/y/g.palmer"_s), file(u"/f.palmer"_s)};
    QStringList names;
    for (const RecentFile &one : files)
        names << shortName(one, files);
    QCOMPARE(names, QStringList({u"a/x/f.palmer"_s, u"b/x/f.palmer"_s, u"y/f.palmer"_s, u"g.palmer"_s,
                                 u"/f.palmer"_s}));
}

void FilesWindowTest::theListOfRecentFilesIsCleared() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    const ShownWindow shown(path);
    QCOMPARE(recentFiles().size(), std::size_t{1});
    const auto menus = shown.window->findChildren<QMenu *>();
    QAction *clear = nullptr;
    for (QMenu *menu : menus) {
        emit menu->aboutToShow();
        for (QAction *action : menu->actions())
            clear = action->objectName() == u"clearRecent"_s ? action : clear;
    }
    QVERIFY(clear);
    clear->trigger();
    QVERIFY(recentFiles().empty());
    QVERIFY(QFile::exists(path));
}

void FilesWindowTest::oneQuestionForSeveralWindows() {
    const QTemporaryDir folder;
    const QString first = folder.filePath(u"a.palmer"_s);
    const QString second = folder.filePath(u"b.palmer"_s);
    for (const QString &path : {first, second})
        saveDocument(openDocument(examplePath("rotary-axis")), path);
    const auto numberOf = [](const QString &path) { return openDocument(path).report.number; };
    const std::string before = numberOf(first);
    const ShownWindow one(first);
    const ShownWindow two(second);
    change(one, "17");
    change(two, "18");
    answer("cancel");
    one.find<QAction>("quit")->trigger();
    QVERIFY(one.window->isVisible() && two.window->isVisible());
    answer("saveAll");
    one.find<QAction>("quit")->trigger();
    QVERIFY(!one.window || !one.window->isVisible());
    QVERIFY(!two.window || !two.window->isVisible());
    QCOMPARE(numberOf(first), std::string("17"));
    QCOMPARE(numberOf(second), std::string("18"));
    const ShownWindow three(first);
    const ShownWindow four(second);
    change(three, "19");
    change(four, "20");
    answer("discardAll");
    three.find<QAction>("quit")->trigger();
    QVERIFY(!three.window || !three.window->isVisible());
    QVERIFY(!four.window || !four.window->isVisible());
    QCOMPARE(numberOf(first), std::string("17"));
    QCOMPARE(numberOf(second), std::string("18"));
}

void FilesWindowTest::undoIsBoundedByMemory() {
    DocumentModel model;
    model.setDocument(openDocument(examplePath("rotary-axis")), {});
    QVERIFY(model.undoStack()->undoLimit() >= 500); // of tests of the usual size nothing is forgotten
    Document large;
    large.tests.push_back(std::make_shared<const palmer::Test>(newDriftTest(Axis{})));
    auto test = std::make_shared<palmer::Test>(*large.tests[0]);
    auto &drift = std::get<DriftMeasurement>(test->measurement);
    drift.times.resize(1'000'000);
    drift.deviations.resize(1'000'000);
    large.tests[0] = std::move(test);
    model.setDocument(std::move(large), {});
    const auto edit = [&](int i, bool all) {
        model.edit("edit", [&](Document &document) {
            auto edited = std::make_shared<palmer::Test>(*document.tests[0]);
            edited->title = std::to_string(i);
            if (all)
                std::ranges::fill(std::get<DriftMeasurement>(edited->measurement).deviations, i);
            document.tests[0] = std::move(edited);
        });
    };
    for (int i = 1; i <= 60; ++i) // they copied the test and kept it, or were forgotten after ten
        edit(i, false);
    QCOMPARE(model.undoStack()->count(), 60);
    for (int i = 1; i <= 30; ++i)
        edit(i, true);
    QVERIFY(model.undoStack()->count() >= 4 && model.undoStack()->count() <= 12);
    while (model.undoStack()->canUndo())
        model.undoStack()->undo();
    QVERIFY(std::stoi(model.document()->tests[0]->title) >= 18);
}

void FilesWindowTest::saysThatAFileIsReadOnly() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::ReadGroup));
    const ShownWindow shown(path);
    const auto *sentence = shown.find<QLabel>("noticeSentence");
    QVERIFY(sentence->isVisible());
    QCOMPARE(sentence->text(), u"⚠ a.palmer is read-only: changes can be saved under another name."_s);
    QVERIFY(shown.window->windowTitle().contains(u"(read-only)"_s));
    setWindowLanguage(Language::Id::french); // the notice follows
    QCoreApplication::processEvents();
    QVERIFY2(sentence->text().startsWith(u"⚠ a.palmer est en lecture seule"_s), qPrintable(sentence->text()));
    setWindowLanguage(Language::Id::english);
    // Saving asks for another name.
    const QString other = folder.filePath(u"b.palmer"_s);
    bool asked = false;
    QTimer::singleShot(0, shown.window, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        asked = dialog != nullptr;
        if (dialog)
            dialog->reject();
    });
    shown.find<QAction>("save")->trigger();
    QVERIFY(asked);
    QVERIFY(shown.window->saveTo(other));
    QVERIFY(!sentence->isVisible());
    QVERIFY(!shown.window->windowTitle().contains(u"(read-only)"_s));
}

void FilesWindowTest::saysThatAFileIsOpenElsewhere() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    const QString lock = folder.filePath(u".~lock.a.palmer#"_s);
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    const auto write = [&](const QByteArray &content) {
        QFile file(lock);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    };
    const auto notice = [](const ShownWindow &shown) {
        const auto *sentence = shown.find<QLabel>("noticeSentence");
        return sentence->isVisible() ? sentence->text() : QString();
    };
    {
        const ShownWindow shown(path);
        QVERIFY(notice(shown).isEmpty());
        QVERIFY(QFile::exists(lock)); // for all others
    }
    QVERIFY(!QFile::exists(lock));
    // Another machine has it.
    write("4711\npalmer\nworkshop-2\n\n\n");
    {
        const ShownWindow shown(path);
        QVERIFY2(notice(shown).contains(u"a.palmer"_s) && notice(shown).contains(u"workshop-2"_s) &&
                     notice(shown).contains(u"4711"_s),
                 qPrintable(notice(shown)));
        QVERIFY(shown.window->hasDocument());
        const QString other = folder.filePath(u"b.palmer"_s);
        QVERIFY(shown.window->saveTo(other)); // under another name nobody is in the way
        QVERIFY(notice(shown).isEmpty());
        QVERIFY(QFile::exists(folder.filePath(u".~lock.b.palmer#"_s)));
    }
    QVERIFY(QFile::exists(lock)); // not ours
    // A program of this machine that is gone.
    QProcess gone;
    gone.start(u"true"_s, {});
    const qint64 process = gone.processId();
    QVERIFY(gone.waitForFinished());
    write(QByteArray::number(process) + "\npalmer\n" + QSysInfo::machineHostName().toUtf8() + "\n\n\n");
    {
        const ShownWindow shown(path);
        QVERIFY(notice(shown).isEmpty());
        QVERIFY(QFile::exists(lock));
    }
    QVERIFY(!QFile::exists(lock));
}

QTEST_MAIN(FilesWindowTest)
#include "fileswindowtest.moc"
