// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/synthesize.h"

#include "kernel/numerics/points.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace palmer;

/// Made measurements are what was asked for.
class Synthesize : public QObject {
    Q_OBJECT

private slots:
    void noiseIsAsAskedFor_data();
    void noiseIsAsAskedFor();
    void centreIsAPlace();
    void readingsAreRounded();
    void arcsFollowEachOther();
    void positioning();
    void nothingToMake();
};

void Synthesize::noiseIsAsAskedFor_data() {
    QTest::addColumn<double>("correlation");
    QTest::newRow("white") << 0.0;
    QTest::newRow("coloured") << 0.8;
}

void Synthesize::noiseIsAsAskedFor() {
    QFETCH(double, correlation);
    CircularSynthesis asked;
    asked.points = 40'000;
    asked.noise = {2e-3, correlation, 0, 3};
    const CircularMeasurement made = synthesizeCircular(asked);
    for (const Arc &arc : made.arcs) {
        const auto &r = arc.radialDeviations;
        double mean = 0;
        double square = 0;
        double lagged = 0;
        for (std::size_t i = 0; i < r.size(); ++i) {
            mean += r[i] / double(r.size());
            square += r[i] * r[i] / double(r.size());
            lagged += i > 0 ? r[i] * r[i - 1] / double(r.size()) : 0;
        }
        // 40 000 readings, of coloured noise a ninth as many independent ones: five standard deviations.
        QVERIFY(std::abs(mean) < 5 * 2e-3 * std::sqrt(9.0 / 40'000));
        QVERIFY(std::abs(std::sqrt(square) / 2e-3 - 1) < 0.04);
        QVERIFY(std::abs(lagged / square - correlation) < 0.03);
    }
    QVERIFY(made.arcs[0].radialDeviations != made.arcs[1].radialDeviations);
}

void Synthesize::centreIsAPlace() {
    CircularSynthesis asked;
    asked.points = 100;
    asked.radius = 10;
    asked.sources = {{InfluenceId::centre, PlaneAxis::first, 3.0},
                     {InfluenceId::centre, PlaneAxis::second, -1.0}};
    const CircularMeasurement made = synthesizeCircular(asked);
    for (const Arc &arc : made.arcs) {
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            const Point u = direction(arc.angles[i]);
            const double r = 10 + arc.radialDeviations[i];
            QVERIFY(std::abs(std::hypot(r * u.x - 3, r * u.y + 1) - 10) < 1e-12);
        }
        // Unwrapped: no step as large as half a turn.
        for (std::size_t i = 1; i < arc.angles.size(); ++i)
            QVERIFY(std::abs(arc.angles[i] - arc.angles[i - 1]) < 10);
    }
}

void Synthesize::readingsAreRounded() {
    CircularSynthesis asked;
    asked.points = 200;
    asked.sources = {{InfluenceId::squareness, PlaneAxis::none, 1e-4}};
    asked.noise.resolution = 1e-4;
    const auto fine = synthesizeCircular(asked);
    for (const double r : fine.arcs[0].radialDeviations)
        QCOMPARE(r, std::nearbyint(r * 1e4) / 1e4); // the double nearest to the decimal
    asked.noise.resolution = 3e-4;
    const auto coarse = synthesizeCircular(asked);
    for (const double r : coarse.arcs[0].radialDeviations)
        QVERIFY(std::abs(r / 3e-4 - std::nearbyint(r / 3e-4)) < 1e-9);
}

void Synthesize::arcsFollowEachOther() {
    CircularSynthesis asked;
    asked.points = 4;
    asked.arc = {10, 50};
    asked.pause = 1;
    asked.sources = {{InfluenceId::radiusDrift, PlaneAxis::none, 9.0}};
    const CircularMeasurement made = synthesizeCircular(asked);
    QCOMPARE(made.arcs[0].angles, (std::vector<double>{15, 25, 35, 45}));
    QCOMPARE(made.arcs[1].angles, (std::vector<double>{45, 35, 25, 15}));
    QCOMPARE(made.arcs[1].sense, Sense::clockwise);
    // 9 mm a turn: 0.25 mm from reading to reading, a turn and one reading between the arcs; 0 in the middle.
    QVERIFY(std::abs(made.arcs[0].radialDeviations[1] - made.arcs[0].radialDeviations[0] - 0.25) < 1e-12);
    QVERIFY(std::abs(made.arcs[1].radialDeviations[0] - made.arcs[0].radialDeviations[3] - 9.25) < 1e-12);
    QVERIFY(std::abs(made.arcs[0].radialDeviations[0] + made.arcs[1].radialDeviations[3]) < 1e-12);
}

void Synthesize::positioning() {
    PositioningSynthesis asked;
    asked.targets = {100, 200, 300};
    asked.runs = 2;
    asked.scale = 1e-5;
    asked.reversal = 2e-3;
    asked.backlash = 1e-3;
    asked.temperature = 25;
    asked.expansion = 10;
    const PositioningMeasurement made = synthesizePositioning(asked);
    QCOMPARE(made.runs.size(), std::size_t(4));
    // (10 + 50) µm/m over 200 mm, less half of 1 + 2 µm
    QVERIFY(std::abs(*made.runs[0].deviations[2] - (12e-3 - 1.5e-3)) < 1e-15);
    QVERIFY(std::abs(*made.runs[1].deviations[2] - (12e-3 + 1.5e-3)) < 1e-15);
    QVERIFY(std::abs(*made.runs[1].deviations[0] - 0.5e-3) < 1e-15);
    QCOMPARE(made.conditions.common.sensors.size(), std::size_t(1));
    QVERIFY(*made.conditions.common.sensors[0].start == 25 && *made.conditions.common.sensors[0].end == 25);
    QVERIFY(*made.conditions.common.expansion.machine == 10);
    // Of the drift alone: 11 equal steps over 12 readings, downwards in the order of time.
    PositioningSynthesis drifting;
    drifting.targets = {0, 1, 2};
    drifting.runs = 2;
    drifting.drift = 11e-3;
    const PositioningMeasurement drifted = synthesizePositioning(drifting);
    QVERIFY(std::abs(*drifted.runs[1].deviations[2] - 3e-3) < 1e-15);
    QVERIFY(std::abs(*drifted.runs[3].deviations[0] - 11e-3) < 1e-15);
    PositioningSynthesis waves;
    waves.targets = {5, 7.5, 15};
    waves.runs = 1;
    waves.cyclic = 4e-3;
    const PositioningMeasurement wavy = synthesizePositioning(waves);
    QVERIFY(std::abs(*wavy.runs[0].deviations[1] - 4e-3) < 1e-15); // a quarter of 10 mm on
    QVERIFY(std::abs(*wavy.runs[0].deviations[2]) < 1e-15);
    waves.phase = std::numbers::pi / 2;
    QVERIFY(std::abs(*synthesizePositioning(waves).runs[0].deviations[0] - 4e-3) < 1e-15);
    PositioningSynthesis one; // a target alone: no travel, no drift
    one.targets = {7};
    one.runs = 1;
    one.backlash = 2e-3;
    one.reversal = 1;
    one.temperature = 20;
    const PositioningMeasurement single = synthesizePositioning(one);
    QCOMPARE(*single.runs[0].deviations[0], -1e-3);
    QVERIFY(single.conditions.common.sensors.empty());
}

void Synthesize::nothingToMake() {
    CircularSynthesis asked;
    asked.points = 0;
    asked.senses.clear();
    QVERIFY(synthesizeCircular(asked).arcs.empty());
    QVERIFY(synthesizePositioning({}).runs.empty());
}

QTEST_GUILESS_MAIN(Synthesize)
#include "synthesize.moc"
