// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/simulate.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/planning/targetplan.h"
#include "kernel/simulation/positioningtrials.h"
#include "kernel/simulation/randomdraws.h"
#include "kernel/simulation/runtrials.h"

#include <QTest>
#include <ctime>

#include <cmath>
#include <random>
#include <thread>

using namespace palmer;
using namespace palmer::testdata;

/// Monte Carlo of positioning tests: it is the real evaluation, it agrees with what is known, and it does not
/// depend on the threads.
class SimulatePositioning : public QObject {
    Q_OBJECT

private slots:
    void everyRowHasLanes();
    void numbersDoNotDependOnTheRegisters();
    void trialsAreTheRealEvaluation_data();
    void trialsAreTheRealEvaluation();
    void nothingGivesNothing();
    void normalDevice();
    void uniformErrors_data();
    void uniformErrors();
    void misalignment();
    void independentDriftOfTwoReadings();
    void linearDrift();
    void driftFollowsTheOrderOfTime_data();
    void driftFollowsTheOrderOfTime();
    void smallInputsAgreeWithTheBudget();
    void scaling();
    void workedExampleIsShifted();
    void sameFiguresOnAnyNumberOfThreads_data();
    void sameFiguresOnAnyNumberOfThreads();
    void fewSumsForAnyNumberOfTrials();
    void sumsOfManyChunksAreTheSameOnAnyThreads();
    void seedsDiffer();
    void adaptiveIsStable();
    void adaptiveGoesOnUntilAllIsStable();
    void constantsDoNotGoOn();
    void errorOfU();
    void oneTargetAndDirectionRulesA();
    void fixedNumber();
    void cancel();
    void progress();
    void histogram();
    void incompleteBudget();
    void rotary();
};

namespace {

constexpr double coverage = 0.9545;

const Edition &edition(const Test &test) {
    return *findEdition(test.edition);
}

Surroundings noSurroundings() {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    return surroundings;
}

Simulation simulated(const Test &test, std::optional<long long> trials = 100000, int threads = 2) {
    SimulationOptions options;
    options.trials = trials;
    options.threads = threads;
    const auto result = simulate(test, noSurroundings(), edition(test), options);
    if (!result)
        qFatal("no simulation");
    return *result;
}

/// Two targets 1 000 mm apart, ↑ only, the second 100 µm off: E↑ is the difference of both means.
Test twoTargets(int runs) {
    std::vector<std::vector<double>> up(static_cast<std::size_t>(runs), {0, 100});
    Test test = positioningTest("ISO 230-2:2006", {0, 1000}, up, {});
    stateNothing(measurement(test));
    return test;
}

const SimulatedParameter &of(const Simulation &simulation, std::string_view id) {
    const SimulatedParameter *found = simulation.find(id);
    if (!found)
        qFatal("no parameter");
    return *found;
}

/// The statistical error of u of 10⁵ trials is about 0.25 %, of U somewhat more.
constexpr double statistical = 0.016;

#define COMPARE_RELATIVE(found, expected, tolerance)                                                         \
    QVERIFY2(std::abs((found) - (expected)) <= (tolerance)*std::abs(expected),                               \
             qPrintable(QStringLiteral(#found " is %1, not %2").arg(found, 0, 'g', 12).arg(expected)))

} // namespace

void SimulatePositioning::everyRowHasLanes() {
    for (const Edition *one : editions()) {
        for (const Row &row : one->rows)
            QVERIFY2(row.value->four, row.term.id);
    }
}

void SimulatePositioning::numbersDoNotDependOnTheRegisters() {
    const RandomDraws draws(-42);
    constexpr long long first = (1LL << 32U) - 4; // the high word changes after these trials
    constexpr std::uint32_t place = 7;
    std::vector<double> numbers(3 * RandomDraws::blockSize);
    std::vector<double> narrow(numbers.size());
    draws.symmetric(first, place, numbers);
    draws.symmetricNarrow(first, place, narrow);
    QCOMPARE(numbers, narrow);
    std::size_t k = 0;
    for (std::uint32_t next = place; k < numbers.size(); ++next) {
        for (const RandomDraws::WordLanes &words : draws.lanes(first, next)) {
            for (const double number : RandomDraws::symmetric(words).values())
                QCOMPARE(numbers[k++], number);
        }
    }
    for (int trial = 0; trial < Lanes::count; ++trial)
        QCOMPARE(numbers[static_cast<std::size_t>(trial)],
                 RandomDraws::symmetric(draws.words(first + trial, place)[0]));
}

void SimulatePositioning::trialsAreTheRealEvaluation_data() {
    QTest::addColumn<QString>("edition");
    QTest::addColumn<int>("up");
    QTest::addColumn<int>("down");
    QTest::addColumn<bool>("range");
    QTest::addColumn<bool>("correction");
    QTest::addColumn<bool>("gaps");
    QTest::addColumn<bool>("linear");
    QTest::newRow("1988, range method, linear drift")
        << "ISO 230-2:1988" << 5 << 5 << true << false << false << true;
    QTest::newRow("1988") << "ISO 230-2:1988" << 5 << 5 << false << false << false << false;
    QTest::newRow("2006, corrected to 20 °C")
        << "ISO 230-2:2006" << 5 << 5 << false << true << false << false;
    QTest::newRow("2006, one direction") << "ISO 230-2:2006" << 4 << 0 << false << false << false << false;
    QTest::newRow("2006, one run each way") << "ISO 230-2:2006" << 1 << 1 << false << false << false << true;
    QTest::newRow("2014, readings missing") << "ISO 230-2:2014" << 6 << 5 << false << true << true << false;
    QTest::newRow("VDI") << "VDI/DGQ 3441:1977" << 3 << 7 << false << false << true << true;
}

void SimulatePositioning::trialsAreTheRealEvaluation() {
    QFETCH(QString, edition);
    QFETCH(int, up);
    QFETCH(int, down);
    QFETCH(bool, range);
    QFETCH(bool, correction);
    QFETCH(bool, gaps);
    QFETCH(bool, linear);
    std::mt19937_64 random(42);
    std::normal_distribution<double> reading(0, 4);
    for (const std::size_t targets : {1, 2, 7, 11}) {
        std::vector<double> positions;
        for (std::size_t i = 0; i < targets; ++i)
            positions.push_back(100.0 * static_cast<double>(i) + reading(random));
        std::vector<std::vector<double>> runs[2];
        for (int k = 0; k < up + down; ++k) {
            auto &run = runs[k < up ? 0 : 1].emplace_back();
            for (std::size_t i = 0; i < targets; ++i)
                run.push_back(reading(random));
        }
        Test test = positioningTest(edition.toLatin1().constData(), positions, runs[0], runs[1]);
        PositioningMeasurement &m = measurement(test);
        stateX1(m);
        m.uncertainty.length = 600;
        m.uncertainty.driftModel = linear ? DriftModel::linear : DriftModel::independent;
        if (range)
            m.standardDeviation = DeviationMethod::range;
        if (correction)
            m.conditions.common.correctionTo20 = CorrectionTo20::appliedHere;
        if (gaps) {
            m.runs[1].deviations[targets / 2].reset();
            m.runs[2].deviations[0].reset();
        }
        const TestEvaluation evaluation = evaluated(test);
        const PositioningTrials trials(m, evaluation, positioningBudget(m, {}), 7);
        std::size_t withValue = 0;
        for (const Parameter &p : evaluation.parameters)
            withValue += p.value.has_value();
        QCOMPARE(trials.parameters().size(), withValue);
        QVERIFY(withValue > 0);
        auto place = trials.buffers();
        const auto chunk = static_cast<std::size_t>(PositioningTrials::chunk());
        std::vector<double> values(withValue * chunk);
        trials.run(0, place, values, {});
        for (std::size_t trial = 0; trial < 25; ++trial) {
            Test perturbed = test;
            perturbed.measurement = trials.perturbed(static_cast<long long>(trial));
            const TestEvaluation real = evaluated(perturbed);
            for (std::size_t p = 0; p < withValue; ++p) {
                const Parameter *expected = parameter(real, trials.parameters()[p].id);
                QVERIFY(expected && expected->value);
                QCOMPARE(values[p * chunk + trial] == *expected->value, true); // to the last bit
            }
        }
        QVERIFY(values[0] != values[1] || targets == 1);
    }
}

void SimulatePositioning::nothingGivesNothing() {
    Test test = example1988("ISO 230-2:2006");
    stateNothing(measurement(test));
    for (const SimulatedParameter &p : simulated(test, 20000).parameters) {
        QCOMPARE(p.u, 0.0);
        QCOMPARE(p.expanded(), 0.0);
        QCOMPARE(p.shift(), 0.0);
        QVERIFY(!p.largeShift());
    }
}

void SimulatePositioning::normalDevice() {
    Test test = twoTargets(5);
    measurement(test).uncertainty.device.perMetre = 3;
    const Simulation result = simulated(test);
    COMPARE_RELATIVE(of(result, "E+").u, 0.0015, statistical);
    COMPARE_RELATIVE(of(result, "E+").expanded(), 0.0030, statistical); // ±2σ hold 95.45 %
    QCOMPARE(of(result, "R+").expanded(), 0.0);
}

void SimulatePositioning::uniformErrors_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<double>("width"); // of the error at 1 000 mm, µm
    QTest::newRow("device known by its range") << 0 << 3.0;
    QTest::newRow("temperature of the machine") << 1 << 6.0;
    QTest::newRow("expansion of the machine") << 2 << 10.0;
}

void SimulatePositioning::uniformErrors() {
    QFETCH(int, which);
    QFETCH(double, width);
    Test test = twoTargets(5);
    PositioningMeasurement &m = measurement(test);
    setTemperature(m, 25);
    if (which == 0)
        m.uncertainty.device = {DeviceKind::range, 0.0, 3.0, 2};
    else if (which == 1)
        m.uncertainty.temperatureRange.machine = 0.5;
    else
        m.uncertainty.expansionRange.machine = 2;
    const Simulation result = simulated(test);
    COMPARE_RELATIVE(of(result, "E+").u, width / 1000 / std::sqrt(12.0), statistical);
    COMPARE_RELATIVE(of(result, "E+").expanded(), coverage * width / 2000, statistical);
}

void SimulatePositioning::misalignment() {
    Test test = twoTargets(5);
    measurement(test).uncertainty.misalignmentRange = 2; // cosine error up to 2 µm at 1 000 mm
    const Simulation result = simulated(test);
    COMPARE_RELATIVE(of(result, "E+").u, 0.002 / std::sqrt(12.0), statistical);
    COMPARE_RELATIVE(of(result, "E+").shift(), -0.001, statistical); // readings come out too short
}

void SimulatePositioning::independentDriftOfTwoReadings() {
    Test test = twoTargets(1);
    measurement(test).uncertainty.environmentalVariation = 3;
    // The difference of two uniform errors: triangular over ±3 µm.
    const Simulation result = simulated(test);
    COMPARE_RELATIVE(of(result, "E+").u, 0.003 / std::sqrt(6.0), statistical);
    COMPARE_RELATIVE(of(result, "E+").expanded(), 0.003 * (1 - std::sqrt(1 - coverage)), statistical);
}

void SimulatePositioning::linearDrift() {
    Test test = twoTargets(1);
    measurement(test).uncertainty.environmentalVariation = 3;
    measurement(test).uncertainty.driftModel = DriftModel::linear;
    // From the first to the second reading the drift changes by its whole, uniform over ±3 µm.
    const Simulation two = simulated(test);
    COMPARE_RELATIVE(of(two, "E+").u, 0.003 / std::sqrt(3.0), statistical);
    COMPARE_RELATIVE(of(two, "E+").expanded(), 0.003 * coverage, statistical);
    // Of five runs each has but a ninth of it between both targets.
    Test five = twoTargets(5);
    measurement(five).uncertainty = measurement(test).uncertainty;
    COMPARE_RELATIVE(of(simulated(five), "E+").u, 0.003 / 9 / std::sqrt(3.0), statistical);
    // In a step cycle the five readings of a target come together: means at 2 and 7 of 9 steps.
    measurement(five).cycle = Cycle::step;
    COMPARE_RELATIVE(of(simulated(five), "E+").u, 0.003 * 5 / 9 / std::sqrt(3.0), statistical);
}

void SimulatePositioning::driftFollowsTheOrderOfTime_data() {
    QTest::addColumn<Cycle>("cycle");
    QTest::newRow("standard cycle") << Cycle::standard;
    QTest::newRow("step cycle") << Cycle::step;
}

/// Reading by reading, in the order in which a program of the cycle would take them: −½ of the drift at the
/// first, +½ at the last, equal steps between; no reading leaves ± E_VE/2.
void SimulatePositioning::driftFollowsTheOrderOfTime() {
    QFETCH(Cycle, cycle);
    const std::vector<std::vector<double>> run(2, {0, 0, 0});
    const Test test = [&] {
        Test made = positioningTest("ISO 230-2:2006", {0, 500, 1000}, run, run);
        PositioningMeasurement &m = measurement(made);
        stateNothing(m);
        m.cycle = cycle;
        m.uncertainty.environmentalVariation = 3; // µm
        m.uncertainty.driftModel = DriftModel::linear;
        return made;
    }();
    const auto &m = std::get<PositioningMeasurement>(test.measurement);
    const PositioningTrials trials(m, evaluated(test), positioningBudget(m, {}), 7);
    const std::vector<Stop> stops = measuringCycle(3, 2, cycle);
    double largest = 0;
    for (long long trial = 0; trial < 400; ++trial) {
        const PositioningMeasurement seen = trials.perturbed(trial);
        std::vector<double> errors;
        for (const Stop &stop : stops) // runs in turn ↑ and ↓
            errors.push_back(
                *seen.runs[static_cast<std::size_t>(2 * stop.run + (stop.approach == Direction::negative))]
                     .deviations[stop.target]);
        const double drift = 2 * errors.back();
        for (std::size_t k = 0; k < errors.size(); ++k)
            QVERIFY(std::abs(errors[k] - drift * (static_cast<double>(k) / 11 - 0.5)) < 1e-15);
        largest = std::max(largest, std::abs(drift));
    }
    QVERIFY(largest <= 0.003 && largest > 0.0029); // E_VE; that of 400 uniform numbers reaches 0.99 of it
}

void SimulatePositioning::smallInputsAgreeWithTheBudget() {
    // Extremes that stay where they are: errors of 0.02 µm against steps of 10 µm and more.
    Test test = positioningTest(
        "ISO 230-2:2006", {0, 250, 500, 1000},
        {{0, 10, 20, 200}, {0, 10, 20, 200}, {0, 10, 20, 200}, {0, 10, 20, 200}, {0, 10, 20, 200}},
        {{-40, 5, 10, 140}, {-40, 5, 10, 140}, {-40, 5, 10, 140}, {-40, 5, 10, 140}, {-40, 5, 10, 140}});
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.device.perMetre = 0.02;
    const auto compare = [&](std::initializer_list<const char *> ids, double tolerance) {
        const Simulation result = simulated(test);
        const TestEvaluation budget = evaluated(test);
        for (const char *id : ids)
            COMPARE_RELATIVE(of(result, id).expanded(), *parameter(budget, id)->budgetUncertainty, tolerance);
    };
    compare({"E+", "E-"}, statistical);
    m.uncertainty.device.perMetre = 0;
    m.uncertainty.environmentalVariation = 0.02;
    // 0.6 for 0.577 is 4 % on the safe side; the rest is nearly normal.
    compare({"E+", "E-", "E", "M", "B"}, 0.04 + statistical);
}

void SimulatePositioning::scaling() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateX1(m);
    const Simulation once = simulated(test, 20000);
    for (Run &run : m.runs) {
        for (auto &reading : run.deviations)
            *reading *= 2;
    }
    *m.uncertainty.device.perMetre *= 2;
    *m.uncertainty.misalignmentRange *= std::sqrt(2.0);
    *m.uncertainty.temperatureRange.machine *= 2;
    *m.uncertainty.expansionRange.machine *= 2;
    *m.uncertainty.environmentalVariation *= 2;
    const Simulation twice = simulated(test, 20000);
    for (const SimulatedParameter &p : once.parameters) {
        COMPARE_RELATIVE(of(twice, p.id).u, 2 * p.u, 1e-9);
        COMPARE_RELATIVE(of(twice, p.id).expanded(), 2 * p.expanded(), 1e-6); // edges of the counts round
        COMPARE_RELATIVE(of(twice, p.id).mean, 2 * p.mean, 1e-9);
    }
}

void SimulatePositioning::workedExampleIsShifted() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.environmentalVariation = 3;
    m.uncertainty.method = UncertaintyMethod::monteCarlo;
    const Simulation result = simulated(test, fewestDecidingTrials);
    const SimulatedParameter &a = of(result, "A");
    QVERIFY(std::abs(a.value * 1000 - 16.23) < 0.005);
    QVERIFY2(std::abs(a.mean * 1000 - 18.2) < 0.1, qPrintable(QString::number(a.mean * 1000)));
    QVERIFY(a.largeShift());
    Surroundings surroundings = noSurroundings();
    surroundings.simulation = std::make_shared<const Simulation>(result);
    const TestEvaluation evaluation = evaluateTest(test, surroundings);
    QVERIFY(finding(evaluation, "monteCarloShift"));
    QCOMPARE(parameter(evaluation, "A")->decidedBy, UncertaintyMethod::budget);
}

void SimulatePositioning::sameFiguresOnAnyNumberOfThreads_data() {
    QTest::addColumn<bool>("adaptive");
    QTest::newRow("fixed number, not a multiple of anything") << false;
    QTest::newRow("adaptive") << true;
}

void SimulatePositioning::sameFiguresOnAnyNumberOfThreads() {
    QFETCH(bool, adaptive);
    Test test = adaptive ? twoTargets(5) : example1988("ISO 230-2:2006"); // which is stable after a million
    stateX1(measurement(test));
    const auto trials = adaptive ? std::optional<long long>() : 34567;
    const Simulation one = simulated(test, trials, 1);
    QCOMPARE(simulated(test, trials, 2), one);
    QCOMPARE(simulated(test, trials, 8), one);
}

void SimulatePositioning::fewSumsForAnyNumberOfTrials() {
    constexpr long long most = 4096;
    for (const long long chunks :
         {1LL, 2LL, most, most + 1, 2 * most, 2 * most + 1, 123'457LL, 2'000'000LL, 1'000'000'000'000LL}) {
        const long long together = chunksInGroup(chunks);
        const long long groups = (chunks + together - 1) / together;
        QVERIFY(groups >= 1 && groups <= most);
        QCOMPARE(together == 1, chunks <= most); // small numbers of trials are summed chunk by chunk
        QVERIFY((groups - 1) * together < chunks);
    }
}

void SimulatePositioning::sumsOfManyChunksAreTheSameOnAnyThreads() {
    Test test = twoTargets(1);
    measurement(test).uncertainty.device.perMetre = 3;
    measurement(test).uncertainty.environmentalVariation = 1;
    const long long trials = 4096LL * PositioningTrials::chunk() + 12345; // groups of two chunks
    const Simulation one = simulated(test, trials, 1);
    QCOMPARE(one.trials, trials);
    QCOMPARE(simulated(test, trials, 3), one);
    QCOMPARE(simulated(test, trials, 8), one);
    // As few trials say, but for chance: 2 million against 10⁵.
    COMPARE_RELATIVE(of(one, "E+").u, of(simulated(test), "E+").u, statistical);
}

void SimulatePositioning::seedsDiffer() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    SimulationOptions options;
    options.trials = 10000;
    std::vector<double> u;
    for (const long long seed : {1LL, 2LL, -1LL, 1LL << 40}) {
        options.seed = seed;
        const auto result = simulate(test, noSurroundings(), edition(test), options);
        QCOMPARE(result->seed, seed);
        QVERIFY(std::ranges::find(u, of(*result, "A").u) == u.end());
        u.push_back(of(*result, "A").u);
        COMPARE_RELATIVE(u.back(), u.front(), 0.05); // 10⁴ trials
    }
}

void SimulatePositioning::adaptiveIsStable() {
    Test test =
        positioningTest("ISO 230-2:2006", {0, 500, 1000}, {{0, 3, 5}, {1, 2, 6}}, {{2, 4, 9}, {1, 6, 8}});
    stateX1(measurement(test));
    const Simulation result = simulated(test, std::nullopt);
    QVERIFY(result.stable);
    QVERIFY(result.trials >= 220000);
    QCOMPARE(result.trials % 10000, 0LL);
    QVERIFY(result.mayDecide());
    // The figures are those of all trials together, not of blocks.
    const Simulation same = simulated(test, result.trials);
    for (const SimulatedParameter &p : result.parameters)
        QCOMPARE(p, of(same, p.id));
    const Simulation many = simulated(test, 300000);
    for (const SimulatedParameter &p : result.parameters)
        COMPARE_RELATIVE(p.u, of(many, p.id).u, 0.02); // two digits
}

void SimulatePositioning::adaptiveGoesOnUntilAllIsStable() {
    // u of E↑ just above a power of ten has a coarse tolerance, just below it a fine one: ten times the
    // digits, and 2s of every figure is below it at the end, by blocks of our own.
    Test test = twoTargets(5);
    long long trials[2]{};
    for (int k = 0; k < 2; ++k) {
        measurement(test).uncertainty.device.perMetre = 2 * (k == 0 ? 1.05 : 0.985); // u in µm
        const Simulation result = simulated(test, std::nullopt);
        QVERIFY(result.stable);
        const double tolerance = k == 0 ? 0.05e-3 : 0.005e-3;
        const SimulatedParameter &e = of(result, "E+");
        QVERIFY(std::abs(e.tolerance() - tolerance) < 1e-12);
        trials[k] = result.trials;
        QVERIFY(2 * *e.expandedError <= tolerance);
        QVERIFY(std::abs(e.u * 1000 - (k == 0 ? 1.05 : 0.985)) < 0.01);
    }
    QVERIFY2(trials[1] > trials[0] && trials[0] >= 220000,
             qPrintable(QStringLiteral("%1 and %2").arg(trials[0]).arg(trials[1])));
    QVERIFY(trials[1] <= 10'000'000);
}

void SimulatePositioning::constantsDoNotGoOn() {
    // R is the same in every trial but for rounding: that is no uncertainty to wait for.
    Test test = example1988("ISO 230-2:2006");
    stateNothing(measurement(test));
    measurement(test).uncertainty.device.perMetre = 1;
    const Simulation result = simulated(test, std::nullopt);
    QVERIFY(result.stable);
    QVERIFY(result.trials < 10'000'000);
    QVERIFY(of(result, "R").u < 1e-15);
}

void SimulatePositioning::errorOfU() {
    // s_U of N trials tells how far runs of other seeds lie apart: 12 of them, each with 22 blocks.
    Test test = twoTargets(5);
    measurement(test).uncertainty.device.perMetre = 3;
    SimulationOptions options;
    options.trials = 220000;
    std::vector<double> found;
    double told = 0;
    constexpr int seeds = 12;
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = seed;
        const Simulation result = simulate(test, noSurroundings(), edition(test), options).value();
        found.push_back(of(result, "E+").expanded());
        told += *of(result, "E+").expandedError / seeds;
    }
    double mean = 0;
    double squares = 0;
    for (const double u : found)
        mean += u / seeds;
    for (const double u : found)
        squares += (u - mean) * (u - mean) / (seeds - 1);
    // The s of 12 is known to 21 %; of all trials together U scatters no more than the average of blocks.
    QVERIFY2(std::sqrt(squares) < 1.7 * told && std::sqrt(squares) > 0.3 * told,
             qPrintable(QStringLiteral("%1, told %2").arg(std::sqrt(squares)).arg(told)));
    options.trials = 19999; // one block: not known
    QVERIFY(!of(simulate(test, noSurroundings(), edition(test), options).value(), "E+").expandedError);
}

void SimulatePositioning::oneTargetAndDirectionRulesA() {
    // A = R↑ = 4s of one target: its U by simulation against 2·U_EVE of the budget, U_EVE = 0.6 E_VE.
    Test test = positioningTest("ISO 230-2:2006", {0, 500, 1000},
                                {{0, -9, 0}, {0, 9, 0}, {0, -9, 0}, {0, 9, 0}, {0, 0, 0}},
                                {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    stateNothing(measurement(test));
    measurement(test).uncertainty.environmentalVariation = 1;
    const SimulatedParameter a = of(simulated(test), "A");
    const double budget = *parameter(evaluated(test), "A")->budgetUncertainty;
    COMPARE_RELATIVE(budget, 0.0012, 1e-9);
    // 0.6 for 0.577 and a sum of uniform errors: U a little below; two ends taken as uncorrelated give 0.930.
    COMPARE_RELATIVE(a.expanded(), 0.577350 / 0.6 * budget, 0.02);
}

void SimulatePositioning::fixedNumber() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    for (const long long trials : {1LL, 3LL, 499LL, 501LL, 10000LL, 10001LL}) {
        const Simulation result = simulated(test, trials);
        QCOMPARE(result.trials, trials);
        QVERIFY(!result.mayDecide() && !result.adaptive);
        long long counted = 0;
        for (const long long count : of(result, "A").histogram.counts)
            counted += count;
        QCOMPARE(counted, trials);
    }
}

void SimulatePositioning::cancel() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    SimulationOptions options;
    options.trials = 100000000;
    for (int attempt = 0; attempt < 3; ++attempt) {
        std::stop_source source;
        std::clock_t stopped = 0; // processor time: what others do with the machine does not count
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            stopped = std::clock();
            source.request_stop();
        });
        QVERIFY(!simulate(test, noSurroundings(), edition(test), options, source.get_token()));
        stopper.join();
        const double seconds = static_cast<double>(std::clock() - stopped) / CLOCKS_PER_SEC;
        QVERIFY2(seconds <= 0.1, qPrintable(QString::number(seconds)));
    }
}

void SimulatePositioning::progress() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    SimulationOptions options;
    options.trials = 50000;
    options.threads = 2;
    long long last = 0;
    bool rising = true;
    const auto thread = std::this_thread::get_id();
    bool sameThread = true;
    const auto result =
        simulate(test, noSurroundings(), edition(test), options, {}, [&](const SimulationProgress &progress) {
            rising &= progress.trials > last && progress.of == 50000;
            last = progress.trials;
            sameThread &= std::this_thread::get_id() == thread;
        });
    QVERIFY(result);
    QVERIFY(rising);
    QVERIFY(sameThread);
    QVERIFY(last > 10000 && last <= 50000);
}

void SimulatePositioning::histogram() {
    Test test = twoTargets(5);
    measurement(test).uncertainty.device.perMetre = 3;
    const SimulatedParameter e = of(simulated(test), "E+");
    const Histogram &h = e.histogram;
    QVERIFY(!h.counts.empty() && h.width > 0);
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < h.counts.size(); ++k) {
        sum += (h.from + (static_cast<double>(k) + 0.5) * h.width) * static_cast<double>(h.counts[k]);
        count += static_cast<double>(h.counts[k]);
    }
    QVERIFY(std::abs(sum / count - e.mean) < h.width / 10);
    const auto middle = std::ranges::max_element(h.counts) - h.counts.begin();
    QVERIFY(std::abs(h.from + (static_cast<double>(middle) + 0.5) * h.width - e.mean) < 0.5 * e.u);
}

void SimulatePositioning::incompleteBudget() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    measurement(test).uncertainty.environmentalVariation.reset();
    QVERIFY(!simulate(test, noSurroundings(), edition(test), {}));
    Surroundings drift = noSurroundings();
    drift.environmentalVariation = 0.003;
    SimulationOptions options;
    options.trials = 10000;
    QVERIFY(simulate(test, drift, edition(test), options));
}

void SimulatePositioning::rotary() {
    Test test = positioningTest("ISO 230-2:2006", {0, 90}, {{0, 100}, {0, 100}}, {});
    PositioningMeasurement &m = measurement(test);
    m.axis.motion = Motion::rotary;
    m.uncertainty.device.fixed = 1;
    m.uncertainty.environmentalVariation = 0;
    const Simulation result = simulated(test);
    COMPARE_RELATIVE(of(result, "E+").u * 3600, 0.5, statistical);
}

QTEST_APPLESS_MAIN(SimulatePositioning)
#include "simulatepositioning.moc"
