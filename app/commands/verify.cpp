// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/progressline.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "print/proof/verifyreport.h"
#include "proof/readreportpdf.h"
#include "register/historyfile.h"
#include "report/blocks/plaintext.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palmer {

namespace {

constexpr const char *extractOption = "extract";

constexpr std::array verifyOptions{
    Option{"json", "", REPORT_TEXT("report", "the outcome as JSON; of several files one object a line")},
    Option{extractOption, "OUT.palmer",
           REPORT_TEXT("report", "take the test file out of the report, byte for byte, and no more")},
    Option{"threads", "N", REPORT_TEXT("report", "threads of the simulation; the figures are the same")},
    jsonLinesOption,
    jobsOption,
    Option{forceOption.name, "", forceOption.description, false, extractOption},
};

int threadsOf(const Invocation &invocation) {
    const auto word = invocation.value("threads");
    if (!word)
        return 0;
    constexpr long long most = 256;
    return static_cast<int>(
        std::min(wholeBetween("threads", *word, 1, std::numeric_limits<int>::max()), most));
}

QByteArray reportFrom(const QString &file) {
    QByteArray bytes = bytesFrom(file);
    if (!isPdf(bytes))
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "this is no PDF; a report of Palmer is verified"), {}, {}});
    return bytes;
}

int extract(const Invocation &invocation, const QString &output) {
    for (const char *other : {"json", jsonLinesOption.name, "threads", jobsOption.name}) {
        if (invocation.has(other))
            throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                              {std::string(extractOption), std::string(other)}});
    }
    if (invocation.arguments.size() != 1)
        throw UsageError(
            {REPORT_TEXT("report", "the option --%1 takes one report"), {std::string(extractOption)}});
    requireOutput(invocation, output, {"palmer", "json"});
    const QString file = invocation.arguments.front();
    return codeOf(file, invocation.language, [&] {
        return written(invocation,
                       {{readReportPdf(reportFrom(file), Carried::testFileOrHistory).testFile, output}});
    });
}

QString inLines(const QString &text) {
    QString result;
    for (const QString &line : text.split(u'\n', Qt::SkipEmptyParts)) {
        const auto first = std::ranges::find_if(line, [](QChar c) { return c != u' '; });
        const QString indent(first - line.begin(), u' ');
        for (const QString &part : wrapped(line, textColumns() - static_cast<int>(indent.size())))
            result += indent + part + u'\n';
    }
    return result;
}

int verify(const Invocation &invocation, const Input &input, int threads, bool several) {
    std::optional<OpenedReport> opened;
    {
        ProgressLine line(invocation.language);
        opened = openReport(reportFrom(input.file), threads, {},
                            [&](const SimulationProgress &progress) { line.show(progress); });
    }
    const Verification verification = verifyReport(opened.value(), composeHistoryFile); // cannot be stopped
    if (const auto form = jsonForm(invocation, several))
        printOut(verificationJson(verification, input.shown, namesLanguage(invocation),
                                  *form == JsonForm::oneLine));
    else
        printOut((several ? input.shown + u'\n' : QString()) +
                 inLines(verificationText(verification, invocation.language)));
    return verification.follows() ? done : difference;
}

int runVerify(const Invocation &invocation) {
    const int threads = threadsOf(invocation);
    if (const auto output = invocation.value(extractOption))
        return extract(invocation, *output);
    const Inputs inputs = inputsOf(invocation, InFolders::reports);
    const auto work = [&](const Input &input) -> JobResult {
        if (isToBePassedOver(input))
            return {done, {}};
        const bool alone = inputs.list.size() == 1;
        return {verify(invocation, input, alone || threads > 0 ? threads : 1, inputs.several), {}};
    };
    return eachInput(invocation, inputs, work,
                     jsonForm(invocation, inputs.several) ? Between::nothing : Between::emptyLine);
}

} // namespace

Command verifyCommand() {
    return {"verify",
            "REPORT.pdf|FOLDER…",
            REPORT_TEXT("report",
                        "whether every printed number of a report follows from the test file inside it"),
            verifyOptions,
            runVerify,
            true};
}

} // namespace palmer
