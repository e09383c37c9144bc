// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pitchscan.h"

#include "core/kernel/diagnosis/coverage.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace palmer;

class PitchScanTest : public QObject {
    Q_OBJECT

private slots:
    /// The scan by Fourier transforms finds what a sum over all readings finds.
    void theScanFindsThePitch() {
        CircularSynthesis asked;
        asked.points = 720;
        asked.sources = {{InfluenceId::cyclic, PlaneAxis::second, 2e-3, 23.7, 0.4}};
        const testdata::MadeCircle made(synthesizeCircular(asked));
        const DiagnosedCircle circle = made.circle();
        const Point centre{};
        const PathRows rows({&circle, 1}, {&centre, 1}, 0, 0);
        const InfluenceFit fit(rows, {{InfluenceId::radius}});
        const PitchScan scan(rows, fit, PlaneAxis::second);
        const std::vector<double> found = scan.explained();
        const auto best = std::size_t(std::ranges::max_element(found) - found.begin());
        QVERIFY2(std::abs(scan.periods(best) - 150 / 23.7) <= 1.0 / 8,
                 qPrintable(QString::number(scan.periods(best))));
        // Within twice the step of the largest: R/p from 0.5 to 1/(2·0.5°).
        QCOMPARE(scan.periods(0), 0.5);
        QVERIFY(scan.periods(found.size()) <= 180 / std::numbers::pi + 0.13);
        // Its neighbour in the list of usual pitches is not as good; a list that holds it is.
        QVERIFY(std::abs(scan.refined(150 / scan.periods(best), std::array{24.0}, 0) / 23.7 - 1) < 5e-3);
        const double all = fit.fit.residual.squaredNorm();
        QCOMPARE(scan.refined(150 / scan.periods(best), std::array{23.7}, 1e-3 * all), 23.7);
        // What a pitch explains beyond the fit is what fitting it leaves less.
        for (const double pitch : {23.7, 10.0, 61.0}) {
            std::vector<FitTerm> terms = cyclicTerms(PlaneAxis::second, pitch);
            terms.insert(terms.begin(), fit.terms.begin(), fit.terms.end());
            const double less = all - InfluenceFit(rows, terms).fit.residual.squaredNorm();
            QVERIFY2(std::abs(scan.explainedBy(pitch) - less) < 1e-9 * all,
                     qPrintable(QString::number(pitch)));
        }
        QVERIFY(found[best] > 0.8 * all && found[best] < 1.05 * all);
        const auto other = PitchScan(rows, fit, PlaneAxis::first).explained();
        QVERIFY(*std::ranges::max_element(other) < 0.5 * all);
    }
};

QTEST_GUILESS_MAIN(PitchScanTest)
#include "pitchscan.moc"
