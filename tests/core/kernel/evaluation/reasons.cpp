// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/uncertainty/uncertaintydata.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <memory>

using namespace palmer;
using namespace palmer::testdata;

namespace {

/// The reason that is given where a simulation says U = `expanded` and u of one parameter, in English; empty:
/// none.
std::string reason(const Test &test, const char *id, double expanded, double u) {
    const double value = *parameter(evaluated(test), id)->value;
    auto simulation = std::make_shared<Simulation>();
    simulation->edition = test.edition;
    simulation->trials = fewestDecidingTrials;
    SimulatedParameter simulated;
    simulated.id = id;
    simulated.value = simulated.mean = value;
    simulated.u = u;
    simulated.low = value - expanded;
    simulated.high = value + expanded;
    simulation->parameters = {simulated};
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    surroundings.simulation = simulation;
    const TestEvaluation evaluation = evaluateTest(test, surroundings);
    const Finding *found = finding(evaluation, "uncertaintyMethods");
    return found ? found->message.text.source : "";
}

bool says(const std::string &reason, const char *words) {
    return reason.find(words) != std::string::npos;
}

double budgetOf(const Test &test, const char *id) {
    return *parameter(evaluated(test), id)->budgetUncertainty;
}

double contribution(const Test &test, std::string_view id) {
    const TestEvaluation evaluation = evaluated(test);
    const auto found = std::ranges::find(evaluation.uncertainty.contributions, id,
                                         [](const Contribution &c) { return std::string_view(c.id); });
    return found->expanded.value();
}

constexpr double never = 1; ///< mm: a u that is twice no budget

/// Budgets of the displacement and of the drift, each as large as the other.
Test circleWithDrift() {
    Test test = circularTest(360);
    circle(test).uncertainty.displacement.expanded = 4;
    circle(test).uncertainty.environmentalVariation = 7;
    circle(test).uncertainty.repeatability = 1;
    return test;
}

/// The instrument's part per metre alone.
Test axisWithScale() {
    Test test = exactHand("ISO 230-2:2006");
    stateNothing(measurement(test));
    measurement(test).uncertainty.device.perMetre = 20;
    return test;
}

/// The drift alone.
Test axisWithDrift(double range, DriftModel model = DriftModel::independent) {
    Test test = exactHand("ISO 230-2:2006");
    stateNothing(measurement(test));
    measurement(test).uncertainty.environmentalVariation = range;
    measurement(test).uncertainty.driftModel = model;
    return test;
}

} // namespace

/// Why budget and simulation differ by more than 20 %: what is said holds of the numbers.
class Reasons : public QObject {
    Q_OBJECT

private slots:
    /// From both sides of 20 %.
    void agreementNeedsNone() {
        const Test test = circleWithDrift();
        const double budget = budgetOf(test, "G(b)_XY");
        for (const double factor : {0.81, 1.0, 1.19})
            QCOMPARE(reason(test, "G(b)_XY", factor * budget, never), std::string());
        for (const double factor : {0.79, 1.21})
            QVERIFY(!reason(test, "G(b)_XY", factor * budget, never).empty());
    }

    void whatMovesACircleLeavesItsWidth() {
        const Test test = circleWithDrift();
        const double budget = budgetOf(test, "G(b)_XY");
        const double drift = contribution(test, "environmentalVariation");
        const double displacement = contribution(test, "displacement");
        const double withoutDrift = std::sqrt(budget * budget - drift * drift);
        QVERIFY(withoutDrift < 0.79 * budget);
        QVERIFY(says(reason(test, "G(b)_XY", withoutDrift, never), "leaves its width"));
        const double withoutBoth = std::sqrt(withoutDrift * withoutDrift - displacement * displacement);
        QVERIFY(withoutBoth < 0.79 * withoutDrift);
        QVERIFY(says(reason(test, "G(b)_XY", withoutBoth, never), "leaves its width"));
        QVERIFY(says(reason(test, "G(b)_XY", withoutBoth / 2, never), "no single reason"));
        // Distances are moved by it.
        const double ofDistance = budgetOf(test, "Fmax_XY");
        QVERIFY(says(reason(test, "Fmax_XY", std::sqrt(ofDistance * ofDistance - drift * drift), never),
                     "no single reason"));
    }

    void noiseMovesTheExtremePoints() {
        Test test = circleWithDrift();
        const double budget = budgetOf(test, "G(b)_XY");
        QVERIFY(says(reason(test, "G(b)_XY", 1.5 * budget, never), "no single reason"));
        circle(test).uncertainty.pointNoise = 0.1;
        QVERIFY(says(reason(test, "G(b)_XY", 1.5 * budgetOf(test, "G(b)_XY"), never), "extreme points"));
        QVERIFY(!says(reason(test, "G(b)_XY", 0.1 * budget, never), "extreme points"));
        circle(test).uncertainty.pointNoise = 0;
        circle(test).uncertainty.resolution = 0.1;
        QVERIFY(says(reason(test, "G(b)_XY", 1.5 * budgetOf(test, "G(b)_XY"), never), "extreme points"));
    }

    void resultsAreNotNormallyDistributed() {
        const Test round = circleWithDrift();
        const double ofCircle = budgetOf(round, "D_XY") > 0 ? budgetOf(round, "D_XY") : 1;
        QVERIFY(says(reason(round, "D_XY", 1.5 * ofCircle, ofCircle / 2), "not normally distributed"));
        const Test axis = axisWithScale();
        const double ofAxis = budgetOf(axis, "A");
        QVERIFY(says(reason(axis, "A", 1.5 * ofAxis, ofAxis / 2), "not normally distributed"));
    }

    /// A is ruled by the targets at 300 mm and 400 mm; L is 400 mm.
    void rulingTargetsLieCloser() {
        const Test test = axisWithScale();
        const TestEvaluation plain = evaluated(test);
        const Parameter &a = *parameter(plain, "A");
        QVERIFY(*a.actualUncertainty < 0.79 * *a.budgetUncertainty);
        QVERIFY(says(reason(test, "A", *a.actualUncertainty, never), "ruling targets lie closer together"));
        QVERIFY(says(reason(test, "A", 3 * *a.budgetUncertainty, *a.actualUncertainty / 2),
                     "closer together than the length L = %2 of the budget, and"));
    }

    void theMeanOverAllTargetsIsLessUncertain() {
        const Test test = axisWithDrift(5);
        const double budget = budgetOf(test, "Bmean");
        QVERIFY(says(reason(test, "Bmean", budget / std::sqrt(5), never), "mean over all targets"));
        QVERIFY(!says(reason(test, "B", budgetOf(test, "B") / std::sqrt(5), never), "mean over all targets"));
        QVERIFY(!says(reason(test, "Bmean", budget * std::sqrt(5), never), "mean over all targets"));
    }

    /// The smallest s of exactHand is 0.5 µm: a drift of 5 µm has a deviation of 1.4 µm.
    void driftWidensTheScatter() {
        const Test test = axisWithDrift(5);
        QVERIFY(says(reason(test, "R", 3 * budgetOf(test, "R"), never), "widens the s"));
        const Test linear = axisWithDrift(5, DriftModel::linear);
        QVERIFY(!says(reason(linear, "R", 3 * budgetOf(linear, "R"), never), "widens the s"));
        const Test means = axisWithDrift(5);
        QVERIFY(!says(reason(means, "E", 3 * budgetOf(means, "E"), never), "widens the s"));
        const Test little = axisWithDrift(0.05);
        QVERIFY(!says(reason(little, "R", 3 * budgetOf(little, "R"), never), "widens the s"));
    }

    /// E is 13 µm, and 7 µm without the targets that rule it.
    void otherTargetsComeClose() {
        const auto said = [](double range) {
            const Test test = axisWithDrift(range);
            return reason(test, "E", 3 * budgetOf(test, "E"), never);
        };
        QVERIFY(budgetOf(axisWithDrift(17), "E") > 6e-3 && budgetOf(axisWithDrift(15), "E") < 6e-3);
        QVERIFY(says(said(17), "other targets come within U"));
        QVERIFY(says(said(15), "no single reason"));
    }
};

QTEST_GUILESS_MAIN(Reasons)
#include "reasons.moc"
