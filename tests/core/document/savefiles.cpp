// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/savefiles.h"
#include "document/spool.h"
#include "fulldisk.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <functional>
#include <memory>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palmer;

namespace {

QByteArray contentOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
}

void write(const QString &path, const QByteArray &bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

QStringList namesIn(const QTemporaryDir &folder) {
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System);
}

constexpr int allSaved = 100;
constexpr int anotherError = 101;

/// Index of the file that could not be saved, in a process of its own that is prepared first.
int outcome(const std::vector<FileToSave> &files, const std::function<void()> &prepare) {
    const pid_t child = ::fork();
    if (child == 0) {
        prepare();
        int result = allSaved;
        try {
            saveFiles(files);
        } catch (const UnsavedFile &error) {
            result = anotherError;
            for (std::size_t i = 0; i < files.size(); ++i) {
                if (files[i].path == error.path && error.kind == Error::Kind::unwritable)
                    result = static_cast<int>(i);
            }
        }
        ::_exit(result);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : anotherError;
}

/// No file may grow beyond `limit` bytes, as on a disk that fills up.
std::function<void()> within(qsizetype limit) {
    return [limit] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit both{static_cast<rlim_t>(limit), static_cast<rlim_t>(limit)};
        ::setrlimit(RLIMIT_FSIZE, &both);
    };
}

} // namespace

/// Several files are saved in one step: all or none.
class SaveFilesTest : public QObject {
    Q_OBJECT

private slots:
    void allOrNone() {
        const QTemporaryDir folder;
        const std::vector<QString> paths{folder.filePath("a"), folder.filePath("b"), folder.filePath("c")};
        // Each of three sizes in each place; each limit from both sides; some files new, others there.
        const std::vector<qsizetype> sizes{0, 700, 5'000, 20'000};
        for (int which = 0; which < 64; ++which) {
            const std::vector<qsizetype> chosen{sizes[which % 4], sizes[which / 4 % 4], sizes[which / 16]};
            std::vector<FileToSave> files;
            for (std::size_t i = 0; i < 3; ++i)
                files.push_back({QByteArray(chosen[i], 'n'), paths[i]});
            for (const qsizetype limit : {0, 699, 700, 4'999, 5'000, 19'999, 20'000}) {
                for (std::size_t i = 0; i < 3; ++i) {
                    QFile::remove(paths[i]);
                    if ((static_cast<std::size_t>(which) >> i) % 2 == 0)
                        write(paths[i], "old " + QByteArray::number(i));
                }
                const auto content = [&] {
                    return std::vector{contentOf(paths[0]), contentOf(paths[1]), contentOf(paths[2])};
                };
                const auto before = content();
                const auto tooLarge = std::ranges::find_if(chosen, [&](auto size) { return size > limit; });
                const int expected =
                    tooLarge == chosen.end() ? allSaved : static_cast<int>(tooLarge - chosen.begin());
                QCOMPARE(outcome(files, within(limit)), expected);
                if (expected == allSaved)
                    QVERIFY(content() == (std::vector{files[0].bytes, files[1].bytes, files[2].bytes}));
                else
                    QVERIFY(content() == before);
                for (const QString &name : namesIn(folder)) // nothing is left beside
                    QVERIFY2(name.size() == 1, qPrintable(name));
            }
        }
    }

    /// In a folder of many users nobody may rename over the file of another: seen only when the first files
    /// have their new names.
    void whatCannotBeRenamedOverBringsTheOthersBack() {
        if (::geteuid() != 0)
            QSKIP("needs two users");
        constexpr uid_t nobody = 65534;
        const QTemporaryDir folder;
        QCOMPARE(::chmod(QFile::encodeName(folder.path()).constData(), 01777), 0);
        const auto path = [&](const char *name) { return folder.filePath(QLatin1StringView(name)); };
        for (const char *name : {"mine", "linked", "foreign"}) {
            write(path(name), name);
            QCOMPARE(::chmod(QFile::encodeName(path(name)).constData(), 0666), 0);
        }
        QCOMPARE(::chown(QFile::encodeName(path("mine")).constData(), nobody, nobody), 0);
        QCOMPARE(::chown(QFile::encodeName(path("linked")).constData(), nobody, nobody), 0);
        QVERIFY(QFile::link(path("linked"), path("link")));
        const std::vector<FileToSave> files{
            {"new", path("mine")}, {"new", path("link")}, {"new", path("none")}, {"new", path("foreign")}};
        QCOMPARE(outcome(files, [] { (void)!::setuid(nobody); }), 3);
        for (const char *name : {"mine", "linked", "foreign"})
            QCOMPARE(contentOf(path(name)), QByteArray(name));
        QCOMPARE(namesIn(folder).size(), 4); // and the link
        QVERIFY(QFileInfo(path("link")).isSymLink());
        // Without the last all goes well.
        QCOMPARE(outcome({files.begin(), files.begin() + 3}, [] { (void)!::setuid(nobody); }), allSaved);
        for (const char *name : {"mine", "linked", "none"})
            QCOMPARE(contentOf(path(name)), QByteArray("new"));
        QCOMPARE(namesIn(folder).size(), 5);
    }

    void aFullDeviceLeavesTheFiles() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a");
        write(file, "old");
        for (const std::vector<FileToSave> &files :
             {std::vector<FileToSave>{{"new", file}, {"new", QStringLiteral("/dev/full")}},
              std::vector<FileToSave>{{"new", QStringLiteral("/dev/full")}, {"new", file}}}) {
            QVERIFY_EXCEPTION_THROWN(saveFiles(files), UnsavedFile);
            QCOMPARE(contentOf(file), QByteArray("old"));
        }
    }

    void namesThatCannotBeAreSeenFirst() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a");
        for (const QString &other : {folder.path(), folder.filePath("missing/b")}) {
            try {
                saveFiles({{"new", file}, {"new", other}});
                QFAIL("saved");
            } catch (const UnsavedFile &error) {
                QCOMPARE(error.path, other);
            }
            QVERIFY(namesIn(folder).isEmpty());
        }
    }

    void aSpoolKeepsWhatIsWritten_data() {
        QTest::addColumn<int>("pieces");
        QTest::addColumn<QByteArray>("folder");
        QTest::newRow("nothing") << 0 << QByteArray();
        QTest::newRow("in memory") << 3 << QByteArray();
        QTest::newRow("in a file") << 3000 << QByteArray();
        QTest::newRow("without a place for a file") << 3000 << QByteArray("/there/is/no/such/folder");
    }

    void aSpoolKeepsWhatIsWritten() {
        QFETCH(const int, pieces);
        QFETCH(const QByteArray, folder);
        const QByteArray usual = qgetenv("TMPDIR");
        if (!folder.isEmpty())
            qputenv("TMPDIR", folder);
        const auto spool = std::make_shared<Spool>();
        QByteArray all;
        for (int i = 0; i < pieces; ++i) {
            const QByteArray piece = QByteArray::number(i).repeated(300);
            QCOMPARE(spool->write(piece), piece.size());
            all += piece;
        }
        usual.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", usual);
        QVERIFY(spool->bytes() == all);
        const QTemporaryDir place;
        saveFiles({{spool->bytes(), place.filePath("a"), spool}});
        QVERIFY(contentOf(place.filePath("a")) == all);
    }

    void aSpoolOnAFullDiskTakesNoMore() {
        const FullDisk full(2'000'000);
        Spool spool;
        const QByteArray piece(500'000, 'x');
        bool refused = false;
        for (int i = 0; i < 8; ++i)
            refused = refused || spool.write(piece) != piece.size();
        QVERIFY(refused);
    }
};

QTEST_APPLESS_MAIN(SaveFilesTest)
#include "savefiles.moc"
