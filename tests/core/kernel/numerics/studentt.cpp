// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/studentt.h"

#include <QTest>

#include <cmath>

using palmer::chiSquareExceeded;
using palmer::normalExceeded;
using palmer::studentQuantile975;

class StudentT : public QObject {
    Q_OBJECT

private slots:
    void agreesWithTables_data();
    void agreesWithTables();
    void fallsTowardsTheNormalDistribution();
    void hasNoBoundWithoutDegreesOfFreedom();
    void chiSquare_data();
    void chiSquare();
};

void StudentT::agreesWithTables_data() {
    QTest::addColumn<int>("degrees");
    QTest::addColumn<double>("quantile");
    // NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2; 1 and 2 in closed form
    QTest::newRow("1: tan(0.475 π)") << 1 << 12.7062047361747;
    QTest::newRow("2") << 2 << 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95));
    QTest::newRow("3") << 3 << 3.182446305284263;
    QTest::newRow("4") << 4 << 2.776445105197793;
    QTest::newRow("8") << 8 << 2.306004135204166;
    QTest::newRow("30") << 30 << 2.042272456301238;
    QTest::newRow("100") << 100 << 1.983971518523552;
}

void StudentT::agreesWithTables() {
    QFETCH(int, degrees);
    QFETCH(double, quantile);
    // digits of the tables
    QVERIFY(std::abs(studentQuantile975(degrees) - quantile) < 1e-11 * quantile);
}

void StudentT::fallsTowardsTheNormalDistribution() {
    double before = studentQuantile975(1);
    for (int degrees = 2; degrees < 2000; ++degrees) {
        const double now = studentQuantile975(degrees);
        QVERIFY(now < before);
        QVERIFY(now > 1.959963984540054);
        before = now;
    }
}

void StudentT::hasNoBoundWithoutDegreesOfFreedom() {
    QVERIFY(std::isinf(studentQuantile975(0)));
}

void StudentT::chiSquare_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("probability");
    // NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4
    QTest::newRow("2, 1 %") << 9.210 << 2. << 0.01;
    QTest::newRow("10, 5 %") << 18.307 << 10. << 0.05;
    QTest::newRow("10, 1 %") << 23.209 << 10. << 0.01;
    QTest::newRow("48, 5 %") << 65.171 << 48. << 0.05;
}

void StudentT::chiSquare() {
    QFETCH(double, value);
    QFETCH(double, degrees);
    QFETCH(double, probability);
    const double found = chiSquareExceeded(value, degrees);
    QVERIFY2(std::abs(found / probability - 1) < 0.02, qPrintable(QString::number(found)));
    QCOMPARE(chiSquareExceeded(value, 0), 1.0);
    QCOMPARE(chiSquareExceeded(0, degrees), 1.0);
    QVERIFY(std::abs(normalExceeded(-1.959964) - 0.05) < 1e-7);
}

QTEST_GUILESS_MAIN(StudentT)
#include "studentt.moc"
