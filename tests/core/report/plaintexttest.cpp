// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/blocks/plaintext.h"

#include <QTest>

using namespace palmer;

class PlainTextTest : public QObject {
    Q_OBJECT

private slots:
    void measuresWhatATerminalShows_data();
    void measuresWhatATerminalShows();
    void breaksLinesAtSpacesOnly();
    void alignsColumns();
    void breaksTheFlexibleColumn();
    void leavesOutPictures();
};

void PlainTextTest::measuresWhatATerminalShows_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("width");
    QTest::newRow("nothing") << "" << 0;
    QTest::newRow("plain letters") << "A" << 1;
    QTest::newRow("accents and arrows") << "é↑" << 2;
    QTest::newRow("a combining macron takes no column") << "x\u0304i↓" << 3;
    QTest::newRow("wide characters take two") << "轴" << 2;
    QTest::newRow("outside the basic plane") << "𝑥" << 1;
}

void PlainTextTest::measuresWhatATerminalShows() {
    QFETCH(QString, text);
    QFETCH(int, width);
    QCOMPARE(displayWidth(text), width);
}

void PlainTextTest::breaksLinesAtSpacesOnly() {
    QCOMPARE(wrapped("one two three", 7), QStringList({"one two", "three"}));
    QCOMPARE(wrapped("immeasurably long", 4), QStringList({"immeasurably", "long"}));
    QCOMPARE(wrapped("a b\u00A0c", 3), QStringList({"a", "b\u00A0c"}));
    QCOMPARE(wrapped("first\nsecond", 80), QStringList({"first", "second"}));
}

void PlainTextTest::alignsColumns() {
    Table table;
    table.columns = {{QString("name"), "", Alignment::left, false},
                     {QString("value"), "µm", Alignment::decimal, false}};
    table.rows = {{QString("x\u0304"), QString("−1.5")},
                  {QString("long"), QString("10.25")},
                  {QString(""), QString("")}};
    table.rulesAfter = {1};
    QCOMPARE(plainText({{table}}), QString("━━━━━━━━━━━\n"
                                           "name  value\n"
                                           "         µm\n"
                                           "───────────\n"
                                           "x\u0304     −1.5\n"
                                           "long  10.25\n"
                                           "───────────\n"
                                           "–      –\n"
                                           "━━━━━━━━━━━\n"));
}

void PlainTextTest::breaksTheFlexibleColumn() {
    Table table;
    table.columns = {{QString("result"), "", Alignment::left, true},
                     {QString("v"), "", Alignment::right, false}};
    table.rows = {{QString("repeatability of positioning"), QString("1")}};
    const QStringList lines = plainText({{table}}, 20).split('\n');
    QCOMPARE(lines[3], QString("repeatability of") + QString(3, ' ') + '1');
    QCOMPARE(lines[4], QString("positioning"));
}

void PlainTextTest::leavesOutPictures() {
    Table table;
    table.columns = {{QString("A")}, {QString("± U")}, {QString("U")}};
    Cell picture;
    picture.extras.edit().whisker = Whisker();
    table.rows = {{QString("1"), picture, QString()}, {QString("2"), blankCell(), QString()}};
    QCOMPARE(plainText({{table}}), QString("━━━━\n"
                                           "A  U\n"
                                           "────\n"
                                           "1  –\n"
                                           "2  –\n"
                                           "━━━━\n"));
}

QTEST_GUILESS_MAIN(PlainTextTest)
#include "plaintexttest.moc"
