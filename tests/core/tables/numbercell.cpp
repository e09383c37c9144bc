// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "tables/numbercell.h"

#include <QTest>

#include <charconv>
#include <random>

using namespace palmer;

Q_DECLARE_METATYPE(CellKind)

class NumberCellTest : public QObject {
    Q_OBJECT

private slots:
    void readsNumbers_data();
    void readsNumbers();
    void refusesWhatIsNone_data();
    void refusesWhatIsNone();
    void readsEveryNumberExactly();
};

void NumberCellTest::readsNumbers_data() {
    QTest::addColumn<QByteArray>("cell");
    QTest::addColumn<bool>("comma");
    QTest::addColumn<double>("value");
    QTest::newRow("whole") << QByteArray("12") << false << 12.0;
    QTest::newRow("whole under comma") << QByteArray("12") << true << 12.0;
    QTest::newRow("point") << QByteArray("32.56") << false << 32.56;
    QTest::newRow("comma") << QByteArray("32,56") << true << 32.56;
    QTest::newRow("minus") << QByteArray("-0.003") << false << -0.003;
    QTest::newRow("plus") << QByteArray("+0,003") << true << 0.003;
    QTest::newRow("minus of Unicode") << QByteArray("−3,0") << true << -3.0;
    QTest::newRow("en dash of a word processor") << QByteArray("–3.0") << false << -3.0;
    QTest::newRow("no digit before the mark") << QByteArray("-.5") << false << -0.5;
    QTest::newRow("no digit after the mark") << QByteArray("5,") << true << 5.0;
    QTest::newRow("exponent") << QByteArray("-1.5E-03") << false << -0.0015;
    QTest::newRow("exponent under comma") << QByteArray("1,5e+2") << true << 150.0;
    QTest::newRow("exponent with a minus of Unicode") << QByteArray("1.5e−3") << false << 0.0015;
    QTest::newRow("blanks around") << QByteArray(" \t4.25 ") << false << 4.25;
    QTest::newRow("no-break spaces around") << QByteArray("\u00A04,25\u202F") << true << 4.25;
    QTest::newRow("negative zero") << QByteArray("-0.0") << false << -0.0;
    QTest::newRow("many digits") << QByteArray("0.1000000000000000055511151231257827") << false << 0.1;
    QTest::newRow("nearly nothing") << QByteArray("1e-400") << false << 0.0;
    QTest::newRow("largest") << QByteArray("1.7976931348623157e308") << false << 1.7976931348623157e308;
    QTest::newRow("thousands, French") << QByteArray("1\u202F234,5") << true << 1234.5;
    QTest::newRow("thousands, blank") << QByteArray("1 234.5") << false << 1234.5;
    QTest::newRow("thousands, English") << QByteArray("1,234.5") << false << 1234.5;
    QTest::newRow("thousands, German") << QByteArray("1.234,5") << true << 1234.5;
    QTest::newRow("thousands, Swiss") << QByteArray("1'234.5") << false << 1234.5;
    QTest::newRow("millions") << QByteArray("-1,234,567.5") << false << -1234567.5;
    QTest::newRow("smallest") << QByteArray("4.9406564584124654e-324") << false << 4.9406564584124654e-324;
}

void NumberCellTest::readsNumbers() {
    QFETCH(QByteArray, cell);
    QFETCH(bool, comma);
    QFETCH(double, value);
    const CellValue read = readCell(std::string_view(cell), comma ? DecimalMark::comma : DecimalMark::point);
    QVERIFY(read.kind == CellKind::number);
    QVERIFY(read.value == value);
    QCOMPARE(std::signbit(read.value), std::signbit(value));
}

void NumberCellTest::refusesWhatIsNone_data() {
    QTest::addColumn<QByteArray>("cell");
    QTest::addColumn<bool>("comma");
    QTest::addColumn<CellKind>("kind");
    QTest::newRow("the other mark: never 3256") << QByteArray("32,56") << false << CellKind::grouped;
    QTest::newRow("the other mark under comma") << QByteArray("32.56") << true << CellKind::grouped;
    QTest::newRow("thousands without decimals") << QByteArray("1,234") << false << CellKind::grouped;
    QTest::newRow("the other mark behind the mark") << QByteArray("1.234,5") << false << CellKind::grouped;
    QTest::newRow("thousands of two digits") << QByteArray("1,23.5") << false << CellKind::broken;
    QTest::newRow("blank after four digits") << QByteArray("1234 567.5") << false << CellKind::grouped;
    QTest::newRow("nought before a blank") << QByteArray("0 150") << false << CellKind::grouped;
    QTest::newRow("blank before two digits") << QByteArray("1 23.5") << false << CellKind::broken;
    QTest::newRow("two marks") << QByteArray("-4,,7") << true << CellKind::broken;
    QTest::newRow("two signs") << QByteArray("--4") << false << CellKind::broken;
    QTest::newRow("sign behind") << QByteArray("4-") << false << CellKind::broken;
    QTest::newRow("two numbers") << QByteArray("4 5") << false << CellKind::broken;
    QTest::newRow("beyond double") << QByteArray("1e999") << false << CellKind::broken;
    QTest::newRow("beyond double without exponent")
        << QByteArray("9").repeated(350) << false << CellKind::broken;
    QTest::newRow("senselessly long") << QByteArray("9").repeated(5000) << false << CellKind::broken;
    QTest::newRow("infinite") << QByteArray("inf") << false << CellKind::broken;
    QTest::newRow("nan") << QByteArray("NaN") << false << CellKind::broken;
    QTest::newRow("not available") << QByteArray("n/a") << false << CellKind::missing;
    QTest::newRow("error of a spreadsheet") << QByteArray("#N/A") << false << CellKind::missing;
    QTest::newRow("dash") << QByteArray("-") << false << CellKind::missing;
    QTest::newRow("minus alone") << QByteArray("−") << false << CellKind::missing;
    QTest::newRow("nothing") << QByteArray("") << false << CellKind::empty;
    QTest::newRow("blanks") << QByteArray(" \u00A0\t") << false << CellKind::empty;
    QTest::newRow("word") << QByteArray("Point") << false << CellKind::text;
    QTest::newRow("number with unit") << QByteArray("12.5 mm") << false << CellKind::text;
    QTest::newRow("date") << QByteArray("12/03/2026") << false << CellKind::text;
    QTest::newRow("hexadecimal") << QByteArray("0x1A") << false << CellKind::text;
    QTest::newRow("exponent alone") << QByteArray("e5") << false << CellKind::text;
    QTest::newRow("mark alone") << QByteArray(".") << false << CellKind::text;
}

void NumberCellTest::refusesWhatIsNone() {
    QFETCH(QByteArray, cell);
    QFETCH(bool, comma);
    QFETCH(CellKind, kind);
    const CellValue read = readCell(std::string_view(cell), comma ? DecimalMark::comma : DecimalMark::point);
    QCOMPARE(static_cast<int>(read.kind), static_cast<int>(kind));
    QCOMPARE(read.value, 0.0);
}

void NumberCellTest::readsEveryNumberExactly() {
    // As the library rounds, whatever path is taken: numbers of all lengths and sizes.
    std::mt19937_64 random(8);
    for (int trial = 0; trial < 200'000; ++trial) {
        std::string text = random() % 2 ? "-" : "";
        for (auto digits = 1 + random() % 20; digits > 0; --digits)
            text += static_cast<char>('0' + random() % 10);
        if (random() % 4) {
            text += '.';
            for (auto digits = random() % 22; digits > 0; --digits)
                text += static_cast<char>('0' + random() % 10);
        }
        if (random() % 3 == 0)
            text += 'e' + std::to_string(static_cast<int>(random() % 80) - 40);
        double expected = 0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        const CellValue read = readCell(text, DecimalMark::point);
        QVERIFY2(read.kind == CellKind::number && read.value == expected, text.c_str());
        // Whatever follows that is no part of it, many bytes or none.
        char next = ';';
        do {
            next = static_cast<char>(random());
        } while ((next >= '0' && next <= '9') || next == '.' || next == 'e' || next == 'E');
        const std::string line = text + next + "00000000,11111111.2222";
        const LeadingNumber leading = leadingNumber(line, DecimalMark::point);
        QVERIFY2(leading.size == text.size() && leading.value == expected, line.c_str());
    }
}

QTEST_APPLESS_MAIN(NumberCellTest)
#include "numbercell.moc"
