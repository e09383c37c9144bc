// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/outliers.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "editing/editreadings.h"

#include <QTest>
#include <random>

using namespace palmer;
using namespace palmer::testdata;

namespace {

/// 11 targets, 5 runs each way, normal readings of 1 µm.
PositioningMeasurement normalReadings(unsigned seed) {
    std::mt19937 random(seed); // NOLINT: the same every time
    std::normal_distribution<double> noise(0, 1);
    std::vector<double> targets;
    std::vector<std::vector<double>> up(5);
    std::vector<std::vector<double>> down(5);
    for (int i = 0; i < 11; ++i) {
        targets.push_back(i * 100.0);
        for (std::size_t j = 0; j < 5; ++j) {
            up[j].push_back(i + noise(random));
            down[j].push_back(i + 3 + noise(random));
        }
    }
    Test test = positioningTest("ISO 230-2:2014", targets, up, down);
    return measurement(test);
}

} // namespace

class OutliersTest : public QObject {
    Q_OBJECT

private slots:
    void silentAboutThePublishedExample() {
        Test test = example1988("ISO 230-2:1988");
        QVERIFY(outlierHints(measurement(test)).empty());
    }

    void findsOneTypingError_data() {
        QTest::addColumn<double>("value");
        QTest::newRow("a decimal mark lost") << -0.058;
        QTest::newRow("ten times too large") << 0.5;
        QTest::newRow("a beam interrupted") << 95.4;
    }

    void findsOneTypingError() {
        QFETCH(double, value);
        Test test = example1988("ISO 230-2:1988");
        setReading(measurement(test), {3, 6}, value);
        const auto hints = outlierHints(measurement(test));
        QCOMPARE(hints.size(), std::size_t{1}); // and not the readings beside it
        QCOMPARE(hints[0].place, (ReadingPlace{3, 6}));
        QVERIFY(std::abs(hints[0].distance - (value + 0.0045)) < 0.0015); // the others: −5.8 … −3.3 µm
    }

    void rarelyDoubtsGoodReadings() {
        int hints = 0;
        for (unsigned seed = 1; seed <= 200; ++seed)
            hints += static_cast<int>(outlierHints(normalReadings(seed)).size());
        QVERIFY2(hints <= 4, qPrintable(QString::number(hints))); // of 22 000 readings
    }

    void needsEnoughToCompareWith() {
        Test two = positioningTest("ISO 230-2:2014", {0, 100}, {{1, 2}, {900, 2}}, {});
        QVERIFY(outlierHints(measurement(two)).empty());
        QVERIFY(outlierHints({}).empty());
        Test equal =
            positioningTest("ISO 230-2:2014", {0, 1, 2, 3}, {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 9, 1}}, {});
        QVERIFY(outlierHints(measurement(equal)).empty()); // no scale
    }
};

QTEST_GUILESS_MAIN(OutliersTest)
#include "outliers.moc"
