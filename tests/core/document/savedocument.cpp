// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savedocument.h"

#include "core/document/completefile.h"
#include "document/readdocument.h"
#include "document/readprogress.h"
#include "document/writedocument.h"
#include "system/files.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <limits>
#include <optional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palmer;

namespace {

std::optional<Error> errorOfSaving(const Document &document, const QString &path) {
    try {
        saveDocument(document, path);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

std::optional<Error> errorOfOpening(const QString &path) {
    try {
        (void)openDocument(path);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

QByteArray contentOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

enum Outcome { saved, refusedSaving, anotherError };

/// What becomes of saving where no file may grow beyond `limit` bytes, as on a disk that fills up: the last
/// write takes a part, or nothing. In a process of its own, which the limit ends with.
Outcome saveWithin(qsizetype limit, const QByteArray &bytes, const QString &path) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const auto most = static_cast<rlim_t>(limit);
        const rlimit both{most, most};
        Outcome outcome = anotherError;
        if (::setrlimit(RLIMIT_FSIZE, &both) == 0) {
            try {
                saveBytes(bytes, path);
                outcome = saved;
            } catch (const Error &error) {
                outcome = error.kind == Error::Kind::unwritable ? refusedSaving : anotherError;
            }
        }
        ::_exit(outcome);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? static_cast<Outcome>(WEXITSTATUS(status)) : anotherError;
}

} // namespace

class SaveDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasSavedIsOpenedEqually() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("é x.palmer"));
        const Document document = readDocument(completeFile());
        saveDocument(Document(), path);
        saveDocument(document, path);
        QVERIFY(openDocument(path) == document);
        QCOMPARE(contentOf(path), writeDocument(document));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(),
                 1); // nothing is left beside
    }

    void aMissingFolderIsAnError() {
        const QTemporaryDir folder;
        const auto error = errorOfSaving({}, folder.filePath(QStringLiteral("none/x.palmer")));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        QVERIFY(!QDir(folder.filePath(QStringLiteral("none"))).exists());
    }

    void aFolderIsNoTarget() {
        const QTemporaryDir folder;
        const auto error = errorOfSaving({}, folder.path());
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        QVERIFY(QDir(folder.path()).exists());
    }

    void aFullDeviceIsAnErrorAndStaysADevice() {
        const auto error = errorOfSaving({}, QStringLiteral("/dev/full"));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        const QFileInfo device(QStringLiteral("/dev/full"));
        QVERIFY(device.exists() && !device.isFile());
    }

    void aFailedSaveLeavesTheOldFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        saveDocument({}, path);
        const QByteArray before = contentOf(path);
        Document broken;
        Instrument instrument;
        instrument.resolution = std::numeric_limits<double>::infinity();
        broken.instruments.push_back(instrument);
        QVERIFY(errorOfSaving(broken, path));
        QCOMPARE(contentOf(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }

    void aFullDiskLeavesTheOldFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        const QByteArray before(20'000, 'o');
        constexpr qsizetype step = 1021; // of 40 KiB: below, at and above every buffer there may be
        for (qsizetype size = 0; size <= 40 * 1024; size += step) {
            const QByteArray bytes(size, 'n');
            for (const qsizetype limit : {qsizetype(0), size / 2, size - 1, size, size + 1}) {
                if (limit < 0)
                    continue;
                saveBytes(before, path);
                const bool fits = limit >= size;
                QCOMPARE(saveWithin(limit, bytes, path), fits ? saved : refusedSaving);
                QCOMPARE(contentOf(path), fits ? bytes : before);
                QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
            }
        }
    }

    void aLinkStaysALink() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        const QString link = folder.filePath(QStringLiteral("link.palmer"));
        saveBytes("old", path);
        QVERIFY(QFile::link(path, link));
        saveBytes("new", link);
        QCOMPARE(contentOf(path), QByteArray("new"));
        QVERIFY(QFileInfo(link).isSymLink());
        const QString hard = folder.filePath(QStringLiteral("hard.palmer"));
        QCOMPARE(::link(QFile::encodeName(path).constData(), QFile::encodeName(hard).constData()), 0);
        QVERIFY(isSameFile(path, link) && isSameFile(link, hard));
        const QString other = folder.filePath(QStringLiteral("other.palmer"));
        saveBytes("new", other);
        QVERIFY(!isSameFile(path, other) && !isSameFile(path, folder.filePath(QStringLiteral("none"))));
        QVERIFY(!isSameFile(QStringLiteral("/dev/null"), QStringLiteral("/dev/null")));
    }

    void pipesAndDevicesAreNotRead() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath(QStringLiteral("pipe.palmer"));
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        for (const QString &path : {pipe, QStringLiteral("/dev/zero"), QStringLiteral("/dev/null"),
                                    QStringLiteral("/dev/tty"), folder.path()}) {
            const auto error = errorOfOpening(path);
            QVERIFY2(error && error->kind == Error::Kind::unreadable, qPrintable(path));
        }
        // What the system makes up while it is read says that it is empty.
        QCOMPARE(readBytes(QStringLiteral("/proc/self/status")), QByteArray());
    }

    void whatIsReadIsCounted() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("large"));
        QByteArray bytes;
        for (int i = 0; i < 300'000; ++i)
            bytes += QByteArray::number(i) + '\n'; // more than one block
        saveBytes(bytes, path);
        ReadProgress progress;
        progress.unit = ReadProgress::Unit::trials;
        progress.done = 5;
        QCOMPARE(readBytes(path, progress), bytes);
        QCOMPARE(progress.done.load(), bytes.size());
        QCOMPARE(progress.of.load(), bytes.size());
        QVERIFY(progress.unit == ReadProgress::Unit::bytes);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(readBytes(path, progress, stop.get_token()).isEmpty());
        QCOMPARE(progress.done.load(), 0);
    }

    void aPipeThatNobodyReadsIsAnError() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath(QStringLiteral("pipe"));
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        const auto error = errorOfSaving({}, pipe);
        QVERIFY(error && error->kind == Error::Kind::unwritable);
        QVERIFY(QFileInfo::exists(pipe) && !QFileInfo(pipe).isFile());
    }

    void whatCannotBeReadIsAnError_data() {
        QTest::addColumn<QString>("path");
        QTest::newRow("missing file") << QStringLiteral("/nowhere/x.palmer");
        QTest::newRow("folder") << QDir::tempPath();
        QTest::newRow("no name") << QString();
    }
    void whatCannotBeReadIsAnError() {
        QFETCH(QString, path);
        const auto error = errorOfOpening(path);
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unreadable);
    }

    void anEmptyFileIsAnError() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        saveBytes({}, path);
        const auto error = errorOfOpening(path);
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::syntax);
    }

    void anEndlessFileIsAnError() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.resize(largestFile + 1)); // a hole, no bytes on disk
        file.close();
        const auto error = errorOfOpening(path);
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::tooLarge);
    }
};

QTEST_APPLESS_MAIN(SaveDocumentTest)
#include "savedocument.moc"
