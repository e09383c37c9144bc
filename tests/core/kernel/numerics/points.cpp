// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/points.h"

#include <QTest>

#include <cmath>

using namespace palmer;

class PointsTest : public QObject {
    Q_OBJECT

private slots:
    void axesAreExact_data();
    void axesAreExact();
    void directionsAreThoseOfTheAngle();
    void manyTurnsChangeNothing();
    void polarPointsLieAtTheirRadii();
    void appendKeepsTheOrder();
};

void PointsTest::axesAreExact_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("first axis") << 0.0 << 1.0 << 0.0;
    QTest::newRow("second axis") << 90.0 << 0.0 << 1.0;
    QTest::newRow("first axis backwards") << 180.0 << -1.0 << 0.0;
    QTest::newRow("second axis backwards") << 270.0 << 0.0 << -1.0;
    QTest::newRow("a quarter clockwise") << -90.0 << 0.0 << -1.0;
    QTest::newRow("half a turn clockwise") << -180.0 << -1.0 << 0.0;
    QTest::newRow("three quarters clockwise") << -270.0 << 0.0 << 1.0;
    QTest::newRow("two turns and a quarter") << 810.0 << 0.0 << 1.0;
    QTest::newRow("a thousand turns backwards") << -360000.0 << 1.0 << 0.0;
}

void PointsTest::axesAreExact() {
    QFETCH(double, degrees);
    QFETCH(double, x);
    QFETCH(double, y);
    const Point u = direction(degrees);
    QVERIFY(u.x == x); // exactly: 0 is 0, not 6e-17
    QVERIFY(u.y == y);
}

void PointsTest::directionsAreThoseOfTheAngle() {
    for (int i = -800; i <= 800; ++i) {
        const double degrees = i * 0.9 + 0.05;
        const double radians = degrees * (std::acos(-1.0) / 180);
        const Point u = direction(degrees);
        // The reference itself is rounded at 13 rad: 2 ulp of it.
        QVERIFY(std::abs(u.x - std::cos(radians)) <= 4e-15);
        QVERIFY(std::abs(u.y - std::sin(radians)) <= 4e-15);
        QVERIFY(std::abs(u.x * u.x + u.y * u.y - 1) <= 4e-16);
    }
}

void PointsTest::manyTurnsChangeNothing() {
    for (int i = 0; i < 360; ++i) {
        const double degrees = i + 0.125; // exact in binary, so that whole turns are exact too
        QCOMPARE(direction(degrees + 360.0 * 1000), direction(degrees));
        QCOMPARE(direction(degrees - 360.0 * 1000), direction(degrees));
    }
}

void PointsTest::polarPointsLieAtTheirRadii() {
    const std::vector<double> angles{0, 30, 90, 200.5, -45};
    const std::vector<double> radii{150, 150.001, 0, 149.5, 1e-3};
    const Points points = polarPoints(angles, radii);
    QCOMPARE(points.size(), angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i)
        QVERIFY(std::abs(std::hypot(points.x[i], points.y[i]) - radii[i]) <= 4e-16 * radii[i]);
    QVERIFY(points.x[1] > 0 && points.y[1] > 0);
    QVERIFY(points.x[3] < 0 && points.y[3] < 0);
}

void PointsTest::appendKeepsTheOrder() {
    Points points{{1, 2}, {3, 4}};
    const Points more{{5}, {6}};
    points.append(more.view());
    QCOMPARE(points, (Points{{1, 2, 5}, {3, 4, 6}}));
}

QTEST_GUILESS_MAIN(PointsTest)
#include "points.moc"
