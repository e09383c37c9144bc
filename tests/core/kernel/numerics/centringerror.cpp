// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/centringerror.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"
#include "kernel/numerics/radiusextremes.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace palmer;
using Status = CentringError::Status;

namespace {

struct Readings {
    std::vector<double> angles;
    std::vector<double> distances;

    [[nodiscard]] CommandedArc arc() const { return {angles, distances}; }
};

/// What a bar reads that turns about e while the point goes to radius(θ)·u(θ).
template <class Radius>
Readings readings(double from, double to, int n, Point e, Radius radius) {
    Readings result;
    for (int i = 0; i < n; ++i) {
        const double angle = from + (to - from) * i / n;
        const Point u = direction(angle);
        const double r = radius(angle);
        result.angles.push_back(angle);
        result.distances.push_back(std::hypot(r * u.x - e.x, r * u.y - e.y));
    }
    return result;
}

} // namespace

class CentringErrorTest : public QObject {
    Q_OBJECT

private slots:
    void perfectCircleStaysPerfect_data();
    void perfectCircleStaysPerfect();
    void readingsTakenAsPolarShowAFalseEllipse();
    void pointsComeBackExactly();
    void eachArcHasItsRadius();
    void eachArcCountsAlike();
    void fitIsAMinimum();
    void badInput();
    void rayBesideThePivotGivesTheFoot();
};

void CentringErrorTest::perfectCircleStaysPerfect_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<Point>("e");
    QTest::newRow("full circle, 0.3 along the first axis") << 0.0 << 360.0 << Point{0.3, 0};
    QTest::newRow("full circle, 0.3 aslant") << 0.0 << 360.0 << Point{-0.18, 0.24};
    QTest::newRow("clockwise from 270 degrees") << 270.0 << -90.0 << Point{0.18, 0.24};
    QTest::newRow("one and a half turns") << -45.0 << 495.0 << Point{0.18, -0.24};
    QTest::newRow("half circle") << 30.0 << 210.0 << Point{0.18, -0.24};
    QTest::newRow("quarter") << 0.0 << 90.0 << Point{0.3, 0.1};
    QTest::newRow("centred") << 0.0 << 360.0 << Point{0, 0};
    QTest::newRow("50 mm off") << 0.0 << 360.0 << Point{30, -40};
}

void CentringErrorTest::perfectCircleStaysPerfect() {
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(Point, e);
    const Readings perfect = readings(from, to, 1800, e, [](double) { return 150.0; });
    const CommandedArc arcs[]{perfect.arc()};
    const CentringError error = centringError(arcs);
    QCOMPARE(error.status, Status::converged);
    // Rounding of r (3e-14 mm), enlarged on the quarter.
    QVERIFY(std::abs(error.e.x - e.x) <= 2e-12);
    QVERIFY(std::abs(error.e.y - e.y) <= 2e-12);
    QVERIFY(std::abs(error.radii.at(0) - 150) <= 2e-12);
    const Points points = rebuildPoints(perfect.arc(), error.e);
    const MinimumZone zone = minimumZone(points.view());
    QCOMPARE(zone.status, MinimumZone::Status::found);
    QVERIFY(zone.certified);
    QVERIFY(zone.width <= 1e-12); // the goal is 1e-6
    QVERIFY(std::abs(zone.outerRadius - 150) <= 2e-12);
}

void CentringErrorTest::readingsTakenAsPolarShowAFalseEllipse() {
    // e²/R peak to valley is what the angles of the wrong point cost: 0.600 µm at R 150, e 0.3.
    const Readings perfect = readings(0, 360, 1800, {0.3, 0}, [](double) { return 150.0; });
    const Points asPolar = polarPoints(perfect.angles, perfect.distances);
    QVERIFY(std::abs(minimumZone(asPolar.view()).width - 0.6e-3) <= 1e-6);
}

void CentringErrorTest::pointsComeBackExactly() {
    // With the true e the rebuilt points are those measured, whatever the form of the path.
    const auto form = [](double angle) {
        return 150 + 0.02 * direction(2 * angle).x - 0.01 * direction(3 * angle + 10).y;
    };
    const Point e{0.25, -0.1};
    const Readings path = readings(-20, 400, 1111, e, form);
    const Points points = rebuildPoints(path.arc(), e);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point u = direction(path.angles[i]);
        const double r = form(path.angles[i]);
        QVERIFY(std::abs(points.x[i] - r * u.x) <= 1e-13);
        QVERIFY(std::abs(points.y[i] - r * u.y) <= 1e-13);
    }
}

void CentringErrorTest::eachArcHasItsRadius() {
    const Point e{0.2, 0.1};
    const Readings ccw = readings(0, 360, 720, e, [](double) { return 150.004; });
    const Readings cw = readings(360, 0, 500, e, [](double) { return 149.997; });
    const CommandedArc arcs[]{ccw.arc(), cw.arc()};
    const CentringError error = centringError(arcs);
    QCOMPARE(error.status, Status::converged);
    QVERIFY(std::abs(error.e.x - e.x) <= 1e-12);
    QVERIFY(std::abs(error.e.y - e.y) <= 1e-12);
    QVERIFY(std::abs(error.radii.at(0) - 150.004) <= 1e-12);
    QVERIFY(std::abs(error.radii.at(1) - 149.997) <= 1e-12);
}

void CentringErrorTest::eachArcCountsAlike() {
    // Two paths shifted against each other by a first harmonic: e lies halfway, whatever the numbers.
    const Readings first = readings(0, 360, 3600, {0.010, 0}, [](double) { return 150.0; });
    const Readings second = readings(0, 360, 90, {0.030, 0}, [](double) { return 150.0; });
    const CommandedArc arcs[]{first.arc(), second.arc()};
    const CentringError error = centringError(arcs);
    QCOMPARE(error.status, Status::converged);
    QVERIFY(std::abs(error.e.x - 0.020) <= 1e-8); // (Δe)²/R of what the model leaves
    QVERIFY(std::abs(error.e.y) <= 1e-12);
    // An arc without points does not count.
    const CommandedArc withEmpty[]{first.arc(), {}, second.arc()};
    const CentringError same = centringError(withEmpty);
    QCOMPARE(same.e, error.e);
    QCOMPARE(same.radii.size(), std::size_t{3});
    QCOMPARE(same.radii[1], 0.0);
}

void CentringErrorTest::fitIsAMinimum() {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> noise(-0.005, 0.005);
    for (int trial = 0; trial < 20; ++trial) {
        const double to = trial % 2 ? 360 : 100;
        const Point e{0.2 * direction(17 * trial).x, 0.2 * direction(17 * trial).y};
        const Readings first = readings(0, to, 300, e, [&](double) { return 150 + noise(random); });
        const Readings second = readings(to, 0, 100, e, [&](double) { return 150.01 + noise(random); });
        const CommandedArc arcs[]{first.arc(), second.arc()};
        const CentringError error = centringError(arcs);
        QCOMPARE(error.status, Status::converged);
        const auto sum = [&](Point at, double r0, double r1) {
            const double radii[]{r0, r1};
            long double total = 0;
            for (std::size_t k = 0; k < 2; ++k) {
                long double part = 0;
                for (std::size_t i = 0; i < arcs[k].angles.size(); ++i) {
                    const Point u = direction(arcs[k].angles[i]);
                    const long double f =
                        arcs[k].distances[i] - std::hypot(radii[k] * static_cast<long double>(u.x) - at.x,
                                                          radii[k] * static_cast<long double>(u.y) - at.y);
                    part += f * f;
                }
                total += part / static_cast<long double>(arcs[k].angles.size());
            }
            return total;
        };
        const long double least = sum(error.e, error.radii[0], error.radii[1]);
        for (const double step : {1e-6, 1e-4}) {
            for (int k = 0; k < 8; ++k) {
                const Point u = direction(45 * k);
                QVERIFY(sum({error.e.x + step * u.x, error.e.y + step * u.y}, error.radii[0],
                            error.radii[1]) > least);
            }
            QVERIFY(sum(error.e, error.radii[0] + step, error.radii[1]) > least);
            QVERIFY(sum(error.e, error.radii[0], error.radii[1] - step) > least);
        }
    }
}

void CentringErrorTest::badInput() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(centringError({}).status, Status::undetermined);
    const auto status = [](std::vector<double> angles, std::vector<double> distances) {
        const CommandedArc arcs[]{{angles, distances}};
        const CentringError error = centringError(arcs);
        if (error.status != Status::converged && error.e != Point{})
            return Status::notConverged;
        return error.status;
    };
    QCOMPARE(status({}, {}), Status::undetermined);
    QCOMPARE(status({0}, {150}), Status::undetermined);
    QCOMPARE(status({0, 180}, {150, 151}), Status::undetermined);
    QCOMPARE(status({20, 20, 380}, {150, 151, 150}), Status::undetermined);
    QCOMPARE(status({0, 90, 180}, {150, 150, 150}), Status::converged);
    QCOMPARE(status({0, 0.1, 0.2}, {150, 151, 150}), Status::undetermined);
    QCOMPARE(status({0, 90, nan, 180}, {150, 150, 150, 150}), Status::notFinite);
    QCOMPARE(status({0, 90, 100, 180}, {150, 150, nan, 150}), Status::notFinite);
    QCOMPARE(status({0, 90, 180, 270}, {0, 0, 0, 0}), Status::undetermined);
}

void CentringErrorTest::rayBesideThePivotGivesTheFoot() {
    const std::vector<double> angles{0, 90, 180};
    const std::vector<double> distances{1, 1, 5};
    const Points points = rebuildPoints({angles, distances}, {2, 3});
    // 0°: the ray passes 3 off, farther than 1; 90°: 2 off, likewise; 180°: −2 + √(25 − 9).
    QCOMPARE(points.x[0], 2.0);
    QCOMPARE(points.y[1], 3.0);
    QCOMPARE(points.x[2], -2.0);
}

QTEST_GUILESS_MAIN(CentringErrorTest)
#include "centringerror.moc"
