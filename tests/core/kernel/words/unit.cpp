// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/words/unit.h"

#include <QTest>

#include <numbers>
#include <string>

using namespace palmer;

class UnitTest : public QObject {
    Q_OBJECT

private slots:
    void toBase_data() {
        QTest::addColumn<QByteArray>("word");
        QTest::addColumn<QByteArray>("sign");
        QTest::addColumn<double>("number");
        QTest::addColumn<double>("base"); // mm, degrees, s, °C: as it is written, to the last bit
        const auto row = [](const char *word, const char *sign, double number, double base) {
            QTest::addRow("%g %s", number, word) << QByteArray(word) << QByteArray(sign) << number << base;
        };
        row("mm", "mm", 2.1, 2.1);
        row("um", "µm", 2.1, 0.0021);
        row("um", "µm", -18.03, -0.01803);
        row("um", "µm", 0.123456789, 0.000123456789);
        row("nm", "nm", 2.1, 0.0000021);
        row("m", "m", 1.5, 1500);
        row("in", "in", 1, 25.4);
        row("in", "in", 10, 254);
        row("uin", "µin", 1e6, 25.4);
        row("deg", "°", 0.5, 0.5);
        row("arcmin", "′", 90, 1.5);
        row("arcsec", "″", 1800, 0.5);
        row("rad", "rad", std::numbers::pi, 180);
        row("mdeg", "mdeg", 1500, 1.5);
        row("mrad", "mrad", 500 * std::numbers::pi, 90);
        row("urad", "µrad", 1e6 * std::numbers::pi, 180);
        row("s", "s", 7, 7);
        row("min", "min", 1.5, 90);
        row("h", "h", 2, 7200);
        row("ms", "ms", 1500, 1.5);
        row("C", "°C", 20.5, 20.5);
    }

    void toBase() {
        QFETCH(QByteArray, word);
        QFETCH(QByteArray, sign);
        QFETCH(double, number);
        QFETCH(double, base);
        const Unit *unit = unitOf(word.toStdString());
        QVERIFY(unit);
        QCOMPARE(unitOfSign(sign.toStdString()), unit);
        QVERIFY2(unit->toBase(number) == base, qPrintable(QString::number(unit->toBase(number), 'g', 17)));
    }

    /// Every decimal of up to nine places: as the number with its mark moved is read.
    void marksMoveWithoutRounding() {
        const Unit *micrometre = unitOf("um");
        unsigned seed = 1;
        for (int round = 0; round < 5000; ++round) {
            seed = seed * 1664525U + 1013904223U;
            const int places = round % 10;
            const auto moved = [&](int by) {
                return std::stod(std::to_string(seed) + "e-" + std::to_string(by));
            };
            QCOMPARE(micrometre->toBase(moved(places)) == moved(places + 3), true);
        }
        // more digits than any table has: divided
        QCOMPARE(micrometre->toBase(1.0 / 3), 1.0 / 3 / 1000);
        QCOMPARE(micrometre->toBase(1e300), 1e300 / 1000);
    }

    void unknownWords() {
        QVERIFY(!unitOf("µm") && !unitOf("") && !unitOf("foot"));
        QVERIFY(!unitOfSign("um") && !unitOfSign(""));
        QVERIFY(unitOf("um")->kind == UnitKind::length && unitOf("arcsec")->kind == UnitKind::angle &&
                unitOf("ms")->kind == UnitKind::time && unitOf("C")->kind == UnitKind::temperature);
    }
};

QTEST_APPLESS_MAIN(UnitTest)
#include "unit.moc"
