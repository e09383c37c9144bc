// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/newtest.h"

#include "document/readdocument.h"
#include "document/writedocument.h"
#include "editing/editreadings.h"
#include "editing/measuringcycle.h"
#include "editing/takestatements.h"

#include <QTest>

using namespace palmer;

namespace {

NewPositioningTest wanted() {
    NewPositioningTest result;
    result.axis.name = "X";
    result.axis.travel = 1800;
    result.targets = evenTargets(0, 1800, 11, 0.001);
    return result;
}

} // namespace

class NewTestTest : public QObject {
    Q_OBJECT

private slots:
    void isEmptyAndComplete() {
        const Test test = newTest(wanted());
        const auto &m = std::get<PositioningMeasurement>(test.measurement);
        QCOMPARE(m.runs.size(), std::size_t{10});
        QCOMPARE(m.runs[1].approach, Direction::negative);
        QCOMPARE(firstMissing(m), firstOfCycle(m));
        Document document;
        QCOMPARE(insertTest(document, 0, test), std::size_t{0});
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void evenTargetsAreRound() {
        QCOMPARE(evenTargets(0, 0.4, 5, 0.1), (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4}));
        QCOMPARE(evenTargets(-10, 10, 3, 1), (std::vector<double>{-10, 0, 10}));
        QCOMPARE(evenTargets(0, 1000, 4, 0.001), (std::vector<double>{0, 333.333, 666.667, 1000}));
        QCOMPARE(evenTargets(0, 1, 5, 1), (std::vector<double>{0, 1})); // no finer than the resolution
        QVERIFY(evenTargets(5, 5, 3).empty());
        QVERIFY(evenTargets(5, 1, 3).empty());
    }

    void idsAreUnique() {
        Document document;
        for (int i = 0; i < 3; ++i)
            insertTest(document, document.tests.size(), newTest(wanted()));
        QCOMPARE(document.tests[0]->id, std::string("x1"));
        QCOMPARE(document.tests[2]->id, std::string("x3"));
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void duplicatesWithAndWithoutReadings() {
        Document document;
        Test test = newTest(wanted());
        test.title = "as found";
        test.date = "2026-11-21";
        test.remarks = "a crane passed during run 3";
        auto &m = std::get<PositioningMeasurement>(test.measurement);
        m.conditions.gradientPerHour = 0.4;
        m.conditions.gradientHoursBefore = 12;
        setReading(m, {0, 0}, 0.001);
        setRefused(m, {0, 1}, "?");
        insertTest(document, 0, test);
        QCOMPARE(duplicateTest(document, 0, true), std::size_t{1});
        QVERIFY(document.tests[1]->measurement == document.tests[0]->measurement);
        QVERIFY(document.tests[1]->id != document.tests[0]->id);
        QCOMPARE(duplicateTest(document, 0, false), std::size_t{1});
        const auto &empty = std::get<PositioningMeasurement>(document.tests[1]->measurement);
        QCOMPARE(firstMissing(empty), firstOfCycle(empty));
        QVERIFY(empty.refused.empty() && !document.tests[1]->date);
        QCOMPARE(document.tests[1]->remarks, std::string());
        QVERIFY(!empty.conditions.gradientPerHour && !empty.conditions.gradientHoursBefore);
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void takesOverWhatHoldsForTheWholeMachine() {
        Test from = newTest(wanted());
        from.instruments = {"L1"};
        from.decisionRule.rule = Rule::iso14253_1;
        from.limits["A"].value = 0.012;
        from.date = "2026-11-21";
        from.agreedPoints = {{"warmUp", AgreementState::agreed, "60 min"},
                             {"otherAxes", AgreementState::agreed, "Y 250"},
                             {"dwell", AgreementState::agreed, "5 s"}};
        auto &stated = std::get<PositioningMeasurement>(from.measurement);
        stated.conditions.common.warmUp = {WarmUpKind::procedure, "60 min"};
        stated.conditions.common.sensors = {{SensorMeasures::machine, "table", 20.1, 20.4, {}},
                                            {SensorMeasures::instrument, "beam", 20.2, 20.3, {}}};
        stated.conditions.common.expansion = {11.5, 0.0};
        stated.conditions.common.otherAxes = "Y 250";
        stated.conditions.common.toolOffset = {0.0, 0.0, 120.0};
        stated.conditions.feed = 5000;
        stated.conditions.airPressure = 1008;
        stated.conditions.gradientPerHour = 0.4;
        stated.uncertainty.method = UncertaintyMethod::budget;
        stated.uncertainty.device.fixed = 0.3;
        stated.uncertainty.misalignmentRange = 1;
        stated.uncertainty.environmentalVariation = 0.6;

        NewPositioningTest next = wanted();
        next.axis.name = "Y";
        Test y = newTest(next);
        takeStatements(y, from);
        const auto &taken = std::get<PositioningMeasurement>(y.measurement);
        QCOMPARE(y.instruments, from.instruments);
        QVERIFY(y.decisionRule == from.decisionRule && y.limits.empty() && !y.date);
        QCOMPARE(y.agreedPoints.size(), std::size_t{2});
        QVERIFY(taken.axis.name == "Y" && firstMissing(taken) == firstOfCycle(taken));
        PositioningConditions expected;
        expected.feed = 5000;
        expected.common.warmUp = stated.conditions.common.warmUp;
        expected.common.expansion = stated.conditions.common.expansion;
        expected.common.sensors = {{SensorMeasures::machine, "table", {}, {}, {}},
                                   {SensorMeasures::instrument, "beam", {}, {}, {}}};
        QVERIFY(taken.conditions == expected); // nothing that was measured or belongs to the axis
        PositioningUncertaintyInputs budget;
        budget.method = UncertaintyMethod::budget;
        budget.device.fixed = 0.3;
        QVERIFY(taken.uncertainty == budget);

        next.axis.motion = Motion::rotary; // another instrument
        Test c = newTest(next);
        takeStatements(c, from);
        Test circle = newTest(NewCircularTest());
        takeStatements(circle, from);
        for (const Test *other : {&c, &circle}) {
            QVERIFY(other->instruments.empty());
            QCOMPARE(other->agreedPoints.size(), std::size_t{1});
            QVERIFY(other->decisionRule == from.decisionRule);
        }
        QVERIFY(!std::get<PositioningMeasurement>(c.measurement).conditions.feed);
        const Conditions &common = std::get<CircularMeasurement>(circle.measurement).conditions.common;
        QCOMPARE(common.sensors.size(), std::size_t{1});
        QVERIFY(common.expansion == Expansion({11.5, std::nullopt}));
        QCOMPARE(common.warmUp.text, std::string("60 min"));
        Test drift = newDriftTest(next.axis);
        takeStatements(drift, from);
        QVERIFY(drift == newDriftTest(next.axis));
    }

    /// A repeat takes all but what is measured on its day, and overwrites nothing.
    void fillsLikeTheLastTest() {
        Document source;
        source.machine.name = "Mill";
        source.machine.serialNumber = "7";
        source.instruments.resize(1);
        source.instruments[0].id = "laser";
        source.instruments[0].description = "Laser";
        Test last = newTest(wanted());
        last.date = "2026-11-20";
        last.instruments = {"laser"};
        last.purpose = Purpose::acceptance;
        last.limits["A"].value = 0.02;
        last.agreedPoints = {{"warmUp", AgreementState::agreed, "60 min"},
                             {"otherAxes", AgreementState::agreed, "Y 250"}};
        auto &stated = std::get<PositioningMeasurement>(last.measurement);
        stated.axis.positionFeedback = "linear scale";
        stated.conditions.common.sensors = {{SensorMeasures::machine, "table", 20.1, 20.4, {}}};
        stated.conditions.common.otherAxes = "Y 250";
        stated.conditions.common.load = "none";
        stated.conditions.dwell = 3;
        stated.conditions.airPressure = 1008;
        stated.conditions.gradientPerHour = 0.4;
        stated.uncertainty.misalignmentRange = 1;
        stated.uncertainty.environmentalVariation = 0.6;
        source.tests = {std::make_shared<const Test>(last)};

        Document document;
        document.machine.name = "Mill 2";
        document.instruments.resize(1); // another one under that name
        document.instruments[0].id = "laser";
        document.instruments[0].description = "Ball bar";
        Test own = newTest(wanted());
        std::get<PositioningMeasurement>(own.measurement).conditions.dwell = 5;
        document.tests = {std::make_shared<const Test>(own)};
        fillLike(document, 0, source, 0);
        const Test &filled = *document.tests[0];
        const auto &measurement = std::get<PositioningMeasurement>(filled.measurement);
        QCOMPARE(document.machine.name, std::string("Mill 2"));
        QCOMPARE(document.machine.serialNumber, std::string("7"));
        QCOMPARE(document.instruments.size(), std::size_t{2});
        QCOMPARE(filled.instruments, std::vector<std::string>{document.instruments[1].id});
        QVERIFY(filled.purpose == Purpose::acceptance && filled.limits == last.limits);
        QCOMPARE(filled.agreedPoints.size(), std::size_t{2});
        QCOMPARE(measurement.axis.positionFeedback, std::string("linear scale"));
        QCOMPARE(measurement.conditions.common.otherAxes, std::string("Y 250"));
        QCOMPARE(measurement.conditions.common.load, std::string("none"));
        QCOMPARE(measurement.conditions.dwell, std::optional(5.0)); // was stated
        QCOMPARE(measurement.uncertainty.misalignmentRange, std::optional(1.0));
        QVERIFY(measurement.conditions.common.sensors ==
                (std::vector<Sensor>{{SensorMeasures::machine, "table", {}, {}, {}}}));
        QVERIFY(!filled.date && !measurement.conditions.airPressure &&
                !measurement.conditions.gradientPerHour && !measurement.uncertainty.environmentalVariation);
        const Document once = document;
        fillLike(document, 0, source, 0);
        QVERIFY(document == once);

        Document ofY = document;
        Test y = newTest(wanted());
        std::get<PositioningMeasurement>(y.measurement).axis.name = "Y";
        ofY.tests.push_back(std::make_shared<const Test>(y));
        QCOMPARE(lastTestLike(ofY, 1), std::optional(std::size_t{0}));
        fillLike(ofY, 1, ofY, 0);
        const auto &taken = std::get<PositioningMeasurement>(ofY.tests[1]->measurement);
        QVERIFY(ofY.tests[1]->limits.empty() && taken.conditions.common.otherAxes.empty()); // of X alone
        QCOMPARE(taken.conditions.common.load, std::string("none"));
        QVERIFY(!lastTestLike(source, 0));
    }

    /// The newest, but rather an older one of the same axis.
    void theLastTestIsOfTheSameAxis() {
        Document document;
        const auto add = [&](const char *axis, const char *date) {
            Test test = newTest(wanted());
            std::get<PositioningMeasurement>(test.measurement).axis.name = axis;
            test.date = date;
            document.tests.push_back(std::make_shared<const Test>(test));
        };
        add("X", "2026-01-02");
        add("X", "2026-01-01");
        add("Y", "2026-01-03");
        add("X", "2026-01-04");
        QCOMPARE(lastTestLike(document, 3), std::optional(std::size_t{0}));
        QCOMPARE(lastTestLike(document, 2), std::optional(std::size_t{3}));
    }

    void removesWhatNamesTheTest() {
        Document document;
        Test drift;
        drift.id = "d1";
        drift.measurement = DriftMeasurement{};
        std::get<DriftMeasurement>(drift.measurement).times = {0, 1};
        std::get<DriftMeasurement>(drift.measurement).deviations = {0, 0.001};
        insertTest(document, 0, drift);
        Test test = newTest(wanted());
        std::get<PositioningMeasurement>(test.measurement).uncertainty.driftTest = "d1";
        insertTest(document, 0, test);
        removeTest(document, 0);
        QCOMPARE(document.tests.size(), std::size_t{1});
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void removesWhatComparesWithTheTest() {
        Document document;
        Test before = newTest(wanted());
        before.id = "before";
        Test after = newTest(wanted());
        after.comparedWith = ComparedWith{"before"};
        document.tests = {std::make_shared<const Test>(before), std::make_shared<const Test>(after)};
        removeTest(document, 0);
        QVERIFY(!document.tests.at(0)->comparedWith);
    }
};

QTEST_GUILESS_MAIN(NewTestTest)
#include "newtest.moc"
