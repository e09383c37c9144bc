// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pitchscan.h"

#include "core/kernel/diagnosis/coverage.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace palmer;

namespace {

/// The same by the sines of the library, in long double.
double explained(const std::vector<double> &along, const std::vector<double> &curve,
                 const std::vector<double> &squares, double periods) {
    long double b1 = 0;
    long double b2 = 0;
    long double ss = 0;
    long double sc = 0;
    long double cc = 0;
    for (std::size_t i = 0; i < along.size(); ++i) {
        const long double angle = 2 * std::numbers::pi_v<long double> * along[i] * periods;
        b1 += curve[i] * std::sin(angle);
        b2 += curve[i] * std::cos(angle);
        ss += squares[i] * std::sin(angle) * std::sin(angle);
        sc += squares[i] * std::sin(angle) * std::cos(angle);
        cc += squares[i] * std::cos(angle) * std::cos(angle);
    }
    return static_cast<double>((b1 * b1 * cc - 2 * b1 * b2 * sc + b2 * b2 * ss) / (ss * cc - sc * sc));
}

} // namespace

class PitchScanTest : public QObject {
    Q_OBJECT

private slots:
    void anyCurveAgainstTheSinesOfTheLibrary() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> position(-1, 1);
        std::normal_distribution<double> value;
        for (int k = 0; k < 200; ++k) {
            std::vector<double> along(400);
            std::vector<double> curve;
            std::vector<double> squares;
            for (double &x : along) {
                x = position(random);
                curve.push_back(value(random) * x);
                squares.push_back(x * x);
            }
            const double periods = 3 + 20 * std::abs(position(random));
            const double expected = explained(along, curve, squares, periods);
            const double tolerance = 1e-10 * (1 + expected);
            const double found = explainedByPitch(along, curve, squares, periods);
            QVERIFY2(std::abs(found - expected) < tolerance,
                     qPrintable(QString("%1 for %2").arg(found).arg(expected)));
        }
    }

    void aCyclicErrorIsExplainedByItsPitchAlone() {
        std::vector<double> along;
        std::vector<double> curve;
        std::vector<double> squares;
        double all = 0;
        for (int i = 0; i < 4000; ++i) {
            const double x = std::cos(2 * std::numbers::pi * i / 4000);
            const double v = x * std::sin(2 * std::numbers::pi * x * 15 + 0.7);
            along.push_back(x);
            curve.push_back(v * x);
            squares.push_back(x * x);
            all += v * v;
        }
        QVERIFY(std::abs(explainedByPitch(along, curve, squares, 15) - all) < 1e-3 * all);
        QVERIFY(explainedByPitch(along, curve, squares, 12) < 0.2 * all);
    }

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
        QCOMPARE(scan.refined(150 / scan.periods(best), std::array{23.7}, 1e-12), 23.7);
        const double all = fit.fit.residual.squaredNorm();
        QVERIFY(found[best] > 0.8 * all && found[best] < 1.05 * all);
        const auto other = PitchScan(rows, fit, PlaneAxis::first).explained();
        QVERIFY(*std::ranges::max_element(other) < 0.5 * all);
    }

    void rowsThatDoNotCountSayNothing() {
        const std::vector<double> none(8, 0.0);
        QCOMPARE(explainedByPitch(none, none, none, 10), 0.0);
    }
};

QTEST_GUILESS_MAIN(PitchScanTest)
#include "pitchscan.moc"
