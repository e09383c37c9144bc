#include "kernel/evaluation/iso230_2/requirements.h"

#include "kernel/evaluation/iso230_2/checks.h"

#include <array>

namespace palmer::iso230_2 {

namespace {

constexpr auto requirement = Grade::requirement;
constexpr auto recommendation = Grade::recommendation;
constexpr auto note = Grade::note;

bool shortLinear(const PositioningCase &test) {
    return test.linear() && !test.longAxis();
}
bool zoneOfLinear(const PositioningCase &test) {
    return test.linear() && test.zoneTest();
}
bool longLinear(const PositioningCase &test) {
    return test.linear() && test.wholeTravelOfLongAxis();
}
bool shortRotary(const PositioningCase &test) {
    return !test.linear() && !test.longAxis();
}
bool zoneOfRotary(const PositioningCase &test) {
    return !test.linear() && test.zoneTest();
}
bool longRotary(const PositioningCase &test) {
    return !test.linear() && test.wholeTravelOfLongAxis();
}

// clang-format off

// ---- ISO 230-2:1988 ------------------------------------------------------------------------------------------

constexpr std::array shortLinear1988{
    Requirement{"targetsPerMetre", "4.3.2", requirement, targetsPerMetre},
    Requirement{"numberOfTargets", "4.3.2", requirement, fiveTargets},
    Requirement{"approaches",      "4.3.2", requirement, fiveApproaches},
};
constexpr std::array zoneOfLinear1988{
    Requirement{"targetsPerMetre", "4.3.2", requirement, targetsPerMetre},
    Requirement{"numberOfTargets", "4.3.2", requirement, fiveTargets},
    Requirement{"approaches",      "4.3.2", requirement, fiveApproaches},
    Requirement{"zone",            "4.3.3", requirement, zoneLength},
    Requirement{"otherTest",       "4.3.3", requirement, otherTest},
};
constexpr std::array longLinear1988{
    Requirement{"meanInterval",    "4.3.3", requirement, meanInterval},
    Requirement{"wholeLength",     "4.3.3", requirement, wholeLength},
    Requirement{"approaches",      "4.3.3", requirement, oneApproach},
    Requirement{"otherTest",       "4.3.3", requirement, otherTest},
};
constexpr std::array shortRotary1988{
    Requirement{"quarterTurns",    "4.3.4", requirement, quarterTurns},
    Requirement{"approaches",      "4.3.4", requirement, fiveApproaches},
};
constexpr std::array allSchemes1988{
    Scheme{shortLinear,  shortLinear1988},
    Scheme{zoneOfLinear, zoneOfLinear1988},
    Scheme{longLinear,   longLinear1988},
    Scheme{shortRotary,  shortRotary1988},
    Scheme{zoneOfRotary, shortRotary1988},
    // above 360° the edition has no rule
};

constexpr std::array all1988{
    Requirement{"travel",               "",      requirement,    axisTravel},
    Requirement{"temperature",          "3.1",   recommendation, temperature1988},
    Requirement{"correctionTo20",       "3.1",   requirement,    correction1988},
    Requirement{"correctionTo20",       "3.1",   requirement,    correctionImpossible},
    Requirement{"correctionTo20",       "",      note,           correctionOfRotary},
    Requirement{"complete",             "3.2",   requirement,    incomplete},
    Requirement{"levelled",             "3.2",   requirement,    notLevelled},
    Requirement{"unloaded",             "3.2",   requirement,    loaded},
    Requirement{"compensation",         "7",     requirement,    compensationStated},
    Requirement{"warmUp",               "3.3",   requirement,    warmUp1988},
    Requirement{"warmUp",               "3.3",   requirement,    warmUpProcedure},
    Requirement{"ends",                 "",      requirement,    ends},
    Requirement{"ends",                 "",      note,           endsUnknown},
    Requirement{"evenSpacing",          "4.2",   recommendation, evenSpacing},
    Requirement{"missingReadings",      "4.3.2", requirement,    fewReadings},
    Requirement{"missingReadings",      "",      note,           missingReadings},
    Requirement{"refusedReadings",      "",      requirement,    refusedReadings},
    Requirement{"unequalRuns",          "",      note,           unequalRuns},
    Requirement{"excluded",             "",      requirement,    excludedReadings},
    Requirement{"excluded",             "",      requirement,    excludedWithoutReason},
    Requirement{"standardDeviation",    "2.9",   requirement,    rangeMethodRuns},
    Requirement{"drift",                "",      note,           drift},
    Requirement{"workedExample",        "",      note,           workedExample},
};

// ---- ISO 230-2:1997, 2006, 2014 --------------------------------------------------------------------------------

constexpr std::array shortLinear2006{
    Requirement{"targetsPerMetre", "4.3.2", requirement, targetsPerMetre},
    Requirement{"numberOfTargets", "4.3.2", requirement, fiveTargets},
    Requirement{"approaches",      "4.3.2", requirement, fiveApproaches},
};
constexpr std::array zoneOfLinear2006{
    Requirement{"targetsPerMetre", "4.3.2", requirement, targetsPerMetre},
    Requirement{"numberOfTargets", "4.3.2", requirement, fiveTargets},
    Requirement{"approaches",      "4.3.2", requirement, fiveApproaches},
    Requirement{"zone",            "",      note,        zoneLengthInPractice},
    Requirement{"otherTest",       "",      requirement, otherTest},
};
constexpr std::array longLinear2006{
    Requirement{"meanInterval",    "",      note,        meanIntervalInPractice},
    Requirement{"wholeLength",     "",      note,        wholeLengthInPractice},
    Requirement{"approaches",      "",      note,        oneApproachInPractice},
    Requirement{"otherTest",       "",      requirement, otherTest},
};
constexpr std::array shortRotary2006{
    Requirement{"numberOfTargets", "",      note,        targetsOfTravel},
    Requirement{"approaches",      "",      note,        fiveApproachesInPractice},
};
constexpr std::array zoneOfRotary2006{
    Requirement{"numberOfTargets", "",      note,        targetsOfTravel},
    Requirement{"approaches",      "",      note,        fiveApproachesInPractice},
    Requirement{"zone",            "",      note,        zoneLengthInPractice},
    Requirement{"otherTest",       "",      requirement, otherTest},
};
constexpr std::array longRotary2006{
    Requirement{"targetsPerTurn",  "",      note,        targetsPerTurn},
    Requirement{"approaches",      "",      note,        oneApproachInPractice},
    Requirement{"otherTest",       "",      requirement, otherTest},
};

template <std::size_t n>
constexpr std::array<Requirement, n> withoutClauses(std::array<Requirement, n> table) {
    for (Requirement &row : table)
        row.clause = "";
    return table;
}

constexpr auto shortLinearUnclaused = withoutClauses(shortLinear2006);
constexpr auto zoneOfLinearUnclaused = withoutClauses(zoneOfLinear2006);

constexpr std::array allSchemes2006{
    Scheme{shortLinear,  shortLinear2006},
    Scheme{zoneOfLinear, zoneOfLinear2006},
    Scheme{longLinear,   longLinear2006},
    Scheme{shortRotary,  shortRotary2006},
    Scheme{zoneOfRotary, zoneOfRotary2006},
    Scheme{longRotary,   longRotary2006},
};
constexpr std::array allSchemesUnclaused{
    Scheme{shortLinear,  shortLinearUnclaused},
    Scheme{zoneOfLinear, zoneOfLinearUnclaused},
    Scheme{longLinear,   longLinear2006},
    Scheme{shortRotary,  shortRotary2006},
    Scheme{zoneOfRotary, zoneOfRotary2006},
    Scheme{longRotary,   longRotary2006},
};

constexpr std::array all2006{
    Requirement{"travel",               "",      requirement,    axisTravel},
    Requirement{"ends",                 "2.2",   requirement,    ends},
    Requirement{"ends",                 "2.2",   note,           endsUnknown},
    Requirement{"correctionTo20",       "3.1",   requirement,    correction},
    Requirement{"correctionTo20",       "3.1",   requirement,    correctionImpossible},
    Requirement{"correctionTo20",       "",      note,           correctionOfRotary},
    Requirement{"expansionRange",       "3.1",   note,           expansionUncertainty},
    Requirement{"complete",             "3.2",   requirement,    incomplete},
    Requirement{"levelled",             "3.2",   requirement,    notLevelled},
    Requirement{"unloaded",             "3.2",   requirement,    loaded},
    Requirement{"compensation",         "3.2",   recommendation, compensationStated},
    Requirement{"warmUp",               "3.3",   requirement,    warmUpProcedure},
    Requirement{"cycle",                "",      requirement,    stepCycle},
    Requirement{"evenSpacing",          "4.2",   recommendation, evenSpacing},
    Requirement{"targetChoice",         "4.2",   recommendation, randomPart},
    Requirement{"missingReadings",      "4.3.2", requirement,    fewReadings},
    Requirement{"missingReadings",      "",      note,           missingReadings},
    Requirement{"refusedReadings",      "",      requirement,    refusedReadings},
    Requirement{"unequalRuns",          "",      note,           unequalRuns},
    Requirement{"excluded",             "",      requirement,    excludedReadings},
    Requirement{"excluded",             "",      requirement,    excludedWithoutReason},
    Requirement{"standardDeviation",    "2.15",  requirement,    rangeMethodElsewhere},
    Requirement{"drift",                "3.3",   note,           drift},
    Requirement{"workedExample",        "",      note,           workedExample},
    Requirement{"uncertainty",          "",      requirement,    uncertaintyStated}, // last: 1997 has all but this
};

constexpr auto all2014 = withoutClauses(all2006);

/// VDI/DGQ 3441 evaluates the same data; of its text nothing was read: only what holds for any report.
constexpr std::array allVdi3441{
    Requirement{"correctionTo20",       "",      requirement,    correction},
    Requirement{"correctionTo20",       "",      requirement,    correctionImpossible},
    Requirement{"correctionTo20",       "",      note,           correctionOfRotary},
    Requirement{"missingReadings",      "",      requirement,    fewReadings},
    Requirement{"missingReadings",      "",      note,           missingReadings},
    Requirement{"refusedReadings",      "",      requirement,    refusedReadings},
    Requirement{"unequalRuns",          "",      note,           unequalRuns},
    Requirement{"excluded",             "",      requirement,    excludedReadings},
    Requirement{"excluded",             "",      requirement,    excludedWithoutReason},
    Requirement{"standardDeviation",    "",      requirement,    rangeMethodElsewhere},
    Requirement{"drift",                "",      note,           drift},
    Requirement{"workedExample",        "",      note,           workedExample},
};

// ---- Points to be agreed between supplier/manufacturer and user --------------------------------------------------

constexpr std::array agreed1988{
    AgreementPoint{"gradient",           "a", REPORT_TEXT("report", "largest temperature gradient, 12 h before and during the test")},
    AgreementPoint{"measuringReference", "b", REPORT_TEXT("report", "position of the measuring reference")},
    AgreementPoint{"warmUp",             "c", REPORT_TEXT("report", "warm-up")},
    AgreementPoint{"feed",               "d", REPORT_TEXT("report", "feed rate between targets, when not rapid")},
    AgreementPoint{"cycle",              "e", REPORT_TEXT("report", "measuring cycle")},
    AgreementPoint{"zone",               "f", REPORT_TEXT("report", "place of the 2 m working zone")},
};

constexpr std::array agreed1997{
    AgreementPoint{"gradient",           "", REPORT_TEXT("report", "temperature gradient, 12 h before and during the test")},
    AgreementPoint{"instrumentPosition", "", REPORT_TEXT("report", "position of the instrument and of the temperature sensors")},
    AgreementPoint{"warmUp",             "", REPORT_TEXT("report", "warm-up")},
    AgreementPoint{"feed",               "", REPORT_TEXT("report", "feed rate between targets")},
    AgreementPoint{"zone",               "", REPORT_TEXT("report", "place of the working zone of 2 000 mm or 360°")},
    AgreementPoint{"otherAxes",          "", REPORT_TEXT("report", "position of the axes not under test")},
    AgreementPoint{"dwell",              "", REPORT_TEXT("report", "dwell at each target")},
    AgreementPoint{"firstLastTarget",    "", REPORT_TEXT("report", "first and last target")},
    AgreementPoint{"stepCycle",          "", REPORT_TEXT("report", "step cycle")},
};

// clang-format on

} // namespace

std::span<const Scheme> schemes1988() {
    return allSchemes1988;
}
std::span<const Scheme> schemes2006() {
    return allSchemes2006;
}
std::span<const Scheme> schemesWithoutClauses() {
    return allSchemesUnclaused;
}

std::span<const Requirement> requirements1988() {
    return all1988;
}
std::span<const Requirement> requirements1997() {
    return std::span(all2014).first(all2014.size() - 1);
}
std::span<const Requirement> requirements2006() {
    return all2006;
}
std::span<const Requirement> requirements2014() {
    return all2014;
}
std::span<const Requirement> requirementsVdi3441() {
    return allVdi3441;
}

std::span<const AgreementPoint> points1988() {
    return agreed1988;
}
std::span<const AgreementPoint> points1997() {
    return agreed1997;
}

} // namespace palmer::iso230_2
