// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/preparation.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "document/evaluateddocument.h"
#include "editing/typicalvalues.h"
#include "export/answersjson.h"
#include "report/blocks/plaintext.h"
#include "report/explanations/explanation.h"
#include "system/filename.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

constexpr auto explainOptions = optionList(
    Option{"test", "N", REPORT_TEXT("report", "which test of the file, from 1; without it all")},
    Option{"typical", "",
           REPORT_TEXT("report",
                       "what the budget of the uncertainty may take where nothing is stated, and where "
                       "it comes from, as --set takes it")},
    Option{"json", "", REPORT_TEXT("report", "the explanations as JSON")}, foreignOptions);

QString inLines(const QString &text, int indent) {
    QString result;
    for (const QString &line : wrapped(text, textColumns() - indent))
        result += QString(indent, u' ') + line + u'\n';
    return result;
}

/// Name and result, formula, formula with numbers, explanations.
QString textOf(const Explanation &explained) {
    QString text = explained.symbol.plain() + QStringLiteral("  ") + explained.name + u'\n';
    if (!explained.source.isEmpty())
        text += inLines(explained.source, 2);
    if (const QString formula = explained.formula.plain(); !formula.isEmpty())
        text += QStringLiteral("    ") + formula + u'\n';
    for (const Formula &step : explained.steps)
        text += QStringLiteral("    ") + step.plain() + u'\n';
    for (const QString &sentence : explained.words)
        text += inLines(sentence, 2);
    return text;
}

/// Ids of the requested parameters: by id, by printed symbol, or by id in any case.
std::vector<std::string> idsMeant(const TestEvaluation &evaluation, const std::optional<QString> &asked) {
    std::vector<std::string> all;
    std::array<std::vector<std::string>, 3> meant; ///< by id, by symbol, by id in any case
    for (const Parameter &parameter : evaluation.parameters) {
        const std::string id = parameterId(parameter);
        all.push_back(id);
        if (!asked)
            continue;
        if (QString::fromStdString(id) == *asked)
            meant[0].push_back(id);
        if (QString::fromStdString(plainSymbol(parameter)) == *asked)
            meant[1].push_back(id);
        if (QString::fromStdString(id).compare(*asked, Qt::CaseInsensitive) == 0)
            meant[2].push_back(id);
    }
    if (!asked)
        return all;
    const auto found = std::ranges::find_if(meant, [](const auto &ids) { return !ids.empty(); });
    return found == meant.end() ? std::vector<std::string>() : *found;
}

struct Asked {
    std::optional<std::size_t> test; ///< index
    std::optional<QString> parameter;
    bool typical = false; ///< typical values instead of explanations
};

Asked askedOf(const Invocation &invocation, std::size_t tests) {
    Asked asked;
    if (invocation.arguments.size() > 2)
        throw UsageError(
            {REPORT_TEXT("report", "the command %1 takes a file and a parameter"), {std::string("explain")}});
    if (invocation.arguments.size() == 2)
        asked.parameter = invocation.arguments.back();
    if (invocation.has("test"))
        asked.test = testIndex(invocation, tests);
    asked.typical = invocation.has("typical");
    if (asked.typical && asked.parameter)
        throw UsageError({REPORT_TEXT("report", "--typical takes no parameter"), {}});
    return asked;
}

[[noreturn]] void refuseUnknown(const EvaluatedDocument &evaluated, const Asked &asked) {
    std::string known;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (asked.test && *asked.test != i)
            continue;
        for (const Parameter &parameter : evaluated.tests[i]->parameters) {
            const std::string id = parameterId(parameter);
            if ((", " + known + ",").find(", " + id + ",") == std::string::npos)
                known += (known.empty() ? "" : ", ") + id;
        }
    }
    const QString given = asked.parameter.value_or(QString());
    if (known.empty())
        throw UsageError(
            {REPORT_TEXT("report", "unknown parameter %1: the tests have none"), {given.toStdString()}});
    throw UsageError(
        {REPORT_TEXT("report", "unknown parameter %1; known: %2"), {given.toStdString(), known}});
}

/// A value, its source and the options that apply it.
QString textOf(const OfferedValue &offered) {
    QString text = offered.value + u'\n' + inLines(offered.source, 2);
    for (const auto &[path, stated] : offered.settings)
        text += QStringLiteral("    --set '") + QString::fromStdString(path) + u'=' +
                QString::fromStdString(stated) + QStringLiteral("'\n");
    return text;
}

/// The explanations of the chosen tests; without those that have none.
std::vector<ExplainedTest> explained(const EvaluatedDocument &evaluated, const Asked &asked,
                                     const Language &language) {
    const Document &document = *evaluated.document;
    std::vector<ExplainedTest> result;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (asked.test && *asked.test != i)
            continue;
        ExplainedTest one{i, {}, {}};
        if (asked.typical) {
            for (const TypicalValue &value : typicalValues(document, *document.tests[i], language)) {
                one.typical.push_back({value.value, value.source, {}});
                for (const auto &[field, stated] : value.fields)
                    one.typical.back().settings.emplace_back(pathInFile(i, field), stated);
            }
        } else {
            for (const std::string &id : idsMeant(*evaluated.tests[i], asked.parameter)) {
                if (auto explained = explanation(evaluated, i, id, language))
                    one.parameters.push_back(std::move(*explained));
            }
        }
        if (!one.parameters.empty() || !one.typical.empty())
            result.push_back(std::move(one));
    }
    return result;
}

QString textOf(const std::vector<ExplainedTest> &tests, const EvaluatedDocument &evaluated,
               const Language &language) {
    QString text;
    for (const ExplainedTest &one : tests) {
        const QString title = QString::fromStdString(evaluated.document->tests[one.test]->title);
        const QString head = language.sentence(
            {REPORT_TEXT("report", "Test %1"), {Number{static_cast<double>(one.test + 1), Quantity::count}}});
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + head +
                (title.isEmpty() ? QString() : QStringLiteral(" · ") + title) + u'\n';
        for (const OfferedValue &offered : one.typical)
            text += u'\n' + textOf(offered);
        for (const Explanation &explained : one.parameters)
            text += u'\n' + textOf(explained);
    }
    return text;
}

int runExplain(const Invocation &invocation) {
    const QString &file = invocation.arguments.front();
    return codeOf(file, invocation.language, [&]() -> int {
        const EvaluatedDocument evaluated =
            evaluate(std::make_shared<const Document>(documentFrom(file, invocation)));
        const Asked asked = askedOf(invocation, evaluated.tests.size());
        const bool asJson = invocation.has("json");
        const Language language = asJson ? namesLanguage(invocation) : invocation.language;
        const std::vector<ExplainedTest> tests = explained(evaluated, asked, language);
        if (tests.empty() && asked.parameter)
            refuseUnknown(evaluated, asked);
        if (tests.empty())
            printError(file + QStringLiteral(": ") +
                       invocation.language.text(
                           asked.typical ? REPORT_TEXT("report", "no typical value is known for its tests")
                                         : REPORT_TEXT("report", "its tests have no results to explain")));
        if (asJson)
            printOut(explanationJson(evaluated, shownFileName(file), tests));
        else
            printOut(textOf(tests, evaluated, language));
        return done;
    });
}

} // namespace

Command explainCommand() {
    return {"explain", "FILE [PARAMETER]",
            REPORT_TEXT("report",
                        "how a value follows from the readings: formula with the numbers put in, clause, "
                        "ruling targets"),
            explainOptions, runExplain};
}

} // namespace palmer
