// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "kernel/typetest/typetest.h"

#include "core/kernel/typetest/computedtypes.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace palmer;

namespace {

bool isNear(double actual, double expected, double relative) {
    return std::abs(actual - expected) <= relative * std::abs(expected);
}

} // namespace

class TypeTestTest : public QObject {
    Q_OBJECT

private slots:
    void factorsAgreeWithAnIndependentComputation() {
        for (const auto &row : testdata::computedFactors) {
            const double k = toleranceFactor(row.count, {row.content, row.confidence});
            // Boost.Math solves for the quantile to about half the digits of a double.
            QVERIFY2(isNear(k, row.factor, 1e-8), qPrintable(QString::number(k, 'g', 12)));
        }
    }
    /// The tables of one-sided factors, four decimals.
    void factorsOfTheTables() {
        struct Row {
            std::size_t count;
            Tolerance tolerance;
            double k;
        };
        for (const Row &row :
             {Row{3, {}, 7.6559}, Row{5, {}, 4.2027}, Row{10, {}, 2.9110}, Row{20, {}, 2.3960},
              Row{50, {}, 2.0650}, Row{100, {}, 1.9265}, Row{10, {0.90, 0.95}, 2.3546},
              Row{10, {0.99, 0.95}, 3.9811}, Row{10, {0.95, 0.90}, 2.5684}})
            QVERIFY(std::abs(toleranceFactor(row.count, row.tolerance) - row.k) < 0.5e-4 + 1e-9);
    }
    void statisticsAgreeWithAnIndependentComputation() {
        constexpr double tolerance = 1e-8; // that of the factor
        for (const auto &row : testdata::computedTypes) {
            const auto type = typeStatistics(row.values, {});
            QVERIFY(type);
            QVERIFY(isNear(type->mean, row.mean, 1e-13));
            QVERIFY(isNear(type->s, row.s, 1e-12));
            QVERIFY(isNear(*type->normalLimit, row.normalLimit, tolerance));
            QVERIFY(isNear(*type->logNormalLimit, row.logNormalLimit, tolerance));
            QVERIFY(isNear(type->normality->w, row.w, 1e-12));
            QVERIFY(isNear(type->normality->probability, row.probability, 1e-9));
            QVERIFY(isNear(type->logNormality->w, row.wOfLogarithms, 1e-12));
            QVERIFY(isNear(type->logNormality->probability, row.probabilityOfLogarithms, 1e-9));
            QCOMPARE(type->normality->doubtful, row.probability < 0.05);
        }
    }
    void medianAndOrder() {
        const auto odd = typeStatistics(std::vector{3.0, 1.0, 2.5}, {});
        QVERIFY(odd->sorted == (std::vector{1.0, 2.5, 3.0}));
        QCOMPARE(odd->median, 2.5);
        QCOMPARE(typeStatistics(std::vector{3.0, 1.0, 2.5, 2.0}, {})->median, 2.25);
        QVERIFY(isNear(odd->confidenceOfLargest, 1 - 0.95 * 0.95 * 0.95, 1e-12));
        QVERIFY(
            isNear(typeStatistics(std::vector<double>(59, 1.0), {})->confidenceOfLargest, 0.951505, 1e-5));
        QVERIFY(isNear(normalScore(0, 3), -normalScore(2, 3), 1e-12));
    }
    /// Each thing that the values do not carry is null.
    void whatTheValuesDoNotCarry() {
        QVERIFY(!typeStatistics(std::vector{1.0, 2.0}, {}));
        const auto few = typeStatistics(std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}, {});
        QVERIFY(few->normalLimit && few->logNormalLimit && !few->normality && !few->logNormality);
        const auto equal = typeStatistics(std::vector<double>(9, 4.0), {});
        QVERIFY(!equal->normalLimit && !equal->logNormalLimit && !equal->normality);
        const auto zero = typeStatistics(std::vector{0.0, 1.0, 2.0}, {});
        QVERIFY(zero->normalLimit && !zero->logNormalLimit);
        QVERIFY(!zero->limit(TypeDistribution::logNormal) && zero->limit(TypeDistribution::normal));
    }
    /// Log-normal values, coefficient of variation 0.3: the normal limit claims a confidence it does not
    /// have.
    void confidenceOfBothLimits_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("ofNormal");
        QTest::newRow("10 machines") << 10 << 0.83;
        QTest::newRow("30 machines") << 30 << 0.76;
    }
    void confidenceOfBothLimits() {
        QFETCH(int, count);
        QFETCH(double, ofNormal);
        constexpr int trials = 20000;
        const double sigma = std::sqrt(std::log1p(0.3 * 0.3));
        const double quantile = std::exp(1.6448536269514722 * sigma); // 95 % of the type lie below
        std::mt19937_64 random(5);
        std::normal_distribution<double> normal;
        int normalHolds = 0;
        int logNormalHolds = 0;
        std::vector<double> values(static_cast<std::size_t>(count));
        const double k = toleranceFactor(values.size(), {});
        for (int trial = 0; trial < trials; ++trial) {
            double sum = 0;
            double squares = 0;
            double logSum = 0;
            double logSquares = 0;
            for (double &value : values) {
                const double logarithm = sigma * normal(random);
                value = std::exp(logarithm);
                sum += value;
                squares += value * value;
                logSum += logarithm;
                logSquares += logarithm * logarithm;
            }
            const auto limit = [&](double a, double b) {
                return a / count + k * std::sqrt((b - a * a / count) / (count - 1));
            };
            if (trial == 0) { // the sums stand for the program's limits
                const auto type = typeStatistics(values, {});
                QVERIFY(isNear(limit(sum, squares), *type->normalLimit, 1e-10));
                QVERIFY(isNear(std::exp(limit(logSum, logSquares)), *type->logNormalLimit, 1e-10));
            }
            normalHolds += limit(sum, squares) >= quantile ? 1 : 0;
            logNormalHolds += std::exp(limit(logSum, logSquares)) >= quantile ? 1 : 0;
        }
        qInfo("normal %.4f, log-normal %.4f", double(normalHolds) / trials, double(logNormalHolds) / trials);
        // 20 000 trials: 3 standard deviations are below 0.01; 0.005 for the rounding of the expected value.
        QVERIFY(std::abs(double(normalHolds) / trials - ofNormal) < 0.015);
        QVERIFY(std::abs(double(logNormalHolds) / trials - 0.95) < 0.005);
    }
};

QTEST_GUILESS_MAIN(TypeTestTest)
#include "typetest.moc"
