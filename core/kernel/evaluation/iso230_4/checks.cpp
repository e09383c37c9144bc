#include "kernel/evaluation/iso230_4/checks.h"

#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/stated.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palmer::iso230_4 {

namespace {

constexpr double leastExtent = 90; ///< degrees

bool anyRow(const CircularCase &test, std::string_view quantity) {
    return std::ranges::any_of(test.edition.circles->rows,
                               [&](const CircularRow &row) { return row.quantity == quantity; });
}

/// The edition has this result and the parties ask for it.
bool asked(const CircularCase &test, std::string_view quantity) {
    return anyRow(test, quantity) && test.isRequired(quantity);
}

bool partialArc(const CircularCase &test) {
    return std::ranges::any_of(test.results.paths, [](const EvaluatedPath &p) { return !p.fullCircle; });
}

/// Whether the angles of an arc go back by more than half of what they cover: measured in the other sense, or
/// not unwrapped. Small steps back are the noise of measured angles.
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
    return back > (furthest - least) / 2;
}

/// The path has minimum zone circles and no least squares circle, though a result that is asked for rests on
/// one.
bool lacksLeastSquares(const CircularCase &test, CircleOf of, bool needed) {
    return needed && test.results.circle(of, ReferenceCircle::minimumZone) &&
           !test.results.circle(of, ReferenceCircle::leastSquares);
}

bool allStated(const Point3 &point) {
    return std::ranges::all_of(point, [](const auto &x) { return x.has_value(); });
}

Message plain(Text text) {
    return {text};
}

} // namespace

Sentence noArcs(const CircularCase &test) {
    if (std::ranges::any_of(test.results.paths, [](const EvaluatedPath &p) { return !p.source.empty(); }))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The test has no measured points in the evaluated range."));
}

Sentence shortArc(const CircularCase &test) {
    for (const EvaluatedPath &path : test.results.paths) {
        if (!path.source.empty() && path.extent < leastExtent)
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

Sentence oneSense(const CircularCase &test) {
    if (test.results.paths.size() != 1)
        return std::nullopt;
    if (!asked(test, "G(b)") && !asked(test, "D") && !asked(test, "H"))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report", "Only the path %1 was measured: bi-directional results need both senses."),
        {test.results.paths.front().index}};
}

Sentence partialArcsForD(const CircularCase &test) {
    if (test.feedback() || !asked(test, "D") || !test.bothSenses() || !partialArc(test))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "No value for D: it needs full circles in both senses."));
}

Sentence leastSquaresOfPartialArc(const CircularCase &test) {
    if (test.feedback() || !asked(test, "F") || test.measurement.centring != Centring::leastSquares ||
        !partialArc(test))
        return std::nullopt;
    return plain(REPORT_TEXT("report",
                             "No value for F of a partial arc: the least squares centre is for full circles "
                             "only."));
}

Sentence setUpCentring(const CircularCase &test) {
    if (test.feedback() || !asked(test, "F") || test.measurement.centring != Centring::instrument ||
        test.results.paths.empty() || partialArc(test))
        return std::nullopt;
    return plain(REPORT_TEXT(
        "report", "F is taken about the set-up centre: it contains the set-up error, which table A.1 "
                  "does not expect of full circles."));
}

Sentence noCircle(const CircularCase &test) {
    for (const EvaluatedPath &path : test.results.paths) {
        const CircleOf of =
            path.sense == Sense::counterclockwise ? CircleOf::counterclockwise : CircleOf::clockwise;
        if (!path.source.empty() && !test.results.circle(of, ReferenceCircle::minimumZone))
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
    const bool ofF =
        !test.feedback() && asked(test, "F") && test.measurement.centring == Centring::leastSquares && full;
    const bool ofPair = !test.feedback() && (asked(test, "D") || asked(test, "H")) && full;
    bool lacks = test.bothSenses() && lacksLeastSquares(test, CircleOf::both, ofG || ofPair);
    for (const EvaluatedPath &path : test.results.paths)
        lacks |= lacksLeastSquares(
            test, path.sense == Sense::counterclockwise ? CircleOf::counterclockwise : CircleOf::clockwise,
            ofG || ofF);
    if (!lacks)
        return std::nullopt;
    return plain(REPORT_TEXT("report",
                             "No least squares circle was found for the points: what rests on it has no "
                             "value."));
}

Sentence notCertified(const CircularCase &test) {
    const auto open = [](const CircleResult &c) { return c.certified == false; };
    if (std::ranges::none_of(test.results.circles, open))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The minimum zone circles are not proven to be the narrowest."));
}

Sentence leftHandedPlane(const CircularCase &test) {
    const Plane &plane = test.measurement.plane;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> rightHanded{
        {{"X", "Y"}, {"Y", "Z"}, {"Z", "X"}}};
    const auto is = [&](const auto &pair) {
        return plane.first == pair.first && plane.second == pair.second;
    };
    if (plane.first.empty() || plane.second.empty() || std::ranges::any_of(rightHanded, is))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The plane %1 is not XY, YZ or ZX: seen from the positive end of the third axis its "
                    "senses are exchanged."),
        {plane.first + plane.second}};
}

Sentence referenceNotCalibrated(const CircularCase &test) {
    if (!test.needsLength() || !test.notCalibrated())
        return std::nullopt;
    return plain(REPORT_TEXT("report", "No value for F and D: the reference length is not calibrated."));
}

Sentence referenceNotStated(const CircularCase &test) {
    if (!test.needsLength() || test.measurement.referenceLength.calibrated)
        return std::nullopt;
    return plain(REPORT_TEXT(
        "report", "F and D need a calibrated reference length: whether it is calibrated is not stated."));
}

Sentence notCorrected(const CircularCase &test) {
    if (!test.needsLength() || !test.results.notCorrected ||
        test.common().correctionTo20 == CorrectionTo20::appliedHere)
        return std::nullopt;
    return plain(REPORT_TEXT(
        "report", "F and D are not corrected to 20 °C, and the test was made at another temperature."));
}

Sentence correctionImpossible(const CircularCase &test) {
    if (!test.needsLength() || test.common().correctionTo20 != CorrectionTo20::appliedHere ||
        test.results.correction)
        return std::nullopt;
    return plain(REPORT_TEXT("report",
                             "F and D cannot be corrected to 20 °C: temperatures at start and end and the "
                             "coefficients of thermal expansion of machine and instrument are needed."));
}

Sentence recentred(const CircularCase &test) {
    if (!test.conditions().recentredBetweenRuns.value_or(false))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The instrument was centred anew between the runs."));
}

Sentence dryRunWithoutAgreement(const CircularCase &test) {
    if (test.common().warmUp.kind != WarmUpKind::dryRun || isAgreed(test.test, "warmUp"))
        return std::nullopt;
    return plain(REPORT_TEXT("report",
                             "A dry run without an agreed warm-up: only the movements needed to set up the "
                             "instrument are allowed."));
}

Sentence incomplete(const CircularCase &test) {
    if (test.common().complete.value_or(true))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The machine was not complete."));
}

Sentence notLevelled(const CircularCase &test) {
    if (test.common().levelled.value_or(true))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The machine was not levelled and aligned."));
}

Sentence loaded(const CircularCase &test) {
    if (test.common().unloaded.value_or(true))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The machine was not unloaded."));
}

Sentence feedbackSignal(const CircularCase &test) {
    if (!test.feedback())
        return std::nullopt;
    return plain(REPORT_TEXT("report",
                             "Feedback signal: the annex speaks of machines with linear scales; what lies "
                             "between scale and tool is not seen."));
}

Sentence lengthOfFeedback(const CircularCase &test) {
    const auto &asked = test.measurement.requiredResults;
    const auto isLength = [](const std::string &id) {
        return id == "F" || id == "Fmax" || id == "Fmin" || id == "D";
    };
    if (!test.feedback() || std::ranges::none_of(asked, isLength))
        return std::nullopt;
    return plain(REPORT_TEXT("report", "F and D cannot be had from a feedback signal."));
}

Sentence uncertaintyNotStated(const CircularCase &test) {
    if (test.uncertaintyStated)
        return std::nullopt;
    return plain(REPORT_TEXT("report", "The measurement uncertainty is not stated beside every result."));
}

bool planeStated(const CircularCase &test) {
    return !test.measurement.plane.first.empty() && !test.measurement.plane.second.empty();
}
bool feedStated(const CircularCase &test) {
    return test.measurement.feed.has_value();
}
bool instrumentStated(const CircularCase &test) {
    return test.feedback() || stated::instruments(test);
}
bool centreStated(const CircularCase &test) {
    return test.feedback() || allStated(test.conditions().centre);
}
bool toolOffsetStated(const CircularCase &test) {
    return test.feedback() || allStated(test.common().toolOffset);
}
bool workpieceOffsetStated(const CircularCase &test) {
    return test.feedback() || allStated(test.common().workpieceOffset);
}
bool expansionStated(const CircularCase &test) {
    const Expansion &alpha = test.common().expansion;
    return !test.needsLength() || (alpha.machine && alpha.instrument);
}
bool correctionStated(const CircularCase &test) {
    return !test.needsLength() || test.common().correctionTo20 != CorrectionTo20::notStated;
}
bool startPointStated(const CircularCase &test) {
    return !test.conditions().startPoint.empty();
}
bool stopPointStated(const CircularCase &test) {
    return !test.conditions().stopPoint.empty();
}
bool smoothingStated(const CircularCase &test) {
    return !test.conditions().smoothing.empty();
}
bool recentringStated(const CircularCase &test) {
    return test.feedback() || !test.bothSenses() || test.conditions().recentredBetweenRuns.has_value();
}

} // namespace palmer::iso230_4
