#include "commands/evaluate.h"

#include "commands/eachfile.h"
#include "commands/editionoption.h"
#include "commands/rejection.h"
#include "commands/simulations.h"
#include "export/resultsjson.h"
#include "report/plaintext.h"
#include "report/results.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr std::array options{
    Option{
        "edition", "E",
        REPORT_TEXT("report", "evaluate the tests of its kind under another edition (a view: no verdicts)")},
    Option{"json", "", REPORT_TEXT("report", "results as JSON; of several files one object a line")},
    simulationCommandOptions[0],
    simulationCommandOptions[1],
    simulationCommandOptions[2],
    simulationCommandOptions[3],
    foreignOptions[0],
    foreignOptions[1],
    foreignOptions[2],
};

int run(const Invocation &invocation) {
    const Edition *asked = editionAsked(invocation);
    const std::string edition = asked ? asked->word : "";
    const bool json = invocation.has(QLatin1StringView("json"));
    const SimulationChoices choices = simulationChoices(invocation);
    const bool several = invocation.arguments.size() > 1;
    // Scripts read the same names everywhere, unless they ask for others.
    const Language names = invocation.languageChosen ? invocation.language : Language(Language::Id::english);
    return eachFile(invocation, [&, first = true](const QString &file, Document document) mutable {
        choose(document, choices);
        const EvaluatedDocument evaluated =
            simulated(evaluate(std::make_shared<const Document>(std::move(document)), nullptr, edition),
                      SimulateWhich::monteCarloOnly, choices.threads, invocation.language);
        if (json) {
            printOut(resultsJson(evaluated, file, names, several ? JsonForm::oneLine : JsonForm::pretty));
        } else {
            const QString head =
                several ? (first ? QString() : QStringLiteral("\n")) + file + QStringLiteral("\n\n")
                        : QString();
            printOut(head + plainText(composeResults(evaluated, invocation.language)));
        }
        first = false;
        return hasRejection(evaluated) ? difference : done;
    });
}

} // namespace

Command evaluateCommand() {
    return {"evaluate", "FILE…", REPORT_TEXT("report", "results of the tests as a table or as JSON"), options,
            run};
}

} // namespace palmer
