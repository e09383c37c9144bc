// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "document/evaluateddocument.h"
#include "export/resultsjson.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr auto checkOptions = optionList(
    Option{"json", "", REPORT_TEXT("report", "findings as JSON; of several files one object a line")},
    jsonLinesOption, jobsOption, preparationOptions[0], foreignOptions);

int runCheck(const Invocation &invocation) {
    const Inputs inputs = inputsOf(invocation);
    const auto form = jsonForm(invocation, inputs.several);
    const auto work = [&](const Input &input, Document document) -> JobResult {
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(std::move(document)));
        if (form)
            printOut(findingsJson(evaluated, input.shown, namesLanguage(invocation), *form));
        else
            printOut((inputs.several ? input.shown + QStringLiteral("\n\n") : QString()) +
                     plainText(composeFindings(evaluated, invocation.language), textColumns()));
        const bool allMet = std::ranges::all_of(evaluated.tests, [](const TestEvaluationPointer &test) {
            return test->accordance() != Accordance::no;
        });
        return {allMet ? done : difference, {}};
    };
    return eachDocument(invocation, inputs, work, form ? Between::nothing : Between::emptyLine);
}

} // namespace

Command checkCommand() {
    return {"check", "FILE|FOLDER…",
            REPORT_TEXT("report", "findings only: what the edition asks for and the test lacks"),
            checkOptions, runCheck};
}

} // namespace palmer
