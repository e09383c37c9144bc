// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "tables/cellunits.h"

#include <QTest>

using namespace palmer;

class CellUnitsTest : public QObject {
    Q_OBJECT

private slots:
    void readsNumbersWithUnits_data() {
        QTest::addColumn<QString>("cell");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        const auto row = [](const char *cell, double value, const char *unit) {
            QTest::newRow(cell) << QString(cell) << value << QString(unit);
        };
        row("1.234 mm", 1.234, "mm");
        row("-2.1µm", -2.1, "um");
        row("−2.1 um", -2.1, "um");
        row("+3 Âµm", 3, "um");
        row("1e-3 mm", 1e-3, "mm");
        row("12.5°", 12.5, "deg");
        row("12.5 deg", 12.5, "deg");
        row("1.5\"", 1.5, "arcsec");
        row("1.5''", 1.5, "arcsec");
        row("1.5\"\"", 1.5, "arcsec");
        row("1.5′", 1.5, "arcmin");
        row("20.1 °C", 20.1, "C");
        row("12°30'15\"", 45015.0 / 3600, "deg");
        row("12° 30' 15.5\"", 45015.5 / 3600, "deg");
        row("12°30′", 12.5, "deg");
        row("-0°30'", -0.5, "deg");
        row("−0°0′1.8″", -0.0005, "deg");
        row("12°30’15’’", 45015.0 / 3600, "deg");
    }
    void readsNumbersWithUnits() {
        QFETCH(QString, cell);
        QFETCH(double, value);
        QFETCH(QString, unit);
        const auto read = cellWithUnit(cell.toStdString(), DecimalMark::point);
        QVERIFY(read);
        QCOMPARE(QString(read->unit->word), unit);
        QCOMPARE(read->value - value, 0.0); // QCOMPARE of doubles lets the last bits go
    }

    void leavesOtherTexts_data() {
        QTest::addColumn<QString>("cell");
        for (const char *cell :
             {"mm",     "1.234",      "",        "1.2 mm/m", "1.2 mm approx", "1,5 mm",   "1 234.5 mm",
              "3 h",    "1 X",        "2 M",     "1C",       "5 s",           "10 min",   "1.2 ell",
              "12°60'", "12°30'60\"", "12°-30'", "12.5°30'", "12°30''",       "12:30:15", "12°30'15\"x",
              "x 1 mm", "2 runs",     "1.2 mm 3"})
            QTest::newRow(cell) << QString(cell);
    }
    void leavesOtherTexts() {
        QFETCH(QString, cell);
        QVERIFY(!cellWithUnit(cell.toStdString(), DecimalMark::point));
    }

    /// The decimals of the text, whatever the unit: no last bit is lost.
    void movesDecimals() {
        for (const double value : {2.1, 0.7, -3.3, 123.4567, 0.1, 4.35}) {
            const std::string number = std::to_string(value);
            const auto inUm = numberIn(*unitOf("um"), number + " mm", DecimalMark::point);
            QVERIFY(inUm);
            QCOMPARE(*inUm - std::stod(number + "e3"), 0.0);
            const auto inNm = numberIn(*unitOf("nm"), number + " µm", DecimalMark::point);
            QCOMPARE(*inNm - std::stod(number + "e3"), 0.0);
            QCOMPARE(numberIn(*unitOf("mm"), number + " mm", DecimalMark::point).value() - value, 0.0);
        }
        QVERIFY(!numberIn(*unitOf("um"), "1 in", DecimalMark::point));
        QVERIFY(!numberIn(*unitOf("um"), "1e-3 mm", DecimalMark::point));
        QVERIFY(!numberIn(*unitOf("um"), "1°", DecimalMark::point));
        QCOMPARE(numberIn(*unitOf("deg"), "1.8″", DecimalMark::point).value() - 0.0005, 0.0);
    }
};

QTEST_GUILESS_MAIN(CellUnitsTest)
#include "cellunits.moc"
