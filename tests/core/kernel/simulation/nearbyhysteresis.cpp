// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/nearbyhysteresis.h"

#include "kernel/evaluation/iso230_4/hysteresis.h"
#include "kernel/numerics/leastsquarescircle.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palmer;

/// The hysteresis near a reference against the plain way, which finds all angles anew and sorts them.
class NearbyHysteresisTest : public QObject {
    Q_OBJECT

private slots:
    void toTheLastBit_data();
    void toTheLastBit();
    void whatCannotBeTold();
};

namespace {

constexpr double radius = 150;

struct Row {
    int first = 360;      ///< points
    int second = 360;     ///< of the other path
    double form = 5e-3;   ///< mm
    double offset = 1e-2; ///< mm
    double noise = 1e-4;  ///< mm, of each look
    double common = 0;    ///< mm, of each path of each look
    double jitter = 0;    ///< of the angles, in steps
    double overlap = 0;   ///< degrees beyond the full turn
    double step = 0;      ///< of the readings, mm
    double shift = 1e-5;  ///< of the centre, mm
    bool near = true;     ///< nearly no look has to go the plain way
};

std::vector<double> anglesOf(int n, const Row &row, int sense, std::mt19937_64 &random) {
    std::uniform_real_distribution<double> any(-0.5, 0.5);
    std::vector<double> angles;
    for (int i = 0; i < n; ++i) {
        const double place = i + row.jitter * any(random);
        angles.push_back(sense * (360 + row.overlap) * place / n);
    }
    return angles;
}

struct Path {
    Rays rays;
    std::vector<double> radii;
    Rays::Look look;

    Path(const std::vector<double> &angles, const Row &row, int sense, Point centre,
         std::mt19937_64 &random) {
        std::normal_distribution<double> normal;
        std::vector<double> x;
        std::vector<double> y;
        for (const double degrees : angles) {
            const double angle = degrees * std::numbers::pi / 180;
            double d = row.offset * std::cos(angle - 0.5) + row.form * std::cos(2 * angle) +
                       row.form / 3 * sense * std::sin(3 * angle) + row.form / 50 * normal(random);
            if (row.step > 0)
                d = std::round(d / row.step) * row.step;
            const Point u = direction(degrees);
            x.push_back(u.x);
            y.push_back(u.y);
            radii.push_back(radius + d);
        }
        rays = Rays(x, y, radii, centre);
        look = rays.sample();
    }

    void lookAgain(const Row &row, std::mt19937_64 &random) {
        std::normal_distribution<double> normal;
        const double all = row.common * normal(random);
        for (std::size_t i = 0; i < radii.size(); ++i)
            look.radii[i] = radii[i] + (all + row.noise * normal(random));
        rays.prepare(look);
    }

    [[nodiscard]] Points points() const {
        Points result;
        rays.fill(look, result);
        return result;
    }
};

} // namespace

Q_DECLARE_METATYPE(Row)

void NearbyHysteresisTest::toTheLastBit_data() {
    QTest::addColumn<Row>("row");
    QTest::newRow("as most") << Row{};
    QTest::newRow("many points") << Row{.first = 1800, .second = 1800};
    QTest::newRow("other numbers") << Row{.first = 500, .second = 37};
    QTest::newRow("few points") << Row{.first = 16, .second = 16};
    QTest::newRow("too few points") << Row{.first = 15, .second = 36, .near = false};
    QTest::newRow("noise alone") << Row{.form = 0, .offset = 0};
    QTest::newRow("nothing at all") << Row{.form = 0, .offset = 0, .noise = 0};
    QTest::newRow("no noise") << Row{.noise = 0};
    QTest::newRow("ties") << Row{.noise = 0, .step = 1e-3};
    QTest::newRow("much noise") << Row{.noise = 1e-2};
    QTest::newRow("drift") << Row{.common = 1e-3};
    QTest::newRow("far off the centre") << Row{.offset = 0.3, .common = 1e-3};
    QTest::newRow("another centre") << Row{.shift = 1e-3};
    QTest::newRow("angles as they came") << Row{.jitter = 0.9};
    QTest::newRow("start and end at one place") << Row{.first = 361, .second = 361, .overlap = 1};
    QTest::newRow("two turns nearly") << Row{.jitter = 0.4, .overlap = 20};
    QTest::newRow("angles anyhow") << Row{.jitter = 20, .near = false};
    QTest::newRow("a centre far away") << Row{.shift = 1, .near = false};
    QTest::newRow("large noise") << Row{.noise = 3, .near = false};
}

void NearbyHysteresisTest::toTheLastBit() {
    QFETCH(Row, row);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    int plain = 0;
    constexpr int references = 4;
    constexpr int looks = 50;
    for (int reference = 0; reference < references; ++reference) {
        const Point centre{row.offset * 0.9, row.offset * 0.5};
        Path first(anglesOf(row.first, row, 1, random), row, 1, centre, random);
        Path second(anglesOf(row.second, row, -1, random), row, -1, centre, random);
        const NearbyHysteresis nearby(first.rays, second.rays, centre);
        for (int look = 0; look < looks; ++look) {
            first.lookAgain(row, random);
            second.lookAgain(row, random);
            const Point at{centre.x + row.shift * normal(random), centre.y + row.shift * normal(random)};
            const auto found = nearby.largestDifference(
                {RaysLook{&first.rays, &first.look}, RaysLook{&second.rays, &second.look}}, at);
            plain += found ? 0 : 1;
            if (found)
                QVERIFY(*found ==
                        iso230_4::largestDifference(first.points().view(), second.points().view(), at));
        }
    }
    if (row.near)
        QVERIFY2(plain <= references * looks / 20, qPrintable(QString::number(plain)));
}

void NearbyHysteresisTest::whatCannotBeTold() {
    std::mt19937_64 random(3);
    const Row row;
    Path first(anglesOf(row.first, row, 1, random), row, 1, {}, random);
    Path second(anglesOf(row.second, row, -1, random), row, -1, {}, random);
    const NearbyHysteresis nearby(first.rays, second.rays, {});
    const auto told = [&](Point centre) {
        return nearby
            .largestDifference({RaysLook{&first.rays, &first.look}, RaysLook{&second.rays, &second.look}},
                               centre)
            .has_value();
    };
    first.lookAgain(row, random);
    second.lookAgain(row, random);
    QVERIFY(told({}));
    QVERIFY(!told({std::numeric_limits<double>::quiet_NaN(), 0}));
    QVERIFY(!told({0, std::numeric_limits<double>::infinity()}));
    second.look.radii[7] = std::numeric_limits<double>::quiet_NaN();
    second.rays.prepare(second.look);
    QVERIFY(!told({}));
}

QTEST_APPLESS_MAIN(NearbyHysteresisTest)
#include "nearbyhysteresis.moc"
