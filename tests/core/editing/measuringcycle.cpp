// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/measuringcycle.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "editing/editreadings.h"

#include <QTest>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

namespace {

/// Two runs each way over three targets, all places named "run:target" from 1.
PositioningMeasurement threeTargets(Cycle cycle) {
    Test test =
        positioningTest("ISO 230-2:2014", {0, 100, 200}, {{1, 2, 3}, {1, 2, 3}}, {{4, 5, 6}, {4, 5, 6}});
    measurement(test).cycle = cycle;
    return measurement(test);
}

QString walk(const PositioningMeasurement &measurement) {
    QStringList places;
    for (auto place = firstOfCycle(measurement); place; place = nextInCycle(measurement, *place))
        places << QStringLiteral("%1:%2").arg(place->run + 1).arg(place->target + 1);
    return places.join(u' ');
}

} // namespace

class MeasuringCycleTest : public QObject {
    Q_OBJECT

private slots:
    void walksAsTheMachine_data() {
        QTest::addColumn<Cycle>("cycle");
        QTest::addColumn<QString>("order");
        QTest::newRow("standard cycle: up 1…m, down m…1")
            << Cycle::standard << QStringLiteral("1:1 1:2 1:3 2:3 2:2 2:1 3:1 3:2 3:3 4:3 4:2 4:1");
        QTest::newRow("step cycle: all runs at a target, then the next")
            << Cycle::step << QStringLiteral("1:1 2:1 3:1 4:1 1:2 2:2 3:2 4:2 1:3 2:3 3:3 4:3");
    }

    void walksAsTheMachine() {
        QFETCH(Cycle, cycle);
        QFETCH(QString, order);
        QCOMPARE(walk(threeTargets(cycle)), order);
    }

    void backIsTheOtherWayRound() {
        for (const Cycle cycle : {Cycle::standard, Cycle::step}) {
            const PositioningMeasurement measurement = threeTargets(cycle);
            std::set<ReadingPlace> seen;
            auto place = firstOfCycle(measurement);
            while (place) {
                seen.insert(*place);
                const auto next = nextInCycle(measurement, *place);
                if (next)
                    QCOMPARE(previousInCycle(measurement, *next), place);
                place = next;
            }
            QCOMPARE(seen.size(), std::size_t{12});
            QVERIFY(!previousInCycle(measurement, {0, 0}));
        }
    }

    void oneDirectionWalksItOnly() {
        Test test = positioningTest("ISO 230-2:2014", {0, 100}, {}, {{1, 2}, {3, 4}});
        QCOMPARE(walk(measurement(test)), QStringLiteral("1:2 1:1 2:2 2:1"));
    }

    void goesOnWhereTheFirstReadingIsMissing() {
        PositioningMeasurement measurement = threeTargets(Cycle::standard);
        QVERIFY(!firstMissing(measurement));
        setReading(measurement, {1, 1}, std::nullopt);
        QCOMPARE(firstMissing(measurement), (ReadingPlace{1, 1}));
        const ReadingPlace earlier{0, 2};
        setAside(measurement, {&earlier, 1}, "beam interrupted");
        QCOMPARE(firstMissing(measurement), (ReadingPlace{1, 1}));
    }

    void nothingToWalk() {
        const PositioningMeasurement empty;
        QVERIFY(!firstOfCycle(empty));
        QVERIFY(!nextInCycle(empty, {0, 0}));
        QVERIFY(!previousInCycle(empty, {2, 5}));
        QVERIFY(!nextInCycle(threeTargets(Cycle::standard), {0, 3}));
    }
};

QTEST_GUILESS_MAIN(MeasuringCycleTest)
#include "measuringcycle.moc"
