// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/editions.h"

#include "kernel/evaluation/commonchecks.h"
#include "kernel/evaluation/iso230_4/checks.h"
#include "kernel/evaluation/iso230_4/parameters.h"
#include "kernel/evaluation/laboratory.h"
#include "kernel/evaluation/stated.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palmer::iso230_4 {

namespace {

constexpr auto mainRow = Weight::main;
constexpr auto detail = Weight::detail;
constexpr auto always = Printed::always;
constexpr auto arc = Of::path;
constexpr auto pair = Of::pair;
constexpr auto circularDeviation = OfCircle::deviation;
constexpr auto radial = OfCircle::radialDeviation;
constexpr auto meanRadial = OfCircle::meanRadialDeviation;
constexpr auto hysteresisOfPair = OfCircle::hysteresis;
constexpr bool measured = true; ///< by an external instrument
constexpr bool feedback = false;
constexpr bool at20 = true;
constexpr auto shall = Grade::requirement;
constexpr auto should = Grade::recommendation;
constexpr auto info = Grade::note;
constexpr auto missingValues = Explains::missingValues;

using common::ofConditions;
using common::ofDeclared;
using common::statingConditions;
using enum Source;
using enum Subject;
using Row = CircularRequirement;

// clang-format off

// ---- Results, in the order of print ------------------------------------------------------------------------------

constexpr std::array rows2005{
    CircularRow{{"G(b)",  {"G(b)"},     REPORT_TEXT("report", "bi-directional circular deviation"), "3.3", "G", {REPORT_TEXT_FOR("report", "bi-directional", "circular deviation"), REPORT_TEXT("report", "bi-directional circular deviation")}, mainRow, always, pair, circularDeviation}, measured, false, deviationOfPair},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular deviation"), "3.4", "G", {}, mainRow, always, arc, circularDeviation}, measured, false, deviationOfPath},
    CircularRow{{"D",     {"D"},        REPORT_TEXT("report", "mean bi-directional radial deviation"), "3.6", "D", {REPORT_TEXT_FOR("report", "mean radial", "deviation"), REPORT_TEXT("report", "mean bi-directional radial deviation")}, mainRow, always, pair, meanRadial}, measured, at20, meanRadialDeviation},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial deviation, maximum"), "3.5", "F", {}, detail, always, arc, radial, Bound::upper, "F"}, measured, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial deviation, minimum"), "3.5", "F", {}, detail, always, arc, radial, Bound::lower, "F"}, measured, at20, smallestRadialDeviation},
    CircularRow{{"G(b)f", {"G(b)", "f"}, REPORT_TEXT("report", "bi-directional circular deviation using feed back signal"), "", "G", {REPORT_TEXT("report", "bi-directional, feed back"), {}, REPORT_TEXT_FOR("report", "bi-directional", "circular deviation")}, mainRow, always, pair, circularDeviation}, feedback, false, deviationOfPair},
    CircularRow{{"Gf",    {"G", "f"},   REPORT_TEXT("report", "circular deviation using feed back signal"), "", "G", {}, mainRow, always, arc, circularDeviation}, feedback, false, deviationOfPath},
};

constexpr std::array rows2022{
    CircularRow{{"G(b)",  {"G(b)"},     REPORT_TEXT("report", "bi-directional circular error"), "", "G", {REPORT_TEXT_FOR("report", "bi-directional", "circular error"), REPORT_TEXT("report", "bi-directional circular error")}, mainRow, always, pair, circularDeviation}, measured, false, deviationOfPair},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular error"), "", "G", {}, mainRow, always, arc, circularDeviation}, measured, false, deviationOfPath},
    CircularRow{{"D",     {"D"},        REPORT_TEXT("report", "mean bi-directional radial error"), "", "D", {REPORT_TEXT_FOR("report", "mean radial", "error"), REPORT_TEXT("report", "mean bi-directional radial error")}, mainRow, always, pair, meanRadial}, measured, at20, meanRadialDeviation},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial error, maximum"), "", "F", {}, detail, always, arc, radial, Bound::upper, "F"}, measured, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial error, minimum"), "", "F", {}, detail, always, arc, radial, Bound::lower, "F"}, measured, at20, smallestRadialDeviation},
    CircularRow{{"G(b)f", {"G(b)", "f"}, REPORT_TEXT("report", "bi-directional circular error using feed back signal"), "", "G", {REPORT_TEXT("report", "bi-directional, feed back"), {}, REPORT_TEXT_FOR("report", "bi-directional", "circular error")}, mainRow, always, pair, circularDeviation}, feedback, false, deviationOfPair},
    CircularRow{{"Gf",    {"G", "f"},   REPORT_TEXT("report", "circular error using feed back signal"), "", "G", {}, mainRow, always, arc, circularDeviation}, feedback, false, deviationOfPath},
};

constexpr std::array rows1996{
    CircularRow{{"H",     {"H"},        REPORT_TEXT("report", "circular hysteresis"), "", "H", {}, mainRow, always, pair, hysteresisOfPair}, measured, false, hysteresis},
    CircularRow{{"G",     {"G"},        REPORT_TEXT("report", "circular deviation"), "", "G", {}, mainRow, always, arc, circularDeviation}, measured, false, deviationOfPath},
    CircularRow{{"Fmax",  {"F", "max"}, REPORT_TEXT("report", "radial deviation, maximum"), "", "F", {}, detail, always, arc, radial, Bound::upper, "F"}, measured, at20, largestRadialDeviation},
    CircularRow{{"Fmin",  {"F", "min"}, REPORT_TEXT("report", "radial deviation, minimum"), "", "F", {}, detail, always, arc, radial, Bound::lower, "F"}, measured, at20, smallestRadialDeviation},
};

// ---- Requirements, in the order of the printed standard ------------------------------------------------------------

constexpr std::array text2005{
    Row{"scope", text, "1", shall, conditions, nullptr, unless<rotaryAxis>, {}, {}, {"plane"}},
    Row{"arcs", text, "3.1", shall, readings, nullptr, unless<shortArc>, {}, {}, {"arcs"}},
    Row{"centring", text, "3.5", shall, readings, nullptr, unless<leastSquaresOfPartialArc>, {}, {}, {"centring"}, missingValues},
    Row{"setUpCentring", text, "3.5, Table A.1", info, readings, nullptr, unless<setUpCentring>, {}, {}, {"centring"}},
    Row{"fullCircles", text, "3.6", shall, readings, nullptr, unless<partialArcsForD>, {}, {}, {"arcs"}, missingValues},
    Row{"temperature", text, "4.1", shall, conditions, common::controllable, temperature,
        REPORT_TEXT("report", "temperature of the environment"), {}, {"conditions.sensors", "conditions.temperatureControlled"}},
    Row{"correctionTo20", text, "4.1, 6 d", shall, conditions, needsF, correction,
        REPORT_TEXT("report", "correction to 20 °C"), {}, {"conditions.correctionTo20"}},
    Row{"correctionTo20", text, "4.1, 6 b", shall, conditions, needsOnlyD, correction,
        REPORT_TEXT("report", "correction to 20 °C"), {}, {"conditions.correctionTo20"}},
    Row{"soak", text, "4.1", shall, conditions, nullptr, ofDeclared<&Conditions::stabilised>,
        REPORT_TEXT("report", "thermal stability before the test"),
        REPORT_TEXT("report", "Machine or instruments were not thermally stable."), {"conditions.stabilised", "conditions.soak"}},
    Row{"shielded", text, "4.1", shall, conditions, nullptr, ofDeclared<&Conditions::shielded>,
        REPORT_TEXT("report", "protection from draughts and radiation"),
        REPORT_TEXT("report", "Not protected from draughts or radiation."), {"conditions.shielded"}},
    Row{"complete", text, "4.2", shall, conditions, nullptr, ofDeclared<&Conditions::complete>,
        REPORT_TEXT("report", "machine complete and in working order"),
        REPORT_TEXT("report", "The machine was not complete or not in working order."), {"conditions.complete"}},
    Row{"levelled", text, "4.2", shall, conditions, nullptr, ofDeclared<&Conditions::levelled>,
        REPORT_TEXT("report", "levelling and functional checks"),
        REPORT_TEXT("report", "Levelling or functional checks were not done."), {"conditions.levelled"}},
    Row{"unloaded", text, "4.2", shall, conditions, nullptr, ofDeclared<&Conditions::unloaded>,
        REPORT_TEXT("report", "machine unloaded"), REPORT_TEXT("report", "The machine was loaded."), {"conditions.unloaded"}},
    Row{"warmUp", text, "4.3", shall, conditions, nullptr, ofConditions<common::warmUpOrSetUp>,
        REPORT_TEXT("report", "warm-up: by whom specified"),
        REPORT_TEXT("report", "Dry run without agreed warm-up: only set-up movements are allowed."), {"conditions.warmUp"}},
    Row{"referenceLength", text, "4.5", shall, conditions, needsLength, referenceLength,
        REPORT_TEXT("report", "calibrated reference length"), {}, {"referenceLength"}, missingValues},
    Row{"bothSenses", text, "5", shall, readings, nullptr, bothSenses,
        REPORT_TEXT("report", "which of the results are required"), {}, {"requiredResults"}, missingValues},
    Row{"consecutive", text, "5", shall, readings, nullptr, unless<notConsecutive>, {}, {}, {"arcs"}},
    Row{"allPoints", text, "5", shall, readings, nullptr, allPoints,
        REPORT_TEXT("report", "what the evaluated range leaves out"), {}, {"arcs.cutOff"}},
    Row{"setUp", text, "5", should, Subject::uncertainty, partialF, stating<centringUncertaintyStated>,
        REPORT_TEXT("report", "set-up error"), {}, {"uncertainty.centring"}},
    Row{"uncertainty", text, "6", should, Subject::uncertainty, nullptr, common::uncertaintyStated,
        REPORT_TEXT("report", "test uncertainty"), {}, {"uncertainty"}, Explains::missingUncertainty},
    Row{"contouringFeed", text, "Annex C", info, conditions, nullptr, unless<otherContouringFeed>, {}, {}, {"specified"}},
    Row{"requiredResults", text, "Annex D", shall, limits, nullptr, unless<lengthOfFeedback>, {}, {}, {"requiredResults"}},
    Row{"source", text, "Annex D", info, conditions, nullptr, unless<feedbackSignal>, {}, {}, {"positionFeedback"}},
};

constexpr Row statement(const char *id, const char *clause, Subject subject, bool (*applies)(const CircularCase &), Judgement (*judge)(const CircularCase &),
                        Text name, const char *key) {
    return {id, text, clause, shall, subject, applies, judge, name, {}, {key}};
}

/// Statements required in the report: date, machine, measuring equipment and the parameters of the test.
constexpr std::array statements2005{
    statement("date", "6", conditions, nullptr, stating<stated::date<CircularCase>>, REPORT_TEXT("report", "date of the test"), "date"),
    statement("machineName", "6", machine, nullptr, stating<laboratory::named<CircularCase>>, REPORT_TEXT("report", "name of the machine"), "machine.name"),
    statement("instruments", "6", namedInstruments, external, stating<stated::instruments<CircularCase>>, REPORT_TEXT("report", "instrument"), "instruments"),
    statement("feed", "6 (4.4 b)", conditions, nullptr, stating<feedStated>, REPORT_TEXT("report", "contouring feed"), "feed"),
    statement("plane", "6 (4.4 d)", conditions, nullptr, stating<planeStated>, REPORT_TEXT("report", "axes moved"), "plane"),
    statement("centre", "6 (4.4 e)", conditions, external, stating<locationStated>, REPORT_TEXT("report", "location of the measuring instrument"), "conditions.centre"),
    statement("sensors", "6 (4.4 f)", conditions, needsLength, temperaturesStated, REPORT_TEXT("report", "temperatures of machine, instrument and air"), "conditions.sensors"),
    statement("expansion", "6 (4.4 f)", conditions, needsLength, ofConditions<common::expansionStated>, REPORT_TEXT("report", "coefficients of thermal expansion of machine and instrument"), "conditions.expansion"),
    statement("startPoint", "6 (4.4 g)", conditions, nullptr, stating<stated::condition<&CircularConditions::startPoint, CircularCase>>, REPORT_TEXT("report", "start point"), "conditions.startPoint"),
    statement("stopPoint", "6 (4.4 g)", conditions, nullptr, stating<stated::condition<&CircularConditions::stopPoint, CircularCase>>, REPORT_TEXT("report", "stop point"), "conditions.stopPoint"),
    statement("smoothing", "6 (4.4 g)", conditions, nullptr, stating<stated::condition<&CircularConditions::smoothing, CircularCase>>, REPORT_TEXT("report", "data smoothing"), "conditions.smoothing"),
    statement("compensation", "6 (4.4 h)", conditions, nullptr, stating<stated::common<&Conditions::compensation, CircularCase>>, REPORT_TEXT("report", "compensation active during the test"), "conditions.compensation"),
    statement("otherAxes", "6 (4.4 i)", conditions, nullptr, ofConditions<common::otherAxes>, REPORT_TEXT("report", "position of the axes not under test"), "conditions.otherAxes"),
};

constexpr Row laboratoryRow(const char *id, bool (*applies)(const CircularCase &), Judgement (*judge)(const CircularCase &), Text name, const char *key) {
    return {id, Source::laboratory, "", info, conditions, applies, judge, name, {}, {key}};
}
constexpr std::array laboratoryRows{
    laboratoryRow("positionFeedback", external, stating<stated::ofMeasurement<&CircularMeasurement::positionFeedback, CircularCase>>, REPORT_TEXT("report", "measuring system of the axes"), "positionFeedback"),
    laboratoryRow("offsets", external, ofConditions<common::offsetsStated>, REPORT_TEXT("report", "offset of the measuring line to the tool and workpiece reference"), "conditions.toolOffset"),
    laboratoryRow("sensorPositions", needsLength, statingConditions<common::machineSensorsPlaced>, REPORT_TEXT("report", "position of the temperature sensors"), "conditions.sensors"),
    laboratoryRow("correctionTo20", needsLength, stating<stated::common<&Conditions::correctionTo20, CircularCase>>, REPORT_TEXT("report", "type of compensation"), "conditions.correctionTo20"),
};

constexpr Row programRow(const char *id, Subject subject, Judgement (*judge)(const CircularCase &),
                         Explains explains = Explains::nothing) {
    return {id, program, "", info, subject, nullptr, judge, {}, {}, {}, explains};
}
constexpr std::array programRows{
    programRow("arcs", readings, unless<noArcs>, missingValues),
    programRow("arcs", readings, unless<anglesAgainstSense>),
    programRow("arcs", readings, unless<largeDeviations>),
    programRow("fullCircles", readings, unless<partialArcsForH>, missingValues),
    programRow("fullCircles", readings, unless<unaskedD>, missingValues),
    programRow("centring", readings, unless<unaskedF>, missingValues),
    programRow("minimumZone", readings, unless<noCircle>, missingValues),
    programRow("minimumZone", readings, unless<notCertified>),
    programRow("leastSquares", readings, unless<noLeastSquaresCircle>, missingValues),
    programRow("plane", conditions, unless<leftHandedPlane>),
    programRow("recentredBetweenRuns", conditions, unless<recentred>),
    programRow("correctionTo20", conditions, unless<correctionImpossible>),
};

// clang-format on

using Rows = std::span<const Row>;

std::vector<Row> table(std::initializer_list<Rows> parts,
                       std::initializer_list<std::string_view> without = {}) {
    std::vector<Row> result;
    for (const Rows part : parts) {
        for (const Row &row : part) {
            if (std::find(without.begin(), without.end(), row.id) == without.end())
                result.push_back(row);
        }
    }
    return result;
}

/// If the text was not read, statements are laboratory practice and the other rows are practice of the field.
std::vector<Row> asLaboratory(std::initializer_list<std::string_view> without) {
    const std::vector<Row> rows = asPractice(Rows(text2005), without);
    std::vector<Row> statements(statements2005.begin(), statements2005.end());
    for (Row &row : statements) {
        row.source = Source::laboratory;
        row.clause = "";
        row.modality = info;
    }
    return table({rows, statements, table({laboratory::rows<CircularCase>()}, {"date", "machineName"}),
                  laboratoryRows, table({laboratory::instrumentRows<CircularCase>()}, {"instruments"}),
                  laboratory::checks<CircularCase>(), programRows});
}

const CircularRules &rules1996() {
    static const std::vector<Row> requirements = asLaboratory({"uncertainty", "fullCircles"});
    static const CircularRules rules{rows1996, requirements};
    return rules;
}

const CircularRules &rules2005() {
    static const std::vector<Row> requirements =
        table({text2005, statements2005, table({laboratory::rows<CircularCase>()}, {"date", "machineName"}),
               laboratoryRows, table({laboratory::instrumentRows<CircularCase>()}, {"instruments"}),
               laboratory::checks<CircularCase>(), programRows});
    static const CircularRules rules{rows2005, requirements};
    return rules;
}

const CircularRules &rules2022() {
    static const std::vector<Row> requirements = asLaboratory({});
    static const CircularRules rules{rows2022, requirements};
    return rules;
}

// ---- Editions
// -------------------------------------------------------------------------------------------------

constexpr Text title =
    REPORT_TEXT("report", "Test code for machine tools — Part 4: Circular tests for numerically controlled "
                          "machine tools");

PointRole warmUpPoint(const Test &test) {
    const Conditions *conditions = conditionsOf(test);
    return conditions && conditions->warmUp.specifiedBy == SpecifiedBy::maker ? PointRole::notApplicable
                                                                              : PointRole::listed;
}

constexpr std::array points2005{
    AgreementPoint{"warmUp", "a", REPORT_TEXT("report", "warm-up"), warmUpPoint},
    AgreementPoint{"testParameters", "b", REPORT_TEXT("report", "test parameters")},
    AgreementPoint{"results", "c", REPORT_TEXT("report", "which of the results are required")},
};

/// The same for editions whose text was not read: no letters.
constexpr auto pointsOfOthers = [] {
    auto result = points2005;
    for (AgreementPoint &point : result)
        point.letter = "";
    return result;
}();

Edition unread(const char *word, const CircularRules &rules) {
    return {
        .word = word, .family = word, .kind = Kind::circular, .points = pointsOfOthers, .circles = &rules};
}

Edition iso2005() {
    return {.word = "ISO 230-4:2005",
            .family = "ISO 230-4:2005",
            .kind = Kind::circular,
            .title = title,
            .isDefault = true,
            .textRead = TextRead::all,
            .points = points2005,
            .pointsClause = "7",
            .parametersClause = "4.4",
            .circles = &rules2005()};
}

} // namespace

std::span<const Edition> editions() {
    static const std::vector<Edition> table{
        unread("ISO 230-4:1996", rules1996()),
        iso2005(),
        unread("ISO 230-4:2022", rules2022()),
    };
    return table;
}

} // namespace palmer::iso230_4
