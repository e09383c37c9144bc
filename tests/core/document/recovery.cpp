// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII

#include "document/recovery.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "document/savedocument.h"
#include "document/savefiles.h"
#include "system/files.h"

#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace palmer;
using namespace palmer::testdata;

namespace {

Document example() {
    Document document;
    document.report.title = "Annual check";
    document.tests.push_back(std::make_shared<const Test>(example1988("ISO 230-2:1988")));
    return document;
}

const QDateTime noon(QDate(2026, 11, 21), QTime(12, 0), Qt::UTC);

} // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void keepsDocumentAndOrigin() {
        const Recovery read = readRecovery(writeRecovery(example(), {"/data/x “axis”.palmer", noon}));
        QVERIFY(*read.document == example());
        QCOMPARE(read.origin.path, QString("/data/x “axis”.palmer"));
        QCOMPARE(read.origin.saved, noon);
        QCOMPARE(read.title, QString("Annual check"));
        QVERIFY(readRecovery(writeRecovery(example(), {{}, noon})).origin.path.isEmpty());
    }

    void refusesWhatIsCutOff() {
        const QByteArray bytes = writeRecovery(example(), {"/data/x.palmer", noon});
        for (qsizetype size = 0; size < bytes.size() - 1; size += 7)
            QVERIFY_EXCEPTION_THROWN(std::ignore = readRecovery(bytes.left(size)), Error);
        QVERIFY_EXCEPTION_THROWN(std::ignore = readRecovery("{}\n{}"), Error);
        QVERIFY_EXCEPTION_THROWN(std::ignore = readRecovery("3\n"), Error);
    }

    /// A program that was killed while it wrote leaves a part; that of one that lives stays.
    void removesWhatWasBeingWritten() {
        const QTemporaryDir folder;
        const QString part = nameWhileSaving(folder.filePath("dead.recovery"));
        const QString living = nameWhileSaving(folder.filePath("living.recovery"));
        const QString other = folder.filePath("living.recovery.notes");
        for (const QString &name : {part, living, other})
            saveBytes("half", name);
        QLockFile lock(recoveryLock(folder.filePath("living.recovery")));
        QVERIFY(lock.tryLock(0));
        QVERIFY(abandonedRecoveries(folder.path()).empty());
        QVERIFY(!QFile::exists(part) && QFile::exists(living) && QFile::exists(other));
        QVERIFY(!QFile::exists(recoveryLock(folder.filePath("dead.recovery"))));
    }

    void findsOnlyWhatNobodyHolds() {
        const QTemporaryDir folder;
        const auto put = [&](const char *name, const QDateTime &saved) {
            const QString path = folder.filePath(name);
            saveBytes(writeRecovery(example(), {name, saved}), path);
            return path;
        };
        const QString held = put("held.recovery", noon);
        const QString first = put("first.recovery", noon);
        const QString second = put("second.recovery", noon.addSecs(60));
        const QString broken = folder.filePath("broken.recovery");
        saveBytes("no copy", broken);
        QLockFile lock(recoveryLock(held));
        QVERIFY(lock.tryLock(0));
        const auto found = abandonedRecoveries(folder.path());
        QCOMPARE(found.size(), std::size_t{3});
        QCOMPARE(found[0].file, broken); // the latest first: what cannot be read has the time of its file
        QVERIFY(found[0].refusal && !found[0].document);
        QCOMPARE(found[1].file, second);
        QVERIFY(!found[1].refusal);
        QCOMPARE(found[2].file, first);
        QVERIFY(QFile::exists(broken)); // nothing is thrown away unseen
        discardRecovery(first);
        QCOMPARE(abandonedRecoveries(folder.path()).size(), std::size_t{2});
        // Cut off behind its first line it still says whose it is.
        const QByteArray whole = writeRecovery(example(), {"mine.palmer", noon});
        saveBytes(whole.first(whole.size() - 20), second);
        const auto again = abandonedRecoveries(folder.path());
        const auto cut = std::ranges::find(again, second, &Recovery::file);
        QVERIFY(cut != again.end() && cut->refusal);
        QCOMPARE(cut->origin.path, "mine.palmer");
        QVERIFY(abandonedRecoveries(folder.filePath("missing")).empty());
    }
};

QTEST_GUILESS_MAIN(RecoveryTest)
#include "recovery.moc"
