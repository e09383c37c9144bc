// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/minimumzone.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/radiusextremes.h"
#include "referencecircles.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace palmer;
using Status = MinimumZone::Status;

namespace {

using Random = std::mt19937_64;

double uniform(Random &random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Points moved(const Points &points, Point shift, double degrees = 0) {
    const Point u = direction(degrees);
    Points result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.x.push_back(u.x * points.x[i] - u.y * points.y[i] + shift.x);
        result.y.push_back(u.y * points.x[i] + u.x * points.y[i] + shift.y);
    }
    return result;
}

/// Points at random angles of an arc, radii R·(1 ± noise/2).
Points scattered(Random &random, int n, double radius, double noise, double extent) {
    const double start = uniform(random, 0, 360);
    std::vector<double> angles;
    std::vector<double> radii;
    for (int i = 0; i < n; ++i) {
        angles.push_back(start + uniform(random, 0, extent));
        radii.push_back(radius * (1 + noise * uniform(random, -0.5, 0.5)));
    }
    return polarPoints(angles, radii);
}

/// A path as measured: offset, ovality, three lobes and noise, over `extent` degrees.
Points path(Random &random, int n, double extent) {
    const double start = uniform(random, 0, 360);
    const double ovality = uniform(random, 0, 0.01);
    const double lobes = uniform(random, 0, 0.005);
    const double noise = uniform(random, 0, 0.002);
    const double offset = uniform(random, 0, 0.02);
    std::vector<double> angles;
    std::vector<double> radii;
    for (int i = 0; i < n; ++i) {
        const double angle = start + extent * i / (n - 1);
        angles.push_back(angle);
        radii.push_back(150 + offset * direction(angle - 40).x + ovality * direction(2 * angle).x +
                        lobes * direction(3 * angle).y + noise * uniform(random, -1, 1));
    }
    return polarPoints(angles, radii);
}

struct BruteForce {
    long double width = std::numeric_limits<long double>::infinity(); ///< of the thinnest ring
    long double strip = std::numeric_limits<long double>::infinity(); ///< of the thinnest strip
};

/// Every pair of bisectors, every strip through two points, in long double.
BruteForce bruteForce(const Points &p) {
    BruteForce best;
    const std::size_t n = p.size();
    const auto x = [&](std::size_t i) { return static_cast<long double>(p.x[i]); };
    const auto y = [&](std::size_t i) { return static_cast<long double>(p.y[i]); };
    struct Line {
        long double nx, ny, k;
        std::size_t a, b;
    };
    std::vector<Line> bisectors;
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            const long double nx = x(b) - x(a);
            const long double ny = y(b) - y(a);
            const long double length = std::hypot(nx, ny);
            if (length == 0)
                continue;
            bisectors.push_back({nx, ny, (nx * (x(a) + x(b)) + ny * (y(a) + y(b))) / 2, a, b});
            long double least = 0;
            long double greatest = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const long double height = (nx * (y(i) - y(a)) - ny * (x(i) - x(a))) / length;
                least = std::min(least, height);
                greatest = std::max(greatest, height);
            }
            best.strip = std::min(best.strip, greatest - least);
        }
    }
    for (std::size_t k = 0; k < bisectors.size(); ++k) {
        for (std::size_t l = k + 1; l < bisectors.size(); ++l) {
            const Line &f = bisectors[k];
            const Line &g = bisectors[l];
            const long double determinant = f.nx * g.ny - f.ny * g.nx;
            if (f.a == g.a || f.a == g.b || f.b == g.a || f.b == g.b || determinant == 0)
                continue;
            const long double cx = (f.k * g.ny - g.k * f.ny) / determinant;
            const long double cy = (f.nx * g.k - g.nx * f.k) / determinant;
            long double least = std::numeric_limits<long double>::infinity();
            long double greatest = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const long double r = std::hypot(x(i) - cx, y(i) - cy);
                least = std::min(least, r);
                greatest = std::max(greatest, r);
            }
            if (greatest < 1e8L) // beyond it the width is rounding
                best.width = std::min(best.width, greatest - least);
        }
    }
    return best;
}

/// What a result says of itself is true of the points; to rounding of coordinates of that size.
void verify(const Points &points, const MinimumZone &zone) {
    QCOMPARE(zone.status, Status::found);
    QVERIFY(zone.certified);
    QVERIFY(zone.width >= 0);
    QVERIFY(zone.width == zone.outerRadius - zone.innerRadius);
    const double size = zone.outerRadius + std::abs(zone.centre.x) + std::abs(zone.centre.y);
    const double rounding = 2e-15 * size;
    const RadiusExtremes extremes = radiusExtremes(points.view(), zone.centre);
    QVERIFY(std::abs(extremes.outer - zone.outerRadius) <= rounding);
    QVERIFY(std::abs(extremes.inner - zone.innerRadius) <= rounding);
    for (const std::size_t i : zone.outer)
        QVERIFY(std::abs(std::hypot(points.x.at(i) - zone.centre.x, points.y.at(i) - zone.centre.y) -
                         zone.outerRadius) <= rounding);
    for (const std::size_t i : zone.inner)
        QVERIFY(std::abs(std::hypot(points.x.at(i) - zone.centre.x, points.y.at(i) - zone.centre.y) -
                         zone.innerRadius) <= rounding);
}

/// Outer, inner, outer, inner in the order of the angle about the centre.
bool alternate(const Points &points, const MinimumZone &zone) {
    std::vector<std::pair<double, bool>> contacts;
    for (const std::size_t i : zone.outer)
        contacts.emplace_back(std::atan2(points.y[i] - zone.centre.y, points.x[i] - zone.centre.x), true);
    for (const std::size_t i : zone.inner)
        contacts.emplace_back(std::atan2(points.y[i] - zone.centre.y, points.x[i] - zone.centre.x), false);
    std::sort(contacts.begin(), contacts.end());
    return contacts[0].second != contacts[1].second && contacts[1].second != contacts[2].second &&
           contacts[2].second != contacts[3].second;
}

} // namespace

class MinimumZoneTest : public QObject {
    Q_OBJECT

private slots:
    void referenceSets_data();
    void referenceSets();
    void referenceSetsFarOff_data() { referenceSets_data(); }
    void referenceSetsFarOff();
    void ballbarPair();
    void smallSetsAgreeWithBruteForce_data();
    void smallSetsAgreeWithBruteForce();
    void fourContactsMayNotSufficeForTheProof();
    void ringIsNeverWiderThanThatOfLeastSquares_data();
    void ringIsNeverWiderThanThatOfLeastSquares();
    void unionIsNeverThinnerThanItsPaths();
    void movesAndTurnsWithThePoints();
    void orderAndRepetitionOfPointsDoNotCount();
    void quantisedData_data();
    void quantisedData();
    void perfectCircle_data();
    void perfectCircle();
    void millionPoints_data();
    void millionPoints();
    void badInput_data();
    void badInput();
    void degenerateAmongMany();
    void notFiniteAmongMany_data();
    void notFiniteAmongMany();
    void exhaustedSearchIsNotCertified();
};

void MinimumZoneTest::referenceSets_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("exists");
    QTest::addColumn<Point>("centre");
    QTest::addColumn<double>("outer");
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("width");
    for (const reference::Expected &set : reference::expected()) {
        QTest::newRow(qPrintable(set.name))
            << set.name << set.hasZone() << Point{set.at("mzc_cx"), set.at("mzc_cy")} << set.at("mzc_Ro")
            << set.at("mzc_Ri") << set.at("mzc_width");
    }
}

void MinimumZoneTest::referenceSets() {
    QFETCH(QString, file);
    QFETCH(bool, exists);
    QFETCH(Point, centre);
    QFETCH(double, outer);
    QFETCH(double, inner);
    QFETCH(double, width);
    const Points points = reference::points(file);
    const MinimumZone zone = minimumZone(points.view());
    if (!exists) {
        QCOMPARE(zone.status, Status::tooFewPoints);
        return;
    }
    verify(points, zone);
    QVERIFY(alternate(points, zone));
    QVERIFY(std::abs(zone.width - width) <= 1e-12);
    // Centre and radii follow the rounding of coordinates up to 1000 mm.
    QVERIFY(std::abs(zone.outerRadius - outer) <= 1e-12);
    QVERIFY(std::abs(zone.innerRadius - inner) <= 1e-12);
    QVERIFY(std::abs(zone.centre.x - centre.x) <= 1e-12);
    QVERIFY(std::abs(zone.centre.y - centre.y) <= 1e-12);
}

void MinimumZoneTest::referenceSetsFarOff() {
    QFETCH(QString, file);
    QFETCH(bool, exists);
    QFETCH(double, width);
    if (!exists)
        return;
    for (const Point shift : {Point{1000, 0}, Point{-1000, 1000}}) {
        const Points points = moved(reference::points(file), shift);
        const MinimumZone zone = minimumZone(points.view());
        verify(points, zone);
        // The shifted coordinates are rounded at 1000 … 2000 mm, by up to 1.2e-13 each.
        QVERIFY(std::abs(zone.width - width) <= 1e-12);
    }
}

void MinimumZoneTest::ballbarPair() {
    // Expected: ballbar_pair_expected.txt, about the centre of the instrument, in mm.
    const reference::Path ccw = reference::ballbarPath(QStringLiteral("ccw"));
    const reference::Path cw = reference::ballbarPath(QStringLiteral("cw"));
    Points points = polarPoints(ccw.angles, ccw.radii);
    const MinimumZone first = minimumZone(points.view());
    verify(points, first);
    QVERIFY(std::abs(first.width - 20.42116918984e-3) <= 1e-12);
    QVERIFY(std::abs(first.centre.x + 11.14276205655e-3) <= 1e-12);
    QVERIFY(std::abs(first.centre.y - 10.51117321777e-3) <= 1e-12);
    const Points other = polarPoints(cw.angles, cw.radii);
    const MinimumZone second = minimumZone(other.view());
    verify(other, second);
    QVERIFY(std::abs(second.width - 24.64810384128e-3) <= 1e-12);
    QVERIFY(std::abs(second.centre.x + 15.303861312e-3) <= 1e-12);
    QVERIFY(std::abs(second.centre.y - 10.39855071438e-3) <= 1e-12);
    points.append(other.view());
    const MinimumZone both = minimumZone(points.view());
    verify(points, both);
    QVERIFY(std::abs(both.width - 25.06388642145e-3) <= 1e-12);
    QVERIFY(std::abs(both.centre.x + 14.87726780082e-3) <= 1e-12);
    QVERIFY(std::abs(both.centre.y - 10.10163452273e-3) <= 1e-12);
}

void MinimumZoneTest::smallSetsAgreeWithBruteForce_data() {
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("step");
    QTest::newRow("full circles, a micrometre in 150 mm") << 1e-5 << 360.0 << 0.0;
    QTest::newRow("half circles") << 1e-4 << 180.0 << 0.0;
    QTest::newRow("quarters") << 1e-4 << 90.0 << 0.0;
    QTest::newRow("arcs of 80 degrees") << 1e-4 << 80.0 << 0.0;
    QTest::newRow("short arcs") << 1e-4 << 20.0 << 0.0;
    QTest::newRow("full circles, a hundredth") << 1e-2 << 360.0 << 0.0;
    QTest::newRow("full circles, half the radius") << 0.5 << 360.0 << 0.0;
    QTest::newRow("quarters, a fifth of the radius") << 0.2 << 90.0 << 0.0;
    QTest::newRow("short arcs, deviations as large as the sagitta") << 0.02 << 20.0 << 0.0;
    QTest::newRow("clouds") << 2.0 << 360.0 << 0.0;
    QTest::newRow("full circles on a coarse grid") << 0.05 << 360.0 << 5.0;
    QTest::newRow("quarters on a coarse grid") << 0.02 << 90.0 << 5.0;
    QTest::newRow("short arcs on a coarse grid") << 0.02 << 20.0 << 2.5;
}

void MinimumZoneTest::smallSetsAgreeWithBruteForce() {
    QFETCH(double, noise);
    QFETCH(double, extent);
    QFETCH(double, step);
    Random random(5);
    int rings = 0;
    for (int trial = 0; trial < 150; ++trial) {
        Points points = scattered(random, 4 + trial % 9, 150, noise, extent);
        if (step > 0) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                points.x[i] = step * std::round(points.x[i] / step);
                points.y[i] = step * std::round(points.y[i] / step);
            }
        }
        if (trial % 4 == 0) // duplicates
            points.append(Points{{points.x[0], points.x[2]}, {points.y[0], points.y[2]}}.view());
        if (trial % 3 == 0)
            points = moved(points, {1000, -700});
        const BruteForce best = bruteForce(points);
        const MinimumZone zone = minimumZone(points.view());
        if (zone.status == Status::found) {
            ++rings;
            verify(points, zone);
            // Rounding of the coordinates and, where the ring is nearly a strip, of its large radius.
            const double rounding = 4e-13 + 4e-15 * zone.outerRadius;
            QVERIFY(std::abs(zone.width - static_cast<double>(best.width)) <= rounding);
            QVERIFY(zone.width <= best.strip);
        } else if (zone.status == Status::straight) {
            QVERIFY(best.strip <= best.width + 1e-12);
        } else {
            QCOMPARE(zone.status, Status::tooFewPoints);
            QVERIFY(step > 0);
        }
    }
    QVERIFY(rings >= 40); // the rest is straight
}

void MinimumZoneTest::fourContactsMayNotSufficeForTheProof() {
    // Short arcs with large deviations: several local minima, the search over the whole plane has the word.
    Random random(11);
    int looks = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Points points = scattered(random, 16, 150, 0.3, 90);
        const MinimumZone zone = minimumZone(points.view());
        const BruteForce best = bruteForce(points);
        if (zone.status == Status::straight) {
            QVERIFY(best.strip <= best.width + 1e-12);
            continue;
        }
        verify(points, zone);
        QVERIFY(std::abs(zone.width - static_cast<double>(best.width)) <= 4e-13 + 4e-15 * zone.outerRadius);
        looks = std::max(looks, zone.scans);
    }
    QVERIFY(looks > 1); // a set of this size is looked at once, unless the search had to be continued
}

void MinimumZoneTest::ringIsNeverWiderThanThatOfLeastSquares_data() {
    QTest::addColumn<double>("extent");
    QTest::newRow("full circle") << 360.0;
    QTest::newRow("one and a half turns") << 540.0;
    QTest::newRow("half circle") << 180.0;
    QTest::newRow("quarter") << 90.0;
    QTest::newRow("80 degrees") << 80.0;
}

void MinimumZoneTest::ringIsNeverWiderThanThatOfLeastSquares() {
    QFETCH(double, extent);
    Random random(6);
    for (int trial = 0; trial < 60; ++trial) {
        const Points points = path(random, 50 + 40 * trial, extent);
        const MinimumZone zone = minimumZone(points.view());
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        verify(points, zone);
        QVERIFY(alternate(points, zone));
        QVERIFY(zone.width <= circle.range() + 1e-13); // rounding of 150 mm
        // Fmax − Fmin ≥ G: about any centre the radii range over at least the width.
        for (int k = 0; k < 8; ++k) {
            const Point u = direction(45 * k);
            const RadiusExtremes about =
                radiusExtremes(points.view(), {zone.centre.x + 1e-3 * u.x, zone.centre.y + 1e-3 * u.y});
            QVERIFY(about.outer - about.inner >= zone.width);
        }
    }
}

void MinimumZoneTest::unionIsNeverThinnerThanItsPaths() {
    Random random(7);
    for (int trial = 0; trial < 60; ++trial) {
        const double extent = trial % 2 ? 360 : 120;
        const Points first = path(random, 300 + trial, extent);
        const Points second = path(random, 700 - trial, extent);
        Points both = first;
        both.append(second.view());
        const MinimumZone zone = minimumZone(both.view());
        verify(both, zone);
        QVERIFY(zone.width >= minimumZone(first.view()).width - 1e-13);
        QVERIFY(zone.width >= minimumZone(second.view()).width - 1e-13);
    }
}

void MinimumZoneTest::movesAndTurnsWithThePoints() {
    Random random(8);
    for (int trial = 0; trial < 60; ++trial) {
        const Points points = path(random, 200 + 20 * trial, trial % 2 ? 360 : 90);
        const double width = minimumZone(points.view()).width;
        const Points other = moved(points, {uniform(random, -1000, 1000), uniform(random, -1000, 1000)},
                                   uniform(random, 0, 360));
        const MinimumZone zone = minimumZone(other.view());
        verify(other, zone);
        QVERIFY(std::abs(zone.width - width) <= 1e-12); // coordinates of 1000 mm are rounded by 1e-13
    }
}

void MinimumZoneTest::orderAndRepetitionOfPointsDoNotCount() {
    Random random(9);
    for (int trial = 0; trial < 30; ++trial) {
        Points points = path(random, 100 + 50 * trial, 360);
        const double width = minimumZone(points.view()).width;
        std::vector<std::size_t> order(points.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::shuffle(order.begin(), order.end(), random);
        Points shuffled;
        for (const std::size_t i : order) {
            for (int times = 0; times < 1 + trial % 3; ++times) {
                shuffled.x.push_back(points.x[i]);
                shuffled.y.push_back(points.y[i]);
            }
        }
        const MinimumZone zone = minimumZone(shuffled.view());
        verify(shuffled, zone);
        QVERIFY(std::abs(zone.width - width) <= 2e-13); // another origin, another rounding
    }
}

void MinimumZoneTest::quantisedData_data() {
    QTest::addColumn<int>("n");
    QTest::addColumn<double>("extent");
    for (const int n : {36, 180, 256, 257, 1800, 20000}) {
        QTest::addRow("%d points of a full circle", n) << n << 360.0;
        QTest::addRow("%d points of 80 degrees", n) << n << 80.0;
    }
}

void MinimumZoneTest::quantisedData() {
    // Radial deviations to 0.1 µm: many points share the extremes. Adding the harmonics of a centre to
    // quantised data is the same as another centre: the width is known only to be between these bounds.
    QFETCH(int, n);
    QFETCH(double, extent);
    Random random(10);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> angles;
        std::vector<double> radii;
        for (int i = 0; i < n; ++i) {
            angles.push_back(extent * i / n);
            const double deviation = 4e-3 * direction(2 * angles.back()).x + uniform(random, -3e-4, 3e-4);
            radii.push_back(150 + 1e-4 * std::round(1e4 * deviation));
        }
        const Points points = polarPoints(angles, radii);
        const MinimumZone zone = minimumZone(points.view());
        verify(points, zone);
        QVERIFY(alternate(points, zone)); // whichever of the ties are named
        const auto [least, greatest] = std::minmax_element(radii.begin(), radii.end());
        QVERIFY(zone.width <= *greatest - *least + 1e-13);
        QVERIFY(zone.width <= leastSquaresCircle(points.view()).range() + 1e-13);
        QVERIFY(zone.scans <= 6);
    }
}

void MinimumZoneTest::perfectCircle_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<Point>("centre");
    for (const double extent : {360.0, 90.0, 80.0, 10.0}) {
        QTest::addRow("%g degrees about the origin", extent) << extent << Point{0, 0};
        QTest::addRow("%g degrees far off", extent) << extent << Point{1000, -1000};
    }
}

void MinimumZoneTest::perfectCircle() {
    QFETCH(double, extent);
    QFETCH(Point, centre);
    for (const int n : {4, 5, 8, 100, 255, 256, 257, 1000, 30000}) {
        std::vector<double> angles;
        for (int i = 0; i < n; ++i)
            angles.push_back(extent * i / n);
        const Points points = moved(polarPoints(angles, std::vector<double>(angles.size(), 150)), centre);
        const MinimumZone zone = minimumZone(points.view());
        verify(points, zone);
        // All that is left is the rounding of the coordinates, 3e-14 or 2e-13 at 1000 mm, and the tolerance
        // of 1.5e-13 to which points are inside.
        QVERIFY(zone.width <= (centre.x == 0 ? 3e-13 : 6e-13));
    }
}

void MinimumZoneTest::millionPoints_data() {
    QTest::addColumn<Point>("centre");
    QTest::addColumn<bool>("inOrder");
    QTest::newRow("about the origin") << Point{0, 0} << true;
    QTest::newRow("1000 mm off") << Point{1000, -1000} << true;
    QTest::newRow("about the origin, shuffled") << Point{0, 0} << false;
}

void MinimumZoneTest::millionPoints() {
    // Four contacts at Pythagorean directions, all other points strictly inside: the width is 12 µm by
    // construction. The contacts stand where a sample of the data does not look.
    QFETCH(Point, centre);
    QFETCH(bool, inOrder);
    constexpr int n = 1000000;
    constexpr double outer = 150.006;
    constexpr double inner = 149.994;
    Random random(12);
    Points points;
    for (int i = 0; i < n; ++i) {
        const Point u = direction(inOrder ? 360.0 * i / n : uniform(random, 0, 360));
        const double r = uniform(random, inner + 1e-6, outer - 1e-6);
        points.x.push_back(centre.x + r * u.x);
        points.y.push_back(centre.y + r * u.y);
    }
    const std::array<Point, 4> directions{{{0.96, 0.28}, {0.28, 0.96}, {-0.8, -0.6}, {0.6, -0.8}}};
    const std::array<std::size_t, 4> places{44445, 44446, 617283, 999998};
    for (std::size_t k = 0; k < 4; ++k) {
        const double r = k % 2 == 0 ? outer : inner;
        points.x[places[k]] = centre.x + r * directions[k].x;
        points.y[places[k]] = centre.y + r * directions[k].y;
    }
    const MinimumZone zone = minimumZone(points.view());
    verify(points, zone);
    QVERIFY(std::abs(zone.width - 0.012) <= 1e-12);
    QVERIFY(std::abs(zone.centre.x - centre.x) <= 1e-12);
    QVERIFY(std::abs(zone.centre.y - centre.y) <= 1e-12);
    QCOMPARE(std::min(zone.outer[0], zone.outer[1]), places[0]);
    QCOMPARE(std::max(zone.outer[0], zone.outer[1]), places[2]);
    QCOMPARE(std::min(zone.inner[0], zone.inner[1]), places[1]);
    QCOMPARE(std::max(zone.inner[0], zone.inner[1]), places[3]);
}

void MinimumZoneTest::badInput_data() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<std::vector<double>>("x");
    QTest::addColumn<std::vector<double>>("y");
    QTest::addColumn<int>("status");
    using Values = std::vector<double>;
    const auto row = [](const char *name, const Values &x, const Values &y, Status status) {
        QTest::newRow(name) << x << y << static_cast<int>(status);
    };
    row("four corners of a square", {0, 1, 1, 0}, {0, 0, 1, 1}, Status::found);
    row("square with a point in the middle of a side", {0, 1, 1, 0, 0.5}, {0, 0, 1, 1, 0}, Status::found);
    row("no point", {}, {}, Status::tooFewPoints);
    row("one point", {1}, {1}, Status::tooFewPoints);
    row("three points", {0, 1, 0}, {0, 0, 1}, Status::tooFewPoints);
    row("three points, each twice", {0, 1, 0, 0, 1, 0}, {0, 0, 1, 0, 0, 1}, Status::tooFewPoints);
    row("one point, many times", {7, 7, 7, 7, 7}, {1, 1, 1, 1, 1}, Status::tooFewPoints);
    row("points on the first axis", {1, 2, 3, 5}, {0, 0, 0, 0}, Status::straight);
    row("points on the second axis", {4, 4, 4, 4, 4}, {1, 2, 3, 5, 8}, Status::straight);
    row("a slanting line", {0.1, 0.2, 0.3, 0.4, 0.7}, {0.3, 0.6, 0.9, 1.2, 2.1}, Status::straight);
    row("a slanting line far off", {1000.1, 1000.2, 1000.3, 1000.4}, {0.3, 0.6, 0.9, 1.2}, Status::straight);
    row("two close lines", {0, 1, 2, 3, 4, 5}, {0, 0.1, 0, 0.1, 0, 0.1}, Status::straight);
    row("NaN in x", {0, 1, nan, 2, 3}, {0, 0, 1, 5, 4}, Status::notFinite);
    row("NaN in y", {0, 1, 0, 2, 3}, {0, nan, 1, 5, 4}, Status::notFinite);
    row("only NaN", {nan, nan, nan, nan, nan}, {nan, nan, nan, nan, nan}, Status::notFinite);
    row("infinite", {0, 1, 0, 2, 3}, {0, 0, infinity, 5, 4}, Status::notFinite);
    row("too large", {0, 1, 0, 2, 3}, {0, 0, 1e300, 5, 4}, Status::notFinite);
}

void MinimumZoneTest::badInput() {
    QFETCH(std::vector<double>, x);
    QFETCH(std::vector<double>, y);
    QFETCH(int, status);
    MinimumZone zone = minimumZone({x, y});
    QCOMPARE(static_cast<int>(zone.status), status);
    if (zone.status == Status::found) {
        verify({x, y}, zone);
    } else {
        zone.scans = 0;
        MinimumZone zeros;
        zeros.status = zone.status;
        QCOMPARE(zone, zeros);
    }
}

void MinimumZoneTest::degenerateAmongMany() {
    // 100 000 times three points, then a fourth hidden where a sample of the data does not look.
    Points points;
    for (int i = 0; i < 100000; ++i) {
        points.x.push_back(i % 3 == 0 ? 1 : 0);
        points.y.push_back(i % 3 == 1 ? 1 : 0);
    }
    QCOMPARE(minimumZone(points.view()).status, Status::tooFewPoints);
    points.x[77777] = 1;
    points.y[77777] = 1.25;
    const MinimumZone zone = minimumZone(points.view());
    verify(points, zone);
    const Points four{{1, 0, 0, 1}, {0, 1, 0, 1.25}};
    QVERIFY(std::abs(zone.width - minimumZone(four.view()).width) <= 1e-15);

    std::fill(points.x.begin(), points.x.end(), 3);
    std::fill(points.y.begin(), points.y.end(), 4);
    QCOMPARE(minimumZone(points.view()).status, Status::tooFewPoints);
    for (std::size_t i = 0; i < points.size(); ++i)
        points.x[i] = 1e-3 * static_cast<double>(i);
    QCOMPARE(minimumZone(points.view()).status, Status::straight);
    for (std::size_t i = 0; i < points.size(); ++i) { // aslant every point is off the line by its rounding
        points.x[i] = 0.1 * static_cast<double>(i);
        points.y[i] = 0.3 * static_cast<double>(i) + 7;
    }
    const MinimumZone slanting = minimumZone(points.view());
    QCOMPARE(slanting.status, Status::straight);
    QVERIFY(slanting.scans < 12); // the rounding is not followed point by point
}

void MinimumZoneTest::notFiniteAmongMany_data() {
    QTest::addColumn<int>("at");
    QTest::addColumn<double>("value");
    for (const int at : {0, 1, 77777, 99998, 99999}) {
        QTest::addRow("NaN at %d", at) << at << std::numeric_limits<double>::quiet_NaN();
        QTest::addRow("infinity at %d", at) << at << -std::numeric_limits<double>::infinity();
        QTest::addRow("too large at %d", at) << at << 1e200;
    }
}

void MinimumZoneTest::notFiniteAmongMany() {
    QFETCH(int, at);
    QFETCH(double, value);
    Random random(13);
    Points points = path(random, 100000, 360);
    points.x[static_cast<std::size_t>(at)] = value;
    QCOMPARE(minimumZone(points.view()).status, Status::notFinite);
    for (std::size_t i = 0; i < points.size(); ++i) // the same among collinear points, and among equal ones
        points.x[i] = points.y[i] = static_cast<double>(i);
    points.x[static_cast<std::size_t>(at)] = value;
    QCOMPARE(minimumZone(points.view()).status, Status::notFinite);
}

void MinimumZoneTest::exhaustedSearchIsNotCertified() {
    // With no exchange and a core too small for the proof there is a ring about all points, and no claim.
    Random random(14);
    const Points points = path(random, 200, 360);
    const double width = minimumZone(points.view()).width;
    const MinimumZone zone = minimumZone(points.view(), {.maxExchanges = 0, .maxCorePoints = 6});
    QCOMPARE(zone.status, Status::found);
    QVERIFY(!zone.certified);
    QVERIFY(zone.width >= width);
    const RadiusExtremes extremes = radiusExtremes(points.view(), zone.centre);
    QVERIFY(std::abs(extremes.outer - extremes.inner - zone.width) <= 1e-12);
    // The search over the whole plane alone finds the same as the exchange.
    const MinimumZone core = minimumZone(points.view(), {.maxExchanges = 0});
    verify(points, core);
    QVERIFY(std::abs(core.width - width) <= 2e-13);
}

QTEST_GUILESS_MAIN(MinimumZoneTest)
#include "minimumzone.moc"
