#include "export/resultsjson.h"

#include "document/filewords.h"
#include "document/json.h"
#include "export/diagnosisjson.h"
#include "export/findingtext.h"
#include "kernel/evaluation/targetvalue.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

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

const char *word(Accordance accordance) {
    constexpr std::array words{"notChecked", "no", "notShown", "partly", "yes"};
    return words.at(static_cast<std::size_t>(accordance));
}

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// Of a test: how it stands to its limits, apart from its accordance.
const char *limitsWord(std::optional<Verdict> verdict) {
    if (!verdict)
        return "noneAgreed";
    return *verdict == Verdict::conforms    ? "respected"
           : *verdict == Verdict::notProven ? "notProven"
                                            : "exceeded";
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

bool isAngle(Quantity quantity) {
    return quantity == Quantity::angle || quantity == Quantity::angularDeviation;
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
            {"unit", isAngle(parameter.term.quantity) ? "deg" : "mm"},
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
        const char *key;
        const char *id;
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

/// What positioning and circular tests have alike, before their own.
void addHead(Json &test, const Test &source, const TestEvaluation &evaluation, CorrectionTo20 correction,
             const Language &language) {
    test["edition"] = evaluation.edition ? Json(evaluation.edition->word) : Json(nullptr);
    const Accordance accordance = evaluation.accordance();
    const RequirementCounts counts = countRequirements(evaluation.findings);
    test["accordance"] = word(accordance);
    test["inAccordance"] = accordance == Accordance::yes  ? Json(true)
                           : accordance == Accordance::no ? Json(false)
                                                          : Json(nullptr);
    test["unmet"] = counts.unmet;
    test["undeclared"] = counts.undeclared;
    test["role"] = fileWord(source.role);
    test["purpose"] = fileWord(source.purpose);
    test["limits"] = limitsWord(evaluation.verdict);
    test["verdict"] = verdictWord(evaluation.verdict);
    test["correctionTo20"] = fileWord(correction);
    test["decisionRule"] = fileWord(source.decisionRule.rule);
    test["parameters"] = parameters(evaluation, language);
}

Json testResults(const Test &source, const TestEvaluation &evaluation, const Language &language) {
    Json test{{"title", source.title}, {"kind", fileWord(kindOf(source))}};
    if (const auto *m = std::get_if<PositioningMeasurement>(&source.measurement)) {
        addHead(test, source, evaluation, m->conditions.common.correctionTo20, language);
        const auto &results = std::get<PositioningResults>(evaluation.results);
        Json targets = Json::array();
        for (std::size_t i = 0; i < results.targets.size(); ++i)
            targets.push_back(target(m->targets[i], results.targets[i], evaluation.edition->c));
        test["targets"] = std::move(targets);
        test["uncertainty"] = uncertainty(evaluation.uncertainty);
    } else if (const auto *circle = std::get_if<CircularMeasurement>(&source.measurement)) {
        addHead(test, source, evaluation, circle->conditions.common.correctionTo20, language);
        const auto &results = std::get<CircularResults>(evaluation.results);
        test["circles"] = circles(results);
        test["uncertainty"] = uncertainty(evaluation.uncertainty);
        test["correction"] = number(results.correction);
        if (Json diagnosis = diagnosisJson(source, evaluation, language); !diagnosis.is_null())
            test["diagnosis"] = std::move(diagnosis);
    } else if (const auto *results = std::get_if<DriftResults>(&evaluation.results)) {
        const auto &drift = std::get<DriftMeasurement>(source.measurement);
        test["range"] = number(results->range);
        test["unit"] = drift.axis.motion == Motion::rotary ? "deg" : "mm";
    }
    test["findings"] = findings(evaluation, language);
    return test;
}

} // namespace

QByteArray resultsJson(const EvaluatedDocument &evaluated, const QString &fileName, const Language &language,
                       JsonForm form) {
    Json tests = Json::array();
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i)
        tests.push_back(testResults(*evaluated.document->tests[i], *evaluated.tests[i], language));
    Json file{{"format", "palmer results"},
              {"version", resultsVersion},
              {"program", "Palmer " PALMER_VERSION},
              {"file", fileName.toStdString()},
              {"tests", std::move(tests)}};
    if (Json feeds = feedDiagnosesJson(evaluated, language); !feeds.empty())
        file["feedDiagnoses"] = std::move(feeds);
    return QByteArray::fromStdString(form == JsonForm::pretty ? printJson(file) : compactJson(file) + '\n');
}

} // namespace palmer
