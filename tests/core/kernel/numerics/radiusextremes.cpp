// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/radiusextremes.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace palmer;

class RadiusExtremesTest : public QObject {
    Q_OBJECT

private slots:
    void extremesAreThoseOfAPlainLoop_data();
    void extremesAreThoseOfAPlainLoop();
    void firstOfTiesIsNamed();
    void originServesPrecisionOnly();
    void findsTheFirstPointAtADistance();
    void noPointsGiveZeros();
    void notFiniteIsSaid_data();
    void notFiniteIsSaid();
};

void RadiusExtremesTest::extremesAreThoseOfAPlainLoop_data() {
    QTest::addColumn<int>("n");
    for (const int n : {1, 2, 3, 4, 5, 7, 15, 16, 17, 127, 1023, 1024, 1025, 2051, 100003})
        QTest::addRow("%d points", n) << n;
}

void RadiusExtremesTest::extremesAreThoseOfAPlainLoop() {
    QFETCH(int, n);
    std::mt19937_64 random(static_cast<unsigned>(n));
    std::uniform_real_distribution<double> coordinate(-200, 200);
    Points points;
    for (int i = 0; i < n; ++i) {
        points.x.push_back(coordinate(random));
        points.y.push_back(coordinate(random));
    }
    const Point centre{1.5, -2.25};
    double inner = std::numeric_limits<double>::infinity();
    double outer = 0;
    std::size_t nearest = 0;
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double dx = points.x[i] - centre.x;
        const double dy = points.y[i] - centre.y;
        const double r = std::sqrt(dx * dx + dy * dy);
        if (r < inner) {
            inner = r;
            nearest = i;
        }
        if (r > outer) {
            outer = r;
            farthest = i;
        }
    }
    const RadiusExtremes extremes = radiusExtremes(points.view(), centre);
    QVERIFY(extremes.finite);
    QVERIFY(extremes.inner == inner); // the same bits: the same operations in another order
    QVERIFY(extremes.outer == outer);
    QCOMPARE(extremes.nearest, nearest);
    QCOMPARE(extremes.farthest, farthest);
}

void RadiusExtremesTest::firstOfTiesIsNamed() {
    Points points;
    for (int i = 0; i < 5000; ++i) {
        points.x.push_back(i % 10 == 7 ? 2 : (i % 10 == 3 ? -1 : 1.5));
        points.y.push_back(0);
    }
    const RadiusExtremes extremes = radiusExtremes(points.view(), {});
    QCOMPARE(extremes.farthest, std::size_t{7});
    QCOMPARE(extremes.nearest, std::size_t{3});
}

void RadiusExtremesTest::originServesPrecisionOnly() {
    const Points points{{1001, 1000, 999, 1000}, {-500, -499, -500, -501.5}};
    const RadiusExtremes direct = radiusExtremes(points.view(), {1000, -500});
    const RadiusExtremes split = radiusExtremes(points.view(), {0, 0}, {1000, -500});
    QCOMPARE(direct.inner, 1.0);
    QCOMPARE(direct.outer, 1.5);
    QCOMPARE(split.inner, 1.0);
    QCOMPARE(split.outer, 1.5);
    // A movement of the centre far below the step of the coordinates (1e-13 at 1000) still shows.
    QVERIFY(radiusExtremes(points.view(), {0, 1e-15}, {1000, -500}).outer > 1.5);
}

void RadiusExtremesTest::findsTheFirstPointAtADistance() {
    std::vector<double> x(100, 3);
    std::vector<double> y(100, 4);
    x[41] = 6;
    y[41] = 8;
    x[77] = 6;
    y[77] = 8;
    QCOMPARE(findSquaredDistance(x.data(), y.data(), 100, {}, {}, 100), std::size_t{41});
    QCOMPARE(findSquaredDistance(x.data(), y.data(), 100, {}, {}, 25), std::size_t{0});
    QCOMPARE(findSquaredDistance(x.data(), y.data(), 100, {}, {}, 50), std::size_t{100}); // between: none
    QCOMPARE(findSquaredDistance(x.data(), y.data(), 41, {}, {}, 100), std::size_t{41});  // not so far
}

void RadiusExtremesTest::noPointsGiveZeros() {
    const RadiusExtremes extremes = radiusExtremes({}, {1, 2});
    QVERIFY(extremes.finite);
    QCOMPARE(extremes.inner, 0.0);
    QCOMPARE(extremes.outer, 0.0);
}

void RadiusExtremesTest::notFiniteIsSaid_data() {
    QTest::addColumn<int>("at");
    QTest::addColumn<double>("value");
    for (const int at : {0, 1, 3, 1000, 2998, 2999}) {
        QTest::addRow("NaN at %d", at) << at << std::numeric_limits<double>::quiet_NaN();
        QTest::addRow("infinity at %d", at) << at << std::numeric_limits<double>::infinity();
        QTest::addRow("too large to be squared at %d", at) << at << 1e200;
    }
}

void RadiusExtremesTest::notFiniteIsSaid() {
    QFETCH(int, at);
    QFETCH(double, value);
    Points points{std::vector<double>(3000, 1), std::vector<double>(3000, 2)};
    points.y[static_cast<std::size_t>(at)] = value;
    QVERIFY(!radiusExtremes(points.view(), {}).finite);
}

QTEST_GUILESS_MAIN(RadiusExtremesTest)
#include "radiusextremes.moc"
