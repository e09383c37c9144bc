#pragma once

#include "kernel/evaluation/positioningcase.h"

#include <optional>

/// What the editions of ISO 230-2 ask of a test, one function a question. Each returns the sentence of the
/// finding, or null when the requirement is met or cannot apply. Grade and clause stand in the tables.
namespace palmer::iso230_2 {

using Sentence = std::optional<Message>;

// Targets
Sentence axisTravel(const PositioningCase &test);      ///< axis travel stated
Sentence targetsPerMetre(const PositioningCase &test); ///< ≥ 5 a metre of the judged travel
Sentence fiveTargets(const PositioningCase &test);     ///< ≥ 5 in all
Sentence meanInterval(const PositioningCase &test);    ///< long axis: mean interval ≤ 250 mm
Sentence
wholeLength(const PositioningCase &test); ///< long axis: no more than 250 mm left out at an end, on average
Sentence quarterTurns(const PositioningCase &test);    ///< 1988, rotary: 0, 90, 180, 270° or a polygon
Sentence targetsOfTravel(const PositioningCase &test); ///< rotary: ≤ 90° 3, ≤ 180° 5, above 8 targets
Sentence targetsPerTurn(const PositioningCase &test);  ///< rotary above 360°: 8 a turn, up to 1 800°
Sentence otherTest(const PositioningCase &test);       ///< long axis: whole travel and zone
Sentence zoneLength(const PositioningCase &test);      ///< the zone is 2 000 mm (360°) long
Sentence ends(const PositioningCase &test);            ///< first and last target approached from both sides
Sentence endsUnknown(const PositioningCase &test);     ///< ends of the axis not stated: not checked
Sentence evenSpacing(const PositioningCase &test);     ///< freely chosen targets do not share a phase
Sentence randomPart(const PositioningCase &test);      ///< r within ± the period, or ±30 % of p

// Runs and readings
Sentence fiveApproaches(const PositioningCase &test); ///< ≥ 5 each way
Sentence oneApproach(const PositioningCase &test);    ///< ≥ 1 each way
Sentence fewReadings(const PositioningCase &test);    ///< missing readings, fewer than 5 left somewhere
Sentence
missingReadings(const PositioningCase &test); ///< missing readings, 5 left everywhere (or no full test)
Sentence refusedReadings(const PositioningCase &test);  ///< none of them is a text that is no number
Sentence unequalRuns(const PositioningCase &test);      ///< as many runs up as down
Sentence excludedReadings(const PositioningCase &test); ///< none set aside
Sentence excludedWithoutReason(const PositioningCase &test);
Sentence rangeMethodElsewhere(const PositioningCase &test); ///< range method outside ISO 230-2:1988
Sentence rangeMethodRuns(const PositioningCase &test);      ///< range method: 2 … 10 readings
Sentence drift(const PositioningCase &test);         ///< no steady progression from approach to approach
Sentence stepCycle(const PositioningCase &test);     ///< step cycle by written agreement only
Sentence workedExample(const PositioningCase &test); ///< the readings are those of the 1988 example

// The same where the text of the edition was not read: the sentence says so.
Sentence meanIntervalInPractice(const PositioningCase &test);
Sentence wholeLengthInPractice(const PositioningCase &test);
Sentence zoneLengthInPractice(const PositioningCase &test);
Sentence fiveApproachesInPractice(const PositioningCase &test);
Sentence oneApproachInPractice(const PositioningCase &test);

// Conditions
Sentence temperature1988(const PositioningCase &test);      ///< 20 ± 0.5 °C where controllable
Sentence correction1988(const PositioningCase &test);       ///< compensation on beyond 20 ± 0.5 °C
Sentence correction(const PositioningCase &test);           ///< corrected to 20 °C where it is not 20 °C
Sentence correctionImpossible(const PositioningCase &test); ///< "applied here" without θ or α
Sentence correctionOfRotary(const PositioningCase &test);   ///< "applied here" to a rotary axis
Sentence expansionUncertainty(const PositioningCase &test); ///< 0.6·R(α) ≥ 2 µm/(m·°C)
Sentence incomplete(const PositioningCase &test);           ///< machine complete
Sentence notLevelled(const PositioningCase &test);          ///< machine levelled and aligned
Sentence loaded(const PositioningCase &test);               ///< machine unloaded
Sentence warmUp1988(const PositioningCase &test);      ///< agreed or the maker's, else only set-up movements
Sentence warmUpProcedure(const PositioningCase &test); ///< a procedure is agreed or described
Sentence compensationStated(const PositioningCase &test); ///< compensation stated
Sentence uncertaintyStated(const PositioningCase &test);  ///< U beside every result

} // namespace palmer::iso230_2
