// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/planreport.h"

#include "kernel/evaluation/edition.h"
#include "language/rounding.h"

#include <algorithm>

namespace palmer {
namespace {

constexpr int runsBeside = 5; ///< further runs are printed below

KeyValues head(const TargetRequest &request, const TargetPlan &plan, const CycleProgram &program,
               const Language &language) {
    const bool linear = request.motion == Motion::linear;
    const Quantity position = linear ? Quantity::position : Quantity::angle;
    KeyValues result;
    result.labelWidth = 48;
    const auto add = [&](const Text &key, const QString &value) {
        result.rows.push_back({language.text(key), value});
    };
    const Number from{request.from, position, -1};
    const Number to{request.from + request.travel, position, -1};
    add(REPORT_TEXT("report", "Axis"), QString::fromStdString(program.axis));
    add(REPORT_TEXT("report", "Measurement travel"),
        language.sentence(REPORT_TEXT("report", "%1 to %2"), {from, to}));
    if (request.zone)
        add(REPORT_TEXT("report", "Zone, to be agreed"),
            language.sentence(REPORT_TEXT("report", "%1 to %2"), {Number{request.zone->from, position, -1},
                                                                  Number{request.zone->to, position, -1}}));
    add(REPORT_TEXT("report", "Targets"),
        language.number(static_cast<double>(plan.targets.size()), Quantity::count));
    if (plan.ofTest) {
        if (plan.interval)
            add(REPORT_TEXT("report", "Nominal interval"),
                language.quantity(*plan.interval, position, request.decimals));
    } else if (!plan.interval) {
        add(REPORT_TEXT("report", "Quarter turns"),
            language.text(REPORT_TEXT("report", "all multiples of 90° within the travel")));
        add(REPORT_TEXT("report", "Further targets"),
            language.sentence(REPORT_TEXT("report", "one in each %1 of the travel, at random"),
                              {Number{plan.randomPart, position, request.decimals}}));
    } else {
        add(REPORT_TEXT("report", "Nominal interval"),
            language.quantity(*plan.interval, position, request.decimals));
        add(REPORT_TEXT("report", "Random part"),
            request.rule == TargetRule::pitches1988 && !plan.boundOf2006 && request.period
                ? language.sentence(REPORT_TEXT("report", "P = (N + r)·p, p = %1"),
                                    {Number{*request.period, position, -1}})
                : language.sentence(REPORT_TEXT("report", "± %1, new for every target"),
                                    {Number{plan.randomPart, position, request.decimals}}));
    }
    if (plan.boundOf2006)
        add(REPORT_TEXT("report", "Rule"),
            language.text(REPORT_TEXT("report", "that of ISO 230-2:2006: ISO 230-2:1988 has none for an "
                                                "unknown or long cyclic pitch")));
    if (!plan.ofTest)
        add(REPORT_TEXT("report", "Seed"), QString::number(request.seed));
    add(REPORT_TEXT("report", "Cycle"),
        language.text(program.cycle == Cycle::standard ? REPORT_TEXT("report", "standard test cycle")
                                                       : REPORT_TEXT("report", "step cycle")));
    add(REPORT_TEXT("report", "Runs each way"),
        language.number(program.runs, Quantity::count) +
            QLatin1StringView(!program.only                          ? ""
                              : *program.only == Direction::positive ? " ↑"
                                                                     : " ↓"));
    add(REPORT_TEXT("report", "Feed rate"),
        program.feed ? language.quantity(*program.feed, linear ? Quantity::feed : Quantity::angularFeed)
                     : language.text(REPORT_TEXT("report", "rapid feed")));
    add(REPORT_TEXT("report", "Dwell at each target"), language.quantity(program.dwell, Quantity::time));
    add(REPORT_TEXT("report", "Approach distance"), language.quantity(program.approach, position));
    return result;
}

/// Returns the letter of the editions that choose targets by this rule.
QString letterOfPlan(TargetRule rule) {
    const auto list = editionsOf(Kind::positioning);
    const auto found =
        std::ranges::find_if(list, [&](const Edition *edition) { return edition->targetRule == rule; });
    return QString::fromUtf8(found == list.end() ? "i" : (*found)->targetLetter);
}

/// Table of runs first … last − 1 of the plan, with an empty field per reading.
Table table(const TargetPlan &plan, const TargetRequest &request, const CycleProgram &program, int first,
            const Language &language) {
    const int last = std::min(program.runs, first + runsBeside);
    std::vector<const char *> arrows{"↑", "↓"};
    if (program.only)
        arrows.erase(arrows.begin() + (*program.only == Direction::positive ? 1 : 0));
    const Quantity position = request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    Table result;
    result.columns.push_back({letterOfPlan(request.rule), {}, Alignment::right, false});
    result.columns.push_back({QStringLiteral("P"), language.unit(position), Alignment::decimal, false});
    for (int run = first; run < last; ++run) {
        for (const char *arrow : arrows)
            result.columns.push_back(
                {QString::number(run + 1) + QString::fromUtf8(arrow), {}, Alignment::right, true});
    }
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        std::vector<Cell> row{QString::number(i + 1),
                              language.number(plan.targets[i], position, request.decimals)};
        for (int run = first; run < last; ++run)
            row.insert(row.end(), arrows.size(), Cell(QStringLiteral("\n"))); // space to write
        result.rows.push_back(std::move(row));
        result.rulesAfter.push_back(i);
    }
    return result;
}

/// Adds the plan of one travel.
void add(Report &report, const PlannedMeasurement &planned, const CycleProgram &program,
         const Language &language) {
    const TargetRequest &request = planned.request;
    const TargetPlan &plan = planned.plan;
    report.blocks.emplace_back(head(request, plan, program, language));
    const Quantity position = request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    const Interval moved = movedThrough(program);
    QString travel = language.sentence(
        REPORT_TEXT("report", "The axis moves from %1 to %2."),
        {Number{moved.from, position, request.decimals}, Number{moved.to, position, request.decimals}});
    if (const auto over = overtravelText(program, request))
        travel += u' ' + language.sentence(*over);
    report.blocks.emplace_back(Paragraph{travel});
    report.blocks.emplace_back(
        Heading{2, language.text(REPORT_TEXT("report", "Readings, in the order they are taken"))});
    for (int first = 0; first < program.runs; first += runsBeside)
        report.blocks.emplace_back(table(plan, request, program, first, language));
}

} // namespace

Report composePlan(std::span<const PlannedMeasurement> planned, const CycleProgram &program,
                   const Language &language) {
    Report report;
    report.language = language.code();
    report.title = language.sentence(REPORT_TEXT("report", "Plan of measurement, axis %1"), {program.axis});
    report.blocks.emplace_back(Heading{1, report.title});
    for (const PlannedMeasurement &part : planned) {
        if (&part != &planned.front())
            report.blocks.emplace_back(PageBreak{}); // each plan is filled in separately at the machine
        if (part.request.zone)
            report.blocks.emplace_back(
                Heading{1, language.text(REPORT_TEXT("report", "Full test of a zone of the long axis"))});
        add(report, part, programOf(part, program), language);
    }
    report.footerLeft = report.title;
    report.footerRight = language.text(REPORT_TEXT("report", "page %1 / %2"));
    return report;
}

std::optional<Message> overtravelText(const CycleProgram &program, const TargetRequest &request) {
    if (!overtravelOf(program, request).any())
        return std::nullopt;
    const Quantity position = request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    if (const auto &ends = request.axisRange)
        return Message{REPORT_TEXT("report", "That is beyond the ends of the axis, %1 and %2."),
                       {Number{ends->from, position, -1}, Number{ends->to, position, -1}}};
    return Message{REPORT_TEXT("report", "That is more than the travel of the axis, %1."),
                   {Number{*request.axisTravel, position, -1}}};
}

QString targetList(const TargetPlan &plan, int decimals) {
    QString list;
    for (std::size_t i = 0; i < plan.targets.size(); ++i)
        list += QString::number(i + 1) + u'\t' +
                QString::fromStdString(Decimal(plan.targets[i]).rounded(decimals)) + u'\n';
    return list;
}

} // namespace palmer
