// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <optional>

/// Checks of ISO 230-4, one function per question. Each returns the sentence of the finding, or null if the
/// requirement is met or cannot apply. Grade and clause are in the tables (editions.cpp).
namespace palmer::iso230_4 {

using Sentence = std::optional<Message>;

Sentence noArcs(const CircularCase &test);             ///< at least one path with points
Sentence shortArc(const CircularCase &test);           ///< arcs of 90° at least
Sentence anglesAgainstSense(const CircularCase &test); ///< anticlockwise they grow, clockwise they fall
Sentence largeDeviations(const CircularCase &test);    ///< small, otherwise unit or radius is wrong
Judgement bothSenses(const CircularCase &test);        ///< both senses for G(b), D, H
Sentence partialArcsForD(const CircularCase &test);
Sentence partialArcsForH(const CircularCase &test); ///< full circles for H
Sentence
leastSquaresOfPartialArc(const CircularCase &test);      ///< full circle for F about the least squares centre
Sentence unaskedD(const CircularCase &test);             ///< the same of results shown, not asked for
Sentence unaskedF(const CircularCase &test);             ///< likewise
Sentence setUpCentring(const CircularCase &test);        ///< F of a full circle about the set-up centre
Sentence noCircle(const CircularCase &test);             ///< enough points, not on a line
Sentence noLeastSquaresCircle(const CircularCase &test); ///< if G, F or D need one
Sentence notCertified(const CircularCase &test);         ///< minimum zone proven
Sentence leftHandedPlane(const CircularCase &test);      ///< XY, YZ or ZX
Judgement referenceLength(const CircularCase &test);     ///< calibrated, for F and D
Judgement temperature(const CircularCase &test);         ///< 20 °C if it can be controlled
Judgement correction(const CircularCase &test);          ///< F and D at 20 °C
Sentence correctionImpossible(const CircularCase &test); ///< "applied here" without θ or α
Sentence recentred(const CircularCase &test);            ///< both paths without re-centring
Sentence feedbackSignal(const CircularCase &test);       ///< Annex D refers to machines with linear scales
Sentence lengthOfFeedback(const CircularCase &test);     ///< F and D of a feedback signal
Sentence rotaryAxis(const CircularCase &test);           ///< the plane has an axis A, B or C
Sentence notConsecutive(const CircularCase &test);       ///< the two paths are consecutive
Judgement allPoints(const CircularCase &test);           ///< omitted points are accounted for
Sentence otherContouringFeed(const CircularCase &test);  ///< the specified acceleration, within 1 %

// When a row applies
bool external(const CircularCase &test);    ///< measured by an instrument, not the feedback signal
bool needsLength(const CircularCase &test); ///< F or D is asked for and possible
bool needsF(const CircularCase &test);
bool needsOnlyD(const CircularCase &test);
bool partialF(const CircularCase &test); ///< F of a partial arc

// Statements
bool centringUncertaintyStated(const CircularCase &test);
bool planeStated(const CircularCase &test);
bool feedStated(const CircularCase &test);
bool locationStated(const CircularCase &test);          ///< centre, or the position of the instrument
Judgement temperaturesStated(const CircularCase &test); ///< for machine, instrument and air

} // namespace palmer::iso230_4
