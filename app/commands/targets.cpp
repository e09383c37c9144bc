// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/targets.h"

#include "commandline/editionoption.h"
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "document/plannedtest.h"
#include "document/writedocument.h"
#include "export/partprogram.h"
#include "kernel/evaluation/edition.h"
#include "print/pdf/writepdf.h"
#include "report/blocks/plaintext.h"
#include "report/planreport.h"

#include <QBuffer>
#include <QFileInfo>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr std::array targetsOptions{
    Option{"axis", "X", REPORT_TEXT("report", "name of the axis")},
    Option{"travel", "1000", REPORT_TEXT("report", "measurement travel, mm; of rotary axes degrees")},
    Option{"rotary", "", REPORT_TEXT("report", "a rotary axis")},
    Option{"from", "0", REPORT_TEXT("report", "where the measurement travel begins")},
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
           REPORT_TEXT("report", "writes the part program in this dialect instead of the plan")},
    Option{"o", "OUT",
           REPORT_TEXT("report", "the file to write: the plan as text, as .pdf or as .palmer to fill in; "
                                 "or the part program")},
    forceOption,
};

/// The number of an option, which has to be greater.
std::optional<double> number(const Invocation &invocation, const char *option, double greaterThan) {
    const auto given = invocation.value(QLatin1StringView(option));
    return given ? std::optional(numberAbove(option, *given, greaterThan)) : std::nullopt;
}

std::optional<int> whole(const Invocation &invocation, const char *option, int least, int most) {
    const auto given = invocation.value(QLatin1StringView(option));
    return given ? std::optional(static_cast<int>(wholeBetween(option, *given, least, most))) : std::nullopt;
}

Cycle cycle(const Invocation &invocation) {
    return invocation.value(QLatin1StringView("cycle")) == QLatin1StringView("step") ? Cycle::step
                                                                                     : Cycle::standard;
}

std::optional<Dialect> dialect(const Invocation &invocation) {
    const auto word = invocation.value(QLatin1StringView("program"));
    if (!word)
        return std::nullopt;
    const auto found = std::ranges::find_if(
        dialects(), [&](const DialectName &each) { return *word == QLatin1StringView(each.word); });
    return found->dialect; // parseArguments() has refused other words
}

const Edition &edition(const Invocation &invocation) {
    const Edition *asked = editionAsked(invocation, Kind::positioning);
    return asked ? *asked : defaultEdition(Kind::positioning);
}

TargetRequest request(const Invocation &invocation) {
    TargetRequest result;
    result.rule = edition(invocation).targetRule;
    result.motion = invocation.has(QLatin1StringView("rotary")) ? Motion::rotary : Motion::linear;
    result.from = numberOf(invocation, "from").value_or(0);
    const auto travel = number(invocation, "travel", 0);
    if (!travel)
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 needs --%2"), {std::string("targets"), "travel"}});
    result.travel = *travel;
    result.perMetre = number(invocation, "per-metre", 0).value_or(5);
    result.period = number(invocation, "period", 0);
    result.decimals = whole(invocation, "decimals", 0, 9).value_or(3);
    result.seed = static_cast<std::uint64_t>(seedOf(invocation).value_or(1));
    return result;
}

QByteArray planned(const TargetRequest &asked, const TargetPlan &plan, const CycleProgram &program,
                   const Invocation &invocation, const QString &ending) {
    if (ending == QLatin1StringView("palmer")) {
        Document document;
        document.writtenBy = "Palmer " PALMER_VERSION;
        document.tests.push_back(
            std::make_shared<const Test>(plannedTest(asked, plan, program, edition(invocation).word)));
        return writeDocument(document);
    }
    const Report report = composePlan(asked, plan, program, invocation.language);
    if (ending != QLatin1StringView("pdf"))
        return plainText(report).toUtf8();
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    writePdf(report, pdf);
    return pdf.data();
}

int runTargets(const Invocation &invocation) {
    if (!invocation.arguments.isEmpty())
        throw UsageError({REPORT_TEXT("report", "the command %1 takes no file"), {std::string("targets")}});
    const auto output = invocation.value(QLatin1StringView("o"));
    if (!output)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file to write (%2)"),
                          {std::string("targets"), std::string("-o OUT")}});
    const TargetRequest asked = request(invocation);
    const TargetPlan plan = planTargets(asked);
    if (plan.targets.empty())
        throw UsageError(
            {REPORT_TEXT("report", "these numbers give no plan: too many targets, or too few decimals "
                                   "to tell them apart"),
             {}});
    CycleProgram program;
    program.axis =
        invocation.value(QLatin1StringView("axis")).value_or(QStringLiteral("X")).trimmed().toStdString();
    program.motion = asked.motion;
    program.targets = plan.targets;
    program.decimals = asked.decimals;
    program.cycle = cycle(invocation);
    program.runs = whole(invocation, "runs", 1, 1000).value_or(plan.runs);
    program.feed = number(invocation, "feed", 0);
    program.dwell = number(invocation, "dwell", 0).value_or(program.dwell);
    program.approach = number(invocation, "approach", 0).value_or(program.approach);
    const auto chosen = dialect(invocation);
    if (chosen)
        demandOutput(invocation, *output, {"nc", "ngc", "mpf", "spf", "h", "iso", "cnc", "tap", "txt"});
    else
        demandOutput(invocation, *output, {"palmer", "pdf", "txt"});
    QByteArray bytes;
    if (chosen) {
        try {
            bytes = partProgram(program, *chosen, invocation.language);
        } catch (const Error &error) {
            throw UsageError(error.message);
        }
    } else {
        bytes = planned(asked, plan, program, invocation, QFileInfo(*output).suffix().toLower());
    }
    try {
        writeOutput(bytes, *output);
    } catch (const Error &error) {
        printError(*output, error, invocation.language);
        return cannotRead;
    }
    return done;
}

} // namespace

Command targetsCommand() {
    return {"targets",
            "",
            REPORT_TEXT("report", "plans the targets of a positioning test, writes the part program"),
            targetsOptions,
            runTargets,
            true};
}

} // namespace palmer
