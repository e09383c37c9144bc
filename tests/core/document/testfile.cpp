// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/testfile.h"

#include "core/document/completefile.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/writedocument.h"
#include "import/importmeasurement.h"

#include <QDirIterator>
#include <QStringEncoder>
#include <QTest>

using namespace palmer;

namespace {

QByteArray encoded(const QByteArray &text, QStringConverter::Encoding encoding, bool mark) {
    QStringEncoder encoder(encoding,
                           mark ? QStringConverter::Flag::WriteBom : QStringConverter::Flag::Default);
    return encoder.encode(QString::fromUtf8(text));
}

constexpr std::array encodings{QStringConverter::Utf8,    QStringConverter::Utf16LE,
                               QStringConverter::Utf16BE, QStringConverter::Utf32LE,
                               QStringConverter::Utf32BE, QStringConverter::Latin1};

/// Whether the import refuses it as the test file it was.
bool isRefused(const QByteArray &bytes, const QString &name) {
    try {
        (void)importMeasurement(bytes, name);
        return false;
    } catch (const Error &) {
        return true;
    }
}

} // namespace

/// A test file never reaches a reader of tables, whatever happened to it: its readings would come back
/// without their limits.
class TestFileTest : public QObject {
    Q_OBJECT

private slots:
    void isKnownByItsName() {
        for (const char *name : {"x.palmer", "X.PALMER", "/a/b.c/é.Palmer"})
            QVERIFY(isTestFile("0;1\n2;3\n", QString::fromUtf8(name)));
        for (const char *name : {"x.csv", "palmer", "x.palmer.csv", ""})
            QVERIFY(!isTestFile("0;1\n2;3\n", QString::fromUtf8(name)));
        QVERIFY(isRefused("0;1\n100;2\n", QStringLiteral("x.palmer")));
        QVERIFY(!isRefused("0;1\n100;2\n", QStringLiteral("x.csv")));
    }

    void isKnownWithoutItsBeginning() {
        const QByteArray file = completeFile();
        QVERIFY(file.size() > 1000);
        for (qsizetype size = 0; size < file.size(); ++size) // to the last bracket
            QVERIFY2(size >= file.trimmed().size() || isTestFile(file.mid(size)),
                     qPrintable(QString::number(size)));
        for (qsizetype size = 1; size < file.size(); ++size)
            QVERIFY(isTestFile(file.first(size)));
    }

    /// Neither beginning nor end are left: one of its keys, as JSON writes it, tells.
    void isKnownByAKeyInTheMiddle() {
        for (const char *piece :
             {"1, 2],\n\"deviations\": [0.1", "\"targets\":", "]\n\"targets\" \t\r\n: [0, 1",
              "x\": 1, \"angles\": [0", "a:b \"times\": 0", "\"other\": 1 \"kind\": \"x"})
            QVERIFY2(isTestFile(piece), piece);
        for (const char *piece : {":", "\":", "\"\":", " : 1", "targets: 1", "\"targets\"", "\"target\": 1",
                                  "targets\": 1", "\"targets\"; 1: 2", "\"Targets\": 1", "\"targets\" x: 1"})
            QVERIFY2(!isTestFile(piece), piece);
        const QByteArray file = completeFile();
        const qsizetype key = file.indexOf("\"deviations\"");
        QVERIFY(isTestFile(file.mid(key, 20)) && !isTestFile(file.mid(key + 1, 20)));
    }

    void isKnownInEveryEncoding() {
        const QByteArray file = completeFile();
        for (const auto encoding : encodings) {
            for (const bool mark : {false, true}) {
                for (qsizetype line = 0; line < file.count('\n') - 1; line += 7) {
                    const QList<QByteArray> rest = file.split('\n').mid(line);
                    const QByteArray damaged = encoded(rest.join('\n'), encoding, mark);
                    QVERIFY2(isTestFile(damaged), qPrintable(QString::number(line)));
                    QVERIFY(isRefused(damaged, QStringLiteral("x.csv")));
                }
            }
        }
    }

    void isKnownBehindSomethingElse() {
        const QByteArray file = completeFile();
        for (const QByteArray &before :
             {QByteArray("\n\n \t"), QByteArray("garbage\n"), QByteArray("0;1;2\n3;4;5\n"),
              QByteArray(1, '\0'), QByteArray(8192, 'x'), QByteArray("# a comment\n"),
              QByteArray("\xEF\xBB\xBF\n")}) {
            QVERIFY2(isTestFile(before + file), before.constData());
            QVERIFY(isRefused(before + file, QStringLiteral("x.txt")));
        }
        QByteArray other = file;
        other.replace("palmer test report", "another format");
        QVERIFY(isTestFile(other) && isRefused(other, QStringLiteral("x.txt")));
    }

    void isReadAsWhatItIs() {
        const QByteArray file = completeFile();
        const Document document = readDocument(file);
        for (const auto encoding : encodings) {
            if (encoding == QStringConverter::Latin1) // “é” of UTF-8 is two characters there
                continue;
            for (const bool mark : {false, true})
                QVERIFY2(readDocument(encoded(file, encoding, mark)) == document,
                         QStringConverter::nameForEncoding(encoding));
        }
        // Cut anywhere, or with half a pair of surrogates, it is an error as in UTF-8.
        const QByteArray wide = encoded(file.trimmed(), QStringConverter::Utf16LE, true);
        for (qsizetype size = 0; size < wide.size() - 2; size += 31)
            QVERIFY_EXCEPTION_THROWN(std::ignore = readDocument(wide.first(size)), Error);
        QByteArray broken = wide;
        broken.replace(broken.indexOf('"') + 2, 2, QByteArray("\x00\xD8", 2));
        QVERIFY_EXCEPTION_THROWN(std::ignore = readDocument(broken), Error);
    }

    void noMeasurementIsTakenForOne() {
        int seen = 0;
        for (const char *folder : {"tables", "workbooks", "rtl", "rtx", "b5r", "ren", "indexed"}) {
            QDirIterator files(QStringLiteral(PALMER_SOURCE_DIR "/tests/data/import/") +
                                   QLatin1StringView(folder),
                               QDir::Files);
            while (files.hasNext()) {
                const QString path = files.next();
                QVERIFY2(path.endsWith(QStringLiteral(".expected")) || !isTestFile(readBytes(path), path),
                         qPrintable(path));
                ++seen;
            }
        }
        QVERIFY(seen > 40);
        QVERIFY(!isTestFile("time: 12:30\n\"X\": 0;1\n\"time\": 12:30:01\n0;1\n"));
    }
};

QTEST_APPLESS_MAIN(TestFileTest)
#include "testfile.moc"
