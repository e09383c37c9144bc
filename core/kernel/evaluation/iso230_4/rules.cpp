#include "kernel/evaluation/iso230_4/rules.h"

#include "kernel/evaluation/iso230_4/checks.h"
#include "kernel/evaluation/iso230_4/parameters.h"
#include "kernel/evaluation/stated.h"

#include <array>

namespace palmer::iso230_4 {

namespace {

constexpr auto arc = CircularRow::Of::eachArc;
constexpr auto pair = CircularRow::Of::pair;
constexpr auto deviation = Quantity::deviation;
constexpr bool external = true;
constexpr bool feedback = false;
constexpr bool at20 = true;
constexpr auto requirement = Grade::requirement;
constexpr auto recommendation = Grade::recommendation;
constexpr auto note = Grade::note;

// clang-format off

// ---- Results, in the order of print ------------------------------------------------------------------------------

constexpr std::array rows2005{
    CircularRow{{"G(b)",  {"G(b)"},     REPORT_TEXT("report", "bi-directional circular deviation"), "3.3", deviation}, "G(b)", pair, external, false, deviationOfPair},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular deviation"), "3.4", deviation}, "G", arc, external, false, deviationOfPath},
    CircularRow{{"D",     {"D"},        REPORT_TEXT("report", "mean bi-directional radial deviation"), "3.6", deviation}, "D", pair, external, at20, meanRadialDeviation},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial deviation, maximum"), "3.5", deviation}, "F", arc, external, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial deviation, minimum"), "3.5", deviation}, "F", arc, external, at20, smallestRadialDeviation},
    CircularRow{{"G(b)f", {"G(b)", "f"}, REPORT_TEXT("report", "bi-directional circular deviation using feed back signal"), "", deviation}, "G(b)f", pair, feedback, false, deviationOfPair},
    CircularRow{{"Gf",    {"G", "f"},   REPORT_TEXT("report", "circular deviation using feed back signal"), "", deviation}, "Gf", arc, feedback, false, deviationOfPath},
};

constexpr std::array rows2022{
    CircularRow{{"G(b)",  {"G(b)"},     REPORT_TEXT("report", "bi-directional circular error"), "", deviation}, "G(b)", pair, external, false, deviationOfPair},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular error"), "", deviation}, "G", arc, external, false, deviationOfPath},
    CircularRow{{"D",     {"D"},        REPORT_TEXT("report", "mean bi-directional radial error"), "", deviation}, "D", pair, external, at20, meanRadialDeviation},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial error, maximum"), "", deviation}, "F", arc, external, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial error, minimum"), "", deviation}, "F", arc, external, at20, smallestRadialDeviation},
    CircularRow{{"G(b)f", {"G(b)", "f"}, REPORT_TEXT("report", "bi-directional circular error using feed back signal"), "", deviation}, "G(b)f", pair, feedback, false, deviationOfPair},
    CircularRow{{"Gf",    {"G", "f"},   REPORT_TEXT("report", "circular error using feed back signal"), "", deviation}, "Gf", arc, feedback, false, deviationOfPath},
};

constexpr std::array rows1996{
    CircularRow{{"H",     {"H"},        REPORT_TEXT("report", "circular hysteresis"), "", deviation}, "H", pair, external, false, hysteresis},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular deviation"), "", deviation}, "G", arc, external, false, deviationOfPath},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial deviation, maximum"), "", deviation}, "F", arc, external, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial deviation, minimum"), "", deviation}, "F", arc, external, at20, smallestRadialDeviation},
};

// ---- Requirements --------------------------------------------------------------------------------------------------

constexpr std::array requirements2005{
    CircularRequirement{"arcs",             "",    requirement,    noArcs},
    CircularRequirement{"arcs",             "",    requirement,    shortArc},
    CircularRequirement{"arcs",             "",    requirement,    anglesAgainstSense},
    CircularRequirement{"arcs",             "3.3", requirement,    oneSense},
    CircularRequirement{"arcs",             "3.6", requirement,    partialArcsForD},
    CircularRequirement{"centring",         "3.5", requirement,    leastSquaresOfPartialArc},
    CircularRequirement{"centring",         "3.5", note,           setUpCentring},
    CircularRequirement{"minimumZone",      "",    requirement,    noCircle},
    CircularRequirement{"minimumZone",      "",    note,           notCertified},
    CircularRequirement{"leastSquares",     "",    requirement,    noLeastSquaresCircle},
    CircularRequirement{"plane",            "3.8", note,           leftHandedPlane},
    CircularRequirement{"referenceLength",  "4.5", requirement,    referenceNotCalibrated},
    CircularRequirement{"referenceLength",  "4.5", requirement,    referenceNotStated},
    CircularRequirement{"correctionTo20",   "",    requirement,    notCorrected},
    CircularRequirement{"correctionTo20",   "",    requirement,    correctionImpossible},
    CircularRequirement{"recentredBetweenRuns", "", requirement,   recentred},
    CircularRequirement{"warmUp",           "",    requirement,    dryRunWithoutAgreement},
    CircularRequirement{"complete",         "",    requirement,    incomplete},
    CircularRequirement{"levelled",         "",    requirement,    notLevelled},
    CircularRequirement{"unloaded",         "",    requirement,    loaded},
    CircularRequirement{"source",           "Annex D", note,       feedbackSignal},
    CircularRequirement{"requiredResults",  "",    requirement,    lengthOfFeedback},
    CircularRequirement{"uncertainty",      "4.6", recommendation, uncertaintyNotStated},
};

template <std::size_t n>
constexpr std::array<CircularRequirement, n> withoutClauses(std::array<CircularRequirement, n> table) {
    for (CircularRequirement &row : table)
        row.clause = "";
    return table;
}

constexpr auto requirementsWithoutClauses = withoutClauses(requirements2005);

constexpr std::array allStatements{
    CircularStatement{"date",             REPORT_TEXT("report", "date of the test"), stated::date},
    CircularStatement{"manufacturer",     REPORT_TEXT("report", "manufacturer of the machine"), stated::ofMachine<&Machine::manufacturer>},
    CircularStatement{"model",            REPORT_TEXT("report", "type of the machine"), stated::ofMachine<&Machine::model>},
    CircularStatement{"serialNumber",     REPORT_TEXT("report", "serial number of the machine"), stated::ofMachine<&Machine::serialNumber>},
    CircularStatement{"plane",            REPORT_TEXT("report", "axes moved"), planeStated},
    CircularStatement{"feed",             REPORT_TEXT("report", "contouring feed"), feedStated},
    CircularStatement{"instruments",      REPORT_TEXT("report", "instrument"), instrumentStated},
    CircularStatement{"serialNumber",     REPORT_TEXT("report", "serial number of each instrument"), stated::instrumentSerial},
    CircularStatement{"certificate",      REPORT_TEXT("report", "calibration certificate of each instrument"), stated::certificate},
    CircularStatement{"calibrationDate",  REPORT_TEXT("report", "calibration date of each instrument"), stated::calibrationDate},
    CircularStatement{"centre",           REPORT_TEXT("report", "location of the instrument: centre of the circle"), centreStated},
    CircularStatement{"toolOffset",       REPORT_TEXT("report", "location of the instrument: offset to the tool reference"), toolOffsetStated},
    CircularStatement{"workpieceOffset",  REPORT_TEXT("report", "location of the instrument: offset to the workpiece reference"), workpieceOffsetStated},
    CircularStatement{"sensors",          REPORT_TEXT("report", "temperature of the machine at start and end"), temperatureStated<SensorMeasures::machine>},
    CircularStatement{"sensors",          REPORT_TEXT("report", "temperature of the instrument at start and end"), temperatureStated<SensorMeasures::instrument>},
    CircularStatement{"sensors",          REPORT_TEXT("report", "temperature of the air at start and end"), temperatureStated<SensorMeasures::air>},
    CircularStatement{"expansion",        REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument"), expansionStated},
    CircularStatement{"correctionTo20",   REPORT_TEXT("report", "correction of F and D to 20 °C"), correctionStated},
    CircularStatement{"startPoint",       REPORT_TEXT("report", "start point"), startPointStated},
    CircularStatement{"stopPoint",        REPORT_TEXT("report", "stop point"), stopPointStated},
    CircularStatement{"smoothing",        REPORT_TEXT("report", "data smoothing"), smoothingStated},
    CircularStatement{"recentredBetweenRuns", REPORT_TEXT("report", "measured one after the other without re-centring"), recentringStated},
    CircularStatement{"compensation",     REPORT_TEXT("report", "compensation active during the test"), stated::common<&Conditions::compensation>},
    CircularStatement{"otherAxes",        REPORT_TEXT("report", "position of the axes not under test"), stated::common<&Conditions::otherAxes>},
    CircularStatement{"warmUp",           REPORT_TEXT("report", "warm-up done"), stated::warmUp},
};

// clang-format on

} // namespace

const CircularRules &rules1996() {
    static constexpr CircularRules rules{rows1996, requirementsWithoutClauses, allStatements};
    return rules;
}

const CircularRules &rules2005() {
    static constexpr CircularRules rules{rows2005, requirements2005, allStatements};
    return rules;
}

const CircularRules &rules2022() {
    static constexpr CircularRules rules{rows2022, requirementsWithoutClauses, allStatements};
    return rules;
}

} // namespace palmer::iso230_4
