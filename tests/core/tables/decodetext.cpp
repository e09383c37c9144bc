// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "tables/decodetext.h"

#include <QTest>

using namespace palmer;

class DecodeTextTest : public QObject {
    Q_OBJECT

private slots:
    void readsEncodings_data();
    void readsEncodings();
    void tellsChineseFromWesternText_data();
    void tellsChineseFromWesternText();
    void refusesWhatIsNoText_data();
    void refusesWhatIsNoText();
    void countsLinesOfAllKinds();
};

void DecodeTextTest::readsEncodings_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("encoding");
    QTest::addColumn<bool>("guessed");
    const int utf8 = static_cast<int>(Encoding::utf8);
    QTest::newRow("UTF-8") << QByteArray("écart;µm") << utf8 << false;
    QTest::newRow("UTF-8 with its mark") << QByteArray("\xEF\xBB\xBFécart;µm") << utf8 << false;
    QTest::newRow("UTF-16 little end first") << QByteArray("\xFF\xFE\xE9\0c\0a\0r\0t\0;\0\xB5\0m\0", 18)
                                             << static_cast<int>(Encoding::utf16LittleEndian) << false;
    QTest::newRow("UTF-16 big end first") << QByteArray("\xFE\xFF\0\xE9\0c\0a\0r\0t\0;\0\xB5\0m", 18)
                                          << static_cast<int>(Encoding::utf16BigEndian) << false;
    QTest::newRow("Windows-1252") << QByteArray("\xE9"
                                                "cart;\xB5m")
                                  << static_cast<int>(Encoding::windows1252) << true;
}

void DecodeTextTest::readsEncodings() {
    QFETCH(QByteArray, bytes);
    QFETCH(int, encoding);
    QFETCH(bool, guessed);
    const DecodedText decoded = decodeText(bytes);
    QCOMPARE(QString::fromStdString(decoded.text), QString("écart;µm"));
    QCOMPARE(static_cast<int>(decoded.encoding.value), encoding);
    QCOMPARE(decoded.encoding.origin == Origin::guessed, guessed);
}

// The bytes are those of iconv -t GBK and -t CP1252.
void DecodeTextTest::tellsChineseFromWesternText_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("text");
    QTest::newRow("Chinese") << QByteArray("\xBB\xFA\xB4\xB2: \xBC\xD3\xB9\xA4\xD6\xD0\xD0\xC4")
                             << "机床: 加工中心";
    QTest::newRow("Chinese with units")
        << QByteArray("\xCE\xF3\xB2\xEE (\xA6\xCCm) 20 \xA1\xE6") << "误差 (μm) 20 ℃";
    QTest::newRow("one pair proves nothing") << QByteArray("\xE9\xE9") << "éé";
    QTest::newRow("letters beside one another") << QByteArray("cr\xE9\xE9, id\xE9\xE9, 20 \xB0"
                                                              "C")
                                                << "créé, idéé, 20 °C";
    QTest::newRow("German") << QByteArray("Pr\xFC"
                                          "fer: M\xFCller, gr\xF6\xDFte")
                            << "Prüfer: Müller, größte";
}

void DecodeTextTest::tellsChineseFromWesternText() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, text);
    const DecodedText decoded = decodeText(bytes);
    QCOMPARE(QString::fromStdString(decoded.text), text);
    QCOMPARE(decoded.encoding.origin, Origin::guessed);
    QCOMPARE(QString::fromStdString(decodeText(bytes, decoded.encoding.value).text), text);
}

void DecodeTextTest::refusesWhatIsNoText_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("place");
    QTest::newRow("nothing") << QByteArray() << "";
    QTest::newRow("blanks") << QByteArray(" \r\n\t\n") << "";
    QTest::newRow("a mark alone") << QByteArray("\xEF\xBB\xBF") << "";
    QTest::newRow("a zero byte") << QByteArray("1;2\n3;\0", 7) << "2:3";
    QTest::newRow("a bell far behind") << QByteArray("1;2\n").repeated(100) + "4;\a;5"
                                       << "101:3";
    QTest::newRow("half a character of UTF-16") << QByteArray("\xFF\xFE\x31\0\x00", 5) << "1:2";
    QTest::newRow("half a pair of UTF-16") << QByteArray("\xFF\xFE\x31\0\x00\xD8\x31\0", 8) << "1:2";
    QTest::newRow("no character of any code") << QByteArray("ab\n\x81") << "2:1";
}

void DecodeTextTest::refusesWhatIsNoText() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, place);
    try {
        (void)decodeText(bytes);
    } catch (const Error &error) {
        QCOMPARE(QString::fromStdString(error.place), place);
        QVERIFY(!error.message.text.empty());
        return;
    }
    QFAIL("accepted");
}

void DecodeTextTest::countsLinesOfAllKinds() {
    const std::string text = "a\r\nbé\rc\nd";
    QCOMPARE(lineAndColumn(text, 0), std::string("1:1"));
    QCOMPARE(lineAndColumn(text, 3), std::string("2:1"));
    QCOMPARE(lineAndColumn(text, text.find('\r', 4)), std::string("2:3"));
    QCOMPARE(lineAndColumn(text, text.find('c')), std::string("3:1"));
    QCOMPARE(lineAndColumn(text, text.size()), std::string("4:2"));
}

QTEST_APPLESS_MAIN(DecodeTextTest)
#include "decodetext.moc"
