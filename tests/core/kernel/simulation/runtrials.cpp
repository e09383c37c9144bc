// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/runtrials.h"

#include <QTest>

#include <cmath>

using namespace palmer;

/// What is made of the trials: intervals, pictures, averages of blocks.
class RunTrialsTest : public QObject {
    Q_OBJECT

private slots:
    void placesOfValues() {
        const FineCounts fine{10, 0.5};
        const auto index = [&](double value) { return fine.index(value, 1 / fine.width); };
        QCOMPARE(index(10), std::size_t(0));
        QCOMPARE(index(10.49), std::size_t(0));
        QCOMPARE(index(10.5), std::size_t(1));
        QCOMPARE(index(9), std::size_t(0)); // what lies outside is counted at the ends
        QCOMPARE(index(10 + 0.5 * 8191), std::size_t(8191));
        QCOMPARE(index(1e6), std::size_t(8191));
    }

    void shortestIntervals_data() {
        QTest::addColumn<QList<qlonglong>>("counts");
        QTest::addColumn<double>("low"); // in intervals of the counts
        QTest::addColumn<double>("high");
        using Counts = QList<qlonglong>;
        // 95.45 % of 100 in intervals of 1: any 95.45 of them, the first are taken
        QTest::newRow("even") << Counts(100, 1) << 0.0 << 95.45;
        QTest::newRow("one interval") << Counts{0, 0, 1000} << 2.0 << 2.9545;
        // 954.5 of 1 000: 950 and 4.5 of the last 50; from the second on there are but 950
        QTest::newRow("all three") << Counts{50, 900, 50} << 0.0 << 2 + 4.5 / 50;
        // 95.45 of 100: without the 3 it is 40 and 55.45 of the 57, which is shorter than 43 and 52.45
        QTest::newRow("the last two") << Counts{3, 40, 57} << 1.0 << 2 + 55.45 / 57;
        // 19.09 of 20: there is nothing behind the 19
        QTest::newRow("too little behind") << Counts{1, 19, 0, 0} << 0.0 << 1 + 18.09 / 19;
        QTest::newRow("nothing counted") << Counts{0, 0} << 0.0 << 0.0;
    }

    void shortestIntervals() {
        QFETCH(QList<qlonglong>, counts);
        QFETCH(double, low);
        QFETCH(double, high);
        const std::vector<long long> numbers(counts.begin(), counts.end());
        const CoverageInterval found = shortestInterval({10, 2}, numbers);
        QVERIFY(std::abs(found.low - (10 + 2 * low)) < 1e-12);
        QVERIFY(std::abs(found.high - (10 + 2 * high)) < 1e-12);
        const CoverageInterval alike = shortestInterval({10, 0}, numbers);
        QCOMPARE(alike.low, 10.0);
        QCOMPARE(alike.high, 10.0);
    }

    void pictures() {
        // ± 8 u in 8 192 intervals; the picture shows ± 4 u in 64: it leaves out 2 048 each side, 64 make one
        const FineCounts fine{-8, 16.0 / 8192};
        const struct {
            std::size_t fine;
            std::size_t interval;
        } places[]{{0, 0},     {2047, 0},  {2048, 0},  {2111, 0},  {2112, 1}, {4095, 31},
                   {4096, 32}, {6079, 62}, {6080, 63}, {6144, 63}, {8191, 63}};
        for (const auto &[place, interval] : places) {
            std::vector<long long> counts(FineCounts::count);
            counts[place] = 7;
            const Histogram picture = histogram(fine, counts);
            std::vector<long long> expected(64);
            expected[interval] = 7;
            QCOMPARE(picture.counts, expected);
            QCOMPARE(picture.from, -4.0);
            QCOMPARE(picture.width, 0.125);
        }
    }

    void errorsOfAverages() {
        QVERIFY(!errorOfAverage({}) && !errorOfAverage(std::vector{5.0}));
        QCOMPARE(*errorOfAverage(std::vector{1.0, 3.0}), 1.0);                      // √((1 + 1)/(2·1))
        QCOMPARE(*errorOfAverage(std::vector{1.0, 2.0, 6.0}), std::sqrt(14.0 / 6)); // √((4 + 1 + 9)/(3·2))
    }

    void stableWhenTwiceTheErrorIsTolerated() {
        const std::vector<double> quiet{3, 3};
        const auto averages = [&](int which, double step) {
            BlockAverages result{quiet, quiet, quiet, quiet, quiet};
            std::vector<double> *all[]{&result.means, &result.u, &result.low, &result.high, &result.expanded};
            *all[which] = {0, step}; // the error of their average is step/2
            return result;
        };
        for (int which = 0; which < 5; ++which) {
            QVERIFY(averages(which, 1).stable(1));
            QVERIFY(!averages(which, 1).stable(0.999));
            // values that come out alike but for the last digits: 1e-12
            QVERIFY(averages(which, 0.99e-12).stable(0));
            QVERIFY(!averages(which, 1.01e-12).stable(0));
        }
        const std::vector<double> one{3};
        QVERIFY(!BlockAverages({one, one, one, one, one}).stable(1));
    }

    void blocksOfFixedNumbers() {
        QCOMPARE(fixedBlock(1), 10'000LL);
        QCOMPARE(fixedBlock(10'000'000), 10'000LL); // 1 000 blocks
        QCOMPARE(fixedBlock(10'000'001), 20'000LL);
        QCOMPARE(fixedBlock(1'000'000'000), 1'000'000LL);
    }

    void moments() {
        Moments all;
        QCOMPARE(all.mean(), 0.0);
        all.add({2, 4, 1});
        QCOMPARE(all.deviation(), 0.0);
        all.add({7, 37, 2}); // 2, then 1 and 6: mean 3, squares 1 + 4 + 9 = 14
        QCOMPARE(all.count, 3LL);
        QCOMPARE(all.mean(), 3.0);
        QCOMPARE(all.deviation(), std::sqrt(7.0));
    }
};

QTEST_APPLESS_MAIN(RunTrialsTest)
#include "runtrials.moc"
