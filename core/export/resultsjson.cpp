// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/resultsjson.h"

#include "document/filewords.h"
#include "document/json.h"
#include "export/diagnosisjson.h"
#include "export/findingtext.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/measurement/testfacts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

constexpr int resultsVersion = 1;

const char *word(Verdict verdict) {
    switch (verdict) {
    case Verdict::conforms:
        return "conforms";
    case Verdict::notProven:
        return "notProven";
    case Verdict::doesNotConform:
        return "doesNotConform";
    }
    return "";
}

const char *word(Grade grade) {
    switch (grade) {
    case Grade::requirement:
        return "requirement";
    case Grade::recommendation:
        return "recommendation";
    case Grade::note:
        return "note";
    }
    return "";
}

const char *word(Source source) {
    constexpr std::array words{"text", "practice", "laboratory", "program"};
    return words.at(static_cast<std::size_t>(source));
}

const char *word(State state) {
    return state == State::unmet ? "unmet" : "undeclared";
}

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json verdictWord(std::optional<Verdict> verdict) {
    return verdict ? Json(word(*verdict)) : Json(nullptr);
}

Json textOrNull(std::string_view text) {
    return text.empty() ? Json(nullptr) : Json(std::string(text));
}

Json ruling(const Parameter &parameter) {
    Json list = Json::array();
    for (const auto &rules : parameter.ruling) {
        if (rules)
            list.push_back(
                {{"target", rules->target},
                 {"approach", rules->approach ? Json(fileWord(*rules->approach)) : Json(nullptr)}});
    }
    return list;
}

Json monteCarlo(const Parameter &parameter, const UncertaintyEvaluation &uncertainty) {
    if (!parameter.simulated || !uncertainty.simulation)
        return nullptr;
    const SimulatedParameter &simulated = *parameter.simulated;
    return {{"u", simulated.u},
            {"low", simulated.low},
            {"high", simulated.high},
            {"shift", simulated.shift()},
            {"trials", uncertainty.simulation->trials},
            {"seed", uncertainty.simulation->seed},
            {"tolerance", simulated.tolerance()}};
}

Json parameter(const Parameter &parameter, const UncertaintyEvaluation &uncertainty,
               const Language &language) {
    return {{"id", parameterId(parameter)},
            {"quantity", parameter.term.id},
            {"symbol", plainSymbol(parameter)},
            {"name", language.text(parameter.term.name).toStdString()},
            {"clause", textOrNull(parameter.term.clause)},
            {"value", number(parameter.value)},
            {"unit", resultUnit(parameter.term.quantity)},
            {"ruling", ruling(parameter)},
            {"expandedUncertainty", number(parameter.expandedUncertainty)},
            {"limit", parameter.limit ? number(parameter.limit->value) : Json(nullptr)},
            {"limitOf", textOrNull(parameter.limitOf)},
            {"guardBand", number(parameter.guardBand)},
            {"verdict", verdictWord(parameter.verdict)},
            {"monteCarlo", monteCarlo(parameter, uncertainty)}};
}

Json target(double position, const TargetStatistics &statistics, double c) {
    struct Key {
        const char *key = nullptr;
        const char *id = nullptr;
    };
    constexpr std::array keys{
        Key{"meanPositive", "mean+"},
        Key{"meanNegative", "mean-"},
        Key{"mean", "mean"},
        Key{"reversal", "reversal"},
        Key{"sPositive", "s+"},
        Key{"sNegative", "s-"},
        Key{"rangePositive", "range+"},
        Key{"rangeNegative", "range-"},
        Key{"lowerPositive", "lower+"},
        Key{"upperPositive", "upper+"},
        Key{"lowerNegative", "lower-"},
        Key{"upperNegative", "upper-"},
        Key{"repeatabilityPositive", "R+"},
        Key{"repeatabilityNegative", "R-"},
        Key{"repeatability", "R"},
    };
    Json result{
        {"target", position}, {"nPositive", statistics.positive.n}, {"nNegative", statistics.negative.n}};
    for (const Key &row : keys)
        result[row.key] = number(targetValue(row.id, statistics, c));
    return result;
}

Json findings(const TestEvaluation &evaluation, const Language &language) {
    Json list = Json::array();
    for (const Finding &finding : evaluation.findings)
        list.push_back({{"grade", word(finding.grade)},
                        {"source", word(finding.source)},
                        {"state", finding.state ? Json(word(*finding.state)) : Json(nullptr)},
                        {"clause", textOrNull(finding.clause)},
                        {"id", finding.id},
                        {"keys", finding.keys},
                        {"text", findingText(finding, language).toStdString()}});
    return list;
}

Json parameters(const TestEvaluation &evaluation, const Language &language) {
    Json list = Json::array();
    for (const Parameter &row : evaluation.parameters)
        list.push_back(parameter(row, evaluation.uncertainty, language));
    return list;
}

const char *word(CircleOf of) {
    switch (of) {
    case CircleOf::both:
        return "both";
    case CircleOf::counterclockwise:
        return "counterclockwise";
    case CircleOf::clockwise:
        return "clockwise";
    }
    return "";
}

Json circles(const CircularResults &results) {
    Json list = Json::array();
    for (const CircleResult &circle : results.circles)
        list.push_back({{"of", word(circle.of)},
                        {"kind", fileWord(circle.kind)},
                        {"centre", Json::array({circle.centre.x, circle.centre.y})},
                        {"radius", circle.radius},
                        {"innerRadius", circle.innerRadius},
                        {"outerRadius", circle.outerRadius},
                        {"width", circle.width},
                        {"certified", circle.certified ? Json(*circle.certified) : Json(nullptr)}});
    return list;
}

/// The contributions are those of a budget that is to be used.
Json uncertainty(const UncertaintyEvaluation &evaluation) {
    Json contributions = Json::array();
    if (usesContributions(evaluation.method)) {
        for (const Contribution &contribution : evaluation.contributions)
            contributions.push_back({{"id", contribution.id}, {"value", number(contribution.expanded)}});
    }
    return {{"method", fileWord(evaluation.method)}, {"contributions", std::move(contributions)}};
}

/// Agreed working zone of a long axis, [from, to].
Json zoneOf(const PositioningMeasurement &m) {
    return m.zone ? Json::array({m.zone->from, m.zone->to}) : Json(nullptr);
}

Json zoneOf(const auto & /*measurement*/) {
    return nullptr;
}

/// What tests of all kinds have alike, before their own.
const char *stateWord(LimitState state) {
    constexpr std::array words{"respected", "notProven", "notEvaluable", "exceeded"};
    return words.at(static_cast<std::size_t>(state));
}

const char *reasonWord(NotEvaluable reason) {
    constexpr std::array words{"oneRun",          "oneDirection",  "oneSense",
                               "feedbackSignal",  "notCalibrated", "notCalibrated",
                               "noSuchParameter", "otherEdition",  "noValue"};
    return words.at(static_cast<std::size_t>(reason));
}

Json agreedLimits(const Test &source, const TestEvaluation &evaluation) {
    const Axis *axis = axisOf(source);
    Json list = Json::array();
    for (const AgreedLimit &agreed : evaluation.limits)
        list.push_back({{"key", agreed.key},
                        {"value", number(agreed.limit.value)},
                        {"unit", axis && axis->motion == Motion::rotary ? "deg" : "mm"},
                        {"state", stateWord(agreed.state)},
                        {"reason", agreed.reason ? Json(reasonWord(*agreed.reason)) : Json(nullptr)},
                        {"parameters", agreed.parameters}});
    return list;
}

Json headOf(const Test &source, const TestEvaluation &evaluation) {
    const bool isOfAxis = axisOf(source);
    const Conditions *conditions = conditionsOf(source);
    const Accordance accordance = evaluation.accordance();
    const RequirementCounts counts = countRequirements(evaluation.findings);
    return {
        {"title", source.title},
        {"kind", fileWord(kindOf(source))},
        {"id", source.id},
        {"axis", isOfAxis ? Json(axesOf(source)) : Json(nullptr)},
        {"plane", isOfAxis ? Json(nullptr) : Json(axesOf(source))},
        {"zone", std::visit([](const auto &measurement) { return zoneOf(measurement); }, source.measurement)},
        {"date", source.date ? Json(*source.date) : Json(nullptr)},
        {"edition", evaluation.edition ? Json(evaluation.edition->word) : Json(nullptr)},
        {"view", evaluation.edition && evaluation.edition->word != source.edition},
        {"accordance", accordanceWord(accordance)},
        {"inAccordance", accordance == Accordance::yes  ? Json(true)
                         : accordance == Accordance::no ? Json(false)
                                                        : Json(nullptr)},
        {"unmet", counts.unmet},
        {"undeclared", counts.undeclared},
        {"role", fileWord(source.role)},
        {"purpose", fileWord(source.purpose)},
        {"limits", limitsWord(evaluation.verdict)},
        {"agreedLimits", agreedLimits(source, evaluation)},
        {"verdict", verdictWord(evaluation.verdict)},
        {"correctionTo20", fileWord(conditions ? conditions->correctionTo20 : CorrectionTo20::notStated)},
        {"decisionRule", fileWord(source.decisionRule.rule)}};
}

/// What tests of a kind have alone, apart from the targets and the diagnosis.
Json ownResults(const PositioningMeasurement & /*measurement*/, const PositioningResults & /*results*/,
                const UncertaintyEvaluation &evaluation) {
    return {{"uncertainty", uncertainty(evaluation)}};
}

Json ownResults(const CircularMeasurement & /*measurement*/, const CircularResults &results,
                const UncertaintyEvaluation &evaluation) {
    return {{"circles", circles(results)},
            {"uncertainty", uncertainty(evaluation)},
            {"correction", number(results.correction)}};
}

Json ownResults(const DriftMeasurement &measurement, const DriftResults &results,
                const UncertaintyEvaluation & /*evaluation*/) {
    return {{"range", number(results.range)},
            {"unit", measurement.axis.motion == Motion::rotary ? "deg" : "mm"}};
}

/// Target by target: of 10⁵ of them a tree takes more memory than all the rest.
void addTargets(std::vector<JsonMember> &members, const PositioningMeasurement &measurement,
                const PositioningResults &results, const TestEvaluation &evaluation) {
    const auto &targets = results.targets;
    const auto print = [&](JsonPrinter &printer, const Place &place) {
        const std::size_t begin = printer.size();
        printer.list(targets.size(), [&](std::size_t i) {
            if (i == 1) // the others are about as long as the first
                printer.expect((printer.size() - begin) * (targets.size() + targets.size() / 8));
            printValue(printer, target(measurement.targets[i], targets[i], evaluation.edition->c),
                       Place(place, i));
        });
    };
    members.push_back({"targets", targets.empty(), print});
}

void addTargets(std::vector<JsonMember> & /*members*/, const auto & /*measurement*/, const auto & /*results*/,
                const TestEvaluation & /*evaluation*/) {}

void printTest(JsonPrinter &printer, const Place &place, const Test &source, const TestEvaluation &evaluation,
               const Language &language) {
    Json head = headOf(source, evaluation);
    head["parameters"] = parameters(evaluation, language);
    std::vector<JsonMember> members = membersOf(head);
    Json own = withResults(source, evaluation, [&](const auto &measurement, const auto &results) {
        addTargets(members, measurement, results, evaluation);
        return ownResults(measurement, results, evaluation.uncertainty);
    });
    if (Json diagnosis = diagnosisJson(source, evaluation, language); !diagnosis.is_null())
        own["diagnosis"] = std::move(diagnosis);
    own["findings"] = findings(evaluation, language);
    std::ranges::move(membersOf(own), std::back_inserter(members));
    printer.object(members, place);
}

Json fileHead(const char *format, const Document &document, const QString &fileName) {
    const Machine &machine = document.machine;
    return {{"format", format},
            {"version", resultsVersion},
            {"program", "Palmer " PALMER_VERSION},
            {"file", fileName.toStdString()},
            {"machine",
             {{"name", textOrNull(machine.name)},
              {"manufacturer", textOrNull(machine.manufacturer)},
              {"model", textOrNull(machine.model)},
              {"serialNumber", textOrNull(machine.serialNumber)}}},
            {"reportNumber", textOrNull(document.report.number)}};
}

QByteArray printed(const Json &file, JsonForm form) {
    return QByteArray::fromStdString(form == JsonForm::pretty ? printJson(file) : compactJson(file) + '\n');
}

} // namespace

const char *limitsWord(std::optional<Verdict> verdict) {
    if (!verdict)
        return "noneAgreed";
    return *verdict == Verdict::conforms    ? "respected"
           : *verdict == Verdict::notProven ? "notProven"
                                            : "exceeded";
}

const char *accordanceWord(Accordance accordance) {
    constexpr std::array words{"notChecked", "no", "notShown", "partly", "yes"};
    return words.at(static_cast<std::size_t>(accordance));
}

const char *resultUnit(Quantity quantity) {
    return quantity == Quantity::angle || quantity == Quantity::angularDeviation ? "deg" : "mm";
}

QByteArray resultsJson(const EvaluatedDocument &evaluated, const QString &fileName, const Language &language,
                       JsonForm form) {
    const auto &tests = evaluated.tests;
    const Json head = fileHead("palmer results", *evaluated.document, fileName);
    Json rest = Json::object();
    if (Json feeds = feedDiagnosesJson(evaluated, language); !feeds.empty())
        rest["feedDiagnoses"] = std::move(feeds);
    std::vector<JsonMember> members = membersOf(head);
    members.push_back({"tests", tests.empty(), [&](JsonPrinter &printer, const Place &place) {
                           printer.list(tests.size(), [&](std::size_t i) {
                               printTest(printer, Place(place, i), *evaluated.document->tests[i], *tests[i],
                                         language);
                           });
                       }});
    std::ranges::move(membersOf(rest), std::back_inserter(members));
    JsonPrinter printer(form == JsonForm::pretty ? JsonPrinter::Form::lines : JsonPrinter::Form::oneLine);
    printer.object(members, {});
    QByteArray text = printer.take();
    text += '\n';
    return text;
}

QByteArray findingsJson(const EvaluatedDocument &evaluated, const QString &fileName, const Language &language,
                        JsonForm form) {
    Json tests = Json::array();
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        Json test = headOf(*evaluated.document->tests[i], *evaluated.tests[i]);
        test["findings"] = findings(*evaluated.tests[i], language);
        tests.push_back(std::move(test));
    }
    Json file = fileHead("palmer findings", *evaluated.document, fileName);
    file["tests"] = std::move(tests);
    return printed(file, form);
}

} // namespace palmer
