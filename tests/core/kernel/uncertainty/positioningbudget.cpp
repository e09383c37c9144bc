// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/positioningbudget.h"

#include "core/kernel/uncertainty/uncertaintydata.h"
#include "core/kernel/words/written.h"
#include "kernel/uncertainty/coefficients.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

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
    void oneTargetAndDirectionRulesA();
    void unequalRuns_data();
    void unequalRuns();
    void effectiveSystematic_data();
    void effectiveSystematic();
    void effectiveSystematicIsNeverLarger();
    void fixedPartCountsInFull();
    void vdi();
    void nothingGivesNothing();
    void eachAloneGivesItsColumn_data();
    void eachAloneGivesItsColumn();
    void scaling();
    void certificates();
    void inputsSayHow_data();
    void inputsSayHow();
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
    // The mean over all targets: the one of 4 ↑ and 5 ↓ as if it ruled.
    COMPARE_NEAR(uncertainty(gap, "Bmean"), std::sqrt(1 / 4.0 + 1 / 5.0) * 1.8, 1e-12);
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

void PositioningBudgetTest::oneTargetAndDirectionRulesA() {
    // s↑ of the second target alone: A = R↑ = 4s there, and A↑ likewise; A↓ is ruled by two targets.
    Test test = positioningTest("ISO 230-2:2006", {0, 500, 1000},
                                {{0, -9, 0.1}, {0, 9, 0}, {0, -9, 0.1}, {0, 9, 0}, {0, 0, 0}},
                                {{0, 0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1}, {0, 0.6, 1.1}, {0, 0.5, 1}});
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.environmentalVariation = 1; // U_EVE = 0.6
    const TestEvaluation none = evaluated(test);
    const Parameter *a = parameter(none, "A");
    QVERIFY(*a->ruling[0] == *a->ruling[1]);
    QCOMPARE(*a->value, *parameter(none, "R+")->value);
    COMPARE_NEAR(uncertainty(none, "A"), 1.2, 1e-12);
    COMPARE_NEAR(uncertainty(none, "A+"), 1.2, 1e-12);
    COMPARE_NEAR(uncertainty(none, "A-"), std::sqrt(2.4) * 0.6, 1e-12);
    // S beside it, and the factor of 1988.
    m.uncertainty.device.perMetre = 2;
    COMPARE_NEAR(uncertainty(evaluated(test), "A"), std::sqrt(4 + 4 * 0.36), 1e-12);
    test.edition = "ISO 230-2:1988";
    COMPARE_NEAR(uncertainty(evaluated(test), "A"), std::sqrt(4 + 9 * 0.36), 1e-12);
}

void PositioningBudgetTest::unequalRuns_data() {
    QTest::addColumn<QString>("edition");
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("expected"); // U²/U_EVE², S = 0
    // Readings: target 1: 6 ↑, 5 ↓; target 2: 4 ↑, 3 ↓; target 3: 2 ↑, 6 ↓. See unequalRuns.
    const char *iso = "ISO 230-2:2006";
    QTest::newRow("E: 3↑ and 1↓") << iso << "E" << 1 / 2.0 + 1 / 5.0;
    QTest::newRow("E↑: 3↑ and 1↑") << iso << "E+" << 1 / 2.0 + 1 / 6.0;
    QTest::newRow("M: targets 3 and 1") << iso << "M" << (1 / 2.0 + 1 / 6.0 + 1 / 6.0 + 1 / 5.0) / 4;
    QTest::newRow("A: 3↑ and 1↓") << iso << "A" << 1 / 2.0 + 1 / 5.0 + 4 * (1 / 1.0 + 1 / 4.0);
    QTest::newRow("A↓: 3↓ and 1↓") << iso << "A-" << 1 / 6.0 + 1 / 5.0 + 4 * (1 / 5.0 + 1 / 4.0);
    QTest::newRow("R↑: target 2") << iso << "R+" << 16 / 3.0;
    QTest::newRow("R: target 2, both") << iso << "R" << 1 / 4.0 + 1 / 3.0 + 4 * (1 / 3.0 + 1 / 2.0);
    QTest::newRow("B: target 2") << iso << "B" << 1 / 4.0 + 1 / 3.0;
    QTest::newRow("B̄: target 3, safe side") << iso << "Bmean" << 1 / 2.0 + 1 / 6.0;
    QTest::newRow("r̄: 3↑, safe side") << "ISO 230-2:1988"
                                      << "r" << 36 / 1.0;
    QTest::newRow("r̄↓: 2↓, safe side") << "ISO 230-2:1988"
                                       << "r-" << 36 / 2.0;
    const char *vdi = "VDI/DGQ 3441:1977";
    QTest::newRow("Umax: target 2") << vdi << "Umax" << 1 / 4.0 + 1 / 3.0;
    QTest::newRow("Psmax: target 2") << vdi << "Psmax" << 9 * (1 / 3.0 + 1 / 2.0);
    QTest::newRow("Psmean: target 3, safe side") << vdi << "Psmean" << 9 * (1 / 1.0 + 1 / 5.0);
    QTest::newRow("P: 3↑ and 1↓") << vdi << "P"
                                  << 1 / 2.0 + 1 / 5.0 + 9 / 4.0 * (1 / 1.0 + 1 / 5.0 + 1 / 4.0 + 1 / 5.0);
    QTest::newRow("Pa: targets 3 and 1") << vdi << "Pa" << (1 / 2.0 + 1 / 6.0 + 1 / 6.0 + 1 / 5.0) / 4;
}

void PositioningBudgetTest::unequalRuns() {
    QFETCH(QString, edition);
    QFETCH(QString, id);
    QFETCH(double, expected);
    // Means 0, 50, 100 ↑ and −10, 20, 90 ↓; s of 2 at target 2, of some hundredths elsewhere.
    constexpr int counts[2][3]{{6, 4, 2}, {5, 3, 6}};
    constexpr double means[2][3]{{0, 50, 100}, {-10, 20, 90}};
    std::vector<std::vector<double>> runs[2];
    for (int d = 0; d < 2; ++d) {
        for (int run = 0; run < 6; ++run) {
            std::vector<double> readings;
            for (int i = 0; i < 3; ++i)
                readings.push_back(means[d][i] + (run % 2 == 0 ? 1 : -1) * (i == 1 ? 2 : 0.02));
            runs[d].push_back(readings);
        }
    }
    Test test = positioningTest(edition.toLatin1().constData(), {0, 500, 1000}, runs[0], runs[1]);
    PositioningMeasurement &m = measurement(test);
    int seen[2]{};
    for (Run &run : m.runs) {
        const int d = run.approach == Direction::positive ? 0 : 1;
        for (int i = 0; i < 3; ++i) {
            if (seen[d] >= counts[d][i])
                run.deviations[static_cast<std::size_t>(i)].reset();
        }
        ++seen[d];
    }
    stateNothing(m);
    m.uncertainty.environmentalVariation = 1;
    const double u = uncertainty(evaluated(test), id.toStdString()) / 0.6;
    COMPARE_NEAR(u * u, expected, 1e-12);
}

void PositioningBudgetTest::effectiveSystematic_data() {
    QTest::addColumn<double>("here");  // reversal at the target in the middle, µm
    QTest::addColumn<double>("there"); // at all others
    QTest::addColumn<double>("expected");
    QTest::newRow("uniform reversal") << 5.0 << 5.0 << 4.85;
    QTest::newRow("one target a little larger") << 6.0 << 5.0 << 3.85;
    QTest::newRow("one target rules alone") << 12.0 << 2.0 << 0.0;
}

void PositioningBudgetTest::effectiveSystematic() {
    QFETCH(double, here);
    QFETCH(double, there);
    QFETCH(double, expected);
    const std::vector<double> up{there / 2, there / 2, here / 2, there / 2, there / 2};
    std::vector<double> down;
    for (const double mean : up)
        down.push_back(-mean);
    Test test = positioningTest("ISO 230-2:2006", {0, 250, 500, 750, 1000}, {up, up, up, up, up},
                                {down, down, down, down, down});
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.device.perMetre = 4.85;
    m.uncertainty.environmentalVariation = 2; // U_EVE = 1.2
    const TestEvaluation evaluation = evaluated(test);
    COMPARE_NEAR(micrometres(evaluation.uncertainty.systematic), 4.85, 1e-12);
    for (const char *id : {"E", "A"}) { // s = 0: both are the same
        const Parameter *p = parameter(evaluation, id);
        COMPARE_NEAR(micrometres(p->effectiveSystematic), expected, 1e-9);
        const double environment = id[0] == 'E' ? 0.4 : *p->ruling[0] == *p->ruling[1] ? 4 : 2.4;
        COMPARE_NEAR(micrometres(p->actualUncertainty), std::sqrt(expected * expected + environment * 1.44),
                     1e-9);
        COMPARE_NEAR(uncertainty(evaluation, id), std::sqrt(4.85 * 4.85 + environment * 1.44), 1e-9);
    }
}

void PositioningBudgetTest::effectiveSystematicIsNeverLarger() {
    // Any readings: S_eff lies between 0 and S, and is what evaluating the tilted readings gives.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> reading(-8, 8);
    for (int k = 0; k < 60; ++k) {
        const int targets = 2 + k % 7;
        std::vector<double> positions;
        for (int i = 0; i < targets; ++i)
            positions.push_back(-300 + 100.0 * i + reading(random));
        std::vector<std::vector<double>> runs[2];
        for (auto &direction : runs) {
            for (int run = 0; run < 3; ++run) {
                std::vector<double> values;
                for (int i = 0; i < targets; ++i)
                    values.push_back(reading(random));
                direction.push_back(values);
            }
        }
        Test test =
            positioningTest(k % 2 == 0 ? "ISO 230-2:2014" : "VDI/DGQ 3441:1977", positions, runs[0], runs[1]);
        PositioningMeasurement &m = measurement(test);
        stateNothing(m);
        const double length = positions.back() - positions.front();
        m.uncertainty.device.perMetre = 5 * 1000 / length; // S = 5 µm
        const TestEvaluation evaluation = evaluated(test);
        const auto tilted = [&](double t) {
            Test other = test;
            for (Run &run : measurement(other).runs) {
                for (std::size_t i = 0; i < run.deviations.size(); ++i)
                    *run.deviations[i] += t / 1000 * (positions[i] - positions.front()) / length;
            }
            return evaluated(other);
        };
        const TestEvaluation up = tilted(5);
        const TestEvaluation down = tilted(-5);
        int looked = 0;
        for (const Parameter &p : evaluation.parameters) {
            if (!p.effectiveSystematic)
                continue;
            ++looked;
            const double expected =
                std::max(*parameter(up, p.term.id)->value, *parameter(down, p.term.id)->value) - *p.value;
            COMPARE_NEAR(micrometres(p.effectiveSystematic), expected * 1000, 1e-9);
            QVERIFY(*p.effectiveSystematic >= 0 && *p.effectiveSystematic <= 0.005 + 1e-12);
            QVERIFY(*p.actualUncertainty <= *p.budgetUncertainty + 1e-12);
        }
        QVERIFY(looked >= 2);
    }
}

void PositioningBudgetTest::fixedPartCountsInFull() {
    Test test = positioningTest("ISO 230-2:2006", {0, 500, 1000}, {{1, 6, 1}, {1, 6, 1}},
                                {{-1, -6, -1}, {-1, -6, -1}});
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.device = {DeviceKind::certificate, 0.8, 0.0, 2};
    const auto effective = [&] { return micrometres(parameter(evaluated(test), "E")->effectiveSystematic); };
    COMPARE_NEAR(effective(), 0.8, 1e-12); // E is ruled by one target, which a tilt does not reach
    m.uncertainty.device = {DeviceKind::certificate, 0.0, 0.8, 2};
    COMPARE_NEAR(effective(), 0.0, 1e-9);
    m.uncertainty.device = {DeviceKind::certificate, 0.3, 0.5, 2};
    COMPARE_NEAR(effective(), std::sqrt(0.8 * 0.8 - 0.5 * 0.5), 1e-9);
    m.axis.motion = Motion::rotary; // arc seconds, nothing grows
    m.uncertainty.device = {DeviceKind::certificate, 0.8, 0.0, 2};
    COMPARE_NEAR(*parameter(evaluated(test), "E")->effectiveSystematic * 3600, 0.8, 1e-12);
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

void PositioningBudgetTest::inputsSayHow_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<QByteArray>("id");
    QTest::addColumn<QByteArray>("text"); // how it begins
    QTest::addColumn<QByteArray>("numbers");
    const auto row = [](const char *name, const char *id, const Change &change, const char *text,
                        const char *numbers) {
        QTest::newRow(name) << change << QByteArray(id) << QByteArray(text) << QByteArray(numbers);
    };
    using M = PositioningMeasurement;
    const auto device = [](DeviceKind kind, double fixed, double perMetre, double k) -> Change {
        return [=](M &m) { m.uncertainty.device = {kind, fixed, perMetre, k}; };
    };
    const auto certificate = DeviceKind::certificate;
    const auto range = DeviceKind::range;
    // L = 1 500 mm
    row("fixed, k = 2", "device", device(certificate, 0.5, 0, 2), "%1", "0.5 µm");
    row("fixed, k = 3", "device", device(certificate, 0.5, 0, 3), "%1 · 2/%2", "0.5 µm; 3");
    row("fixed range", "device", device(range, 0.5, 0, 2), "%1 · %2", "0.6; 0.5 µm");
    row("per metre, k = 2", "device", device(certificate, 0, 4, 2), "%1/m · %2 m", "4 µm; 1.5.3");
    row("per metre, k = 3", "device", device(certificate, 0, 4, 3), "%1/m · %2 m · 2/%3", "4 µm; 1.5.3; 3");
    row("range per metre", "device", device(range, 0, 4, 2), "%1 · %2/m · %3 m", "0.6; 4 µm; 1.5.3");
    row("both, k = 2", "device", device(certificate, 0.5, 4, 2), "%1 + %2/m · %3 m", "0.5 µm; 4 µm; 1.5.3");
    row("both, k = 3", "device", device(certificate, 0.5, 4, 3), "(%1 + %2/m · %3 m) · 2/%4",
        "0.5 µm; 4 µm; 1.5.3; 3");
    row("range of both", "device", device(range, 0.5, 4, 2), "%1 · (%2 + %3/m · %4 m)",
        "0.6; 0.5 µm; 4 µm; 1.5.3");
    row(
        "rotary", "device",
        [](M &m) {
            m.axis.motion = Motion::rotary;
            m.uncertainty.device = {DeviceKind::certificate, 0.5, 0.0, 2};
        },
        "%1", "0.5″");
    row(
        "misalignment", "misalignment", [](M &m) { m.uncertainty.misalignmentRange = 2; }, "%1 · (%2)² / %3",
        "0.3; 2 mm; 1500 mm");
    row(
        "temperature", "temperatureMachine", [](M &m) { m.uncertainty.temperatureRange.machine = 0.5; },
        "%1 · %2 · %3 m · %4", "0.6; 12 α; 1.5.3; 0.5 °C");
    row(
        "expansion", "expansionMachine",
        [](M &m) {
            m.uncertainty.expansionRange.machine = 2;
            setTemperature(m, 25.1); // not 5.1000000000000014
        },
        "%1 · %2 · %3 m · %4", "0.6; 5.1 °C; 1.5.3; 2 α");
    row(
        "temperature, α not stated", "temperatureMachine",
        [](M &m) {
            m.uncertainty.temperatureRange.machine = 0;
            m.conditions.common.expansion.machine.reset();
        },
        "%1 · %2 · %3 m · %4", "0.6; –; 1.5.3; 0 °C");
    row(
        "expansion, θ not stated", "expansionMachine",
        [](M &m) {
            m.uncertainty.expansionRange.machine = 0;
            m.conditions.common.sensors.clear();
        },
        "%1 · %2 · %3 m · %4", "0.6; –; 1.5.3; 0 α");
    row(
        "instrument without expansion", "temperatureInstrument", [](M &) {}, "instrument without", "");
    row(
        "neither", "expansionInstrument", [](M &) {}, "instrument without", "");
    row(
        "drift", "environmentalVariation", [](M &m) { m.uncertainty.environmentalVariation = 3; }, "%1 · %2",
        "0.6; 3 µm");
}

void PositioningBudgetTest::inputsSayHow() {
    QFETCH(Change, change);
    QFETCH(QByteArray, id);
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, numbers);
    Test test = example1988("ISO 230-2:2006");
    PositioningMeasurement &m = measurement(test);
    stateNothing(m);
    m.uncertainty.length = 1500;
    change(m);
    const PositioningBudget budget = positioningBudget(m, {});
    const Contribution *found = budget.find(id.toStdString());
    QVERIFY(found && !found->name.empty() && found->defects.empty());
    const QByteArray source = QByteArray(found->inputs.text.source).replace("\u00A0", " ");
    QVERIFY2(source.startsWith(text), found->inputs.text.source);
    QCOMPARE(written(found->inputs), numbers);
    QCOMPARE(found->applies, !text.startsWith("instrument without"));
    for (const Argument &argument : found->inputs.arguments) {
        const auto *number = std::get_if<Number>(&argument);
        QVERIFY(!number ||
                number->value == std::stod(QByteArray::number(number->value, 'g', 12).toStdString()));
    }
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
    for (Sensor &sensor : m.conditions.common.sensors)
        sensor.start.reset(); // and the start might have been farther
    QVERIFY(std::isnan(contribution(positioningBudget(m, {}), "expansionMachine")));
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
