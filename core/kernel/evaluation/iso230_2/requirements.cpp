// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_2/editions.h"

#include "kernel/evaluation/commonchecks.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/laboratory.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace palmer::iso230_2 {

namespace {

using common::ofConditions;
using common::ofDeclared;
using common::statingConditions;
using enum Source;
using enum Subject;

constexpr auto shall = Grade::requirement;
constexpr auto should = Grade::recommendation;
constexpr auto info = Grade::note;

// ---- When a row applies ----------------------------------------------------------------------------------

bool linear(const PositioningCase &test) {
    return test.linear();
}
bool rotary(const PositioningCase &test) {
    return !test.linear();
}
bool fullTest(const PositioningCase &test) {
    return test.linear() && !test.wholeTravelOfLongAxis();
}
bool shortLinear(const PositioningCase &test) {
    return test.linear() && !test.longAxis();
}
bool notShortLinear(const PositioningCase &test) {
    return !shortLinear(test);
}
bool zoneOfLinear(const PositioningCase &test) {
    return test.linear() && test.zoneTest();
}
bool longLinear(const PositioningCase &test) {
    return test.linear() && test.longAxis();
}
bool wholeOfLinear(const PositioningCase &test) {
    return test.linear() && test.wholeTravelOfLongAxis();
}
bool turnOfRotary(const PositioningCase &test) {
    return !test.linear() && !test.wholeTravelOfLongAxis();
}
bool wholeOfRotary(const PositioningCase &test) {
    return !test.linear() && test.wholeTravelOfLongAxis();
}
bool wholeTravel(const PositioningCase &test) {
    return test.wholeTravelOfLongAxis();
}
bool longAxis(const PositioningCase &test) {
    return test.longAxis();
}
bool zoneTest(const PositioningCase &test) {
    return test.zoneTest();
}
bool polygon(const PositioningCase &test) {
    return test.measurement.targetChoice.kind == TargetChoiceKind::polygon;
}
bool rotaryScale(const PositioningCase &test) {
    return !test.linear() && !polygon(test);
}
bool furtherTargets(const PositioningCase &test) {
    return rotaryScale(test) && test.conditions().continuousDevice.value_or(true);
}
bool chosenFreely(const PositioningCase &test) {
    const auto kind = test.measurement.targetChoice.kind;
    return kind == TargetChoiceKind::free || kind == TargetChoiceKind::notStated;
}
bool linearChosenFreely(const PositioningCase &test) {
    return test.linear() && chosenFreely(test);
}
bool compensatingInstrument(const PositioningCase &test) {
    return test.linear() && test.common().instrumentCompensation != InstrumentCompensation::none;
}
bool approachedBothWays(const PositioningCase &test) {
    return test.positiveRuns > 0 && test.negativeRuns > 0;
}
bool wasCorrected(const PositioningCase &test) {
    const CorrectionTo20 correction = test.common().correctionTo20;
    return test.linear() &&
           (correction == CorrectionTo20::appliedByInstrument || correction == CorrectionTo20::appliedHere);
}

// ---- Rows with their own wording -------------------------------------------------------------------------

Judgement temperature1988(const PositioningCase &test) {
    return common::temperature(
        test.common(),
        REPORT_TEXT("report", "The air was at %1; 20 ± 0.5 °C is asked for where it can be controlled."));
}

bool choiceStated(const PositioningCase &test) {
    return test.measurement.targetChoice.kind != TargetChoiceKind::notStated;
}
bool axisName(const PositioningCase &test) {
    return !isBlank(test.measurement.axis.name);
}
bool positionFeedback(const PositioningCase &test) {
    return !isBlank(test.measurement.axis.positionFeedback);
}
bool feedStated(const PositioningCase &test) {
    return test.conditions().feed || test.conditions().feedMode == FeedMode::rapid;
}
bool airTemperature(const PositioningCase &test) {
    return common::anyTemperature(test.common(), SensorMeasures::air);
}

using Demand = Requirement;

// clang-format off

// ---- ISO 230-2:1988 ------------------------------------------------------------------------------------------

constexpr std::array text1988{
    Demand{"temperature", text, "3.1", shall, conditions, common::controllable, temperature1988,
        REPORT_TEXT("report", "temperature of the environment"), {}, {"conditions.sensors", "conditions.temperatureControlled"}},
    Demand{"soak", text, "3.1", shall, conditions, nullptr, ofDeclared<&Conditions::stabilised>,
        REPORT_TEXT("report", "thermal stability before the test"),
        REPORT_TEXT("report", "Machine or instruments were not thermally stable."), {"conditions.stabilised", "conditions.soak"}},
    Demand{"shielded", text, "3.1", shall, conditions, nullptr, ofDeclared<&Conditions::shielded>,
        REPORT_TEXT("report", "protection from draughts and radiation"),
        REPORT_TEXT("report", "Not protected from draughts or radiation."), {"conditions.shielded"}},
    Demand{"instrumentCompensation", text, "3.1", shall, conditions, compensatingInstrument, instrumentCompensation,
        REPORT_TEXT("report", "compensation by the instrument"),
        REPORT_TEXT("report", "The instrument's compensation was switched off."), {"conditions.instrumentCompensation"}},
    Demand{"gradientPerHour", text, "3.1", shall, conditions, nullptr, gradient,
        REPORT_TEXT("report", "temperature gradient over 12 h and its agreed limit"), {}, {"conditions.gradientPerHour", "conditions.gradientHoursBefore"}},
    Demand{"complete", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::complete>,
        REPORT_TEXT("report", "machine complete and in working order"),
        REPORT_TEXT("report", "The machine was not complete or not in working order."), {"conditions.complete"}},
    Demand{"levelled", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::levelled>,
        REPORT_TEXT("report", "levelling, alignment and functional checks"),
        REPORT_TEXT("report", "Levelling, alignment or functional checks were not done."), {"conditions.levelled"}},
    Demand{"unloaded", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::unloaded>,
        REPORT_TEXT_FOR("report", "machine unloaded", "1988"),
        REPORT_TEXT_FOR("report", "The machine was loaded.", "1988"), {"conditions.unloaded"}},
    Demand{"otherAxes", text, "3.2", shall, conditions, nullptr, ofConditions<common::otherAxes>,
        REPORT_TEXT("report", "position of the axes not under test"), {}, {"conditions.otherAxes"}},
    Demand{"warmUp", text, "3.3", shall, conditions, nullptr, ofConditions<common::warmUpOrSetUp>,
        REPORT_TEXT("report", "warm-up: by whom specified"),
        REPORT_TEXT("report", "Dry run without agreed warm-up: only set-up movements are allowed."), {"conditions.warmUp"}},
    Demand{"dwell", text, "4.1", shall, conditions, nullptr, dwell,
        REPORT_TEXT("report", "rest at each target"), REPORT_TEXT("report", "No rest at the targets."), {"conditions.dwell"}},
    Demand{"feed", text, "4.1", shall, conditions, nullptr, feedOrRapid,
        REPORT_TEXT("report", "agreed feed"), REPORT_TEXT("report", "Neither rapid nor at an agreed feed."), {"conditions.feed", "conditions.feedMode", "agreedPoints.feed"}},
    Demand{"targetChoice", text, "4.2", shall, conditions, linearChosenFreely, choiceOf1988,
        REPORT_TEXT("report", "choice of targets, cyclic pitch"), {}, {"targetChoice"}},
    Demand{"instrumentPosition", text, "4.3.1", shall, conditions, nullptr, statingConditions<common::instrumentPosition>,
        REPORT_TEXT("report", "position of the measuring device"), {}, {"conditions.instrumentPosition", "conditions.toolOffset"}},
    Demand{"sensors", text, "4.3.1", shall, conditions, linear, sensorsOf1988,
        REPORT_TEXT("report", "position of the temperature sensor, type of compensation"), {}, {"conditions.sensors", "conditions.correctionTo20"}},
    Demand{"travel", text, "4.3.2", shall, conditions, linear, axisTravel,
        REPORT_TEXT("report", "axis travel"), {}, {"axis.travel"}},
    Demand{"spacing", text, "4.3.2", shall, conditions, fullTest, spacing,
        REPORT_TEXT("report", "even spacing of the targets up to the ends of the axis"), {}, {"axis.range", "targets"}},
    Demand{"targetsPerMetre", text, "4.3.2", shall, readings, fullTest, unless<targetsPerMetre>, {}, {}, {"targets"}},
    Demand{"numberOfTargets", text, "4.3.2", shall, readings, fullTest, unless<fiveTargets>, {}, {}, {"targets"}},
    Demand{"cycle", text, "4.3.2", shall, conditions, fullTest, cycleStated,
        REPORT_TEXT("report", "measuring cycle"), {}, {"cycle"}},
    Demand{"approaches", text, "4.3.2", shall, readings, fullTest, unless<fiveApproaches>, {}, {}, {"runs"}},
    Demand{"missingReadings", text, "4.3.2", shall, readings, fullTest, unless<fewReadings>, {}, {}, {"runs"}},
    Demand{"meanInterval", text, "4.3.3", shall, readings, wholeOfLinear, elements,
        REPORT_TEXT("report", "elements of the measuring device"), {}, {"axis.scaleElement"}},
    Demand{"wholeLength", text, "4.3.3", shall, readings, wholeOfLinear, unless<wholeLength>, {}, {}, {"targets"}},
    Demand{"approaches", text, "4.3.3", shall, readings, wholeOfLinear, unless<oneApproach>, {}, {}, {"runs"}},
    Demand{"otherTest", text, "4.3.3", shall, readings, longLinear, unless<otherTest>},
    Demand{"zone", text, "4.3.3", shall, conditions, longLinear, zone,
        REPORT_TEXT("report", "agreed working zone"),
        REPORT_TEXT("report", "No working zone was agreed."), {"zone", "agreedPoints.zone"}},
    Demand{"quarterTurns", text, "4.3.4", shall, readings, rotaryScale, quarterTurns, {}, {}, {"targets"}},
    Demand{"freeTargets", text, "4.3.4", shall, conditions, furtherTargets, freeTargets,
        REPORT_TEXT("report", "continuous measuring device or not"),
        REPORT_TEXT("report", "Fewer than three further targets."), {"conditions.continuousDevice"}},
    Demand{"polygonFaces", text, "4.3.4", shall, conditions, polygon, polygonFaces,
        REPORT_TEXT("report", "number of faces"), {}, {"targetChoice.faces"}},
    Demand{"instruments", text, "4.3.4", shall, namedInstruments, rotary, namedInstrument,
        REPORT_TEXT("report", "nature of the measuring device"), {}, {"instruments"}},
    Demand{"approaches", text, "5", shall, readings, rotary, unless<fiveApproaches>, {}, {}, {"runs"}},
    Demand{"missingReadings", text, "5", shall, readings, rotary, unless<fewReadings>, {}, {}, {"runs"}},
};

// ---- ISO 230-2:2006 ------------------------------------------------------------------------------------------

constexpr std::array text2006{
    Demand{"uncertainty", text, "Foreword (7)", shall, uncertainty, nullptr, common::uncertaintyStated,
        REPORT_TEXT("report", "measurement uncertainty"), {}, {"uncertainty"}, Explains::missingUncertainty},
    Demand{"cycle", text, "1", should, conditions, notShortLinear, cycleOf2006,
        REPORT_TEXT("report", "measuring cycle"), {}, {"cycle", "agreedPoints.stepCycle"}},
    Demand{"ends", text, "2.2", shall, conditions, approachedBothWays, endsOf2006,
        REPORT_TEXT("report", "ends of the axis"), {}, {"axis.range", "conditions.approachDistance"}},
    Demand{"sensors", text, "3.1", shall, conditions, nullptr, temperaturesOf2006,
        REPORT_TEXT("report", "temperatures of machine and instrument"), {}, {"conditions.sensors"}},
    Demand{"correctionTo20", text, "3.1", shall, conditions, linear, correction,
        REPORT_TEXT("report", "correction to 20 °C"), {}, {"conditions.correctionTo20"}},
    Demand{"expansionRange", text, "3.1", info, uncertainty, nullptr, unless<expansionUncertainty>, {}, {}, {"uncertainty.expansionRange"}},
    Demand{"soak", text, "3.1", shall, conditions, nullptr, ofDeclared<&Conditions::stabilised>,
        REPORT_TEXT("report", "thermal stability before the test"),
        REPORT_TEXT("report", "Machine or instruments were not thermally stable."), {"conditions.stabilised", "conditions.soak"}},
    Demand{"shielded", text, "3.1", shall, conditions, nullptr, ofDeclared<&Conditions::shielded>,
        REPORT_TEXT("report", "protection from draughts and radiation"),
        REPORT_TEXT("report", "Not protected from draughts or radiation."), {"conditions.shielded"}},
    Demand{"gradientPerHour", text, "3.1", shall, conditions, nullptr, gradient,
        REPORT_TEXT("report", "temperature gradient over 12 h and its agreed limit"), {}, {"conditions.gradientPerHour", "conditions.gradientHoursBefore"}},
    Demand{"compensation", text, "3.2", should, conditions, nullptr, stating<stated::common<&Conditions::compensation, PositioningCase>>,
        REPORT_TEXT("report", "use of compensation"), {}, {"conditions.compensation"}},
    Demand{"complete", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::complete>,
        REPORT_TEXT("report", "machine complete and in working order"),
        REPORT_TEXT("report", "The machine was not complete or not in working order."), {"conditions.complete"}},
    Demand{"levelled", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::levelled>,
        REPORT_TEXT("report", "levelling and alignment"),
        REPORT_TEXT("report", "Levelling or alignment was not done."), {"conditions.levelled"}},
    Demand{"unloaded", text, "3.2", shall, conditions, nullptr, ofDeclared<&Conditions::unloaded>,
        REPORT_TEXT("report", "machine unloaded"), REPORT_TEXT("report", "The machine was loaded."), {"conditions.unloaded"}},
    Demand{"otherAxes", text, "3.2", shall, conditions, nullptr, ofConditions<common::otherAxes>,
        REPORT_TEXT("report", "position of the axes not under test"), {}, {"conditions.otherAxes"}},
    Demand{"warmUp", text, "3.3", shall, conditions, nullptr, ofConditions<common::warmUpStated>,
        REPORT_TEXT("report", "warm-up"), {}, {"conditions.warmUp"}},
    Demand{"drift", text, "3.3", should, readings, nullptr, unless<drift>},
    Demand{"dwell", text, "4.1", shall, conditions, nullptr, dwell,
        REPORT_TEXT("report", "rest at each target"), REPORT_TEXT("report", "No rest at the targets."), {"conditions.dwell"}},
    Demand{"feed", text, "4.1", shall, conditions, nullptr, feedAsAgreed,
        REPORT_TEXT("report", "agreed feed"),
        REPORT_TEXT("report", "The feed between targets was not agreed."), {"conditions.feed", "agreedPoints.feed"}},
    Demand{"targetChoice", text, "4.2", shall, conditions, chosenFreely, choiceOf2006,
        REPORT_TEXT("report", "choice of targets, cyclic pitch"), {}, {"targetChoice"}},
    Demand{"evenSpacing", practice, "", info, readings, nullptr, unless<evenSpacing>, {}, {}, {"targets"}},
    Demand{"instrumentPosition", text, "4.3.1", shall, conditions, nullptr, statingConditions<common::instrumentPosition>,
        REPORT_TEXT("report", "position of the measuring device"), {}, {"conditions.instrumentPosition", "conditions.toolOffset"}},
    Demand{"correctionStatements", text, "4.3.1", shall, conditions, wasCorrected, correctionStatements,
        REPORT_TEXT("report", "position of the temperature sensors, expansion coefficients"), {}, {"conditions.sensors", "conditions.expansion"}},
    Demand{"travel", text, "4.3.2", shall, conditions, linear, axisTravel,
        REPORT_TEXT("report", "axis travel"), {}, {"axis.travel"}},
    Demand{"cycle", text, "4.3.2", shall, conditions, shortLinear, cycleOf2006,
        REPORT_TEXT("report", "measuring cycle"), {}, {"cycle", "agreedPoints.stepCycle"}},
    Demand{"cycle", text, "4.3.2", info, conditions, nullptr, unless<stepCycleAgreed>, {}, {}, {"cycle", "agreedPoints.stepCycle"}},
    Demand{"targetsPerMetre", text, "4.3.2", shall, readings, shortLinear, unless<targetsPerMetre>, {}, {}, {"targets"}},
    Demand{"numberOfTargets", text, "4.3.2", shall, readings, shortLinear, unless<fiveTargets>, {}, {}, {"targets"}},
    Demand{"approaches", text, "4.3.2", shall, readings, shortLinear, unless<fiveApproaches>, {}, {}, {"runs"}},
    Demand{"missingReadings", text, "4.3.2", shall, readings, shortLinear, unless<fewReadings>, {}, {}, {"runs"}},
    // long and rotary axes: the rest of 4.3 was not read
    Demand{"targetsPerMetre", practice, "", shall, readings, zoneOfLinear, unless<targetsPerMetre>, {}, {}, {"targets"}},
    Demand{"numberOfTargets", practice, "", shall, readings, zoneOfLinear, unless<fiveTargets>, {}, {}, {"targets"}},
    Demand{"approaches", practice, "", shall, readings, zoneOfLinear, unless<fiveApproaches>, {}, {}, {"runs"}},
    Demand{"missingReadings", practice, "", shall, readings, zoneOfLinear, unless<fewReadings>, {}, {}, {"runs"}},
    Demand{"meanInterval", practice, "", shall, readings, wholeOfLinear, unless<meanInterval>, {}, {}, {"targets"}},
    Demand{"wholeLength", practice, "", shall, readings, wholeOfLinear, unless<wholeLength>, {}, {}, {"targets"}},
    Demand{"approaches", practice, "", shall, readings, wholeTravel, unless<oneApproach>, {}, {}, {"runs"}},
    Demand{"numberOfTargets", practice, "", shall, readings, turnOfRotary, unless<targetsOfTravel>, {}, {}, {"targets"}},
    Demand{"approaches", practice, "", shall, readings, turnOfRotary, unless<fiveApproaches>, {}, {}, {"runs"}},
    Demand{"missingReadings", practice, "", shall, readings, turnOfRotary, unless<fewReadings>, {}, {}, {"runs"}},
    Demand{"travel", practice, "", shall, conditions, rotary, axisTravel, REPORT_TEXT("report", "axis travel"), {}, {"axis.travel"}},
    Demand{"targetsPerTurn", practice, "", shall, readings, wholeOfRotary, unless<targetsPerTurn>, {}, {}, {"targets"}},
    Demand{"zone", practice, "", shall, conditions, zoneTest, unless<zoneLength>, {}, {}, {"zone"}},
    Demand{"otherTest", practice, "", shall, readings, longAxis, unless<otherTest>},
};

// ---- Good practice of a laboratory ----------------------------------------------------------------------------

constexpr Demand laboratoryRow(const char *id, Subject subject, bool (*applies)(const PositioningCase &),
                            Judgement (*judge)(const PositioningCase &), Text name, const char *key) {
    return {id, laboratory, "", info, subject, applies, judge, name, {}, {key}};
}

/// For every positioning test.
constexpr std::array laboratoryRows{
    laboratoryRow("name", conditions, nullptr, stating<axisName>, REPORT_TEXT("report", "name of the axis"), "axis.name"),
    laboratoryRow("positionFeedback", conditions, nullptr, stating<positionFeedback>, REPORT_TEXT("report", "measuring system of the axis"), "axis.positionFeedback"),
    laboratoryRow("offsets", conditions, nullptr, ofConditions<common::offsetsStated>, REPORT_TEXT("report", "offset of the measuring line to the tool and workpiece reference"), "conditions.toolOffset"),
    laboratoryRow("sensors", conditions, nullptr, stating<airTemperature>, REPORT_TEXT("report", "temperature of the air"), "conditions.sensors"),
    laboratoryRow("airPressure", conditions, nullptr, stating<stated::condition<&PositioningConditions::airPressure, PositioningCase>>, REPORT_TEXT("report", "air pressure"), "conditions.airPressure"),
    laboratoryRow("airHumidity", conditions, nullptr, stating<stated::condition<&PositioningConditions::airHumidity, PositioningCase>>, REPORT_TEXT("report", "air humidity"), "conditions.airHumidity"),
};
/// If the text of the edition does not ask for temperatures.
constexpr std::array temperatureRows{
    laboratoryRow("sensors", conditions, linear, temperaturesOfMachineAndInstrument, REPORT_TEXT("report", "temperatures of machine and instrument"), "conditions.sensors"),
    laboratoryRow("expansion", conditions, linear, ofConditions<common::expansionStated>, REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument"), "conditions.expansion"),
    laboratoryRow("compensation", conditions, nullptr, stating<stated::common<&Conditions::compensation, PositioningCase>>, REPORT_TEXT("report", "compensation active during the test"), "conditions.compensation"),
    laboratoryRow("uncertainty", uncertainty, nullptr, common::uncertaintyStated, REPORT_TEXT("report", "measurement uncertainty"), "uncertainty"),
};
constexpr std::array choiceOfRotary{
    laboratoryRow("targetChoice", conditions, rotary, stating<choiceStated>, REPORT_TEXT("report", "how the targets were chosen"), "targetChoice"),
};
/// VDI only, where no ISO edition asks.
constexpr std::array otherRows{
    laboratoryRow("targetChoice", conditions, nullptr, stating<choiceStated>, REPORT_TEXT("report", "how the targets were chosen"), "targetChoice"),
    laboratoryRow("otherAxes", conditions, nullptr, ofConditions<common::otherAxes>, REPORT_TEXT("report", "position of the axes not under test"), "conditions.otherAxes"),
    laboratoryRow("instrumentPosition", conditions, nullptr, statingConditions<common::instrumentPosition>, REPORT_TEXT("report", "position of the measuring device"), "conditions.instrumentPosition"),
    laboratoryRow("correctionTo20", conditions, linear, stating<stated::common<&Conditions::correctionTo20, PositioningCase>>, REPORT_TEXT("report", "correction to 20 °C"), "conditions.correctionTo20"),
    laboratoryRow("warmUp", conditions, nullptr, stating<stated::warmUp<PositioningCase>>, REPORT_TEXT("report", "warm-up"), "conditions.warmUp"),
    laboratoryRow("feed", conditions, nullptr, stating<feedStated>, REPORT_TEXT("report", "feed rate"), "conditions.feed"),
    laboratoryRow("dwell", conditions, nullptr, stating<stated::condition<&PositioningConditions::dwell, PositioningCase>>, REPORT_TEXT("report", "dwell at each target"), "conditions.dwell"),
};

// ---- Rows of the program ----------------------------------------------------------------------------------

constexpr Demand programRow(const char *id, Subject subject, bool (*applies)(const PositioningCase &),
                         Judgement (*judge)(const PositioningCase &), Explains explains = Explains::nothing) {
    return {id, program, "", info, subject, applies, judge, {}, {}, {}, explains};
}

constexpr std::array programRows{
    programRow("correctionTo20", conditions, nullptr, unless<correctionImpossible>),
    programRow("correctionTo20", conditions, nullptr, unless<correctionOfRotary>),
    programRow("missingReadings", readings, nullptr, unless<missingReadings>),
    programRow("refusedReadings", readings, nullptr, unless<refusedReadings>),
    programRow("unequalRuns", readings, nullptr, unless<unequalRuns>),
    programRow("excluded", readings, nullptr, unless<excludedReadings>),
    Demand{"excluded", laboratory, "", info, readings, nullptr, unless<excludedWithoutReason>},
    programRow("standardDeviation", readings, nullptr, unless<rangeMethodElsewhere>),
    programRow("standardDeviation", readings, nullptr, unless<rangeMethodRuns>),
    programRow("coverage", readings, nullptr, unless<coverage>),
    programRow("workedExample", readings, nullptr, unless<workedExample>, Explains::substituteReadings),
};
/// Missing readings if no row asks for five approaches.
constexpr std::array longLinearRows{programRow("missingReadings", readings, wholeOfLinear, unless<fewReadings>)};
constexpr std::array longRows{programRow("missingReadings", readings, wholeTravel, unless<fewReadings>)};
constexpr std::array vdiRows{programRow("missingReadings", readings, nullptr, unless<fewReadings>)};
/// Ends of the axis: not mentioned in 1988.
constexpr std::array endRows{programRow("ends", conditions, approachedBothWays, unless<ends>)};
constexpr std::array endUnknownRows{programRow("ends", conditions, approachedBothWays, unless<endsUnknown>)};
constexpr std::array driftRows{programRow("drift", readings, nullptr, unless<drift>)};
constexpr std::array moreThanFive1988{
    programRow("approaches", readings, fullTest, unless<moreThanFive>),
    programRow("approaches", readings, rotary, unless<moreThanFive>),
};
constexpr std::array moreThanFive2006{programRow("approaches", readings, shortLinear, unless<moreThanFive>)};

// ---- Points to be agreed between supplier/manufacturer and user --------------------------------------------------

using enum PointRole;

const PositioningMeasurement *positioning(const Test &test) {
    return std::get_if<PositioningMeasurement>(&test.measurement);
}
PointRole always(const Test &) {
    return inRow;
}
PointRole warmUpPoint(const Test &test) {
    const auto *m = positioning(test);
    return m && m->conditions.common.warmUp.specifiedBy == SpecifiedBy::maker ? notApplicable : listed;
}
PointRole warmUpInRow(const Test &test) {
    return warmUpPoint(test) == listed ? inRow : notApplicable;
}
PointRole feedPoint1988(const Test &test) {
    const auto *m = positioning(test);
    return m && m->conditions.feedMode == FeedMode::rapid ? notApplicable : inRow;
}
PointRole cyclePoint(const Test &test) {
    const auto *m = positioning(test);
    return m && m->axis.motion == Motion::linear ? listed : notApplicable;
}
bool isLong(const Test &test) {
    const auto *m = positioning(test);
    return m && isLongAxis(*m);
}
PointRole zonePoint1988(const Test &test) {
    return isLong(test) && positioning(test)->axis.motion == Motion::linear ? inRow : notApplicable;
}
PointRole zonePoint(const Test &test) {
    return isLong(test) ? listed : notApplicable;
}
PointRole stepPoint(const Test &test) {
    const auto *m = positioning(test);
    return m && m->cycle == Cycle::step ? inRow : notApplicable;
}

constexpr std::array agreed1988{
    AgreementPoint{"gradient",           "a", REPORT_TEXT("report", "largest temperature gradient, 12 h before and during the test"), always},
    AgreementPoint{"measuringReference", "b", REPORT_TEXT("report", "position of the measuring reference"), nullptr, true},
    AgreementPoint{"warmUp",             "c", REPORT_TEXT("report", "warm-up"), warmUpPoint},
    AgreementPoint{"feed",               "d", REPORT_TEXT("report", "feed rate between targets, when not rapid"), feedPoint1988},
    AgreementPoint{"cycle",              "e", REPORT_TEXT("report", "measuring cycle"), cyclePoint},
    AgreementPoint{"zone",               "f", REPORT_TEXT("report", "location of the 2 m working zone"), zonePoint1988},
};

constexpr std::array agreed1997{
    AgreementPoint{"gradient",           "", REPORT_TEXT("report", "temperature gradient, 12 h before and during the test"), always},
    AgreementPoint{"instrumentPosition", "", REPORT_TEXT("report", "position of the instrument and of the temperature sensors")},
    AgreementPoint{"warmUp",             "", REPORT_TEXT("report", "warm-up"), warmUpInRow},
    AgreementPoint{"feed",               "", REPORT_TEXT("report", "feed rate between targets"), always},
    AgreementPoint{"zone",               "", REPORT_TEXT("report", "location of the working zone of 2 000 mm or 360°"), zonePoint},
    AgreementPoint{"otherAxes",          "", REPORT_TEXT("report", "position of the axes not under test")},
    AgreementPoint{"dwell",              "", REPORT_TEXT("report", "dwell at each target")},
    AgreementPoint{"firstLastTarget",    "", REPORT_TEXT("report", "first and last target")},
    AgreementPoint{"stepCycle",          "", REPORT_TEXT("report", "step cycle"), stepPoint},
};

// clang-format on

using Rows = std::span<const Demand>;

std::vector<Demand> table(std::initializer_list<Rows> parts) {
    std::vector<Demand> result;
    for (const Rows part : parts)
        result.insert(result.end(), part.begin(), part.end());
    return result;
}

std::vector<Demand> practiceOf2006(std::initializer_list<std::string_view> without) {
    const std::vector<Demand> rows = asPractice(Rows(text2006), without);
    return table({rows, laboratory::rows<PositioningCase>(), laboratoryRows,
                  laboratory::instrumentRows<PositioningCase>(), laboratory::checks<PositioningCase>(),
                  programRows, longRows});
}

std::vector<Demand> requirements1988() {
    std::vector<Demand> instruments = table({laboratory::instrumentRows<PositioningCase>()});
    for (Demand &row : instruments) { // for rotary axes the text itself asks for the instrument
        if (row.id == std::string_view("instruments"))
            row.applies = linear;
    }
    return table({text1988, laboratory::rows<PositioningCase>(), laboratoryRows, temperatureRows,
                  choiceOfRotary, instruments, laboratory::checks<PositioningCase>(), programRows,
                  longLinearRows, endRows, endUnknownRows, driftRows, moreThanFive1988});
}

std::vector<Demand> requirements2006() {
    return table({text2006, laboratory::rows<PositioningCase>(), laboratoryRows,
                  laboratory::instrumentRows<PositioningCase>(), laboratory::checks<PositioningCase>(),
                  programRows, longRows, moreThanFive2006});
}

std::vector<Demand> requirementsVdi3441() {
    return table({laboratory::rows<PositioningCase>(), laboratoryRows, temperatureRows, otherRows,
                  laboratory::instrumentRows<PositioningCase>(), laboratory::checks<PositioningCase>(),
                  programRows, vdiRows, driftRows});
}

} // namespace

const Demands &demandsOf(std::string_view text) {
    static const std::vector<Demand> of1988 = requirements1988();
    static const std::vector<Demand> of1997 = practiceOf2006({"uncertainty"});
    static const std::vector<Demand> of2006 = requirements2006();
    static const std::vector<Demand> of2014 = practiceOf2006({});
    static const std::vector<Demand> ofVdi3441 = requirementsVdi3441();
    static const std::array texts{
        Demands{"ISO 230-2:1988", of1988, agreed1988}, Demands{"ISO 230-2:1997", of1997, agreed1997},
        Demands{"ISO 230-2:2006", of2006, agreed1997}, Demands{"ISO 230-2:2014", of2014, agreed1997},
        Demands{"VDI/DGQ 3441:1977", ofVdi3441}, // asks nothing of ISO
    };
    const auto found = std::ranges::find(texts, text, &Demands::text);
    assert(found != texts.end());
    return *found;
}

} // namespace palmer::iso230_2
