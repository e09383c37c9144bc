#include "commands/check.h"

#include "commands/eachfile.h"
#include "document/evaluateddocument.h"
#include "report/plaintext.h"
#include "report/results.h"

#include <algorithm>

namespace palmer {

namespace {

int run(const Invocation &invocation) {
    const bool several = invocation.arguments.size() > 1;
    return eachFile(invocation, [&, first = true](const QString &file, Document document) mutable {
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(std::move(document)));
        const QString head =
            several ? (first ? QString() : QStringLiteral("\n")) + file + QStringLiteral("\n\n") : QString();
        printOut(head + plainText(composeFindings(evaluated, invocation.language)));
        first = false;
        const bool allMet = std::ranges::all_of(evaluated.tests, [](const TestEvaluationPointer &test) {
            return test->accordance() != Accordance::no;
        });
        return allMet ? done : difference;
    });
}

} // namespace

Command checkCommand() {
    return {"check", "FILE…",
            REPORT_TEXT("report", "findings only: what the edition asks for and the test lacks"),
            foreignOptions, run};
}

} // namespace palmer
