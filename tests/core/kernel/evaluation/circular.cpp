// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/iso230_4/checks.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/iso230_4/results.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace palmer;

/// Circular tests: published and exact results, properties, and what is refused.
class Circular : public QObject {
    Q_OBJECT

private slots:
    void ballbarPair();
    void ballbarPairByLeastSquares();
    void commandedAngles();
    void correction_data();
    void correction();
    void lengthsChangeByTheCorrection();
    void namesFollowTheSense_data();
    void namesFollowTheSense();
    void editions();
    void evaluatedRange();
    void degenerate_data();
    void degenerate();
    void withoutLeastSquaresCircle_data();
    void withoutLeastSquaresCircle();
    void shortArcStillHasItsCertificate();
    void oneSenseOnly();
    void aRequiredResultThatCannotBeGiven();
    void noResultOfBothFromOne();
    void calibration();
    void feedback();
    void whatIsShownWithoutValueSaysWhy();
    void limitsOfF();
    void rowsAndTestAgreeUnderAllPairsOfLimits();
    void equalToTheLimitConformsWhateverTheRadius();
    void holesOfFullCircles_data();
    void holesOfFullCircles();
    void anglesAgainstTheSense_data();
    void anglesAgainstTheSense();
    void largeDeviationsAreDoubted();
    void nilExpansionNeedsNoCorrection();
    void hysteresis();
    void properties();
    void repetitionsAreEvaluatedLikeTheFirst();
    void withoutLengthsNoCorrectionIsMissed();
    void feedForAnotherDiameter();
};

namespace {

constexpr double micrometre = 1e-3; // mm

/// angle;radial deviation in µm
Arc readArc(const char *name, Sense sense) {
    Arc arc;
    arc.sense = sense;
    QFile file(QStringLiteral(PALMER_SOURCE_DIR "/resources/reference/circles") + u'/' +
               QString::fromUtf8(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no %s", name);
    for (const QByteArray &line : file.readAll().split('\n')) {
        const QList<QByteArray> cells = line.trimmed().split(line.contains(';') ? ';' : ',');
        bool isNumber = false;
        const double angle = cells.value(0).toDouble(&isNumber);
        if (!isNumber || cells.size() < 2)
            continue;
        arc.angles.push_back(angle);
        arc.radialDeviations.push_back(cells[1].toDouble() * micrometre);
    }
    return arc;
}

Test circularTest(std::vector<Arc> arcs, const char *edition = "ISO 230-4:2005", double radius = 150) {
    CircularMeasurement m;
    m.plane = {"X", "Y"};
    m.nominalRadius = radius;
    m.referenceLength.calibrated = true;
    m.arcs = std::move(arcs);
    Test test;
    test.edition = edition;
    test.measurement = std::move(m);
    return test;
}

CircularMeasurement &measurement(Test &test) {
    return std::get<CircularMeasurement>(test.measurement);
}

TestEvaluation evaluated(const Test &test, const char *edition = nullptr) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
}

const Parameter *parameter(const TestEvaluation &evaluation, const char *id) {
    const auto found = std::ranges::find(evaluation.parameters, id, parameterId);
    return found == evaluation.parameters.end() ? nullptr : &*found;
}

double value(const TestEvaluation &evaluation, const char *id) {
    const Parameter *p = parameter(evaluation, id);
    return p && p->value ? *p->value / micrometre : std::numeric_limits<double>::quiet_NaN();
}

const Finding *finding(const TestEvaluation &evaluation, const char *id) {
    const auto found = std::ranges::find(evaluation.findings, id, &Finding::id);
    return found == evaluation.findings.end() ? nullptr : &*found;
}

/// A path with radial deviations of `shape` (µm) at n angles over `extent` degrees from `start`.
template <typename Shape>
Arc path(Sense sense, int n, Shape shape, double start = 0, double extent = 360) {
    Arc arc;
    arc.sense = sense;
    const double sign = sense == Sense::counterclockwise ? 1 : -1;
    for (int i = 0; i < n; ++i) {
        const double angle = start + sign * extent * i / n;
        arc.angles.push_back(angle);
        arc.radialDeviations.push_back(shape(angle * std::numbers::pi / 180) * micrometre);
    }
    return arc;
}

constexpr auto counterclockwise = Sense::counterclockwise;
constexpr auto clockwise = Sense::clockwise;

} // namespace

void Circular::ballbarPair() {
    const auto e = evaluated(circularTest(
        {readArc("ballbar_pair_ccw.csv", counterclockwise), readArc("ballbar_pair_cw.csv", clockwise)}));
    // published with the data to 13 digits; 1e-9 mm = 1e-6 µm is asked for
    const double tolerance = 1e-6;
    QVERIFY(std::abs(value(e, "G_XY") - 20.42116918984) < tolerance);
    QVERIFY(std::abs(value(e, "G_YX") - 24.64810384128) < tolerance);
    QVERIFY(std::abs(value(e, "G(b)_XY") - 25.06388642145) < tolerance);
    QVERIFY(std::abs(value(e, "D_XY") - 1.126290372183) < tolerance);
    QVERIFY(std::abs(value(e, "Fmax_XY") - 12.78373473872) < tolerance);
    QVERIFY(std::abs(value(e, "Fmin_XY") + 9.445532039179) < tolerance);
    QVERIFY(std::abs(value(e, "Fmax_YX") - 15.7125371548) < tolerance);
    QVERIFY(std::abs(value(e, "Fmin_YX") + 11.32371989194) < tolerance);
    const auto &results = std::get<CircularResults>(e.results);
    const CircleResult *both = results.circle(CircleOf::both, ReferenceCircle::minimumZone);
    QVERIFY(both && both->certified == true);
    QVERIFY(std::abs(both->centre.x / micrometre + 14.87726780082) < 1e-5);
    QVERIFY(std::abs(both->centre.y / micrometre - 10.10163452273) < 1e-5);
    QCOMPARE(results.circles.size(), 6u);

    auto setUp = circularTest({readArc("ballbar_pair_ccw.csv", counterclockwise)});
    measurement(setUp).centring = Centring::instrument;
    const auto f = evaluated(setUp);
    QVERIFY(std::abs(value(f, "Fmax_XY") - 21.732758) < tolerance);
    QVERIFY(std::abs(value(f, "Fmin_XY") + 24.859543) < tolerance);
    QVERIFY(finding(f, "setUpCentring") && finding(f, "setUpCentring")->grade == Grade::note);
}

void Circular::ballbarPairByLeastSquares() {
    auto test = circularTest(
        {readArc("ballbar_pair_ccw.csv", counterclockwise), readArc("ballbar_pair_cw.csv", clockwise)});
    measurement(test).referenceCircle = ReferenceCircle::leastSquares;
    const auto e = evaluated(test);
    QVERIFY(std::abs(value(e, "G_XY") - 22.2292667779) < 1e-6);
    QVERIFY(std::abs(value(e, "G_YX") - 27.03625704674) < 1e-6);
    QVERIFY(std::abs(value(e, "G(b)_XY") - 27.03649379717) < 1e-6);
}

void Circular::commandedAngles() {
    // a perfect circle, the pivot 0.3 mm off: the bar reads |R·u(θ) − e|
    const double e[]{0.2, std::sqrt(0.09 - 0.04)};
    const auto reading = [&](double theta) {
        return (std::hypot(150 * std::cos(theta) - e[0], 150 * std::sin(theta) - e[1]) - 150) / micrometre;
    };
    Test test = circularTest({path(counterclockwise, 1000, reading), path(clockwise, 900, reading, 77)});
    for (Arc &arc : measurement(test).arcs)
        arc.angleReference = AngleReference::commanded;
    const auto rebuilt = evaluated(test);
    QVERIFY(value(rebuilt, "G_XY") < 1e-3); // µm: below 1e-6 mm
    QVERIFY(value(rebuilt, "G(b)_XY") < 1e-3);
    QVERIFY(std::abs(value(rebuilt, "D_XY")) < 1e-3);
    for (Arc &arc : measurement(test).arcs)
        arc.angleReference = AngleReference::polar;
    // taken as polar a false ellipse of e²/R is left: 0.600 µm (to the printed digits)
    QVERIFY(std::abs(value(evaluated(test), "G_XY") - 0.600) < 5e-4);
}

void Circular::correction_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("instrument");
    QTest::addColumn<double>("machine");
    QTest::addColumn<double>("alphaInstrument");
    QTest::addColumn<double>("alphaMachine");
    QTest::addColumn<double>("expected");
    QTest::newRow("R 75") << 75.0 << 22.0 << 22.0 << 0.1 << 11.5 << -1.71;
    QTest::newRow("R 150") << 150.0 << 25.0 << 24.0 << 1.2 << 10.8 << -5.58;
    QTest::newRow("R 300") << 300.0 << 18.0 << 23.0 << 1.2 << 11.7 << -11.25;
}

void Circular::correction() {
    QFETCH(double, radius);
    QFETCH(double, instrument);
    QFETCH(double, machine);
    QFETCH(double, alphaInstrument);
    QFETCH(double, alphaMachine);
    QFETCH(double, expected);
    Test test =
        circularTest({path(counterclockwise, 360, [](double) { return 0.0; })}, "ISO 230-4:2005", radius);
    Conditions &conditions = measurement(test).conditions.common;
    conditions.correctionTo20 = CorrectionTo20::appliedHere;
    conditions.expansion = {alphaMachine, alphaInstrument};
    conditions.sensors = {{SensorMeasures::machine, "", machine, machine, {}},
                          {SensorMeasures::instrument, "", instrument, instrument, {}}};
    const auto c = std::get<CircularResults>(evaluated(test).results).correction;
    QVERIFY(c && std::abs(*c / micrometre - expected) < 1e-10);
    conditions.sensors.pop_back();
    const auto without = evaluated(test);
    QVERIFY(!std::get<CircularResults>(without.results).correction);
    QVERIFY(finding(without, "correctionTo20"));
}

void Circular::lengthsChangeByTheCorrection() {
    Test test = circularTest(
        {readArc("ballbar_pair_ccw.csv", counterclockwise), readArc("ballbar_pair_cw.csv", clockwise)});
    const auto raw = evaluated(test);
    Conditions &conditions = measurement(test).conditions.common;
    conditions.correctionTo20 = CorrectionTo20::appliedHere;
    conditions.expansion = {10.8, 1.2};
    conditions.sensors = {{SensorMeasures::machine, "", 24.0, 24.0, {}},
                          {SensorMeasures::instrument, "", 25.0, 25.0, {}}};
    const auto corrected = evaluated(test);
    for (const char *id : {"D_XY", "Fmax_XY", "Fmin_XY", "Fmax_YX", "Fmin_YX"})
        QVERIFY(std::abs(value(corrected, id) - value(raw, id) + 5.58) < 1e-9);
    for (const char *id : {"G_XY", "G_YX", "G(b)_XY"})
        QCOMPARE(value(corrected, id), value(raw, id));
    conditions.correctionTo20 = CorrectionTo20::notApplied;
    QVERIFY(std::get<CircularResults>(evaluated(test).results).at20 == At20::wrong);
    QVERIFY(finding(evaluated(test), "correctionTo20"));
}

void Circular::namesFollowTheSense_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<bool>("clockwiseFirst");
    QTest::addColumn<QString>("ids");
    const auto row = [](const char *name, const char *first, const char *second, bool clockwiseFirst,
                        const char *ids) {
        QTest::newRow(name) << QString::fromUtf8(first) << QString::fromUtf8(second) << clockwiseFirst
                            << QString::fromUtf8(ids);
    };
    row("XY", "X", "Y", false, "G(b)_XY G_XY G_YX D_XY Fmax_XY Fmin_XY Fmax_YX Fmin_YX");
    row("XY, clockwise first", "X", "Y", true, "G(b)_YX G_YX G_XY D_YX Fmax_YX Fmin_YX Fmax_XY Fmin_XY");
    row("ZX", "Z", "X", false, "G(b)_ZX G_ZX G_XZ D_ZX Fmax_ZX Fmin_ZX Fmax_XZ Fmin_XZ");
}

void Circular::namesFollowTheSense() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(bool, clockwiseFirst);
    QFETCH(QString, ids);
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    std::vector<Arc> arcs{path(counterclockwise, 90, shape), path(clockwise, 90, shape)};
    if (clockwiseFirst)
        std::swap(arcs[0], arcs[1]);
    Test test = circularTest(std::move(arcs));
    measurement(test).plane = {first.toStdString(), second.toStdString()};
    QStringList found;
    const auto e = evaluated(test);
    for (const Parameter &p : e.parameters)
        found << QString::fromStdString(parameterId(p));
    QCOMPARE(found.join(u' '), ids);
    QVERIFY(!finding(e, "plane") || finding(e, "plane")->grade == Grade::requirement);
    measurement(test).plane = {"Y", "X"};
    QCOMPARE(finding(evaluated(test), "plane")->grade, Grade::note); // left-handed
}

void Circular::editions() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    const Test test = circularTest({path(counterclockwise, 90, shape), path(clockwise, 90, shape)});
    const auto of1996 = evaluated(test, "ISO 230-4:1996");
    QVERIFY(of1996.view);
    QVERIFY(parameter(of1996, "H_XY") && !parameter(of1996, "G(b)_XY") && !parameter(of1996, "D_XY"));
    const auto of2022 = evaluated(test, "ISO 230-4:2022");
    QCOMPARE(parameter(of2022, "G_XY")->term.name.source, "circular error");
    QCOMPARE(value(of2022, "G(b)_XY"), value(evaluated(test), "G(b)_XY"));
    QCOMPARE(parameter(evaluated(test), "G_XY")->term.clause, "3.4");
    QCOMPARE(parameter(of2022, "G_XY")->term.clause, "");
}

void Circular::evaluatedRange() {
    // feed-in and feed-out of 45° each way hold rubbish: the middle 360° are evaluated
    Arc arc;
    for (int i = 0; i <= 450; ++i) {
        arc.angles.push_back(i - 45);
        arc.radialDeviations.push_back(i < 45 || i > 405 ? 1.0 : 0.001);
    }
    Test test = circularTest({arc});
    auto e = evaluated(test);
    QVERIFY(value(e, "G_XY") < 1e-6);
    QCOMPARE(std::get<CircularResults>(e.results).paths[0].evaluated, (Interval{0, 360}));
    QVERIFY(std::get<CircularResults>(e.results).paths[0].fullCircle);
    measurement(test).arcs[0].evaluated = Interval{10, 200};
    e = evaluated(test);
    const EvaluatedPath &path = std::get<CircularResults>(e.results).paths[0];
    QCOMPARE(path.source.size(), 191u);
    QVERIFY(!path.fullCircle);
    QCOMPARE(path.extent, 190.0);
    QCOMPARE(path.source.front(), 55u);
    QVERIFY(std::isnan(value(e, "Fmax_XY"))); // least squares centre of a partial arc
    QCOMPARE(finding(e, "centring")->grade, Grade::requirement);
}

void Circular::degenerate_data() {
    QTest::addColumn<QList<double>>("angles");
    QTest::addColumn<QList<double>>("radii");
    QTest::newRow("no points") << QList<double>{} << QList<double>{};
    QTest::newRow("one point") << QList<double>{0} << QList<double>{0};
    QTest::newRow("three points") << QList<double>{0, 120, 240} << QList<double>{0, 0.001, 0};
    QTest::newRow("all equal") << QList<double>{5, 5, 5, 5, 5}
                               << QList<double>{0.001, 0.001, 0.001, 0.001, 0.001};
    QTest::newRow("on a line") << QList<double>{0, 0, 0, 0, 0} << QList<double>{-1, -0.5, 0, 0.5, 1};
}

void Circular::degenerate() {
    QFETCH(QList<double>, angles);
    QFETCH(QList<double>, radii);
    Arc arc;
    arc.angles.assign(angles.begin(), angles.end());
    arc.radialDeviations.assign(radii.begin(), radii.end());
    for (const char *edition : {"ISO 230-4:1996", "ISO 230-4:2005", "ISO 230-4:2022"}) {
        Arc back = arc;
        back.sense = clockwise;
        const auto e = evaluated(circularTest({arc, back}, edition));
        QVERIFY(parameter(e, "G_XY") && !parameter(e, "G_XY")->value);
        QVERIFY(e.accordance() != Accordance::yes);
        QVERIFY(finding(e, angles.isEmpty() ? "arcs" : "minimumZone"));
        QVERIFY(finding(e, "noValue"));
    }
    QVERIFY(finding(evaluated(circularTest({})), "arcs"));
}

void Circular::withoutLeastSquaresCircle_data() {
    QTest::addColumn<bool>("circleOfG");
    QTest::addColumn<bool>("centringOfF");
    QTest::addColumn<QByteArray>("asked"); // empty: all
    QTest::addColumn<int>("lost");         // -1: all; else the sense without a circle; 2: the pair
    QTest::addColumn<bool>("expected");
    QTest::newRow("nothing is lost") << true << true << QByteArray() << -2 << false;
    QTest::newRow("G rests on it") << true << false << QByteArray("G") << 0 << true;
    QTest::newRow("of the other path") << true << false << QByteArray("G") << 1 << true;
    QTest::newRow("of the pair") << true << false << QByteArray("G") << 2 << true;
    QTest::newRow("F rests on it") << false << true << QByteArray("F") << 0 << true;
    QTest::newRow("F about the set-up does not") << false << false << QByteArray("F") << -1 << false;
    QTest::newRow("F does not rest on that of the pair") << false << true << QByteArray("F") << 2 << false;
    QTest::newRow("D rests on it") << false << false << QByteArray("D") << 2 << true;
    QTest::newRow("D does not rest on that of a path") << false << false << QByteArray("D") << 0 << false;
    QTest::newRow("minimum zone G alone does not") << false << false << QByteArray("G") << -1 << false;
    QTest::newRow("all are asked for") << false << false << QByteArray() << -1 << true;
}

/// The fit found no circle (not converged, or a straight line): what rests on it has a finding.
void Circular::withoutLeastSquaresCircle() {
    QFETCH(bool, circleOfG);
    QFETCH(bool, centringOfF);
    QFETCH(QByteArray, asked);
    QFETCH(int, lost);
    Test test = circularTest(
        {readArc("ballbar_pair_ccw.csv", counterclockwise), readArc("ballbar_pair_cw.csv", clockwise)});
    CircularMeasurement &m = measurement(test);
    m.referenceCircle = circleOfG ? ReferenceCircle::leastSquares : ReferenceCircle::minimumZone;
    m.centring = centringOfF ? Centring::leastSquares : Centring::instrument;
    if (!asked.isEmpty())
        m.requiredResults = {asked.toStdString()};
    CircularResults results = iso230_4::circularResults(m);
    std::erase_if(results.circles, [&](const CircleResult &circle) {
        const int of = circle.of == CircleOf::counterclockwise ? 0 : circle.of == CircleOf::clockwise ? 1 : 2;
        return circle.kind == ReferenceCircle::leastSquares && (lost == -1 || lost == of);
    });
    const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    const CircularCase whole{test, m, surroundings, *findEdition(test.edition), results};
    const auto sentence = iso230_4::noLeastSquaresCircle(whole);
    QTEST(sentence.has_value(), "expected");
    // And it is asked where circles are evaluated.
    const bool asks =
        std::ranges::any_of(findEdition(test.edition)->circles->requirements, [&](const auto &row) {
            const Judgement judged = row.judge(whole);
            return sentence && judged.sentence && judged.sentence->text.source == sentence->text.source;
        });
    QTEST(asks, "expected");
}

void Circular::shortArcStillHasItsCertificate() {
    const auto shape = [](double theta) { return 3 * std::sin(9 * theta) + std::cos(17 * theta); };
    const auto e = evaluated(circularTest({path(counterclockwise, 400, shape, 10, 80)}));
    const CircleResult *circle =
        std::get<CircularResults>(e.results).circle(CircleOf::counterclockwise, ReferenceCircle::minimumZone);
    QVERIFY(circle && circle->certified.has_value());
    QVERIFY(value(e, "G_XY") > 0);
    QCOMPARE(finding(e, "arcs")->grade, Grade::requirement);
}

void Circular::oneSenseOnly() {
    const auto e =
        evaluated(circularTest({path(clockwise, 360, [](double theta) { return std::cos(2 * theta); })}));
    QVERIFY(parameter(e, "G_YX") && !parameter(e, "G_XY") && !parameter(e, "G(b)_YX") &&
            !parameter(e, "D_YX"));
    QCOMPARE(finding(e, "bothSenses")->grade, Grade::requirement);
    Test test = circularTest({path(clockwise, 360, [](double theta) { return std::cos(2 * theta); })});
    measurement(test).requiredResults = {"G"};
    QVERIFY(!finding(evaluated(test), "bothSenses")); // nobody asked for G(b) or D
    measurement(test).source = SignalSource::feedback;
    measurement(test).requiredResults = {"Gf"};
    QVERIFY(!finding(evaluated(test), "bothSenses"));
    measurement(test).requiredResults = {"G(b)f"};
    QVERIFY(finding(evaluated(test), "bothSenses"));
}

void Circular::aRequiredResultThatCannotBeGiven() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    Test test = circularTest({path(counterclockwise, 360, shape), path(clockwise, 360, shape)});
    const auto found = [&](std::vector<std::string> required, SignalSource source) {
        measurement(test).requiredResults = std::move(required);
        measurement(test).source = source;
        return evaluated(test);
    };
    QVERIFY(!finding(found({"G", "F"}, SignalSource::external), "noValue"));
    for (const auto &e :
         {found({"H"}, SignalSource::external), found({"G", "G(b)"}, SignalSource::feedback)}) {
        QVERIFY(finding(e, "noValue"));
        QVERIFY(std::ranges::all_of(e.parameters, &Parameter::required)); // nothing left: all are given
    }
    const auto some = found({"H", "G"}, SignalSource::external);
    QVERIFY(finding(some, "noValue") && parameter(some, "G_XY")->required &&
            !parameter(some, "G(b)_XY")->required);
    measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedHere;
    measurement(test).conditions.common.expansion = {11.5, 0.5};
    for (const SensorMeasures what : {SensorMeasures::machine, SensorMeasures::instrument})
        measurement(test).conditions.common.sensors.push_back({what, "", 21.5, 21.5, {}});
    const auto correction = [](const TestEvaluation &e) {
        return std::get<CircularResults>(e.results).correction;
    };
    QVERIFY(correction(found({"F"}, SignalSource::external)));
    QVERIFY(!correction(found({}, SignalSource::feedback))); // which has neither F nor D
}

void Circular::noResultOfBothFromOne() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    for (const std::size_t k : {0U, 1U}) {
        for (const std::size_t points : {0U, 1U, 3U}) {
            Test test = circularTest({path(counterclockwise, 360, shape), path(clockwise, 360, shape)});
            QVERIFY(parameter(evaluated(test), "G(b)_XY")->value);
            Arc &arc = measurement(test).arcs[k];
            arc.angles.resize(points);
            arc.radialDeviations.resize(points);
            for (const bool ofFeedback : {false, true}) {
                measurement(test).source = ofFeedback ? SignalSource::feedback : SignalSource::external;
                const auto e = evaluated(test);
                const Parameter *both = parameter(e, ofFeedback ? "G(b)f_XY" : "G(b)_XY");
                QVERIFY(both && !both->value);
                QVERIFY(ofFeedback || !parameter(e, "D_XY")->value);
                QVERIFY(finding(e, "bothSenses"));
            }
        }
    }
}

void Circular::calibration() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    Test test = circularTest({path(counterclockwise, 360, shape), path(clockwise, 360, shape)});
    measurement(test).referenceLength.calibrated = false;
    const auto refused = evaluated(test);
    QVERIFY(std::isnan(value(refused, "D_XY")) && std::isnan(value(refused, "Fmax_XY")));
    QCOMPARE(finding(refused, "referenceLength")->grade, Grade::requirement);
    QVERIFY(value(refused, "G_XY") > 0);
    measurement(test).referenceLength.calibrated.reset();
    const auto notStated = evaluated(test);
    QVERIFY(parameter(notStated, "D_XY")->value.has_value());
    QVERIFY(finding(notStated, "referenceLength"));

    // What nobody says to be calibrated proves no limit; one that is exceeded stays so.
    test.limits = {{"D", {1.0, {}, ""}}, {"F", {1e-6, {}, ""}}, {"G", {1.0, {}, ""}}};
    const auto limited = evaluated(test);
    QVERIFY(limited.limits.at(0).state == LimitState::notEvaluable);
    QVERIFY(limited.limits.at(0).reason == NotEvaluable::calibrationOpen);
    QVERIFY(limited.limits.at(1).state == LimitState::exceeded);
    QVERIFY(limited.limits.at(2).state == LimitState::respected);
    measurement(test).referenceLength.calibrated = true;
    QVERIFY(evaluated(test).limits.at(0).state == LimitState::respected);
}

void Circular::whatIsShownWithoutValueSaysWhy() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    Test test =
        circularTest({path(counterclockwise, 180, shape, 0, 180), path(clockwise, 180, shape, 180, 180)});
    for (const Limits &limits : {Limits{}, Limits{{"G", {0.01, {}, ""}}}}) {
        test.limits = limits;
        const auto e = evaluated(test);
        QVERIFY(!parameter(e, "Fmax_XY")->value && !parameter(e, "D_XY")->value);
        for (const char *id : {"centring", "fullCircles"}) {
            const Finding *why = finding(e, id);
            QVERIFY2(why, id);
            // No limit asks for them: no requirement.
            QVERIFY2((why->grade == Grade::requirement) == limits.empty(), id);
        }
    }
    measurement(test).requiredResults = {"G"}; // F and D are not shown
    QVERIFY(!finding(evaluated(test), "centring") && !finding(evaluated(test), "fullCircles"));
}

void Circular::feedback() {
    const auto shape = [](double theta) { return std::cos(2 * theta); };
    Test test = circularTest({path(counterclockwise, 360, shape), path(clockwise, 360, shape)});
    measurement(test).source = SignalSource::feedback;
    const auto e = evaluated(test);
    QStringList ids;
    for (const Parameter &p : e.parameters)
        ids << QString::fromStdString(parameterId(p));
    QCOMPARE(ids.join(u' '), QStringLiteral("G(b)f_XY Gf_XY Gf_YX"));
    QVERIFY(finding(e, "source") && !finding(e, "toolOffset") && !finding(e, "sensors"));
    measurement(test).requiredResults = {"F"};
    QCOMPARE(finding(evaluated(test), "requiredResults")->grade, Grade::requirement);
}

void Circular::limitsOfF() {
    // Fmax = 2, Fmin = −5 µm about the set-up centre
    const auto shape = [](double theta) { return theta == 0 ? 2.0 : theta > 3 && theta < 3.2 ? -5.0 : 0.0; };
    Test test = circularTest({path(counterclockwise, 360, shape)});
    measurement(test).centring = Centring::instrument;
    test.limits = {{"F", {0.004, {}, ""}}};
    auto e = evaluated(test);
    QVERIFY(!parameter(e, "Fmax_XY")->verdict);
    QVERIFY(parameter(e, "Fmin_XY")->verdict == Verdict::doesNotConform);
    QVERIFY(e.verdict == Verdict::doesNotConform);
    test.limits = {{"Fmax", {0.003, {}, ""}}, {"Fmin", {-0.006, {}, ""}}};
    e = evaluated(test);
    QVERIFY(parameter(e, "Fmax_XY")->verdict == Verdict::conforms);
    QVERIFY(parameter(e, "Fmin_XY")->verdict == Verdict::conforms);
    QVERIFY(!finding(e, "limits")); // a limit from below may be negative
    test.limits = {{"Fmin", {-0.004, {}, ""}}};
    QVERIFY(evaluated(test).verdict == Verdict::doesNotConform);
    // Two limits of one row: its name is said once.
    Test warm = test;
    warm.limits = {{"F", {0.01, {}, ""}}, {"Fmin", {-0.006, {}, ""}}};
    warm.decisionRule = {Rule::iso14253_1, 1.0};
    measurement(warm).conditions.common.sensors = {{SensorMeasures::machine, "", 25, 25, {}}};
    const auto uncorrected = evaluated(warm);
    const auto said = std::ranges::find_if(uncorrected.findings, [](const Finding &finding) {
        return std::string_view(finding.message.text.source).starts_with("Nothing is proven for");
    });
    QVERIFY(said != uncorrected.findings.end());
    QCOMPARE(std::get<std::string>(said->message.arguments.at(0)), std::string("FminXY"));
    test.limits = {{"D", {0.01, {}, ""}}};
    e = evaluated(test);
    QVERIFY(e.verdict == Verdict::notProven && finding(e, "limits"));
    QVERIFY(e.limits.at(0).reason == NotEvaluable::oneSense);
    test.limits = {{"G(b)f", {0.01, {}, ""}}};
    QVERIFY(evaluated(test).limits.at(0).reason == NotEvaluable::noSuchParameter);
    measurement(test).source = SignalSource::feedback;
    test.limits = {{"F", {0.01, {}, ""}}};
    QVERIFY(evaluated(test).limits.at(0).reason == NotEvaluable::feedbackSignal);
}

void Circular::rowsAndTestAgreeUnderAllPairsOfLimits() {
    std::mt19937_64 random(230);
    std::uniform_real_distribution<double> uniform(0, 1);
    int fromF = 0;
    for (int round = 0; round < 1500; ++round) {
        const double most = 10 * uniform(random) - (round % 7 ? 0 : 5);
        const double least = most - 1 - 12 * uniform(random);
        Test test = circularTest({path(counterclockwise, 90, [&](double theta) {
            return theta < 1 ? most : theta < 2 ? least : (most + least) / 2;
        })});
        measurement(test).centring = Centring::instrument;
        measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedByInstrument;
        const bool proof = round % 3 == 0;
        test.decisionRule = {proof ? Rule::iso14253_1 : Rule::simpleAcceptance, 1.0};
        if (proof && round % 2) {
            measurement(test).uncertainty.method = UncertaintyMethod::direct;
            measurement(test).uncertainty.expanded = {{"F", 2 * uniform(random)}};
        }
        const auto which = static_cast<unsigned>(1 + random() % 7);
        if (which & 1)
            test.limits["F"].value = 12 * uniform(random) * micrometre;
        if (which & 2)
            test.limits["Fmax"].value = (12 * uniform(random) - 1) * micrometre;
        if (which & 4)
            test.limits["Fmin"].value = -12 * uniform(random) * micrometre;
        const auto e = evaluated(test);
        // What each limit says, by the clauses: F at the row of the larger size, Fmax from above, Fmin from
        // below.
        const double u = proof && round % 2 ? measurement(test).uncertainty.expanded.at("F") : 0;
        const auto verdict = [&](double badness, double limit) {
            if (!proof)
                return badness <= limit ? Verdict::conforms : Verdict::doesNotConform;
            if (round % 2 == 0)
                return Verdict::notProven;
            return badness <= limit - u  ? Verdict::conforms
                   : badness > limit + u ? Verdict::doesNotConform
                                         : Verdict::notProven;
        };
        struct Said {
            const char *key;
            Verdict verdict;
            double room;
        };
        const auto limit = [&](const char *key) { return *test.limits.at(key).value / micrometre; };
        std::vector<Said> ofMost;
        std::vector<Said> ofLeast;
        const bool lowRules = std::abs(least) > std::abs(most);
        if (which & 1) {
            const double size = std::max(std::abs(most), std::abs(least));
            (lowRules ? ofLeast : ofMost).push_back({"F", verdict(size, limit("F")), limit("F") - size});
        }
        if (which & 2)
            ofMost.push_back({"Fmax", verdict(most, limit("Fmax")), limit("Fmax") - most});
        if (which & 4)
            ofLeast.push_back({"Fmin", verdict(-least, -limit("Fmin")), least - limit("Fmin")});
        std::optional<Verdict> worstOfRows;
        for (const auto &[id, said] : {std::pair{"Fmax_XY", &ofMost}, std::pair{"Fmin_XY", &ofLeast}}) {
            const Parameter &row = *parameter(e, id);
            QCOMPARE(row.verdict.has_value(), !said->empty());
            if (said->empty())
                continue;
            const Said &shown = *std::ranges::max_element(*said, [](const Said &a, const Said &b) {
                return std::pair(a.verdict, -a.room) < std::pair(b.verdict, -b.room);
            });
            QCOMPARE(row.limitOf, shown.key);
            QVERIFY(row.verdict == shown.verdict);
            QCOMPARE(*row.limit->value, *test.limits.at(shown.key).value);
            QVERIFY(row.bound == (row.limitOf == "F"      ? Bound::magnitude
                                  : row.limitOf == "Fmax" ? Bound::upper
                                                          : Bound::lower));
            fromF += row.limitOf == "F";
            worstOfRows = std::max(worstOfRows.value_or(shown.verdict), shown.verdict);
            QCOMPARE(finding(e, "limits") != nullptr, ofMost.size() == 2 || ofLeast.size() == 2);
        }
        QVERIFY(e.verdict == worstOfRows); // never a verdict that no row has
    }
    QVERIFY(fromF > 100);

    // Equal limits: the parameter's own, found tighter or worse by nobody.
    Test test = circularTest({path(counterclockwise, 90, [](double theta) { return theta < 1 ? 3 : -1; })});
    measurement(test).centring = Centring::instrument;
    test.limits = {{"F", {0.004, {}, ""}}, {"Fmax", {0.004, {}, ""}}};
    QCOMPARE(parameter(evaluated(test), "Fmax_XY")->limitOf, "Fmax");
    const auto says = [&](const char *words) {
        const TestEvaluation e = evaluated(test);
        const Finding *said = finding(e, "limits");
        return said && std::string_view(said->message.text.source).find(words) != std::string_view::npos;
    };
    QVERIFY(says("which are equal"));
    QVERIFY(!says("tighter"));
    test.limits["Fmax"].value = std::nextafter(0.004, 0);
    QVERIFY(says("tighter"));
    test.limits["Fmax"].value = std::nextafter(0.004, 1);
    QVERIFY(says("tighter"));
}

/// Deviations of ± half the limit, four times around: G and Fmax are exactly known whatever the radius, whose
/// rounding they are differences of.
void Circular::equalToTheLimitConformsWhateverTheRadius() {
    for (const double radius : {10.0, 50.0, 150.0, 300.0, 1000.0, 7000.0}) {
        for (int tenths = 1; tenths <= 200; ++tenths) {
            const double width = tenths / 10.0; // µm
            Test test = circularTest({path(counterclockwise, 72, [&](double theta) {
                return std::fmod(theta * 180 / std::numbers::pi + 1, 90) < 45 ? width / 2 : -width / 2;
            })});
            measurement(test).nominalRadius = radius;
            const auto verdict = [&](const char *id, double limit) {
                test.limits.clear();
                test.limits[id].value = limit * micrometre;
                return *evaluated(test).verdict;
            };
            for (const char *id : {"G", "Fmax"}) {
                const double value = id[0] == 'G' ? width : width / 2;
                const double nothing = 1e-6; // µm: beyond all rounding up to 7 m of radius
                QVERIFY2(verdict(id, value) == Verdict::conforms, id);
                QVERIFY2(verdict(id, value + nothing) == Verdict::conforms, id);
                QVERIFY2(
                    verdict(id, value - nothing) == Verdict::doesNotConform,
                    qPrintable(
                        QStringLiteral("%1 of R %2: %3").arg(QString::fromUtf8(id)).arg(radius).arg(value)));
            }
        }
    }
}

void Circular::holesOfFullCircles_data() {
    QTest::addColumn<int>("hole");  // degrees left out
    QTest::addColumn<int>("holes"); // that many times
    QTest::addColumn<double>("to"); // last angle
    QTest::addColumn<bool>("full");
    QTest::newRow("whole") << 0 << 0 << 359.0 << true;
    QTest::newRow("a hole of 90°") << 90 << 1 << 359.0 << true;
    QTest::newRow("a hole of 91°") << 91 << 1 << 359.0 << false;
    QTest::newRow("two holes of 45°") << 45 << 2 << 359.0 << true;
    QTest::newRow("two holes of 46°") << 46 << 2 << 359.0 << false;
    QTest::newRow("steps of four are no hole") << 4 << 30 << 359.0 << true;
    QTest::newRow("steps of five are") << 5 << 30 << 359.0 << false;
    QTest::newRow("the closing step counts: 45°, 45°") << 45 << 1 << 315.0 << true;
    QTest::newRow("the closing step counts: 45°, 46°") << 45 << 1 << 314.0 << false;
    QTest::newRow("the closing step is twice the largest") << 30 << 1 << 300.0 << true;
    QTest::newRow("the closing step is more") << 30 << 1 << 299.0 << false;
}

void Circular::holesOfFullCircles() {
    QFETCH(int, hole);
    QFETCH(int, holes);
    QFETCH(double, to);
    QFETCH(bool, full);
    Arc arc;
    int left = holes;
    for (double angle = 0; angle <= to;) {
        arc.angles.push_back(angle);
        arc.radialDeviations.push_back(1e-3);
        angle += left > 0 && arc.angles.size() % 3 == 0 ? hole : 1;
        left -= left > 0 && arc.angles.size() % 3 == 0 ? 1 : 0;
    }
    const auto e = evaluated(circularTest({arc}));
    const EvaluatedPath &evaluatedPath = std::get<CircularResults>(e.results).paths[0];
    QCOMPARE(evaluatedPath.fullCircle, full);
    QCOMPARE(evaluatedPath.extent == 360.0, full);
    QCOMPARE(parameter(e, "Fmax_XY")->value.has_value(), full);
    // In whatever order they were read.
    std::mt19937_64 random(8);
    for (const bool anyhow : {false, true}) {
        std::ranges::reverse(arc.angles);
        if (anyhow)
            std::ranges::shuffle(arc.angles, random);
        const auto again = evaluated(circularTest({arc}));
        const EvaluatedPath &path = std::get<CircularResults>(again.results).paths[0];
        QCOMPARE(path.fullCircle, evaluatedPath.fullCircle);
        QVERIFY(path.extent == evaluatedPath.extent);
    }
}

void Circular::anglesAgainstTheSense_data() {
    QTest::addColumn<QList<double>>("angles");
    QTest::addColumn<bool>("against"); // counterclockwise
    const auto ramp = [](double from, double to, double step) {
        QList<double> angles;
        for (int i = 0; i <= std::lround((to - from) / step); ++i)
            angles.append(from + step * i);
        return angles;
    };
    QTest::newRow("grow") << ramp(0, 359, 1) << false;
    QTest::newRow("fall") << ramp(359, 0, -1) << true;
    QTest::newRow("a short arc that falls") << ramp(100, 0, -1) << true;
    QTest::newRow("not unwrapped, half way") << ramp(180, 359, 1) + ramp(0, 179, 1) << true;
    QTest::newRow("not unwrapped, with overlap") << ramp(0, 359, 1) + ramp(0, 90, 1) << true;
    QTest::newRow("there and back") << ramp(0, 180, 1) + ramp(179, 0, -1) << true;
    QTest::newRow("a turn and a half") << ramp(-90, 450, 1) << false;
    QList<double> noisy = ramp(0, 359, 1);
    for (qsizetype i = 0; i < noisy.size(); ++i)
        noisy[i] += 3 * std::sin(1.7 * static_cast<double>(i));
    QTest::newRow("noise of measured angles") << noisy << false;
    QTest::newRow("one point") << QList<double>{5} << false;
}

void Circular::anglesAgainstTheSense() {
    QFETCH(QList<double>, angles);
    QFETCH(bool, against);
    for (const Sense sense : {counterclockwise, clockwise}) {
        Arc arc;
        arc.sense = sense;
        for (const double angle : angles) {
            arc.angles.push_back(sense == counterclockwise ? angle : -angle);
            arc.radialDeviations.push_back(1e-3);
        }
        // As the second arc of its sense it is looked at, too.
        for (const bool repeated : {false, true}) {
            std::vector<Arc> arcs{arc};
            if (repeated)
                arcs.insert(arcs.begin(), path(sense, 360, [](double) { return 1.0; }));
            const auto e = evaluated(circularTest(arcs));
            const auto says = [](const Finding &f) {
                return f.id == "arcs" &&
                       QString::fromUtf8(f.message.text.source).contains(u"against its sense");
            };
            const auto found = std::ranges::find_if(e.findings, says);
            QCOMPARE(found != e.findings.end(), against);
            if (against)
                QVERIFY(found->message.arguments[0] == Argument(std::string(repeated ? "2" : "1")));
        }
    }
}

/// A tenth of the radius, from both sides and outwards and inwards.
void Circular::largeDeviationsAreDoubted() {
    for (const double radius : {0.5, 50.0, 150.0}) {
        for (const double share : {-1.2, -0.11, -0.1, 0.0, 0.1, 0.11, 1.2}) {
            Arc arc = path(counterclockwise, 360, [](double) { return 0.0; });
            arc.radialDeviations[7] = share * radius;
            const auto e = evaluated(circularTest({arc}, "ISO 230-4:2005", radius));
            const auto found = std::ranges::find_if(e.findings, [](const Finding &f) {
                return QString::fromUtf8(f.message.text.source).contains(u"on a circle of radius");
            });
            QCOMPARE(found != e.findings.end(), std::abs(share) > 0.105);
            if (found != e.findings.end()) {
                QCOMPARE(found->grade, Grade::note);
                QCOMPARE(std::get<Number>(found->message.arguments[0]).value, std::abs(share) * radius);
            }
        }
    }
}

void Circular::nilExpansionNeedsNoCorrection() {
    Test test = circularTest({path(counterclockwise, 360, [](double) { return 1.0; })});
    Conditions &conditions = measurement(test).conditions.common;
    conditions.correctionTo20 = CorrectionTo20::notApplied;
    const auto isMissing = [&](double machine, double instrument) {
        conditions.sensors = {{SensorMeasures::machine, "", machine, machine, {}},
                              {SensorMeasures::instrument, "", instrument, instrument, {}}};
        const auto e = evaluated(test);
        const bool result = std::get<CircularResults>(e.results).at20 == At20::wrong;
        if (result != (finding(e, "correctionTo20") != nullptr))
            qFatal("finding and result differ");
        return result;
    };
    QVERIFY(isMissing(30, 30)); // coefficients not stated
    conditions.expansion = {11, 11};
    QVERIFY(!isMissing(30, 30));
    QVERIFY(isMissing(20, 30));
    QVERIFY(isMissing(30, 20));
    QVERIFY(!isMissing(20, 20));
    // 0.05 µm over the radius of 150 mm: 1/3 µm/m
    conditions.expansion = {11, 11 + 0.033};
    QVERIFY(!isMissing(30, 30));
    conditions.expansion = {11, 11 + 0.034};
    QVERIFY(isMissing(30, 30));
    // Asked for and impossible: at 20 °C nothing is missing.
    conditions.correctionTo20 = CorrectionTo20::appliedHere;
    conditions.expansion = {};
    QVERIFY(isMissing(24, 20));
    conditions.sensors = {{SensorMeasures::machine, "", 20.0, 20.0, {}},
                          {SensorMeasures::instrument, "", 20.0, 20.0, {}}};
    QVERIFY(std::get<CircularResults>(evaluated(test).results).at20 == At20::hold);
    conditions.sensors.clear();
    QVERIFY(std::get<CircularResults>(evaluated(test).results).at20 == At20::wrong);
}

void Circular::hysteresis() {
    // two circles about one centre, 4 µm apart, with other angles in each sense
    const auto e = evaluated(circularTest({path(counterclockwise, 720, [](double) { return 2.0; }),
                                           path(
                                               clockwise, 500, [](double) { return -2.0; }, 13)},
                                          "ISO 230-4:1996"));
    QVERIFY(std::abs(value(e, "H_XY") - 4) < 1e-9);
    QVERIFY(!finding(e, "fullCircles"));
    Test half = circularTest({path(counterclockwise, 360, [](double) { return 0.0; }),
                              path(clockwise, 360, [](double) { return 1.0; })});
    for (Arc &arc : measurement(half).arcs) {
        arc.angles.resize(180);
        arc.radialDeviations.resize(180);
    }
    const auto arcs = evaluated(half, "ISO 230-4:1996");
    QVERIFY(!parameter(arcs, "H_XY")->value);
    QVERIFY(finding(arcs, "fullCircles")); // why
    // A point of one sense that stands out between two of the other is seen from its own side: 10 + 2 µm.
    // From the other side the path about it is interpolated, half as far out.
    constexpr double degree = std::numbers::pi / 180;
    for (const Sense spiky : {counterclockwise, clockwise}) {
        const auto shape = [&](Sense sense, double at) {
            return [=](double theta) {
                return sense != spiky ? -2.0 : std::abs(theta - at * degree) < 1e-6 ? 10.0 : 2.0;
            };
        };
        const auto one = evaluated(circularTest({path(counterclockwise, 360, shape(counterclockwise, 50), 50),
                                                 path(clockwise, 360, shape(clockwise, 50.5), 50.5)},
                                                "ISO 230-4:1996"));
        QVERIFY(std::abs(value(one, "H_XY") - 12) < 1e-4); // the centre moves by 0.02 µm
    }
}

void Circular::properties() {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 300; ++round) {
        double a[2][6];
        for (auto &row : a)
            for (double &x : row)
                x = 5 * uniform(random);
        const auto shape = [&](int k) {
            return [&, k](double t) {
                return a[k][0] * std::cos(t) + a[k][1] * std::sin(t) + a[k][2] * std::cos(2 * t) +
                       a[k][3] * std::sin(3 * t) + a[k][4] + a[k][5] * std::cos(7 * t) + uniform(random);
            };
        };
        Test test = circularTest({path(counterclockwise, 200, shape(0)), path(clockwise, 150, shape(1))});
        const auto zone = evaluated(test);
        const double rounding = 1e-9; // µm, on 10⁵ µm of radius
        QVERIFY(value(zone, "G(b)_XY") >= std::max(value(zone, "G_XY"), value(zone, "G_YX")) - rounding);
        QVERIFY(value(zone, "Fmax_XY") - value(zone, "Fmin_XY") >= value(zone, "G_XY") - rounding);
        measurement(test).referenceCircle = ReferenceCircle::leastSquares;
        const auto fit = evaluated(test);
        for (const char *id : {"G_XY", "G_YX", "G(b)_XY"})
            QVERIFY(value(fit, id) >= value(zone, id) - rounding);
        // turned by an angle, nothing changes
        measurement(test).referenceCircle = ReferenceCircle::minimumZone;
        for (Arc &arc : measurement(test).arcs) {
            for (double &angle : arc.angles)
                angle += 33.3;
        }
        const auto turned = evaluated(test);
        for (const char *id : {"G_XY", "G_YX", "G(b)_XY", "D_XY", "Fmax_YX"})
            QVERIFY(std::abs(value(turned, id) - value(zone, id)) < 1e-7);
    }
}

void Circular::repetitionsAreEvaluatedLikeTheFirst() {
    const auto shape = [](double angle) { return 3 * std::cos(2 * angle) + 20 * std::cos(angle); };
    auto test = circularTest({path(counterclockwise, 180, shape), path(clockwise, 180, shape),
                              path(counterclockwise, 180, shape)});
    for (Arc &arc : measurement(test).arcs)
        arc.angleReference = AngleReference::commanded;
    const auto e = evaluated(test);
    const auto &results = std::get<CircularResults>(e.results);
    QCOMPARE(results.repetitions, std::vector<std::size_t>{2});
    const EvaluatedPath first = iso230_4::evaluatedPath(measurement(test), 0, results.centringError);
    const EvaluatedPath third = iso230_4::evaluatedPath(measurement(test), 2, results.centringError);
    QCOMPARE(first.points, results.paths[0].points);
    QCOMPARE(third.points, first.points);
    QCOMPARE(third.arc, 2u);
    QCOMPARE(third.index, std::string("XY"));
    for (const auto kind : {ReferenceCircle::minimumZone, ReferenceCircle::leastSquares})
        QCOMPARE(iso230_4::circleOfPath(third, kind)->width,
                 results.circle(CircleOf::counterclockwise, kind)->width);
    auto tooFew = circularTest({path(counterclockwise, 3, shape)});
    const EvaluatedPath three = iso230_4::evaluatedPath(measurement(tooFew), 0, std::nullopt);
    QVERIFY(!iso230_4::circleOfPath(three, ReferenceCircle::minimumZone));
}

void Circular::withoutLengthsNoCorrectionIsMissed() {
    auto test = circularTest({path(counterclockwise, 36, [](double angle) { return std::cos(2 * angle); })});
    measurement(test).conditions.common.correctionTo20 = CorrectionTo20::appliedHere;
    const auto asks = [&] {
        const auto e = evaluated(test);
        return std::ranges::any_of(e.findings, [](const Finding &f) {
            return std::string_view(f.message.text.source).starts_with("F and D cannot be corrected");
        });
    };
    QVERIFY(asks());
    measurement(test).requiredResults = {"G"};
    QVERIFY(!asks());
}

void Circular::feedForAnotherDiameter() {
    using iso230_4::contouringFeed;
    // Annex C prints 559 mm/min; exactly 500·√1.25.
    QVERIFY(std::abs(*contouringFeed({100, 500, 125}) - 250 * std::sqrt(5.0)) < 1e-12 * 559);
    QCOMPARE(*contouringFeed({100, 500, 100}), 500.0);
    QCOMPARE(*contouringFeed({1e-200, 1, 1e200}), 1e200); // the quotient alone would overflow
    const double infinite = std::numeric_limits<double>::infinity();
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, infinite, none}) {
        QVERIFY(!contouringFeed({bad, 500, 125}));
        QVERIFY(!contouringFeed({100, bad, 125}));
        QVERIFY(!contouringFeed({100, 500, bad}));
    }
    QVERIFY(!contouringFeed({1e-300, 1e300, 1e300}));
}

QTEST_GUILESS_MAIN(Circular)
#include "circular.moc"
