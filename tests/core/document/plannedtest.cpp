// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/plannedtest.h"

#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/measurement/testfacts.h"

#include <QTest>
#include <cmath>
#include <random>
#include <set>

using namespace palmer;

namespace {

/// What an edition asks of targets, approaches and cycle.
const std::set<std::string> asked{"cycle",           "targetChoice",    "evenSpacing",   "spacing",
                                  "targetsPerMetre", "numberOfTargets", "meanInterval",  "wholeLength",
                                  "quarterTurns",    "freeTargets",     "approaches",    "missingReadings",
                                  "unequalRuns",     "targetsOfTravel", "targetsPerTurn"};

TargetRequest requestFor(const Edition &edition, Motion motion, double travel) {
    TargetRequest request;
    request.rule = edition.targetRule;
    request.motion = motion;
    request.travel = travel;
    return request;
}

Test filledIn(const TargetRequest &request, const Edition &edition) {
    const TargetPlan plan = planTargets(request);
    CycleProgram program;
    program.motion = request.motion;
    program.targets = plan.targets;
    program.runs = plan.runs;
    Test test = plannedTest(request, plan, program, edition.word);
    auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    measurement.axis.travel = request.axisTravel;
    measurement.conditions.continuousDevice = true;
    int reading = 0;
    for (Run &run : measurement.runs) {
        for (auto &deviation : run.deviations)
            deviation = 0.001 * (++reading * 7 % 11);
    }
    return test;
}

/// Findings against a plan, as "id: sentence".
QStringList against(const Test &test) {
    QStringList result;
    for (const Finding &finding : evaluateTest(test, {}).findings) {
        if (asked.contains(finding.id) && finding.state != State::undeclared)
            result << QString::fromStdString(finding.id + ": ") + finding.message.text.source;
    }
    return result;
}

} // namespace

/// A plan, filled in with readings, meets what its own edition asks of targets, approaches and cycle.
class PlannedTest : public QObject {
    Q_OBJECT

private slots:
    void meetsItsEdition_data() {
        QTest::addColumn<QByteArray>("word");
        QTest::addColumn<Motion>("motion");
        for (const Edition *edition : editionsOf(Kind::positioning)) {
            QTest::addRow("%s, linear", edition->word) << QByteArray(edition->word) << Motion::linear;
            QTest::addRow("%s, rotary", edition->word) << QByteArray(edition->word) << Motion::rotary;
        }
    }
    void meetsItsEdition() {
        QFETCH(QByteArray, word);
        QFETCH(Motion, motion);
        const Edition &edition = *findEdition(word.toStdString());
        const bool linear = motion == Motion::linear;
        std::mt19937 generator(20261123);
        std::uniform_real_distribution<double> share(0, 1);
        // limits of the standard and both sides of them, then any
        std::vector<double> travels =
            linear ? std::vector{50.0,   200.0,  999.0,  1000.0, 1001.0, 1999.0,
                                 2000.0, 2000.1, 2050.0, 2130.0, 2500.0, 10000.0}
                   : std::vector{20.0,  89.0,  90.0,  91.0,  180.0, 181.0,  270.0, 359.0,
                                 360.0, 361.0, 380.0, 400.0, 720.0, 1800.0, 3600.0};
        for (int i = 0; i < 60; ++i)
            travels.push_back(linear ? 20 + 5000 * share(generator) : 5 + 1500 * share(generator));
        for (std::size_t i = 0; i < travels.size(); ++i) {
            TargetRequest request = requestFor(edition, motion, travels[i]);
            request.decimals = 3;
            // between 270° and a turn an axis of unknown ends is thought to reach all quarters
            const bool reachesAll = linear || request.travel < 270 || request.travel >= 360;
            request.from = i % 3 == 0 || !reachesAll ? 0 : std::round(2000 * share(generator)) - 1000;
            if (i % 4 == 1)
                request.period = 0.5 + 40 * share(generator);
            if (i % 5 == 2 && reachesAll)
                request.axisTravel = request.travel + 2;
            for (request.seed = 1; request.seed <= 10; ++request.seed) {
                const Test test = filledIn(request, edition);
                const QStringList wrong = against(test);
                QVERIFY2(wrong.isEmpty() &&
                             !std::get<PositioningMeasurement>(test.measurement).targets.empty(),
                         qPrintable(QStringLiteral("travel %1 from %2, seed %3: %4")
                                        .arg(request.travel)
                                        .arg(request.from)
                                        .arg(request.seed)
                                        .arg(wrong.join(QStringLiteral("; ")))));
            }
        }
    }

    /// Quarter turns have no interval, and the test states none.
    void statesNoIntervalThatIsNotThere() {
        TargetRequest request = requestFor(*findEdition("ISO 230-2:1988"), Motion::rotary, 360);
        const auto choice = [](const Test &test) {
            return std::get<PositioningMeasurement>(test.measurement).targetChoice;
        };
        const TargetChoice turns = choice(filledIn(request, *findEdition("ISO 230-2:1988")));
        QVERIFY(turns.kind == TargetChoiceKind::free && !turns.interval && turns.seed == 1);
        request.rule = TargetRule::nominalInterval;
        QCOMPARE(choice(filledIn(request, *findEdition("ISO 230-2:2006"))).interval, std::optional(45.0));
    }

    /// 358° in seven parts: 51.142857, not 51.142857142857146.
    void theIntervalIsStatedInFewDigits() {
        TargetPlan plan;
        QVERIFY(!statedInterval(plan));
        plan.interval = 358.0 / 7;
        QCOMPARE(statedInterval(plan).value(), 51.142857);
    }

    /// Targets, runs, directions and cycle of a test, however they were chosen.
    void aTestIsItsOwnPlan() {
        QVERIFY(!planOf(Test()));
        QVERIFY(!planOf(testOf(Kind::circular)));
        Test test;
        PositioningMeasurement measurement;
        measurement.axis.name = "Y";
        measurement.axis.travel = 500;
        measurement.targets = {0.5, 120.12345, 480};
        measurement.cycle = Cycle::step;
        measurement.conditions.feed = 900;
        const std::vector<std::optional<double>> nothing(3);
        measurement.runs = {{Direction::negative, nothing}, {Direction::negative, nothing}};
        test.measurement = measurement;
        const auto plan = planOf(test);
        QVERIFY(plan && plan->planned.plan.ofTest);
        QCOMPARE(plan->program.targets, measurement.targets);
        QCOMPARE(plan->program.decimals, 5);
        QCOMPARE(plan->program.runs, 2);
        QCOMPARE(plan->program.only, std::optional(Direction::negative));
        QCOMPARE(plan->program.cycle, Cycle::step);
        QCOMPARE(plan->program.feed, std::optional(900.0));
        QCOMPARE(plan->program.axis, std::string("Y"));
        QCOMPARE(plan->planned.request.axisTravel, std::optional(500.0));
        measurement.runs.push_back({Direction::positive, nothing});
        test.measurement = measurement;
        QVERIFY(!planOf(test)->program.only);
        QCOMPARE(planOf(test)->program.runs, 2);
        measurement.runs.clear();
        test.measurement = measurement;
        QCOMPARE(planOf(test)->program.runs, 5); // as the standards ask
    }
};

QTEST_APPLESS_MAIN(PlannedTest)
#include "plannedtest.moc"
