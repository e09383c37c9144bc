// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/readingsaside.h"

#include <QTest>

using namespace palmer;

class ReadingsAsideTest : public QObject {
    Q_OBJECT

private slots:
    void foundByTheirPlace() {
        PositioningMeasurement measurement;
        // not in order; places count from 1
        measurement.excluded = {{2, 3, 0.1, "b"}, {1, 4, 0.2, "a"}, {2, 1, 0.3, "c"}, {2, 3, 0.4, "twice"}};
        const ReadingsAside aside(measurement);
        QCOMPARE(aside.at(0, 3), &measurement.excluded[1]);
        QCOMPARE(aside.at(1, 0), &measurement.excluded[2]);
        QCOMPARE(aside.at(1, 2), &measurement.excluded[0]); // the first of two
        for (const auto &[run, target] : {std::pair(0, 0), {0, 2}, {1, 1}, {1, 3}, {2, 0}, {3, 2}})
            QVERIFY(!aside.at(static_cast<std::size_t>(run), static_cast<std::size_t>(target)));
    }
};

QTEST_APPLESS_MAIN(ReadingsAsideTest)
#include "readingsaside.moc"
