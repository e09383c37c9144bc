// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/positioningcase.h"

#include <optional>

/// Checks of the editions of ISO 230-2, one function per question. A Sentence says what is wrong, or is null;
/// a Judgement can also be undeclared. Source, clause, modality and when a row applies are in the tables
/// (requirements.cpp).
namespace palmer::iso230_2 {

using Sentence = std::optional<Message>;

// Targets
Judgement axisTravel(const PositioningCase &test);     ///< axis travel stated
Sentence targetsPerMetre(const PositioningCase &test); ///< ≥ 5 per metre of the judged travel
Sentence fiveTargets(const PositioningCase &test);     ///< ≥ 5 in all
Sentence meanInterval(const PositioningCase &test);    ///< long axis: mean interval ≤ 250 mm
Judgement elements(const PositioningCase &test);       ///< the same, or a target in each scale element
Sentence
wholeLength(const PositioningCase &test); ///< long axis: at most 250 mm left out at an end, on average
Judgement quarterTurns(const PositioningCase &test);   ///< those of 0, 90, 180, 270° that are within reach
Judgement freeTargets(const PositioningCase &test);    ///< three more than those
Judgement polygonFaces(const PositioningCase &test);   ///< as many targets as the polygon has faces
Sentence targetsOfTravel(const PositioningCase &test); ///< rotary: ≤ 90° 3, ≤ 180° 5, above 8 targets
Sentence targetsPerTurn(const PositioningCase &test);  ///< rotary above 360°: 8 per turn, up to 1 800°
Sentence otherTest(const PositioningCase &test);       ///< long axis: whole travel and zone
Sentence zoneLength(const PositioningCase &test);      ///< the zone is 2 000 mm (360°) long
Judgement zone(const PositioningCase &test);           ///< and agreed
Sentence ends(const PositioningCase &test);            ///< first and last target approached from both sides
Judgement endsOf2006(const PositioningCase &test);     ///< the same; undeclared without the ends of the axis
Sentence endsUnknown(const PositioningCase &test);     ///< ends of the axis not stated: not checked
Judgement choiceOf1988(const PositioningCase &test);   ///< targets do not share a phase of the cyclic pitch
Judgement
spacing(const PositioningCase &test); ///< steps within two periods (60 %) of the mean step, up to the ends
Sentence coverage(const PositioningCase &test);      ///< at least half of the axis
Judgement choiceOf2006(const PositioningCase &test); ///< random part within ± the period, or ±30 % of p
Sentence evenSpacing(const PositioningCase &test);   ///< all steps equal, period unknown

// Runs and readings
Sentence fiveApproaches(const PositioningCase &test); ///< ≥ 5 per direction
Sentence moreThanFive(const PositioningCase &test);
Sentence oneApproach(const PositioningCase &test); ///< ≥ 1 per direction
Sentence
fewReadings(const PositioningCase &test); ///< five approaches, but fewer than 5 readings left somewhere
Sentence missingReadings(const PositioningCase &test);  ///< missing readings, 5 left everywhere
Sentence refusedReadings(const PositioningCase &test);  ///< none is a text that is not a number
Sentence unequalRuns(const PositioningCase &test);      ///< equal numbers of runs in both directions
Sentence excludedReadings(const PositioningCase &test); ///< none set aside
Sentence excludedWithoutReason(const PositioningCase &test);
Sentence rangeMethodElsewhere(const PositioningCase &test); ///< range method outside ISO 230-2:1988
Sentence rangeMethodRuns(const PositioningCase &test);      ///< range method: 2 … 10 readings
Sentence drift(const PositioningCase &test);           ///< no steady progression from approach to approach
bool stepCycleInWriting(const PositioningCase &test);  ///< agreed, with a text naming the document
Judgement cycleStated(const PositioningCase &test);    ///< stated, and not contradicted by the runs
Judgement cycleOf2006(const PositioningCase &test);    ///< and the step cycle by written agreement only
Sentence stepCycleAgreed(const PositioningCase &test); ///< the step cycle is agreed
Sentence workedExample(const PositioningCase &test);   ///< the readings are those of the 1988 example

// Conditions
Judgement instrumentCompensation(const PositioningCase &test); ///< on if the instrument has one
Judgement gradient(const PositioningCase &test);               ///< over 12 h within the agreed limit
Judgement dwell(const PositioningCase &test);                  ///< at rest at each target
Judgement feedOrRapid(const PositioningCase &test);            ///< rapid, or at an agreed feed
Judgement feedAsAgreed(const PositioningCase &test);           ///< at an agreed feed
Judgement correction(const PositioningCase &test);             ///< corrected to 20 °C if necessary
Sentence correctionImpossible(const PositioningCase &test);    ///< "applied here" without θ or α
Sentence correctionOfRotary(const PositioningCase &test);      ///< "applied here" to a rotary axis
Sentence expansionUncertainty(const PositioningCase &test);    ///< 0.6·R(α) ≥ 2 µm/(m·°C)
Judgement temperaturesOf2006(const PositioningCase &test);     ///< of machine and instrument
Judgement temperaturesOfMachineAndInstrument(const PositioningCase &test); ///< each by its own sensor
Judgement sensorsOf1988(const PositioningCase &test);        ///< positions and type of compensation
Judgement correctionStatements(const PositioningCase &test); ///< the statements of a correction that was made
Judgement namedInstrument(const PositioningCase &test);      ///< one with a description

} // namespace palmer::iso230_2
