// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "kernel/diagnosis/diagnosis.h"

#include "core/kernel/diagnosis/coverage.h"
#include "core/kernel/evaluation/circulardata.h"
#include "kernel/diagnosis/sourcewords.h"
#include "kernel/diagnosis/traces.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace palmer;
using testdata::MadeCircle;

namespace {

constexpr auto none = PlaneAxis::none;
constexpr auto x = PlaneAxis::first;
constexpr auto y = PlaneAxis::second;

const DiagnosisOptions withoutSearch{{}, {}, false, false, {}};

Diagnosis diagnosed(const CircularSynthesis &asked, const DiagnosisOptions &options = {}) {
    const MadeCircle made(synthesizeCircular(asked));
    return diagnose(made.circle(), options);
}

double valueOf(const Diagnosis &diagnosis, InfluenceId id, PlaneAxis axis = none) {
    const SourceEstimate *source = diagnosis.find(id, axis);
    return source && source->value ? *source->value : std::numeric_limits<double>::quiet_NaN();
}

/// All linear sources at once.
CircularSynthesis machine() {
    CircularSynthesis asked;
    asked.points = 720;
    asked.sources = {{InfluenceId::centre, x, 0.012},        {InfluenceId::centre, y, -0.007},
                     {InfluenceId::radius, none, 2e-3},      {InfluenceId::scaleMismatch, none, 65e-6},
                     {InfluenceId::squareness, none, 30e-6}, {InfluenceId::servoMismatch, none, 6e-4},
                     {InfluenceId::backlash, x, 6e-3},       {InfluenceId::backlash, y, -4e-3},
                     {InfluenceId::lateralPlay, x, 3e-3},    {InfluenceId::lateralPlay, y, 1.5e-3},
                     {InfluenceId::straightness, x, 8e-3},   {InfluenceId::straightness, y, -5e-3}};
    return asked;
}

/// In units that make 1 about a micrometre.
double unitOf(InfluenceId id) {
    return influence(id).unitsPerBase;
}

} // namespace

class DiagnosisTest : public QObject {
    Q_OBJECT

private slots:
    void truthOfTheBallbarPair();
    void rankAndCondition_data();
    void rankAndCondition();
    void inseparableSourcesGiveTheirSum();
    void aSumHoldsTheWholeCentre_data();
    void aSumHoldsTheWholeCentre();
    void aSumStatesWhatItAdds();
    void eachSourceIsRecognised_data();
    void eachSourceIsRecognised();
    void everyUsualPitchIsFound();
    void theShapeOfAGuidewayIsNoPitch();
    void statedPitchAndWidth();
    void severalFeeds();
    void noiseAloneIsNoSource();
    void startOfThePathDoesNotCount();
    void exchangeOfAxes();
    void effectsAddUp();
    void lagOfCommandedAngles_data();
    void lagOfCommandedAngles();
    void turnedAngles_data();
    void turnedAngles();
    void resolutionBoundsTheUncertainty();
    void changeOfRadiusBetweenTheArcs();
    void intervalsCoverTheTruth_data();
    void intervalsCoverTheTruth();
    void manyPointsAreAveraged();
    void tracesAddUpToTheMeasured();
    void spectrumShowsAVibration();
    void withoutFeed();
    void badInput_data();
    void badInput();
    void wordsForEverySource();
    void uncertaintiesAsShown();
};

void DiagnosisTest::truthOfTheBallbarPair() {
    // The angles of the file are those of the machine's own circle: commanded. Taken for angles seen from the
    // instrument, which stands e = 0.0144 mm off, they are wrong by e/R = 1e-4, and so are the values by 1e-4
    // of what the others make: some 1e-2 mm.
    const Test test = testdata::ballbarPair();
    auto measurement = std::get<CircularMeasurement>(test.measurement);
    measurement.feed = 1000;
    const MadeCircle polar(measurement);
    for (Arc &arc : measurement.arcs)
        arc.angleReference = AngleReference::commanded;
    const MadeCircle pair(std::move(measurement));
    const Diagnosis asPolar = diagnose(polar.circle());
    const Diagnosis d = diagnose(pair.circle());
    QCOMPARE(d.rank, 12);
    QCOMPARE(d.of, 12); // nothing was looked for and found that is not there
    const DiagnosedCircle circle = pair.circle();
    const std::size_t points = circle.arcs[0].points.size() + circle.arcs[1].points.size();
    QVERIFY(d.points <= points && double(d.points) > 0.97 * double(points)); // but for the reversals
    QCOMPARE(asPolar.of, 12);
    // ballbar_pair_truth.txt; 2e-3 µm, 0.01 µrad (µm/m), 1e-4 ms
    const struct {
        InfluenceId id;
        PlaneAxis axis;
        double truth;
        double tolerance;
    } rows[]{
        {InfluenceId::radius, none, 1.125, 2e-3},  {InfluenceId::scaleMismatch, none, 65, 0.01},
        {InfluenceId::squareness, none, 30, 0.01}, {InfluenceId::servoMismatch, none, 0.6, 1e-4},
        {InfluenceId::backlash, x, 6, 2e-3},       {InfluenceId::backlash, y, -4, 2e-3},
        {InfluenceId::lateralPlay, x, 3, 2e-3},    {InfluenceId::lateralPlay, y, 1.5, 2e-3},
        {InfluenceId::straightness, x, 8, 2e-3},   {InfluenceId::straightness, y, -5, 2e-3},
    };
    for (const auto &row : rows) {
        const double shown = shownParameter(row.id, valueOf(d, row.id, row.axis));
        QVERIFY2(std::abs(shown - row.truth) <= row.tolerance,
                 qPrintable(QStringLiteral("%1: %2").arg(influence(row.id).word).arg(shown, 0, 'g', 9)));
        const double seen = shownParameter(row.id, valueOf(asPolar, row.id, row.axis));
        QVERIFY2(std::abs(seen - row.truth) <= std::max(row.tolerance, 5e-3), influence(row.id).word);
    }
    // Both parts of the first harmonic: of the instrument, and of the bows. Commanded angles do not hide it.
    for (const Diagnosis *one : {&asPolar, &d}) {
        QVERIFY(std::abs(valueOf(*one, InfluenceId::centre, x) + 13.25e-3) <= 2e-6);
        QVERIFY(std::abs(valueOf(*one, InfluenceId::centre, y) - 10e-3) <= 2e-6);
    }
    // Contributions alone, as the file states them, to the four digits it gives.
    const struct {
        InfluenceId id;
        PlaneAxis axis;
        double micrometres;
    } parts[]{{InfluenceId::scaleMismatch, none, 9.7499},
              {InfluenceId::squareness, none, 4.5},
              {InfluenceId::servoMismatch, none, 9.9999},
              {InfluenceId::backlash, x, 6.0},
              {InfluenceId::backlash, y, 4.0},
              {InfluenceId::lateralPlay, x, 3.0},
              {InfluenceId::lateralPlay, y, 1.5},
              {InfluenceId::straightness, x, 4.0},
              {InfluenceId::straightness, y, 2.5}};
    for (const auto &part : parts) {
        // The readings miss the axes by up to 0.1°: a step is 1 − cos 0.1° less, 1e-5 mm.
        const double found = 1e3 * *d.find(part.id, part.axis)->contribution;
        QVERIFY2(std::abs(found - part.micrometres) <= 0.012, qPrintable(QString::number(found)));
    }
    QCOMPARE(d.sources.front().id, InfluenceId::servoMismatch); // the largest first
    QVERIFY(d.residual < 2e-6);
}

void DiagnosisTest::rankAndCondition_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<bool>("both");
    QTest::addColumn<int>("rank");
    QTest::addColumn<double>("condition");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<QStringList>("apart");
    const QStringList nothing;
    // circular.md: 12, 5.8. The rest from singular values computed apart, with all readings; what the
    // reversals take away moves them a little.
    QTest::newRow("full circle, both senses") << 0. << 360. << true << 12 << 5.79 << 0.02 << nothing;
    QTest::newRow("full circle, one sense") << 0. << 360. << false << 11 << 39.2 << 0.02
                                            << QStringList{"radius",        "scaleMismatch", "squareness",
                                                           "servoMismatch", "lateralPlay:X", "lateralPlay:Y"};
    QTest::newRow("half a circle") << 0. << 180. << true << 12 << 121.6 << 0.02
                                   << QStringList{"centre:Y", "radius", "scaleMismatch"};
    QTest::newRow("0° to 90°") << 0. << 90. << true << 10 << 1.27e4 << 0.1
                               << QStringList{"centre:X",       "centre:Y",      "radius",
                                              "scaleMismatch",  "squareness",    "backlash:X",
                                              "backlash:Y",     "lateralPlay:X", "lateralPlay:Y",
                                              "straightness:X", "straightness:Y"};
    QTest::newRow("45° to 135°") << 45. << 135. << true << 12 << 1.35e4 << 0.06
                                 << QStringList{"centre:X",      "centre:Y",       "radius",
                                                "scaleMismatch", "squareness",     "servoMismatch",
                                                "backlash:X",    "straightness:X", "straightness:Y"};
}

void DiagnosisTest::rankAndCondition() {
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(bool, both);
    QFETCH(int, rank);
    QFETCH(double, condition);
    QFETCH(double, tolerance);
    QFETCH(QStringList, apart);
    CircularSynthesis asked = machine();
    asked.points = 1800;
    asked.sources.erase(asked.sources.begin(), asked.sources.begin() + 2);
    asked.arc = {from, to};
    asked.noise.deviation = 1e-4;
    if (!both)
        asked.senses.pop_back();
    const Diagnosis d = diagnosed(asked, withoutSearch);
    QCOMPARE(d.rank, rank);
    QVERIFY2(std::abs(d.condition / condition - 1) <= tolerance, qPrintable(QString::number(d.condition)));
    QStringList found;
    for (const SourceEstimate &source : d.sources) {
        if (!source.separable)
            found += QString::fromStdString(sourceId(source));
        QCOMPARE(source.value.has_value(), source.separable);
        QCOMPARE(source.contribution.has_value(), source.separable);
    }
    found.sort();
    apart.sort();
    QCOMPARE(found, apart);
}

void DiagnosisTest::inseparableSourcesGiveTheirSum() {
    // One sense alone: F·Δτ·s and −β·R have the same column, sin 2θ/2.
    CircularSynthesis asked = machine();
    asked.senses = {Sense::clockwise};
    const Diagnosis d = diagnosed(asked, withoutSearch);
    const SourceEstimate *squareness = d.find(InfluenceId::squareness);
    QCOMPARE(squareness->with.size(), std::size_t(1));
    QCOMPARE(d.sources[squareness->with.front()].id, InfluenceId::servoMismatch);
    const auto sum = std::ranges::find_if(d.sums, [&](const SourceSum &s) {
        return &d.sources[s.of.front().source] == squareness ||
               d.sources[s.of.front().source].id == InfluenceId::servoMismatch;
    });
    QVERIFY(sum != d.sums.end());
    QCOMPARE(sum->of.size(), std::size_t(2));
    double truth = 0;
    for (const SourceSum::Part &part : sum->of) {
        const bool isSquareness = d.sources[part.source].id == InfluenceId::squareness;
        truth += part.factor * (isSquareness ? 30.0 : 0.6); // µrad, ms
    }
    QVERIFY2(std::abs(sum->value - truth) <= 0.01, qPrintable(QString::number(sum->value)));
    QVERIFY(std::abs(sum->of.front().factor - 1) < 1e-12);
    // A quarter: lost motion of one axis and lateral play of the other have one column.
    asked.senses = {Sense::counterclockwise, Sense::clockwise};
    asked.arc = {0, 90};
    const Diagnosis quarter = diagnosed(asked, withoutSearch);
    for (const SourceSum &one : quarter.sums) {
        if (one.of.size() != 2 || quarter.sources[one.of[0].source].id != InfluenceId::backlash)
            continue;
        QCOMPARE(quarter.sources[one.of[1].source].id, InfluenceId::lateralPlay);
        const bool ofX = quarter.sources[one.of[0].source].axis == x;
        const double both = ofX ? 6 + 1.5 : -4 + 3; // µm
        QVERIFY(std::abs(one.of[1].factor - 1) < 1e-9);
        QVERIFY2(std::abs(one.value - both) < 0.01, qPrintable(QString::number(one.value)));
    }
    QVERIFY(std::ranges::count_if(quarter.sums, [](const SourceSum &s) { return s.of.size() == 2; }) == 2);
}

void DiagnosisTest::aSumHoldsTheWholeCentre_data() {
    QTest::addColumn<int>("to");
    QTest::newRow("a quarter") << 90;
    QTest::newRow("half a circle") << 180;
    QTest::newRow("more") << 200;
}

/// Also the part that is taken out of the points before the fit.
void DiagnosisTest::aSumHoldsTheWholeCentre() {
    QFETCH(int, to);
    CircularSynthesis asked = machine();
    asked.arc = {0, double(to)};
    const Diagnosis d = diagnosed(asked, withoutSearch);
    int withCentre = 0;
    for (const SourceSum &sum : d.sums) {
        double truth = 0;
        double parts = 0;
        for (const SourceSum::Part &part : sum.of) {
            const SourceEstimate &source = d.sources[part.source];
            withCentre += source.id == InfluenceId::centre ? 1 : 0;
            for (const auto &made : asked.sources) {
                if (made.id != source.id || made.axis != source.axis)
                    continue;
                const double one = part.factor * made.value * unitOf(made.id);
                truth += one;
                parts += std::abs(one);
            }
        }
        QVERIFY2(std::abs(sum.value - truth) <= 1e-3 * parts,
                 qPrintable(QString("%1 %2").arg(sum.value).arg(truth)));
    }
    QVERIFY(withCentre > 0);
}

/// A lag is fitted as its square, a servo mismatch without feed as the difference of following errors.
void DiagnosisTest::aSumStatesWhatItAdds() {
    const auto truthOf = [](const Diagnosis &d, const SourceSum &sum, InfluenceId id, double value) {
        double truth = 0;
        for (const SourceSum::Part &part : sum.of) {
            const SourceEstimate &source = d.sources[part.source];
            truth += part.factor * (source.id == id                        ? value
                                    : source.id == InfluenceId::squareness ? 30
                                                                           : 2); // µrad; µm of the radius
        }
        return truth;
    };
    const auto sumWith = [](const Diagnosis &d, InfluenceId id) {
        return *std::ranges::find_if(d.sums, [&](const SourceSum &sum) {
            return std::ranges::any_of(sum.of, [&](const auto &p) { return d.sources[p.source].id == id; });
        });
    };
    const auto partOf = [](const Diagnosis &d, const SourceSum &sum, InfluenceId id) {
        return *std::ranges::find_if(sum.of, [&](const auto &p) { return d.sources[p.source].id == id; });
    };
    CircularSynthesis asked = machine();
    asked.senses = {Sense::clockwise};
    CircularMeasurement measurement = synthesizeCircular(asked);
    measurement.feed.reset();
    const MadeCircle without(std::move(measurement));
    const Diagnosis d = diagnose(without.circle(), withoutSearch);
    const SourceSum sum = sumWith(d, InfluenceId::servoMismatch);
    const SourceSum::Part part = partOf(d, sum, InfluenceId::servoMismatch);
    QCOMPARE(part.unit, "µm");
    QCOMPARE(summandName(d, part).text.source, "Difference of following errors %1, in µm");
    const double following = 0.6 * asked.feed / 60; // ms · mm/s
    QVERIFY(std::abs(sum.value - truthOf(d, sum, InfluenceId::servoMismatch, following)) <= 0.01);

    const auto made = [](double feed) {
        CircularSynthesis lagging = machine();
        lagging.feed = feed;
        lagging.sources.push_back({InfluenceId::commonLag, none, 1e-4}); // s²
        return MadeCircle(synthesizeCircular(lagging));
    };
    const MadeCircle slow = made(6000);
    const MadeCircle fast = made(6100);
    const Diagnosis feeds = diagnose(std::vector{slow.circle(), fast.circle()}, withoutSearch);
    const SourceSum lag = sumWith(feeds, InfluenceId::commonLag);
    const SourceSum::Part square = partOf(feeds, lag, InfluenceId::commonLag);
    QCOMPARE(square.unit, "ms²");
    QCOMPARE(summandName(feeds, square).text.source, "(Common lag %1)²");
    const double truth = truthOf(feeds, lag, InfluenceId::commonLag, 100); // ms²
    QVERIFY2(std::abs(lag.value - truth) <= 0.01 * std::abs(truth), qPrintable(QString::number(lag.value)));
}

void DiagnosisTest::eachSourceIsRecognised_data() {
    QTest::addColumn<InfluenceId>("id");
    QTest::addColumn<PlaneAxis>("axis");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("shape");
    const auto row = [](const char *name, InfluenceId id, PlaneAxis axis, double value, double shape = 0) {
        QTest::newRow(name) << id << axis << value << shape;
    };
    row("B.2.1 scales", InfluenceId::scaleMismatch, none, -40e-6);
    row("B.2.2 squareness", InfluenceId::squareness, none, 35e-6);
    row("B.2.3 X with its pitch", InfluenceId::cyclic, x, 2e-3, 10);
    row("B.2.3 Y with its pitch", InfluenceId::cyclic, y, 1e-3, 4);
    row("B.2.3 X with a pitch of inches", InfluenceId::cyclic, x, 2e-3, 5.08);
    row("B.2.3 Y with a pitch of inches", InfluenceId::cyclic, y, 2e-3, 6.35);
    row("B.3.2 backlash X", InfluenceId::backlash, x, 5e-3);
    row("B.3.2 backlash Y, overcompensated", InfluenceId::backlash, y, -5e-3);
    row("B.3.2 spikes of X", InfluenceId::reversalSpike, x, 6e-3, 1.3);
    row("B.3.2 spikes of Y, inwards", InfluenceId::reversalSpike, y, -4e-3, 3);
    row("B.3.4 servo", InfluenceId::servoMismatch, none, -4e-4);
    row("lateral play X", InfluenceId::lateralPlay, x, 4e-3);
    row("lateral play Y", InfluenceId::lateralPlay, y, -4e-3);
    row("straightness X", InfluenceId::straightness, x, 8e-3);
    row("straightness Y", InfluenceId::straightness, y, -8e-3);
    row("drift of the radius", InfluenceId::radiusDrift, none, 4e-3);
}

void DiagnosisTest::eachSourceIsRecognised() {
    QFETCH(InfluenceId, id);
    QFETCH(PlaneAxis, axis);
    QFETCH(double, value);
    QFETCH(double, shape);
    for (const double correlation : {0.0, 0.8}) {
        CircularSynthesis asked;
        asked.sources = {{id, axis, value, shape}};
        asked.noise.deviation = 1e-4;
        asked.noise.correlation = correlation;
        asked.noise.resolution = 1e-4;
        const Diagnosis d = diagnosed(asked);
        const SourceEstimate &first = d.sources.front();
        QVERIFY2(first.id == id && first.axis == axis, influence(first.id).word);
        QVERIFY(first.value && first.u && *first.u > 0);
        // Five standard uncertainties; those of a spike and of a width that was found go together.
        const double off = std::abs(*first.value - value);
        QVERIFY2(off <= 5 * *first.u, qPrintable(QStringLiteral("%1 ± %2").arg(*first.value).arg(*first.u)));
        QVERIFY(*first.u < 0.1 * std::abs(value));
        if (first.width)
            QVERIFY2(std::abs(*first.width / shape - 1) < 0.1, qPrintable(QString::number(*first.width)));
        if (first.pitch)
            QCOMPARE(*first.pitch, shape);
        const bool lookedFor =
            id == InfluenceId::cyclic || id == InfluenceId::reversalSpike || id == InfluenceId::radiusDrift;
        QCOMPARE(first.proposed, lookedFor);
        QCOMPARE(d.of, lookedFor ? 14 : 12);
        if (lookedFor)
            QVERIFY(*first.significance < 1e-3);
    }
}

/// Screws and racks, those of inches among them, on circles of usual size.
void DiagnosisTest::everyUsualPitchIsFound() {
    for (const double pitch : {1.0,  2.0,  2.5,  3.0,  4.0,  5.0,  5.08, 6.0,  6.35, 8.0,  10.0,
                               12.0, 12.7, 15.0, 16.0, 20.0, 25.0, 25.4, 30.0, 32.0, 40.0, 50.0}) {
        for (const PlaneAxis axis : {x, y}) {
            CircularSynthesis asked;
            asked.radius = axis == x ? 100 : 150;
            asked.points = 7200; // seven a period of the finest, where an axis moves fastest
            asked.sources = {{InfluenceId::cyclic, axis, 2e-3, pitch}};
            asked.noise.deviation = 1e-4;
            const Diagnosis d = diagnosed(asked);
            const SourceEstimate &first = d.sources.front();
            QVERIFY2(first.id == InfluenceId::cyclic && first.axis == axis && first.pitch == pitch,
                     qPrintable(QStringLiteral("%1 on %2").arg(pitch).arg(asked.radius)));
            QVERIFY2(std::abs(*first.value - 2e-3) <= 5 * *first.u,
                     qPrintable(QString::number(*first.value)));
        }
    }
}

/// A guideway that is bent like a cubic and a quartic is neither a pitch nor a spike.
void DiagnosisTest::theShapeOfAGuidewayIsNoPitch() {
    for (const double bent : {1e-3, 5e-3}) {
        for (const double correlation : {0.0, 0.8}) {
            CircularSynthesis asked;
            asked.noise.deviation = 2e-4;
            asked.noise.correlation = correlation;
            CircularMeasurement measured = synthesizeCircular(asked);
            for (Arc &arc : measured.arcs) {
                for (std::size_t i = 0; i < arc.angles.size(); ++i) {
                    const Point u = direction(arc.angles[i]);
                    arc.radialDeviations[i] += bent * (std::pow(u.x, 3) + std::pow(u.x, 4) / 2) * u.y;
                }
            }
            const MadeCircle made(measured);
            const Diagnosis d = diagnose(made.circle(), {});
            for (const SourceEstimate &source : d.sources)
                QVERIFY2(!source.proposed, influence(source.id).word);
        }
    }
}

void DiagnosisTest::statedPitchAndWidth() {
    CircularSynthesis asked = machine();
    asked.points = 1800;
    asked.noise.deviation = 5e-5;
    asked.sources.push_back({InfluenceId::cyclic, y, 0.8e-3, 7.3, 0.6}); // no plausible pitch
    asked.sources.push_back({InfluenceId::reversalSpike, x, 2e-3, 1.5});
    DiagnosisOptions options;
    options.pitch[1] = 7.3;
    options.spikeWidth = 1.5;
    options.search = false;
    const Diagnosis d = diagnosed(asked, options);
    QCOMPARE(d.of, 16); // two columns of the pitch, a spike each axis
    const SourceEstimate *cyclic = d.find(InfluenceId::cyclic, y);
    QVERIFY(cyclic && cyclic->value && !cyclic->proposed);
    QVERIFY(std::abs(*cyclic->value - 0.8e-3) < 5 * *cyclic->u);
    QVERIFY(std::abs(*cyclic->phase - 0.6) < 0.05);
    QVERIFY(std::abs(valueOf(d, InfluenceId::reversalSpike, x) - 2e-3) < 1e-4);
    QVERIFY(std::abs(valueOf(d, InfluenceId::reversalSpike, y)) < 1e-4);
    QVERIFY(std::abs(valueOf(d, InfluenceId::backlash, x) - 6e-3) < 1e-4);
}

void DiagnosisTest::severalFeeds() {
    const double q = 0.015 * 0.015; // s²
    const auto made = [&](double feed) {
        CircularSynthesis asked = machine();
        asked.feed = feed;
        asked.sources.push_back({InfluenceId::commonLag, none, q});
        asked.sources.push_back({InfluenceId::lagMismatch, none, 2e-5});
        asked.noise.deviation = 2e-5;
        return MadeCircle(synthesizeCircular(asked));
    };
    const MadeCircle slow = made(500);
    const MadeCircle middle = made(2000);
    const MadeCircle fast = made(6000);
    const std::vector circles{slow.circle(), middle.circle(), fast.circle()};
    QVERIFY(areSeveralFeeds(circles));
    const Diagnosis d = diagnose(circles, withoutSearch);
    QCOMPARE(d.rank, 18); // three centres, ten of the machine, two of the lag
    const SourceEstimate *lag = d.find(InfluenceId::commonLag);
    QVERIFY(lag->value && std::abs(*lag->value - q) < 5 * *lag->u && *lag->u < 0.05 * q);
    QVERIFY(std::abs(valueOf(d, InfluenceId::lagMismatch) - 2e-5) < 5 * *d.find(InfluenceId::lagMismatch)->u);
    QVERIFY(std::abs(valueOf(d, InfluenceId::radius) - 2e-3) < 2e-5);
    QVERIFY(std::abs(valueOf(d, InfluenceId::servoMismatch) - 6e-4) < 1e-5);
    QVERIFY(std::abs(valueOf(d, InfluenceId::squareness) - 30e-6) < 2e-7);
    // One feed alone takes the lag for a smaller radius.
    const Diagnosis alone = diagnose(fast.circle(), withoutSearch);
    QVERIFY(!alone.find(InfluenceId::commonLag));
    QVERIFY(valueOf(alone, InfluenceId::radius) < -5e-3);
    // Two rows a column are asked for: seven points a circle and sense are six that count.
    const auto few = [](double feed, std::size_t points) {
        CircularSynthesis asked;
        asked.feed = feed;
        asked.points = points;
        return MadeCircle(synthesizeCircular(asked));
    };
    const MadeCircle first = few(500, 7);
    const MadeCircle second = few(2000, 7);
    const MadeCircle enough = few(6000, 7);
    const MadeCircle fewer = few(6000, 5);
    QVERIFY(diagnose(std::vector{first.circle(), second.circle(), enough.circle()}, withoutSearch).valid());
    QVERIFY(!diagnose(std::vector{first.circle(), second.circle(), fewer.circle()}, withoutSearch).valid());
    // What does not belong together is not taken together.
    CircularSynthesis other = machine();
    other.radius = 100;
    other.feed = 3000;
    const MadeCircle small(synthesizeCircular(other));
    QVERIFY(!areSeveralFeeds(std::vector{slow.circle(), small.circle()}));
    QVERIFY(!areSeveralFeeds(std::vector{slow.circle(), slow.circle()}));
    QVERIFY(!diagnose(std::vector{slow.circle(), small.circle()}).valid());
}

void DiagnosisTest::noiseAloneIsNoSource() {
    for (const double correlation : {0.0, 0.6, 0.95}) {
        for (long long seed = 1; seed <= 8; ++seed) {
            CircularSynthesis asked;
            asked.points = 720;
            asked.noise = {3e-4, correlation, 0, seed};
            const Diagnosis d = diagnosed(asked);
            QCOMPARE(d.of, 12); // of 24 looks one in 42 would find something by chance
            for (const SourceEstimate &source : d.sources)
                QVERIFY2(std::abs(*source.value) < 6 * *source.u, influence(source.id).word);
        }
    }
}

void DiagnosisTest::startOfThePathDoesNotCount() {
    CircularSynthesis asked = machine();
    asked.noise.deviation = 1e-4;
    const MadeCircle made(synthesizeCircular(asked));
    CircularMeasurement turned = made.measurement;
    for (Arc &arc : turned.arcs) {
        // The same points, begun a third of a turn later.
        const auto by = static_cast<std::ptrdiff_t>(arc.angles.size() / 3);
        std::rotate(arc.angles.begin(), arc.angles.begin() + by, arc.angles.end());
        std::rotate(arc.radialDeviations.begin(), arc.radialDeviations.begin() + by,
                    arc.radialDeviations.end());
        const double turn = arc.sense == Sense::counterclockwise ? 360 : -360;
        for (auto i = arc.angles.end() - by; i != arc.angles.end(); ++i)
            *i += turn;
    }
    const MadeCircle other(turned);
    const Diagnosis a = diagnose(made.circle(), withoutSearch);
    const Diagnosis b = diagnose(other.circle(), withoutSearch);
    for (const SourceEstimate &source : a.sources) {
        const double difference = valueOf(b, source.id, source.axis) - *source.value;
        QVERIFY(std::abs(difference) * unitOf(source.id) < 1e-6);
    }
}

void DiagnosisTest::exchangeOfAxes() {
    const CircularSynthesis asked = machine();
    const MadeCircle made(synthesizeCircular(asked));
    CircularMeasurement mirrored = made.measurement;
    mirrored.plane = {"Y", "X"};
    for (Arc &arc : mirrored.arcs) {
        arc.sense = arc.sense == Sense::clockwise ? Sense::counterclockwise : Sense::clockwise;
        for (double &angle : arc.angles)
            angle = 90 - angle;
    }
    const MadeCircle other(mirrored);
    const Diagnosis a = diagnose(made.circle(), withoutSearch);
    const Diagnosis b = diagnose(other.circle(), withoutSearch);
    for (const SourceEstimate &source : a.sources) {
        // Differences of the axes change their sign, what belongs to an axis goes with it.
        const bool turns = source.id == InfluenceId::scaleMismatch || source.id == InfluenceId::servoMismatch;
        const PlaneAxis axis = source.axis == x ? y : source.axis == y ? x : none;
        const double expected = turns ? -*source.value : *source.value;
        const double found = valueOf(b, source.id, axis);
        QVERIFY2(std::abs(found - expected) * unitOf(source.id) < 1e-6, influence(source.id).word);
        QVERIFY(std::abs(*b.find(source.id, axis)->contribution - *source.contribution) < 1e-9);
    }
}

void DiagnosisTest::effectsAddUp() {
    const CircularSynthesis all = machine();
    const Diagnosis whole = diagnosed(all, withoutSearch);
    for (const SourceEstimate &source : whole.sources) {
        double sum = 0;
        for (const CircularSource &one : all.sources) {
            if (one.id == InfluenceId::centre)
                continue; // it turns the points: not linear
            CircularSynthesis alone = all;
            alone.sources = {one};
            sum += valueOf(diagnosed(alone, withoutSearch), source.id, source.axis);
        }
        for (const CircularSource &one : all.sources) {
            if (one.id == InfluenceId::centre && source.id == one.id && source.axis == one.axis)
                sum += one.value;
        }
        // Centre and deviations of 0.01 mm on 150 mm: a second order of 1e-6 mm.
        QVERIFY2(std::abs(*source.value - sum) * unitOf(source.id) < 2e-2, influence(source.id).word);
    }
}

void DiagnosisTest::lagOfCommandedAngles_data() {
    QTest::addColumn<double>("lag");
    QTest::addColumn<bool>("steps");
    for (const double lag : {0.0, 0.3, 0.76, 2.5})
        QTest::addRow("steps, %g°", lag) << lag << true;
    QTest::newRow("nothing to see it by") << 0.76 << false;
}

void DiagnosisTest::lagOfCommandedAngles() {
    QFETCH(double, lag);
    QFETCH(bool, steps);
    CircularSynthesis asked = machine();
    asked.points = 1800;
    asked.noise.deviation = 1e-4;
    std::erase_if(asked.sources, [&](const CircularSource &s) {
        const bool step = s.id == InfluenceId::backlash || s.id == InfluenceId::lateralPlay;
        return s.id == InfluenceId::centre || (!steps && step);
    });
    CircularMeasurement measurement = synthesizeCircular(asked);
    for (Arc &arc : measurement.arcs) {
        // What was reached at θ had been commanded a lag further on.
        arc.angleReference = AngleReference::commanded;
        for (double &angle : arc.angles)
            angle += arc.sense == Sense::counterclockwise ? lag : -lag;
    }
    MadeCircle made(measurement);
    const auto paths = iso230_4::paths(made.measurement);
    const Diagnosis d = diagnose(made.circle(), withoutSearch);
    if (!steps) {
        QCOMPARE(d.lagAngle, 0.0);
        return;
    }
    // Readings are 0.2° apart: nothing tells the step more closely.
    QVERIFY2(std::abs(d.lagAngle - lag) <= 0.15, qPrintable(QString::number(d.lagAngle)));
    QVERIFY(std::abs(valueOf(d, InfluenceId::backlash, x) - 6e-3) < 2e-4);
    QVERIFY(std::abs(valueOf(d, InfluenceId::lateralPlay, y) - 1.5e-3) < 2e-4);
    QVERIFY(std::abs(valueOf(d, InfluenceId::squareness) - 30e-6) < 2e-6);
}

void DiagnosisTest::turnedAngles_data() {
    QTest::addColumn<double>("by");
    QTest::addColumn<bool>("commanded");
    QTest::addColumn<bool>("steps");
    QTest::newRow("polar") << 0.3 << false << true;
    QTest::newRow("commanded") << -0.3 << true << true;
    QTest::newRow("far") << 1.5 << true << true;
    QTest::newRow("not at all") << 0.0 << false << true;
    QTest::newRow("below 0.05°") << 0.04 << true << true;
    QTest::newRow("nothing to see it by") << 0.3 << true << false;
}

void DiagnosisTest::turnedAngles() {
    QFETCH(double, by);
    QFETCH(bool, commanded);
    QFETCH(bool, steps);
    CircularSynthesis asked = machine();
    asked.points = 1800;
    asked.noise.deviation = 1e-4;
    std::erase_if(asked.sources, [&](const CircularSource &s) {
        const bool step = s.id == InfluenceId::backlash || s.id == InfluenceId::lateralPlay;
        return s.id == InfluenceId::centre || (!steps && step);
    });
    CircularMeasurement measurement = synthesizeCircular(asked);
    for (Arc &arc : measurement.arcs) {
        arc.angleReference = commanded ? AngleReference::commanded : AngleReference::polar;
        for (double &angle : arc.angles)
            angle += by;
    }
    const MadeCircle made(measurement);
    const Diagnosis d = diagnose(made.circle());
    const bool stated = steps && std::abs(by) > 0.05;
    QCOMPARE(d.rotation.angle.has_value(), steps);
    QCOMPARE(d.rotation.isStated(), stated);
    const auto statement = rotationStatement(d.rotation);
    QCOMPARE(statement.has_value(), stated);
    if (!steps)
        return;
    QVERIFY(d.rotation.bound < 0.25 && d.rotation.u > 0); // readings are 0.2° apart
    QVERIFY2(std::abs(*d.rotation.angle - by) <= d.rotation.bound,
             qPrintable(QString::number(*d.rotation.angle)));
    QCOMPARE(d.rotation.removed(), stated ? *d.rotation.angle : 0.0);
    if (stated)
        QCOMPARE(QByteArray(statement->text.source).contains("start angle"), commanded);
    QCOMPARE(d.of, 12); // no spike is made of it
    for (const CircularSource &source : asked.sources) {
        const auto interval = d.find(source.id, source.axis)->interval();
        const double slack = 0.03 / unitOf(source.id); // a twentieth of those that miss
        QVERIFY2(interval && interval->from - slack <= source.value && source.value <= interval->to + slack,
                 influence(source.id).word);
    }
}

/// Readings in steps of 0.5 µm without noise to blur them: no height is known better than four of them tell.
void DiagnosisTest::resolutionBoundsTheUncertainty() {
    CircularSynthesis asked = machine();
    asked.noise = {2e-5, 0, 0, 1};
    const MadeCircle fine(synthesizeCircular(asked));
    asked.noise.resolution = 5e-4;
    const MadeCircle made(synthesizeCircular(asked));
    QCOMPARE(fine.circle().resolution, 0.0);
    QVERIFY(std::abs(made.circle().resolution - 5e-4) < 1e-12);
    const double least = 5e-4 / std::sqrt(48.0);
    QVERIFY(*diagnose(fine.circle()).find(InfluenceId::backlash, x)->u < least / 5);
    const Diagnosis d = diagnose(made.circle());
    for (const PlaneAxis axis : {x, y})
        QVERIFY(*d.find(InfluenceId::backlash, axis)->u > 0.99 * least);
}

void DiagnosisTest::changeOfRadiusBetweenTheArcs() {
    // circular.md: r_ccw − r_cw = δ looks like L_x = −0.78 δ, L_y = +0.78 δ.
    CircularSynthesis asked;
    asked.noise.deviation = 1e-5;
    CircularMeasurement measurement = synthesizeCircular(asked);
    constexpr double delta = 5e-3;
    for (double &r : measurement.arcs.front().radialDeviations)
        r += delta;
    const MadeCircle made(measurement);
    const Diagnosis d = diagnose(made.circle(), withoutSearch);
    QVERIFY(std::abs(valueOf(d, InfluenceId::lateralPlay, x) / delta + 0.78) < 0.01);
    QVERIFY(std::abs(valueOf(d, InfluenceId::lateralPlay, y) / delta - 0.78) < 0.01);
    QVERIFY(!d.remarks.empty());
    // With a step of its own nothing is left for the play, which is 4.5 times less certain then.
    DiagnosisOptions options = withoutSearch;
    options.drift = true;
    const Diagnosis stepped = diagnose(made.circle(), options);
    QVERIFY(std::abs(valueOf(stepped, InfluenceId::lateralPlay, x)) < 1e-4);
    QVERIFY(std::abs(*stepped.find(InfluenceId::radiusDrift)->step - delta) < 1e-4);
    const MadeCircle plain(synthesizeCircular(asked));
    const double price = *diagnose(plain.circle(), options).find(InfluenceId::lateralPlay, x)->u /
                         *diagnose(plain.circle(), withoutSearch).find(InfluenceId::lateralPlay, x)->u;
    QVERIFY2(std::abs(price / 4.5 - 1) < 0.05, qPrintable(QString::number(price)));
    // With the pause known the drift alone is fitted.
    options.pause = 0.5;
    QVERIFY(!diagnose(made.circle(), options).find(InfluenceId::radiusDrift)->step);
}

void DiagnosisTest::intervalsCoverTheTruth_data() {
    QTest::addColumn<double>("correlation");
    QTest::newRow("white noise") << 0.0;
    QTest::newRow("coloured noise") << 0.9;
}

void DiagnosisTest::intervalsCoverTheTruth() {
    QFETCH(double, correlation);
    constexpr int trials = 150;
    int hits = 0;
    int all = 0;
    for (const auto &row :
         testdata::coverage(testdata::coverageCircle(360, correlation), withoutSearch, trials)) {
        // One or two in a hundred are called not valid or an indication: 2.3 ± 1.5; five of these.
        QVERIFY2(row.trials >= 140, qPrintable(QString::number(row.trials)));
        // 95 % of 150: 142.5 ± 2.7; five of these.
        QVERIFY2(row.hits >= row.trials * 0.86, influence(row.id).word);
        hits += row.hits;
        all += row.trials;
    }
    // The seeds are fixed. 95 % ± 0.5 %, somewhat more where sources share the noise. Noise that looks slower
    // than it is has the widest intervals, and none where it looks too slow.
    const double part = double(hits) / all;
    QVERIFY2(part > 0.92 && part < 0.975, qPrintable(QString::number(part)));
}

void DiagnosisTest::manyPointsAreAveraged() {
    CircularSynthesis asked = machine();
    asked.points = 50'000; // more than rows
    asked.noise.deviation = 1e-4;
    const Diagnosis d = diagnosed(asked);
    QCOMPARE(d.of, 12);
    for (const CircularSource &source : asked.sources) {
        if (source.id == InfluenceId::centre)
            continue;
        const SourceEstimate *found = d.find(source.id, source.axis);
        // A second order of the centre beside the noise.
        QVERIFY2(std::abs(*found->value - source.value) < 5 * *found->u + 2e-2 / unitOf(source.id),
                 influence(source.id).word);
    }
}

void DiagnosisTest::tracesAddUpToTheMeasured() {
    CircularSynthesis asked = machine();
    asked.noise.deviation = 1e-4;
    const MadeCircle made(synthesizeCircular(asked));
    const DiagnosedCircle circle = made.circle();
    const Diagnosis d = diagnose(circle, withoutSearch);
    const auto rest = unexplained(circle, d);
    double squares = 0;
    std::size_t points = 0;
    for (std::size_t a = 0; a < 2; ++a) {
        QCOMPARE(rest[a].size(), circle.arcs[a].points.size());
        for (std::size_t i = 0; i < rest[a].size(); ++i) {
            squares += rest[a][i] * rest[a][i];
            ++points;
        }
    }
    // The residual of the fit, but for the readings at the reversals.
    QVERIFY(std::abs(std::sqrt(squares / double(points)) / d.residual - 1) < 0.02);
    // A source moves the path by its column. The centre is so near that radial means radial about the origin.
    std::size_t squareness = 0;
    while (d.sources[squareness].id != InfluenceId::squareness)
        ++squareness;
    const Points with = syntheticPath(circle, d, std::array{squareness})[0];
    const Points without = syntheticPath(circle, d, {})[0];
    std::vector<double> column;
    for (std::size_t i = 0; i < with.size(); ++i)
        column.push_back(std::hypot(with.x[i], with.y[i]) - std::hypot(without.x[i], without.y[i]));
    const auto [low, high] = std::ranges::minmax(column);
    QVERIFY(std::abs((high - low) - *d.sources[squareness].contribution) < 1e-6);
}

void DiagnosisTest::spectrumShowsAVibration() {
    CircularSynthesis asked = machine();
    CircularMeasurement measurement = synthesizeCircular(asked);
    constexpr double perTurn = 60;
    constexpr double amplitude = 2e-3;
    for (double &angle : measurement.arcs[1].angles) {
        const auto i = static_cast<std::size_t>(&angle - measurement.arcs[1].angles.data());
        measurement.arcs[1].radialDeviations[i] +=
            amplitude * std::cos(perTurn * angle * std::numbers::pi / 180);
    }
    const MadeCircle made(measurement);
    const DiagnosedCircle circle = made.circle();
    const Diagnosis d = diagnose(circle, withoutSearch);
    const auto lines = spectrum(circle, 1, unexplained(circle, d)[1]);
    const auto highest = std::ranges::max_element(lines, {}, &SpectralLine::amplitude);
    QVERIFY(std::abs(highest->perTurn - perTurn) < 0.1);
    QVERIFY(std::abs(highest->amplitude / amplitude - 1) < 0.02);
    // n·F/(2πR)
    QVERIFY(std::abs(*highest->frequency - perTurn * 1000 / 60 / (2 * std::numbers::pi * 150)) < 1e-2);
    QVERIFY(spectrum(circle, 5, {}).empty());
}

void DiagnosisTest::withoutFeed() {
    CircularMeasurement measurement = synthesizeCircular(machine());
    measurement.feed.reset();
    const MadeCircle made(measurement);
    const Diagnosis d = diagnose(made.circle(), withoutSearch);
    const SourceEstimate *servo = d.find(InfluenceId::servoMismatch);
    QVERIFY(servo->separable && !servo->value && !servo->u);
    // F·Δτ of 16.7 mm/s and 0.6 ms
    QVERIFY(std::abs(*servo->contribution - 1e-2) < 2e-5);
    QVERIFY(std::abs(valueOf(d, InfluenceId::squareness) - 30e-6) < 1e-8);
    QCOMPARE(d.remarks.size(), std::size_t(1));
}

void DiagnosisTest::badInput_data() {
    QTest::addColumn<QString>("damage");
    for (const char *damage : {"no arcs", "no points", "few points", "no radius", "not finite", "no feed",
                               "one place", "endless feed"})
        QTest::newRow(damage) << QString::fromUtf8(damage);
}

void DiagnosisTest::badInput() {
    QFETCH(QString, damage);
    CircularMeasurement m = synthesizeCircular(machine());
    if (damage == u"no arcs")
        m.arcs.clear();
    for (Arc &arc : m.arcs) {
        const std::size_t left = damage == u"no points" ? 0 : damage == u"few points" ? 7 : arc.angles.size();
        arc.angles.resize(left);
        arc.radialDeviations.resize(left);
        if (damage == u"not finite")
            arc.radialDeviations[5] = std::numeric_limits<double>::quiet_NaN();
        if (damage == u"one place")
            std::ranges::fill(arc.angles, 12.0);
    }
    if (damage == u"no radius")
        m.nominalRadius = 0;
    if (damage == u"no feed")
        m.feed = 0;
    if (damage == u"endless feed")
        m.feed = std::numeric_limits<double>::infinity();
    const MadeCircle made(m);
    const Diagnosis d = diagnose(made.circle());
    QVERIFY(!d.valid());
    QVERIFY(d.sources.empty());
}

void DiagnosisTest::wordsForEverySource() {
    for (const Influence &row : influences()) {
        for (const double sign : {1.0, -1.0}) {
            Diagnosis d;
            d.first = "X";
            d.second = "Y";
            SourceEstimate source;
            source.id = row.id;
            source.axis = row.ofAxis ? y : none;
            source.axisName = row.ofAxis ? "Y" : "X–Y";
            source.separable = true;
            source.fitted[0] = sign;
            const Message meaning = sourceMeaning(d, source);
            QVERIFY(!sourceName(source).text.empty() && !meaning.text.empty());
            const bool taken = row.id == InfluenceId::centre || row.id == InfluenceId::radius;
            QCOMPARE(sourceAdvice(d, source).text.empty(), taken);
            if (row.ofAxis && !taken)
                QCOMPARE(std::get<std::string>(meaning.arguments.front()), std::string("Y"));
            // The words of the sign; not seen where the interval holds 0, borders included.
            if (!taken) {
                const auto meant = [&](double value, double u) {
                    source.value = value;
                    source.u = u;
                    source.degreesOfFreedom = 100; // k = 1.984
                    return QByteArray(sourceMeaning(d, source).text.source);
                };
                const QByteArray notSeen("Not seen: its 95 % interval contains zero.");
                QCOMPARE(meant(sign * 3.4, 1), QByteArray(meaning.text.source)); // t(0.9995) = 3.390
                QVERIFY(meant(sign * 3.3, 1).startsWith("Not certain"));
                QVERIFY(meant(sign * 2.0, 1).startsWith("Not certain"));
                QCOMPARE(meant(sign * 1.9, 1), notSeen);
                QCOMPARE(meant(0, 0), notSeen);
            }
            source.separable = false;
            QVERIFY(sourceMeaning(d, source).text != meaning.text || taken);
            source.with = {0};
            QCOMPARE(sourceMeaning(d, source).text.source, "These arcs do not tell it from other sources.");
        }
    }
}

void DiagnosisTest::uncertaintiesAsShown() {
    SourceEstimate source;
    source.id = InfluenceId::backlash;
    QVERIFY(!source.interval());
    QCOMPARE(shownUncertainty(source), 0.0);
    source.value = 0.006;
    QVERIFY(!source.interval());
    source.u = 0.001;
    source.degreesOfFreedom = 10; // t(0.975; 10) = 2.228 139
    QVERIFY(std::abs(source.interval()->from - (0.006 - 2.228139e-3)) < 1e-9);
    QVERIFY(std::abs(source.interval()->to - (0.006 + 2.228139e-3)) < 1e-9);
    QVERIFY(source.isSeen()); // t(0.9995; 10) = 4.587
    source.value = 0.0045;
    QVERIFY(!source.isSeen());
    source.value = 0.006;
    QVERIFY(std::abs(*shownExpanded(source) - 2.228139) < 1e-6); // µm
    source.indication = true;
    QVERIFY(!source.interval() && !shownExpanded(source) && !source.isSeen());
    source.indication = false;
    source.degreesOfFreedom = 1e12; // many: as of a million, 1.959 966
    QVERIFY(std::abs(source.interval()->to - (0.006 + 1.959966e-3)) < 1e-9);
    QVERIFY(std::abs(shownUncertainty(source) - 1) < 1e-12); // µm
    // τ = √q: u(τ) = u(q)/(2τ); q of 4 ms² ± 0.4 ms²: τ = 2 ± 0.1 ms
    source.id = InfluenceId::commonLag;
    source.value = 4e-6;
    source.u = 0.4e-6;
    QVERIFY(std::abs(shownUncertainty(source) - 0.1) < 1e-12);
    source.value = -4e-6;
    QVERIFY(std::abs(shownUncertainty(source) - 0.1) < 1e-12);
    // near 0 the root of u: q = 0 ± 0.25 ms²
    source.value = 0;
    source.u = 0.25e-6;
    QVERIFY(std::abs(shownUncertainty(source) - 0.5) < 1e-12);
    source.value = 0.062e-6; // √u/2 = 0.25 ms is still larger than √q = 0.249
    QVERIFY(std::abs(shownUncertainty(source) - 0.5) < 1e-12);
    source.u = 0;
    QCOMPARE(shownUncertainty(source), 0.0);
}

QTEST_GUILESS_MAIN(DiagnosisTest)
#include "diagnosis.moc"
