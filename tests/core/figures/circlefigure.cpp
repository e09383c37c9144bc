// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/circlefigure.h"

#include "core/kernel/evaluation/circulardata.h"
#include "kernel/numerics/centringerror.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace palmer;
using namespace palmer::testdata;

namespace {

CircleFigure figureOf(const Test &test, const CircleFigureOptions &options = {},
                      Language::Id language = Language::Id::english) {
    return circleFigure(test, evaluatedCircular(test), Language(language), options);
}

QStringList list(std::initializer_list<const char *> texts) {
    QStringList result;
    for (const char *text : texts)
        result << QString::fromUtf8(text);
    return result;
}

QStringList legendTexts(const CircleFigure &figure) {
    QStringList texts;
    for (const CircleLegendEntry &entry : figure.legend)
        texts << entry.text;
    return texts;
}

double parameterOf(const TestEvaluation &evaluation, const char *id) {
    const auto found = std::ranges::find(evaluation.parameters, id, parameterId);
    return found != evaluation.parameters.end() && found->value ? 1000 * *found->value : std::nan("");
}

Interval drawn(const CircleFigure &figure) {
    Interval range{1e300, -1e300};
    for (const CircleTrace &trace : figure.traces) {
        for (const TracePoint &point : trace.points)
            range = {std::min(range.from, point.deviation), std::max(range.to, point.deviation)};
    }
    return range;
}

/// A sum of ten digits: figures name deviations in µm, results in mm.
constexpr double rounding = 1e-9;

} // namespace

/// The figure of a circular test: what it shows and how large.
class CircleFigureTest : public QObject {
    Q_OBJECT

private slots:
    void combinedFigureOfTheBallbarPair() {
        const Test test = ballbarPair();
        const TestEvaluation evaluation = evaluatedCircular(test);
        const CircleFigure figure = circleFigure(test, evaluation, Language(Language::Id::english));
        QCOMPARE(figure.title, QStringLiteral("Actual paths"));
        QCOMPARE(figure.ratio, QStringLiteral("1\u202f000:1"));
        QCOMPARE(figure.divisionLabel, QStringLiteral("5\u00a0µm"));
        QCOMPARE(figure.plotRadius, 34.0);
        QCOMPARE(figure.figureRadius, 49.0);
        QVERIFY(figure.envelope.has_value());
        QCOMPARE(figure.envelope->id, QStringLiteral("G(b)_XY"));
        // about the centre of G(b) the paths fill the ring, exactly
        QVERIFY(std::abs(figure.envelope->outer - figure.envelope->inner -
                         parameterOf(evaluation, "G(b)_XY")) < rounding);
        QVERIFY(std::abs(drawn(figure).to - figure.envelope->outer) < rounding);
        QVERIFY(std::abs(drawn(figure).from - figure.envelope->inner) < rounding);
        QCOMPARE(figure.traces.size(), std::size_t{2});
        QCOMPARE(figure.traces[0].points.size(), std::size_t{1800}); // none left out
        QStringList rings;
        for (const DeviationCircle &ring : figure.rings)
            rings << ring.label;
        QCOMPARE(rings, list({"−10", "−5", "0", "+5", "+10"}));
        QCOMPARE(legendTexts(figure), list({"anticlockwise, XY", "clockwise, YX", "nominal circle",
                                            "minimum zone, G(b)", "reference centre", "starting point"}));
        QCOMPARE(figure.arrows[0].index, QStringLiteral("XY"));
        QCOMPARE(figure.arrows[1].index, QStringLiteral("YX"));
    }

    void separateFiguresStandAboutTheirOwnCentres() {
        const Test test = ballbarPair();
        const TestEvaluation evaluation = evaluatedCircular(test);
        const auto options = separateCircleFigures(test, evaluation);
        QCOMPARE(options.size(), std::size_t{5});
        const char *ids[] = {"G(b)_XY", "G_XY", "G_YX", "Fmax_XY", "Fmax_YX"};
        for (std::size_t i = 0; i < options.size(); ++i) {
            const CircleFigure figure =
                circleFigure(test, evaluation, Language(Language::Id::english), options[i]);
            QCOMPARE(figure.envelope->id, QString::fromUtf8(ids[i]));
            QVERIFY(std::abs(drawn(figure).to - figure.envelope->outer) < rounding);
            QVERIFY(std::abs(drawn(figure).from - figure.envelope->inner) < rounding);
            QCOMPARE(figure.traces.size(), std::size_t{i == 0 ? 2U : 1U});
        }
        const CircleFigure radial =
            circleFigure(test, evaluation, Language(Language::Id::english), options[3]);
        QVERIFY(std::abs(drawn(radial).to - parameterOf(evaluation, "Fmax_XY")) < rounding);
        QVERIFY(std::abs(drawn(radial).from - parameterOf(evaluation, "Fmin_XY")) < rounding);
        QVERIFY(!radial.envelope->dimension);
    }

    void radialDeviationsAboutTheSetUpAreThoseRead() {
        Test test = ballbarPair();
        circular(test).centring = Centring::instrument;
        const TestEvaluation evaluation = evaluatedCircular(test);
        CircleFigureOptions options;
        options.subject = CircleSubject::radialDeviation;
        const CircleFigure figure = circleFigure(test, evaluation, Language(Language::Id::english), options);
        QCOMPARE(figure.traces.size(), std::size_t{2}); // one centre for both
        const Arc &arc = circular(test).arcs[0];
        QCOMPARE(figure.traces[0].points[7].deviation, arc.radialDeviations[7] * 1000);
        QCOMPARE(figure.traces[0].points[7].angle, arc.angles[7]);
    }

    void correctionTo20IsInRadialDeviationsOnly() {
        Test test = ballbarPair();
        auto &conditions = circular(test).conditions.common;
        conditions.correctionTo20 = CorrectionTo20::appliedHere;
        conditions.expansion = {11.5, 0.1};
        for (const SensorMeasures what : {SensorMeasures::machine, SensorMeasures::instrument}) {
            Sensor sensor;
            sensor.measures = what;
            sensor.start = sensor.end = 22;
            conditions.sensors.push_back(sensor);
        }
        const TestEvaluation evaluation = evaluatedCircular(test);
        const auto &results = std::get<CircularResults>(evaluation.results);
        QVERIFY(results.correction.has_value());
        QVERIFY(std::abs(*results.correction * 1000) > 1);
        CircleFigureOptions options{.of = CircleOf::counterclockwise,
                                    .subject = CircleSubject::radialDeviation};
        const CircleFigure radial = circleFigure(test, evaluation, Language(Language::Id::english), options);
        QVERIFY(std::abs(drawn(radial).to - parameterOf(evaluation, "Fmax_XY")) < rounding);
        const Test plain = ballbarPair();
        QVERIFY(std::abs(drawn(figureOf(test)).to - drawn(figureOf(plain)).to) < rounding);
    }

    void magnificationIsTheLargestRoundOneThatFits_data() {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<double>("magnification");
        QTest::addColumn<double>("plotRadius");
        QTest::newRow("the ballbar pair") << -10.8 << 14.3 << 1000.0 << 34.0;
        QTest::newRow("outwards to the edge") << -1.0 << 15.0 << 1000.0 << 34.0;
        QTest::newRow("a little more outwards") << -1.0 << 15.1 << 500.0 << 34.0;
        QTest::newRow("inwards to 0.15 of the radius") << -26.65 << 1.0 << 1000.0 << 34.0;
        QTest::newRow("a little more inwards") << -26.7 << 1.0 << 500.0 << 34.0;
        QTest::newRow("far outside: the nominal circle gives way") << 30.0 << 35.0 << 1000.0 << 14.0;
        QTest::newRow("far inside") << -400.0 << -390.0 << 50.0 << 34.0;
        QTest::newRow("nothing deviates") << 0.0 << 0.0 << 100000.0 << 34.0;
        QTest::newRow("hundredths of a micrometre") << -0.01 << 0.01 << 100000.0 << 34.0;
        QTest::newRow("a millimetre") << -1000.0 << 1000.0 << 10.0 << 34.0;
        QTest::newRow("a metre") << -1e6 << 1e6 << 0.01 << 34.0;
    }

    void magnificationIsTheLargestRoundOneThatFits() {
        QFETCH(const double, from);
        QFETCH(const double, to);
        QFETCH(const double, magnification);
        QFETCH(const double, plotRadius);
        const CircleScale scale = circleScale({from, to}, 49);
        QVERIFY(std::abs(scale.magnification / magnification - 1) < 1e-12);
        QVERIFY(std::abs(scale.plotRadius - plotRadius) < 1e-9);
    }

    void noRadiusShrinksBelowItsPart() {
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> exponent(-3, 4);
        std::uniform_real_distribution<double> place(-3, 3);
        std::uniform_real_distribution<double> radius(8, 120);
        for (int k = 0; k < 20000; ++k) {
            const double size = std::pow(10, exponent(generator));
            const double middle = place(generator) * size;
            const Interval deviations{middle - size, middle + size};
            const double figureRadius = radius(generator);
            const CircleScale scale = circleScale(deviations, figureRadius);
            const double slack = 1e-9 * figureRadius;
            for (const double deviation : {deviations.from, deviations.to, 0.0}) {
                const double r = scale.plotRadius + scale.magnification * deviation / 1000;
                QVERIFY(r >= 0.15 * figureRadius - slack);
                QVERIFY(r <= figureRadius + slack);
            }
            // 1, 2 or 5 times a power of ten
            const double decade = std::pow(10, std::floor(std::log10(scale.magnification) + 1e-9));
            const double factor = scale.magnification / decade;
            QVERIFY(std::abs(factor - 1) < 1e-9 || std::abs(factor - 2) < 1e-9 ||
                    std::abs(factor - 5) < 1e-9);
            // the next step does not fit with the nominal circle at this place
            const double next = scale.magnification * (factor > 1.5 && factor < 3 ? 2.5 : 2);
            QVERIFY(scale.magnification >= 1e5 * (1 - 1e-9) ||
                    scale.plotRadius + next * std::max(0.0, deviations.to) / 1000 > figureRadius ||
                    scale.plotRadius + next * std::min(0.0, deviations.from) / 1000 < 0.15 * figureRadius);
        }
    }

    void magnificationFollowsTheDrawnSize() {
        const Test test = ballbarPair();
        double before = 0;
        for (const double width : {30.0, 60.0, 112.0, 300.0, 1000.0}) {
            const CircleFigure figure = figureOf(test, {.size = {width, width}});
            QVERIFY(figure.magnification > before);
            before = figure.magnification;
            QVERIFY(figure.radius(drawn(figure).to) <= figure.figureRadius + 1e-9);
            QVERIFY(figure.radius(drawn(figure).from) >= 0.15 * figure.figureRadius - 1e-9);
            QVERIFY(2 * figure.figureRadius < width);
        }
    }

    void ringsAndBarsAreRound() {
        for (const double width : {30.0, 45.0, 60.0, 85.0, 112.0, 200.0}) {
            const CircleFigure figure = figureOf(ballbarPair(), {.size = {width, width}});
            const double length = figure.division * figure.magnification / 1000;
            QVERIFY(length >= 0.08 * figure.figureRadius * (1 - 1e-9));
            QVERIFY(length <= 0.2 * figure.figureRadius * (1 + 1e-9));
            QVERIFY(figure.rings.size() >= 3);
            QVERIFY(std::ranges::any_of(figure.rings, [](const auto &ring) { return ring.deviation == 0; }));
            for (const DeviationCircle &ring : figure.rings) {
                QVERIFY(figure.radius(ring.deviation) <= figure.figureRadius + 1e-9);
                QVERIFY(figure.radius(ring.deviation) >= 0.15 * figure.figureRadius - 1e-9);
                QVERIFY(!ring.label.contains(QLatin1Char('-')));
            }
        }
    }

    void theGuardBandStandsAboutTheLimit() {
        Test test = ballbarPair();
        test.limits["G(b)"].value = 0.030;
        test.decisionRule = {Rule::iso14253_1, 1};
        auto &uncertainty = std::get<CircularMeasurement>(test.measurement).uncertainty;
        uncertainty.method = UncertaintyMethod::direct;
        uncertainty.expanded = {{"G(b)", 1.2}};
        const Language english(Language::Id::english);
        const CircleFigure guarded = circleFigure(test, evaluatedCircular(test), english);
        QVERIFY(guarded.envelope->guard && std::abs(*guarded.envelope->guard - 1.2) < 1e-9);
        test.decisionRule.rule = Rule::simpleAcceptance;
        const CircleFigure simple = circleFigure(test, evaluatedCircular(test), english);
        QVERIFY(simple.envelope->limit && !simple.envelope->guard);
    }

    void limitsStandWhereTheyBelong() {
        Test test = ballbarPair();
        test.limits["G(b)"].value = 0.030;
        test.limits["F"].value = 0.016;
        test.limits["Fmin"].value = -0.012;
        const CircleFigure both = figureOf(test);
        QCOMPARE(*both.envelope->limit, 30.0);
        QCOMPARE(both.envelope->limitLabel, QStringLiteral("limit of G(b): 30\u00a0µm"));
        Test converted = test; // through another unit
        converted.limits["G(b)"].value = 0.0010000000000000002;
        QCOMPARE(figureOf(converted).envelope->limitLabel, QStringLiteral("limit of G(b): 1\u00a0µm"));
        QVERIFY(both.limits.empty()); // of F only about the centre of F
        const CircleFigure radial =
            figureOf(test, {.of = CircleOf::counterclockwise, .subject = CircleSubject::radialDeviation});
        QVERIFY(!radial.envelope->limit);
        std::vector<double> limits;
        for (const DeviationCircle &limit : radial.limits)
            limits.push_back(limit.deviation);
        QCOMPARE(limits, std::vector<double>({-12, -16, 16}));
        QVERIFY(!figureOf(test, {.limits = false}).envelope->limit);
        test.limits["G(b)"].value = 0.5; // wider than the figure
        QVERIFY(!figureOf(test).envelope->limit);
        test.limits["F"].value = 1;
        test.limits["Fmin"].value.reset();
        QVERIFY(figureOf(test, {.of = CircleOf::counterclockwise, .subject = CircleSubject::radialDeviation})
                    .limits.empty());
        test.limits["G(b)"] = {0.03, "ISO 230-4:1996", ""}; // agreed for another edition
        QVERIFY(!figureOf(test).envelope->limit);
    }

    void contactsRuleTheResult() {
        const CircleFigure figure = figureOf(ballbarPair(), {.contacts = true});
        QCOMPARE(std::ranges::count(figure.contacts, true, &ContactMark::outer), 2);
        QCOMPARE(std::ranges::count(figure.contacts, false, &ContactMark::outer), 2);
        for (const ContactMark &contact : figure.contacts) {
            const double on = contact.outer ? figure.envelope->outer : figure.envelope->inner;
            QVERIFY(std::abs(contact.mark.at.deviation - on) < rounding);
        }
        QVERIFY(legendTexts(figure).contains(QStringLiteral("ruling points")));
    }

    void repetitionsAreShownOnRequest() {
        Test test = ballbarPair();
        auto &arcs = circular(test).arcs;
        arcs.push_back(arcs[0]);
        for (double &deviation : arcs.back().radialDeviations)
            deviation += 0.001;
        QCOMPARE(figureOf(test).traces.size(), std::size_t{2});
        const CircleFigure figure = figureOf(test, {.repetitions = true});
        QCOMPARE(figure.traces.size(), std::size_t{3});
        QVERIFY(figure.traces[2].repetition);
        // about the same centre: one micrometre farther out, to the second order of the centre's offset
        QVERIFY(std::abs(figure.traces[2].points[100].deviation - figure.traces[0].points[100].deviation -
                         1) < 1e-6);
        QVERIFY(legendTexts(figure).contains(QStringLiteral("repetitions")));
        QCOMPARE(figure.starts.size(), std::size_t{2});
        const CircleFigure one = figureOf(test, {.of = CircleOf::clockwise, .repetitions = true});
        QCOMPARE(one.traces.size(), std::size_t{1});
    }

    void commandedAnglesAreRebuilt() {
        // A perfect circle read from a pivot 0.3 mm off: r = |R·u − e|
        std::vector<Arc> arcs;
        for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
            arcs.push_back(pathOf(sense, 720, [](double angle) {
                return 1000 * (std::hypot(150 * std::cos(angle) - 0.3, 150 * std::sin(angle)) - 150);
            }));
            arcs.back().angleReference = AngleReference::commanded;
        }
        arcs.push_back(arcs[0]);
        const CircleFigure figure = figureOf(circularTest(arcs), {.repetitions = true});
        // the repetition too: all lie on the nominal circle to a thousandth of a micrometre
        QVERIFY(drawn(figure).to < 1e-3 && drawn(figure).from > -1e-3);
        QCOMPARE(figure.traces.size(), std::size_t{3});
    }

    void anglesAreThoseAboutTheNamedCentre() {
        // a circle about (0.5, 0.2) mm: the angle about its centre differs from the one about the origin
        const CircleFigure figure =
            figureOf(circularTest({pathOf(Sense::counterclockwise, 720, [](double angle) {
                const double along = 0.5 * std::cos(angle) + 0.2 * std::sin(angle);
                const double across = -0.5 * std::sin(angle) + 0.2 * std::cos(angle);
                return 1000 * (along + std::sqrt(150 * 150 - across * across) - 150);
            })}));
        // at 90° it is seen 0.5/150 rad to the left of the centre's vertical
        QVERIFY(std::abs(figure.traces[0].points[180].angle - 90 - 0.5 / 150 * 57.29578) < 1e-3);
        QVERIFY(std::abs(figure.traces[0].points[180].deviation) < 1e-6);
    }

    void oneSenseAloneIsAboutItsOwnCentre() {
        const Test test = circularTest({referenceArc("ballbar_pair_cw.csv", Sense::clockwise)});
        const CircleFigure figure = figureOf(test);
        QCOMPARE(figure.envelope->id, QStringLiteral("G_YX"));
        QCOMPARE(figure.title, QStringLiteral("Actual path, YX"));
        QCOMPARE(separateCircleFigures(test, evaluatedCircular(test)).size(), std::size_t{2});
    }

    void feedbackSignalNamesItsResult() {
        Test test = ballbarPair();
        circular(test).source = SignalSource::feedback;
        const CircleFigure figure = figureOf(test);
        QCOMPARE(figure.envelope->label, QStringLiteral("G(b)"));
        QCOMPARE(figure.envelope->subscript, QStringLiteral("f"));
        QCOMPARE(separateCircleFigures(test, evaluatedCircular(test)).size(), std::size_t{3}); // no F
    }

    void whatIsMissingIsLeftOut_data() {
        QTest::addColumn<Test>("test");
        QTest::newRow("no arc") << circularTest({});
        QTest::newRow("an arc without points") << circularTest({Arc()});
        QTest::newRow("one point") << circularTest({pathOf(Sense::clockwise, 1, [](double) { return 3; })});
        QTest::newRow("three points")
            << circularTest({pathOf(Sense::clockwise, 3, [](double) { return 3; })});
        QTest::newRow("all at one angle") << circularTest({pathOf(
            Sense::clockwise, 50, [](double) { return 3; }, 45, 0)});
        QTest::newRow("an arc of 10°") << circularTest({pathOf(
            Sense::counterclockwise, 90, [](double a) { return std::sin(9 * a); }, 40, 10)});
        QTest::newRow("readings of metres") << circularTest(
            {pathOf(Sense::counterclockwise, 90, [](double a) { return 1e6 * std::sin(3 * a); })});
    }

    void whatIsMissingIsLeftOut() {
        QFETCH(const Test, test);
        for (const bool radial : {false, true}) {
            for (const CircleOf of : {CircleOf::both, CircleOf::counterclockwise, CircleOf::clockwise}) {
                CircleFigureOptions options{.of = of, .repetitions = true, .contacts = true};
                options.subject = radial ? CircleSubject::radialDeviation : CircleSubject::circularDeviation;
                const CircleFigure figure = figureOf(test, options);
                QVERIFY(std::isfinite(figure.plotRadius) && std::isfinite(figure.magnification));
                QVERIFY(figure.plotRadius > 0);
                QVERIFY(!figure.rings.empty());
                QVERIFY(!figure.title.isEmpty());
                for (const CircleTrace &trace : figure.traces) {
                    for (const TracePoint &point : trace.points)
                        QVERIFY(std::isfinite(point.angle) && std::isfinite(point.deviation));
                }
            }
        }
    }

    void frenchFigureSpeaksFrench() {
        Test test = ballbarPair();
        test.limits["G(b)"].value = 0.0255;
        const CircleFigure figure = figureOf(test, {}, Language::Id::french);
        QCOMPARE(figure.title, QStringLiteral("Trajectoires réelles"));
        QCOMPARE(figure.caption, QStringLiteral("grossissement 1\u202f000:1, 5\u00a0µm par division"));
        QCOMPARE(figure.centre, QStringLiteral("autour du centre de la zone minimale de G(b)"));
        QCOMPARE(figure.envelope->limitLabel, QStringLiteral("limite de G(b)\u00a0: 25,5\u00a0µm"));
        QCOMPARE(legendTexts(figure),
                 list({"sens antihoraire, XY", "sens horaire, YX", "cercle nominal", "zone minimale, G(b)",
                       "centre de référence", "point de départ"}));
    }

    void leastSquaresCircleIsNamed() {
        Test test = ballbarPair();
        circular(test).referenceCircle = ReferenceCircle::leastSquares;
        const TestEvaluation evaluation = evaluatedCircular(test);
        const CircleFigure figure = circleFigure(test, evaluation, Language(Language::Id::english));
        QVERIFY(legendTexts(figure).contains(QStringLiteral("least squares, G(b)")));
        QVERIFY(figure.centre.contains(QStringLiteral("least squares")));
        QVERIFY(std::abs(drawn(figure).to - figure.envelope->outer) < rounding);
    }

    /// Of evaluated points and others, of arcs of either kind of angles: what the formulas say of each
    /// reading.
    void wholeArcsShowEveryReadingAsItLies() {
        for (const bool commanded : {false, true}) {
            Test test = ballbarPair();
            CircularMeasurement &m = circular(test);
            m.arcs.push_back(m.arcs.front()); // a repetition
            for (Arc &arc : m.arcs) {
                arc.angleReference = commanded ? AngleReference::commanded : AngleReference::polar;
                const double from = std::min(arc.angles.front(), arc.angles.back());
                arc.evaluated = Interval{from + 20.05, from + 300};
            }
            m.arcs[1].evaluated.reset();
            const TestEvaluation evaluation = evaluatedCircular(test);
            const auto &results = std::get<CircularResults>(evaluation.results);
            for (std::size_t k = 0; k < m.arcs.size(); ++k) {
                const Arc &arc = m.arcs[k];
                const CircleResult *circle = results.circle(
                    arc.sense == Sense::clockwise ? CircleOf::clockwise : CircleOf::counterclockwise,
                    ReferenceCircle::leastSquares);
                const PathProfile profile = wholeArc(test, evaluation, k);
                QCOMPARE(profile.angles.size(), arc.angles.size());
                for (std::size_t i = 0; i < arc.angles.size(); ++i) {
                    const Point u = direction(arc.angles[i]);
                    double radius = m.nominalRadius + arc.radialDeviations[i];
                    if (commanded)
                        radius = rebuiltRadius(radius, u, *results.centringError);
                    const double x = radius * u.x - circle->centre.x;
                    const double y = radius * u.y - circle->centre.y;
                    QVERIFY(std::abs(profile.deviations[i] - 1000 * (std::hypot(x, y) - m.nominalRadius)) <
                            rounding);
                    const double turned = std::atan2(u.x * y - u.y * x, u.x * x + u.y * y);
                    QVERIFY(std::abs(profile.angles[i] - arc.angles[i] - turned * 57.29577951308232) < 1e-11);
                    QCOMPARE(profile.source[i], i);
                }
            }
        }
    }

    void manyPointsAreDecimated() {
        const Test test = longPair(200000);
        const TestEvaluation evaluation = evaluatedCircular(test);
        const CircleFigure figure = circleFigure(test, evaluation, Language(Language::Id::english));
        std::size_t points = 0;
        for (const CircleTrace &trace : figure.traces)
            points += trace.points.size();
        QVERIFY(points < 30000);
        // the extremes are those of the result, not those of a bin
        QVERIFY(std::abs(drawn(figure).to - figure.envelope->outer) < 1e-6);
        QVERIFY(std::abs(drawn(figure).from - figure.envelope->inner) < 1e-6);
    }

    void zoomingShowsMoreOfLess() {
        const Test test = longPair(100000);
        const TestEvaluation evaluation = evaluatedCircular(test);
        const Language language(Language::Id::english);
        const auto profiles = pathProfiles(test, evaluation);
        const CircleFigure whole = circleFigure(test, evaluation, profiles, language, {});
        const CircleFigure zoomed = withView(whole, profiles, {34, 0.1, 200}, language);
        QVERIFY(zoomed.division < whole.division / 50);
        QCOMPARE(zoomed.magnification, whole.magnification); // of the whole figure
        std::size_t points = 0;
        for (const CircleTrace &trace : zoomed.traces) {
            points += trace.points.size();
            for (const TracePoint &point : trace.points)
                QVERIFY(std::abs(std::remainder(point.angle, 360.0)) < 3);
        }
        // 112 mm / 200 at a radius of 34 mm are 0.9°: 250 of the 100 000 points a path, all of them
        QVERIFY(points > 400);
        QVERIFY(points < 4000);
        QVERIFY(zoomed.rings.size() < 62);
        QCOMPARE(withView(zoomed, profiles, {}, language), whole);
        // a view that holds the centre sees all directions
        const CircleFigure middle = withView(whole, profiles, {0, 0, 1.2}, language);
        std::size_t all = 0;
        for (const CircleTrace &trace : middle.traces)
            all += trace.points.size();
        QVERIFY(all > 10000);
    }

    /// Whatever was in view before: near and far, beside the centre and about it.
    void aViewDoesNotDependOnTheOneBefore() {
        const Test test = longPair(3000);
        const TestEvaluation evaluation = evaluatedCircular(test);
        const Language language(Language::Id::english);
        const auto profiles = pathProfiles(test, evaluation);
        const CircleFigure whole = circleFigure(test, evaluation, profiles, language, {});
        CircleFigure shown = whole;
        std::mt19937 random(20261123);
        std::uniform_real_distribution<double> place(-1, 1);
        for (int i = 0; i < 300; ++i) {
            constexpr std::array zooms{1.0, 1.1, 1.7, 1.7, 1.7, 3.0, 3.0, 40.0};
            const double zoom = zooms.at(random() % zooms.size());
            const double reach = random() % 2 == 0 ? 20 : 60; // mm; a few times the centre is out of view
            const CircleView view{reach * place(random), reach * place(random), zoom};
            shown = withView(std::move(shown), profiles, view, language);
            QVERIFY(shown == withView(whole, profiles, view, language));
        }
    }
};

QTEST_GUILESS_MAIN(CircleFigureTest)
#include "circlefigure.moc"
