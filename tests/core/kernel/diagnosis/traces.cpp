// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/traces.h"

#include "core/kernel/evaluation/circulardata.h"
#include "kernel/diagnosis/synthesize.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace palmer;

namespace {

/// A made circle as it is diagnosed.
struct Made {
    explicit Made(const CircularSynthesis &asked) {
        test.edition = "ISO 230-4:2005";
        test.measurement = synthesizeCircular(asked);
        evaluation = testdata::evaluatedCircular(test);
        circle = diagnosedCircle(std::get<CircularMeasurement>(test.measurement),
                                 std::get<CircularResults>(evaluation.results));
        diagnosis = diagnose(circle);
    }
    [[nodiscard]] std::vector<std::size_t> all() const {
        std::vector<std::size_t> places(diagnosis.sources.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
        return places;
    }
    [[nodiscard]] std::size_t placeOf(InfluenceId id, PlaneAxis axis = PlaneAxis::none) const {
        return static_cast<std::size_t>(diagnosis.find(id, axis) - diagnosis.sources.data());
    }

    palmer::Test test;
    TestEvaluation evaluation;
    DiagnosedCircle circle;
    Diagnosis diagnosis;
};

CircularSynthesis mixture() {
    CircularSynthesis asked;
    asked.points = 720;
    asked.sources = {{InfluenceId::centre, PlaneAxis::first, 0.012},
                     {InfluenceId::radius, PlaneAxis::none, 0.005},
                     {InfluenceId::squareness, PlaneAxis::none, 50e-6},
                     {InfluenceId::servoMismatch, PlaneAxis::none, 0.3e-3},
                     {InfluenceId::backlash, PlaneAxis::second, 0.003}};
    asked.noise = {1e-5, 0, 0, 5};
    return asked;
}

} // namespace

/// Curves and numbers that a diagnosis is shown by, against circles with known truth.
class Traces : public QObject {
    Q_OBJECT

private slots:
    void pathAndRestMakeTheMeasured();
    void pathOfOneSourceDeviatesByItAlone();
    void fittedCircleIsTheTruth();
    void widthsOfOneSource();
    void partsAreRanked();
    void fewestPartsThatMakeMostOfThePath_data();
    void fewestPartsThatMakeMostOfThePath();
    void sumsAreOnePart_data();
    void sumsAreOnePart();
    void vibrationStandsOut();
    void manyPointsOfAnyNumber();
};

void Traces::pathAndRestMakeTheMeasured() {
    const Made made(mixture());
    const auto path = syntheticPath(made.circle, made.diagnosis, made.all());
    const auto rest = unexplained(made.circle, made.diagnosis);
    const Point centre = *made.circle.centre;
    for (std::size_t a = 0; a < made.circle.arcs.size(); ++a) {
        const PointsView measured = made.circle.arcs[a].points;
        QCOMPARE(path[a].size(), measured.size());
        for (std::size_t i = 0; i < measured.size(); ++i) {
            const double r = std::hypot(measured.x[i] - centre.x, measured.y[i] - centre.y);
            const double made_ = std::hypot(path[a].x[i] - centre.x, path[a].y[i] - centre.y);
            QVERIFY(std::abs(made_ + rest[a][i] - r) < 1e-11); // rounding at a radius of 150
            // In the direction in which it was measured.
            const double cross = (measured.x[i] - centre.x) * (path[a].y[i] - centre.y) -
                                 (measured.y[i] - centre.y) * (path[a].x[i] - centre.x);
            QVERIFY(std::abs(cross) < 1e-9);
        }
    }
}

void Traces::pathOfOneSourceDeviatesByItAlone() {
    const Made made(mixture());
    const std::vector<std::size_t> chosen{made.placeOf(InfluenceId::squareness)};
    const auto path = syntheticPath(made.circle, made.diagnosis, chosen);
    const FittedCircle fitted = fittedCircle(made.circle, made.diagnosis);
    for (const Points &points : path) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double x = points.x[i] - fitted.centre.x;
            const double y = points.y[i] - fitted.centre.y;
            const double expected = -50e-6 * 150 / 2 * 2 * x * y / (x * x + y * y);
            // The noise of 0.01 µm and what a shift of the centre makes of second order.
            QVERIFY(std::abs(std::hypot(x, y) - fitted.radius - expected) < 2e-5);
        }
    }
}

void Traces::fittedCircleIsTheTruth() {
    const Made made(mixture());
    const FittedCircle fitted = fittedCircle(made.circle, made.diagnosis);
    QVERIFY(std::abs(fitted.centre.x - 0.012) < 5e-6); // the noise
    QVERIFY(std::abs(fitted.centre.y) < 5e-6);
    QVERIFY(std::abs(fitted.radius - 150.005) < 5e-6);
}

/// Squareness alone makes an oval of width |β|R; nothing is left without it.
void Traces::widthsOfOneSource() {
    CircularSynthesis asked;
    asked.points = 720;
    asked.sources = {{InfluenceId::squareness, PlaneAxis::none, -40e-6}};
    const Made made(asked);
    const std::vector<std::size_t> chosen{made.placeOf(InfluenceId::squareness)};
    const TracedWidths widths = tracedWidths(made.circle, made.diagnosis, chosen);
    const double oval = 40e-6 * 150;
    QVERIFY(std::abs(widths.measured - oval) < 1e-6); // no point stands at ±45° exactly
    QVERIFY(std::abs(widths.chosen - oval) < 1e-6);
    QVERIFY(widths.without < 1e-6);
    const TracedWidths nothing = tracedWidths(made.circle, made.diagnosis, {});
    QVERIFY(nothing.chosen < 1e-9);
    QCOMPARE(nothing.without, nothing.measured);
    const double zone = std::get<CircularResults>(made.evaluation.results)
                            .circle(CircleOf::both, ReferenceCircle::minimumZone)
                            ->width;
    QVERIFY(std::abs(nothing.measured - zone) < 1e-11);
}

void Traces::partsAreRanked() {
    const Made made(mixture());
    const auto parts = rankedParts(made.diagnosis);
    QVERIFY(std::ranges::is_sorted(parts, std::greater<>(), &DiagnosedPart::contribution));
    for (const DiagnosedPart &part : parts) {
        const InfluenceId id = made.diagnosis.sources[part.sources.front()].id;
        QVERIFY(id != InfluenceId::centre && id != InfluenceId::radius);
    }
    QCOMPARE(parts.front().sources.front(), made.placeOf(InfluenceId::squareness));
    QVERIFY(std::abs(parts.front().contribution - 50e-6 * 150) < 1e-5);
}

void Traces::fewestPartsThatMakeMostOfThePath_data() {
    QTest::addColumn<double>("squareness"); // µrad
    QTest::addColumn<double>("backlash");   // µm
    QTest::addColumn<int>("parts");
    QTest::newRow("one far above the rest") << 60.0 << 0.5 << 1;
    QTest::newRow("two alike") << 20.0 << 3.0 << 2;
    QTest::newRow("nothing but noise") << 0.0 << 0.0 << 0;
}

void Traces::fewestPartsThatMakeMostOfThePath() {
    QFETCH(double, squareness);
    QFETCH(double, backlash);
    CircularSynthesis asked;
    asked.points = 720;
    asked.sources = {{InfluenceId::squareness, PlaneAxis::none, squareness * 1e-6},
                     {InfluenceId::backlash, PlaneAxis::first, backlash * 1e-3}};
    asked.noise = {1e-5, 0, 0, 2};
    const Made made(asked);
    QTEST(int(prevailingParts(made.circle, made.diagnosis)), "parts");
}

void Traces::sumsAreOnePart_data() {
    QTest::addColumn<double>("to");
    QTest::addColumn<bool>("oneSense");
    QTest::newRow("one sense") << 360.0 << true;
    QTest::newRow("half a circle") << 180.0 << false;
    QTest::newRow("a quarter") << 90.0 << false;
}

/// What cannot be told apart is traced together, and nothing twice; its path is that of the measured points.
void Traces::sumsAreOnePart() {
    QFETCH(double, to);
    QFETCH(bool, oneSense);
    CircularSynthesis asked = mixture();
    asked.sources.erase(asked.sources.begin()); // seen from the programmed centre the ends of an arc move
    asked.arc = {0, to};
    if (oneSense)
        asked.senses = {Sense::counterclockwise};
    const Made made(asked);
    QVERIFY(!made.diagnosis.sums.empty());
    const auto parts = rankedParts(made.diagnosis);
    std::vector<int> times(made.diagnosis.sources.size());
    std::vector<std::size_t> chosen;
    for (const DiagnosedPart &part : parts) {
        QVERIFY(part.sum || part.sources.size() == 1);
        for (const std::size_t place : part.sources) {
            ++times[place];
            chosen.push_back(place);
        }
    }
    QVERIFY(std::ranges::all_of(times, [](int n) { return n <= 1; }));
    const TracedWidths widths = tracedWidths(made.circle, made.diagnosis, chosen);
    QVERIFY(widths.without < 2e-4); // noise of 0.01 µm, 720 points
    const auto path = syntheticPath(made.circle, made.diagnosis, chosen);
    for (std::size_t a = 0; a < path.size(); ++a) {
        const PointsView measured = made.circle.arcs[a].points;
        for (std::size_t i = 0; i < measured.size(); ++i)
            QVERIFY(std::hypot(path[a].x[i] - measured.x[i], path[a].y[i] - measured.y[i]) < 2e-4);
    }
    // Without them it stays near the measured points, however large the parts of a sum are.
    for (const Points &points : syntheticPath(made.circle, made.diagnosis, {})) {
        for (std::size_t i = 0; i < points.size(); ++i)
            QVERIFY(std::abs(std::hypot(points.x[i], points.y[i]) - 150.005) < 0.03);
    }
}

void Traces::vibrationStandsOut() {
    CircularSynthesis asked;
    asked.points = 720;
    asked.feed = 3000;
    // 226 waves a turn.
    asked.vibration = {5e-4, 226 * 3000.0 / 60 / (2 * std::numbers::pi * 150)};
    const Made made(asked);
    const auto rest = unexplained(made.circle, made.diagnosis);
    const auto lines = spectrum(made.circle, 0, rest[0]);
    const auto largest = std::ranges::max_element(lines, {}, &SpectralLine::amplitude);
    QCOMPARE(std::lround(largest->perTurn), 226L);
    QVERIFY(std::abs(*largest->frequency - asked.vibration.frequency) < 1e-6);
    QVERIFY(std::abs(largest->amplitude - 5e-4) < 5e-6); // the fit takes next to nothing of it
}

/// A prime number of points would take the square of it.
void Traces::manyPointsOfAnyNumber() {
    CircularSynthesis asked;
    asked.points = 99'991; // a prime
    asked.feed = 3000;
    asked.vibration = {5e-4, 226 * 3000.0 / 60 / (2 * std::numbers::pi * 150)};
    asked.noise = {5e-4, 0, 0, 4};
    const Made made(asked);
    const auto rest = unexplained(made.circle, made.diagnosis);
    const auto lines = spectrum(made.circle, 0, rest[0]);
    // Means of neighbours are fitted, but the rest is that of the readings.
    QVERIFY(std::abs(made.diagnosis.residual - 5e-4 * std::sqrt(1.5)) < 5e-6);
    QVERIFY(lines.size() > 49'000);
    const auto largest = std::ranges::max_element(lines, {}, &SpectralLine::amplitude);
    QVERIFY(std::abs(largest->perTurn - 226) < 0.5);
    QVERIFY(std::abs(largest->amplitude - 5e-4) < 2e-4); // part of it leaks into its neighbours
}

QTEST_APPLESS_MAIN(Traces)
#include "traces.moc"
