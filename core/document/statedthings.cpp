// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/statedthings.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

// Words to choose from, in the order of their enumerations. An empty one states nothing.
constexpr std::array purposeWords{Text{},
                                  REPORT_TEXT("report", "type test"),
                                  REPORT_TEXT_FOR("report", "acceptance", "purpose"),
                                  REPORT_TEXT_FOR("report", "comparison", "purpose"),
                                  REPORT_TEXT("report", "periodic check"),
                                  REPORT_TEXT_FOR("report", "compensation", "purpose"),
                                  REPORT_TEXT("report", "after repair"),
                                  REPORT_TEXT("report", "after collision"),
                                  REPORT_TEXT("report", "other purpose")};
constexpr std::array roleWords{Text{}, REPORT_TEXT("report", "as found"), REPORT_TEXT("report", "as left")};
constexpr std::array correctionWords{Text{}, REPORT_TEXT("report", "not applied"),
                                     REPORT_TEXT("report", "applied by the instrument"),
                                     REPORT_TEXT("report", "applied here")};
constexpr std::array warmUpWords{Text{}, REPORT_TEXT("report", "agreed or maker’s procedure"),
                                 REPORT_TEXT("report", "dry run"),
                                 REPORT_TEXT("report", "set-up movements only")};
constexpr std::array compensationWords{Text{}, REPORT_TEXT_FOR("report", "switched on", "compensation"),
                                       REPORT_TEXT_FOR("report", "switched off", "compensation"),
                                       REPORT_TEXT("report", "the instrument has none")};
constexpr std::array targetChoiceWords{Text{}, REPORT_TEXT("report", "chosen freely"),
                                       REPORT_TEXT("report", "faces of the polygon"),
                                       REPORT_TEXT("report", "fixed by the instrument")};
constexpr std::array cycleWords{Text{}, REPORT_TEXT("report", "standard test cycle"),
                                REPORT_TEXT("report", "step cycle")};
constexpr std::array feedModeWords{Text{}, REPORT_TEXT("report", "programmed feed"),
                                   REPORT_TEXT("report", "rapid feed")};

// clang-format off
constexpr std::array things{
    StatedThing{"date", REPORT_TEXT("report", "Date of the test"), REPORT_TEXT("report", "The day the readings were taken: 12.03.2026, 2026-03-12 or in words. The day stands first.")},
    StatedThing{"name", REPORT_TEXT("report", "Name"), REPORT_TEXT("report", "What the report calls the machine, or the letter of the axis under test.")},
    StatedThing{"manufacturer", REPORT_TEXT("report", "Manufacturer"), REPORT_TEXT("report", "The maker of the machine, as on its plate.")},
    StatedThing{"model", REPORT_TEXT("report", "Type"), REPORT_TEXT("report", "The type of the machine, as on its plate.")},
    StatedThing{"serialNumber", REPORT_TEXT("report", "Serial number"), REPORT_TEXT("report", "Tells this machine or this instrument from all others of its type.")},
    StatedThing{"controller", REPORT_TEXT("report", "Numerical control"), REPORT_TEXT("report", "Maker and type of the numerical control, with its version where compensation depends on it.")},
    StatedThing{"instruments", REPORT_TEXT("report", "Instrument"), REPORT_TEXT("report", "The measuring instrument. Each test names those it was measured with; the first one is taken for all tests.")},
    StatedThing{"certificate", REPORT_TEXT("report", "Calibration certificate"), REPORT_TEXT("report", "Number of the certificate that makes the readings traceable.")},
    StatedThing{"calibrationDate", REPORT_TEXT("report", "Calibrated on"), REPORT_TEXT("report", "The day of the calibration, not of its end of validity.")},
    StatedThing{"travel", REPORT_TEXT("report", "Axis travel"), REPORT_TEXT("report", "The whole travel of the axis, not that between the first and the last target: the number of targets and the kind of test follow from it."), {.quantity = Quantity::position}},
    StatedThing{"range", REPORT_TEXT("report", "Ends of the axis"), REPORT_TEXT("report", "Both ends of the travel in coordinates of the axis, as “0 … 1800”: shows whether the first and the last target can be approached from both sides."), {.quantity = Quantity::position}},
    StatedThing{"zone", REPORT_TEXT("report", "Agreed working zone"), REPORT_TEXT("report", "The 2 000 mm (360°) of a long axis that were agreed for the full test. A test whose targets lie inside is judged as that of a short axis."), {.quantity = Quantity::position}},
    StatedThing{"positionFeedback", REPORT_TEXT("report", "Measuring system of the axis"), REPORT_TEXT("report", "How the axis knows its position: linear scale, rotary encoder at the screw, …")},
    StatedThing{"targetChoice", REPORT_TEXT("report", "Choice of targets"), REPORT_TEXT("report", "Freely chosen targets have a random part, so that periodic errors do not stay hidden; the plan proposes them."), {.words = targetChoiceWords}},
    StatedThing{"cycle", REPORT_TEXT("report", "Test cycle"), REPORT_TEXT("report", "Standard: all targets up, all down, again. Step: all approaches at one target, then the next; only by written agreement. Not stated: the report says so."), {.words = cycleWords}},
    StatedThing{"feed", REPORT_TEXT("report", "Feed rate"), REPORT_TEXT("report", "The feed between the targets, as programmed; or rapid."), {.quantity = Quantity::feed}},
    StatedThing{"feedMode", REPORT_TEXT("report", "Kind of feed"), {}, {.words = feedModeWords}},
    StatedThing{"dwell", REPORT_TEXT("report", "Dwell at target"), REPORT_TEXT("report", "How long the axis rests before the reading is taken."), {.quantity = Quantity::time}},
    StatedThing{"approachDistance", REPORT_TEXT("report", "Approach distance"), REPORT_TEXT("report", "How far the axis goes beyond a target before it comes back to it: beyond the first and the last one it needs that room."), {.quantity = Quantity::position}},
    StatedThing{"sensors", REPORT_TEXT("report", "Temperatures"), REPORT_TEXT("report", "Start and end of the test for each sensor, and where it was. The mean of machine and instrument is what the correction to 20 °C uses.")},
    StatedThing{"expansion", REPORT_TEXT("report", "Expansion coefficient α"), REPORT_TEXT("report", "Of the measuring system of the machine and of the instrument, in µm/(m·°C): steel about 11.5, glass scales about 8. Needed to correct to 20 °C. An instrument that compensates the air only: 0.")},
    StatedThing{"correctionTo20", REPORT_TEXT("report", "Correction to 20 °C"), REPORT_TEXT("report", "By the instrument: its material compensation was on, nothing is added. Applied here: Palmer adds the nominal differential expansion. Never both: that costs 35 µm/m at 3 °C."), {.words = correctionWords}},
    StatedThing{"airPressure", REPORT_TEXT("report", "Air pressure"), REPORT_TEXT("report", "At the place of the test and not reduced to sea level: the wavelength of a laser depends on it."), {.quantity = Quantity::pressure}},
    StatedThing{"airHumidity", REPORT_TEXT("report", "Relative humidity"), REPORT_TEXT("report", "Relative humidity at the machine."), {.quantity = Quantity::percent}},
    StatedThing{"gradientPerHour", REPORT_TEXT("report", "Temperature gradient"), REPORT_TEXT("report", "Largest change of the air temperature in one hour, in the 12 hours before the test and during it."), {.quantity = Quantity::gradient}},
    StatedThing{"warmUp", REPORT_TEXT("report", "Warm-up"), REPORT_TEXT("report", "Agreed, the maker's, a dry run, or the movements needed to set up the instrument alone."), {.words = warmUpWords}},
    StatedThing{"compensation", REPORT_TEXT("report", "Active compensation"), REPORT_TEXT("report", "Which compensation of the control was on: pitch error, reversal, temperature; or none.")},
    StatedThing{"load", REPORT_TEXT("report", "Load"), REPORT_TEXT("report", "What was on the machine during the test; none is a statement.")},
    StatedThing{"toolOffset", REPORT_TEXT("report", "Offset to the tool reference"), REPORT_TEXT("report", "X, Y, Z from the tool reference to the measuring line. 0 is a statement, empty is none.")},
    StatedThing{"workpieceOffset", REPORT_TEXT("report", "Offset to the workpiece reference"), REPORT_TEXT("report", "X, Y, Z from the workpiece reference to the measuring line. 0 is a statement, empty is none.")},
    StatedThing{"complete", REPORT_TEXT("report", "Machine complete, in working order"), REPORT_TEXT("report", "The machine was completely assembled and in working order; guards may be absent.")},
    StatedThing{"levelled", REPORT_TEXT("report", "Levelled and aligned"), REPORT_TEXT("report", "Levelling and geometric alignment were done before the test.")},
    StatedThing{"unloaded", REPORT_TEXT("report", "Machine unloaded"), REPORT_TEXT("report", "The test was made without workpiece.")},
    StatedThing{"calibrationDue", REPORT_TEXT("report", "Calibration due"), REPORT_TEXT("report", "The day the calibration ends. A test made after it is noted.")},
    StatedThing{"scaleElement", REPORT_TEXT("report", "Element of the scale"), REPORT_TEXT("report", "Length of one element of the axis's measuring device; 0: continuous. A long axis has a target in each element, of a continuous one every 250 mm."), {.quantity = Quantity::position}},
    StatedThing{"faces", REPORT_TEXT("report", "Faces of the polygon"), REPORT_TEXT("report", "How many faces the polygon has: as many targets are asked for.")},
    StatedThing{"continuousDevice", REPORT_TEXT("report", "Continuous measuring device"), REPORT_TEXT("report", "Whether a rotary device with a continuous scale of suitable accuracy was at hand: then three further targets are chosen freely.")},
    StatedThing{"referencePosition", REPORT_TEXT("report", "Zero of displacement"), {}, {.quantity = Quantity::position}},
    StatedThing{"purpose", REPORT_TEXT("report", "Purpose of the test"), REPORT_TEXT("report", "Acceptance, periodic check, comparison, … The step cycle is no reference for acceptance."), {.words = purposeWords}},
    StatedThing{"role", REPORT_TEXT("report", "As found or as left"), REPORT_TEXT("report", "Before or after an adjustment. The verdict of the report rests on all tests except those as found."), {.words = roleWords}},
    StatedThing{"instrumentPosition", REPORT_TEXT("report", "Measuring device"), REPORT_TEXT("report", "Where the measuring device stood, in words; both offsets complete say it as well.")},
    StatedThing{"otherAxes", REPORT_TEXT("report", "Axes not under test"), REPORT_TEXT("report", "Where the other axes stood: squareness and pitch of the axis move the readings with them.")},
    StatedThing{"temperatureControlled", REPORT_TEXT("report", "Room temperature can be controlled"), REPORT_TEXT("report", "Where it can, 20 °C are asked for (1988: ± 0.5 °C; the same bound is taken for circles, whose text has none).")},
    StatedThing{"stabilised", REPORT_TEXT("report", "Thermally stable before the test"), REPORT_TEXT("report", "Machine and instruments were long enough in their environment to be thermally stable.")},
    StatedThing{"soak", REPORT_TEXT("report", "Soaking time"), REPORT_TEXT("report", "How long machine and instruments stood in their environment before the test: 12 h. Whether that made them stable is declared beside it.")},
    StatedThing{"thermalGuidelines", REPORT_TEXT("report", "Maker’s thermal guidelines"), {}},
    StatedThing{"shielded", REPORT_TEXT("report", "Shielded from draughts and radiation"), REPORT_TEXT("report", "Machine and instruments were protected from draughts and from radiation, of the sun or of heaters.")},
    StatedThing{"instrumentCompensation", REPORT_TEXT("report", "Compensation by the instrument"), REPORT_TEXT("report", "Whether the instrument's compensation for the air and the machine's temperature was switched on; nothing is asked of one that has none."), {.words = compensationWords}},
    StatedThing{"gradientHoursBefore", REPORT_TEXT("report", "Gradient: hours before the test"), REPORT_TEXT("report", "How many hours before the test the gradient covers: 12 are asked for."), {.quantity = Quantity::number}},
    StatedThing{"cutOff", REPORT_TEXT("report", "What the evaluated range leaves out"), REPORT_TEXT("report", "Feed-in, feed-out, overshoot: all other points of the path are to be used.")},
    StatedThing{"referenceLength", REPORT_TEXT("report", "Reference length"), REPORT_TEXT("report", "Whether the reference length of the instrument is calibrated: F and D need it.")},
    StatedThing{"centring", REPORT_TEXT("report", "Set-up error"), REPORT_TEXT("report", "Standard uncertainty of the centring; of an arc F contains the set-up error.")},
    StatedThing{"uncertainty", REPORT_TEXT("report", "Measurement uncertainty"), REPORT_TEXT("report", "U beside every result: by a budget, a simulation, or as the laboratory states it.")},
    StatedThing{"plane", REPORT_TEXT("report", "Plane"), REPORT_TEXT("report", "The two axes that were moved. Sense and angle run from the first towards the second.")},
    StatedThing{"requiredResults", REPORT_TEXT("report", "Required results"), REPORT_TEXT("report", "The results that supplier and user ask for: G, G(b), F, D. Bi-directional ones need a path of each sense.")},
    StatedThing{"centre", REPORT_TEXT("report", "Centre of the circle"), REPORT_TEXT("report", "X, Y, Z of the centre in coordinates of the machine.")},
    StatedThing{"startPoint", REPORT_TEXT("report", "Start point"), REPORT_TEXT("report", "Where the path began, as an angle or an axis.")},
    StatedThing{"stopPoint", REPORT_TEXT("report", "Stop point"), REPORT_TEXT("report", "Where the path ended.")},
    StatedThing{"smoothing", REPORT_TEXT("report", "Data smoothing"), REPORT_TEXT("report", "Filters of the instrument or its program that the data went through; or none.")},
    StatedThing{"recentredBetweenRuns", REPORT_TEXT("report", "Re-centred between the runs"), REPORT_TEXT("report", "Bi-directional results need both paths measured one after the other without re-centring.")},
    StatedThing{"device", REPORT_TEXT("report", "Instrument"), REPORT_TEXT("report", "As its certificate states it: a fixed part and a part that grows with the length, brought to k = 2. Or the full width of the range its error lies in.")},
    StatedThing{"misalignmentRange", REPORT_TEXT("report", "Misalignment"), REPORT_TEXT("report", "The largest distance by which the measuring line may have left the axis over the travel, in mm: it enters as a cosine error.")},
    StatedThing{"temperatureRange", REPORT_TEXT("report", "Range of the temperature"), REPORT_TEXT("report", "The full width in which the mean temperature of machine or instrument is sure to lie: sensors, their places, changes between start and end.")},
    StatedThing{"expansionRange", REPORT_TEXT("report", "Range of the expansion coefficient"), REPORT_TEXT("report", "The full width in which α is sure to lie. 3.4 µm/(m·°C) gives U(α) = 2 µm/(m·°C), which ISO 230-2 calls the typical minimum.")},
    StatedThing{"environmentalVariation", REPORT_TEXT("report", "Environmental variation E_VE"), REPORT_TEXT("report", "The largest less the smallest reading of a drift test at rest, over the time of the test. Typed in, or taken from a drift test of the file.")},
    StatedThing{"length", REPORT_TEXT("report", "Length L"), REPORT_TEXT("report", "What the contributions grow with; empty: the measurement travel.")},
    StatedThing{"displacement", REPORT_TEXT("report", "Calibration of displacement"), REPORT_TEXT("report", "Expanded uncertainty of the instrument's displacement, from its certificate. A simulation draws one error a trial for all points: F and D move by it, G does not. The budget counts it in G, too.")},
    StatedThing{"pointNoise", REPORT_TEXT("report", "Noise of a point"), REPORT_TEXT("report", "Standard uncertainty of a single point, from readings at rest. G grows with it and with the number of points.")},
    StatedThing{"repeatability", REPORT_TEXT("report", "Repeatability"), REPORT_TEXT("report", "Standard uncertainty of the result from repeated circles; empty: from the repetitions of the file. A simulation adds one draw a trial to each result, G among them, and moves no point by it.")},
    StatedThing{"trials", REPORT_TEXT("report", "Trials"), REPORT_TEXT("report", "How many times the test is evaluated anew with other errors; empty: as many as two digits of the uncertainty need. Fewer than 220 000 are shown and never decide.")},
    StatedThing{"seed", REPORT_TEXT_FOR("report", "Seed", "of a simulation"), REPORT_TEXT("report", "The same seed gives the same figures, on any computer.")},
    StatedThing{"expanded", REPORT_TEXT("report", "Expanded uncertainty"), REPORT_TEXT("report", "U of the result with k = 2, as the laboratory determined it.")},
    StatedThing{"limits", REPORT_TEXT("report", "Limits"), REPORT_TEXT("report", "What was agreed, with the edition it was agreed for and where it stands. Under another edition there is no verdict.")},
    StatedThing{"decisionRule", REPORT_TEXT("report", "Decision rule"), REPORT_TEXT("report", "How a value near its limit is judged, whose risk the uncertainty is: ISO 14253-1 asks the maker to prove conformity, the other rule asks the user to prove the contrary.")},
    StatedThing{"guardFactor", REPORT_TEXT("report", "Guard band"), REPORT_TEXT("report", "How many times the expanded uncertainty U the value has to stay away from the limit; 1 as a rule.")},
    StatedThing{"agreedPoints", REPORT_TEXT("report", "Points to be agreed"), REPORT_TEXT("report", "What the edition leaves to supplier and user. “Not agreed” is printed as it is, “not applicable” asks for nothing.")},
    StatedThing{"number", REPORT_TEXT("report", "Number"), REPORT_TEXT("report", "Tells this report from all others of the laboratory.")},
    StatedThing{"place", REPORT_TEXT("report", "Place"), REPORT_TEXT("report", "Where the tests were made.")},
    StatedThing{"customer", REPORT_TEXT("report", "Customer"), REPORT_TEXT("report", "Who ordered the tests, with the address.")},
    StatedThing{"address", REPORT_TEXT("report", "Address"), REPORT_TEXT("report", "Street, postcode, town and country, as they stand on the certificate.")},
    StatedThing{"authorisedBy", REPORT_TEXT("report", "Authorised by"), REPORT_TEXT("report", "Who releases the report and answers for it.")},
    StatedThing{"revisionReason", REPORT_TEXT("report", "Reason of the revision"), REPORT_TEXT("report", "What the revision changes.")},
    StatedThing{"condition", REPORT_TEXT("report", "Condition of the machine"), REPORT_TEXT("report", "As it was found: new, in production, after a repair, with what was adjusted before the test.")},
    StatedThing{"calibratedBy", REPORT_TEXT("report", "Calibrated by"), REPORT_TEXT("report", "The laboratory that calibrated the instrument, with its accreditation.")},
    StatedThing{"method", REPORT_TEXT("report", "Method"), REPORT_TEXT("report", "How U is evaluated: by a budget, a simulation, as the laboratory states it, or not at all.")},
};
// clang-format on

} // namespace

std::span<const StatedThing> statedThings() {
    return things;
}

const StatedThing *statedThing(std::string_view key) {
    const auto found = std::ranges::find(things, key, &StatedThing::key);
    return found == things.end() ? nullptr : &*found;
}

Quantity quantityOf(const StatedThing &thing, Motion motion) {
    const Quantity quantity = thing.form.quantity.value();
    if (motion == Motion::linear)
        return quantity;
    return quantity == Quantity::position ? Quantity::angle
           : quantity == Quantity::feed   ? Quantity::angularFeed
                                          : quantity;
}

Text statedWord(std::string_view key, std::size_t value) {
    return statedThing(key)->form.words[value];
}

} // namespace palmer
