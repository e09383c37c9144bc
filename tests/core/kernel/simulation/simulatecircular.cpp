// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/simulation/simulate.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/simulation/circulartrials.h"

#include <QTest>
#include <ctime>

#include <cmath>
#include <numbers>
#include <random>
#include <thread>

using namespace palmer;
using namespace palmer::testdata;

/// Monte Carlo of circular tests through points, circles and results.
class SimulateCircular : public QObject {
    Q_OBJECT

private slots:
    void trialsAreTheRealEvaluation_data();
    void trialsAreTheRealEvaluation();
    void everyTrialIsThePlainWay_data();
    void everyTrialIsThePlainWay();
    void noiseAlone();
    void nothingGivesNothing();
    void displacement();
    void lengths();
    void driftBetweenThePaths();
    void repeatability();
    void sameFiguresOnAnyNumberOfThreads();
    void cancelWithManyPoints();
    void partOfTheResults();
};

namespace {

Surroundings noSurroundings() {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    return surroundings;
}

/// An oval circle with a hysteresis, so that the extremes stay where they are.
Test ovalTest(int n) {
    Test test = circularTest(n);
    for (Arc &arc : circle(test).arcs) {
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            const double angle = arc.angles[i] * std::numbers::pi / 180;
            arc.radialDeviations[i] = 0.010 * std::cos(2 * angle) +
                                      (arc.sense == Sense::clockwise ? 0.002 * std::sin(2 * angle) : 0);
        }
    }
    return test;
}

Simulation simulated(const Test &test, long long trials = 3000, int threads = 2) {
    SimulationOptions options;
    options.trials = trials;
    options.threads = threads;
    const auto result = simulate(test, noSurroundings(), *findEdition(test.edition), options);
    if (!result)
        qFatal("no simulation");
    return *result;
}

const SimulatedParameter &of(const Simulation &simulation, std::string_view id) {
    const SimulatedParameter *found = simulation.find(id);
    if (!found)
        qFatal("no parameter");
    return *found;
}

/// The statistical error of u of 3 000 trials is 1.3 %.
constexpr double statistical = 0.045;

#define COMPARE_RELATIVE(found, expected, tolerance)                                                         \
    QVERIFY2(std::abs((found) - (expected)) <= (tolerance)*std::abs(expected),                               \
             qPrintable(QStringLiteral(#found " is %1, not %2").arg(found, 0, 'g', 12).arg(expected)))

} // namespace

void SimulateCircular::trialsAreTheRealEvaluation_data() {
    QTest::addColumn<bool>("commanded");
    QTest::addColumn<bool>("setUp");
    QTest::addColumn<bool>("leastSquares");
    QTest::addColumn<QString>("edition");
    QTest::newRow("polar") << false << false << false << "ISO 230-4:2005";
    QTest::newRow("polar, set-up centring, range of the least squares circle")
        << false << true << true << "ISO 230-4:2022";
    QTest::newRow("commanded angles") << true << false << false << "ISO 230-4:2005";
    QTest::newRow("1996") << false << false << false << "ISO 230-4:1996";
}

void SimulateCircular::trialsAreTheRealEvaluation() {
    QFETCH(bool, commanded);
    QFETCH(bool, setUp);
    QFETCH(bool, leastSquares);
    QFETCH(QString, edition);
    Test test = ovalTest(40);
    test.edition = edition.toStdString();
    CircularMeasurement &m = circle(test);
    m.arcs.push_back(m.arcs.front()); // a repetition
    for (Arc &arc : m.arcs) {
        if (commanded)
            arc.angleReference = AngleReference::commanded;
        arc.radialDeviations[3] += 0.0007;
    }
    if (setUp)
        m.centring = Centring::instrument;
    if (leastSquares)
        m.referenceCircle = ReferenceCircle::leastSquares;
    CircularUncertaintyInputs &inputs = m.uncertainty;
    inputs.displacement.expanded = 0.5;
    inputs.resolution = 0.1;
    inputs.pointNoise = 0.2;
    inputs.environmentalVariation = 0.4;
    inputs.centring = 0.3;
    m.referenceLength.expandedUncertainty = 0.6;
    const TestEvaluation evaluation = evaluated(test);
    const CircularTrials trials(test, m, noSurroundings(), evaluation, 3);
    QCOMPARE(trials.parameters().size(), evaluation.parameters.size());
    auto place = trials.buffers();
    const auto chunk = static_cast<std::size_t>(trials.chunk());
    std::vector<double> values(trials.parameters().size() * chunk);
    trials.run(0, place, values, {});
    for (std::size_t trial = 0; trial < 10; ++trial) {
        Test perturbed = test;
        perturbed.measurement = trials.perturbed(static_cast<long long>(trial));
        const TestEvaluation real = evaluated(perturbed);
        for (std::size_t p = 0; p < trials.parameters().size(); ++p) {
            const Parameter *expected = parameter(real, trials.parameters()[p].id);
            // To the last digits: the points are the same, the circles are fitted by the same functions.
            QVERIFY2(std::abs(values[p * chunk + trial] - *expected->value) <= 1e-12,
                     trials.parameters()[p].id.c_str());
            QVERIFY(std::abs(*expected->value - trials.parameters()[p].value) > 1e-9);
        }
    }
}

namespace {

struct Case {
    int points = 90; ///< each way
    double arc = 360;
    double form = 0.005;  ///< mm
    double offset = 0.01; ///< mm
    double step = 0;      ///< of the readings, mm
    double noise = 0.1;   ///< µm
    double resolution = 0.1;
    double common = 0.5; ///< drift and displacement, µm
    bool commanded = false;
    bool setUp = false;
    bool leastSquares = false;
    bool repeated = false;
    const char *edition = "ISO 230-4:2005";
    bool quick = true; ///< nearly no circle has to go the plain way
};

Test testOf(const Case &of) {
    Test test = circularTest(of.points);
    test.edition = of.edition;
    CircularMeasurement &m = circle(test);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0, of.form / 50);
    for (Arc &arc : m.arcs) {
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            arc.angles[i] *= of.arc / 360;
            const double angle = arc.angles[i] * std::numbers::pi / 180;
            double d = of.offset * std::cos(angle - 0.5) + of.form * std::cos(2 * angle) +
                       of.form / 3 * std::sin(3 * angle + (arc.sense == Sense::clockwise ? 1 : 0)) +
                       normal(random);
            if (of.step > 0)
                d = std::round(d / of.step) * of.step;
            arc.radialDeviations[i] = d;
        }
        if (of.commanded)
            arc.angleReference = AngleReference::commanded;
    }
    if (of.repeated) {
        m.arcs.push_back(m.arcs.back());
        m.arcs.push_back(m.arcs.front());
    }
    if (of.setUp)
        m.centring = Centring::instrument;
    if (of.leastSquares)
        m.referenceCircle = ReferenceCircle::leastSquares;
    m.uncertainty.pointNoise = of.noise;
    m.uncertainty.resolution = of.resolution;
    m.uncertainty.displacement.expanded = of.common;
    m.uncertainty.environmentalVariation = of.common;
    m.uncertainty.centring = of.common;
    return test;
}

} // namespace

Q_DECLARE_METATYPE(Case)

void SimulateCircular::everyTrialIsThePlainWay_data() {
    QTest::addColumn<Case>("of");
    QTest::newRow("as most") << Case{};
    QTest::newRow("more points") << Case{.points = 601};
    QTest::newRow("noise alone") << Case{.form = 0, .offset = 0};
    QTest::newRow("no noise") << Case{.noise = 0, .resolution = 0, .quick = false};
    QTest::newRow("resolution alone") << Case{.step = 1e-4, .noise = 0};
    QTest::newRow("ties that stay") << Case{
        .offset = 0, .step = 1e-3, .noise = 0, .resolution = 0, .quick = false};
    QTest::newRow("little noise") << Case{.noise = 1e-4, .resolution = 0, .common = 0};
    QTest::newRow("large noise") << Case{.noise = 50, .resolution = 20, .common = 100, .quick = false};
    QTest::newRow("tiny deviations") << Case{.form = 1e-6, .offset = 1e-6};
    QTest::newRow("large deviations") << Case{.form = 0.5, .offset = 1, .quick = false};
    QTest::newRow("far off the centre") << Case{.offset = 0.3};
    QTest::newRow("a quarter") << Case{.arc = 90.5};
    QTest::newRow("half a circle, range of the least squares circle")
        << Case{.arc = 180, .leastSquares = true, .quick = false};
    QTest::newRow("several arcs") << Case{.repeated = true};
    QTest::newRow("set-up centring") << Case{.setUp = true};
    QTest::newRow("range of the least squares circle, 2022")
        << Case{.leastSquares = true, .edition = "ISO 230-4:2022"};
    QTest::newRow("commanded angles") << Case{.commanded = true};
    QTest::newRow("commanded angles, far off the centre, several arcs")
        << Case{.offset = 0.3, .commanded = true, .repeated = true};
    QTest::newRow("1996") << Case{.edition = "ISO 230-4:1996"};
    QTest::newRow("1996, commanded, set-up centring")
        << Case{.commanded = true, .setUp = true, .edition = "ISO 230-4:1996"};
}

void SimulateCircular::everyTrialIsThePlainWay() {
    QFETCH(Case, of);
    const Test test = testOf(of);
    const TestEvaluation evaluation = evaluated(test);
    const auto &measurement = std::get<CircularMeasurement>(test.measurement);
    const CircularTrials trials(test, measurement, noSurroundings(), evaluation, 11);
    QVERIFY(!trials.parameters().empty());
    auto place = trials.buffers();
    const auto chunk = static_cast<std::size_t>(trials.chunk());
    constexpr std::size_t all = 200;
    std::vector<double> values(trials.parameters().size() * chunk);
    for (std::size_t first = 0; first < all; first += chunk) {
        trials.run(static_cast<long long>(first), place, values, {});
        for (std::size_t k = 0; k < chunk && first + k < all; ++k) {
            Test perturbed = test;
            perturbed.measurement = trials.perturbed(static_cast<long long>(first + k));
            const TestEvaluation real = evaluated(perturbed);
            for (std::size_t p = 0; p < trials.parameters().size(); ++p) {
                const std::string &id = trials.parameters()[p].id;
                const double expected = *parameter(real, id)->value;
                const double found = values[p * chunk + k];
                // Minimum zones are the same bits where the points are; least squares circles are found to
                // rounding, and so is the centring error of commanded angles.
                const bool bits = id.starts_with('G') && !of.leastSquares && !of.commanded;
                QVERIFY2(std::abs(found - expected) <= (bits ? 0 : 2e-12),
                         qPrintable(QStringLiteral("%1 of trial %2: %3 not %4")
                                        .arg(QString::fromStdString(id))
                                        .arg(first + k)
                                        .arg(found, 0, 'g', 17)
                                        .arg(expected, 0, 'g', 17)));
            }
        }
    }
    // From four points of no shape the exchange now and then finds a ring that is not the least of all.
    if (of.quick)
        QVERIFY2(place.plain <= 20, qPrintable(QString::number(place.plain)));
}

void SimulateCircular::noiseAlone() {
    Test test = circularTest(600);
    circle(test).uncertainty.pointNoise = 0.1;
    const Simulation result = simulated(test, 1000);
    // The width of 600 normal points of 0.1 µm about their best circle.
    QVERIFY2(std::abs(of(result, "G_XY").mean * 1000 - 0.59) < 0.01,
             qPrintable(QString::number(of(result, "G_XY").mean * 1000)));
    QVERIFY(of(result, "G(b)_XY").mean > of(result, "G_XY").mean); // more points, more width
    QVERIFY(of(result, "G_XY").largeShift());
    COMPARE_RELATIVE(of(result, "D_XY").u, 0.0001 / std::sqrt(1200.0), 0.08); // of 1 000 trials
    QVERIFY(std::abs(of(result, "D_XY").shift()) < 4e-7);                     // four deviations of the mean
}

void SimulateCircular::nothingGivesNothing() {
    for (const SimulatedParameter &p : simulated(ovalTest(36), 1000).parameters) {
        QCOMPARE(p.u, 0.0);
        QCOMPARE(p.expanded(), 0.0);
        QVERIFY(std::abs(p.shift()) < 1e-12);
    }
}

void SimulateCircular::displacement() {
    Test test = ovalTest(40);
    circle(test).uncertainty.displacement.expanded = 0.4;
    const Simulation result = simulated(test);
    // The scale is uncertain by 0.4 µm over the range of the deviations, which G(b) is nearly all of.
    COMPARE_RELATIVE(of(result, "G(b)_XY").u, 0.0002, 0.05);
    COMPARE_RELATIVE(of(result, "D_XY").u, 0.0002, statistical);
}

void SimulateCircular::lengths() {
    Test test = ovalTest(40);
    CircularMeasurement &m = circle(test);
    m.referenceLength.expandedUncertainty = 0.6;
    m.conditions.common.sensors = {{SensorMeasures::machine, "", 23.0, 23.0, std::nullopt},
                                   {SensorMeasures::instrument, "", 23.0, 23.0, std::nullopt}};
    m.conditions.common.expansion = {11.5, 1.2};
    m.uncertainty.temperatureStandardUncertainty = {0.3, 0.3};
    m.uncertainty.expansionStandardUncertainty = {1.0, 0.2};
    const Simulation result = simulated(test);
    const double expected = *parameter(evaluated(test), "D_XY")->budgetUncertainty / 2;
    for (const char *id : {"D_XY", "Fmax_XY", "Fmin_YX"})
        COMPARE_RELATIVE(of(result, id).u, expected, statistical);
    QVERIFY(of(result, "G_XY").u < 1e-8); // a larger circle is as round
}

void SimulateCircular::driftBetweenThePaths() {
    Test test = ovalTest(40);
    circle(test).uncertainty.environmentalVariation = 0.6;
    const Simulation result = simulated(test);
    // The mean of two uniform drifts.
    COMPARE_RELATIVE(of(result, "D_XY").u, 0.0006 / std::sqrt(12.0) / std::sqrt(2.0), statistical);
    COMPARE_RELATIVE(of(result, "Fmax_XY").u, 0.0006 / std::sqrt(12.0), statistical);
    QVERIFY(of(result, "G_XY").u < 1e-8);
    QVERIFY(of(result, "G(b)_XY").u > 1e-5);
}

void SimulateCircular::repeatability() {
    Test test = ovalTest(40);
    circle(test).uncertainty.repeatability = 0.25;
    const Simulation result = simulated(test);
    for (const SimulatedParameter &p : result.parameters)
        COMPARE_RELATIVE(p.u, 0.00025, statistical);
}

void SimulateCircular::sameFiguresOnAnyNumberOfThreads() {
    for (const char *edition : {"ISO 230-4:2005", "ISO 230-4:1996"}) {
        Test test = ovalTest(20);
        test.edition = edition;
        circle(test).uncertainty.pointNoise = 0.3;
        circle(test).uncertainty.resolution = 0.1;
        const Simulation one = simulated(test, 10150, 1);
        QCOMPARE(simulated(test, 10150, 2), one);
        QCOMPARE(simulated(test, 10150, 8), one);
    }
}

void SimulateCircular::cancelWithManyPoints() {
    Test test = ovalTest(20000);
    circle(test).uncertainty.pointNoise = 0.3;
    SimulationOptions options;
    options.trials = 1000000;
    for (int attempt = 0; attempt < 3; ++attempt) {
        std::stop_source source;
        std::clock_t stopped = 0; // processor time: what others do with the machine does not count
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            stopped = std::clock();
            source.request_stop();
        });
        QVERIFY(!simulate(test, noSurroundings(), *findEdition(test.edition), options, source.get_token()));
        stopper.join();
        const double seconds = static_cast<double>(std::clock() - stopped) / CLOCKS_PER_SEC;
        QVERIFY2(seconds <= 1, qPrintable(QString::number(seconds))); // a million trials take minutes
    }
}

void SimulateCircular::partOfTheResults() {
    Test test = ovalTest(36);
    circle(test).referenceLength.expandedUncertainty.reset(); // F and D have no uncertainty, G has
    circle(test).uncertainty.pointNoise = 0.3;
    const Simulation result = simulated(test, 1000);
    QVERIFY(result.find("G_XY"));
    QVERIFY(!result.find("D_XY"));
}

QTEST_APPLESS_MAIN(SimulateCircular)
#include "simulatecircular.moc"
