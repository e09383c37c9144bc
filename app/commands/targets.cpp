// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "document/plannedtest.h"
#include "document/writedocument.h"
#include "export/answersjson.h"
#include "export/partprogram.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/measurement/testfacts.h"
#include "print/pdf/writepdf.h"
#include "report/blocks/plaintext.h"
#include "report/planreport.h"

#include <QBuffer>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace palmer {

namespace {

constexpr std::array targetsOptions{
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it the first")},
    Option{"axis", "X", REPORT_TEXT("report", "name of the axis")},
    Option{"travel", "1000",
           REPORT_TEXT("report", "travel of the axis, mm; of rotary axes degrees. With --range what is "
                                 "measured of it")},
    Option{"rotary", "", REPORT_TEXT("report", "a rotary axis")},
    Option{"from", "0", REPORT_TEXT("report", "where the travel begins")},
    Option{"range", "FROM:TO", REPORT_TEXT("report", "the ends of the axis; without it those of the travel")},
    Option{"zone", "FROM:TO",
           REPORT_TEXT("report", "the zone that has the full test of an axis of more than 2 000 mm (360°); "
                                 "without it in the middle")},
    Option{"per-metre", "5", REPORT_TEXT("report", "targets per metre")},
    Option{"period", "10", REPORT_TEXT("report", "period of the cyclic errors (pitch), where it is known")},
    Option{"decimals", "3", REPORT_TEXT("report", "decimals of the positions")},
    Option{"seed", "N",
           REPORT_TEXT("report", "start of the random numbers: the same gives the same targets")},
    Option{"edition", "E",
           REPORT_TEXT("report", "whose rule chooses the targets; without it ISO 230-2:2014")},
    Option{"cycle", "standard|step", REPORT_TEXT("report", "the measuring cycle")},
    Option{"runs", "5", REPORT_TEXT("report", "runs each way; without it as the standard asks")},
    Option{"feed", "F", REPORT_TEXT("report", "feed rate, mm/min or °/min; without it rapid feed")},
    Option{"dwell", "S", REPORT_TEXT("report", "rest at each target, s; without it 5")},
    Option{"approach", "D", REPORT_TEXT("report", "distance beyond the ends, mm or degrees; without it 1")},
    Option{"program", "iso|siemens|heidenhain|linuxcnc|haas",
           REPORT_TEXT("report",
                       "writes the part program in this dialect instead of the plan; of a long axis "
                       "a second one, of its zone, into OUT-zone")},
    Option{"o", "OUT",
           REPORT_TEXT("report", "the file to write: the plan as text, as .pdf or as .palmer to fill in; "
                                 "or the part program")},
    Option{"json", "", REPORT_TEXT("report", "the plan as JSON; without -o on standard output")},
    forceOption,
};

// The program that a control executes.
constexpr double smallestMotion = 0.001;
constexpr double mostFeed = 1e6;      ///< mm/min, °/min
constexpr double mostDwell = 3600;    ///< s
constexpr double mostApproach = 1000; ///< mm, degrees

/// The value of an option, which must be greater than a bound.
std::optional<double> number(const Invocation &invocation, const char *option, double greaterThan) {
    const auto given = invocation.value(option);
    return given ? std::optional(numberAbove(option, *given, greaterThan)) : std::nullopt;
}

std::optional<int> whole(const Invocation &invocation, const char *option, int least, int most) {
    const auto given = invocation.value(option);
    return given ? std::optional(static_cast<int>(wholeBetween(option, *given, least, most))) : std::nullopt;
}

/// The initial plan: that of a test of the file, or a new one.
struct Begun {
    TargetRequest request;
    CycleProgram program;
    const Edition *edition = &defaultEdition(Kind::positioning);
    bool isOfFile = false;
};

Begun begun(const Invocation &invocation) {
    Begun result;
    if (invocation.arguments.isEmpty()) {
        if (invocation.has("test"))
            refuseEffect("--test", "FILE");
        return result;
    }
    if (invocation.arguments.size() > 1)
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one file"), {std::string("targets")}});
    const Document document = documentFrom(invocation.arguments.front(), invocation);
    const Test &test = *document.tests[testIndex(invocation, document.tests.size())];
    if (kindOf(test) != Kind::positioning)
        throw UsageError({REPORT_TEXT("report", "only of a positioning test targets are planned"), {}});
    std::tie(result.request, result.program) = plannedFor(test);
    if (const Edition *edition = findEdition(test.edition))
        result.edition = edition;
    result.isOfFile = true;
    return result;
}

std::optional<Interval> interval(const Invocation &invocation, const char *option) {
    const auto given = invocation.value(option);
    return given ? std::optional(intervalGiven(option, *given)) : std::nullopt;
}

/// The travel lies within the range of the axis, leaving the approach distance at both ends.
TargetRequest request(const Invocation &invocation, const Begun &begun, double approach) {
    TargetRequest result = begun.request;
    result.rule = begun.edition->targetRule;
    if (invocation.has("rotary"))
        result.motion = Motion::rotary;
    result.perMetre = number(invocation, "per-metre", 0).value_or(result.perMetre);
    if (const auto period = number(invocation, "period", 0))
        result.period = period;
    result.decimals = whole(invocation, "decimals", 0, 9).value_or(result.decimals);
    result.seed =
        static_cast<std::uint64_t>(seedOf(invocation).value_or(static_cast<long long>(result.seed)));
    const auto travel = number(invocation, "travel", 0);
    const auto from = numberOf(invocation, "from");
    const auto range = interval(invocation, "range");
    if (begun.isOfFile && !travel && !range && !from)
        return result;
    if (!travel && !range)
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 needs --%2"), {std::string("targets"), "travel"}});
    const double begin = from.value_or(0);
    result = withinAxis(result, range.value_or(Interval{begin, begin + travel.value_or(0)}), approach);
    if (!range || (!travel && !from))
        return result;
    const double end = result.from + result.travel;
    result.from = from.value_or(result.from);
    result.travel = travel.value_or(end - result.from);
    constexpr double rounding = 1e-9;
    if (result.from < range->from + approach - rounding ||
        result.from + result.travel > range->to - approach + rounding)
        throw UsageError(
            {REPORT_TEXT("report", "between the ends of the axis (--range) is no room for the travel "
                                   "and for the approach distance before and behind it"),
             {}});
    return result;
}

/// The zone lies on the axis: within the measurement travel and the approach distance before and behind it.
std::optional<Interval> zoneAsked(const Invocation &invocation, const TargetRequest &request,
                                  double approach) {
    const auto zone = interval(invocation, "zone");
    constexpr double rounding = 1e-9;
    const Interval axis{request.from - approach, request.from + request.travel + approach};
    if (zone && (zone->from < axis.from - rounding || zone->to > axis.to + rounding)) {
        const Quantity position = request.motion == Motion::rotary ? Quantity::angle : Quantity::position;
        throw UsageError({REPORT_TEXT("report", "--zone reaches beyond the axis, which goes from %1 to %2"),
                          {Number{axis.from, position}, Number{axis.to, position}}});
    }
    return zone;
}

QByteArray planned(std::span<const PlannedMeasurement> plans, const CycleProgram &program,
                   const Invocation &invocation, const Edition &edition, const QString &ending) {
    if (ending == QLatin1StringView("palmer")) {
        Document document;
        document.writtenBy = "Palmer " PALMER_VERSION;
        for (const PlannedMeasurement &one : plans)
            document.tests.push_back(std::make_shared<const Test>(
                plannedTest(one.request, one.plan, programOf(one, program), edition.word)));
        return writeDocument(document);
    }
    const Report report = composePlan(plans, program, invocation.language);
    if (ending != QLatin1StringView("pdf"))
        return plainText(report).toUtf8();
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    writePdf(report, pdf);
    return pdf.data();
}

CycleProgram program(const Invocation &invocation, CycleProgram result, double approach, int runs) {
    if (const auto axis = invocation.value("axis"))
        result.axis = axis->trimmed().toStdString();
    if (const auto cycle = invocation.value("cycle"))
        result.cycle = *cycle == QLatin1StringView("step") ? Cycle::step : Cycle::standard;
    result.runs = whole(invocation, "runs", 1, 1000).value_or(runs);
    const auto between = [&](const char *option, double most) -> std::optional<double> {
        const auto given = invocation.value(option);
        return given ? std::optional(numberBetween(option, *given, smallestMotion, most)) : std::nullopt;
    };
    if (const auto feed = between("feed", mostFeed))
        result.feed = feed;
    result.dwell = between("dwell", mostDwell).value_or(result.dwell);
    result.approach = approach;
    return result;
}

/// The files to write: the plan, or the part program of each measurement.
std::vector<std::pair<QString, QByteArray>> filesOf(const Invocation &invocation, const QString &output,
                                                    std::span<const PlannedMeasurement> plans,
                                                    const CycleProgram &cycle, const Edition &edition) {
    const auto chosen = dialectOf(invocation, "program");
    const QString ending = QFileInfo(output).suffix().toLower();
    if (!chosen) {
        requireOutput(invocation, output, {"palmer", "pdf", "txt"});
        return {{output, planned(plans, cycle, invocation, edition, ending)}};
    }
    if (plans.size() > 1 && isStandardOutput(output))
        throw UsageError({REPORT_TEXT("report", "standard output takes one part program, and the zone has "
                                                "its own; write them into files")});
    std::vector<std::pair<QString, QByteArray>> files;
    for (const PlannedMeasurement &one : plans) {
        QString path = output;
        if (one.request.zone)
            path.insert(output.size() - (ending.isEmpty() ? 0 : ending.size() + 1), QStringLiteral("-zone"));
        requireOutput(invocation, path, programEndings);
        try {
            files.emplace_back(path, partProgram(programOf(one, cycle), *chosen, invocation.language));
        } catch (const Error &error) {
            throw UsageError(error.message);
        }
    }
    return files;
}

int writeTargets(const Invocation &invocation) {
    const bool asJson = invocation.has("json");
    const QString output = asJson ? invocation.value("o").value_or(QStringLiteral("-"))
                                  : neededOutput(invocation, "targets", "-o OUT");
    Begun base = begun(invocation);
    if (const Edition *asked = editionAsked(invocation, Kind::positioning))
        base.edition = asked;
    const auto givenApproach = invocation.value("approach");
    const double approach = givenApproach
                                ? numberBetween("approach", *givenApproach, smallestMotion, mostApproach)
                                : base.program.approach;
    const TargetRequest asked = request(invocation, base, approach);
    const auto plans = planMeasurements(asked, zoneAsked(invocation, asked, approach));
    const bool isEmpty = plans.empty() || plans.back().plan.targets.empty();
    if (isEmpty)
        throw UsageError(
            {REPORT_TEXT("report", "these numbers give no plan: too many targets, or too few decimals "
                                   "to tell them apart"),
             {}});
    const Motion motion = plans.empty() ? Motion::linear : plans.front().request.motion;
    if (plans.size() == 1 && invocation.has("zone"))
        refuseEffect("--zone", "--travel > " + std::to_string(std::lround(longestShort(motion))));
    const CycleProgram cycle =
        programOf(plans.front(), program(invocation, base.program, approach, plans.front().plan.runs));
    if (asJson) {
        if (invocation.has("program"))
            throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                              {std::string("json"), std::string("program")}});
        requireOutput(invocation, output, {"json"});
        return written(invocation, {{targetsJson(plans, cycle, base.edition->word), output}});
    }
    for (const auto &[path, bytes] : filesOf(invocation, output, plans, cycle, *base.edition)) {
        if (const int code = written(invocation, {{bytes, path}}); code != done)
            return code;
    }
    return done;
}

int runTargets(const Invocation &invocation) {
    return codeOf(invocation.arguments.value(0), invocation.language,
                  [&] { return writeTargets(invocation); });
}

} // namespace

Command targetsCommand() {
    return {"targets",
            "[FILE]",
            REPORT_TEXT("report",
                        "plans the targets of a positioning test, writes the part program; with FILE as "
                        "its test states axis and cycle"),
            targetsOptions,
            runTargets,
            true};
}

} // namespace palmer
