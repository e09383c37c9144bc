#include "commands/report.h"

#include "commands/outputfile.h"
#include "commands/rejection.h"
#include "commands/simulations.h"
#include "commands/streams.h"
#include "report/composereport.h"
#include "ui/pdf/writepdf.h"
#include "validation/validation.h"

#include <QBuffer>
#include <QFileInfo>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr const char *originalsOption = "with-originals";

constexpr std::array options{
    Option{"o", "OUT.pdf",
           REPORT_TEXT("report", "the PDF to write; of two languages OUT.fr.pdf and OUT.en.pdf")},
    Option{"language", "fr|en|fr,en",
           REPORT_TEXT("report", "language of the report; without it those the file asks for")},
    Option{originalsOption, "",
           REPORT_TEXT("report", "the test file inside the PDF keeps the bytes of the instrument files that "
                                 "it was imported from; without it only their names and fingerprints")},
    foreignOptions[0],
    foreignOptions[1],
    foreignOptions[2],
    forceOption,
};

QStringList languagesOf(const Invocation &invocation, const Document &document) {
    QStringList result;
    if (const auto chosen = invocation.value(QLatin1StringView("language"))) {
        result = chosen->split(u',');
    } else {
        for (const ReportLanguage language : document.report.languages)
            result << (language == ReportLanguage::fr ? QStringLiteral("fr") : QStringLiteral("en"));
    }
    result.removeDuplicates();
    return result;
}

/// "report.pdf" → "report.fr.pdf". A folder or a device keeps its name: writing says what is wrong with it.
QString withLanguage(const QString &file, const QString &language) {
    const QFileInfo there(file);
    if (file.endsWith(u'/') || (there.exists() && !there.isFile()))
        return file;
    const QString ending = QStringLiteral(".pdf");
    const bool has = file.endsWith(ending, Qt::CaseInsensitive);
    return (has ? file.chopped(ending.size()) : file) + u'.' + language + (has ? file.right(4) : ending);
}

bool selfTest() {
    return std::ranges::all_of(validateAll(), &SetValidation::agrees);
}

void refuseUnknownLanguage(const Invocation &invocation) {
    const auto chosen = invocation.value(QLatin1StringView("language"));
    for (const QString &name : chosen ? chosen->split(u',') : QStringList()) {
        if (!Language::fromName(name))
            throw UsageError(
                {REPORT_TEXT("report", "unknown language %1; known: fr, en"), {name.toStdString()}});
    }
}

int run(const Invocation &invocation) {
    const auto output = invocation.value(QLatin1StringView("o"));
    if (!output)
        throw UsageError({REPORT_TEXT("report", "the command %1 needs a file to write (%2)"),
                          {std::string("report"), std::string("-o OUT.pdf")}});
    if (invocation.arguments.size() != 1)
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one file"), {std::string("report")}});
    refuseUnknownLanguage(invocation);
    demandOutput(invocation, *output, {"pdf"});
    const QString file = invocation.arguments.front();
    try {
        std::optional<Document> document = documentFrom(file, invocation);
        if (!document)
            return cannotRead; // questions about it are open
        const EvaluatedDocument evaluated =
            simulated(evaluate(std::make_shared<const Document>(std::move(*document)), nullptr, {}),
                      SimulateWhich::allWithBudget, 0, invocation.language);
        const QStringList languages = languagesOf(invocation, *evaluated.document);
        const bool toStandardOutput = *output == QLatin1StringView("-");
        if (toStandardOutput && languages.size() > 1)
            throw UsageError(
                {REPORT_TEXT("report", "standard output takes one report; choose --language"), {}});
        const ReportOptions reportOptions{
            QStringLiteral("Palmer " PALMER_VERSION),
            selfTest(),
            invocation.has(QLatin1StringView(originalsOption)) ? Originals::include : Originals::leaveOut,
            {}};
        const auto targetOf = [&](const QString &name) {
            return languages.size() > 1 ? withLanguage(*output, name) : *output;
        };
        for (const QString &name : languages)
            demandOutput(invocation, targetOf(name), {"pdf"});
        std::vector<FileToSave> reports;
        for (const QString &name : languages) {
            QBuffer pdf;
            pdf.open(QIODevice::WriteOnly);
            ui::writePdf(composeReport(evaluated, Language::fromName(name).value(), reportOptions), pdf,
                         attachedResults(evaluated));
            reports.push_back({pdf.data(), targetOf(name)});
        }
        try {
            writeOutputs(reports);
        } catch (const UnsavedFile &error) {
            printError(error.path, error, invocation.language);
            return cannotRead;
        }
        return hasRejection(evaluated) ? difference : done;
    } catch (const Error &error) {
        printError(file, error, invocation.language);
        return cannotRead;
    }
}

} // namespace

Command reportCommand() {
    return {"report", "FILE", REPORT_TEXT("report", "the printed report as PDF"), options, run, true};
}

} // namespace palmer
