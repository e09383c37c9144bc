// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/decideuncertainty.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/simulation/simulate.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace palmer;
using namespace palmer::testdata;

using TestChange = std::function<void(Test &)>;
Q_DECLARE_METATYPE(TestChange)

/// Which uncertainty decides, what is said of it, and what the verdict makes of it.
class DecidingUncertainty : public QObject {
    Q_OBJECT

private slots:
    void methods_data();
    void methods();
    void statedIsOfTheUnitOfTheAxis();
    void statedOfCircles();
    void largeShiftGivesTheBudget();
    void simulationNotRun();
    void aCircleSaysWhyItIsNotSimulated();
    void simulationOfAnotherEdition();
    void outdatedSimulationIsProvisional();
    void fewTrialsNeverDecide_data();
    void fewTrialsNeverDecide();
    void fewTrialsOfCircles();
    void guardCarriesTheErrorOfU();
    void differencesAreRemarked();
    void realCauses_data();
    void realCauses();
    void actualTargetsDecideIfChosen();
    void guardFactor_data();
    void guardFactor();
    void verdictIgnoresTheSign();
    void withoutUncertaintyNothingIsProven();
    void editionsAskForIt();
};

namespace {

/// A simulation of all parameters with U and shift, in µm.
std::shared_ptr<const Simulation> simulation(const Test &test, double expanded, double shift) {
    Simulation result;
    result.edition = test.edition;
    result.trials = fewestDecidingTrials;
    for (const Parameter &p : evaluated(test).parameters) {
        if (!p.value)
            continue;
        const double mean = *p.value + shift / 1000;
        result.parameters.push_back({parameterId(p),
                                     *p.value,
                                     mean,
                                     expanded / 2000,
                                     mean - expanded / 1000,
                                     mean + expanded / 1000,
                                     {},
                                     {}});
    }
    return std::make_shared<const Simulation>(result);
}

TestEvaluation evaluatedWith(const Test &test, std::shared_ptr<const Simulation> simulation,
                             bool outdated = false) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    surroundings.simulation = std::move(simulation);
    surroundings.simulationOutdated = outdated;
    return evaluateTest(test, surroundings);
}

Test worked(UncertaintyMethod method) {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedByInstrument;
    measurement(test).uncertainty.length = 500; // U(A) = 5.5370 µm
    measurement(test).uncertainty.method = method;
    measurement(test).uncertainty.expanded = {{"A", 4}};
    return test;
}

double micrometres(const Parameter *p) {
    return p->expandedUncertainty.value_or(-0.001) * 1000;
}

} // namespace

void DecidingUncertainty::methods_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("expected"); // µm; −1: none
    QTest::newRow("none") << int(UncertaintyMethod::none) << -1.0;
    QTest::newRow("budget") << int(UncertaintyMethod::budget) << 5.5370;
    QTest::newRow("Monte Carlo") << int(UncertaintyMethod::monteCarlo) << 5.0;
    QTest::newRow("direct") << int(UncertaintyMethod::direct) << 4.0;
}

void DecidingUncertainty::methods() {
    QFETCH(int, method);
    QFETCH(double, expected);
    const Test test = worked(static_cast<UncertaintyMethod>(method));
    const TestEvaluation evaluation = evaluatedWith(test, simulation(test, 5, 0.5));
    const Parameter *a = parameter(evaluation, "A");
    QVERIFY(std::abs(micrometres(a) - expected) < 0.5e-4);
    QCOMPARE(int(a->decidedBy), expected < 0 ? int(UncertaintyMethod::none) : method);
    // Both stand beside each other whichever decides.
    QVERIFY(a->budgetUncertainty && a->simulated);
    QVERIFY(!finding(evaluation, "monteCarloShift"));
}

void DecidingUncertainty::statedIsOfTheUnitOfTheAxis() {
    Test test = worked(UncertaintyMethod::direct);
    measurement(test).uncertainty.expanded = {{"A", 3.6}, {"E", 0}, {"R", -1}, {"B", std::nan("")}};
    const auto stated = [&](const char *id) { return parameter(evaluated(test), id)->expandedUncertainty; };
    QCOMPARE(stated("A"), std::optional(3.6 / 1000)); // µm
    measurement(test).axis.motion = Motion::rotary;
    QCOMPARE(stated("A"), std::optional(3.6 / 3600)); // arc seconds: 0.001°
    QCOMPARE(stated("E"), std::optional(0.0));
    for (const char *id : {"R", "B", "M"}) // negative, no number, not stated
        QVERIFY2(!stated(id), id);
}

void DecidingUncertainty::statedOfCircles() {
    Test test = circularTest(36);
    circle(test).uncertainty.method = UncertaintyMethod::direct;
    circle(test).uncertainty.expanded = {{"G", 2}, {"G(b)", 0}, {"F", 3}, {"Fmin", 4}, {"D", -1}};
    const auto stated = [&](const char *id) { return parameter(evaluated(test), id)->expandedUncertainty; };
    QCOMPARE(stated("G_XY"), std::optional(0.002)); // µm
    QCOMPARE(stated("G(b)_XY"), std::optional(0.0));
    QCOMPARE(stated("Fmax_XY"), std::optional(0.003)); // that of F
    QCOMPARE(stated("Fmin_XY"), std::optional(0.004)); // its own goes before
    QVERIFY(!stated("D_XY"));
}

void DecidingUncertainty::largeShiftGivesTheBudget() {
    const Test test = worked(UncertaintyMethod::monteCarlo);
    const TestEvaluation evaluation = evaluatedWith(test, simulation(test, 5, 1.7)); // 5/3 = 1.667
    const Parameter *a = parameter(evaluation, "A");
    QVERIFY(std::abs(micrometres(a) - 5.5370) < 0.5e-4);
    QCOMPARE(a->decidedBy, UncertaintyMethod::budget);
    QVERIFY(finding(evaluation, "monteCarloShift"));
    // A shift to below counts as well, one of less than a third does not.
    QVERIFY(finding(evaluatedWith(test, simulation(test, 5, -1.7)), "monteCarloShift"));
    QVERIFY(!finding(evaluatedWith(test, simulation(test, 5, 1.66)), "monteCarloShift"));
}

void DecidingUncertainty::simulationNotRun() {
    const TestEvaluation evaluation = evaluated(worked(UncertaintyMethod::monteCarlo));
    QVERIFY(finding(evaluation, "monteCarlo"));
    QVERIFY(!parameter(evaluation, "A")->expandedUncertainty);
    QVERIFY(evaluation.uncertainty.wantsSimulation());
    QVERIFY(!finding(evaluated(worked(UncertaintyMethod::budget)), "monteCarlo"));
}

/// F lacks a temperature: nothing is simulated, not even G, whose own inputs are all there.
void DecidingUncertainty::aCircleSaysWhyItIsNotSimulated() {
    Test test = circularTest(36);
    circle(test).uncertainty.expansionStandardUncertainty = {0.5, 0.5};
    circle(test).uncertainty.displacement.expanded = 1;
    test.limits["G"].value = 0.010;
    test.decisionRule = {Rule::iso14253_1, 1};
    const auto verdict = [&](UncertaintyMethod method) {
        circle(test).uncertainty.method = method;
        return *evaluated(test).verdict;
    };
    QCOMPARE(verdict(UncertaintyMethod::budget), Verdict::conforms);
    QVERIFY(!finding(evaluated(test), "monteCarlo"));
    QCOMPARE(verdict(UncertaintyMethod::monteCarlo), Verdict::notProven);
    const TestEvaluation evaluation = evaluated(test);
    QVERIFY(!evaluation.uncertainty.wantsSimulation());
    QVERIFY(finding(evaluation, "sensors")); // which input it is
    const Finding *why = finding(evaluation, "monteCarlo");
    QVERIFY(why);
    QVERIFY(std::string_view(why->message.text.source).find("cannot be run") != std::string_view::npos);
    // With the temperatures there is nothing to explain but that it was not run.
    circle(test).conditions.common.sensors = {{SensorMeasures::machine, "", 21.0, 21.0, std::nullopt},
                                              {SensorMeasures::instrument, "", 21.0, 21.0, std::nullopt}};
    const TestEvaluation complete = evaluated(test);
    QVERIFY(complete.uncertainty.wantsSimulation());
    QVERIFY(std::string_view(finding(complete, "monteCarlo")->message.text.source).find("was not run") !=
            std::string_view::npos);
}

void DecidingUncertainty::simulationOfAnotherEdition() {
    const Test test = worked(UncertaintyMethod::monteCarlo);
    Simulation other = *simulation(test, 5, 0);
    other.edition = "ISO 230-2:1988";
    const TestEvaluation evaluation = evaluatedWith(test, std::make_shared<const Simulation>(other));
    QVERIFY(!evaluation.uncertainty.simulation);
    QVERIFY(!parameter(evaluation, "A")->simulated);
}

void DecidingUncertainty::outdatedSimulationIsProvisional() {
    Test test = worked(UncertaintyMethod::monteCarlo);
    test.limits["A"].value = 0.030;
    test.decisionRule = {Rule::iso14253_1, 1};
    QVERIFY(!evaluatedWith(test, simulation(test, 5, 0)).provisional);
    const TestEvaluation outdated = evaluatedWith(test, simulation(test, 5, 0), true);
    QVERIFY(outdated.provisional);
    QVERIFY(finding(outdated, "monteCarlo"));
    // The shift of an outdated simulation, by which the budget decides, may be another after the edit.
    const TestEvaluation byBudget = evaluatedWith(test, simulation(test, 5, 1.7), true);
    QCOMPARE(parameter(byBudget, "A")->decidedBy, UncertaintyMethod::budget);
    QVERIFY(byBudget.provisional);
    // Under simple acceptance no uncertainty is looked at.
    test.decisionRule.rule = Rule::simpleAcceptance;
    QVERIFY(!evaluatedWith(test, simulation(test, 5, 0), true).provisional);
    test.decisionRule.rule = Rule::iso14253_1;
    measurement(test).uncertainty.method = UncertaintyMethod::budget;
    QVERIFY(!evaluatedWith(test, simulation(test, 5, 0), true).provisional);
}

void DecidingUncertainty::differencesAreRemarked() {
    const Test test = worked(UncertaintyMethod::budget);
    const auto differing = [&](double factor) {
        Simulation same = *simulation(test, 5, 0);
        const TestEvaluation plain = evaluated(test);
        for (SimulatedParameter &p : same.parameters) {
            const double half = factor * *parameter(plain, p.id)->budgetUncertainty;
            p.low = p.mean - half;
            p.high = p.mean + half;
        }
        return evaluatedWith(test, std::make_shared<const Simulation>(same));
    };
    QVERIFY(!finding(differing(1.19), "uncertaintyMethods"));
    QVERIFY(!finding(differing(0.81), "uncertaintyMethods"));
    const TestEvaluation above = differing(1.21);
    QVERIFY(finding(above, "uncertaintyMethods"));
    QCOMPARE(finding(above, "uncertaintyMethods")->grade, Grade::note);
    QVERIFY(finding(differing(0.79), "uncertaintyMethods"));
}

namespace {

/// What is said of the difference of one parameter; empty: nothing.
std::string reasonFor(const TestEvaluation &evaluation, const std::string &symbol) {
    for (const Finding &f : evaluation.findings) {
        if (f.id != "uncertaintyMethods")
            continue;
        const std::string symbols = ", " + std::get<std::string>(f.message.arguments.front()) + ",";
        if (symbols.find(", " + symbol + ",") != std::string::npos)
            return f.message.text.source;
    }
    return {};
}

std::shared_ptr<const Simulation> realSimulation(const Test &test) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    SimulationOptions options;
    options.trials = fewestDecidingTrials;
    return std::make_shared<const Simulation>(
        simulate(test, surroundings, *findEdition(test.edition), options).value());
}

std::vector<std::vector<double>> runsOf(const std::vector<double> &run) {
    return std::vector<std::vector<double>>(5, run);
}

} // namespace

void DecidingUncertainty::fewTrialsNeverDecide_data() {
    QTest::addColumn<qlonglong>("trials");
    QTest::addColumn<bool>("decides");
    QTest::newRow("three") << 3LL << false;
    QTest::newRow("10⁴/(1 − p), not in whole blocks") << 219'781LL << false;
    QTest::newRow("one less") << 219'999LL << false;
    QTest::newRow("22 blocks") << 220'000LL << true;
    QTest::newRow("one more") << 220'001LL << true;
}

void DecidingUncertainty::fewTrialsNeverDecide() {
    QFETCH(qlonglong, trials);
    QFETCH(bool, decides);
    Test test = worked(UncertaintyMethod::monteCarlo);
    test.limits["A"].value = 0.018; // 16.23: not proven with U 5.5, conforms with 1
    test.decisionRule = {Rule::iso14253_1, 1};
    Simulation few = *simulation(test, 1, 0.1);
    few.trials = trials;
    const TestEvaluation evaluation = evaluatedWith(test, std::make_shared<const Simulation>(few));
    const Parameter *a = parameter(evaluation, "A");
    QCOMPARE(a->decidedBy, decides ? UncertaintyMethod::monteCarlo : UncertaintyMethod::budget);
    QCOMPARE(*evaluation.verdict, decides ? Verdict::conforms : Verdict::notProven);
    QVERIFY(a->simulated); // shown all the same
    const Finding *remark = finding(evaluation, "monteCarlo");
    QCOMPARE(remark != nullptr, !decides);
    if (remark) {
        QCOMPARE(remark->grade, Grade::note);
        QVERIFY(remark->message.count == trials);
        QVERIFY(!finding(evaluation, "uncertaintyMethods")); // nothing is made of so few
    }
}

void DecidingUncertainty::fewTrialsOfCircles() {
    Test test = circularTest(36);
    circle(test).uncertainty.method = UncertaintyMethod::monteCarlo;
    circle(test).uncertainty.displacement.expanded = 1;
    test.limits["G(b)"].value = 0.0005;
    test.decisionRule = {Rule::iso14253_1, 1};
    Simulation few = *simulation(test, 0.1, 0);
    few.trials = 3;
    const TestEvaluation evaluation = evaluatedWith(test, std::make_shared<const Simulation>(few));
    QCOMPARE(parameter(evaluation, "G(b)_XY")->decidedBy, UncertaintyMethod::budget);
    QCOMPARE(*evaluation.verdict, Verdict::notProven);
    few.trials = fewestDecidingTrials;
    QCOMPARE(*evaluatedWith(test, std::make_shared<const Simulation>(few)).verdict, Verdict::conforms);
}

void DecidingUncertainty::guardCarriesTheErrorOfU() {
    Test test = worked(UncertaintyMethod::monteCarlo);
    test.limits["A"].value = 0.0190; // A = 16.2321
    test.decisionRule = {Rule::iso14253_1, 0.83};
    Simulation sure = *simulation(test, 3, 0);
    const auto verdict = [&](std::optional<double> error) {
        for (SimulatedParameter &p : sure.parameters)
            p.expandedError = error;
        const TestEvaluation evaluation = evaluatedWith(test, std::make_shared<const Simulation>(sure));
        const Parameter *a = parameter(evaluation, "A");
        if (std::abs(*a->expandedUncertainty - 0.003) > 1e-12 ||
            std::abs(*a->guardBand - 0.83 * (0.003 + 2 * error.value_or(0))) > 1e-12)
            qFatal("U or guard band");
        return *evaluation.verdict;
    };
    QCOMPARE(verdict(std::nullopt), Verdict::conforms); // 16.2321 + 2.49
    QCOMPARE(verdict(0.00016), Verdict::conforms);      // + 0.83·0.32 = 18.988
    QCOMPARE(verdict(0.00018), Verdict::notProven);     // + 0.83·0.36 = 19.021
    // The budget's U has no such error.
    measurement(test).uncertainty.method = UncertaintyMethod::budget;
    const TestEvaluation budget = evaluatedWith(test, std::make_shared<const Simulation>(sure));
    const Parameter *a = parameter(budget, "A");
    QVERIFY(std::abs(*a->guardBand - 0.83 * *a->expandedUncertainty) < 1e-15);
}

void DecidingUncertainty::realCauses_data() {
    QTest::addColumn<QString>("symbol");
    QTest::addColumn<QString>("words"); // empty: no difference of 20 %
    QTest::addColumn<TestChange>("change");
    const auto row = [](const char *name, const char *symbol, const char *words, TestChange change) {
        QTest::newRow(name) << QString::fromUtf8(symbol) << QString::fromUtf8(words) << std::move(change);
    };
    const auto device = [](double perMetre) {
        return [perMetre](Test &test) {
            stateNothing(measurement(test));
            measurement(test).uncertainty.device.perMetre = perMetre;
        };
    };
    // Targets 0, 500, 1000: the means of one test after the other.
    const auto means = [](const std::vector<double> &up, const std::vector<double> &down) {
        return [up, down](Test &test) {
            test = positioningTest("ISO 230-2:2006", {0, 500, 1000}, runsOf(up), runsOf(down));
        };
    };
    row("the rulers stand apart by half of L", "E", "closer together", [=](Test &test) {
        means({0, 100, 50}, {-40, 60, 10})(test);
        device(3)(test);
    });
    row("they stand apart by all of L", "E", "", [=](Test &test) {
        means({0, 50, 100}, {-40, 10, 60})(test);
        device(3)(test);
    });
    row("one uniform error", "E", "not normally distributed", [=](Test &test) {
        means({0, 50, 100}, {-40, 10, 60})(test);
        stateNothing(measurement(test));
        measurement(test).uncertainty.temperatureRange.machine = 1;
    });
    row("both", "E", "closer together than the length L = %2 of the budget, and", [=](Test &test) {
        means({0, 100, 50}, {-40, 60, 10})(test);
        stateNothing(measurement(test));
        measurement(test).uncertainty.temperatureRange.machine = 1;
    });
    row("the mean over all targets", "B̄", "mean over all targets", [=](Test &test) {
        std::vector<double> positions;
        std::vector<double> up;
        for (int i = 0; i < 10; ++i) {
            positions.push_back(100.0 * i);
            up.push_back(20);
        }
        test = positioningTest("ISO 230-2:2006", positions, runsOf(up), runsOf(std::vector<double>(10, 0)));
        stateNothing(measurement(test));
        measurement(test).uncertainty.environmentalVariation = 1;
    });
    row("readings that scatter less than the drift", "R↑", "widens the s", [=](Test &test) {
        means({0, 0, 0}, {0, 0, 0})(test);
        stateNothing(measurement(test));
        measurement(test).uncertainty.environmentalVariation = 3;
    });
    row("a fixed part of the instrument, rulers close together", "E", "fixed part", [=](Test &test) {
        means({0, 100, 50}, {-40, 60, 10})(test);
        stateNothing(measurement(test));
        measurement(test).uncertainty.device.fixed = 3;
    });
    row("targets that are all alike but for the drift", "B", "other targets come within U", [=](Test &test) {
        means({5, 5, 5}, {0, 0, 0})(test);
        stateNothing(measurement(test));
        measurement(test).uncertainty.environmentalVariation = 1;
    });
    row("a reversal that is the same everywhere", "E", "tilt one way or the other", [=](Test &test) {
        means({5, 5, 5}, {0, 0, 0})(test);
        device(4.85)(test);
    });
}

void DecidingUncertainty::realCauses() {
    QFETCH(QString, symbol);
    QFETCH(QString, words);
    QFETCH(TestChange, change);
    Test test;
    change(test);
    const TestEvaluation evaluation = evaluatedWith(test, realSimulation(test));
    const std::string found = reasonFor(evaluation, symbol.toStdString());
    QVERIFY2(words.isEmpty() ? found.empty() : found.find(words.toStdString()) != std::string::npos,
             found.c_str());
}

void DecidingUncertainty::actualTargetsDecideIfChosen() {
    Test test = positioningTest("ISO 230-2:2006", {0, 500, 1000}, runsOf({1, 6, 1}), runsOf({-1, -6, -1}));
    stateNothing(measurement(test));
    measurement(test).uncertainty.device.perMetre = 4.85;
    measurement(test).uncertainty.environmentalVariation = 1;
    test.limits["E"].value = 0.013; // 12
    test.decisionRule = {Rule::iso14253_1, 1};
    QCOMPARE(*evaluated(test).verdict, Verdict::notProven);
    QVERIFY(parameter(evaluated(test), "E")->actualUncertainty); // beside it, whichever decides
    measurement(test).uncertainty.method = UncertaintyMethod::budgetActual;
    const TestEvaluation actual = evaluated(test);
    QCOMPARE(*actual.verdict, Verdict::conforms);
    const Parameter *e = parameter(actual, "E");
    QCOMPARE(e->decidedBy, UncertaintyMethod::budgetActual);
    QVERIFY(std::abs(*e->expandedUncertainty * 1000 - 0.6 * std::sqrt(0.4)) < 1e-12); // of E_VE alone
    // What has no S in it has the U of the budget.
    const Parameter *b = parameter(actual, "B");
    QCOMPARE(b->expandedUncertainty, b->budgetUncertainty);
    QVERIFY(!b->actualUncertainty);
    QVERIFY(actual.uncertainty.wantsSimulation());
}

void DecidingUncertainty::guardFactor_data() {
    QTest::addColumn<double>("factor");
    QTest::addColumn<double>("limit"); // µm; A = 16.2321, U = 4
    QTest::addColumn<int>("expected");
    const int conforms = int(Verdict::conforms);
    const int open = int(Verdict::notProven);
    const int fails = int(Verdict::doesNotConform);
    QTest::newRow("factor 1: limit far above") << 1.0 << 20.3 << conforms;
    QTest::newRow("factor 1: in the band") << 1.0 << 20.2 << open;
    QTest::newRow("factor 1: just beyond the band") << 1.0 << 12.2 << fails;
    QTest::newRow("factor 1: in the band below") << 1.0 << 12.3 << open;
    QTest::newRow("factor 0.83: limit far above") << 0.83 << 19.6 << conforms;
    QTest::newRow("factor 0.83: in the band") << 0.83 << 19.5 << open;
    QTest::newRow("factor 0.83: just beyond the band") << 0.83 << 12.9 << fails;
    QTest::newRow("factor 0.83: in the band below") << 0.83 << 12.95 << open;
}

void DecidingUncertainty::guardFactor() {
    QFETCH(double, factor);
    QFETCH(double, limit);
    QFETCH(int, expected);
    for (const Rule rule : {Rule::iso14253_1, Rule::rejectionProven}) {
        Test test = worked(UncertaintyMethod::direct);
        test.limits["A"].value = limit / 1000;
        test.decisionRule = {rule, factor};
        const TestEvaluation evaluation = evaluated(test);
        QCOMPARE(int(*parameter(evaluation, "A")->verdict), expected);
        QCOMPARE(int(*evaluation.verdict), expected);
        QVERIFY(std::abs(*parameter(evaluation, "A")->guardBand - factor * 0.004) < 1e-15);
    }
}

void DecidingUncertainty::verdictIgnoresTheSign() {
    // The directions exchanged: Bmean changes its sign and nothing else.
    for (const double limit : {0.0002, 0.0013, 0.0016, 0.003, 0.004}) {
        Test test = worked(UncertaintyMethod::budget);
        test.limits["Bmean"].value = limit;
        test.decisionRule = {Rule::iso14253_1, 1};
        Test turned = test;
        for (Run &run : measurement(turned).runs)
            run.approach = run.approach == Direction::positive ? Direction::negative : Direction::positive;
        const TestEvaluation one = evaluated(test);
        const TestEvaluation other = evaluated(turned);
        QCOMPARE(*parameter(one, "Bmean")->value, -*parameter(other, "Bmean")->value);
        QCOMPARE(one.verdict, other.verdict);

        Test circular = circularTest(36);
        circle(circular).uncertainty.displacement.expanded = 1;
        circular.limits["D"].value = limit;
        circular.decisionRule = {Rule::iso14253_1, 1};
        std::optional<Verdict> verdicts[2];
        for (int k = 0; k < 2; ++k) {
            for (Arc &arc : circle(circular).arcs)
                std::ranges::fill(arc.radialDeviations, k == 0 ? 0.0015 : -0.0015);
            const TestEvaluation evaluation = evaluated(circular);
            QVERIFY((*parameter(evaluation, "D_XY")->value > 0) == (k == 0));
            verdicts[k] = evaluation.verdict;
        }
        QCOMPARE(verdicts[0], verdicts[1]);
    }
}

void DecidingUncertainty::withoutUncertaintyNothingIsProven() {
    Test test = worked(UncertaintyMethod::budget);
    measurement(test).uncertainty.environmentalVariation.reset();
    test.limits["A"].value = 1;
    test.decisionRule = {Rule::iso14253_1, 1};
    const TestEvaluation evaluation = evaluated(test);
    QCOMPARE(*evaluation.verdict, Verdict::notProven);
    QVERIFY(finding(evaluation, "decisionRule"));
    QVERIFY(finding(evaluation, "environmentalVariation"));
}

void DecidingUncertainty::editionsAskForIt() {
    // 2006 asks for U beside every result: with a budget the requirement is met.
    QVERIFY(!finding(evaluated(worked(UncertaintyMethod::budget)), "uncertainty"));
    QVERIFY(finding(evaluated(worked(UncertaintyMethod::none)), "uncertainty"));
    QVERIFY(finding(evaluated(worked(UncertaintyMethod::direct)), "uncertainty")); // of A alone
}

QTEST_APPLESS_MAIN(DecidingUncertainty)
#include "decidinguncertainty.moc"
