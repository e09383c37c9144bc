// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/testfacts.h"

#include <QTest>
#include <array>
#include <utility>

using namespace palmer;

namespace {

Test positioning(Motion motion = Motion::linear) {
    PositioningMeasurement measurement;
    measurement.axis.name = "C";
    measurement.axis.motion = motion;
    measurement.targets = {0, 1, 2};
    measurement.runs = {{Direction::positive, {0.1, {}, 0.2}}, {Direction::negative, {0.1, 0.3, {}}}};
    measurement.uncertainty.method = UncertaintyMethod::budget;
    Test test;
    test.measurement = std::move(measurement);
    return test;
}

Test circles() {
    CircularMeasurement measurement;
    measurement.plane = {"X", "Y"};
    measurement.arcs.resize(2);
    measurement.arcs[0].angles = measurement.arcs[0].radialDeviations = {0, 1, 2, 3};
    measurement.arcs[1].angles = measurement.arcs[1].radialDeviations = {5};
    measurement.uncertainty.method = UncertaintyMethod::direct;
    Test test;
    test.measurement = std::move(measurement);
    return test;
}

Test drift(Motion motion = Motion::linear) {
    DriftMeasurement measurement;
    measurement.axis.name = "Z";
    measurement.axis.motion = motion;
    measurement.times = {0, 60};
    measurement.deviations = {-0.25, 0.5};
    Test test;
    test.measurement = std::move(measurement);
    return test;
}

} // namespace

/// What tests of each kind say of themselves.
class TestFactsTest : public QObject {
    Q_OBJECT

private slots:
    void axes() {
        QCOMPARE(axesOf(positioning()), std::string("C"));
        QCOMPARE(axesOf(circles()), std::string("XY"));
        QCOMPARE(axesOf(drift()), std::string("Z"));
        QCOMPARE(axesOf(Test()), std::string());
        const Test axis = positioning();
        const Test plane = circles();
        const Test still = drift();
        QCOMPARE(axisOf(axis)->name, std::string("C"));
        QVERIFY(!axisOf(plane));
        QCOMPARE(axisOf(still)->name, std::string("Z"));
    }

    void motion() {
        QCOMPARE(motionOf(positioning()), Motion::linear);
        QCOMPARE(motionOf(positioning(Motion::rotary)), Motion::rotary);
        QCOMPARE(motionOf(circles()), Motion::linear);
        QCOMPARE(motionOf(drift()), Motion::linear);
        QCOMPARE(motionOf(drift(Motion::rotary)), Motion::rotary);
    }

    /// The conditions are those of the measurement: what is changed there stays.
    void conditions() {
        for (Test test : {positioning(), circles()}) {
            QVERIFY(isJudged(test));
            conditionsOf(test)->compensation = "on";
            QCOMPARE(conditionsOf(std::as_const(test))->compensation, std::string("on"));
        }
        Test still = drift();
        QVERIFY(!isJudged(still));
        QVERIFY(!conditionsOf(still));
    }

    void uncertainty() {
        const Test axis = positioning();
        const Test plane = circles();
        const Test still = drift();
        QCOMPARE(*methodOf(axis), UncertaintyMethod::budget);
        QCOMPARE(*methodOf(plane), UncertaintyMethod::direct);
        QVERIFY(!methodOf(still));
        for (Test test : {positioning(), circles(), drift()}) {
            QVERIFY(!driftTestOf(test));
            int uses = 0;
            withUncertainty(test, [&](auto &inputs) {
                inputs.driftTest = "d";
                ++uses;
            });
            QCOMPARE(uses, isJudged(test) ? 1 : 0);
            QCOMPARE(driftTestOf(test) != nullptr, isJudged(test));
            QVERIFY(!driftTestOf(test) || *driftTestOf(test) == "d");
        }
    }

    void range() {
        QCOMPARE(rangeOf(std::get<DriftMeasurement>(drift().measurement)), std::optional(0.75));
        QVERIFY(!rangeOf(DriftMeasurement()));
    }

    /// A drift test of a linear axis may record angles.
    void theMainChannelHasTheQuantity() {
        DriftMeasurement measurement;
        measurement.axis.name = "X";
        QCOMPARE(deviationQuantity(measurement), Quantity::deviation);
        measurement.channels = {{"A", ChannelQuantity::angularDeviation, {0.0, 0.001}}};
        QCOMPARE(deviationQuantity(measurement), Quantity::angularDeviation);
        measurement.channels.push_back({"X", ChannelQuantity::deviation, {0.0, 0.001}});
        Test test;
        test.measurement = measurement;
        QCOMPARE(deviationQuantity(test), Quantity::deviation);
        DriftMeasurement rotary;
        rotary.axis.motion = Motion::rotary;
        QCOMPARE(deviationQuantity(rotary), Quantity::angularDeviation);
    }

    void kinds() {
        for (const Kind kind : allKinds)
            QCOMPARE(kindOf(testOf(kind)), kind);
        const auto traits = [](const Test &test) {
            const KindOfTest &row = traitsOf(test);
            return std::array{row.isJudged, row.isOfAxis, row.hasTargets};
        };
        QCOMPARE(traits(positioning()), (std::array{true, true, true}));
        QCOMPARE(traits(circles()), (std::array{true, false, false}));
        QCOMPARE(traits(drift()), (std::array{false, true, false}));
    }

    void partOfAMeasurement() {
        const auto targets = [](const Test &test) {
            return partOr(-1, test.measurement, [](auto &m) -> decltype(static_cast<int>(m.targets.size())) {
                return static_cast<int>(m.targets.size());
            });
        };
        QCOMPARE(targets(positioning()), 3);
        QCOMPARE(targets(circles()), -1);
        QCOMPARE(targets(drift()), -1);
    }

    /// With those that are missing.
    void readings() {
        QCOMPARE(readingsOf(positioning()), std::size_t(6));
        QCOMPARE(readingsOf(circles()), std::size_t(5));
        QCOMPARE(readingsOf(drift()), std::size_t(2));
    }

    void ofOneKind() {
        const auto always = [](const auto & /*a*/, const auto & /*b*/) { return true; };
        const std::array tests{positioning(), circles(), drift()};
        for (std::size_t i = 0; i < tests.size(); ++i) {
            for (std::size_t j = 0; j < tests.size(); ++j)
                QCOMPARE(areOfOneKind(tests[i], tests[j], always), i == j);
        }
        const auto same = [](const auto &a, const auto &b) { return a == b; };
        QVERIFY(areOfOneKind(positioning(), positioning(), same));
        QVERIFY(!areOfOneKind(positioning(), positioning(Motion::rotary), same));
    }
};

QTEST_APPLESS_MAIN(TestFactsTest)

#include "testfacts.moc"
