// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/thinning.h"

#include <QTest>
#include <limits>
#include <random>
#include <set>

using namespace palmer;

namespace {

constexpr std::size_t mostDrawn = 8000; ///< points of a line: 1 MB of SVG holds a dozen such lines

/// A figure with curves and limits of both directions, with gaps, and `runs` marks a target.
CurveFigure figureOf(int targets, int runs, double gaps, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise;
    std::uniform_real_distribution<double> uniform;
    CurveFigure figure;
    figure.x.from = -1;
    figure.x.to = targets;
    for (int i = 0; i < targets; ++i)
        figure.positions.push_back(i);
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
        bool open = false;
        for (int i = 0; i < targets; ++i) {
            if (uniform(random) < gaps) {
                open = false;
                continue;
            }
            if (!open) {
                figure.curves.push_back({role, {}});
                figure.bands.push_back({role, {}});
            }
            open = true;
            const double mean = noise(random);
            const double half = 1 + uniform(random);
            figure.curves.back().points.push_back({double(i), mean, i + 1});
            figure.bands.back().points.push_back({double(i), mean - half, mean + half});
            for (int j = 0; j < runs; ++j) {
                const double y = mean + noise(random);
                figure.readings.push_back({role, double(i), y, i + 1, j + 1});
                least = std::min(least, y);
                greatest = std::max(greatest, y);
            }
        }
    }
    figure.y.from = std::min(least, -10.0) - 1;
    figure.y.to = std::max(greatest, 10.0) + 1;
    return figure;
}

template <class Line>
std::size_t pointsOf(const std::vector<Line> &lines) {
    std::size_t count = 0;
    for (const Line &line : lines)
        count += line.points.size();
    return count;
}

/// Whether all of `part` stands in `whole` in the same order.
template <class Value>
bool isPartOf(const std::vector<Value> &part, const std::vector<Value> &whole) {
    auto at = whole.begin();
    for (const Value &value : part) {
        at = std::find(at, whole.end(), value);
        if (at == whole.end())
            return false;
        ++at;
    }
    return true;
}

template <class Line>
auto pointsIn(const std::vector<Line> &lines, CurveRole role) {
    std::vector<typename decltype(Line::points)::value_type> points;
    for (const Line &line : lines) {
        if (line.role == role)
            points.insert(points.end(), line.points.begin(), line.points.end());
    }
    return points;
}

std::vector<ReadingMark> marksIn(const CurveFigure &figure, CurveRole role) {
    std::vector<ReadingMark> marks;
    for (const ReadingMark &mark : figure.readings) {
        if (mark.role == role)
            marks.push_back(mark);
    }
    return marks;
}

template <class Points>
std::pair<double, double> extremes(const Points &points, auto &&low, auto &&high) {
    std::pair result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const auto &point : points) {
        result.first = std::min(result.first, low(point));
        result.second = std::max(result.second, high(point));
    }
    return result;
}

} // namespace

/// Figures of many points are drawn with as many as paper resolves.
class ThinningTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsSaidOfAFigureStays() {
        CurveFigure figure = figureOf(50, 2000, 0, 3);
        figure.note = QStringLiteral("limits beyond the scale: A 32 µm");
        QVERIFY(!isOrdinary(figure));
        QCOMPARE(thinned(figure).note, figure.note);
    }

    void anOrdinaryFigureStaysAsItIs() {
        for (const auto &[targets, runs] : {std::pair{1, 1}, {11, 5}, {500, 4}, {4000, 0}}) {
            const CurveFigure figure = figureOf(targets, runs, 0.1, 1);
            QVERIFY(isOrdinary(figure));
            QVERIFY(thinned(figure) == figure);
        }
        QVERIFY(!isOrdinary(figureOf(4001, 0, 0, 1)));
        QVERIFY(!isOrdinary(figureOf(10, 201, 0, 1)));
    }

    void extremesAndEndsStay_data() {
        QTest::addColumn<int>("targets");
        QTest::addColumn<int>("runs");
        QTest::addColumn<double>("gaps");
        QTest::newRow("many targets") << 50000 << 1 << 0.0;
        QTest::newRow("every second target missing") << 50000 << 1 << 0.5;
        QTest::newRow("most targets missing") << 100000 << 0 << 0.9;
        QTest::newRow("many runs") << 10 << 20000 << 0.0;
        QTest::newRow("as many of both") << 700 << 300 << 0.01;
    }
    void extremesAndEndsStay() {
        QFETCH(const int, targets);
        QFETCH(const int, runs);
        QFETCH(const double, gaps);
        CurveFigure figure = figureOf(targets, runs, gaps, 7);
        figure.dimensions.push_back({{}, {}, 0, 1, 3, double(targets / 2), DimensionPlace::gutter});
        const CurveFigure drawn = thinned(figure);
        QVERIFY(drawn.readings.size() <= 4000);
        for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
            const auto all = pointsIn(figure.curves, role);
            const auto kept = pointsIn(drawn.curves, role);
            QVERIFY(kept.size() <= mostDrawn);
            QVERIFY(isPartOf(kept, all));
            QCOMPARE(kept.front(), all.front());
            QCOMPARE(kept.back(), all.back());
            const auto y = [](const FigurePoint &point) { return point.y; };
            QCOMPARE(extremes(kept, y, y), extremes(all, y, y));

            const auto limits = pointsIn(figure.bands, role);
            const auto keptLimits = pointsIn(drawn.bands, role);
            QVERIFY(keptLimits.size() <= mostDrawn);
            QVERIFY(isPartOf(keptLimits, limits));
            const auto low = [](const BandPoint &point) { return point.lower; };
            const auto high = [](const BandPoint &point) { return point.upper; };
            QCOMPARE(extremes(keptLimits, low, high), extremes(limits, low, high));
            for (const double ruling : {3.0, double(targets / 2)}) {
                const auto there = [&](const auto &point) { return point.x == ruling; };
                QCOMPARE(std::ranges::any_of(kept, there), std::ranges::any_of(all, there));
                QCOMPARE(std::ranges::any_of(keptLimits, there), std::ranges::any_of(limits, there));
            }

            const auto marks = marksIn(figure, role);
            const auto keptMarks = marksIn(drawn, role);
            const auto value = [](const ReadingMark &mark) { return mark.y; };
            QVERIFY(isPartOf(keptMarks, marks));
            QCOMPARE(extremes(keptMarks, value, value), extremes(marks, value, value));
        }
        QCOMPARE(drawn.positions.size(), figure.positions.size());
    }

    /// A line of two points or more never shrinks to one, which would be drawn as something else.
    void linesStayLines() {
        const CurveFigure figure = figureOf(100000, 0, 0.2, 3);
        for (const Curve &curve : thinned(figure).curves) {
            if (curve.points.size() > 1)
                continue;
            const bool wasAlone = std::ranges::any_of(figure.curves, [&](const Curve &before) {
                return before.role == curve.role && before.points == curve.points;
            });
            QVERIFY(wasAlone);
        }
    }

    /// Wherever there is a mark, one is drawn nearby: within a twentieth of the height and a fortieth of the
    /// width.
    void marksCoverTheSameGround() {
        const CurveFigure figure = figureOf(1000, 200, 0, 5);
        const CurveFigure drawn = thinned(figure);
        const auto places = [&](const CurveFigure &of) {
            std::set<std::tuple<int, int, int>> result;
            for (const ReadingMark &mark : of.readings)
                result.emplace(int(mark.role), int((mark.x - of.x.from) / (of.x.to - of.x.from) * 40),
                               int((mark.y - of.y.from) / (of.y.to - of.y.from) * 20));
            return result;
        };
        const auto kept = places(drawn);
        for (const auto &[role, column, row] : places(figure)) {
            bool near = false;
            for (int dx = -1; dx <= 1; ++dx) {
                for (int dy = -1; dy <= 1; ++dy)
                    near |= kept.contains({role, column + dx, row + dy});
            }
            QVERIFY(near);
        }
        QVERIFY(std::ranges::includes(places(figure), kept));
    }

    /// Zoomed in, what is shown has its details again.
    void theRangeShownCounts() {
        CurveFigure figure = figureOf(100000, 1, 0, 9);
        figure.x.from = 50000;
        figure.x.to = 50100;
        const CurveFigure drawn = thinned(figure);
        const auto inside = [](const auto &points) {
            return std::ranges::count_if(points, [](const auto &p) { return p.x >= 50000 && p.x <= 50100; });
        };
        for (const CurveRole role : {CurveRole::up, CurveRole::down}) {
            QCOMPARE(inside(pointsIn(drawn.curves, role)), 101);
            QCOMPARE(inside(marksIn(drawn, role)), 101);
        }
        QVERIFY(pointsOf(drawn.curves) < mostDrawn);
    }

    void timesInAnyOrder() {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> uniform;
        CurveFigure figure;
        figure.x.to = 1;
        Curve curve{CurveRole::drift, {}};
        for (int i = 0; i < 20000; ++i)
            curve.points.push_back({uniform(random), uniform(random), i + 1});
        figure.curves.push_back(curve);
        const auto kept = pointsIn(thinned(figure).curves, CurveRole::drift);
        const auto y = [](const FigurePoint &point) { return point.y; };
        QVERIFY(isPartOf(kept, curve.points));
        QCOMPARE(extremes(kept, y, y), extremes(curve.points, y, y));
    }

    void equalValuesAreOneLine() {
        CurveFigure figure;
        figure.x.to = 0.5e6;
        Curve curve{CurveRole::drift, {}};
        for (int i = 0; i < 500000; ++i)
            curve.points.push_back({double(i), 1, i + 1});
        figure.curves.push_back(std::move(curve));
        QVERIFY(pointsOf(thinned(figure).curves) < mostDrawn);
    }
};

QTEST_GUILESS_MAIN(ThinningTest)
#include "thinning.moc"
