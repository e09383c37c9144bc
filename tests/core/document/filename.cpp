// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/filename.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace palmer;

/// Names of files whose bytes are no UTF-8.
class FileNameTest : public QObject {
    Q_OBJECT

private slots:
    void eachByteThatIsNoUtf8StandsAlone_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<bool>("isUtf8");
        QTest::newRow("ASCII") << QByteArray("a.palmer") << QString("a.palmer") << true;
        QTest::newRow("UTF-8") << QByteArray("\xc3\xa9t\xc3\xa9 \xf0\x9f\x93\x90")
                               << QString::fromUtf8("été 📐") << true;
        QTest::newRow("Latin-1") << QByteArray("\xe9t\xe9.csv") << QString::fromUtf8("été.csv") << false;
        QTest::newRow("both") << QByteArray("\xc3\xa9-\xe9") << QString::fromUtf8("é-é") << false;
        QTest::newRow("cut short") << QByteArray("\xf0\x9f\x93") << QString::fromLatin1("\xf0\x9f\x93")
                                   << false;
        QTest::newRow("four bytes behind one")
            << QByteArray("\xff\xf0\x9f\x93\x90") << QString::fromUtf8("ÿ📐") << false;
        QTest::newRow("nothing") << QByteArray() << QString() << true;
    }

    void eachByteThatIsNoUtf8StandsAlone() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, shown);
        QFETCH(bool, isUtf8);
        const QString name = fileNameOf(bytes);
        QCOMPARE(isUtf8FileName(name), isUtf8);
        QCOMPARE(shownFileName(name), shown);
        QCOMPARE(nativeFileName(name), bytes);
    }

    /// No two names are one: any bytes come back.
    void anyBytesComeBack() {
        std::mt19937 random(7);
        const QByteArray pieces[]{"a",    "\xe9",        "\xc3\xa9", "\xc3", "\xf0\x9f\x93\x90",
                                  "\x80", "\xed\xb2\x80"};
        for (int k = 0; k < 2000; ++k) {
            QByteArray bytes;
            for (unsigned n = random() % 8; n > 0; --n)
                bytes += pieces[random() % std::size(pieces)];
            const QString name = fileNameOf(bytes);
            QVERIFY2(nativeFileName(name) == bytes, bytes.toHex());
            QVERIFY(isUtf8FileName(shownFileName(name)));
        }
    }

    void aFileOfSuchANameIsReached() {
        const QTemporaryDir folder;
        const QByteArray native = QFile::encodeName(folder.path()) + "/m\xe9.csv";
        FILE *file = fopen(native.constData(), "w");
        if (!file)
            QSKIP("this disk keeps names in UTF-8 only");
        fputs("abc", file);
        fclose(file);
        const ReachableFile reachable(fileNameOf(native));
        QFile found(reachable.name());
        QVERIFY(found.open(QIODevice::ReadOnly));
        QCOMPARE(found.readAll(), QByteArray("abc"));
        const ReachableFile plain("a.csv");
        QCOMPARE(plain.name(), QString("a.csv"));
        QCOMPARE(remove(native.constData()), 0);
    }
};

QTEST_GUILESS_MAIN(FileNameTest)
#include "filename.moc"
