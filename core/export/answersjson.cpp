// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/answersjson.h"

#include "document/filewords.h"
#include "document/json.h"
#include "document/jsonformats.h"
#include "document/resultwords.h"
#include "kernel/words/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

QByteArray printed(const char *format, const Json &members) {
    Json file = jsonHead(format);
    file.update(members);
    return QByteArray::fromStdString(printJson(file));
}

Json texts(const QStringList &list) {
    Json result = Json::array();
    for (const QString &text : list)
        result.push_back(text.toStdString());
    return result;
}

Json orNull(std::optional<double> number) {
    return number ? Json(*number) : Json(nullptr);
}

Json place(std::size_t line) {
    return line > 0 ? Json(line) : Json(nullptr);
}

Json toJson(const Explanation &explained, const Parameter &parameter) {
    QStringList steps;
    for (const Formula &step : explained.steps)
        steps << step.plain();
    return {{"id", explained.id.toStdString()},
            {"symbol", explained.symbol.plain().toStdString()},
            {"name", explained.name.toStdString()},
            {"source", explained.source.toStdString()},
            {"value", orNull(parameter.value)},
            {"unit", resultUnit(parameter.term.quantity)},
            {"formula", explained.formula.plain().toStdString()},
            {"steps", texts(steps)},
            {"words", texts(explained.words)}};
}

Json toJson(const OfferedValue &offered) {
    Json settings = Json::object();
    for (const auto &[path, value] : offered.settings)
        settings[path] = value;
    return {{"value", offered.value.toStdString()},
            {"source", offered.source.toStdString()},
            {"set", std::move(settings)}};
}

Json toJson(const ImportAnswer &answer, const Language &language) {
    Json choices = Json::object();
    for (const ImportChoice &choice : answer.imported.choices)
        choices[choice.key] = {{"value", choice.value},
                               {"origin", inOrder(choice.origin, {"recognised", "guessed", "chosen"})}};
    Json remarks = Json::array();
    for (const Remark &remark : answer.imported.remarks)
        remarks.push_back({{"grade", inOrder(remark.grade, {"problem", "assumption", "note"})},
                           {"text", language.sentence(remark.message).toStdString()},
                           {"line", place(remark.line)},
                           {"column", place(remark.column)},
                           {"times", remark.times}});
    Json questions = Json::array();
    for (const Question &question : answer.imported.questions)
        questions.push_back(
            {{"key", question.id},
             {"grade", inOrder(question.grade, {"doubtful", "assumed"})},
             {"text", language.sentence(question.sentence).toStdString()},
             {"proposal", question.proposal.empty() ? Json(nullptr) : Json(question.proposal)},
             {"answers", answersOf(question)},
             {"line", place(question.line)},
             {"column", place(question.column)},
             {"open", !(answer.accepted && question.canBeAssumed())}});
    return {{"file", answer.file.toStdString()},
            {"format", answer.imported.format},
            {"choices", std::move(choices)},
            {"remarks", std::move(remarks)},
            {"questions", std::move(questions)}};
}

} // namespace

QByteArray explanationJson(const EvaluatedDocument &evaluated, const QString &fileName,
                           const std::vector<ExplainedTest> &tests) {
    Json list = Json::array();
    for (const ExplainedTest &one : tests) {
        Json parameters = Json::array();
        for (const Explanation &explained : one.parameters) {
            const auto &all = evaluated.tests[one.test]->parameters;
            parameters.push_back(
                toJson(explained, *std::ranges::find(all, explained.id.toStdString(), parameterId)));
        }
        Json typical = Json::array();
        for (const OfferedValue &offered : one.typical)
            typical.push_back(toJson(offered));
        list.push_back({{"test", one.test + 1},
                        {"title", evaluated.document->tests[one.test]->title},
                        {"parameters", std::move(parameters)},
                        {"typical", std::move(typical)}});
    }
    return printed("explanation", {{"file", fileName.toStdString()}, {"tests", std::move(list)}});
}

QByteArray importJson(const std::vector<ImportAnswer> &files, const QString &output,
                      const Language &language) {
    Json list = Json::array();
    for (const ImportAnswer &file : files)
        list.push_back(toJson(file, language));
    return printed("import", {{"files", std::move(list)},
                              {"written", output.isEmpty() ? Json(nullptr) : Json(output.toStdString())}});
}

QByteArray targetsJson(std::span<const PlannedMeasurement> plans, const CycleProgram &program,
                       const std::string &edition) {
    Json list = Json::array();
    for (const PlannedMeasurement &one : plans) {
        const auto &[request, plan] = one;
        const auto &zone = request.zone;
        list.push_back({{"from", request.from},
                        {"travel", request.travel},
                        {"zone", zone ? Json::array({zone->from, zone->to}) : Json(nullptr)},
                        {"interval", orNull(plan.interval)},
                        {"randomPart", plan.randomPart},
                        {"runs", programOf(one, program).runs},
                        {"targets", plan.targets}});
    }
    return printed("targets", {{"edition", edition},
                               {"axis", program.axis},
                               {"unit", program.motion == Motion::rotary ? "deg" : "mm"},
                               {"cycle", fileWord(program.cycle)},
                               {"runs", program.runs},
                               {"feed", orNull(program.feed)},
                               {"dwell", program.dwell},
                               {"approach", program.approach},
                               {"measurements", std::move(list)}});
}

QByteArray feedJson(double feed) {
    return printed("feed", {{"feed", feed}, {"unit", "mm/min"}});
}

QByteArray errorJson(const QString &file, const QString &error, int exit) {
    Json line = jsonHead("error");
    line.update({{"file", file.toStdString()}, {"error", error.toStdString()}, {"exit", exit}});
    return QByteArray::fromStdString(compactJson(line)) + '\n';
}

} // namespace palmer
