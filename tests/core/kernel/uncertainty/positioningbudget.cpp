#include "kernel/uncertainty/positioningbudget.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "kernel/uncertainty/coefficients.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace palmer;
using namespace palmer::testdata;

using Change = std::function<void(PositioningMeasurement &)>;
Q_DECLARE_METATYPE(Change)

/// The simplified budget of ISO 230-2: printed vectors, properties, and what gives no number.
class PositioningBudgetTest : public QObject {
    Q_OBJECT

private slots:
    void vectors_data();
    void vectors();
    void vectorsOf1988();
    void everyParameterHasCoefficients();
    void runsOfTheRulingTarget();
    void oneDirectionRulesR();
    void vdi();
    void nothingGivesNothing();
    void eachAloneGivesItsColumn_data();
    void eachAloneGivesItsColumn();
    void scaling();
    void certificates();
    void fartherTemperature();
    void rotary();
    void rotaryPerMetreIsRefused();
    void driftTest();
    void zeroIsAStatement();
    void unknown_data();
    void unknown();
    void impossible_data();
    void impossible();
};

namespace {

/// The values are printed to four decimals of a µm at most.
constexpr double printed = 0.5e-4;

double micrometres(std::optional<double> mm) {
    return mm ? *mm * 1000 : std::numeric_limits<double>::quiet_NaN();
}

double contribution(const PositioningBudget &budget, std::string_view id) {
    const Contribution *found = budget.find(id);
    return found ? micrometres(found->expanded) : std::numeric_limits<double>::quiet_NaN();
}

double uncertainty(const TestEvaluation &evaluation, std::string_view id) {
    const Parameter *p = parameter(evaluation, id);
    return p ? micrometres(p->expandedUncertainty) : std::numeric_limits<double>::quiet_NaN();
}

bool near(double found, double expected, double tolerance) {
    return std::abs(found - expected) <= tolerance;
}

#define COMPARE_NEAR(found, expected, tolerance)                                                             \
    QVERIFY2(near(found, expected, tolerance),                                                               \
             qPrintable(QStringLiteral(#found " is %1, not %2").arg(found, 0, 'g', 12).arg(expected)))

} // namespace

void PositioningBudgetTest::vectors_data() {
    QTest::addColumn<double>("length");
    QTest::addColumn<QList<double>>("contributions"); // device, misalignment, temperature, expansion, EVE
    QTest::addColumn<QList<double>>("results");       // B, R↑, E, M, A
    QTest::newRow("X1, L 500") << 500.0 << QList{0.75, 0.60, 3.60, 3.00, 1.80}
                               << QList{1.1384, 3.60, 4.9172, 4.8508, 5.5370};
    QTest::newRow("X1, L 1000") << 1000.0 << QList{1.50, 0.30, 7.20, 6.00, 1.80}
                                << QList{1.1384, 3.60, 9.5643, 9.5304, 9.8973};
    QTest::newRow("X1, L 2000") << 2000.0 << QList{3.00, 0.15, 14.40, 12.00, 1.80}
                                << QList{1.1384, 3.60, 19.0178, 19.0008, 19.1875};
}

void PositioningBudgetTest::vectors() {
    QFETCH(double, length);
    QFETCH(QList<double>, contributions);
    QFETCH(QList<double>, results);
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    measurement(test).uncertainty.length = length;
    const PositioningBudget budget = positioningBudget(measurement(test), {});
    const char *ids[]{"device", "misalignment", "temperatureMachine", "expansionMachine",
                      "environmentalVariation"};
    for (int k = 0; k < 5; ++k)
        COMPARE_NEAR(contribution(budget, ids[k]), contributions[k], 1e-12);
    COMPARE_NEAR(contribution(budget, "temperatureInstrument"), 0, 0);
    COMPARE_NEAR(contribution(budget, "expansionInstrument"), 0, 0);
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "B"), results[0], printed);
    COMPARE_NEAR(uncertainty(evaluation, "Bmean"), results[0], printed);
    COMPARE_NEAR(uncertainty(evaluation, "R+"), results[1], printed);
    COMPARE_NEAR(uncertainty(evaluation, "E"), results[2], printed);
    COMPARE_NEAR(uncertainty(evaluation, "E-"), results[2], printed);
    COMPARE_NEAR(uncertainty(evaluation, "M"), results[3], printed);
    COMPARE_NEAR(uncertainty(evaluation, "A"), results[4], printed);
    COMPARE_NEAR(uncertainty(evaluation, "A+"), results[4], printed);
    // R of this test is ruled by both directions together.
    COMPARE_NEAR(uncertainty(evaluation, "R"), 1.549193 * 1.8, 1e-5);
}

void PositioningBudgetTest::vectorsOf1988() {
    Test test = example1988("ISO 230-2:1988");
    stateX1(measurement(test));
    measurement(test).uncertainty.length = 500;
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "R+"), 5.40, printed);
    COMPARE_NEAR(uncertainty(evaluation, "A"), 6.2256, printed);
    COMPARE_NEAR(uncertainty(evaluation, "Bmean"), 1.1384, printed);
    COMPARE_NEAR(uncertainty(evaluation, "r"), 5.40, printed);
    COMPARE_NEAR(uncertainty(evaluation, "R"), 2.2136 * 1.8, 1e-4);
}

void PositioningBudgetTest::everyParameterHasCoefficients() {
    for (const Edition *edition : editions()) {
        for (const Row &row : edition->rows)
            QVERIFY2(coefficients(row.term.id), row.term.id);
    }
    QVERIFY(!coefficients("G(b)"));
}

void PositioningBudgetTest::runsOfTheRulingTarget() {
    Test test = exactHand("ISO 230-2:2006");
    stateNothing(measurement(test));
    measurement(test).uncertainty.environmentalVariation = 3;
    // A reading less at the target that rules R↑: s of four readings.
    const TestEvaluation whole = evaluated(test);
    const int ruling = parameter(whole, "R+")->ruling[0]->target;
    QCOMPARE(ruling, 2);
    Run &run = measurement(test).runs[4];
    QCOMPARE(run.approach, Direction::positive);
    run.deviations[1].reset();
    const TestEvaluation gap = evaluated(test);
    QCOMPARE(parameter(gap, "R+")->ruling[0]->target, 2);
    COMPARE_NEAR(uncertainty(whole, "R+"), 4 / std::sqrt(4.0) * 1.8, 1e-12);
    COMPARE_NEAR(uncertainty(gap, "R+"), 4 / std::sqrt(3.0) * 1.8, 1e-12);
    // The mean over all targets: the fewest of all.
    COMPARE_NEAR(uncertainty(gap, "Bmean"), std::sqrt(2.0 / 4) * 1.8, 1e-12);
}

void PositioningBudgetTest::oneDirectionRulesR() {
    // s↓ is large, s↑ and B_i are small: R_i = R_i↓.
    Test test = positioningTest("ISO 230-2:2006", {0, 100}, {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0.1}},
                                {{0, -9}, {0, 9}, {0, -9}, {0, 9}, {0, 0.1}});
    stateNothing(measurement(test));
    measurement(test).uncertainty.environmentalVariation = 3;
    const TestEvaluation evaluation = evaluated(test);
    QCOMPARE(*parameter(evaluation, "R")->value, *parameter(evaluation, "R-")->value);
    COMPARE_NEAR(uncertainty(evaluation, "R"), 2 * 1.8, 1e-12);
}

void PositioningBudgetTest::vdi() {
    Test test = example1988("VDI/DGQ 3441:1977");
    stateX1(measurement(test));
    measurement(test).uncertainty.length = 500;
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "Psmax"), 1.8 * 6 / std::sqrt(8.0), 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "Psmean"), 1.8 * 6 / std::sqrt(8.0), 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "Umax"), 1.1384, printed);
    COMPARE_NEAR(uncertainty(evaluation, "Umean"), 1.1384, printed);
    COMPARE_NEAR(uncertainty(evaluation, "Pa"), std::sqrt(0.5625 + 0.36 + 12.96 + 9 + 0.2 * 3.24), 1e-9);
    COMPARE_NEAR(uncertainty(evaluation, "P"),
                 std::sqrt(0.5625 + 0.36 + 12.96 + 9 + (2.0 / 5 + 9.0 / 4) * 3.24), 1e-9);
}

void PositioningBudgetTest::nothingGivesNothing() {
    for (const char *edition : {"ISO 230-2:1988", "ISO 230-2:2006", "ISO 230-2:2014", "VDI/DGQ 3441:1977"}) {
        Test test = example1988(edition);
        stateNothing(measurement(test));
        for (const Parameter &p : evaluated(test).parameters) {
            QVERIFY(p.expandedUncertainty.has_value());
            QCOMPARE(*p.expandedUncertainty, 0.0);
        }
    }
}

void PositioningBudgetTest::eachAloneGivesItsColumn_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("reachesRepeatability");
    QTest::newRow("device") << "device" << false;
    QTest::newRow("misalignment") << "misalignment" << false;
    QTest::newRow("temperature of the machine") << "temperatureMachine" << false;
    QTest::newRow("temperature of the instrument") << "temperatureInstrument" << false;
    QTest::newRow("expansion of the machine") << "expansionMachine" << false;
    QTest::newRow("expansion of the instrument") << "expansionInstrument" << false;
    QTest::newRow("environmental variation") << "environmentalVariation" << true;
}

void PositioningBudgetTest::eachAloneGivesItsColumn() {
    QFETCH(QString, id);
    QFETCH(bool, reachesRepeatability);
    const std::string which = id.toStdString();
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    setTemperature(m, 24);
    m.conditions.common.sensors.push_back({SensorMeasures::instrument, "", 23.0, 23.0, std::nullopt});
    m.conditions.common.expansion = {12.0, 8.0};
    PositioningUncertaintyInputs &inputs = m.uncertainty;
    inputs.length = 500;
    double expected = 0;
    if (which == "device") {
        inputs.device.fixed = 0.4;
        expected = 0.4;
    } else if (which == "misalignment") {
        inputs.misalignmentRange = 2;
        expected = 2.4;
    } else if (which == "temperatureMachine") {
        inputs.temperatureRange.machine = 0.5;
        expected = 1.8;
    } else if (which == "temperatureInstrument") {
        inputs.temperatureRange.instrument = 0.5;
        expected = 1.2;
    } else if (which == "expansionMachine") {
        inputs.expansionRange.machine = 2;
        expected = 2.4;
    } else if (which == "expansionInstrument") {
        inputs.expansionRange.instrument = 2;
        expected = 1.8;
    } else {
        inputs.environmentalVariation = 2;
        expected = 1.2;
    }
    const PositioningBudget budget = positioningBudget(m, {});
    for (const Contribution &one : budget.contributions)
        COMPARE_NEAR(micrometres(one.expanded), which == one.id ? expected : 0.0, 1e-12);
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(uncertainty(evaluation, "E"), reachesRepeatability ? expected * std::sqrt(0.4) : expected,
                 1e-12);
    COMPARE_NEAR(uncertainty(evaluation, "R+"), reachesRepeatability ? 2 * expected : 0.0, 1e-12);
}

void PositioningBudgetTest::scaling() {
    Test test = example1988("ISO 230-2:2006");
    stateX1(measurement(test));
    const TestEvaluation once = evaluated(test);
    PositioningUncertaintyInputs &inputs = measurement(test).uncertainty;
    constexpr double factor = 3;
    *inputs.device.perMetre *= factor;
    *inputs.misalignmentRange *= std::sqrt(factor);
    *inputs.temperatureRange.machine *= factor;
    *inputs.expansionRange.machine *= factor;
    *inputs.environmentalVariation *= factor;
    const TestEvaluation scaled = evaluated(test);
    for (std::size_t k = 0; k < once.parameters.size(); ++k)
        COMPARE_NEAR(*scaled.parameters[k].expandedUncertainty,
                     factor * *once.parameters[k].expandedUncertainty, 1e-15);
}

void PositioningBudgetTest::certificates() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.length = 500;
    m.uncertainty.device = {DeviceKind::certificate, 0.3, 1.5, 3};
    COMPARE_NEAR(contribution(positioningBudget(m, {}), "device"), (0.3 + 0.75) * 2 / 3, 1e-12);
    m.uncertainty.device = {DeviceKind::range, 0.3, 1.5, 2};
    COMPARE_NEAR(contribution(positioningBudget(m, {}), "device"), 0.6 * (0.3 + 0.75), 1e-12);
}

void PositioningBudgetTest::fartherTemperature() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.length = 1000;
    m.uncertainty.expansionRange.machine = 2;
    m.conditions.common.sensors = {{SensorMeasures::machine, "", 19.0, 20.5, std::nullopt},
                                   {SensorMeasures::machine, "", 17.0, 20.5, std::nullopt}};
    // Mean at the start 18 °C, at the end 20.5 °C.
    COMPARE_NEAR(contribution(positioningBudget(m, {}), "expansionMachine"), 0.6 * 2 * 2, 1e-12);
}

void PositioningBudgetTest::rotary() {
    Test test = exactHand("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    m.axis.motion = Motion::rotary;
    m.uncertainty.method = UncertaintyMethod::budget;
    m.uncertainty.device.fixed = 1; // arc seconds
    m.uncertainty.environmentalVariation = 2;
    const PositioningBudget budget = positioningBudget(m, {});
    QCOMPARE(budget.contributions.size(), std::size_t(2));
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(*parameter(evaluation, "E")->expandedUncertainty * 3600, std::sqrt(1 + 0.4 * 1.44), 1e-12);
    COMPARE_NEAR(*parameter(evaluation, "R+")->expandedUncertainty * 3600, 2 * 1.2, 1e-12);
}

void PositioningBudgetTest::rotaryPerMetreIsRefused() {
    Test test = exactHand("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    m.axis.motion = Motion::rotary;
    m.uncertainty.method = UncertaintyMethod::budget;
    m.uncertainty.device.fixed = 1;
    m.uncertainty.device.perMetre = 1;
    m.uncertainty.environmentalVariation = 2;
    const TestEvaluation evaluation = evaluated(test);
    QVERIFY(finding(evaluation, "device"));
    QVERIFY(!parameter(evaluation, "E")->expandedUncertainty);
}

void PositioningBudgetTest::driftTest() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.environmentalVariation.reset();
    COMPARE_NEAR(contribution(positioningBudget(m, 0.004), "environmentalVariation"), 2.4, 1e-12);
    m.uncertainty.environmentalVariation = 1; // a number wins
    COMPARE_NEAR(contribution(positioningBudget(m, 0.004), "environmentalVariation"), 0.6, 1e-12);
}

void PositioningBudgetTest::zeroIsAStatement() {
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateX1(m);
    // A range of zero needs neither temperature nor coefficient; a laser without α needs no ranges.
    m.conditions.common.sensors.clear();
    m.conditions.common.expansion.machine.reset();
    m.uncertainty.temperatureRange = {0.0, std::nullopt};
    m.uncertainty.expansionRange = {0.0, std::nullopt};
    const PositioningBudget budget = positioningBudget(m, {});
    QVERIFY(budget.isComplete());
    QVERIFY(!budget.find("temperatureInstrument")->applies);
    QVERIFY(!budget.find("expansionInstrument")->applies);
    QVERIFY(budget.find("temperatureMachine")->applies);
}

namespace {

void addNoNumberRows(const QList<std::tuple<const char *, const char *, Change>> &rows) {
    QTest::addColumn<QString>("id");
    QTest::addColumn<Change>("change");
    for (const auto &[name, id, change] : rows)
        QTest::newRow(name) << id << change;
}

/// After the change there is a finding of this id and no U at all.
void compareNoNumber() {
    QFETCH(QString, id);
    QFETCH(Change, change);
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateX1(m);
    m.conditions.common.sensors.push_back({SensorMeasures::instrument, "", 23.0, 23.0, std::nullopt});
    m.conditions.common.expansion.instrument = 8;
    for (const Parameter &p : evaluated(test).parameters)
        QVERIFY(p.expandedUncertainty.has_value());
    change(m);
    const TestEvaluation evaluation = evaluated(test);
    QVERIFY(finding(evaluation, id.toStdString()));
    for (const Parameter &p : evaluation.parameters)
        QVERIFY(!p.expandedUncertainty.has_value());
    QVERIFY(!evaluation.uncertainty.wantsSimulation());
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

void PositioningBudgetTest::unknown_data() {
    using M = PositioningMeasurement;
    addNoNumberRows({
        {"fixed part of the device", "device", [](M &m) { m.uncertainty.device.fixed.reset(); }},
        {"part per metre of the device", "device", [](M &m) { m.uncertainty.device.perMetre.reset(); }},
        {"misalignment", "misalignmentRange", [](M &m) { m.uncertainty.misalignmentRange.reset(); }},
        {"temperature range of the machine", "temperatureRange",
         [](M &m) { m.uncertainty.temperatureRange.machine.reset(); }},
        {"temperature range of the instrument", "temperatureRange",
         [](M &m) { m.uncertainty.temperatureRange.instrument.reset(); }},
        {"expansion range of the machine", "expansionRange",
         [](M &m) { m.uncertainty.expansionRange.machine.reset(); }},
        {"expansion range of the instrument", "expansionRange",
         [](M &m) { m.uncertainty.expansionRange.instrument.reset(); }},
        {"coefficient of expansion of the machine", "expansion",
         [](M &m) { m.conditions.common.expansion.machine.reset(); }},
        {"temperature of the machine", "sensors",
         [](M &m) { m.conditions.common.sensors.erase(m.conditions.common.sensors.begin()); }},
        {"environmental variation", "environmentalVariation",
         [](M &m) { m.uncertainty.environmentalVariation.reset(); }},
    });
}

void PositioningBudgetTest::unknown() {
    compareNoNumber();
}

void PositioningBudgetTest::impossible_data() {
    using M = PositioningMeasurement;
    addNoNumberRows({
        {"negative fixed part", "device", [](M &m) { m.uncertainty.device.fixed = -1; }},
        {"infinite part per metre", "device", [](M &m) { m.uncertainty.device.perMetre = infinity; }},
        {"coverage factor of zero", "device", [](M &m) { m.uncertainty.device.coverageFactor = 0; }},
        {"coverage factor that is no number", "device",
         [](M &m) { m.uncertainty.device.coverageFactor = notANumber; }},
        {"negative misalignment", "misalignmentRange", [](M &m) { m.uncertainty.misalignmentRange = -1; }},
        {"infinite temperature range", "temperatureRange",
         [](M &m) { m.uncertainty.temperatureRange.machine = infinity; }},
        {"negative temperature range", "temperatureRange",
         [](M &m) { m.uncertainty.temperatureRange.instrument = -0.1; }},
        {"negative temperature range of a laser", "temperatureRange",
         [](M &m) {
             m.conditions.common.expansion.instrument = 0;
             m.uncertainty.temperatureRange.instrument = -0.1;
         }},
        {"negative expansion range", "expansionRange",
         [](M &m) { m.uncertainty.expansionRange.machine = -2; }},
        {"infinite coefficient", "expansion", [](M &m) { m.conditions.common.expansion.machine = infinity; }},
        {"infinite temperature", "sensors", [](M &m) { m.conditions.common.sensors[0].start = infinity; }},
        {"negative environmental variation", "environmentalVariation",
         [](M &m) { m.uncertainty.environmentalVariation = -3; }},
        {"infinite environmental variation", "environmentalVariation",
         [](M &m) { m.uncertainty.environmentalVariation = infinity; }},
        {"length of zero", "length", [](M &m) { m.uncertainty.length = 0; }},
        {"negative length", "length", [](M &m) { m.uncertainty.length = -500; }},
    });
}

void PositioningBudgetTest::impossible() {
    compareNoNumber();
}

QTEST_APPLESS_MAIN(PositioningBudgetTest)
#include "positioningbudget.moc"
