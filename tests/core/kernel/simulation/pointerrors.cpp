// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/pointerrors.h"

#include "kernel/numerics/normalquantile.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace palmer;

/// Errors of the points of a trial, drawn side by side.
class PointErrorsTest : public QObject {
    Q_OBJECT

private slots:
    void fromTheWordsOfTheirPlaces_data();
    void fromTheWordsOfTheirPlaces();
};

void PointErrorsTest::fromTheWordsOfTheirPlaces_data() {
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("resolution");
    QTest::newRow("noise") << 0.1 << 0.0;
    QTest::newRow("resolution") << 0.0 << 0.1;
    QTest::newRow("both") << 0.02 << 0.5;
    QTest::newRow("none") << 0.0 << 0.0;
}

void PointErrorsTest::fromTheWordsOfTheirPlaces() {
    QFETCH(double, noise);
    QFETCH(double, resolution);
    for (const std::size_t n : {1U, 7U, 8U, 9U, 255U, 256U, 257U, 1800U}) {
        QVERIFY(placesOfPoints(n) * 2 >= n);
        for (const long long trial : {0LL, 5LL, 0x1234567890LL}) {
            const RandomDraws draws(42);
            const std::uint32_t place = 64;
            std::vector<double> wide(n, -1);
            std::vector<double> narrow(n, -2);
            drawPointErrors(draws, trial, place, {noise, resolution}, wide);
            drawPointErrorsNarrow(draws, trial, place, {noise, resolution}, narrow);
            QVERIFY(wide == narrow);
            for (std::size_t i = 0; i < n; ++i) {
                const auto words = draws.words(trial, place + static_cast<std::uint32_t>(i / 8 * 4 + i % 4));
                const std::size_t half = i % 8 / 4;
                const double normal = normalQuantile((RandomDraws::symmetric(words[half]) + 1) / 2);
                const double expected =
                    noise * normal + resolution / 2 * RandomDraws::symmetric(words[2 + half]);
                // The logarithm is another one, right to a unit of the last place: 2e-16 of √−ln p, and what
                // the quantile makes of it.
                QVERIFY(std::abs(wide[i] - expected) <= 2e-15 * (noise * std::abs(normal) + resolution));
            }
        }
    }
}

QTEST_APPLESS_MAIN(PointErrorsTest)
#include "pointerrors.moc"
