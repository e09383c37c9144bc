// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pathrows.h"

#include <QTest>

#include <deque>
#include <numbers>

using namespace palmer;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double radius = 100;

/// Arcs about the origin, their points at `count` equal steps from the first angle to the last.
class Circle {
public:
    DiagnosedCircle circle{"X", "Y", radius, std::nullopt, false, 0, {}, std::nullopt, {}};

    void add(
        double from, double to, int count, double (*deviation)(double angle) = [](double) { return 0.0; }) {
        Points &points = m_points.emplace_back();
        DiagnosedArc arc;
        arc.sense = to > from ? Sense::counterclockwise : Sense::clockwise;
        for (int i = 0; i < count; ++i) {
            const double angle = count > 1 ? from + (to - from) * i / (count - 1) : from;
            const double r = radius + deviation(angle * degree);
            points.x.push_back(r * std::cos(angle * degree));
            points.y.push_back(r * std::sin(angle * degree));
            arc.angles.push_back(angle);
        }
        arc.points = points.view();
        circle.arcs.push_back(std::move(arc));
    }

private:
    std::deque<Points> m_points; ///< stay where they are
};

PathPosition positionOn(const Circle &of, std::size_t arc, std::size_t i, double lag = 0, double pause = 0) {
    PathPosition position;
    ArcWalk(of.circle, arc, {0, 0}, lag, pause).at(i, position);
    return position;
}

bool near(double value, double expected, double tolerance = 1e-12) { // a few roundings of numbers about 1
    return std::abs(value - expected) <= tolerance;
}

} // namespace

/// The rows that a diagnosis fits.
class PathRowsTest : public QObject {
    Q_OBJECT

private slots:
    /// From the middle of the test, with pauses between the arcs: 1 + ½ + ½ + ¼ + ½ + … turns by hand.
    void turnsAreCountedFromTheMiddle() {
        Circle three;
        three.add(0, 360, 9);
        three.add(180, 0, 5);
        three.add(0, 90, 3);
        // 1 + 0.5 + 0.25 turns and two pauses of 0.125: 2 turns in all.
        QVERIFY(near(positionOn(three, 0, 0, 0, 0.125).turns, -1));
        QVERIFY(near(positionOn(three, 0, 8, 0, 0.125).turns, 0));
        QVERIFY(near(positionOn(three, 1, 0, 0, 0.125).turns, 0.125));
        QVERIFY(near(positionOn(three, 1, 4, 0, 0.125).turns, 0.625));
        QVERIFY(near(positionOn(three, 2, 0, 0, 0.125).turns, 0.75));
        QVERIFY(near(positionOn(three, 2, 2, 0, 0.125).turns, 1));
        Circle one;
        one.add(0, 360, 9);
        QVERIFY(near(positionOn(one, 0, 0, 0, 0.125).turns, -0.5)); // no pause behind the last
    }

    void positionsAreThoseOfThePath() {
        Circle both;
        both.add(30, 300, 10);
        both.add(300, 30, 10);
        both.circle.feed = 25;
        const PathPosition forwards = positionOn(both, 0, 0, 2);
        QVERIFY(near(forwards.cosine, std::cos(30 * degree)) && near(forwards.sine, std::sin(30 * degree)));
        QCOMPARE(forwards.sense, 1.0);
        QCOMPARE(forwards.radius, radius);
        QCOMPARE(forwards.feed, 25.0);
        QCOMPARE(positionOn(both, 1, 0).sense, -1.0);
        // Where angles were commanded, the machine lags behind: the position looked up is that much back.
        for (DiagnosedArc &arc : both.circle.arcs)
            arc.commanded = true;
        QVERIFY(near(positionOn(both, 0, 0, 2).sine, std::sin(28 * degree)));
        QVERIFY(near(positionOn(both, 0, 0, 2).cosine, std::cos(28 * degree)));
        QVERIFY(near(positionOn(both, 1, 9, 2).sine, std::sin(32 * degree)));
        QVERIFY(near(positionOn(both, 1, 9, 2).cosine, std::cos(32 * degree)));
        both.circle.feed.reset();
        QCOMPARE(positionOn(both, 0, 0).feed, 1.0);
    }

    void theLargestStepIsThatOfTheCoarsestArc() {
        Circle two;
        two.add(10, 280, 271);
        two.add(280, 10, 91);
        two.add(5, 5, 1);
        const Point centre{0, 0};
        const PathRows rows({&two.circle, 1}, {&centre, 1}, 0, 0);
        QCOMPARE(rows.size(), Eigen::Index(363));
        QVERIFY(near(rows.step(), 3 * degree));
        QCOMPARE(rows.circleOf(0), std::size_t(0));
    }

    /// Up to 7 200 points of an arc are rows of their own.
    void manyPointsShareARow() {
        for (const int count : {7200, 7201, 14401}) {
            Circle one;
            one.add(1, 359, count, [](double angle) { return 1e-3 * std::cos(3 * angle); });
            const Point centre{0, 0};
            const PathRows rows({&one.circle, 1}, {&centre, 1}, 0, 0);
            const int perRow = count == 7200 ? 1 : count == 7201 ? 2 : 3;
            QCOMPARE(rows.arcs().front().perRow, std::size_t(perRow));
            QCOMPARE(rows.size(), Eigen::Index((count + perRow - 1) / perRow));
            QCOMPARE(rows.records().front().size, std::size_t(rows.size()));
            // A row is the mean of its points, a column of the fit likewise.
            const std::array terms{FitTerm{InfluenceId::radius, PlaneAxis::none, false, 0, 0},
                                   FitTerm{InfluenceId::centre, PlaneAxis::first, false, 0, 0},
                                   FitTerm{InfluenceId::centre, PlaneAxis::second, false, 0, 0}};
            const Eigen::MatrixXd columns = rows.columns(terms);
            const int row = static_cast<int>(rows.size()) / 3;
            double deviation = 0;
            double x = 0;
            double y = 0;
            for (int i = row * perRow; i < (row + 1) * perRow; ++i) {
                const double angle = (1 + 358.0 * i / (count - 1)) * degree;
                deviation += 1e-3 * std::cos(3 * angle) / perRow;
                x += std::cos(angle) / perRow;
                y += std::sin(angle) / perRow;
            }
            QVERIFY(rows.counts(row));
            QVERIFY(near(rows.deviations()[row], deviation));
            QVERIFY(near(columns(row, 0), 1));
            QVERIFY(near(columns(row, 1), x) && near(columns(row, 2), y));
        }
    }

    /// What is nearer to the poles than the reach says nothing; the largest deviation may reach farther.
    void nothingCountsNearAReversal() {
        const Point centre{0, 0};
        const auto used = [&](double reach, double (*deviation)(double)) {
            Circle one;
            one.add(-45, 45, 901, deviation); // in steps of 0.1°
            return PathRows({&one.circle, 1}, {&centre, 1}, 0, 0, reach).used();
        };
        const auto none = [](double) { return 0.0; };
        QCOMPARE(used(0.25, none), std::size_t(901 - 5));
        QCOMPARE(used(0.55, none), std::size_t(901 - 11));
        QCOMPARE(used(4.95, none), std::size_t(901 - 99));
        // A spike of 1 mm at 20° outwards: 1/100 rad = 0.573°, less the mean.
        const auto spike = [](double angle) { return std::abs(angle - 20 * degree) < 1e-6 ? 1.0 : 0.0; };
        QCOMPARE(used(0.25, spike), std::size_t(901 - 11));
        const auto inwards = [](double angle) { return std::abs(angle - 20 * degree) < 1e-6 ? -1.0 : 0.0; };
        QCOMPARE(used(0.25, inwards), std::size_t(901 - 11));
        QCOMPARE(used(0.25, [](double) { return 1.0; }), std::size_t(901 - 5)); // a radius is no deviation
        const auto huge = [](double angle) { return std::abs(angle - 20 * degree) < 1e-6 ? 20.0 : 0.0; };
        QVERIFY(used(0.25, huge) >= 901 - 101); // 5° at most
        Circle one;
        one.add(-45, 45, 901);
        const PathRows rows({&one.circle, 1}, {&centre, 1}, 0, 0, 0.25);
        QVERIFY(!rows.counts(450) && rows.deviations()[450] == 0);
        QVERIFY(rows.counts(447) && !rows.counts(448) && !rows.counts(452) && rows.counts(453));
    }

    void theCentreIsOfAllArcsAlike() {
        Circle two;
        const auto shifted = [](double angle) { return 0.002 * std::cos(angle) - 0.001 * std::sin(angle); };
        two.add(0, 355, 72, shifted);
        two.add(355, 0, 36, shifted);
        const auto centre = centreOf(two.circle);
        QVERIFY(centre);
        QVERIFY(near(centre->x, 0.002, 1e-7) && near(centre->y, -0.001, 1e-7)); // e²/R = 5e-8
        two.circle.centre = Point{1, 2};
        QCOMPARE(centreOf(two.circle)->y, 2.0);
        QVERIFY(!centreOf(Circle().circle));
    }
};

QTEST_GUILESS_MAIN(PathRowsTest)
#include "pathrows.moc"
