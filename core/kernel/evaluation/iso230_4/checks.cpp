// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/checks.h"

#include "kernel/evaluation/commonchecks.h"
#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/stated.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palmer::iso230_4 {

namespace {

constexpr double leastExtent = 90;    ///< degrees
constexpr double largeOfRadius = 0.1; ///< no machine and no set-up deviates by that much
constexpr double noiseOfAngles = 5;   ///< degrees: a larger step back is not noise of measured angles

bool asksForF(const CircularCase &test) {
    return !test.feedback() && test.asksFor(OfCircle::radialDeviation);
}

bool asksForD(const CircularCase &test) {
    return !test.feedback() && test.asksFor(OfCircle::meanRadialDeviation);
}

/// True if such rows are shown although agreed limits ask for others only.
bool listsUnasked(const CircularCase &test, OfCircle what) {
    return !test.feedback() && !test.asksFor(what) &&
           std::ranges::any_of(test.edition.circles->rows, [&](const CircularRow &row) {
               return row.term.circle == what && test.isRequired(row.term);
           });
}

constexpr Text noDOfPartialArcs =
    REPORT_TEXT("report", "No value for D: it needs full circles in both senses.");
constexpr Text noFOfPartialArc = REPORT_TEXT(
    "report", "No value for F of a partial arc: the least squares centre is for full circles only.");

bool partialArc(const CircularCase &test) {
    return std::ranges::any_of(test.results.paths, [](const EvaluatedPath &p) { return !p.fullCircle; });
}

/// True if the angles of an arc go back: measured in the other sense, not unwrapped, or one is mistyped.
/// Small steps back (for an arc of a few points up to half of its range) are noise of measured angles.
bool runsBack(const Arc &arc) {
    const double sign = arc.sense == Sense::counterclockwise ? 1 : -1;
    double least = std::numeric_limits<double>::infinity();
    double furthest = -least;
    double back = 0;
    for (const double angle : arc.angles) {
        least = std::min(least, sign * angle);
        furthest = std::max(furthest, sign * angle);
        back = std::max(back, furthest - sign * angle);
    }
    return back > std::min(noiseOfAngles, (furthest - least) / 2) && !arc.angles.empty();
}

/// True if the path has minimum zone circles but no least squares circle, although a requested result needs
/// one.
bool lacksLeastSquares(const CircularCase &test, CircleOf of, bool needed) {
    return needed && test.results.circle(of, ReferenceCircle::minimumZone) &&
           !test.results.circle(of, ReferenceCircle::leastSquares);
}

} // namespace

Sentence noArcs(const CircularCase &test) {
    return sentenceIf(
        std::ranges::all_of(test.results.paths, [](const EvaluatedPath &p) { return p.source.empty(); }),
        REPORT_TEXT("report", "The test has no measured points in the evaluated range."));
}

Sentence shortArc(const CircularCase &test) {
    if (noArcs(test))
        return std::nullopt; // noArcs reports it
    for (const EvaluatedPath &path : test.results.paths) {
        if (path.source.empty())
            return Message{
                REPORT_TEXT("report", "The path %1 has no measured points in the evaluated range."),
                {path.index}};
        if (path.extent < leastExtent)
            return Message{REPORT_TEXT("report", "The path %1 covers %2: at least 90° are required."),
                           {path.index, Number{path.extent, Quantity::angle, 1}}};
    }
    return std::nullopt;
}

Sentence anglesAgainstSense(const CircularCase &test) {
    const std::vector<Arc> &arcs = test.measurement.arcs;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        if (runsBack(arcs[k]))
            return Message{
                REPORT_TEXT(
                    "report",
                    "The angles of arc %1 (%2) run against its sense or jump back: anticlockwise they "
                    "grow, clockwise they fall. Its name may be wrong."),
                {std::to_string(k + 1), axisIndex(test.measurement.plane, arcs[k].sense)}};
    }
    return std::nullopt;
}

Sentence largeDeviations(const CircularCase &test) {
    double largest = 0;
    for (const Arc &arc : test.measurement.arcs) {
        for (const double deviation : arc.radialDeviations)
            largest = std::max(largest, std::abs(deviation));
    }
    if (largest <= largeOfRadius * test.measurement.nominalRadius)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "Radial deviations up to %1 on a circle of radius %2: are unit and radius right?"),
        {Number{largest, Quantity::position, 3}, Number{test.measurement.nominalRadius, Quantity::position}}};
}

Judgement bothSenses(const CircularCase &test) {
    const auto &paths = test.results.paths;
    if (paths.empty() || test.bothSenses() || !test.asksForPair())
        return Judgement::met();
    if (!test.resultsStated())
        return Judgement::undeclared();
    if (paths.size() == 1)
        return Judgement::unmet(
            {REPORT_TEXT("report", "Only the path %1 was measured: bi-directional results need both senses."),
             {paths.front().index}});
    const auto &shorter =
        *std::ranges::min_element(paths, {}, [](const EvaluatedPath &path) { return path.points.size(); });
    return Judgement::unmet(
        {REPORT_TEXT("report",
                     "Of the path %1 too few points are evaluated (%2): bi-directional results need "
                     "both senses."),
         {shorter.index, Number{static_cast<double>(shorter.points.size()), Quantity::count, 0}}});
}

Sentence partialArcsForD(const CircularCase &test) {
    return sentenceIf(asksForD(test) && test.bothSenses() && partialArc(test), noDOfPartialArcs);
}

Sentence partialArcsForH(const CircularCase &test) {
    return sentenceIf(!test.feedback() && test.asksFor(OfCircle::hysteresis) && test.bothSenses() &&
                          partialArc(test),
                      REPORT_TEXT("report", "No value for H: it needs full circles in both senses."));
}

Sentence leastSquaresOfPartialArc(const CircularCase &test) {
    return sentenceIf(asksForF(test) && test.measurement.centring == Centring::leastSquares &&
                          partialArc(test),
                      noFOfPartialArc);
}

Sentence unaskedD(const CircularCase &test) {
    return sentenceIf(listsUnasked(test, OfCircle::meanRadialDeviation) && test.bothSenses() &&
                          partialArc(test),
                      noDOfPartialArcs);
}

Sentence unaskedF(const CircularCase &test) {
    return sentenceIf(listsUnasked(test, OfCircle::radialDeviation) &&
                          test.measurement.centring == Centring::leastSquares && partialArc(test),
                      noFOfPartialArc);
}

Sentence setUpCentring(const CircularCase &test) {
    return sentenceIf(
        asksForF(test) && test.measurement.centring == Centring::instrument && !test.results.paths.empty() &&
            !partialArc(test),
        REPORT_TEXT("report",
                    "F is taken about the set-up centre: it contains the set-up error, which table A.1 "
                    "does not expect of full circles."));
}

Sentence noCircle(const CircularCase &test) {
    for (const EvaluatedPath &path : test.results.paths) {
        if (!path.source.empty() && !test.results.circle(circleOf(path.sense), ReferenceCircle::minimumZone))
            return Message{
                REPORT_TEXT("report",
                            "The path %1 has no minimum zone circles: they need four different points "
                            "that do not lie on a straight line."),
                {path.index}};
    }
    return std::nullopt;
}

Sentence noLeastSquaresCircle(const CircularCase &test) {
    const bool ofG = test.measurement.referenceCircle == ReferenceCircle::leastSquares;
    const bool full = !partialArc(test);
    const bool ofF = asksForF(test) && test.measurement.centring == Centring::leastSquares && full;
    const bool ofPair = (asksForD(test) || (!test.feedback() && test.asksFor(OfCircle::hysteresis))) && full;
    bool lacks = test.bothSenses() && lacksLeastSquares(test, CircleOf::both, ofG || ofPair);
    for (const EvaluatedPath &path : test.results.paths)
        lacks |= lacksLeastSquares(test, circleOf(path.sense), ofG || ofF);
    return sentenceIf(lacks,
                      REPORT_TEXT("report",
                                  "No least squares circle was found for the points: what rests on it has no "
                                  "value."));
}

Sentence notCertified(const CircularCase &test) {
    const auto open = [](const CircleResult &c) { return c.certified == false; };
    return sentenceIf(std::ranges::any_of(test.results.circles, open),
                      REPORT_TEXT("report", "The minimum zone circles are not proven to be the narrowest."));
}

Sentence leftHandedPlane(const CircularCase &test) {
    const Plane &plane = test.measurement.plane;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> rightHanded{
        {{"X", "Y"}, {"Y", "Z"}, {"Z", "X"}}};
    const auto is = [&](const auto &pair) {
        return plane.first == pair.first && plane.second == pair.second;
    };
    if (plane.first.empty() || plane.second.empty() || plane.first == plane.second ||
        std::ranges::any_of(rightHanded, is))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The plane %1 is not XY, YZ or ZX: seen from the positive end of the third axis its "
                    "senses are exchanged."),
        {plane.first + plane.second}};
}

Judgement referenceLength(const CircularCase &test) {
    if (test.notCalibrated())
        return Judgement::unmet(
            {REPORT_TEXT("report", "No value for F and D: the reference length is not calibrated.")});
    return test.measurement.referenceLength.calibrated ? Judgement::met() : Judgement::undeclared();
}

Judgement temperature(const CircularCase &test) {
    return common::temperature(
        test.common(),
        REPORT_TEXT("report", "The air was at %1; 20 °C is asked for where it can be controlled."));
}

Judgement correction(const CircularCase &test) {
    return common::correction(
        test.common(), test.results.at20, [](const OtherTemperature & /*away*/) -> Message {
            return {REPORT_TEXT(
                "report",
                "F and D are not corrected to 20 °C, and the test was made at another temperature.")};
        });
}

Sentence correctionImpossible(const CircularCase &test) {
    return sentenceIf(test.needsLength() && test.common().correctionTo20 == CorrectionTo20::appliedHere &&
                          !test.results.correction,
                      REPORT_TEXT("report",
                                  "F and D cannot be corrected to 20 °C: temperatures and "
                                  "coefficients of thermal expansion of machine and instrument are needed."));
}

Sentence recentred(const CircularCase &test) {
    return sentenceIf(test.conditions().recentredBetweenRuns.value_or(false),
                      REPORT_TEXT("report", "The instrument was re-centred between the runs."));
}

Sentence feedbackSignal(const CircularCase &test) {
    const std::string &scale = test.measurement.positionFeedback;
    constexpr std::array<std::string_view, 4> linear{"linear", "Linear", "linéaire", "Linéaire"};
    const bool linearScale = std::ranges::any_of(
        linear, [&](std::string_view word) { return scale.find(word) != std::string::npos; });
    return sentenceIf(
        test.feedback() && !linearScale,
        REPORT_TEXT("report", "Feedback signal: the annex speaks of machines with linear scales; what lies "
                              "between scale and tool is not seen."));
}

Sentence lengthOfFeedback(const CircularCase &test) {
    const auto isLength = [&](const std::string &word) {
        return std::ranges::any_of(test.edition.circles->rows, [&](const CircularRow &row) {
            return row.dependsOnTemperature && row.term.isMeantBy(word);
        });
    };
    return sentenceIf(test.feedback() && std::ranges::any_of(test.measurement.requiredResults, isLength),
                      REPORT_TEXT("report", "F and D cannot be had from a feedback signal."));
}

Sentence rotaryAxis(const CircularCase &test) {
    const auto rotary = [](const std::string &name) {
        constexpr std::string_view rotaryAxes = "ABCabc";
        return !name.empty() && rotaryAxes.find(name[0]) != std::string_view::npos;
    };
    return sentenceIf(rotary(test.measurement.plane.first) || rotary(test.measurement.plane.second),
                      REPORT_TEXT("report", "Paths of rotary axes are outside the scope."));
}

Sentence notConsecutive(const CircularCase &test) {
    return sentenceIf(test.bothSenses() && test.asksForPair() &&
                          test.results.paths[0].arc + 1 != test.results.paths[1].arc,
                      REPORT_TEXT("report", "Other paths were measured between the two."));
}

Judgement allPoints(const CircularCase &test) {
    constexpr double margin = 1; ///< degrees
    for (const EvaluatedPath &path : test.results.paths) {
        const Arc &arc = test.measurement.arcs[path.arc];
        if (!arc.evaluated || arc.angles.empty() || !isBlank(arc.cutOff))
            continue;
        const auto [low, high] = std::ranges::minmax(arc.angles);
        if (arc.evaluated->to - arc.evaluated->from < std::min(high - low, 360.0) - margin - 1e-9)
            return Judgement::undeclared();
    }
    return Judgement::met();
}

Sentence otherContouringFeed(const CircularCase &test) {
    constexpr double margin = 0.01;
    const SpecifiedCircle &specified = test.measurement.specified;
    if (!specified.diameter || !specified.feed || !test.measurement.feed)
        return std::nullopt;
    const auto feed =
        contouringFeed({*specified.diameter, *specified.feed, 2 * test.measurement.nominalRadius});
    if (!feed || std::abs(*test.measurement.feed - *feed) <= (margin + 1e-12) * *feed)
        return std::nullopt;
    // Show three significant digits below 100, whole numbers above.
    constexpr double threeDigits = 100;
    const int decimals =
        *feed >= threeDigits || !(*feed > 0) ? 0 : 2 - static_cast<int>(std::floor(std::log10(*feed)));
    return Message{
        REPORT_TEXT("report", "Feed %1; %2 keeps the acceleration."),
        {Number{*test.measurement.feed, Quantity::feed, -1}, Number{*feed, Quantity::feed, decimals}}};
}

bool external(const CircularCase &test) {
    return !test.feedback();
}
bool needsLength(const CircularCase &test) {
    return test.needsLength();
}
bool needsF(const CircularCase &test) {
    return asksForF(test);
}
bool needsOnlyD(const CircularCase &test) {
    return asksForD(test) && !asksForF(test);
}
bool partialF(const CircularCase &test) {
    return needsF(test) && partialArc(test);
}
bool centringUncertaintyStated(const CircularCase &test) {
    return test.measurement.uncertainty.centring.has_value();
}
bool planeStated(const CircularCase &test) {
    const Plane &plane = test.measurement.plane; // a circle lies in the plane of two axes
    return !isBlank(plane.first) && !isBlank(plane.second) && plane.first != plane.second;
}
bool feedStated(const CircularCase &test) {
    return test.measurement.feed.value_or(0) > 0;
}
bool locationStated(const CircularCase &test) {
    return common::allStated(test.conditions().centre) || !isBlank(test.common().instrumentPosition);
}
Judgement temperaturesStated(const CircularCase &test) {
    static constexpr std::array<Text, 7> names{
        Text{},
        REPORT_TEXT("report", "temperature of the machine"),
        REPORT_TEXT("report", "temperature of the instrument"),
        REPORT_TEXT("report", "temperatures of machine and instrument"),
        REPORT_TEXT("report", "temperature of the air"),
        REPORT_TEXT("report", "temperatures of machine and air"),
        REPORT_TEXT("report", "temperatures of instrument and air")};
    const auto any = [&](SensorMeasures what) { return common::anyTemperature(test.common(), what); };
    return Judgement::lacking(
        State::unmet,
        missingOf(any(SensorMeasures::machine), any(SensorMeasures::instrument), any(SensorMeasures::air)),
        names);
}

} // namespace palmer::iso230_4
