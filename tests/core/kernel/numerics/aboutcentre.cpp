// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/aboutcentre.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

using namespace palmer;

/// Points as another centre sees them.
class AboutCentreTest : public QObject {
    Q_OBJECT

private slots:
    void againstLongDouble_data();
    void againstLongDouble();
    void theCentreItself();
};

void AboutCentreTest::againstLongDouble_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<double>("offset"); // of the centre, mm
    QTest::newRow("no point") << 0 << 0.01;
    QTest::newRow("one") << 1 << 0.01;
    QTest::newRow("seven") << 7 << 0.01;
    QTest::newRow("a block and one") << 257 << 0.01;
    QTest::newRow("many") << 10'001 << 0.01;
    QTest::newRow("the origin") << 1000 << 0.0;
    QTest::newRow("some tangents are small") << 1000 << 0.15;
    QTest::newRow("few are") << 1000 << 1.0;
    QTest::newRow("the centre among the points") << 1000 << 150.0;
    QTest::newRow("the centre beyond them") << 1000 << 400.0;
}

void AboutCentreTest::againstLongDouble() {
    QFETCH(int, points);
    QFETCH(double, offset);
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto n = static_cast<std::size_t>(points);
    for (int k = 0; k < 20; ++k) {
        const Point u = direction(180 * any(random));
        const Point centre{offset * u.x, offset * u.y};
        std::vector<double> angles;
        std::vector<double> radii;
        for (std::size_t i = 0; i < n; ++i) {
            angles.push_back(360 * any(random));
            radii.push_back(150 + any(random));
        }
        const Points all = polarPoints(angles, radii);
        std::vector<double> turns(n);
        std::vector<double> distances(n);
        aboutCentre(all.view(), centre, turns, distances);
        for (std::size_t i = 0; i < n; ++i) {
            const long double x = all.x[i];
            const long double y = all.y[i];
            const long double dx = x - centre.x;
            const long double dy = y - centre.y;
            const auto turn = static_cast<double>(std::atan2(x * dy - y * dx, x * dx + y * dy) * 180 /
                                                  std::numbers::pi_v<long double>);
            // The rounding of P − c, of 150 mm and more, as an angle from where c is; nearer than 1 mm to it
            // that says nothing.
            const auto distance = static_cast<double>(std::hypot(dx, dy));
            QVERIFY(std::abs(distances[i] - distance) <= 3e-13);
            const double difference = std::remainder(turns[i] - turn, 360);
            if (distance > 1)
                QVERIFY2(std::abs(difference) <= 1e-11 / distance + 1e-13,
                         qPrintable(QString::number(difference)));
        }
        std::vector<double> narrowTurns(n);
        std::vector<double> narrowDistances(n);
        aboutCentreNarrow(all.view(), centre, narrowTurns, narrowDistances);
        QVERIFY(n == 0 || std::memcmp(turns.data(), narrowTurns.data(), n * sizeof(double)) == 0);
        QVERIFY(n == 0 || std::memcmp(distances.data(), narrowDistances.data(), n * sizeof(double)) == 0);
    }
}

void AboutCentreTest::theCentreItself() {
    const Points points{{3, 150}, {4, 0}};
    std::vector<double> turns(2);
    std::vector<double> distances(2);
    aboutCentre(points.view(), {3, 4}, turns, distances);
    QCOMPARE(distances[0], 0.0);
    QCOMPARE(turns[0], 0.0);
    QVERIFY(std::abs(distances[1] - std::hypot(147.0, 4.0)) <= 1e-13);
    QVERIFY(std::abs(turns[1] + std::atan2(4.0, 147.0) * 180 / std::numbers::pi) <= 1e-13);
}

QTEST_APPLESS_MAIN(AboutCentreTest)
#include "aboutcentre.moc"
