// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/sheetblock.h"

#include "document/documenterror.h"
#include "language/language.h"

#include <QTest>

using namespace palmer;

namespace {

QString told(const std::vector<SheetRow> &rows) {
    QStringList lines;
    const auto number = [](std::optional<double> value) {
        return value ? QString::number(*value, 'g', 12) : "-";
    };
    for (const SheetRow &row : rows)
        lines << QString::fromStdString(row.number) + '|' + QString::fromStdString(row.object) + '|' +
                     (row.permitted.low ? number(row.permitted.low) + ".." : QString()) +
                     number(row.permitted.high) + '|' + number(row.measured) + '|' + number(row.uncertainty) +
                     '|' + QString::fromStdString(row.unit);
    return lines.join('\n');
}

QString pasted(const QString &block, std::size_t first = 0, SheetColumn column = SheetColumn::number,
               std::vector<SheetRow> rows = {}) {
    try {
        return told(pasteSheet(std::move(rows), first, column, block).sheet);
    } catch (const Error &error) {
        return Language(Language::Id::english).sentence(error.message);
    }
}

SheetRow rowOf(const char *number, const char *object) {
    SheetRow row;
    row.number = number;
    row.object = object;
    return row;
}

} // namespace

class SheetBlockTest : public QObject {
    Q_OBJECT

private slots:
    void blocksAreRead_data();
    void blocksAreRead();
    void rowsAreFoundByTheirNumber();
    void blocksWithoutNumbersFillTheRowsFromHere();
    void nothingIsTakenOfAWrongBlock();
    void whatIsTypedIsTakenOrRefused_data();
    void whatIsTypedIsTakenOrRefused();
    void rowsOfTestsKeepTheirNumbers();
};

void SheetBlockTest::blocksAreRead_data() {
    QTest::addColumn<QString>("block");
    QTest::addColumn<QString>("rows");
    QTest::newRow("in the order of the columns") << "G1\tlevel\t0.02\t0.01\t0.004\tmm/m"
                                                 << "G1|level|0.02|0.01|0.004|mm/m";
    QTest::newRow("with a comma") << "G1\tlevel\t0,02\t0,01\t0,004\tmm/m\nG2\tother\t0,015\t0,008\t0,002\tmm"
                                  << "G1|level|0.02|0.01|0.004|mm/m\nG2|other|0.015|0.008|0.002|mm";
    QTest::newRow("a heading says the order")
        << "Unit\tObjet\tU (k = 2)\tMesuré\tN°\nmm\tlevel\t0.004\t0.01\tG1"
        << "G1|level|-|0.01|0.004|mm";
    QTest::newRow("headings with units")
        << "N°;Objet;Tolérance (mm);Mesuré [mm];U, mm\nG1;Rectitude de X, plan XY;0,015;0,008;0,002"
        << "G1|Rectitude de X, plan XY|0.015|0.008|0.002|mm";
    QTest::newRow("headings with units and a column of units")
        << "N°\tTolérance (µm)\tMesuré (µm)\tUnité\nG1\t15\t8\tµm"
        << "G1||15|8|-|µm";
    QTest::newRow("a column without a name is passed over") << "No.\tPage\tObject\nG1\t12\tlevel"
                                                            << "G1|level|-|-|-|";
    QTest::newRow("a range and signs") << "G1\tx\t-0.01 … 0.02\t−0.004\t±0.002\tmm"
                                       << "G1|x|-0.01..0.02|-0.004|0.002|mm";
    QTest::newRow("empty cells and dashes state nothing") << "G1\tx\t0.02\t–\t\tmm"
                                                          << "G1|x|0.02|-|-|mm";
    QTest::newRow("by semicolons") << "G1;table, plan XY;0.02;0.01"
                                   << "G1|table, plan XY|0.02|0.01|-|";
}

void SheetBlockTest::blocksAreRead() {
    QFETCH(QString, block);
    QFETCH(QString, rows);
    QCOMPARE(pasted(block), rows);
}

void SheetBlockTest::rowsAreFoundByTheirNumber() {
    QCOMPARE(pasted("G2\tnew\t0.02\nG3\tthird\t0.01", 0, SheetColumn::number,
                    {rowOf("G1", "a"), rowOf("G2", "b")}),
             "G1|a|-|-|-|\nG2|new|0.02|-|-|\nG3|third|0.01|-|-|");
}

void SheetBlockTest::blocksWithoutNumbersFillTheRowsFromHere() {
    QCOMPARE(pasted("0.01\t0.002\n0.02\t0.003\n0.03\t0.004", 1, SheetColumn::measured,
                    {rowOf("G1", "a"), rowOf("G2", "b"), rowOf("G3", "c")}),
             "G1|a|-|-|-|\nG2|b|-|0.01|0.002|\nG3|c|-|0.02|0.003|\n||-|0.03|0.004|");
}

void SheetBlockTest::nothingIsTakenOfAWrongBlock() {
    QCOMPARE(pasted("G1\tx\t0.02\t0.01\nG2\tx\tabc\t0.01"),
             "line 2 of what was pasted: “abc” cannot stand in this column");
    QCOMPARE(pasted("N°\tTolérance (mm)\tMesuré (µm)\nG1\t0.02\t10"),
             "line 1 of what was pasted: “Mesuré (µm)” cannot stand in this column");
    QCOMPARE(pasted("G1\tx\t-0.02"), "line 1 of what was pasted: “-0.02” cannot stand in this column");
}

void SheetBlockTest::whatIsTypedIsTakenOrRefused_data() {
    QTest::addColumn<SheetColumn>("column");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<bool>("taken");
    QTest::newRow("a tolerance") << SheetColumn::permitted << "0,02" << true;
    QTest::newRow("a tolerance with its sign") << SheetColumn::permitted << "± 0.02" << true;
    QTest::newRow("a range") << SheetColumn::permitted << "-0.01 to 0.02" << true;
    QTest::newRow("a negative tolerance") << SheetColumn::permitted << "-0.01" << false;
    QTest::newRow("no tolerance") << SheetColumn::permitted << "" << true;
    QTest::newRow("words") << SheetColumn::permitted << "small" << false;
    QTest::newRow("a value") << SheetColumn::measured << "−0.004" << true;
    QTest::newRow("no value") << SheetColumn::measured << "x" << false;
    QTest::newRow("a negative uncertainty") << SheetColumn::uncertainty << "-0.1" << false;
    QTest::newRow("another row's number") << SheetColumn::number << "G2" << false;
    QTest::newRow("its own number") << SheetColumn::number << "G1" << true;
    QTest::newRow("too long a text") << SheetColumn::object << QString(5000, 'x') << false;
}

void SheetBlockTest::whatIsTypedIsTakenOrRefused() {
    QFETCH(SheetColumn, column);
    QFETCH(QString, typed);
    QFETCH(bool, taken);
    std::vector<SheetRow> rows{rowOf("G1", "a"), rowOf("G2", "b")};
    rows[0].permitted.high = 0.5;
    const std::vector<SheetRow> before = rows;
    QCOMPARE(!typeIntoSheet(rows, 0, column, typed), taken);
    QVERIFY(taken || rows == before);
}

void SheetBlockTest::rowsOfTestsKeepTheirNumbers() {
    std::vector<SheetRow> rows{rowOf("P1", "A")};
    rows[0].from = SheetSource{"x1", "A"};
    QVERIFY(typeIntoSheet(rows, 0, SheetColumn::measured, "1"));
    QVERIFY(!typeIntoSheet(rows, 0, SheetColumn::object, "accuracy"));
    // The row below the last becomes one when something is typed.
    QVERIFY(!typeIntoSheet(rows, 1, SheetColumn::object, ""));
    QCOMPARE(rows.size(), std::size_t{1});
    QVERIFY(!typeIntoSheet(rows, 1, SheetColumn::object, "level"));
    QCOMPARE(rows.size(), std::size_t{2});
}

QTEST_APPLESS_MAIN(SheetBlockTest)
#include "sheetblock.moc"
