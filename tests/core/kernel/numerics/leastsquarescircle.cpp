// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/leastsquarescircle.h"

#include "referencecircles.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palmer;
using Status = LeastSquaresCircle::Status;

namespace {

Points arc(double radius, Point centre, double from, double to, int n, double noise, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> deviation(-noise / 2, noise / 2);
    std::vector<double> angles;
    std::vector<double> radii;
    for (int i = 0; i < n; ++i) {
        angles.push_back(from + (to - from) * i / (n - 1));
        radii.push_back(radius + (noise > 0 ? deviation(random) : 0));
    }
    Points points = polarPoints(angles, radii);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points.x[i] += centre.x;
        points.y[i] += centre.y;
    }
    return points;
}

/// Σ w_i·(r_i − r̄)² about a centre, in long double: what the fit minimises.
long double variance(const Points &points, const std::vector<std::size_t> &groups, long double cx,
                     long double cy) {
    long double mean = 0;
    long double square = 0;
    std::size_t begin = 0;
    for (const std::size_t size : groups) {
        const long double w = 1.0L / static_cast<long double>(size * groups.size());
        for (std::size_t i = begin; i < begin + size; ++i) {
            const long double r =
                std::hypot(points.x[i] - cx, points.y[i] - cy) - 150; // near R: no cancellation
            mean += w * r;
            square += w * r * r;
        }
        begin += size;
    }
    return square - mean * mean;
}

/// By which part of itself Σ(y − line)² shrinks where x² may be added, x = 0 … n − 1: by the projection on
/// the quadratic polynomial that is orthogonal to lines.
double gainOfParabola(const Points &points) {
    const auto n = static_cast<double>(points.size());
    double mean = 0, slope = 0, squares = 0, sum = 0, norm = 0, linear = 0;
    for (const double y : points.y)
        mean += y / n;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double t = points.x[i] - (n - 1) / 2;
        const double p = t * t - (n * n - 1) / 12;
        const double y = points.y[i] - mean;
        slope += t * y;
        linear += t * t;
        squares += y * y;
        sum += p * y;
        norm += p * p;
    }
    return sum * sum / norm / (squares - slope * slope / linear);
}

} // namespace

class LeastSquaresCircleTest : public QObject {
    Q_OBJECT

private slots:
    void referenceSets_data();
    void referenceSets();
    void ballbarPairCountsBothPathsAlike();
    void groupsCountAlikeWhateverTheirNumbers();
    void fitIsAMinimum_data();
    void fitIsAMinimum();
    void endsWhereNewtonInLongDoubleEnds_data();
    void endsWhereNewtonInLongDoubleEnds();
    void momentsFromAnyOrigin();
    void exactArcs_data();
    void exactArcs();
    void movesAndTurnsWithThePoints();
    void millionPointsKeepThePrecision();
    void slantingLinesAreCollinear();
    void noisyLinesEndWithAStatus();
    void shortArcsWithLargeDeviations_data();
    void shortArcsWithLargeDeviations();
    void noisyShortArcsHaveTheBestOfAllCircles_data();
    void noisyShortArcsHaveTheBestOfAllCircles();
    void notConvergedIsNoCircle();
    void badInput_data();
    void badInput();
};

void LeastSquaresCircleTest::referenceSets_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("range");
    for (const reference::Expected &set : reference::expected())
        QTest::newRow(qPrintable(set.name))
            << set.name << set.at("lsc_cx") << set.at("lsc_cy") << set.at("lsc_R") << set.at("lsc_width");
}

void LeastSquaresCircleTest::referenceSets() {
    QFETCH(QString, file);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, radius);
    QFETCH(double, range);
    const Points points = reference::points(file);
    const LeastSquaresCircle circle = leastSquaresCircle(points.view());
    QCOMPARE(circle.status, Status::converged);
    // The goal is 1e-9 mm; what is seen is the rounding of coordinates up to 1000 mm.
    QVERIFY(std::abs(circle.centre.x - x) <= 1e-12);
    QVERIFY(std::abs(circle.centre.y - y) <= 1e-12);
    QVERIFY(std::abs(circle.radius - radius) <= 1e-12);
    QVERIFY(std::abs(circle.range() - range) <= 1e-12);
}

void LeastSquaresCircleTest::ballbarPairCountsBothPathsAlike() {
    // Expected: ballbar_pair_expected.txt, mm.
    const reference::Path ccw = reference::ballbarPath(QStringLiteral("ccw"));
    const reference::Path cw = reference::ballbarPath(QStringLiteral("cw"));
    Points points = polarPoints(ccw.angles, ccw.radii);
    const LeastSquaresCircle first = leastSquaresCircle(points.view());
    const Points second = polarPoints(cw.angles, cw.radii);
    const LeastSquaresCircle other = leastSquaresCircle(second.view());
    const std::size_t groups[]{points.size(), second.size()};
    points.append(second.view());
    const LeastSquaresCircle both = leastSquaresCircle(points.view(), {.groups = groups});
    // The expected values carry ten decimals of a micrometre or more: 1e-13 mm, and rounding at 150 mm.
    QVERIFY(std::abs(first.centre.x + 13.2499179776e-3) <= 1e-12);
    QVERIFY(std::abs(first.centre.y - 9.99888675618e-3) <= 1e-12);
    QVERIFY(std::abs(first.radius - 150 - 0.6487183141601e-3) <= 1e-12);
    QVERIFY(std::abs(first.range() - 22.2292667779e-3) <= 1e-12);
    QVERIFY(std::abs(other.centre.x + 13.25095385e-3) <= 1e-12);
    QVERIFY(std::abs(other.centre.y - 10.00132448043e-3) <= 1e-12);
    QVERIFY(std::abs(other.radius - 150 - 1.60386243022e-3) <= 1e-12);
    QVERIFY(std::abs(other.range() - 27.03625704674e-3) <= 1e-12);
    QVERIFY(std::abs(both.centre.x + 13.25043587718e-3) <= 1e-12);
    QVERIFY(std::abs(both.centre.y - 10.00010559717e-3) <= 1e-12);
    QVERIFY(std::abs(both.radius - 150 - 1.126290372183e-3) <= 1e-12); // D
    QVERIFY(std::abs(both.range() - 27.03649379717e-3) <= 1e-12);
    // F about the centre of the path itself: distances from it less the nominal radius.
    QVERIFY(std::abs(first.outerRadius - 150 - 12.78373473872e-3) <= 1e-12);
    QVERIFY(std::abs(first.innerRadius - 150 + 9.445532039179e-3) <= 1e-12);
    QVERIFY(std::abs(other.outerRadius - 150 - 15.7125371548e-3) <= 1e-12);
    QVERIFY(std::abs(other.innerRadius - 150 + 11.32371989194e-3) <= 1e-12);
}

void LeastSquaresCircleTest::groupsCountAlikeWhateverTheirNumbers() {
    // A full circle and the same circle with every second point, smaller by 0.2: the pair lies halfway.
    Points points = arc(100, {3, -4}, 0, 359, 360, 0, 1);
    points.append(arc(99.8, {3, -4}, 0, 358, 180, 0, 1).view());
    const std::size_t groups[]{360, 180};
    const LeastSquaresCircle alike = leastSquaresCircle(points.view(), {.groups = groups});
    QCOMPARE(alike.status, Status::converged);
    QVERIFY(std::abs(alike.radius - 99.9) <= 1e-12);
    const LeastSquaresCircle pooled = leastSquaresCircle(points.view());
    QVERIFY(std::abs(pooled.radius - (100 * 360 + 99.8 * 180) / 540) <= 1e-12);
    // Groups without points, before, between and behind, say nothing.
    const std::size_t withEmpty[]{0, 360, 0, 180, 0};
    QCOMPARE(leastSquaresCircle(points.view(), {.groups = withEmpty}), alike);
}

void LeastSquaresCircleTest::fitIsAMinimum_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("noise");
    QTest::newRow("full circle") << 360.0 << 0.02;
    QTest::newRow("half circle") << 180.0 << 0.02;
    QTest::newRow("quarter") << 90.0 << 0.02;
    QTest::newRow("short arc") << 30.0 << 0.02;
    QTest::newRow("full circle, deviations of a tenth of the radius") << 360.0 << 15.0;
    QTest::newRow("quarter, deviations of a twentieth of the radius") << 90.0 << 7.5;
}

void LeastSquaresCircleTest::fitIsAMinimum() {
    QFETCH(double, extent);
    QFETCH(double, noise);
    for (unsigned seed = 0; seed < 20; ++seed) {
        Points points = arc(150, {20, -30}, 17, 17 + extent, 60, noise, seed);
        points.append(arc(150, {20, -30}, 17, 17 + extent, 37, noise, seed + 100).view());
        const std::vector<std::size_t> groups{60, 37};
        const LeastSquaresCircle circle = leastSquaresCircle(points.view(), {.groups = groups});
        QCOMPARE(circle.status, Status::converged);
        const long double at = variance(points, groups, circle.centre.x, circle.centre.y);
        QVERIFY(std::abs(circle.rms - static_cast<double>(std::sqrt(at))) <= 1e-9 * noise);
        for (int k = 0; k < 16; ++k) {
            const Point u = direction(k * 22.5);
            for (const double step : {1e-4 * noise, noise, 10 * noise})
                QVERIFY(variance(points, groups, circle.centre.x + step * u.x, circle.centre.y + step * u.y) >
                        at);
        }
    }
}

void LeastSquaresCircleTest::endsWhereNewtonInLongDoubleEnds_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("noise");
    QTest::addColumn<int>("points");
    QTest::addColumn<int>("iterations"); // at most
    // One look at the directions where the deviations are those of machine tools: its step is sure.
    QTest::newRow("full circle") << 360.0 << 0.02 << 400 << 1;
    QTest::newRow("full circle, many points") << 360.0 << 0.02 << 20000 << 1;
    QTest::newRow("full circle, a thousandth of the radius") << 360.0 << 0.15 << 400 << 2;
    QTest::newRow("half circle") << 180.0 << 0.02 << 400 << 2;
    QTest::newRow("quarter") << 90.0 << 0.02 << 400 << 3;
    QTest::newRow("short arc") << 30.0 << 0.002 << 400 << 4;
    QTest::newRow("full circle, a tenth of the radius") << 360.0 << 15.0 << 400 << 20;
    QTest::newRow("three points and some") << 360.0 << 5.0 << 5 << 20;
}

/// The same circle as Newton's method in long double, which ends where its gradient vanishes.
void LeastSquaresCircleTest::endsWhereNewtonInLongDoubleEnds() {
    QFETCH(double, extent);
    QFETCH(double, noise);
    QFETCH(int, points);
    QFETCH(int, iterations);
    using Real = long double;
    for (unsigned seed = 0; seed < 30; ++seed) {
        Points all = arc(150, {20, -30}, 17, 17 + extent, points, noise, seed);
        all.append(arc(150, {20, -30}, 17, 17 + extent, points / 2 + 1, noise, seed + 100).view());
        const std::vector<std::size_t> groups{static_cast<std::size_t>(points),
                                              static_cast<std::size_t>(points / 2 + 1)};
        const LeastSquaresCircle circle = leastSquaresCircle(all.view(), {.groups = groups});
        QCOMPARE(circle.status, Status::converged);
        QVERIFY2(circle.iterations <= iterations, qPrintable(QString::number(circle.iterations)));
        Real cx = circle.centre.x;
        Real cy = circle.centre.y;
        Real mean = 0;
        for (int step = 0; step < 5; ++step) {
            Real ux = 0, uy = 0, f = 0, fx = 0, fy = 0, xx = 0, xy = 0, yy = 0;
            for (const bool second : {false, true}) { // first the mean, then what is about it
                std::size_t i = 0;
                for (const std::size_t size : groups) {
                    const Real w = 1.0L / static_cast<Real>(size * groups.size());
                    for (const std::size_t end = i + size; i < end; ++i) {
                        const Real dx = all.x[i] - cx;
                        const Real dy = all.y[i] - cy;
                        const Real r = std::sqrt(dx * dx + dy * dy);
                        if (!second) {
                            ux += w * dx / r;
                            uy += w * dy / r;
                            f += w * (r - 150);
                            continue;
                        }
                        const Real d = r - mean;
                        fx += w * d * dx / r;
                        fy += w * d * dy / r;
                        xx += w * ((dx / r - ux) * (dx / r - ux) + d / r * (dy / r) * (dy / r));
                        xy += w * ((dx / r - ux) * (dy / r - uy) - d / r * (dx / r) * (dy / r));
                        yy += w * ((dy / r - uy) * (dy / r - uy) + d / r * (dx / r) * (dx / r));
                    }
                }
                mean = 150 + f;
            }
            const Real determinant = xx * yy - xy * xy;
            cx += (fx * yy - fy * xy) / determinant;
            cy += (fy * xx - fx * xy) / determinant;
        }
        // The rounding of the distances, some 3e-14 mm, times what the arc makes of it: up to (360°/φ)².
        const double tolerance = 1e-12 * std::max(1.0, 5000 / (extent * extent));
        QVERIFY(std::abs(circle.centre.x - static_cast<double>(cx)) <= tolerance);
        QVERIFY(std::abs(circle.centre.y - static_cast<double>(cy)) <= tolerance);
        QVERIFY(std::abs(circle.radius - static_cast<double>(mean)) <= tolerance);
    }
}

/// The moments are taken about the mean of some points: also where these lie elsewhere than the rest.
void LeastSquaresCircleTest::momentsFromAnyOrigin() {
    // Every point of those looked at first lies in one tenth of the circle.
    constexpr int every = 5;
    Points points;
    for (int i = 0; i < 5000; ++i) {
        const double angle = i % every == 0 ? 36.0 * i / 5000 : 360.0 * i / 5000;
        const Point u = direction(angle);
        points.x.push_back(1000 + 150 * u.x);
        points.y.push_back(-500 + 150 * u.y);
    }
    const LeastSquaresCircle circle = leastSquaresCircle(points.view());
    QCOMPARE(circle.status, Status::converged);
    QVERIFY(std::abs(circle.centre.x - 1000) <= 1e-12);
    QVERIFY(std::abs(circle.centre.y + 500) <= 1e-12);
    QVERIFY(std::abs(circle.radius - 150) <= 1e-12);
}

void LeastSquaresCircleTest::exactArcs_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("tolerance");
    // The rounding of the points, about 1e-14 mm, times what the arc makes of it.
    QTest::newRow("full circle") << 360.0 << 1e-12;
    QTest::newRow("half circle") << 180.0 << 1e-12;
    QTest::newRow("90 degrees") << 90.0 << 2e-12;
    QTest::newRow("80 degrees") << 80.0 << 2e-12;
    QTest::newRow("10 degrees") << 10.0 << 1e-9;
    QTest::newRow("1 degree") << 1.0 << 1e-7;
}

void LeastSquaresCircleTest::exactArcs() {
    QFETCH(double, extent);
    QFETCH(double, tolerance);
    for (const Point centre : {Point{0, 0}, Point{1000, -1000}}) {
        const LeastSquaresCircle circle =
            leastSquaresCircle(arc(150, centre, 40, 40 + extent, 400, 0, 1).view());
        QCOMPARE(circle.status, Status::converged);
        const double scale = centre.x == 0 ? 1 : 16; // coordinates with four bits less behind the point
        QVERIFY(std::hypot(circle.centre.x - centre.x, circle.centre.y - centre.y) <= scale * tolerance);
        QVERIFY(std::abs(circle.radius - 150) <= scale * tolerance);
    }
}

void LeastSquaresCircleTest::movesAndTurnsWithThePoints() {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> any(-1, 1);
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Points points = arc(150, {0, 0}, 0, 100 + 5 * seed, 200, 0.03, seed);
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        const Point shift{1000 * any(random), 1000 * any(random)};
        const Point u = direction(180 * any(random));
        Points moved;
        for (std::size_t i = 0; i < points.size(); ++i) {
            moved.x.push_back(u.x * points.x[i] - u.y * points.y[i] + shift.x);
            moved.y.push_back(u.y * points.x[i] + u.x * points.y[i] + shift.y);
        }
        const LeastSquaresCircle other = leastSquaresCircle(moved.view());
        // Rounding of coordinates of 1000 mm, 1e-13, enlarged on the shortest arc.
        QVERIFY(std::abs(other.radius - circle.radius) <= 2e-12);
        QVERIFY(std::abs(other.range() - circle.range()) <= 2e-12);
        QVERIFY(std::abs(other.centre.x - (u.x * circle.centre.x - u.y * circle.centre.y + shift.x)) <=
                2e-12);
        QVERIFY(std::abs(other.centre.y - (u.y * circle.centre.x + u.x * circle.centre.y + shift.y)) <=
                2e-12);
    }
}

void LeastSquaresCircleTest::millionPointsKeepThePrecision() {
    constexpr int n = 1000000;
    Points points;
    for (int i = 0; i < n; ++i) {
        const Point u = direction(360.0 * i / n);
        points.x.push_back(1000 + 150 * u.x);
        points.y.push_back(-1000 + 150 * u.y);
    }
    const LeastSquaresCircle circle = leastSquaresCircle(points.view());
    QCOMPARE(circle.status, Status::converged);
    QVERIFY(std::abs(circle.centre.x - 1000) <= 2e-13);
    QVERIFY(std::abs(circle.centre.y + 1000) <= 2e-13);
    QVERIFY(std::abs(circle.radius - 150) <= 2e-13);
}

void LeastSquaresCircleTest::slantingLinesAreCollinear() {
    // In binary the points of a slanting line are off it by the rounding of their coordinates. They shall
    // not be taken for points of a circle, however large the coordinates are and however short the line.
    std::mt19937_64 random(15);
    std::uniform_real_distribution<double> any(0, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        const Point start{std::pow(10, 9 * any(random) - 3), std::pow(10, 9 * any(random) - 3)};
        const Point u = direction(360 * any(random));
        const double length = std::pow(10, 6 * any(random) - 3);
        Points points;
        for (int i = 0; i < 3 + trial % 50; ++i) {
            const double s = length * any(random);
            points.x.push_back(start.x + s * u.x);
            points.y.push_back(start.y + s * u.y);
        }
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        QCOMPARE(circle.status, Status::collinear);
    }
}

void LeastSquaresCircleTest::noisyLinesEndWithAStatus() {
    // Noise about a straight line: some circle of a large radius fits, or the radius grows without end.
    std::mt19937_64 random(16);
    std::normal_distribution<double> noise(0, 0.01);
    int collinear = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int n = 5 + trial % 40;
        Points points;
        for (int i = 0; i < n; ++i) {
            points.x.push_back(i);
            points.y.push_back(n * noise(random));
        }
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        QVERIFY(circle.valid() || circle.status == Status::collinear);
        if (circle.valid()) {
            QVERIFY(circle.radius > 0 && circle.radius < 1e8 * n);
            QVERIFY(std::isfinite(circle.centre.x) && std::isfinite(circle.centre.y));
            QVERIFY(circle.innerRadius <= circle.radius && circle.radius <= circle.outerRadius);
        } else {
            ++collinear;
            QCOMPARE(circle.radius, 0.0);
            // What the best parabola, which the best circle of so large a radius is, gains over the line.
            QVERIFY2(gainOfParabola(points) < 1e-5, qPrintable(QString::number(gainOfParabola(points))));
        }
    }
    QVERIFY(collinear < 20);
}

void LeastSquaresCircleTest::shortArcsWithLargeDeviations_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("deviation"); // of R
    for (const double extent : {20.0, 30.0, 60.0, 90.0}) {
        for (const double deviation : {0.005, 0.01, 0.02, 0.03, 0.05, 0.1})
            QTest::addRow("%g degrees, %g of R", extent, deviation) << extent << deviation;
    }
}

/// Against the least of the sum as a search without derivatives finds it, in long double.
void LeastSquaresCircleTest::shortArcsWithLargeDeviations() {
    QFETCH(double, extent);
    QFETCH(double, deviation);
    std::mt19937_64 random(30);
    std::uniform_real_distribution<double> any(-1, 1);
    int found = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const int n = 40 + static_cast<int>(random() % 100);
        const double a = any(random);
        const double b = any(random);
        const double phase = 3 * any(random);
        std::vector<double> angles;
        std::vector<double> radii;
        for (int i = 0; i < n; ++i) {
            const double t = 2 * std::numbers::pi * i / (n - 1);
            angles.push_back(extent * i / (n - 1));
            radii.push_back(150 +
                            75 * deviation *
                                (a * std::sin(1.3 * t) + b * std::cos(2.1 * t + phase) + 0.2 * any(random)));
        }
        const Points points = polarPoints(angles, radii);
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        QVERIFY(circle.status == Status::converged || circle.status == Status::collinear);
        if (!circle.valid())
            continue;
        ++found;
        if (circle.radius > 5000)
            continue; // straight within 0.1 mm: the sum tells the centres of metres apart by rounding only
        // A pattern search: a cross whose arms halve where none is lower. Turned along the arc's middle,
        // where the valley is.
        const Point along = direction(extent / 2);
        const std::vector<std::size_t> all{points.size()};
        long double x = circle.centre.x;
        long double y = circle.centre.y;
        long double least = variance(points, all, x, y);
        const long double atFit = least;
        for (long double arm = circle.radius / 8; arm > 1e-9L * circle.radius;) {
            bool lower = false;
            for (const auto &[dx, dy] : {std::pair{along.x, along.y}, std::pair{-along.x, -along.y},
                                         std::pair{-along.y, along.x}, std::pair{along.y, -along.x}}) {
                const long double there = variance(points, all, x + arm * dx, y + arm * dy);
                if (there < least) {
                    least = there;
                    x += arm * dx;
                    y += arm * dy;
                    lower = true;
                }
            }
            if (!lower)
                arm /= 2;
        }
        // The search sees 1e-9 R of the centre, and the sum is flat to the square of it; the fit sees the sum
        // with the rounding of its distances, R·2e-16 each.
        const auto rounding =
            static_cast<long double>(4e-15 * circle.radius) * std::sqrt(static_cast<double>(least));
        QVERIFY2(atFit - least <= 1e-12L * least + rounding,
                 qPrintable(QStringLiteral("trial %1: R %2, %3 mm, %4")
                                .arg(trial)
                                .arg(circle.radius)
                                .arg(double(std::hypot(x - circle.centre.x, y - circle.centre.y)))
                                .arg(double((atFit - least) / least))));
    }
    QVERIFY2(found == 40, qPrintable(QString::number(found)));
}

namespace {

/// The least of the sum of squares over all centres: a dense net of centres, and a pattern search from its
/// best ones. Knows nothing of the fit.
double leastVariance(const Points &points, double extent) {
    const std::vector<std::size_t> all{points.size()};
    double meanX = 0;
    double meanY = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        meanX += points.x[i] / static_cast<double>(points.size());
        meanY += points.y[i] / static_cast<double>(points.size());
    }
    const auto at = [&](double x, double y) {
        double mean = 0;
        std::vector<double> r;
        for (std::size_t i = 0; i < points.size(); ++i) {
            r.push_back(std::hypot(points.x[i] - x, points.y[i] - y));
            mean += r.back() / static_cast<double>(points.size());
        }
        double sum = 0;
        for (const double one : r)
            sum += (one - mean) * (one - mean) / static_cast<double>(points.size());
        return sum;
    };
    struct Node {
        double value, x, y, arm;
    };
    std::vector<Node> net;
    for (double distance = extent / 20; distance < extent * 3000; distance *= 1.4) {
        for (int k = 0; k < 60; ++k) {
            const Point towards = direction(6.0 * k);
            const double x = meanX + distance * towards.x;
            const double y = meanY + distance * towards.y;
            net.push_back({at(x, y), x, y, distance / 10});
        }
    }
    std::ranges::sort(net, {}, &Node::value);
    double least = net.front().value;
    for (std::size_t i = 0; i < 12; ++i) {
        Node node = net[i];
        for (; node.arm > 1e-6 * extent; node.arm /= 2) {
            for (bool lower = true; lower;) {
                lower = false;
                for (int k = 0; k < 8; ++k) {
                    const Point towards = direction(45.0 * k);
                    const double value = at(node.x + node.arm * towards.x, node.y + node.arm * towards.y);
                    if (value < node.value * (1 - 1e-12)) {
                        node.value = value;
                        node.x += node.arm * towards.x;
                        node.y += node.arm * towards.y;
                        lower = true;
                    }
                }
            }
        }
        least = std::min(least, node.value);
    }
    return least;
}

} // namespace

void LeastSquaresCircleTest::noisyShortArcsHaveTheBestOfAllCircles_data() {
    QTest::addColumn<double>("extent");
    QTest::addColumn<double>("deviation"); // of R
    for (const double extent : {20.0, 30.0, 45.0, 90.0}) {
        for (const double deviation : {0.01, 0.03, 0.05})
            QTest::addRow("%g degrees, %g of R", extent, deviation) << extent << deviation;
    }
}

/// Readings that scatter as much as a short arc is bent: the sum has minima on both sides and beside the arc.
void LeastSquaresCircleTest::noisyShortArcsHaveTheBestOfAllCircles() {
    QFETCH(double, extent);
    QFETCH(double, deviation);
    std::mt19937_64 random(31);
    std::normal_distribution<double> noise(0, 100 * deviation);
    for (int trial = 0; trial < 8; ++trial) {
        const int n = 8 + static_cast<int>(random() % 13);
        std::vector<double> angles;
        std::vector<double> radii;
        for (int i = 0; i < n; ++i) {
            angles.push_back(extent * i / (n - 1));
            radii.push_back(100 + noise(random));
        }
        const Points points = polarPoints(angles, radii);
        const LeastSquaresCircle circle = leastSquaresCircle(points.view());
        const double least = leastVariance(points, 100 * extent * std::numbers::pi / 180 / 2);
        if (!circle.valid()) { // no circle is better than the line, which those of the net come near to
            QCOMPARE(circle.status, Status::collinear);
            continue;
        }
        // The search ends with arms of 1e-6 of the extent: the sum is flat to the square of it.
        QVERIFY2(circle.rms * circle.rms <= least * (1 + 1e-9),
                 qPrintable(QStringLiteral("trial %1, %2 points: %3 against %4")
                                .arg(trial)
                                .arg(n)
                                .arg(circle.rms * circle.rms)
                                .arg(least)));
    }
}

void LeastSquaresCircleTest::notConvergedIsNoCircle() {
    const Points points = arc(150, {0, 0}, 0, 30, 100, 3, 1);
    QVERIFY(leastSquaresCircle(points.view()).valid());
    LeastSquaresCircleOptions options;
    options.maxIterations = 2;
    const LeastSquaresCircle circle = leastSquaresCircle(points.view(), options);
    QCOMPARE(circle.status, Status::notConverged);
    QVERIFY(!circle.valid());
    QCOMPARE(circle.radius, 0.0);
}

void LeastSquaresCircleTest::badInput_data() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<std::vector<double>>("x");
    QTest::addColumn<std::vector<double>>("y");
    QTest::addColumn<int>("status");
    using Values = std::vector<double>;
    const auto row = [](const char *name, const Values &x, const Values &y, Status status) {
        QTest::newRow(name) << x << y << static_cast<int>(status);
    };
    row("three points", {0, 1, 0}, {0, 0, 1}, Status::converged);
    row("three points, one of them twice", {0, 1, 0, 1}, {0, 0, 1, 0}, Status::converged);
    row("no point", {}, {}, Status::tooFewPoints);
    row("one point", {1}, {1}, Status::tooFewPoints);
    row("two points", {1, 2}, {1, 3}, Status::tooFewPoints);
    row("two points, many times", {1, 2, 1, 2, 1, 2, 2}, {1, 3, 1, 3, 1, 3, 3}, Status::tooFewPoints);
    row("one point, many times", {7, 7, 7, 7}, {-1, -1, -1, -1}, Status::tooFewPoints);
    row("points on the first axis", {1, 2, 3, 5}, {0, 0, 0, 0}, Status::collinear);
    row("points on the second axis", {4, 4, 4, 4}, {1, 2, 3, 5}, Status::collinear);
    row("a slanting line", {0.1, 0.2, 0.3, 0.4, 0.7}, {0.3, 0.6, 0.9, 1.2, 2.1}, Status::collinear);
    row("a slanting line far off", {1000.1, 1000.2, 1000.3, 1000.4}, {0.3, 0.6, 0.9, 1.2}, Status::collinear);
    row("NaN in x", {0, 1, nan, 2}, {0, 0, 1, 5}, Status::notFinite);
    row("NaN in y", {0, 1, 0, 2}, {0, nan, 1, 5}, Status::notFinite);
    row("infinite", {0, 1, 0, 2}, {0, 0, infinity, 5}, Status::notFinite);
    row("too large", {0, 1, 0, 2}, {0, 0, 1e300, 5}, Status::notFinite);
}

void LeastSquaresCircleTest::badInput() {
    QFETCH(std::vector<double>, x);
    QFETCH(std::vector<double>, y);
    QFETCH(int, status);
    const LeastSquaresCircle circle = leastSquaresCircle({x, y});
    QCOMPARE(static_cast<int>(circle.status), status);
    if (circle.status == Status::converged) {
        QVERIFY(std::abs(circle.centre.x - 0.5) <= 1e-15);
        QVERIFY(std::abs(circle.centre.y - 0.5) <= 1e-15);
        QVERIFY(std::abs(circle.radius - std::numbers::sqrt2 / 2) <= 1e-15);
    } else {
        LeastSquaresCircle zeros;
        zeros.status = circle.status;
        QCOMPARE(circle, zeros);
    }
}

QTEST_GUILESS_MAIN(LeastSquaresCircleTest)
#include "leastsquarescircle.moc"
