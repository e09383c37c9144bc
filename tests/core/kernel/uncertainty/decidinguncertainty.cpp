#include "kernel/evaluation/decideuncertainty.h"

#include "core/kernel/uncertainty/uncertaintydata.h"

#include <QTest>

using namespace palmer;
using namespace palmer::testdata;

/// Which uncertainty decides, what is said of it, and what the verdict makes of it.
class DecidingUncertainty : public QObject {
    Q_OBJECT

private slots:
    void methods_data();
    void methods();
    void largeShiftGivesTheBudget();
    void simulationNotRun();
    void simulationOfAnotherEdition();
    void outdatedSimulationIsProvisional();
    void differencesAreRemarked();
    void closeTargetsAreTheReason();
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
    result.trials = 10000;
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

void DecidingUncertainty::closeTargetsAreTheReason() {
    Test test = worked(UncertaintyMethod::budget);
    // E is ruled by targets 2 and 5, 450 mm apart.
    const auto reasonForE = [&](double length) {
        measurement(test).uncertainty.length = length;
        const TestEvaluation evaluation = evaluatedWith(test, simulation(test, 0.01, 0));
        for (const Finding &f : evaluation.findings) {
            if (f.id != "uncertaintyMethods")
                continue;
            const auto symbols = std::get<std::string>(f.message.arguments.front());
            if (symbols == "E" || symbols.find("E,") != std::string::npos)
                return std::string(f.message.text.source);
        }
        return std::string();
    };
    QVERIFY(reasonForE(1500).find("closer together") != std::string::npos);
    QVERIFY(reasonForE(500).find("extremes over all targets") != std::string::npos);
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
