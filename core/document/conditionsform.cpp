// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/conditionsform.h"

#include "document/fieldvalue.h"
#include "kernel/evaluation/accordance.h"
#include "kernel/evaluation/asked.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// Where a cell stands: by what asks for it, or always in one place.
enum class Standing { byAsked, asked, usual };

struct FormRow {
    Text group; ///< empty: that of the row before
    FormCell cell;
    Standing place = Standing::byAsked;
    bool (*offered)(const Test &) = nullptr; ///< null: to all tests whose kind has the key
};

const PositioningMeasurement *axisTest(const Test &test) {
    return std::get_if<PositioningMeasurement>(&test.measurement);
}
bool ofAxis(const Test &test) {
    return axisTest(test);
}
bool linear(const Test &test) {
    return ofAxis(test) && motionOf(test) == Motion::linear;
}
bool longAxis(const Test &test) {
    return ofAxis(test) && (isLongAxis(*axisTest(test)) || axisTest(test)->zone);
}
bool chosenFreely(const Test &test) {
    const auto *axis = axisTest(test);
    const auto kind = axis ? axis->targetChoice.kind : TargetChoiceKind::fixed;
    return axis && (kind == TargetChoiceKind::free || kind == TargetChoiceKind::notStated ||
                    axis->targetChoice.interval || axis->targetChoice.period);
}
bool polygon(const Test &test) {
    const auto *axis = axisTest(test);
    return axis && (axis->targetChoice.kind == TargetChoiceKind::polygon || axis->targetChoice.faces);
}
bool rangeMethod(const Test &test) {
    const Edition *edition = findEdition(test.edition);
    return ofAxis(test) &&
           ((edition && edition->rangeMethod) || axisTest(test)->standardDeviation == DeviationMethod::range);
}
bool rotary(const Test &test) {
    return ofAxis(test) && motionOf(test) == Motion::rotary;
}

bool withAnother(const Test &) {
    return false;
}

// clang-format off
const std::array rows{
    FormRow{REPORT_TEXT("report", "Test"), {"title", "", 5, REPORT_TEXT("report", "Title of the test")}, Standing::asked},
    FormRow{{}, {"purpose", "", 4}, Standing::asked},
    FormRow{{}, {"role", "", 3, REPORT_TEXT("report", "Role")}, Standing::asked},
    FormRow{{}, {"date", "", 4}, Standing::asked},
    FormRow{{}, {"time", "", 3, REPORT_TEXT("report", "Time of day")}, Standing::asked},
    FormRow{{}, {"instruments", "", 6}, Standing::asked},
    FormRow{REPORT_TEXT("report", "Axis"), {"name", "", 2, REPORT_TEXT("report", "Axis")}, Standing::asked, ofAxis},
    FormRow{{}, {"travel", "", 3}, Standing::asked, ofAxis},
    FormRow{{}, {"range", "", 4}, Standing::asked, ofAxis},
    FormRow{{}, {"positionFeedback", "", 3, REPORT_TEXT("report", "Measuring system")}, Standing::asked, ofAxis},
    FormRow{{}, {"zone", "", 5}, Standing::asked, longAxis},
    FormRow{{}, {"scaleElement", "", 5, REPORT_TEXT("report", "Element of the scale (0: continuous)")}, Standing::byAsked, linear},
    FormRow{{}, {"positionFeedback", "", 6, REPORT_TEXT("report", "Measuring system")}, Standing::asked, isCircle},
    FormRow{{}, {"referenceLength", "", 6, REPORT_TEXT("report", "Reference length calibrated")}, Standing::byAsked, isCircle},
    FormRow{REPORT_TEXT("report", "Cycle"), {"cycle", "", 4}, Standing::asked, ofAxis},
    FormRow{{}, {"feedMode", "", 4}, Standing::asked},
    FormRow{{}, {"feed", "", 4}, Standing::asked, isJudged},
    FormRow{{}, {"dwell", "", 3}},
    FormRow{{}, {"approachDistance", "", 3, REPORT_TEXT("report", "Approach distance")}},
    FormRow{{}, {"startPoint", "", 4}},
    FormRow{{}, {"stopPoint", "", 4}},
    FormRow{{}, {"smoothing", "", 6}},
    FormRow{{}, {"compensation", "", 6}},
    FormRow{{}, {"recentredBetweenRuns", "", 6}},
    FormRow{{}, {"standardDeviation", "", 4, REPORT_TEXT("report", "Standard deviation")}, Standing::asked, rangeMethod},
    FormRow{{}, {"continuousDevice", "", 6}, Standing::byAsked, rotary},
    FormRow{{}, {"specified", "diameter", 4, REPORT_TEXT("report", "Specified diameter")}, Standing::byAsked, isCircle},
    FormRow{{}, {"specified", "feed", 4, REPORT_TEXT("report", "Specified feed")}, Standing::byAsked, isCircle},
    FormRow{REPORT_TEXT("report", "Targets"), {"targetChoice", "kind", 5}, Standing::asked, ofAxis},
    FormRow{{}, {"targetChoice", "interval", 3, REPORT_TEXT("report", "Nominal interval")}, Standing::asked, chosenFreely},
    FormRow{{}, {"targetChoice", "period", 4, REPORT_TEXT("report", "Period of the error")}, Standing::asked, chosenFreely},
    FormRow{{}, {"faces", "", 4, REPORT_TEXT("report", "Faces of the polygon, number")}, Standing::asked, polygon},
    FormRow{REPORT_TEXT("report", "Temperatures"), {"sensors", "", 12}, Standing::asked},
    FormRow{{}, {"expansion", "", 12}, Standing::asked, withAnother}, // in the table of the sensors
    FormRow{REPORT_TEXT("report", "Air"), {"correctionTo20", "", 5}, Standing::asked},
    FormRow{{}, {"gradientPerHour", "", 4}},
    FormRow{{}, {"gradientHoursBefore", "", 3, REPORT_TEXT("report", "Hours before")}},
    FormRow{{}, {"temperatureControlled", "", 6}},
    FormRow{{}, {"instrumentCompensation", "", 6}},
    FormRow{{}, {"airPressure", "", 3}},
    FormRow{{}, {"airHumidity", "", 3}},
    FormRow{REPORT_TEXT("report", "Warm-up"), {"warmUp", "kind", 5, REPORT_TEXT("report", "Kind of warm-up")}},
    FormRow{{}, {"warmUp", "text", 4, REPORT_TEXT("report", "Warm-up, details")}},
    FormRow{{}, {"warmUp", "by", 3, REPORT_TEXT("report", "Specified by")}},
    FormRow{{}, {"soak", "", 4}, Standing::usual},
    FormRow{REPORT_TEXT("report", "Positions"), {"instrumentPosition", "", 6}},
    FormRow{{}, {"otherAxes", "", 6}},
    FormRow{{}, {"centre", "0", 4, REPORT_TEXT("report", "Centre of the circle, X")}},
    FormRow{{}, {"centre", "1", 4, REPORT_TEXT("report", "Centre of the circle, Y")}},
    FormRow{{}, {"centre", "2", 4, REPORT_TEXT("report", "Centre of the circle, Z")}},
    FormRow{{}, {"toolOffset", "0", 4, REPORT_TEXT("report", "Offset to tool, X")}, Standing::usual},
    FormRow{{}, {"toolOffset", "1", 4, REPORT_TEXT("report", "Offset to tool, Y")}, Standing::usual},
    FormRow{{}, {"toolOffset", "2", 4, REPORT_TEXT("report", "Offset to tool, Z")}, Standing::usual},
    FormRow{{}, {"workpieceOffset", "0", 4, REPORT_TEXT("report", "Offset to workpiece, X")}, Standing::usual},
    FormRow{{}, {"workpieceOffset", "1", 4, REPORT_TEXT("report", "Offset to workpiece, Y")}, Standing::usual},
    FormRow{{}, {"workpieceOffset", "2", 4, REPORT_TEXT("report", "Offset to workpiece, Z")}, Standing::usual},
    FormRow{REPORT_TEXT("report", "To declare"), {"complete", "answer", 8}, Standing::asked},
    FormRow{{}, {"unloaded", "answer", 4}, Standing::asked},
    FormRow{{}, {"shielded", "answer", 8}, Standing::asked},
    FormRow{{}, {"allApply", "", 4}, Standing::asked},
    FormRow{{}, {"levelled", "answer", 6}, Standing::asked},
    FormRow{{}, {"stabilised", "answer", 6, REPORT_TEXT("report", "Thermally stable")}, Standing::asked},
    FormRow{REPORT_TEXT("report", "Machine"), {"load", "", 6}},
    FormRow{{}, {"thermalGuidelines", "", 6}},
    FormRow{REPORT_TEXT("report", "Axis"), {"motion", "", 4, REPORT_TEXT("report", "Motion")}, Standing::byAsked, ofAxis},
    FormRow{{}, {"referencePosition", "", 4}},
    FormRow{REPORT_TEXT("report", "Declaration"), {"declaredAccordance", "by", 7, REPORT_TEXT("report", "Rest of the requirements declared met by")}},
    FormRow{{}, {"declaredAccordance", "date", 5, REPORT_TEXT("report", "Declared on")}},
    FormRow{{}, {"declaredAccordance", "text", 12, REPORT_TEXT("report", "Text of the declaration")}},
    FormRow{REPORT_TEXT("report", "Remarks"), {"remarks", "", 12, REPORT_TEXT("report", "Remarks on the test")}},
};
// clang-format on

/// Keys of values that are part of the axis or of the form itself; all others are found under their own name.
bool isOffered(const FormRow &row, const Test &test, std::span<const std::string_view> conditions) {
    if (row.offered)
        return row.offered(test);
    constexpr std::array ofAnyTest{"title",  "purpose",     "role",     "date",
                                   "time",   "instruments", "allApply", "declaredAccordance",
                                   "remarks"};
    return std::ranges::find(ofAnyTest, row.cell.key) != ofAnyTest.end() ||
           std::ranges::find(conditions, row.cell.key) != conditions.end();
}

void add(std::vector<FormGroup> &groups, const Text &name, const FormCell &cell, bool lacks) {
    if (groups.empty() || groups.back().name.source != name.source)
        groups.push_back({name, {}, false});
    groups.back().cells.push_back(cell);
    groups.back().lacks = groups.back().lacks || lacks;
}

} // namespace

ConditionsForm conditionsForm(const Test &test, const TestEvaluation &evaluation) {
    ConditionsForm form;
    if (!conditionsOf(test))
        return form;
    const std::vector<AskedStatement> asked = askedStatements(test, evaluation);
    const bool onlyUsual = std::ranges::all_of(asked, &AskedStatement::usual);
    const std::vector<std::string_view> conditions = conditionKeys(test);
    const auto isMissing = [&](std::string_view key) {
        return std::ranges::any_of(evaluation.findings, [key](const Finding &finding) {
            return lackOf(finding) == Lack::required && finding.subject == Subject::conditions &&
                   !finding.keys.empty() &&
                   finding.keys.front().substr(finding.keys.front().rfind('.') + 1) == key;
        });
    };
    Text group;
    const auto place = [&](const FormRow &row) {
        if (!row.group.empty())
            group = row.group;
        if (!isOffered(row, test, conditions))
            return;
        const auto by = std::ranges::find(asked, row.cell.key, &AskedStatement::key);
        const bool isAsked = by != asked.end() && (!by->usual || onlyUsual);
        const bool isUsual = by != asked.end() && !isAsked;
        if (row.place == Standing::asked || (row.place == Standing::byAsked && isAsked))
            add(form.asked, group, row.cell, isAsked && isMissing(row.cell.key));
        else
            add(row.place == Standing::usual || isUsual ? form.usual : form.other, group, row.cell, false);
    };
    std::ranges::for_each(rows, place);
    for (const std::string_view key : conditions) {
        if (std::ranges::none_of(rows, [key](const FormRow &row) { return row.cell.key == key; }))
            place({REPORT_TEXT("report", "Further conditions"), {key, "", 6}});
    }
    return form;
}

std::vector<std::string_view> declarationKeys() {
    std::vector<std::string_view> keys;
    for (const FormRow &row : rows) {
        if (row.cell.part == "answer")
            keys.push_back(row.cell.key);
    }
    return keys;
}

std::string clauseOfDeclaration(const Edition &edition, std::string_view key) {
    const auto in = [key](const auto &requirements) -> std::string {
        for (const auto &row : requirements) {
            const std::string_view path = row.keys[0] ? row.keys[0] : "";
            if (path.substr(path.rfind('.') + 1) == key)
                return row.clause;
        }
        return {};
    };
    return edition.circles ? in(edition.circles->requirements) : in(edition.requirements);
}

} // namespace palmer
