// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "kernel/trend/trendline.h"

#include "core/kernel/trend/computedlines.h"
#include "core/kernel/trend/simulatedtrends.h"
#include "kernel/numerics/studentt.h"
#include "kernel/trend/notbefore.h"

#include <QTest>
#include <limits>

using namespace palmer;

namespace {

bool isNear(double actual, double expected, double relative) {
    return std::abs(actual - expected) <= relative * std::max(std::abs(expected), 1e-12);
}

/// Values on a line with equal own uncertainties.
std::vector<TrendPoint> onLine(int count, double own) {
    std::vector<TrendPoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({20.0 + i, 5.0 + 0.5 * i, own, {}});
    return points;
}

} // namespace

class TrendLineTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAnIndependentComputation_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < testdata::computedLines.size(); ++i)
            QTest::addRow("%zu points", testdata::computedLines[i].points.size()) << static_cast<int>(i);
    }
    void agreesWithAnIndependentComputation() {
        QFETCH(int, index);
        const auto &expected = testdata::computedLines[static_cast<std::size_t>(index)];
        const auto line = trendLine(expected.points);
        QVERIFY(line);
        // The script works with 50 digits; QR of a handful of points loses a few of 16.
        constexpr double tolerance = 1e-9;
        QVERIFY(isNear(line->level, expected.level, tolerance));
        QVERIFY(isNear(line->slope, expected.slope, tolerance));
        QVERIFY(isNear(line->scatter, expected.scatter, 1e-8));
        QVERIFY(isNear(*line->chi2PerDof, expected.chi2PerDof, tolerance));
        QVERIFY(isNear(std::sqrt(line->levelVariance), expected.uOfLevel, tolerance));
        QVERIFY(isNear(line->slopeUncertainty(), expected.uOfSlope, tolerance));
        QVERIFY(isNear(line->covariance, expected.covariance, 1e-7));
    }
    /// Equal own parts: the textbook's u(slope) = r/√Σ(t − t̄)².
    void ownPartsAlone() {
        const auto line = trendLine(onLine(5, 0.2));
        QVERIFY(line);
        QVERIFY(isNear(line->slope, 0.5, 1e-12));
        QVERIFY(isNear(line->slopeUncertainty(), 0.2 / std::sqrt(10.0), 1e-12));
        QVERIFY(isNear(line->uncertaintyAt(line->centre), 0.2 / std::sqrt(5.0), 1e-12));
        QCOMPARE(line->scatter, 0.0);
        QVERIFY(isNear(line->twoSided, 1.959963984540054, 1e-12));
        QVERIFY(isNear(line->oneSided, 1.6448536269514722, 1e-12));
        QVERIFY(line->isShown());
    }
    /// What one device gets wrong moves the line and does not turn it.
    void onePartForAllMovesTheLevelAlone() {
        auto points = onLine(5, 0.2);
        for (TrendPoint &point : points)
            point.shared = {{"device", 0.7}};
        const auto line = trendLine(points);
        QVERIFY(isNear(line->slopeUncertainty(), 0.2 / std::sqrt(10.0), 1e-10));
        QVERIFY(isNear(line->levelVariance, 0.2 * 0.2 / 5 + 0.7 * 0.7, 1e-10));
    }
    /// What is wrong one way in the first tests and the other way in the last turns the line: α of the
    /// machine below and above 20 °C. A part that goes with the time adds its own slope.
    void signedPartsTurnTheLine() {
        auto points = onLine(5, 0.2);
        for (TrendPoint &point : points)
            point.shared = {{"alpha", 0.5 * (point.time - 22)}};
        const auto line = trendLine(points);
        QVERIFY(isNear(line->slopeUncertainty(), std::hypot(0.2 / std::sqrt(10.0), 0.5), 1e-10));
        for (TrendPoint &point : points)
            point.shared = {{"alpha", 0.5}};
        QVERIFY(isNear(trendLine(points)->slopeUncertainty(), 0.2 / std::sqrt(10.0), 1e-10));
    }
    /// Without any uncertainty the scatter is that of ordinary least squares, s² = Σe²/(n − 2).
    void scatterIsThatOfTheResiduals() {
        const std::vector<TrendPoint> points{{0, 1, 0, {}}, {1, -1, 0, {}}, {2, -1, 0, {}}, {3, 1, 0, {}}};
        const auto line = trendLine(points);
        QVERIFY(line);
        QVERIFY(isNear(line->scatter, std::sqrt(4.0 / 2), 1e-9));
        QVERIFY(!line->chi2PerDof);
        // Nor does a U that all have in common expect any.
        std::vector<TrendPoint> alike = points;
        for (TrendPoint &point : alike)
            point.shared = {{"laser", 0.5}};
        QVERIFY(!trendLine(alike)->chi2PerDof);
        QVERIFY(isNear(line->twoSided, studentQuantile975(2), 1e-12));
        QVERIFY(isNear(line->oneSided, 2.919985580353726, 1e-9)); // t(0.95; 2)
        QVERIFY(!line->isShown());
    }
    void exactPartsWithOneDevice() {
        std::vector<TrendPoint> points;
        for (int i = 0; i < 5; ++i)
            points.push_back({20.0 + i, 3.0 + 0.25 * i, 0, {{"device", 0.4}}});
        const auto line = trendLine(points);
        QVERIFY(line);
        QVERIFY(isNear(line->slope, 0.25, 1e-6));
        QVERIFY(std::isfinite(line->slopeUncertainty()));
        QVERIFY(isNear(std::sqrt(line->levelVariance), 0.4, 1e-6));
    }
    void whatCannotBeFitted_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("fitted");
        QTest::newRow("three points") << 3 << 1.0 << 1.0 << false;
        QTest::newRow("four points") << 4 << 1.0 << 1.0 << true;
        QTest::newRow("all at one time") << 5 << 0.0 << 1.0 << false;
        QTest::newRow("not a number") << 5 << 1.0 << std::numeric_limits<double>::quiet_NaN() << false;
        QTest::newRow("infinite") << 5 << 1.0 << std::numeric_limits<double>::infinity() << false;
    }
    void whatCannotBeFitted() {
        QFETCH(int, count);
        QFETCH(double, step);
        QFETCH(double, value);
        QFETCH(bool, fitted);
        std::vector<TrendPoint> points;
        for (int i = 0; i < count; ++i)
            points.push_back({20.0 + i * step, value, 0.1, {}});
        QCOMPARE(trendLine(points).has_value(), fitted);
    }
    void equalValuesShowNoTrend() {
        std::vector<TrendPoint> points;
        for (int i = 0; i < 6; ++i)
            points.push_back({20.0 + i, 7.5, 0, {}});
        const auto line = trendLine(points);
        QVERIFY(line);
        QVERIFY(!line->isShown());
    }
    /// The bound reaches the limit where line + t·u does, from the last value on, up to twice the time seen.
    void notBeforeSolvesTheBound() {
        const auto line = trendLine(onLine(6, 0.1)); // 5 … 7.5 in 2020 … 2025
        for (const double limit : {7.9, 8.5, 9.7}) {
            const NotBefore earliest = notBefore(*line, {limit, {}});
            QCOMPARE(earliest.state, NotBefore::State::date);
            const double bound =
                line->at(earliest.time) + line->oneSided * line->uncertaintyAt(earliest.time);
            QVERIFY(isNear(bound, limit, 1e-7));
            QVERIFY(earliest.time > line->last && earliest.time < trendHorizon(*line));
        }
        QCOMPARE(trendHorizon(*line), 30.0);
        QCOMPARE(notBefore(*line, {10.4, {}}).state, NotBefore::State::beyond);
        QCOMPARE(notBefore(*line, {7.5, {}}).state, NotBefore::State::already);
        QCOMPARE(notBefore(*line, {}).state, NotBefore::State::noLimit);
        // A reserve is a nearer limit.
        QCOMPARE(notBefore(*line, {8.9, {}}, 0.4).time, notBefore(*line, {8.5, {}}).time);
    }
    void lowerLimitsMirrorUpperOnes() {
        auto points = onLine(6, 0.1);
        const NotBefore up = notBefore(*trendLine(points), {9.0, {}}, 0.2);
        for (TrendPoint &point : points)
            point.value = -point.value;
        const NotBefore down = notBefore(*trendLine(points), {{}, -9.0}, 0.2);
        QCOMPARE(down.state, up.state);
        QVERIFY(isNear(down.time, up.time, 1e-9));
    }
    /// 400 trials each: the bounds are those of the binomial distribution, 95 % − 4 deviations.
    void whatIsSaidHolds_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(std::size(testdata::situations)); ++i)
            QTest::newRow(testdata::situations[i].name) << i;
    }
    void whatIsSaidHolds() {
        QFETCH(int, index);
        constexpr int trials = 400;
        const auto coverage =
            testdata::coverageOf(testdata::situations[index], trials, static_cast<unsigned>(index) + 1);
        QCOMPARE(coverage.trials, trials);
        const auto least = [](int of) { return 0.95 * of - 4 * std::sqrt(0.95 * 0.05 * of); };
        QVERIFY2(coverage.slopeHolds >= least(trials), qPrintable(QString::number(coverage.slopeHolds)));
        QVERIFY2(coverage.levelHolds >= least(trials), qPrintable(QString::number(coverage.levelHolds)));
        QVERIFY2(coverage.datesHold >= least(coverage.dates),
                 qPrintable(QString::number(coverage.datesHold)));
    }
};

QTEST_GUILESS_MAIN(TrendLineTest)
#include "trendline.moc"
