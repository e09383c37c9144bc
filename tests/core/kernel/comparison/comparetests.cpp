// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/comparison/comparetests.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace palmer;

namespace {

/// A test of an axis with a rising curve; device 2 µm/m, all other errors stated to be 0.
struct Axis11 {
    int targets = 11;
    int cycles = 5;
    double noise = 0;
    double slope = 0.006; ///< mm over the travel of 1 m
    unsigned seed = 1;
    double first = 0; ///< position of the first target

    [[nodiscard]] Test make() const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        PositioningMeasurement m;
        m.axis.name = "X";
        for (int i = 0; i < targets; ++i)
            m.targets.push_back(first + 1000.0 * i / (targets - 1));
        for (int j = 0; j < cycles; ++j) {
            for (const Direction approach : {Direction::positive, Direction::negative}) {
                Run &run = m.runs.emplace_back();
                run.approach = approach;
                for (int i = 0; i < targets; ++i)
                    run.deviations.emplace_back(slope * i / (targets - 1) +
                                                (approach == Direction::positive ? 0.001 : -0.001) +
                                                noise * normal(random));
            }
        }
        m.uncertainty.method = UncertaintyMethod::budget;
        m.uncertainty.device = {DeviceKind::certificate, 0.0, 2.0, 2};
        m.uncertainty.misalignmentRange = 0;
        m.uncertainty.temperatureRange = {0, 0};
        m.uncertainty.expansionRange = {0, 0};
        m.uncertainty.environmentalVariation = 0;
        Test test;
        test.edition = "ISO 230-2:2006";
        test.measurement = std::move(m);
        return test;
    }
};

PositioningMeasurement &axisOf(Test &test) {
    return std::get<PositioningMeasurement>(test.measurement);
}

Instrument laser(const char *serialNumber) {
    Instrument instrument;
    instrument.serialNumber = serialNumber;
    instrument.certificate = "C-1";
    return instrument;
}

TestComparison compare(const Test &a, const Test &b, ComparisonOptions options = {},
                       const Instrument *instrumentA = nullptr, const Instrument *instrumentB = nullptr) {
    static const Machine machine;
    options.trials = 20'000;
    PairedTest before{&a, {}};
    PairedTest after{&b, {}};
    before.surroundings.machine = after.surroundings.machine = &machine;
    if (instrumentA)
        before.surroundings.instruments = {instrumentA};
    if (instrumentB)
        after.surroundings.instruments = {instrumentB};
    return compareTwoTests(before, after, options);
}

const ComparedParameter &parameter(const TestComparison &comparison, const char *id) {
    return *std::ranges::find(comparison.parameters, std::string_view(id),
                              [](const ComparedParameter &p) { return std::string_view(p.term.id); });
}

} // namespace

class CompareTestsTest : public QObject {
    Q_OBJECT

private slots:
    void factorsOfSmallSamples();
    void words_data();
    void words();
    void equalCurvesWithSharedErrorsDoNotDiffer();
    void ownDevicesAddUp();
    void alphaErrsTheOtherWayBelow20();
    void repeatabilityIsThatOfTheResiduals();
    void firstCyclesAtCommonTargets();
    void withoutBudgetsTheSquaresAddUp();
    void whatIsNotCompared();
    void whatHasNoWord();
    void laboratoriesAreJudgedByEn();
    void toleranceWords();
    void curvesHaveNoMean();
    void anyNumberOfThreadsGivesTheSame();
    void gapsTakeAnotherResidual();
    void circlesAddTheirSquares();
};

void CompareTestsTest::factorsOfSmallSamples() {
    // Printed in the specification with four decimals.
    QVERIFY(std::abs(smallSampleFactor(2) - 2.2633) < 5e-5);
    QVERIFY(std::abs(smallSampleFactor(3) - 1.4347) < 5e-5);
    QVERIFY(std::abs(smallSampleFactor(5) - 1.1832) < 5e-5);
    QVERIFY(std::abs(smallSampleFactor(10) - 1.0744) < 5e-5);
    QCOMPARE(bandFactor(1, 5), 1.0);
    QVERIFY(bandFactor(22, 5) > bandFactor(2, 5));
    QVERIFY(!betweenTargets({0, 10}, {1.0, 3.0}, 11));
    QCOMPARE(betweenTargets({0, 10}, {1.0, 3.0}, 2.5), std::optional(1.5));
    QCOMPARE(betweenTargets({0, 10}, {1.0, {}}, 0), std::optional(1.0));
    QVERIFY(!betweenTargets({0, 10}, {1.0, {}}, 5));
}

void CompareTestsTest::words_data() {
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("after");
    QTest::addColumn<Bound>("bound");
    QTest::addColumn<double>("uncertainty");
    QTest::addColumn<std::optional<double>>("tolerance");
    QTest::addColumn<ChangeWord>("word");
    using T = std::optional<double>;
    const auto row = [](const char *name, double a, double b, double u, T t, ChangeWord word,
                        Bound bound = Bound::magnitude) {
        QTest::newRow(name) << a << b << bound << u << t << word;
    };
    row("at U", 10, 12, 2, {}, ChangeWord::noChangeProven);
    row("above U", 10, 12.01, 2, {}, ChangeWord::worse);
    row("below U", 12.01, 10, 2, {}, ChangeWord::better);
    row("signed: nearer to 0", -5, -1, 2, {}, ChangeWord::better);
    row("signed: through 0", -5, 5, 2, {}, ChangeWord::changed);
    row("a lower bound", -5, -1, 2, {}, ChangeWord::better, Bound::lower);
    row("an upper bound", -5, -1, 2, {}, ChangeWord::worse, Bound::upper);
    row("within t", 10, 11, 2, 3.0, ChangeWord::unchangedWithin);
    row("perhaps within t", 10, 11.01, 2, 3.0, ChangeWord::notProven);
    row("more than t", 10, 15.01, 2, 3.0, ChangeWord::changedByMore);
    row("perhaps more than t", 10, 15, 2, 3.0, ChangeWord::notProven);
    row("t of 0 is none", 10, 13, 2, 0.0, ChangeWord::worse);
}

void CompareTestsTest::words() {
    QFETCH(double, before);
    QFETCH(double, after);
    QFETCH(Bound, bound);
    QFETCH(double, uncertainty);
    QFETCH(std::optional<double>, tolerance);
    QFETCH(ChangeWord, word);
    QCOMPARE(changeWord(before, after, bound, uncertainty, tolerance), word);
}

void CompareTestsTest::equalCurvesWithSharedErrorsDoNotDiffer() {
    Test a = Axis11().make();
    for (Test *test : {&a}) {
        axisOf(*test).uncertainty.misalignmentRange = 1;
        axisOf(*test).uncertainty.expansionRange = {2, 0};
        axisOf(*test).conditions.common.expansion = {11.0, 8.0};
        axisOf(*test).conditions.common.sensors = {{SensorMeasures::machine, "table", 22.0, 22.0, {}},
                                                   {SensorMeasures::instrument, "stage", 22.0, 22.0, {}}};
    }
    const Test b = a;
    const Instrument one = laser("1");
    ComparisonOptions options;
    options.setUpUntouched = true;
    const TestComparison comparison = compare(a, b, options, &one, &one);
    QVERIFY(comparison.simulated);
    QCOMPARE(comparison.shared.size(), std::size_t{6});
    QCOMPARE(comparison.parameters.size(), std::size_t{12});
    for (const ComparedParameter &p : comparison.parameters) {
        QCOMPARE(p.difference, 0.0);
        QCOMPARE(p.uncertainty, std::optional(0.0));
        QCOMPARE(p.word, std::optional(ChangeWord::noChangeProven));
    }
}

void CompareTestsTest::ownDevicesAddUp() {
    // E of a rising line is its rise plus the reversal: device errors of σ = 1 µm each shift it; the 95.45 %
    // quantile of their difference is 2·√2·σ. 3 %: four times what 2·10⁴ trials leave.
    const Test a = Axis11().make();
    const Instrument one = laser("1");
    const Instrument other = laser("2");
    const TestComparison comparison = compare(a, a, {}, &one, &other);
    QVERIFY(comparison.shared.empty());
    const double u = *parameter(comparison, "E").uncertainty;
    QVERIFY2(std::abs(u - 0.002 * std::sqrt(2)) < 0.03 * u, qPrintable(QString::number(u, 'g', 8)));
    QVERIFY(*parameter(comparison, "B").uncertainty < 1e-15); // lengths do not matter
}

void CompareTestsTest::alphaErrsTheOtherWayBelow20() {
    const auto at = [](double temperature) {
        Test test = Axis11().make();
        axisOf(test).uncertainty.device = {DeviceKind::certificate, 0.0, 0.0, 2};
        axisOf(test).uncertainty.expansionRange = {2, 0};
        axisOf(test).conditions.common.expansion = {11.0, 8.0};
        axisOf(test).conditions.common.sensors = {{SensorMeasures::machine, "", temperature, temperature, {}},
                                                  {SensorMeasures::instrument, "", 20.0, 20.0, {}}};
        return test;
    };
    const Test warm = at(23);
    const Test cold = at(17);
    QCOMPARE(parameter(compare(warm, warm), "E").uncertainty, std::optional(0.0));
    QVERIFY(*parameter(compare(warm, cold), "E").uncertainty > 0.005); // ± 3 µm each, against each other
}

void CompareTestsTest::repeatabilityIsThatOfTheResiduals() {
    Axis11 axis;
    axis.noise = 0.001;
    const Test a = axis.make();
    axis.seed = 2;
    const Test b = axis.make();
    const TestComparison comparison = compare(a, b);
    for (const ComparedParameter &p : comparison.parameters) {
        QVERIFY(*p.repeatabilityAlone > 0);
        QVERIFY(*p.uncertainty >= 0.95 * *p.repeatabilityAlone);
        QVERIFY(*p.uncertainty <= 1.05 * std::hypot(*p.repeatabilityAlone, *p.errorsAlone) + 1e-9);
    }
    QVERIFY(!comparison.pooled);
    axis.cycles = 2;
    const Test c = axis.make();
    QVERIFY(compare(c, c).pooled);
}

void CompareTestsTest::firstCyclesAtCommonTargets() {
    Axis11 axis;
    axis.noise = 0.001;
    const Test a = axis.make();
    Test b = a;
    auto &m = axisOf(b);
    m.runs.resize(6); // three cycles
    m.targets.erase(m.targets.begin() + 3);
    for (Run &run : m.runs)
        run.deviations.erase(run.deviations.begin() + 3);
    m.targets[0] += 5e-7;
    const TestComparison comparison = compare(a, b);
    QCOMPARE(comparison.cycles, 3);
    QCOMPARE(comparison.commonTargets, std::size_t{10});
    for (const ComparedParameter &p : comparison.parameters)
        QVERIFY(std::abs(p.difference) < 1e-15); // the same readings
}

void CompareTestsTest::withoutBudgetsTheSquaresAddUp() {
    const auto direct = [](double micrometres) {
        Test test = Axis11().make();
        axisOf(test).uncertainty = {};
        axisOf(test).uncertainty.method = UncertaintyMethod::direct;
        axisOf(test).uncertainty.expanded = {{"A", micrometres}};
        return test;
    };
    const Test a = direct(3);
    const Test b = direct(4);
    const TestComparison comparison = compare(a, b);
    QVERIFY(!comparison.simulated);
    QVERIFY(std::abs(*parameter(comparison, "A").uncertainty - 0.005) < 1e-15); // no scatter
    QVERIFY(!parameter(comparison, "R").uncertainty);
    QVERIFY(!parameter(comparison, "R").word);
}

void CompareTestsTest::whatIsNotCompared() {
    const Test a = Axis11().make();
    Test b = a;
    axisOf(b).axis.name = "Y";
    QCOMPARE(compare(a, b).refusal, std::optional(NotComparable::otherAxis));
    b = a;
    std::erase_if(axisOf(b).runs, [](const Run &run) { return run.approach == Direction::negative; });
    QCOMPARE(compare(a, b).refusal, std::optional(NotComparable::otherDirections));
    b.measurement = CircularMeasurement();
    QCOMPARE(compare(a, b).refusal, std::optional(NotComparable::otherKind));
    b.measurement = DriftMeasurement();
    QCOMPARE(compare(b, b).refusal, std::optional(NotComparable::noEdition));
    const Instrument one = laser("1");
    ComparisonOptions laboratories;
    laboratories.role = ComparisonRole::laboratories;
    const Instrument unnumbered = laser("");
    for (const Instrument *both :
         {&one, &unnumbered}) // one entry of a file is one instrument, numbered or not
        QCOMPARE(compare(a, a, laboratories, both, both).refusal,
                 std::optional(NotComparable::sharedInstrument));
    const Instrument other = laser("");
    QVERIFY(!compare(a, a, laboratories, &unnumbered, &other).refusal);
}

void CompareTestsTest::whatHasNoWord() {
    Axis11 axis;
    const Test a = axis.make();
    axis.first = 50; // half a step: no common target
    const Test b = axis.make();
    const TestComparison apart = compare(a, b);
    QCOMPARE(apart.noWord, std::optional(NoWord::fewTargets));
    QVERIFY(apart.interpolated && apart.parameters.empty());
    QVERIFY(!apart.curves.front().values.back()); // beyond the first test
    QVERIFY(apart.curves.front().values.front());
    axis = {};
    axis.cycles = 1;
    const Test once = axis.make();
    QCOMPARE(compare(once, once).noWord, std::optional(NoWord::oneRun));
    Test unknown = a;
    axisOf(unknown).uncertainty = {};
    QCOMPARE(compare(unknown, unknown).noWord, std::optional(NoWord::noUncertainty));
}

void CompareTestsTest::laboratoriesAreJudgedByEn() {
    Axis11 axis;
    const Test a = axis.make();
    axis.slope = 0.0085; // 2.5 µm more, U(d) = 2.83 µm
    const Test b = axis.make();
    axis.slope = 0.0095;
    const Test c = axis.make();
    const Instrument one = laser("1");
    const Instrument other = laser("2");
    ComparisonOptions laboratories;
    laboratories.role = ComparisonRole::laboratories;
    const TestComparison agreeing = compare(a, b, laboratories, &one, &other);
    QCOMPARE(parameter(agreeing, "E").word, std::optional(ChangeWord::agree));
    QVERIFY(std::abs(*parameter(agreeing, "E").enRatio - 2.5 / 2.83) < 0.03);
    QCOMPARE(parameter(compare(a, c, laboratories, &one, &other), "E").word,
             std::optional(ChangeWord::disagree));
}

void CompareTestsTest::toleranceWords() {
    ComparisonOptions agreed;
    agreed.tolerance = 0.01;
    const Test a = Axis11().make();
    QCOMPARE(parameter(compare(a, a, agreed), "E").word, std::optional(ChangeWord::unchangedWithin));
}

void CompareTestsTest::curvesHaveNoMean() {
    Axis11 axis;
    const Test a = axis.make();
    axis.slope = 0.01;
    Test b = axis.make();
    for (Run &run : axisOf(b).runs) {
        for (auto &deviation : run.deviations)
            *deviation += 0.5; // another zero
    }
    const TestComparison comparison = compare(a, b);
    double sum = 0;
    for (const ComparedCurve &curve : comparison.curves) {
        for (std::size_t i = 0; i < curve.values.size(); ++i) {
            sum += curve.direction ? *curve.values[i] : 0;
            QVERIFY(*curve.band[i] >= 0);
        }
    }
    QVERIFY(std::abs(sum) < 1e-12);
    QVERIFY(std::abs(*comparison.curves[2].values.back() - 0.002) < 1e-12); // half of the 4 µm
}

void CompareTestsTest::anyNumberOfThreadsGivesTheSame() {
    Axis11 axis;
    axis.noise = 0.001;
    const Test a = axis.make();
    ComparisonOptions options;
    options.threads = 1;
    const TestComparison one = compare(a, a, options);
    options.threads = 3;
    const TestComparison three = compare(a, a, options);
    for (std::size_t p = 0; p < one.parameters.size(); ++p)
        QCOMPARE(three.parameters[p].uncertainty, one.parameters[p].uncertainty);
}

void CompareTestsTest::gapsTakeAnotherResidual() {
    Axis11 axis;
    axis.noise = 0.001;
    Test a = axis.make();
    axisOf(a).runs[2].deviations[4].reset();
    for (const ComparedParameter &p : compare(a, a).parameters)
        QVERIFY(std::isfinite(*p.uncertainty) && *p.uncertainty > 0);

    // Only the highest target is scattered, by 0, −, 3, −1, −2 µm: the gap draws the 3 of the next cycle.
    axis.noise = axis.slope = 0;
    a = axis.make();
    constexpr std::array scatter{0.0, 0.0, 0.003, -0.001, -0.002};
    for (std::size_t j = 0; j < 2 * scatter.size(); ++j)
        *axisOf(a).runs[j].deviations[4] += 0.01 + (j % 2 == 0 ? scatter[j / 2] : 0);
    axisOf(a).runs[2].deviations[4].reset();
    const double drawn = std::sqrt((0 + 9 + 9 + 1 + 4) / 5.0 - 0.6 * 0.6) / 1000; // 1.67 µm if it drew none
    const double ofMean = smallSampleFactor(5) * std::sqrt(5 / 4.0) * drawn / std::sqrt(4);
    const double expected = 2 * std::sqrt(2) * ofMean / 2; // of both tests, of the mean of both directions
    // 95.45 % of eight draws are within 2.0 of their deviations but for a few per cent.
    const double found = *parameter(compare(a, a), "M").repeatabilityAlone;
    QVERIFY2(std::abs(found / expected - 1) < 0.08, qPrintable(QString::number(found / expected)));
}

void CompareTestsTest::circlesAddTheirSquares() {
    const auto circle = [](double amplitude, double expanded) {
        CircularMeasurement m;
        m.plane = {"X", "Y"};
        m.nominalRadius = 100;
        Arc arc;
        for (int i = 0; i < 360; ++i) {
            arc.angles.push_back(i);
            arc.radialDeviations.push_back(amplitude * std::cos(2 * i * 3.14159265358979 / 180));
        }
        m.arcs = {arc};
        m.uncertainty.method = UncertaintyMethod::direct;
        m.uncertainty.expanded = {{"G", expanded}};
        m.uncertainty.repeatability = 0.1;
        Test test;
        test.edition = "ISO 230-4:2005";
        test.measurement = m;
        return test;
    };
    const Test a = circle(0.005, 3);
    const Test b = circle(0.010, 4);
    const TestComparison comparison = compare(a, b);
    QVERIFY(std::abs(*parameter(comparison, "G").uncertainty - 0.005) < 1e-15);
    QCOMPARE(parameter(comparison, "G").word, std::optional(ChangeWord::worse));
    Test unknown = b;
    std::get<CircularMeasurement>(unknown.measurement).uncertainty.repeatability.reset();
    QCOMPARE(compare(a, unknown).noWord, std::optional(NoWord::noRepeatability));
    std::get<CircularMeasurement>(unknown.measurement).nominalRadius = 150;
    QCOMPARE(compare(a, unknown).refusal, std::optional(NotComparable::otherRadius));
}

QTEST_APPLESS_MAIN(CompareTestsTest)
#include "comparetests.moc"
