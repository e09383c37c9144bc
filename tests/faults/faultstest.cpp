// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/recovery.h"

#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace palmer;

namespace {

using Snapshot = QMap<QString, QByteArray>; ///< bytes by path in the folder

struct Outcome {
    int code = 0; ///< exit code; -1: killed
    QByteArray error;
};

QByteArray bytesOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A folder with what the program works on, and its settings and data; the log of its calls beside it.
class Place {
public:
    explicit Place(const QStringList &sources) {
        QDir(m_folder.path()).mkpath("w");
        for (const QString &source : sources)
            QFile::copy(source, path(source.section('/', -1)));
    }

    [[nodiscard]] QString path(const QString &name = {}) const {
        return name.isEmpty() ? m_folder.filePath("w") : m_folder.filePath("w/" + name);
    }
    [[nodiscard]] Snapshot files() const {
        Snapshot result;
        for (QDirIterator all(path(), QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot,
                              QDirIterator::Subdirectories);
             all.hasNext();) {
            const QString file = all.next();
            QString name = QDir(path()).relativeFilePath(file);
            name.replace(QRegularExpression("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"),
                         "UUID"); // anew each time
            result[name] = bytesOf(file);
        }
        return result;
    }
    void put(const Snapshot &files) const {
        for (auto file = files.begin(); file != files.end(); ++file) {
            QDir().mkpath(QFileInfo(path(file.key())).absolutePath());
            QFile target(path(file.key()));
            if (!target.open(QIODevice::WriteOnly) || target.write(file.value()) != file.value().size())
                qFatal("the folder of the test cannot be written");
        }
    }

    Outcome run(const QStringList &command, int faultAt = 0, const QString &kind = {}) const {
        QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
        all.insert("LC_ALL", "C.UTF-8");
        all.insert("XDG_DATA_HOME", path("data"));
        all.insert("XDG_CONFIG_HOME", path("settings"));
        all.insert("XDG_RUNTIME_DIR", m_folder.path());
        all.insert("QT_QPA_PLATFORM", "offscreen");
        all.insert("FAULT_FOLDER", path());
        all.insert("FAULT_LOG", log());
        all.insert("FAULT_AT", QString::number(faultAt));
        all.insert("FAULT_KIND", kind);
        all.insert("LD_PRELOAD", FAULTS);
        all.insert("ASAN_OPTIONS", "verify_asan_link_order=0"); // where it is preloaded before the sanitizer
        QProcess process;
        process.setProcessEnvironment(all);
        process.setWorkingDirectory(path());
        QFile::remove(log());
        process.start(command.front(), command.mid(1));
        process.closeWriteChannel();
        if (!process.waitForFinished(patience))
            qFatal("%s does not end", qPrintable(command.join(' ')));
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
                process.readAllStandardError()};
    }
    [[nodiscard]] QByteArrayList calls() const { return bytesOf(log()).trimmed().split('\n'); }

private:
    [[nodiscard]] QString log() const { return m_folder.filePath("log"); }

    QTemporaryDir m_folder;
};

Snapshot withoutLocks(Snapshot files) {
    files.removeIf([](const auto &file) { return file.key().endsWith(".lock"); });
    return files;
}

const QString cli = PALMER_CLI;
const QString window = FAULTY_WORK;

} // namespace

/// Each call that changes a file fails once, and is once the last: then there is the old file or the new one,
/// and nothing else.
class FaultsTest : public QObject {
    Q_OBJECT

private slots:
    void oldOrNew_data();
    void oldOrNew();
    void aCopyOrNone();
    void theRegisterIsComplete();
    void cleanupTestCase() { qInfo("%d faults injected", m_injected); }

private:
    int m_injected = 0;
};

void FaultsTest::oldOrNew_data() {
    QTest::addColumn<QStringList>("sources");
    QTest::addColumn<QStringList>("before");
    QTest::addColumn<QStringList>("command");
    const QString example = EXAMPLES "teaching-01-centre.palmer";
    const QString circle = "teaching-01-centre.palmer";
    const QStringList none;
    const QStringList import{cli, "import", "inches.txt", "--accept"};
    const QString table = DATA "tables/inches.txt";
    QTest::newRow("a new test file") << QStringList{table} << none
                                     << import + QStringList{"-o", "out.palmer"};
    QTest::newRow("an existing test file")
        << QStringList{table, example} << none << import + QStringList{"-o", circle, "--force"};
    const QStringList synthesis{cli,       "synthesize", "circular", "--points",   "36",
                                "--truth", "truth.json", "-o",       "out.palmer", "--noise"};
    QTest::newRow("synthesis with its truth") << none << none << synthesis + QStringList{"0.1"};
    QTest::newRow("two files, again")
        << none << synthesis + QStringList{"0.2"} << synthesis + QStringList{"0.1"};
    QTest::newRow("the window saves") << QStringList{example} << none << QStringList{window, "save", circle};
    QTest::newRow("settings") << none << none << QStringList{window, "settings", "-"};
    QTest::newRow("a template") << none << none << QStringList{window, "template", "-"};
}

void FaultsTest::oldOrNew() {
    QFETCH(QStringList, sources);
    QFETCH(QStringList, before);
    QFETCH(QStringList, command);
    const Place whole(sources);
    if (!before.isEmpty())
        QCOMPARE(whole.run(before).code, 0);
    const Snapshot old = whole.files();
    const Outcome good = whole.run(command);
    QVERIFY2(good.code == 0, good.error);
    const Snapshot made = whole.files();
    const QByteArrayList calls = whole.calls();
    QVERIFY(made != old && calls.size() > 2);
    const qsizetype most = std::ranges::count_if(made.keys(), [&](const QString &file) {
        return old.value(file) != made.value(file);
    }); // of strays: one a file
    for (const char *kind : {"error", "kill"}) {
        const bool kills = qstrcmp(kind, "kill") == 0;
        for (int at = 1; at <= calls.size(); ++at) {
            const Place place({});
            place.put(old);
            const Outcome outcome = place.run(command, at, kind);
            const Snapshot left = place.files();
            ++m_injected;
            const QByteArray where = QByteArray(kind) + " at call " + QByteArray::number(at) + ", " +
                                     calls[at - 1] + ": exit " + QByteArray::number(outcome.code) +
                                     ", files " + QStringList(left.keys()).join(' ').toUtf8() + '\n' +
                                     outcome.error;
            int strays = 0;
            for (auto file = left.begin(); file != left.end(); ++file) {
                const bool known = old.contains(file.key()) || made.contains(file.key());
                strays +=
                    known || file.key().endsWith(".lock") ? 0 : 1; // of QSettings, which knows a stale one
                QVERIFY2(!known || file.value() == made.value(file.key()) ||
                             (old.contains(file.key()) && file.value() == old.value(file.key())),
                         where);
            }
            for (auto file = old.begin(); file != old.end(); ++file)
                QVERIFY2(left.contains(file.key()), where);
            QVERIFY2(strays <= (kills ? most : 0), where);
            if (kills) { // the next one does not stumble over what is there
                QVERIFY2(place.run(command).code == 0, where);
                QVERIFY2(withoutLocks(place.files()) == made, where);
            } else {
                QVERIFY2(outcome.code >= 0, where);
                QVERIFY2(withoutLocks(left) == (outcome.code == 0 ? made : old) ||
                             (outcome.code == 0 && command.contains("settings")),
                         where);
                QVERIFY2(command.contains("settings") || outcome.error == good.error || outcome.code != 0,
                         where);
                QVERIFY2(outcome.error.count('\n') <= 1 + good.error.count('\n'), where);
            }
        }
    }
}

/// The copy of unsaved changes, whose name is new each time.
void FaultsTest::aCopyOrNone() {
    const QString example = "teaching-01-centre.palmer";
    const QStringList command{window, "autosave", example};
    const auto folder = [](const Place &place) {
        return place.path("data/palmer-faults/palmer-faults/recovery");
    };
    const Place whole({EXAMPLES + example});
    QCOMPARE(whole.run(command).code, 0);
    const QByteArrayList calls = whole.calls();
    QCOMPARE(abandonedRecoveries(folder(whole)).size(), std::size_t(1));
    for (const char *kind : {"error", "kill"}) {
        for (int at = 1; at <= calls.size(); ++at) {
            const Place place({EXAMPLES + example});
            const Outcome outcome = place.run(command, at, kind);
            ++m_injected;
            const QByteArray where = QByteArray(kind) + " at call " + QByteArray::number(at) + ", " +
                                     calls[at - 1] + ": exit " + QByteArray::number(outcome.code) + '\n' +
                                     outcome.error;
            for (QDirIterator all(folder(place), QDir::Files | QDir::Hidden); all.hasNext();) {
                QFile file(all.next()); // a minute later
                QVERIFY(file.open(QIODevice::ReadWrite));
                QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-60),
                                         QFileDevice::FileModificationTime));
            }
            const std::vector<Recovery> copies = abandonedRecoveries(folder(place));
            QVERIFY2(copies.size() <= 1, where);
            for (const Recovery &copy : copies) {
                QVERIFY2(copy.document && copy.document->machine.name == "Another machine", where);
                discardRecovery(copy.file);
            }
            QVERIFY2(outcome.code != 0 || copies.size() == 1, where);
            QVERIFY2(outcome.code != 1 || outcome.error.count('\n') == 1, where);
            QVERIFY2(QDir(folder(place)).isEmpty(QDir::Files | QDir::Hidden),
                     where); // cleaned at the next start
        }
    }
}

/// An index that could not be written, or not to its end, is complete after the next scan.
void FaultsTest::theRegisterIsComplete() {
    const QStringList sources{EXAMPLES "teaching-01-centre.palmer", EXAMPLES "one-direction.palmer"};
    const QStringList scan{cli, "register", "--register", "index/register", "scan", "."};
    const QStringList list{cli, "register", "--register", "index/register", "list"};
    const Place whole(sources);
    QCOMPARE(whole.run(scan).code, 0);
    const QByteArrayList calls = whole.calls();
    QVERIFY(calls.size() > 2);
    for (const char *kind : {"error", "kill"}) {
        for (int at = 1; at <= calls.size(); ++at) {
            const Place place(sources);
            const Outcome outcome = place.run(scan, at, kind);
            ++m_injected;
            const QByteArray where = QByteArray(kind) + " at call " + QByteArray::number(at) + ", " +
                                     calls[at - 1] + ": exit " + QByteArray::number(outcome.code) + '\n' +
                                     outcome.error;
            QVERIFY2(qstrcmp(kind, "kill") == 0 || outcome.code >= 0, where);
            QVERIFY2(outcome.code <= 0 || outcome.error.count('\n') == 1, where);
            QVERIFY2(place.run(scan).code == 0, where);
            QVERIFY2(place.run(list).code == 0, where);
        }
    }
}

QTEST_MAIN(FaultsTest)
#include "faultstest.moc"
