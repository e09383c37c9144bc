// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/statistics.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace palmer;

class Statistics : public QObject {
    Q_OBJECT

private slots:
    void nistNumAcc_data();
    void nistNumAcc();
    void undefinedStaysUndefined();
    void missingReadingsAreLeftOut();
    void rangeFactors();
    void agreesWithLongDouble();
    void repeatabilityOfTarget();
};

namespace {

TargetStatistics ofOneTarget(const std::vector<double> &values) {
    TargetStatistics result;
    statistics({values, {}, 1}, DeviationMethod::calculation, std::span(&result, 1));
    return result;
}

} // namespace

void Statistics::nistNumAcc_data() {
    QTest::addColumn<double>("centre");
    QTest::addColumn<double>("step");
    QTest::addColumn<int>("pairs");
    QTest::addColumn<double>("mean");
    QTest::addColumn<double>("s");
    QTest::addColumn<double>("tolerance");
    // NIST StRD, univariate: centre, then pairs centre ∓ step; certified mean and standard deviation. The
    // later sets are limited by their decimals, which doubles cannot hold.
    QTest::newRow("NumAcc1") << 10000002.0 << 1.0 << 1 << 10000002.0 << 1.0 << 1e-12;
    QTest::newRow("NumAcc2") << 1.2 << 0.1 << 500 << 1.2 << 0.1 << 1e-12;
    QTest::newRow("NumAcc3") << 1000000.2 << 0.1 << 500 << 1000000.2 << 0.1 << 1e-9;
    QTest::newRow("NumAcc4") << 10000000.2 << 0.1 << 500 << 10000000.2 << 0.1 << 1e-8;
}

void Statistics::nistNumAcc() {
    QFETCH(double, centre);
    QFETCH(double, step);
    QFETCH(int, pairs);
    QFETCH(double, mean);
    QFETCH(double, s);
    QFETCH(double, tolerance);
    // as published: decimals, not sums of doubles
    const auto decimal = [](double x) { return std::round(x * 10) / 10; };
    std::vector<double> values{centre};
    for (int k = 0; k < pairs; ++k) {
        values.push_back(decimal(centre - step));
        values.push_back(decimal(centre + step));
    }
    const DirectionStatistics found = ofOneTarget(values).positive;
    QCOMPARE(found.n, 2 * pairs + 1);
    QVERIFY(std::abs(found.mean - mean) <= 1e-12 * mean);
    QVERIFY(std::abs(found.s - s) <= tolerance * s);
}

void Statistics::undefinedStaysUndefined() {
    const TargetStatistics none = ofOneTarget({});
    QCOMPARE(none.positive.n, 0);
    QVERIFY(std::isnan(none.positive.mean) && std::isnan(none.positive.s) && std::isnan(none.positive.range));
    const TargetStatistics one = ofOneTarget({0.25});
    QCOMPARE(one.positive.mean, 0.25);
    QCOMPARE(one.positive.range, 0.0);
    QVERIFY(std::isnan(one.positive.s));
    QVERIFY(std::isnan(one.mean()) && std::isnan(one.reversal()) && std::isnan(repeatability(one, 2)));
}

void Statistics::missingReadingsAreLeftOut() {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    // two targets, three runs
    const std::vector<double> table{1, missing, missing, 4, 3, 6};
    std::vector<TargetStatistics> result(2);
    statistics({table, {}, 2}, DeviationMethod::calculation, result);
    QCOMPARE(result[0].positive.n, 2);
    QCOMPARE(result[0].positive.mean, 2.0);
    QCOMPARE(result[0].positive.s, std::sqrt(2.0));
    QCOMPARE(result[1].positive.n, 2);
    QCOMPARE(result[1].positive.mean, 5.0);
}

void Statistics::rangeFactors() {
    const double published[]{1.128, 1.693, 2.059, 2.326, 2.534, 2.704, 2.847, 2.970, 3.078};
    for (int n = 2; n <= 10; ++n)
        QCOMPARE(*rangeFactor(n), published[n - 2]);
    QVERIFY(!rangeFactor(1) && !rangeFactor(11) && !rangeFactor(0));
    const std::vector<double> table{1, 4, 2};
    TargetStatistics result;
    statistics({table, {}, 1}, DeviationMethod::range, std::span(&result, 1));
    QCOMPARE(result.positive.s, 3 / 1.693);
}

void Statistics::agreesWithLongDouble() {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> exponent(-6, 6);
    for (int round = 0; round < 5000; ++round) {
        const std::size_t n = 2 + static_cast<std::size_t>(round) % 12;
        const double offset = std::pow(10.0, exponent(random));
        const double scale = std::pow(10.0, exponent(random));
        std::vector<double> values;
        for (std::size_t k = 0; k < n; ++k)
            values.push_back(offset + scale * normal(random));
        long double sum = 0;
        for (const double x : values)
            sum += x;
        const long double mean = sum / static_cast<long double>(n);
        long double squares = 0;
        for (const double x : values)
            squares += (x - mean) * (x - mean);
        const double s = static_cast<double>(std::sqrt(squares / static_cast<long double>(n - 1)));
        const DirectionStatistics found = ofOneTarget(values).positive;
        const double eps = std::numeric_limits<double>::epsilon();
        const double size = std::abs(offset) + scale * 5;
        QVERIFY(std::abs(found.mean - static_cast<double>(mean)) <= 2 * eps * size); // one rounding, not n
        QVERIFY(std::abs(found.s - s) <= 16 * eps * s); // no loss by cancellation
    }
}

void Statistics::repeatabilityOfTarget() {
    const auto target = [](double up, double down, double b) {
        return TargetStatistics{{5, b, up, 0}, {5, 0, down, 0}};
    };
    QCOMPARE(repeatability(target(1, 1, -3), 2), 7.0);   // both bands and the reversal
    QCOMPARE(repeatability(target(5, 1, 0.5), 2), 20.0); // the wider direction alone
    QCOMPARE(repeatability(target(1, 5, 0.5), 3), 30.0);
}

QTEST_GUILESS_MAIN(Statistics)
#include "statistics.moc"
