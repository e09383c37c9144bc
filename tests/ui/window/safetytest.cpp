#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "document/recovery.h"
#include "document/savedocument.h"
#include "editing/editreadings.h"
#include "ui/dialogs/recoverydialog.h"

#include <QAction>
#include <QDir>
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
#include <cstdio>
#include <random>

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
        shown.window->autosave().setDelay(40);
        QSignalSpy kept(&shown.window->autosave(), &Autosave::saved);
        QElapsedTimer time;
        time.start();
        while (time.elapsed() < 500) { // never a pause of 40 ms
            rename(shown.window->model(), QString::number(time.elapsed()));
            QTest::qWait(5);
        }
        QVERIFY2(kept.count() >= 4, qPrintable(QString::number(kept.count())));
    }

    void offersWhatACrashLeft() {
        Document document = openDocument(examplePath("rotary-axis"));
        document.machine.name = "recovered lathe";
        QVERIFY(QDir().mkpath(Autosave::folder()));
        const QString copy = Autosave::folder() + "/crashed.recovery";
        saveBytes(writeRecovery(document, {"/data/lathe.palmer", QDateTime::currentDateTimeUtc()}), copy);
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
        // Its own saving is no change by others.
        rename(shown.window->model(), "by this one");
        QVERIFY(shown.window->saveTo(path));
        QTest::qWait(50);
        QVERIFY(!notice->isVisible());
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
        for (int round = 0; round < 50; ++round) {
            QProcess process;
            process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
            process.start(QCoreApplication::applicationFilePath(),
                          {"--type", path, QString::number(round), QCoreApplication::applicationName()});
            QVERIFY(process.waitForStarted());
            QByteArray output;
            // Some are killed at the beginning, perhaps before there is a copy.
            const QByteArray awaited = round % 5 == 0 ? "ready" : "kept ";
            while (!output.contains(awaited) && process.waitForReadyRead(20'000))
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
        QVERIFY2(recovered >= 40, qPrintable(QString::number(recovered)));
        qInfo("recovered in %d of 50 rounds", recovered);
    }
};

int main(int argc, char *argv[]) {
    QApplication application(argc, argv);
    prepareApplication();
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == "--type") {
        QCoreApplication::setApplicationName(arguments.value(4)); // the folder of who started it
        return typeUntilKilled(arguments.value(2), arguments.value(3).toUInt());
    }
    SafetyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "safetytest.moc"
