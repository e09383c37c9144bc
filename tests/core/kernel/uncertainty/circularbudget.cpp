// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/circularbudget.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "core/kernel/words/written.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace palmer;
using namespace palmer::testdata;

using Change = std::function<void(CircularMeasurement &)>;
Q_DECLARE_METATYPE(Change)

/// The uncertainty budgets of circular tests.
class CircularBudgetTest : public QObject {
    Q_OBJECT

private slots:
    void correction_data();
    void correction();
    void combination();
    void setUpCentring();
    void repeatedCircles();
    void nothingGivesNothing();
    void coverageFactors();
    void inputsSayHow();
    void driftTestAndNumbers();
    void statedZeroNeedsNothingElse();
    void unknown_data();
    void unknown();
};

namespace {

/// R 150, machine and instrument 3 °C away, u(T) 0.3, α_i 1.2 ± 0.2, α_m 11.5 ± 1.
void stateTemperatures(CircularMeasurement &m) {
    m.conditions.common.sensors = {{SensorMeasures::machine, "", 23.0, 23.0, std::nullopt},
                                   {SensorMeasures::instrument, "", 23.0, 23.0, std::nullopt}};
    m.conditions.common.expansion = {11.5, 1.2};
    m.uncertainty.temperatureStandardUncertainty = {0.3, 0.3};
    m.uncertainty.expansionStandardUncertainty = {1.0, 0.2};
}

double uncertainty(const TestEvaluation &evaluation, std::string_view id) {
    const Parameter *p = parameter(evaluation, id);
    return p && p->expandedUncertainty ? *p->expandedUncertainty * 1000
                                       : std::numeric_limits<double>::quiet_NaN();
}

#define COMPARE_NEAR(found, expected, tolerance)                                                             \
    QVERIFY2(std::abs((found) - (expected)) <= (tolerance),                                                  \
             qPrintable(QStringLiteral(#found " is %1, not %2").arg(found, 0, 'g', 12).arg(expected)))

} // namespace

void CircularBudgetTest::correction_data() {
    QTest::addColumn<bool>("sameSensor");
    QTest::addColumn<double>("expected");
    QTest::newRow("two sensors") << false << 0.694;
    QTest::newRow("one sensor for both") << true << 0.652;
}

void CircularBudgetTest::correction() {
    QFETCH(bool, sameSensor);
    QFETCH(double, expected);
    Test test = circularTest(36);
    stateTemperatures(circle(test));
    circle(test).uncertainty.sameSensor = sameSensor;
    const CircularBudget budget = circularBudget(circle(test), {}, {}, 72);
    const double u = *budget.find("correction")->expanded / 2 * 1000;
    COMPARE_NEAR(u, expected, 0.0005); // printed to three decimals
}

void CircularBudgetTest::combination() {
    Test test = circularTest(36);
    CircularMeasurement &m = circle(test);
    stateTemperatures(m);
    m.referenceLength.expandedUncertainty = 0.8;
    CircularUncertaintyInputs &inputs = m.uncertainty;
    inputs.displacement.expanded = 0.6;
    inputs.resolution = 0.1;
    inputs.repeatability = 0.2;
    inputs.environmentalVariation = 0.5;
    inputs.pointNoise = 0.3;
    inputs.centring = 5; // set-up centring only
    const double common = 0.09 + 0.01 / 12 + 0.04 + 0.25 / 12;
    const double c = std::pow(*circularBudget(m, {}, {}, 72).find("correction")->expanded * 500, 2);
    const TestEvaluation evaluation = evaluated(test);
    for (const char *id : {"G_XY", "G_YX", "G(b)_XY"})
        COMPARE_NEAR(uncertainty(evaluation, id), 2 * std::sqrt(common), 1e-12);
    for (const char *id : {"Fmax_XY", "Fmin_XY", "Fmax_YX", "Fmin_YX"})
        COMPARE_NEAR(uncertainty(evaluation, id), 2 * std::sqrt(common + 0.16 + c), 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "D_XY"), 2 * std::sqrt(common + 0.16 + c + 0.09 / 72), 1e-12);
}

void CircularBudgetTest::setUpCentring() {
    Test test = circularTest(36);
    circle(test).centring = Centring::instrument;
    circle(test).uncertainty.centring = 5;
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "Fmax_XY"), 10.0, 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "D_XY"), 0.0, 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "G_XY"), 0.0, 1e-12);
}

void CircularBudgetTest::repeatedCircles() {
    Test test = circularTest(36);
    CircularMeasurement &m = circle(test);
    m.uncertainty.repeatability.reset();
    m.referenceCircle = ReferenceCircle::leastSquares;
    // Nothing repeated: unknown.
    QVERIFY(finding(evaluated(test), "repeatability"));
    // Counterclockwise twice more, with 2 and 4 µm of ovality: G 0, 2·2, 2·4 µm … s of 0, 4, 8 is 4.
    for (const double size : {0.002, 0.004}) {
        Arc arc = m.arcs[0];
        for (std::size_t i = 0; i < arc.angles.size(); ++i)
            arc.radialDeviations[i] = size * std::cos(2 * arc.angles[i] * 3.14159265358979 / 180);
        m.arcs.push_back(arc);
    }
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "G_XY"), 8.0, 0.01); // the ellipse is not quite its first harmonic
    // Clockwise was not repeated: the largest s of the others stands for it, on the safe side.
    QVERIFY(uncertainty(evaluation, "G_YX") >= uncertainty(evaluation, "G_XY"));
    QVERIFY(!finding(evaluation, "repeatability"));
    m.uncertainty.repeatability = 1; // a number wins
    COMPARE_NEAR(uncertainty(evaluated(test), "G_XY"), 2.0, 1e-12);
}

void CircularBudgetTest::nothingGivesNothing() {
    for (const char *edition : {"ISO 230-4:1996", "ISO 230-4:2005", "ISO 230-4:2022"}) {
        Test test = circularTest(36);
        test.edition = edition;
        for (const Parameter &p : evaluated(test).parameters) {
            QVERIFY2(p.expandedUncertainty.has_value(), p.term.id);
            QCOMPARE(*p.expandedUncertainty, 0.0);
        }
    }
}

void CircularBudgetTest::coverageFactors() {
    Test test = circularTest(36);
    circle(test).uncertainty.displacement = {0.9, 3};
    circle(test).referenceLength = {true, 1.2, 3};
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "G_XY"), 0.6, 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "D_XY"), 1.0, 1e-12);
}

void CircularBudgetTest::inputsSayHow() {
    Test test = circularTest(36);
    CircularMeasurement &m = circle(test);
    stateTemperatures(m);
    m.uncertainty.displacement = {0.9, 2};
    m.referenceLength = {true, 1.2, 3};
    m.uncertainty.resolution = 0.1;
    m.uncertainty.repeatability = 0.2;
    m.uncertainty.environmentalVariation = 0.5;
    m.uncertainty.pointNoise = 0.3;
    m.uncertainty.centring = 5;
    const auto says = [&](const char *id, std::optional<double> repeated = {}) {
        const Contribution *found = nullptr;
        const CircularBudget budget = circularBudget(m, {}, repeated, 72);
        found = budget.find(id);
        if (!found || found->name.empty() || !found->applies)
            qFatal("no contribution");
        return QByteArray(found->inputs.text.source) + " | " + written(found->inputs);
    };
    QCOMPARE(says("displacement"), QByteArray("%1 | 0.9 µm"));
    QCOMPARE(says("referenceLength"), QByteArray("%1 · 2/%2 | 1.2 µm; 3"));
    QCOMPARE(says("resolution"), QByteArray("2 · %1 / √12 | 0.1 µm"));
    QCOMPARE(says("repeatability"), QByteArray("2 · %1 | 0.2 µm"));
    QCOMPARE(says("environmentalVariation"), QByteArray("2 · %1 / √12 | 0.5 µm"));
    QCOMPARE(says("centring"), QByteArray("2 · %1 | 5 µm"));
    QCOMPARE(says("pointNoise"), QByteArray("2 · %1 / √%2 | 0.3 µm; 72n"));
    // R·√(0.3²·(11.5² + 1.2²) + 3²·(1² + 0.2²)) = 150·√(12.032 + 9.36) = 0.693 77 µm
    QVERIFY(says("correction").endsWith("| 0.693774 µm.3"));
    m.uncertainty.repeatability.reset();
    QVERIFY(says("repeatability", 0.0004).endsWith("repeated circles | 0.4 µm.3"));
    QCOMPARE(*circularBudget(m, {}, 0.0004, 72).find("repeatability")->expanded, 0.0008);
}

void CircularBudgetTest::driftTestAndNumbers() {
    Test test = circularTest(36);
    CircularMeasurement &m = circle(test);
    m.uncertainty.environmentalVariation.reset();
    const auto drift = [&] {
        return *circularBudget(m, 0.004, {}, 72).find("environmentalVariation")->expanded;
    };
    COMPARE_NEAR(drift(), 0.008 / std::sqrt(12.0), 1e-15); // of the drift test, mm
    m.uncertainty.environmentalVariation = 1;              // a number wins, µm
    COMPARE_NEAR(drift(), 0.002 / std::sqrt(12.0), 1e-15);
    // noise without points: that of one
    m.uncertainty.pointNoise = 0.5;
    COMPARE_NEAR(*circularBudget(m, {}, {}, 0).find("pointNoise")->expanded, 0.001, 1e-15);
    COMPARE_NEAR(*circularBudget(m, {}, {}, 4).find("pointNoise")->expanded, 0.0005, 1e-15);
}

void CircularBudgetTest::statedZeroNeedsNothingElse() {
    Test test = circularTest(36);
    CircularMeasurement &m = circle(test);
    const auto defects = [&] {
        QByteArrayList keys;
        const CircularBudget budget = circularBudget(m, {}, {}, 72);
        for (const InputDefect &defect : budget.find("correction")->defects)
            keys << QByteArray(defect.key) + (defect.impossible ? "!" : "");
        return keys.join(' ');
    };
    QCOMPARE(defects(), QByteArray()); // all u are 0: neither temperature nor α is needed
    m.uncertainty.temperatureStandardUncertainty = {0.3, {}};
    QCOMPARE(defects(), QByteArray("expansion temperatureStandardUncertainty expansion"));
    m.conditions.common.expansion = {0.0, 0.0}; // a stated 0 needs no u
    QCOMPARE(defects(), QByteArray());
    m.uncertainty.temperatureStandardUncertainty = {0.3, -1};
    QCOMPARE(defects(), QByteArray("temperatureStandardUncertainty!"));
    m.uncertainty.temperatureStandardUncertainty = {0.0, 0.0};
    m.uncertainty.expansionStandardUncertainty = {1.0, {}};
    QCOMPARE(defects(), QByteArray("sensors expansionStandardUncertainty sensors"));
    m.conditions.common.sensors = {{SensorMeasures::machine, "", 20.0, 20.0, std::nullopt},
                                   {SensorMeasures::instrument, "", 19.5, 20.5, std::nullopt}};
    QCOMPARE(defects(), QByteArray()); // at 20 °C
    // one sensor for both: the machine's stands for the instrument's, and the other way round
    m.conditions.common.sensors.pop_back();
    QCOMPARE(defects(), QByteArray("expansionStandardUncertainty sensors"));
    m.uncertainty.sameSensor = true;
    QCOMPARE(defects(), QByteArray());
    m.conditions.common.sensors[0].measures = SensorMeasures::instrument;
    QCOMPARE(defects(), QByteArray());
    m.conditions.common.expansion = {11.5, {}};
    m.uncertainty.temperatureStandardUncertainty = {0.3, {}};
    QCOMPARE(defects(), QByteArray("expansion"));
    m.conditions.common.expansion.instrument = 1.5;
    m.uncertainty.temperatureStandardUncertainty = {{}, 0.3}; // either stands for both
    // 150·10 µm/(m·°C)·0.3 °C = 0.45 µm, U = 0.9 µm
    COMPARE_NEAR(*circularBudget(m, {}, {}, 72).find("correction")->expanded, 0.0009, 1e-15);
}

void CircularBudgetTest::unknown_data() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    using M = CircularMeasurement;
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("widthsToo");
    QTest::addColumn<Change>("change");
    const auto row = [](const char *name, const char *id, bool widthsToo, const Change &change) {
        QTest::newRow(name) << id << widthsToo << change;
    };
    row("no displacement", "displacement", true, [](M &m) { m.uncertainty.displacement.expanded.reset(); });
    row("negative displacement", "displacement", true,
        [](M &m) { m.uncertainty.displacement.expanded = -1; });
    row("coverage factor of zero", "displacement", true,
        [](M &m) { m.uncertainty.displacement.coverageFactor = 0; });
    row("no resolution", "resolution", true, [](M &m) { m.uncertainty.resolution.reset(); });
    row("infinite resolution", "resolution", true, [=](M &m) { m.uncertainty.resolution = infinity; });
    row("no repeatability", "repeatability", true, [](M &m) { m.uncertainty.repeatability.reset(); });
    row("no environmental variation", "environmentalVariation", true,
        [](M &m) { m.uncertainty.environmentalVariation.reset(); });
    row("no reference length", "referenceLength", false,
        [](M &m) { m.referenceLength.expandedUncertainty.reset(); });
    row("negative reference length", "referenceLength", false,
        [](M &m) { m.referenceLength.expandedUncertainty = -1; });
    row("no uncertainty of the temperature", "temperatureStandardUncertainty", false,
        [](M &m) { m.uncertainty.temperatureStandardUncertainty.machine.reset(); });
    row("negative uncertainty of the coefficient", "expansionStandardUncertainty", false,
        [](M &m) { m.uncertainty.expansionStandardUncertainty.instrument = -1; });
    row("no coefficient", "expansion", false, [](M &m) { m.conditions.common.expansion.machine.reset(); });
    row("no temperature", "sensors", false, [](M &m) { m.conditions.common.sensors.clear(); });
}

void CircularBudgetTest::unknown() {
    QFETCH(QString, id);
    QFETCH(bool, widthsToo);
    QFETCH(Change, change);
    Test test = circularTest(36);
    stateTemperatures(circle(test));
    change(circle(test));
    const TestEvaluation evaluation = evaluated(test);
    QVERIFY(finding(evaluation, id.toStdString()));
    QVERIFY(!parameter(evaluation, "Fmax_XY")->expandedUncertainty);
    QVERIFY(!parameter(evaluation, "D_XY")->expandedUncertainty);
    QCOMPARE(parameter(evaluation, "G_XY")->expandedUncertainty.has_value(), !widthsToo);
    QVERIFY(!evaluation.uncertainty.complete);
}

QTEST_APPLESS_MAIN(CircularBudgetTest)
#include "circularbudget.moc"
