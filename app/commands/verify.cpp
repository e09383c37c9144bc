#include "commands/verify.h"

#include "commands/outputfile.h"
#include "commands/progressline.h"
#include "commands/streams.h"
#include "ui/proof/verifyreport.h"

#include <array>

namespace palmer {

namespace {

constexpr const char *extractOption = "extract";

constexpr std::array options{
    Option{"json", "", REPORT_TEXT("report", "the outcome as JSON; of several files one object a line")},
    Option{extractOption, "OUT.palmer",
           REPORT_TEXT("report", "take the test file out of the report, byte for byte, and no more")},
    Option{"threads", "N", REPORT_TEXT("report", "threads of the simulation; the figures are the same")},
    forceOption,
};

int threadsOf(const Invocation &invocation) {
    const auto word = invocation.value(QLatin1StringView("threads"));
    if (!word)
        return 0;
    constexpr int most = 256;
    bool isNumber = false;
    const int number = word->toInt(&isNumber);
    if (!isNumber || number < 1)
        throw UsageError({REPORT_TEXT("report", "--%1 takes a whole number from %2 on, not %3"),
                          {std::string("threads"), std::string("1"), word->toStdString()}});
    return std::min(number, most);
}

QByteArray reportFrom(const QString &file) {
    QByteArray bytes = bytesFrom(file);
    if (!isPdf(bytes))
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "this is no PDF; a report of Palmer is verified"), {}, {}});
    return bytes;
}

int extract(const Invocation &invocation, const QString &output) {
    if (invocation.arguments.size() != 1)
        throw UsageError(
            {REPORT_TEXT("report", "the option --%1 takes one report"), {std::string(extractOption)}});
    demandOutput(invocation, output, {"palmer", "json"});
    const QString file = invocation.arguments.front();
    QByteArray testFile;
    try {
        testFile = readReportPdf(reportFrom(file)).testFile;
    } catch (const Error &error) {
        printError(file, error, invocation.language);
        return cannotRead;
    }
    try {
        writeOutput(testFile, output);
    } catch (const Error &error) {
        printError(output, error, invocation.language);
        return cannotRead;
    }
    return done;
}

int verify(const Invocation &invocation, const QString &file, int threads, bool first) {
    const bool several = invocation.arguments.size() > 1;
    const Language names = invocation.languageChosen ? invocation.language : Language(Language::Id::english);
    try {
        std::optional<ui::OpenedReport> opened;
        {
            ProgressLine line(invocation.language);
            opened = ui::openReport(reportFrom(file), threads, {},
                                    [&](const SimulationProgress &progress) { line.show(progress); });
        }
        const Verification verification = ui::verifyReport(opened.value()); // nothing stops it
        if (invocation.has(QLatin1StringView("json"))) {
            printOut(verificationJson(verification, file, names, several));
        } else {
            const QString head =
                several ? (first ? QString() : QStringLiteral("\n")) + file + u'\n' : QString();
            printOut(head + verificationText(verification, invocation.language));
        }
        return verification.follows() ? done : difference;
    } catch (const Error &error) {
        printError(file, error, invocation.language);
        return cannotRead;
    }
}

int run(const Invocation &invocation) {
    const int threads = threadsOf(invocation);
    if (const auto output = invocation.value(QLatin1StringView(extractOption)))
        return extract(invocation, *output);
    int code = done;
    for (const QString &file : invocation.arguments)
        code = worse(code, verify(invocation, file, threads, file == invocation.arguments.front()));
    return code;
}

} // namespace

Command verifyCommand() {
    return {"verify",
            "REPORT.pdf…",
            REPORT_TEXT("report",
                        "whether every printed number of a report follows from the test file inside it"),
            options,
            run,
            true};
}

} // namespace palmer
