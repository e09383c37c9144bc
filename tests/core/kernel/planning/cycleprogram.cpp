// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/cycleprogram.h"

#include <QTest>
#include <algorithm>

using namespace palmer;

namespace {

/// "−1 0 100 …": where the axis goes; stops in brackets.
QByteArray written(const std::vector<Move> &path) {
    QByteArrayList words;
    for (const Move &move : path) {
        const QByteArray position = QByteArray::number(move.position);
        words << (move.stop ? '[' + position + ']' : position);
    }
    return words.join(' ');
}

} // namespace

class CycleProgramTest : public QObject {
    Q_OBJECT

private slots:
    void turningPoints_data() {
        QTest::addColumn<double>("target");
        QTest::addColumn<double>("approach");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<double>("below");
        QTest::addColumn<double>("above");
        QTest::newRow("whole") << 500.0 << 1.0 << 3 << 499.0 << 501.0;
        QTest::newRow("0.1 is ten hundredths, not eleven") << 2.0 << 0.1 << 2 << 1.9 << 2.1;
        QTest::newRow("rounded away from the target") << 2.0 << 0.11 << 1 << 1.8 << 2.2;
        QTest::newRow("never upon it") << 2.0 << 1e-9 << 2 << 1.99 << 2.01;
        QTest::newRow("the target as it is written") << 2.004 << 1.0 << 2 << 1.0 << 3.0;
        QTest::newRow("without decimals") << -7.0 << 1.5 << 0 << -9.0 << -5.0;
    }

    void turningPoints() {
        QFETCH(double, target);
        QFETCH(double, approach);
        QFETCH(int, decimals);
        CycleProgram program;
        program.decimals = decimals;
        program.approach = approach;
        QTEST(turningPoint(program, target, Direction::positive), "below");
        QTEST(turningPoint(program, target, Direction::negative), "above");
    }

    void theStandardCycleTurnsAtTheEnds() {
        CycleProgram program;
        program.targets = {0, 100};
        program.runs = 2;
        QCOMPARE(written(cyclePath(program)),
                 QByteArray("-1 [0] [100] 101 [100] [0] -1 [0] [100] 101 [100] [0]"));
        program.targets.clear();
        QVERIFY(cyclePath(program).empty());
    }

    void theStepCycleTurnsAtEveryTarget() {
        CycleProgram program;
        program.cycle = Cycle::step;
        program.targets = {0, 100};
        program.runs = 2;
        QCOMPARE(written(cyclePath(program)),
                 QByteArray("-1 [0] 1 [0] -1 [0] 1 [0] 99 [100] 101 [100] 99 [100] 101 [100]"));
        const auto path = cyclePath(program);
        QVERIFY((path[1].stop == Stop{0, 0, Direction::positive}));
        QVERIFY((path[7].stop == Stop{0, 1, Direction::negative}));
        QVERIFY((path[9].stop == Stop{1, 0, Direction::positive}));
    }

    /// Back beyond the first target before every run, and never beyond the last.
    void aTestOfOneDirectionReturnsBeforeEachRun() {
        CycleProgram program;
        program.targets = {0, 100};
        program.runs = 2;
        program.only = Direction::positive;
        QCOMPARE(written(cyclePath(program)), QByteArray("-1 [0] [100] -1 [0] [100]"));
        QVERIFY((movedThrough(program) == Interval{-1, 100}));
        program.only = Direction::negative;
        QCOMPARE(written(cyclePath(program)), QByteArray("101 [100] [0] 101 [100] [0]"));
        program.cycle = Cycle::step;
        program.only = Direction::positive;
        QCOMPARE(written(cyclePath(program)), QByteArray("-1 [0] -1 [0] 99 [100] 99 [100]"));
    }

    void runsAfterTheSecondReachNoFurther() {
        CycleProgram program;
        program.targets = {0, 40, 100};
        program.approach = 2.5;
        for (const Cycle cycle : {Cycle::standard, Cycle::step}) {
            for (const auto only : {std::optional<Direction>(), std::optional(Direction::positive),
                                    std::optional(Direction::negative)}) {
                for (program.runs = 0; program.runs < 6; ++program.runs) {
                    program.cycle = cycle;
                    program.only = only;
                    Interval reached = program.runs > 0 ? Interval{100, 0} : Interval{};
                    for (const Move &move : cyclePath(program))
                        reached = {std::min(reached.from, move.position),
                                   std::max(reached.to, move.position)};
                    QVERIFY(movedThrough(program) == reached);
                }
            }
        }
    }

    void whatLiesBeyondTheAxis_data() {
        QTest::addColumn<TargetRequest>("request");
        QTest::addColumn<double>("below");
        QTest::addColumn<double>("above");
        const auto row = [](const char *name, Motion motion, std::optional<double> travel,
                            std::optional<Interval> range, double below, double above) {
            TargetRequest request;
            request.motion = motion;
            request.axisTravel = travel;
            request.axisRange = range;
            QTest::newRow(name) << request << below << above;
        };
        row("an axis of which nothing is known", Motion::linear, {}, {}, 0, 0);
        row("ends that leave the room", Motion::linear, {}, Interval{-1, 101}, 0, 0);
        row("below", Motion::linear, {}, Interval{0, 101}, 1, 0);
        row("above", Motion::linear, 500, Interval{-5, 100.5}, 0, 0.5);
        row("only the travel, long enough", Motion::linear, 102, {}, 0, 0);
        row("only the travel, too short", Motion::linear, 101.5, {}, 0, 0.5);
        row("a table that turns without end", Motion::rotary, 360, {}, 0, 0);
        row("a table that does not", Motion::rotary, 90, {}, 0, 12);
    }

    void whatLiesBeyondTheAxis() {
        QFETCH(const TargetRequest, request);
        CycleProgram program;
        program.motion = request.motion;
        program.targets = {0, 100};
        const Overtravel over = overtravelOf(program, request);
        QTEST(over.below, "below");
        QTEST(over.above, "above");
        program.targets.clear();
        QVERIFY(!overtravelOf(program, request).any());
    }
};

QTEST_APPLESS_MAIN(CycleProgramTest)
#include "cycleprogram.moc"
