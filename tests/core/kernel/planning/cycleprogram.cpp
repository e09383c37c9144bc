// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/planning/cycleprogram.h"

#include <QTest>

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
};

QTEST_APPLESS_MAIN(CycleProgramTest)
#include "cycleprogram.moc"
