// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/rays.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"
#include "kernel/numerics/nearbycircle.h"
#include "kernel/numerics/radiusextremes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace palmer;

/// Points near a reference against the plain ways that look at all points.
class RaysTest : public QObject {
    Q_OBJECT

private slots:
    void shapes_data();
    void everyPointBeyondIsVisited_data() { shapes_data(); }
    void everyPointBeyondIsVisited();
    void extremesOfAll_data() { shapes_data(); }
    void extremesOfAll();
    void minimumZoneToTheLastBit_data() { shapes_data(); }
    void minimumZoneToTheLastBit();
    void leastSquares_data() { shapes_data(); }
    void leastSquares();
    void whatIsNotFinite();
};

namespace {

constexpr int looks = 150; ///< of each shape

/// One or two sets of rays about a shape, and looks at them.
struct Shape {
    std::vector<Rays> sets;
    std::vector<std::vector<double>> radii;
    std::vector<Rays::Look> looks;
    std::mt19937_64 random{7};
    double noise;
    double common;

    Shape(int n, double arc, int count, double form, double offset, double step, double noiseOfPoints,
          double commonChange, double radius)
        : noise(noiseOfPoints)
        , common(commonChange) {
        std::normal_distribution<double> normal;
        for (int set = 0; set < count; ++set) {
            std::vector<double> x;
            std::vector<double> y;
            std::vector<double> r;
            for (int i = 0; i < n; ++i) {
                const double degrees = (set == 0 ? 1 : -1) * (arc * i / n + 10);
                const double angle = degrees * std::numbers::pi / 180;
                double d = offset * std::cos(angle - 0.5) + form * std::cos(2 * angle) +
                           form / 2 * std::sin(3 * angle + set) + form / 50 * normal(random);
                if (step > 0)
                    d = std::round(d / step) * step;
                const Point u = direction(degrees);
                x.push_back(u.x);
                y.push_back(u.y);
                r.push_back(radius + d);
            }
            radii.push_back(r);
            const Rays rays(x, y, r, {});
            const LeastSquaresCircle fit = leastSquaresCircle(rays.reference().view());
            sets.emplace_back(x, y, r, fit.valid() ? fit.centre : Point{});
            this->looks.push_back(sets.back().sample());
        }
    }

    void lookAgain() {
        std::normal_distribution<double> normal;
        for (std::size_t k = 0; k < sets.size(); ++k) {
            const double all = common * normal(random);
            for (std::size_t i = 0; i < radii[k].size(); ++i)
                looks[k].radii[i] = radii[k][i] + (all + noise * normal(random));
            sets[k].prepare(looks[k]);
        }
    }

    [[nodiscard]] Points points() const {
        Points all;
        for (std::size_t k = 0; k < sets.size(); ++k) {
            Points of;
            sets[k].fill(looks[k], of);
            all.append(of.view());
        }
        return all;
    }
    [[nodiscard]] Points reference() const {
        Points all;
        for (const Rays &rays : sets)
            all.append(rays.reference().view());
        return all;
    }
};

struct Row {
    int n;
    double arc;          ///< degrees
    int count;           ///< sets
    double form;         ///< mm
    double offset;       ///< mm
    double step;         ///< mm
    double noise;        ///< mm
    double common;       ///< mm
    bool near;           ///< nearly no look has to go the plain way
    double radius = 150; ///< mm
};

} // namespace

Q_DECLARE_METATYPE(Row)

namespace {

Shape shapeOf(const Row &row) {
    return {row.n, row.arc, row.count, row.form, row.offset, row.step, row.noise, row.common, row.radius};
}

} // namespace

void RaysTest::shapes_data() {
    QTest::addColumn<Row>("row");
    const auto add = [](const char *name, Row row) { QTest::newRow(name) << row; };
    add("oval", {400, 360, 1, 5e-3, 1e-3, 0, 1e-4, 0, true});
    add("oval, both senses", {1001, 360, 2, 5e-3, 1e-3, 0, 1e-4, 5e-4, true});
    add("noise alone", {400, 360, 2, 0, 0, 0, 1e-4, 0, true});
    add("little noise", {400, 360, 2, 5e-3, 1e-3, 0, 1e-7, 0, true});
    add("large noise", {400, 360, 1, 5e-3, 1e-3, 0, 0.2, 0, true});
    add("far off the centre", {400, 360, 2, 5e-3, 0.3, 0, 1e-4, 1e-3, true});
    add("a quarter", {400, 90, 1, 5e-3, 1e-3, 0, 1e-4, 0, true});
    add("a quarter, both senses", {399, 90, 2, 5e-3, 1e-3, 0, 1e-4, 1e-3, true});
    add("resolution of a tenth of a micrometre", {400, 360, 2, 2e-3, 0, 1e-4, 1e-4, 0, true});
    add("ties that stay", {400, 360, 2, 2e-3, 0, 1e-3, 0, 1e-4, false});
    add("nothing at all", {400, 360, 2, 0, 0, 0, 0, 0, false});
    add("large deviations", {400, 360, 2, 3, 2, 0, 0.5, 0.5, false});
    add("half a millimetre", {400, 360, 2, 1.5e-5, 3e-6, 0, 3e-7, 0, true, 0.5});
    add("few points", {5, 360, 1, 5e-3, 1e-3, 0, 1e-4, 0, true});
    add("one more than a sector", {17, 360, 2, 5e-3, 1e-3, 0, 1e-4, 0, true});
}

void RaysTest::everyPointBeyondIsVisited() {
    QFETCH(Row, row);
    Shape shape = shapeOf(row);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> part(-0.2, 1.2);
    for (int k = 0; k < looks; ++k) {
        shape.lookAgain();
        for (std::size_t set = 0; set < shape.sets.size(); ++set) {
            const Rays &rays = shape.sets[set];
            const double away = std::pow(10.0, normal(shape.random) - 3);
            const Point centre{away * normal(shape.random), away * normal(shape.random)};
            Points points;
            rays.fill(shape.looks[set], points);
            const RadiusExtremes all = radiusExtremes(points.view(), centre);
            const double outer = all.inner + part(shape.random) * (all.outer - all.inner);
            const double inner = all.inner + part(shape.random) * (all.outer - all.inner);
            std::set<std::size_t> visited;
            rays.visitBeyond(shape.looks[set], centre, outer, inner,
                             [&](std::size_t i) { QVERIFY(visited.insert(i).second); });
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double r = std::sqrt(squaredDistance(points.x[i], points.y[i], {}, centre));
                if (r > outer || r < inner)
                    QVERIFY(visited.contains(i));
            }
            const Rays::Outermost outermost = rays.outermost(shape.looks[set], centre);
            QVERIFY(outermost.greatest >= all.outer);
            QVERIFY(outermost.least <= all.inner);
        }
    }
}

void RaysTest::extremesOfAll() {
    QFETCH(Row, row);
    Shape shape = shapeOf(row);
    std::normal_distribution<double> normal;
    for (int k = 0; k < looks; ++k) {
        shape.lookAgain();
        for (std::size_t set = 0; set < shape.sets.size(); ++set) {
            const double away = std::pow(10.0, normal(shape.random) - 3);
            const Point centre{away * normal(shape.random), away * normal(shape.random)};
            Points points;
            shape.sets[set].fill(shape.looks[set], points);
            const RadiusExtremes all = radiusExtremes(points.view(), centre);
            const Rays::Extremes found = shape.sets[set].extremes(shape.looks[set], centre);
            QCOMPARE(found.greatest, all.outer);
            QVERIFY(found.least == all.inner); // QCOMPARE calls near values equal
            QVERIFY(found.greatest == all.outer);
        }
    }
}

void RaysTest::minimumZoneToTheLastBit() {
    QFETCH(Row, row);
    Shape shape = shapeOf(row);
    const MinimumZone first = minimumZone(shape.reference().view());
    const std::size_t quarter = shape.reference().size() / 4;
    std::array<std::size_t, 4> contacts{0, 2 * quarter, quarter, 3 * quarter};
    if (first.certified)
        contacts = {first.outer[0], first.outer[1], first.inner[0], first.inner[1]};
    int plain = 0;
    for (int k = 0; k < 4 * looks; ++k) {
        shape.lookAgain();
        std::vector<RaysLook> all;
        for (std::size_t set = 0; set < shape.sets.size(); ++set)
            all.push_back({&shape.sets[set], &shape.looks[set]});
        const auto found = minimumZone(all, contacts);
        if (!found) {
            ++plain;
            continue;
        }
        const MinimumZone expected = minimumZone(shape.points().view());
        QVERIFY(found->valid() && found->certified && expected.certified);
        QVERIFY(found->centre == expected.centre);
        QVERIFY(found->innerRadius == expected.innerRadius);
        QVERIFY(found->outerRadius == expected.outerRadius);
        QVERIFY(found->width == expected.width);
        QVERIFY(std::set(found->outer.begin(), found->outer.end()) ==
                std::set(expected.outer.begin(), expected.outer.end()));
        QVERIFY(std::set(found->inner.begin(), found->inner.end()) ==
                std::set(expected.inner.begin(), expected.inner.end()));
    }
    if (row.near)
        QVERIFY2(plain <= 4 * looks / 100, qPrintable(QString::number(plain)));
}

void RaysTest::leastSquares() {
    QFETCH(Row, row);
    Shape shape = shapeOf(row);
    std::vector<const Rays *> sets;
    std::vector<std::size_t> groups;
    for (const Rays &rays : shape.sets) {
        sets.push_back(&rays);
        groups.push_back(rays.size());
    }
    const LeastSquaresCircle first = leastSquaresCircle(shape.reference().view(), {.groups = groups});
    QVERIFY(first.valid());
    const NearbyCircle nearby(sets, first.centre);
    int plain = 0;
    for (int k = 0; k < looks; ++k) {
        shape.lookAgain();
        std::vector<const Rays::Look *> all;
        for (const Rays::Look &look : shape.looks)
            all.push_back(&look);
        const auto found = nearby.fit(all);
        if (!found) {
            ++plain;
            continue;
        }
        const LeastSquaresCircle expected = leastSquaresCircle(shape.points().view(), {.groups = groups});
        // Rounding of both, 1e-14 of the radius; where an arc tells its centre badly that much more.
        const double tolerance = row.arc < 360 ? 5e-11 : 2e-12;
        QVERIFY2(std::abs(found->radius - expected.radius) <= tolerance,
                 qPrintable(QString::number(found->radius - expected.radius)));
        QVERIFY(std::abs(found->centre.x - expected.centre.x) <= tolerance);
        QVERIFY(std::abs(found->centre.y - expected.centre.y) <= tolerance);
    }
    if (row.near && row.arc == 360 && row.noise < 1e-2)
        QCOMPARE(plain, 0);
}

void RaysTest::whatIsNotFinite() {
    Shape shape = shapeOf({100, 360, 1, 5e-3, 0, 0, 1e-4, 0, true});
    for (const std::size_t i : {0U, 50U, 99U}) {
        for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
            shape.lookAgain();
            shape.looks[0].radii[i] = bad;
            shape.sets[0].prepare(shape.looks[0]);
            QVERIFY(!shape.sets[0].finite(shape.looks[0]));
            const std::vector<RaysLook> all{{&shape.sets[0], &shape.looks[0]}};
            QVERIFY(!minimumZone(all, {0, 50, 25, 75}));
            const std::vector<const Rays *> sets{&shape.sets[0]};
            const std::vector<const Rays::Look *> looks{&shape.looks[0]};
            QVERIFY(!NearbyCircle(sets, {}).fit(looks));
        }
    }
}

QTEST_APPLESS_MAIN(RaysTest)
#include "rays.moc"
