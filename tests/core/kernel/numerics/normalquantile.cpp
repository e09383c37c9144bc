// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/normalquantile.h"

#include <QTest>

#include <cmath>

using namespace palmer;

/// The normal deviate against the distribution function it inverts.
class NormalQuantileTest : public QObject {
    Q_OBJECT

private slots:
    void invertsTheDistributionFunction();
    void lanesGiveTheSame();
};

void NormalQuantileTest::invertsTheDistributionFunction() {
    for (double z = -6.5; z <= 6.5; z += 0.001) {
        const double p = 0.5 * std::erfc(-z / std::sqrt(2.0));
        // erfc is good to some ulp of p; p near 1 is known to half an ulp only, which is density⁻¹ as much in
        // z.
        const double density = std::exp(-z * z / 2) / 2.5066282746310002;
        const double tolerance = 1e-14 + (z > 0 ? 2.3e-16 / density : 0);
        QVERIFY2(std::abs(normalQuantile(p) - z) <= tolerance, qPrintable(QString::number(z)));
    }
}

void NormalQuantileTest::lanesGiveTheSame() {
    for (double q = -0.9999; q < 0.9999; q += 0.0007) {
        const auto found = normalQuantileOfSymmetric(Lanes::from({q, -q, q / 2, q * q})).values();
        const std::array expected{(1 + q) / 2, (1 - q) / 2, (1 + q / 2) / 2, (1 + q * q) / 2};
        for (std::size_t k = 0; k < found.size(); ++k) {
            // 1 + q was rounded: the density of the tails makes more of it.
            const double z = normalQuantile(expected[k]);
            const double tolerance = 1e-15 + 3e-16 * std::exp(z * z / 2);
            QVERIFY2(std::abs(found[k] - z) <= tolerance, qPrintable(QString::number(q)));
        }
    }
}

QTEST_APPLESS_MAIN(NormalQuantileTest)
#include "normalquantile.moc"
