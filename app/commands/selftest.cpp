// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "print/pdf/writepdf.h"
#include "report/blocks/plaintext.h"
#include "validation/validationreport.h"

#include <QBuffer>

namespace palmer {

namespace {

constexpr auto selftestOptions = optionList(
    Option{"json", "",
           REPORT_TEXT("report", "every value as JSON, with its origin, tolerance and difference")},
    Option{"report", "FILE.pdf",
           REPORT_TEXT("report", "the validation document of this build, with the processor it ran on")},
    forceOption);

int runSelftest(const Invocation &invocation) {
    const auto document = invocation.value("report");
    if (document)
        requireOutput(invocation, *document, {"pdf"});
    QStringList files = invocation.arguments.isEmpty() ? allReferenceFiles() : QStringList();
    for (const QString &folder : invocation.arguments)
        files += referenceFilesIn(folder);
    if (files.isEmpty()) {
        const Error none(Error::Kind::unreadable,
                         {REPORT_TEXT("report", "no reference data (.json) there"), {}});
        printError(invocation.arguments.join(u' '), none, invocation.language);
        return cannotRead;
    }
    std::vector<SetValidation> sets;
    int code = done;
    for (const QString &name : files) // the others go on after an unreadable one
        code = worse(code, codeOf(name, invocation.language, [&] {
                         sets.push_back(validateFiles({name}).front());
                         return sets.back().agrees() ? done : difference;
                     }));
    if (invocation.has("json"))
        printOut(validationJson(sets));
    else if (document != QStringLiteral("-"))
        printOut(plainText(composeValidation(sets, invocation.language), textColumns()));
    if (document) {
        QBuffer pdf;
        pdf.open(QIODevice::WriteOnly);
        writePdf(composeValidationDocument(sets, invocation.language), pdf);
        writeOutput(pdf.data(), *document);
    }
    return code;
}

} // namespace

Command selftestCommand() {
    return {"selftest",
            "[FOLDER…]",
            REPORT_TEXT("report", "compares the evaluation with reference data, built in or of a folder"),
            selftestOptions,
            runSelftest,
            true};
}

} // namespace palmer
