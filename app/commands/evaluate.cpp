// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/preparation.h"
#include "commandline/simulations.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "document/testsofverdict.h"
#include "export/resultsjson.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"
#include "report/tables/summary.h"

#include <QDataStream>
#include <QIODevice>
#include <array>

namespace palmer {

namespace {

constexpr const char *tableOption = "table";

constexpr auto evaluateOptions = optionList(
    Option{
        "edition", "E",
        REPORT_TEXT("report", "evaluate the tests of its kind under another edition (a view: no verdicts)")},
    Option{"json", "", REPORT_TEXT("report", "results as JSON; of several files one object a line")},
    jsonLinesOption,
    Option{
        tableOption, "csv|text",
        REPORT_TEXT("report",
                    "one table of all files: a row per parameter with value, U, limit and both statements")},
    Option{"decimal-mark", "point|comma",
           REPORT_TEXT("report", "of CSV for spreadsheets, with a byte-order mark"), false, "table=csv"},
    jobsOption, simulationCommandOptions, preparationOptions[0], foreignOptions);

/// Rows as sent by worker processes.
QByteArray packed(const std::vector<QStringList> &rows) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << QList<QStringList>(rows.begin(), rows.end());
    return bytes;
}

std::vector<QStringList> unpacked(const QByteArray &bytes) {
    QList<QStringList> rows;
    QDataStream stream(bytes);
    stream >> rows;
    return {rows.begin(), rows.end()};
}

/// The requested form of the table; null: none. Throws UsageError.
std::optional<SummaryForm> tableForm(const Invocation &invocation) {
    const auto word = invocation.value(tableOption);
    if (!word)
        return {};
    if (*word == QLatin1StringView("csv"))
        return SummaryForm::csv;
    return SummaryForm::text;
}

class Evaluation {
public:
    explicit Evaluation(const Invocation &invocation)
        : m_invocation(invocation)
        , m_inputs(inputsOf(invocation))
        , m_choices(simulationChoices(invocation))
        , m_json(jsonForm(invocation, m_inputs.several))
        , m_table(tableForm(invocation)) {
        if (const Edition *asked = editionAsked(invocation))
            m_edition = asked->word;
        if (m_json && m_table)
            throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                              {std::string("json"), std::string(tableOption)}});
    }

    int run() {
        const auto work = [this](const Input &input, Document document) {
            return result(input, std::move(document));
        };
        if (!m_table)
            return eachDocument(m_invocation, m_inputs, work, m_json ? Between::nothing : Between::emptyLine);
        std::vector<QStringList> rows; // aligned columns need the widths of all rows
        const CsvMarks marks = csvMarks(m_invocation);
        const QStringList head = summaryHead(*m_table, m_invocation.language);
        if (*m_table == SummaryForm::csv)
            printOut(marks.begin + summaryCsv({head}, marks.decimal));
        const int code =
            eachDocument(m_invocation, m_inputs, work, Between::nothing, [&](const JobResult &done) {
                std::vector<QStringList> more = unpacked(done.rows);
                if (*m_table == SummaryForm::csv)
                    printOut(summaryCsv(more, marks.decimal));
                else
                    rows.insert(rows.end(), more.begin(), more.end());
            });
        if (*m_table == SummaryForm::text)
            printOut(summaryText(head, rows, terminalColumns()));
        return code;
    }

private:
    [[nodiscard]] JobResult result(const Input &input, Document document) const {
        choose(document, m_choices);
        if (!m_inputs.several) {
            requireEffect(m_choices, document);
            if (!m_edition.empty())
                requireTestOf(*findEdition(m_edition), document);
        }
        const EvaluatedDocument evaluated =
            simulated(evaluate(std::make_shared<const Document>(std::move(document)), nullptr, m_edition),
                      SimulateWhich::monteCarloOnly, m_choices.threads, m_invocation.language);
        const int code = hasRejection(evaluated) ? difference : done;
        if (m_table)
            return {code, packed(summaryRows(evaluated, input.shown, *m_table, m_invocation.language))};
        if (m_json)
            printOut(resultsJson(evaluated, input.shown, namesLanguage(m_invocation), *m_json));
        else
            printOut((m_inputs.several ? input.shown + QStringLiteral("\n\n") : QString()) +
                     plainText(composeResults(evaluated, m_invocation.language), textColumns()));
        return {code, {}};
    }

    const Invocation &m_invocation;
    Inputs m_inputs;
    SimulationChoices m_choices;
    std::optional<JsonForm> m_json;
    std::optional<SummaryForm> m_table;
    std::string m_edition;
};

int runEvaluate(const Invocation &invocation) {
    return Evaluation(invocation).run();
}

} // namespace

Command evaluateCommand() {
    return {"evaluate", "FILE|FOLDER…", REPORT_TEXT("report", "results of the tests as a table or as JSON"),
            evaluateOptions, runEvaluate};
}

} // namespace palmer
