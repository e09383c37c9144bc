// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "fulldisk.h"
#include "ui/window/shownwindow.h"

#include "document/recovery.h"
#include "document/savedocument.h"
#include "document/writedocument.h"
#include "editing/editreadings.h"
#include "system/filename.h"
#include "ui/dialogs/recoverydialog.h"
#include "ui/import/importassistant.h"
#include "ui/window/endofsession.h"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <QTimer>
#include <QUndoStack>
#include <csignal>
#include <cstdio>
#include <random>
#include <sys/stat.h>

using namespace palmer;
using namespace palmer::ui;

namespace {

void rename(DocumentModel &model, const QString &name) {
    model.edit("prepare", [&](Document &document) { document.machine.name = name.toStdString(); });
}

QMessageBox *errorBox() {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (widget->objectName() == "errorBox" && widget->isVisible())
            return qobject_cast<QMessageBox *>(widget);
    }
    return nullptr;
}

int copies() {
    return static_cast<int>(QDir(Autosave::folder()).entryList({"*.recovery"}, QDir::Files).size());
}

/// The part of this program that is killed: a real window in which readings are typed without end. Says the
/// number of the edit before each edit, and of the copy when it is on the disk.
int typeUntilKilled(const QString &file, unsigned seed) {
    auto *window = new MainWindow;
    window->show();
    window->openFile(file);
    window->autosave().setDelay(15);
    QTextStream out(stdout);
    int number = 0;
    QObject::connect(&window->autosave(), &Autosave::saved, window, [&](const DocumentPointer &document) {
        out << "kept " << QString::fromStdString(document->machine.location) << Qt::endl;
    });
    std::mt19937 random(seed); // NOLINT: the same every time
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, window, [&] {
        window->model().edit("prepare", [&](Document &document) {
            document.machine.location = std::to_string(++number);
            editReadings(document, 0, [&](PositioningMeasurement &m) {
                setReading(m, {random() % m.runs.size(), random() % m.targets.size()},
                           static_cast<double>(random() % 100) / 1e4);
            });
        });
    });
    timer.start(3);
    out << "ready" << Qt::endl;
    return QApplication::exec();
}

/// The part of this program that is ended: a real window with a change that no timer keeps in time.
int waitUntilEnded(const QString &file, QGuiApplication &application) {
    auto *window = new MainWindow;
    window->show();
    window->openFile(file);
    window->autosave().setDelay(3'600'000);
    keepCopiesAtEnd(application);
    rename(window->model(), "typed last");
    QTextStream(stdout) << "ready" << Qt::endl;
    return QApplication::exec();
}

/// Counts how often a widget was shown.
class ShowCounter : public QObject {
public:
    explicit ShowCounter(QWidget &widget) { widget.installEventFilter(this); }
    [[nodiscard]] int count() const { return m_count; }
    bool eventFilter(QObject * /*watched*/, QEvent *event) override {
        m_count += event->type() == QEvent::Show ? 1 : 0;
        return false;
    }

private:
    int m_count = 0;
};

QByteArray contentOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Clicks a button of the box that is to appear; says whether it was this one.
struct Answer {
    Answer(const char *box, QMessageBox::StandardButton button, QObject *context) {
        QTimer::singleShot(0, context, [this, box, button] {
            auto *shown = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            if (!shown)
                return;
            asked = shown->objectName() == QLatin1StringView(box);
            text = shown->text();
            shown->button(button)->click();
        });
    }
    bool asked = false;
    QString text;
};

/// A test file of more bytes than are read at once.
Document largeDocument(const char *name) {
    Document document = openDocument(examplePath("rotary-axis"));
    document.machine.name = name;
    document.report.remarks.clear();
    for (int k = 0; k < 65'536; ++k) // as many characters as remarks may have, of four bytes each
        document.report.remarks += "\xF0\x9D\x84\x9E";
    return document;
}

std::vector<std::string> openMachines() {
    std::vector<std::string> names;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        auto *window = qobject_cast<MainWindow *>(widget);
        if (window && window->hasDocument())
            names.push_back(window->model().document()->machine.name);
    }
    std::ranges::sort(names);
    return names;
}

void deleteOtherWindows(const MainWindow *kept) {
    QList<QPointer<MainWindow>> others;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (auto *window = qobject_cast<MainWindow *>(widget); window && window != kept)
            others += window;
    }
    for (const auto &window : others)
        delete window;
}

} // namespace

/// Nothing typed is lost: saving that fails, programs that write the same file, crashes.
class SafetyTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(QDir(Autosave::folder()).removeRecursively()); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }

    void savingThatFailsIsSaidInPlainWords_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("word");
        const QString folder = QDir::tempPath();
        QTest::newRow("a full disk") << "/dev/full"
                                     << "full";
        QTest::newRow("a folder") << folder << "folder";
        QTest::newRow("a folder that is not there") << folder + "/gone/x.palmer"
                                                    << "does not exist";
    }

    void savingThatFailsIsSaidInPlainWords() {
        QFETCH(QString, path);
        QFETCH(QString, word);
        const ShownWindow shown(examplePath("rotary-axis"));
        rename(shown.window->model(), "lathe");
        const auto before = shown.window->model().document();
        QVERIFY(!shown.window->saveTo(path));
        QMessageBox *box = errorBox();
        QVERIFY(box);
        QVERIFY2(box->informativeText().contains(word), qPrintable(box->informativeText()));
        delete box;
        QVERIFY(shown.window->isWindowModified());
        QVERIFY(shown.window->model().document() == before);
        QVERIFY(shown.window->model().path().isEmpty());
    }

    void aFolderThatVanishes() {
        auto folder = std::make_unique<QTemporaryDir>();
        const QString path = folder->filePath("x.palmer");
        const ShownWindow shown(examplePath("rotary-axis"));
        QVERIFY(shown.window->saveTo(path));
        folder.reset();
        rename(shown.window->model(), "lathe");
        auto *notice = shown.find<QWidget>("notice");
        QTRY_VERIFY(notice->isVisible());
        QVERIFY(!shown.window->saveTo(path));
        QMessageBox *box = errorBox();
        QVERIFY(box && box->informativeText().contains("does not exist"));
        delete box;
        QVERIFY(shown.window->isWindowModified());
    }

    void keepsACopyOfUnsavedChanges() {
        const ShownWindow shown(examplePath("rotary-axis"));
        QCOMPARE(copies(), 0);
        shown.window->autosave().setDelay(10);
        QSignalSpy kept(&shown.window->autosave(), &Autosave::saved);
        rename(shown.window->model(), "lathe");
        QTRY_COMPARE(kept.count(), 1);
        QCOMPARE(copies(), 1);
        QVERIFY(shown.find<QLabel>("statusState")->text().startsWith("Kept automatically at"));
        QVERIFY(abandonedRecoveries(Autosave::folder()).empty()); // this program lives
        shown.window->model().undoStack()->undo();
        QTRY_COMPARE(copies(), 0); // back to what the file says
        shown.window->model().undoStack()->redo();
        QTRY_COMPARE(copies(), 1);
        const QTemporaryDir folder;
        QVERIFY(shown.window->saveTo(folder.filePath("x.palmer")));
        QTRY_COMPARE(copies(), 0);
        rename(shown.window->model(), "mill");
        QTRY_COMPARE(copies(), 1);
        QTimer::singleShot(0, shown.window, [] {
            qobject_cast<QMessageBox *>(QApplication::activeModalWidget())
                ->button(QMessageBox::Discard)
                ->click();
        });
        QVERIFY(shown.window->close());
        QTRY_VERIFY(!shown.window);
        QCOMPARE(copies(), 0);
    }

    void typingOnIsKeptAllTheSame() {
        const ShownWindow shown(examplePath("rotary-axis"));
        // Never a pause as long as the delay; as long as it takes, for the machine may be busy.
        shown.window->autosave().setDelay(200);
        QSignalSpy kept(&shown.window->autosave(), &Autosave::saved);
        QElapsedTimer time;
        for (time.start(); kept.count() < 3 && time.elapsed() < patience; QTest::qWait(5))
            rename(shown.window->model(), QString::number(time.elapsed()));
        QVERIFY2(kept.count() >= 3, qPrintable(QString::number(kept.count())));
    }

    // A name that is no UTF-8 (an old disk): the document opens, and asks for a name to be saved under.
    void opensAFileOfAForeignName() {
        const QTemporaryDir folder;
        const QByteArray name = folder.path().toUtf8() + "/caf\xe9.palmer";
        const QByteArray bytes = bytesToSave(openDocument(examplePath("rotary-axis")));
        std::FILE *file = std::fopen(name.constData(), "wb");
        QVERIFY(file);
        QCOMPARE(std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), file),
                 std::size_t(bytes.size()));
        std::fclose(file);
        const ShownWindow shown(fileNameOf(name));
        QVERIFY(shown.window->hasDocument());
        QCOMPARE(shown.window->model().path(), QString());
        QCOMPARE(bytesToSave(*shown.window->model().document()), bytes);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList()); // no lock, no copy
    }

    /// A copy that cannot be read is named with its reason and stays until it is discarded.
    void namesCopiesThatCannotBeRead() {
        QVERIFY(QDir().mkpath(Autosave::folder()));
        const QString copy = Autosave::folder() + "/broken.recovery";
        saveBytes("{\"format\": \"palm", copy);
        const ShownWindow shown;
        shown.window->offerRecoveries();
        auto *list = shown.find<QListWidget>("recoveryList");
        QCOMPARE(list->count(), 1);
        QVERIFY2(list->item(0)->text().contains("broken.recovery cannot be read"),
                 qPrintable(list->item(0)->text()));
        QCOMPARE(list->item(0)->toolTip(), copy);
        list->item(0)->setCheckState(Qt::Checked);
        QVERIFY(!shown.find<QPushButton>("recover")->isEnabled());
        shown.find<QPushButton>("discardRecovery")->click();
        QVERIFY(!QFile::exists(copy));
    }

    void offersWhatACrashLeft() {
        Document document = openDocument(examplePath("rotary-axis"));
        document.machine.name = "recovered lathe";
        QVERIFY(QDir().mkpath(Autosave::folder()));
        const QString copy = Autosave::folder() + "/crashed.recovery";
        saveBytes(writeRecovery(document, {"/data/lathe.palmer", QDateTime::currentDateTimeUtc(), {}}), copy);
        const ShownWindow shown;
        shown.window->offerRecoveries();
        auto *dialog = shown.find<RecoveryDialog>("recoveryDialog");
        shown.find<QPushButton>("recoverLater")->click();
        QVERIFY(QFile::exists(copy)); // leaving it decides nothing
        QTRY_VERIFY(!shown.window->findChild<RecoveryDialog *>());
        std::ignore = dialog;
        shown.window->offerRecoveries();
        shown.find<QPushButton>("recover")->click();
        QVERIFY(shown.window->hasDocument());
        QVERIFY(*shown.window->model().document() == document);
        QCOMPARE(shown.window->model().path(), QString("/data/lathe.palmer"));
        QVERIFY(shown.window->isWindowModified());
        QVERIFY(!QFile::exists(copy));
        QCOMPARE(copies(), 1); // and has one of its own
    }

    void discardsWhatACrashLeft() {
        const QString copy = Autosave::folder() + "/crashed.recovery";
        saveBytes(writeRecovery({}, {{}, QDateTime::currentDateTimeUtc()}), copy);
        const ShownWindow shown;
        shown.window->offerRecoveries();
        shown.find<QPushButton>("discardRecovery")->click();
        QVERIFY(!QFile::exists(copy));
        QVERIFY(!shown.window->hasDocument());
    }

    void tellsThatAnotherProgramChangedTheFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        Document document = openDocument(examplePath("rotary-axis"));
        saveDocument(document, path);
        const ShownWindow shown(path);
        auto *notice = shown.find<QWidget>("notice");
        QVERIFY(!notice->isVisible());
        saveDocument(document, path); // the same bytes: no change
        QTest::qWait(50);
        QVERIFY(!notice->isVisible());
        document.machine.name = "by another program";
        saveDocument(document, path);
        QTRY_VERIFY(notice->isVisible());
        shown.find<QPushButton>("reload")->click();
        QVERIFY(!notice->isVisible());
        QCOMPARE(shown.window->model().document()->machine.name, std::string("by another program"));
        QVERIFY(!shown.window->isWindowModified());
        // Its own saving is no change by others, not even while it saves.
        ShowCounter shows(*notice);
        for (int round = 0; round < 20; ++round) {
            rename(shown.window->model(), QStringLiteral("by this one %1").arg(round));
            QVERIFY(shown.window->saveTo(path));
        }
        QTest::qWait(50);
        QVERIFY(!notice->isVisible());
        QCOMPARE(shows.count(), 0);
    }

    void asksBeforeItOverwritesOthersChanges() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        Document document = openDocument(examplePath("rotary-axis"));
        saveDocument(document, path);
        const ShownWindow shown(path);
        rename(shown.window->model(), "by this one");
        document.machine.name = "by another program";
        saveDocument(document, path);
        QTimer::singleShot(0, shown.window, [] {
            auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(box && box->objectName() == "overwriteBox");
            box->button(QMessageBox::Cancel)->click();
        });
        shown.find<QAction>("save")->trigger();
        QCOMPARE(openDocument(path).machine.name, std::string("by another program"));
        QTimer::singleShot(0, shown.window, [] {
            QApplication::activeModalWidget()->findChild<QPushButton *>("overwrite")->click();
        });
        shown.find<QAction>("save")->trigger();
        QCOMPARE(openDocument(path).machine.name, std::string("by this one"));
        QVERIFY(!shown.window->isWindowModified());
    }

    void aFullDiskLosesNothing() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(openDocument(examplePath("rotary-axis")), path);
        const QByteArray before = contentOf(path);
        const ShownWindow shown(path);
        shown.window->autosave().setDelay(3'600'000);
        rename(shown.window->model(), "lathe");
        QVERIFY(shown.window->autosave().flush());
        const QString copy =
            Autosave::folder() + '/' + QDir(Autosave::folder()).entryList({"*.recovery"}).value(0);
        const QByteArray kept = contentOf(copy);
        rename(shown.window->model(), "another lathe");
        for (qint64 limit = 0; limit < before.size(); limit += 997) {
            const FullDisk disk(limit);
            QVERIFY(!shown.window->saveTo(path));
            QMessageBox *box = errorBox();
            QVERIFY(box && !box->informativeText().isEmpty());
            delete box;
            QCOMPARE(contentOf(path), before);
            QVERIFY(shown.window->isWindowModified());
            QVERIFY(!shown.window->autosave().flush());
            QCOMPARE(contentOf(copy), kept);
        }
        QVERIFY(shown.window->saveTo(path));
        QVERIFY(!shown.window->isWindowModified());
        QTRY_COMPARE(copies(), 0);
    }

    void aCopyThatCannotBeKeptIsNotThrownAway() {
        const QString copy = Autosave::folder() + "/crashed.recovery";
        saveBytes(writeRecovery(openDocument(examplePath("rotary-axis")),
                                {{}, QDateTime::currentDateTimeUtc(), {}}),
                  copy);
        const ShownWindow shown;
        {
            const FullDisk disk(100);
            shown.window->openRecovery(abandonedRecoveries(Autosave::folder()).at(0));
        }
        QVERIFY(shown.window->hasDocument());
        QVERIFY(QFile::exists(copy));
        discardRecovery(copy);
    }

    void aRecoveredCopyDoesNotOverwriteANewerFile_data() {
        QTest::addColumn<bool>("changed");
        QTest::addColumn<bool>("stated");
        QTest::newRow("the same file") << false << true;
        QTest::newRow("another file, before or after the copy") << true << true;
        QTest::newRow("the same file, a copy of a former version") << false << false;
        QTest::newRow("a newer file, a copy of a former version") << true << false;
    }

    void aRecoveredCopyDoesNotOverwriteANewerFile() {
        QFETCH(bool, changed);
        QFETCH(bool, stated);
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        Document document = openDocument(examplePath("rotary-axis"));
        saveDocument(document, path);
        const FileState known = stateOfFile(path, true);
        if (changed) {
            Document newer = document;
            newer.machine.name = "by a colleague";
            saveDocument(newer, path);
        }
        document.machine.name = "recovered";
        // A copy of this version says what the file was; of a former one only its time tells.
        const QDateTime now = QDateTime::currentDateTimeUtc();
        const QDateTime time = stated ? now.addDays(1) : changed ? now.addDays(-1) : now.addSecs(5);
        const QString copy = Autosave::folder() + "/crashed.recovery";
        saveBytes(writeRecovery(document, {path, time, stated ? std::optional(known) : std::nullopt}), copy);
        const ShownWindow shown;
        shown.window->openRecovery(abandonedRecoveries(Autosave::folder()).at(0));
        QVERIFY(!QFile::exists(copy));
        QCOMPARE(shown.find<QWidget>("notice")->isVisible(), changed);
        const Answer answer("overwriteBox", QMessageBox::Cancel, shown.window);
        shown.find<QAction>("save")->trigger();
        QCOMPARE(answer.asked, changed);
        QCOMPARE(openDocument(path).machine.name, std::string(changed ? "by a colleague" : "recovered"));
        QCOMPARE(shown.window->isWindowModified(), changed);
    }

    void aFileThatIsGoneIsAskedAbout() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(openDocument(examplePath("rotary-axis")), path);
        const ShownWindow shown(path);
        QVERIFY(QFile::remove(path));
        {
            const Answer answer("closeBox", QMessageBox::Cancel, shown.window);
            QVERIFY(!shown.window->close());
            QVERIFY(answer.asked && answer.text.contains("x.palmer"));
        }
        QTRY_VERIFY(shown.window->isWindowModified());
        const Answer answer("closeBox", QMessageBox::Save, shown.window);
        QVERIFY(shown.window->close());
        QVERIFY(answer.asked);
        QVERIFY(openDocument(path) == openDocument(examplePath("rotary-axis")));
    }

    void whatIsKeptAgainstTheFileIsAskedAbout() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        Document document = openDocument(examplePath("rotary-axis"));
        saveDocument(document, path);
        const ShownWindow shown(path);
        document.machine.name = "by another program";
        saveDocument(document, path);
        QTRY_VERIFY(shown.find<QWidget>("notice")->isVisible());
        shown.find<QPushButton>("keepMine")->click();
        QVERIFY(shown.window->isWindowModified());
        const Answer answer("closeBox", QMessageBox::Discard, shown.window);
        QVERIFY(shown.window->close());
        QVERIFY(answer.asked);
    }

    void theEndOfTheSessionKeepsTheChanges() {
        const ShownWindow shown(examplePath("rotary-axis"));
        shown.window->autosave().setDelay(3'600'000);
        keepCopiesOfAllWindows();
        QCOMPARE(copies(), 0); // nothing has changed
        rename(shown.window->model(), "typed last");
        keepCopiesOfAllWindows();
        QCOMPARE(copies(), 1);
    }

    void aSignalKeepsTheChanges_data() {
        QTest::addColumn<int>("number");
        for (const int number : {SIGTERM, SIGINT, SIGHUP})
            QTest::addRow("%d", number) << number;
    }

    void aSignalKeepsTheChanges() {
        QFETCH(int, number);
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(openDocument(examplePath("rotary-axis")), path);
        const QByteArray before = contentOf(path);
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(QCoreApplication::applicationFilePath(),
                      {"ui/window/safetytest", "--wait", path, "0", QCoreApplication::applicationName()});
        QVERIFY(process.waitForStarted());
        QByteArray output;
        while (!output.contains("ready") && process.waitForReadyRead(patience))
            output += process.readAllStandardOutput();
        QCOMPARE(copies(), 0);
        ::kill(static_cast<pid_t>(process.processId()), number);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::CrashExit); // by that signal
        QCOMPARE(process.exitCode(), number);
        const auto found = abandonedRecoveries(Autosave::folder());
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].document->machine.name, std::string("typed last"));
        QCOMPARE(found[0].origin.path, path);
        discardRecovery(found[0].file);
        QCOMPARE(contentOf(path), before);
    }

    void severalLargeFilesAllOpen() {
        const QTemporaryDir folder;
        const ShownWindow shown;
        for (const char *name : {"L1", "L2", "L3"}) {
            const QString path = folder.filePath(QString(name) + ".palmer");
            saveDocument(largeDocument(name), path);
            shown.window->openFile(path);
            shown.window->openFile(path); // twice is once
        }
        QTRY_COMPARE(openMachines(), (std::vector<std::string>{"L1", "L2", "L3"}));
        deleteOtherWindows(shown.window);
    }

    void whatIsNoFileIsRefusedAtOnce() {
        const QTemporaryDir folder;
        const ShownWindow shown;
        for (const char *name : {"pipe.palmer", "pipe.csv"})
            QCOMPARE(::mkfifo(QFile::encodeName(folder.filePath(name)).constData(), 0600), 0);
        for (const QString &path : {folder.filePath("pipe.palmer"), folder.filePath("pipe.csv"),
                                    QString("/dev/zero"), folder.path(), folder.filePath("none.csv")}) {
            shown.window->openFile(path);
            QMessageBox *box = errorBox();
            QVERIFY2(box && !box->informativeText().isEmpty(), qPrintable(path));
            delete box;
        }
        QVERIFY(!shown.window->hasDocument());
        QVERIFY(!shown.window->findChild<ImportAssistant *>());
    }

    /// Whatever its name and its encoding: never the assistant, which would make readings without limits of
    /// it.
    void aDamagedTestFileIsNoMeasurement() {
        const QTemporaryDir folder;
        const ShownWindow shown;
        const QByteArray file = writeDocument(openDocument(examplePath("rotary-axis")));
        QByteArray wide("\xFF\xFE", 2);
        for (const char c : file.mid(file.indexOf('\n') + 1))
            wide += QByteArray{&c, 1} + QByteArray(1, '\0');
        for (const char *name : {"x.palmer", "x.csv", "x.txt"}) {
            for (const QByteArray &bytes : {file.mid(file.indexOf('\n') + 1), wide, "0;1\n100;2\n" + file}) {
                saveBytes(bytes, folder.filePath(name));
                shown.window->openFile(folder.filePath(name));
                QMessageBox *box = errorBox();
                QVERIFY2(box, name);
                delete box;
                QVERIFY(!shown.window->findChild<ImportAssistant *>());
            }
        }
        QVERIFY(!shown.window->hasDocument());
    }

    /// A real process, killed at any moment: nothing older than the last copy is lost, and every copy can be
    /// read.
    void survivesKill() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(openDocument(examplePath("iso230-2-1988-example")), path);
        const QByteArray before = [&] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        }();
        std::mt19937 random(9); // NOLINT: the same every time
        int recovered = 0;
        constexpr int rounds = 30;
        for (int round = 0; round < rounds; ++round) {
            QProcess process;
            process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
            process.start(QCoreApplication::applicationFilePath(),
                          {"ui/window/safetytest", "--type", path, QString::number(round),
                           QCoreApplication::applicationName()});
            QVERIFY(process.waitForStarted());
            QByteArray output;
            // Some are killed at the beginning, perhaps before there is a copy.
            const QByteArray awaited = round % 5 == 0 ? "ready" : "kept ";
            while (!output.contains(awaited) && process.waitForReadyRead(patience))
                output += process.readAllStandardOutput();
            QTest::qWait(static_cast<int>(random() % 120));
            process.kill(); // SIGKILL
            QVERIFY(process.waitForFinished());
            output += process.readAllStandardOutput();
            int last = 0;
            for (const QByteArray &line : output.split('\n')) {
                if (line.startsWith("kept "))
                    last = std::max(last, line.mid(5).toInt());
            }
            const auto found = abandonedRecoveries(Autosave::folder());
            QCOMPARE(copies(), static_cast<int>(found.size())); // none is broken
            if (last > 0) {
                QCOMPARE(found.size(), std::size_t{1});
                QVERIFY(QString::fromStdString(found[0].document->machine.location).toInt() >= last);
                ++recovered;
            }
            for (const Recovery &recovery : found) {
                QCOMPARE(recovery.origin.path, path);
                discardRecovery(recovery.file);
            }
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), before); // the user's file is untouched
        }
        QVERIFY2(recovered >= rounds * 4 / 5, qPrintable(QString::number(recovered)));
        qInfo("recovered in %d of %d rounds", recovered, rounds);
    }
};

PALMER_TEST(runSafetyTest) {
    QApplication application(argc, argv);
    prepareApplication();
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == "--type") {
        QCoreApplication::setApplicationName(arguments.value(4)); // the folder of who started it
        return typeUntilKilled(arguments.value(2), arguments.value(3).toUInt());
    }
    if (arguments.value(1) == "--wait") {
        QCoreApplication::setApplicationName(arguments.value(4));
        return waitUntilEnded(arguments.value(2), application);
    }
    SafetyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "safetytest.moc"
