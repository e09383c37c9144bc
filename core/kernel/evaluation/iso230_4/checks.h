#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <optional>

/// What ISO 230-4 asks of a test, one function a question. Each returns the sentence of the finding, or null
/// when the requirement is met or cannot apply. Grade and clause stand in the tables (rules.cpp).
namespace palmer::iso230_4 {

using Sentence = std::optional<Message>;

Sentence noArcs(const CircularCase &test);             ///< at least one path with points
Sentence shortArc(const CircularCase &test);           ///< arcs of 90° at least
Sentence anglesAgainstSense(const CircularCase &test); ///< anticlockwise grow, clockwise fall
Sentence oneSense(const CircularCase &test);           ///< both senses for G(b), D, H
Sentence partialArcsForD(const CircularCase &test);    ///< full circles for D
Sentence
leastSquaresOfPartialArc(const CircularCase &test);      ///< full circle for F about the least squares centre
Sentence setUpCentring(const CircularCase &test);        ///< F of a full circle about the set-up centre
Sentence noCircle(const CircularCase &test);             ///< enough points, not on a line
Sentence noLeastSquaresCircle(const CircularCase &test); ///< where G, F or D need one
Sentence notCertified(const CircularCase &test);         ///< minimum zone proven
Sentence leftHandedPlane(const CircularCase &test);      ///< XY, YZ or ZX
Sentence referenceNotCalibrated(const CircularCase &test); ///< calibrated reference length for F and D
Sentence referenceNotStated(const CircularCase &test);     ///< whether it is calibrated
Sentence notCorrected(const CircularCase &test);           ///< F and D at 20 °C
Sentence correctionImpossible(const CircularCase &test);   ///< "applied here" without θ or α
Sentence recentred(const CircularCase &test);              ///< both paths without re-centring
Sentence dryRunWithoutAgreement(const CircularCase &test); ///< only set-up movements unless agreed
Sentence incomplete(const CircularCase &test);
Sentence notLevelled(const CircularCase &test);
Sentence loaded(const CircularCase &test);
Sentence feedbackSignal(const CircularCase &test);   ///< Annex D speaks of machines with linear scales
Sentence lengthOfFeedback(const CircularCase &test); ///< F and D of a feedback signal
Sentence uncertaintyNotStated(const CircularCase &test);

// Statements; what a feedback signal or a test without F and D does not need counts as stated.
bool planeStated(const CircularCase &test);
bool feedStated(const CircularCase &test);
bool instrumentStated(const CircularCase &test);
bool centreStated(const CircularCase &test);
bool toolOffsetStated(const CircularCase &test);
bool workpieceOffsetStated(const CircularCase &test);
bool expansionStated(const CircularCase &test);
bool correctionStated(const CircularCase &test);
bool startPointStated(const CircularCase &test);
bool stopPointStated(const CircularCase &test);
bool smoothingStated(const CircularCase &test);
bool recentringStated(const CircularCase &test);

template <SensorMeasures what>
bool temperatureStated(const CircularCase &test) {
    return !test.needsLength() || meanTemperature(test.common(), what).has_value();
}

} // namespace palmer::iso230_4
