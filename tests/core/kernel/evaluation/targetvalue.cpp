// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/targetvalue.h"

#include <QTest>

#include <limits>

using namespace palmer;

class TargetValueTest : public QObject {
    Q_OBJECT

private slots:
    void everyQuantity_data() {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<double>("expected");
        // ↑ mean 7, s 0.5, W 1.5; ↓ mean 4, s 0.75, W 1.75; c = 2
        const auto row = [](const char *id, double expected) {
            QTest::newRow(id) << QByteArray(id) << expected;
        };
        row("mean+", 7);
        row("mean-", 4);
        row("mean", 5.5);
        row("reversal", 3);
        row("s+", 0.5);
        row("s-", 0.75);
        row("range+", 1.5);
        row("range-", 1.75);
        row("lower+", 7 - 1);
        row("upper+", 7 + 1);
        row("lower-", 4 - 1.5);
        row("upper-", 4 + 1.5);
        row("R+", 4 * 0.5);
        row("R-", 4 * 0.75);
        row("R", 2 * 0.5 + 2 * 0.75 + 3);
    }

    void everyQuantity() {
        QFETCH(QByteArray, id);
        QFETCH(double, expected);
        const TargetStatistics target{{5, 7, 0.5, 1.5}, {5, 4, 0.75, 1.75}};
        QCOMPARE(targetValue(id.toStdString(), target, 2), std::optional(expected));
    }

    void undefinedIsNull() {
        const double none = std::numeric_limits<double>::quiet_NaN();
        const TargetStatistics target{{1, 7, none, 0}, {0, none, none, none}};
        QCOMPARE(targetValue("mean+", target, 2), std::optional(7.0));
        for (const char *id : {"mean-", "mean", "s+", "upper+", "R", "nothing", ""})
            QVERIFY2(!targetValue(id, target, 2), id);
    }
};

QTEST_APPLESS_MAIN(TargetValueTest)
#include "targetvalue.moc"
