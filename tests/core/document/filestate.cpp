// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/filestate.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer;

/// Whether a file is still what it was.
class FileStateTest : public QObject {
    Q_OBJECT

private slots:
    void filesUpTo4MiBAreHashed() {
        constexpr qint64 most = qint64{4} * 1024 * 1024;
        QVERIFY(!stateOf(written("small", "abc"), true).hash.isEmpty());
        QVERIFY(stateOf(written("small", "abc"), false).hash.isEmpty());
        QVERIFY(!stateOf(written("border", QByteArray(most, 'a')), true).hash.isEmpty());
        QVERIFY(stateOf(written("large", QByteArray(most + 1, 'a')), true).hash.isEmpty());
        QVERIFY(stateOf(m_folder.path(), true).hash.isEmpty()); // a folder has no content
    }

    /// The time may change without the content, and the content within the same second.
    void theContentDecidesWhereItIsKnown() {
        const FileState before = stateOf(written("a", "abc"), true);
        QVERIFY(stateOf(written("b", "abc"), true).isSameContent(before));
        QVERIFY(!stateOf(written("b", "abd"), true).isSameContent(before));
        QVERIFY(!stateOf(written("b", "abcd"), true).isSameContent(before));
        QVERIFY(!stateOf(m_folder.filePath("none"), true).isSameContent(before));
        QVERIFY(!before.isSameContent(stateOf(m_folder.filePath("none"), true)));
        QVERIFY(
            stateOf(m_folder.filePath("none"), true).isSameContent(stateOf(m_folder.filePath("no"), true)));
    }

    void elseTheTimeDecides() {
        FileState before = stateOf(written("a", "abc"), false);
        FileState now = before;
        QVERIFY(now.isSameContent(before));
        now.modified = now.modified.addSecs(1);
        QVERIFY(!now.isSameContent(before));
        before.hash = "x"; // of one of them alone
        QVERIFY(!now.isSameContent(before));
        now.modified = before.modified;
        QVERIFY(now.isSameContent(before));
    }

private:
    [[nodiscard]] QString written(const char *name, const QByteArray &bytes) const {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write");
        return file.fileName();
    }
    static FileState stateOf(const QString &path, bool withHash) { return stateOfFile(path, withHash); }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(FileStateTest)
#include "filestate.moc"
