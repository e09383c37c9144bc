// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/resultsjson.h"

#include "document/json.h"
#include "document/jsonformats.h"
#include "document/resultwords.h"
#include "document/thermal.h"
#include "export/comparisonjson.h"
#include "export/diagnosisjson.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/measurement/testfacts.h"
#include "report/attachedfile.h"
#include "report/tables/resultcolumns.h"
#include "report/words/findingtext.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iterator>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

Json verdictWord(std::optional<Verdict> verdict) {
    return verdict ? Json(fileWord(*verdict)) : Json(nullptr);
}

Json textOrNull(std::string_view text) {
    return text.empty() ? Json(nullptr) : Json(std::string(text));
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
        result[row.key] = numberOrNull(targetValue(row.id, statistics, c));
    return result;
}

Json findings(const std::vector<Finding> &found, const Language &language) {
    Json list = Json::array();
    for (const Finding &finding : found)
        list.push_back({{"grade", fileWord(finding.grade)},
                        {"source", fileWord(finding.source)},
                        {"state", finding.state ? Json(fileWord(*finding.state)) : Json(nullptr)},
                        {"clause", textOrNull(finding.clause)},
                        {"id", finding.id},
                        {"keys", finding.keys},
                        {"text", findingText(finding, language).toStdString()}});
    return list;
}

Json parameters(const TestEvaluation &evaluation, const Language &language) {
    Json list = Json::array();
    const auto columns = resultColumns(inJson);
    for (const Parameter &parameter : evaluation.parameters) {
        Json told = Json::object();
        for (const ResultColumn *column : columns)
            told[column->key] = column->told({parameter, evaluation.uncertainty, language});
        list.push_back(std::move(told));
    }
    return list;
}

Json circles(const CircularResults &results) {
    Json list = Json::array();
    for (const CircleResult &circle : results.circles)
        list.push_back({{"of", fileWord(circle.of)},
                        {"kind", fileWord(circle.kind)},
                        {"centre", Json::array({circle.centre.x, circle.centre.y})},
                        {"radius", circle.radius},
                        {"innerRadius", circle.innerRadius},
                        {"outerRadius", circle.outerRadius},
                        {"width", circle.width},
                        {"certified", circle.certified ? Json(*circle.certified) : Json(nullptr)}});
    return list;
}

/// Lists the contributions only if the method uses them.
Json uncertainty(const UncertaintyEvaluation &evaluation) {
    Json contributions = Json::array();
    if (usesContributions(evaluation.method)) {
        for (const Contribution &contribution : evaluation.contributions)
            contributions.push_back(
                {{"id", contribution.id}, {"value", numberOrNull(contribution.expanded)}});
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

Json agreedLimits(const Test &source, const TestEvaluation &evaluation) {
    const Axis *axis = axisOf(source);
    Json list = Json::array();
    for (const AgreedLimit &agreed : evaluation.limits)
        list.push_back({{"key", agreed.key},
                        {"value", numberOrNull(agreed.limit.value)},
                        {"unit", axis && axis->motion == Motion::rotary ? "deg" : "mm"},
                        {"state", fileWord(agreed.state)},
                        {"reason", agreed.reason ? Json(fileWord(*agreed.reason)) : Json(nullptr)},
                        {"parameters", agreed.parameters}});
    return list;
}

/// Members common to all kinds of tests; they precede the specific ones.
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
        {"accordance", fileWord(accordance)},
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

/// Members specific to a kind of test, without targets and diagnosis.
Json ownResults(const PositioningMeasurement & /*measurement*/, const PositioningResults & /*results*/,
                const UncertaintyEvaluation &evaluation) {
    return {{"uncertainty", uncertainty(evaluation)}};
}

Json ownResults(const CircularMeasurement & /*measurement*/, const CircularResults &results,
                const UncertaintyEvaluation &evaluation) {
    return {{"circles", circles(results)},
            {"uncertainty", uncertainty(evaluation)},
            {"correction", numberOrNull(results.correction)}};
}

/// The share of U that the drift of a test explains, and what another one would make of it; null: none.
Json driftOf(const EvaluatedDocument &evaluated, std::size_t index) {
    const DriftCases explained = driftCases(evaluated, index);
    const auto steady = std::ranges::find(explained.cases, DriftCase::none, &DriftCase::kind);
    if (steady == explained.cases.end())
        return nullptr;
    static constexpr std::array kinds{"asTested", "halved", "none", "wholeRecord",
                                      "held"}; // as DriftCase::Kind
    Json cases = Json::array();
    for (const DriftCase &one : explained.cases) {
        Json values = Json::array();
        for (std::size_t i = 0; i < one.expanded.size(); ++i) {
            const auto &without = steady->expanded[i];
            const bool isKnown = one.expanded[i] && without && *one.expanded[i] > 0;
            const double ratio = isKnown ? *without / *one.expanded[i] : 1;
            values.push_back({{"id", explained.parameters[i]},
                              {"expandedUncertainty", numberOrNull(one.expanded[i])},
                              {"share", isKnown ? Json(1 - ratio * ratio) : Json(nullptr)}});
        }
        cases.push_back({{"kind", kinds.at(one.kind)},
                         {"heldTo", one.kind == DriftCase::held ? Json(one.hold) : Json(nullptr)},
                         {"duration", numberOrNull(one.lasts)},
                         {"variation", one.variation},
                         {"isLowerBound", one.isLowerBound},
                         {"parameters", std::move(values)}});
    }
    return {{"test", *driftTestOf(*evaluated.document->tests[index])}, {"cases", std::move(cases)}};
}

/// mm or degrees per °C, and s; without values where the data carry no response.
Json responseOf(const ThermalResponse &response, const DriftTemperature &temperature, bool best) {
    const bool found = response.state == ResponseState::found;
    const auto value = [&](std::optional<double> one) { return found ? numberOrNull(one) : Json(nullptr); };
    const auto range = [&](const Range &one) { return Json{value(one.low), value(one.high)}; };
    return {{"temperature", temperature.measures},
            {"state", fileWord(response.state)},
            {"best", best},
            {"perDegree", value(response.k)},
            {"perDegreeInterval", range(response.kRange)},
            {"timeConstant", value(response.tau)},
            {"timeConstantInterval", range(response.tauRange)},
            {"slope", value(response.slope)},
            {"slopeInterval", range(response.slopeRange)},
            {"residual", value(response.residual)},
            {"warmUp", found ? numberOrNull(response.warmUp(withGaps(temperature.values))) : Json(nullptr)},
            {"count", response.count}};
}

Json ownResults(const DriftMeasurement &measurement, const DriftResults &results,
                const UncertaintyEvaluation & /*evaluation*/) {
    Json own{{"range", numberOrNull(results.range)},
             {"unit", deviationQuantity(measurement) == Quantity::angularDeviation ? "deg" : "mm"}};
    if (measurement.channels.empty() && measurement.temperatures.empty())
        return own;
    Json channels = Json::array();
    for (const ThermalChannel &one : thermalChannels(measurement)) {
        Json responses = Json::array();
        for (std::size_t i = 0; i < one.responses.size(); ++i)
            responses.push_back(responseOf(one.responses[i], measurement.temperatures[i], one.best == i));
        channels.push_back({{"name", one.channel.name},
                            {"unit", one.channel.quantity == ChannelQuantity::deviation ? "mm" : "deg"},
                            {"range", one.whole ? numberOrNull(one.whole->value) : Json(nullptr)},
                            {"responses", std::move(responses)}});
    }
    own["channels"] = std::move(channels);
    return own;
}

/// Prints target by target: a tree of 10⁵ targets would take more memory than everything else.
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

/// The comparison that a test states, with the test it names; null: none.
Json comparisonOf(const EvaluatedDocument &evaluated, std::size_t index, const Language &language) {
    const auto stated = statedComparison(evaluated, index);
    if (!stated)
        return nullptr;
    const auto &tests = evaluated.document->tests;
    Json result{{"test", tests[stated->other]->id}, {"isBefore", stated->before == stated->other}};
    result.update(comparisonKeys(stated->comparison, {&evaluated, stated->before},
                                 {&evaluated, stated->after}, stated->options, language));
    return result;
}

void printTest(JsonPrinter &printer, const Place &place, const EvaluatedDocument &evaluated,
               std::size_t index, const Language &language) {
    const Test &source = *evaluated.document->tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    Json head = headOf(source, evaluation);
    head["parameters"] = parameters(evaluation, language);
    std::vector<JsonMember> members = membersOf(head);
    Json own = withResults(source, evaluation, [&](const auto &measurement, const auto &results) {
        addTargets(members, measurement, results, evaluation);
        return ownResults(measurement, results, evaluation.uncertainty);
    });
    if (Json diagnosis = diagnosisJson(source, evaluation, language); !diagnosis.is_null())
        own["diagnosis"] = std::move(diagnosis);
    if (Json drift = driftOf(evaluated, index); !drift.is_null())
        own["drift"] = std::move(drift);
    if (Json comparison = comparisonOf(evaluated, index, language); !comparison.is_null())
        own["comparison"] = std::move(comparison);
    own["findings"] = findings(evaluation.findings, language);
    std::ranges::move(membersOf(own), std::back_inserter(members));
    printer.object(members, place);
}

Json permittedJson(const Permitted &permitted) {
    return permitted.low ? Json::array({numberOrNull(permitted.low), numberOrNull(permitted.high)})
                         : numberOrNull(permitted.high);
}

Json sheetJson(const EvaluatedDocument &evaluated, const Language &language) {
    const ReportHead &head = evaluated.document->report;
    const std::vector<SheetResult> results = evaluated.sheet();
    Json rows = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SheetRow &row = head.sheet[i];
        const SheetResult &result = results[i];
        rows.push_back(
            {{"number", textOrNull(row.number)},
             {"object", textOrNull(row.object)},
             {"permitted", permittedJson(result.permitted)},
             {"measured", numberOrNull(result.value)},
             {"uncertainty", numberOrNull(result.uncertainty)},
             {"guardBand", numberOrNull(result.guardBand)},
             {"unit",
              result.parameter ? Json(resultUnit(result.parameter->term.quantity)) : textOrNull(row.unit)},
             {"state", fileWord(result.state)},
             {"reason", result.gap ? Json(fileWord(*result.gap)) : Json(nullptr)},
             {"instrument", textOrNull(row.instrument)},
             {"remark", textOrNull(row.remark)},
             {"standard", textOrNull(row.standard)},
             {"notApplicable", textOrNull(row.notApplicable)},
             {"from", row.from ? Json({{"test", row.from->test}, {"parameter", row.from->parameter}})
                               : Json(nullptr)}});
    }
    return {{"decisionRule", fileWord(head.decisionRule.rule)},
            {"guardFactor", head.decisionRule.guardFactor},
            {"verdict", verdictWord(verdictOf(results))},
            {"rows", std::move(rows)},
            {"findings", findings(findingsOf(head.sheet, results), language)}};
}

Json fileHead(const char *format, const Document &document, const QString &fileName) {
    const Machine &machine = document.machine;
    Json head = jsonHead(format);
    head.update({{"program", "Palmer " PALMER_VERSION},
                 {"file", fileName.toStdString()},
                 {"machine",
                  {{"name", textOrNull(machine.name)},
                   {"manufacturer", textOrNull(machine.manufacturer)},
                   {"model", textOrNull(machine.model)},
                   {"serialNumber", textOrNull(machine.serialNumber)}}},
                 {"reportNumber", textOrNull(document.report.number)}});
    return head;
}

QByteArray printed(const Json &file, JsonForm form) {
    return QByteArray::fromStdString(form == JsonForm::pretty ? printJson(file) : compactJson(file) + '\n');
}

} // namespace

QByteArray resultsJson(const EvaluatedDocument &evaluated, const QString &fileName, const Language &language,
                       JsonForm form) {
    const auto &tests = evaluated.tests;
    const Json head = fileHead("results", *evaluated.document, fileName);
    Json rest = Json::object();
    if (!evaluated.document->report.sheet.empty())
        rest["sheet"] = sheetJson(evaluated, language);
    if (Json feeds = feedDiagnosesJson(evaluated, language); !feeds.empty())
        rest["feedDiagnoses"] = std::move(feeds);
    std::vector<JsonMember> members = membersOf(head);
    members.push_back({"tests", tests.empty(), [&](JsonPrinter &printer, const Place &place) {
                           printer.list(tests.size(), [&](std::size_t i) {
                               printTest(printer, Place(place, i), evaluated, i, language);
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
        test["findings"] = findings(evaluated.tests[i]->findings, language);
        tests.push_back(std::move(test));
    }
    Json file = fileHead("findings", *evaluated.document, fileName);
    file["tests"] = std::move(tests);
    if (!evaluated.document->report.sheet.empty())
        file["sheet"] = sheetJson(evaluated, language);
    return printed(file, form);
}

QByteArray attachedResults(const EvaluatedDocument &evaluated) {
    return resultsJson(evaluated, attachedFileName(*evaluated.document), Language(Language::Id::english),
                       JsonForm::pretty);
}

} // namespace palmer
