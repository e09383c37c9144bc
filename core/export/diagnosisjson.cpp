// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/diagnosisjson.h"

#include "document/diagnosedtest.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/jsonformats.h"
#include "kernel/diagnosis/sourcewords.h"
#include "kernel/measurement/conditions.h"

#include <nlohmann/json.hpp>

#include <functional>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

constexpr double micrometres = 1000; ///< per millimetre

Json sentencesJson(const std::vector<Message> &messages, const Language &language) {
    Json result = Json::array();
    for (const Message &message : messages)
        result.push_back(language.sentence(message).toStdString());
    return result;
}

/// `shown` converts a value to the unit shown.
template <class Shown>
Json intervalJson(const std::optional<Interval> &interval, const Shown &shown) {
    return interval ? Json{{"from", numberOrNull(shown(interval->from))},
                           {"to", numberOrNull(shown(interval->to))}}
                    : Json(nullptr);
}

Json sourceJson(const Diagnosis &diagnosis, const SourceEstimate &source, const Language &language) {
    Json with = Json::array();
    for (const std::size_t other : source.with)
        with.push_back(sourceId(diagnosis.sources[other]));
    Json result{{"id", influence(source.id).word},
                {"axis", source.axis == PlaneAxis::none ? Json(nullptr) : Json(source.axisName)},
                {"value", numberOrNull(source.value ? std::optional(shownParameter(source.id, *source.value))
                                                    : std::nullopt)},
                {"u", source.interval() ? numberOrNull(shownUncertainty(source)) : Json(nullptr)},
                {"interval",
                 intervalJson(source.interval(), [&](double end) { return shownParameter(source.id, end); })},
                {"unit", influence(source.id).unit},
                {"contribution", numberOrNull(source.contribution)},
                {"separable", source.separable},
                {"with", std::move(with)},
                {"reasons", sentencesJson(source.reasons, language)}};
    if (source.interval())
        result["degreesOfFreedom"] = numberOrNull(source.degreesOfFreedom);
    if (source.pitch)
        result["pitch"] = *source.pitch;
    if (source.phase)
        result["phase"] = numberOrNull(source.phase);
    if (source.width)
        result["width"] = *source.width;
    if (source.step)
        result["step"] = numberOrNull(*source.step * micrometres);
    if (source.proposed)
        result["significance"] = numberOrNull(source.significance);
    result["name"] = language.sentence(sourceName(source)).toStdString();
    result["text"] = language.sentence(sourceMeaning(diagnosis, source)).toStdString();
    const Message advice = sourceAdvice(diagnosis, source);
    if (!advice.text.empty())
        result["advice"] = language.sentence(advice).toStdString();
    return result;
}

Json sumJson(const Diagnosis &diagnosis, const SourceSum &sum) {
    Json of = Json::array();
    for (const SourceSum::Part &part : sum.of)
        of.push_back({{"id", sourceId(diagnosis.sources[part.source])},
                      {"factor", numberOrNull(part.factor)},
                      {"unit", part.unit}});
    return {{"id", "sum"},
            {"of", std::move(of)},
            {"value", numberOrNull(sum.value)},
            {"u", sum.interval ? numberOrNull(sum.u) : Json(nullptr)},
            {"interval", intervalJson(sum.interval, std::identity())},
            {"unit", sum.of.front().unit},
            {"contribution", numberOrNull(sum.contribution)}};
}

Json toJson(const Diagnosis &diagnosis, const Language &language) {
    if (!diagnosis.valid())
        return nullptr;
    Json sources = Json::array();
    for (const SourceEstimate &source : diagnosis.sources)
        sources.push_back(sourceJson(diagnosis, source, language));
    for (const SourceSum &sum : diagnosis.sums)
        sources.push_back(sumJson(diagnosis, sum));
    const Rotation &rotation = diagnosis.rotation;
    return {{"rank", diagnosis.rank},
            {"of", diagnosis.of},
            {"condition", numberOrNull(diagnosis.condition)},
            {"residual", numberOrNull(diagnosis.residual)},
            {"points", diagnosis.points},
            {"readingsPerIndependent", numberOrNull(diagnosis.readingsPerIndependent)},
            {"modelFits", diagnosis.modelFits},
            {"reasons", sentencesJson(diagnosis.reasons, language)},
            {"rotation", rotation.angle ? Json{{"angle", numberOrNull(rotation.angle)},
                                               {"u", numberOrNull(rotation.u)},
                                               {"bound", numberOrNull(rotation.bound)},
                                               {"stated", rotation.isStated()}}
                                        : Json(nullptr)},
            {"lagAngle", numberOrNull(diagnosis.lagAngle)},
            {"sources", std::move(sources)},
            {"remarks", sentencesJson(diagnosis.remarks, language)}};
}

Json noiseJson(const SynthesizedNoise &noise) {
    return {{"deviation", noise.deviation * micrometres},
            {"correlation", noise.correlation},
            {"resolution", noise.resolution * micrometres},
            {"seed", noise.seed},
            {"unit", "µm"}};
}

Json truthHead(const char *kind) {
    Json head = jsonHead("truth");
    head["kind"] = kind;
    return head;
}

QByteArray printed(const Json &json) {
    return QByteArray::fromStdString(printJson(json));
}

} // namespace

Json diagnosisJson(const Test &test, const TestEvaluation &evaluation, const Language &language) {
    const auto circle = circleOf(test, evaluation);
    return circle ? toJson(diagnose(*circle), language) : Json(nullptr);
}

Json feedDiagnosesJson(const EvaluatedDocument &evaluated, const Language &language) {
    Json result = Json::array();
    for (const std::vector<std::size_t> &tests : testsAtSeveralFeeds(evaluated)) {
        Json numbers = Json::array();
        std::vector<DiagnosedCircle> group;
        for (const std::size_t test : tests) {
            numbers.push_back(test + 1);
            group.push_back(*circleOf(*evaluated.document->tests[test], *evaluated.tests[test]));
        }
        Json diagnosis = toJson(diagnose(group), language);
        if (!diagnosis.is_null())
            result.push_back({{"tests", std::move(numbers)}, {"diagnosis", std::move(diagnosis)}});
    }
    return result;
}

QByteArray truthJson(const CircularSynthesis &asked, std::span<const double> feeds) {
    Json truth = truthHead("circular");
    truth["plane"] = asked.plane.first + asked.plane.second;
    truth["nominalRadius"] = asked.radius;
    truth["feeds"] = Json(std::vector<double>(feeds.begin(), feeds.end()));
    truth["points"] = asked.points;
    truth["arc"] = Json{{"from", asked.arc.from}, {"to", asked.arc.to}};
    truth["pause"] = asked.pause;
    Json senses = Json::array();
    for (const Sense sense : asked.senses)
        senses.push_back(fileWord(sense));
    truth["senses"] = std::move(senses);
    Json sources = Json::array();
    for (const CircularSource &source : asked.sources) {
        Json one{{"id", influence(source.id).word},
                 {"axis", source.axis == PlaneAxis::none    ? Json(nullptr)
                          : source.axis == PlaneAxis::first ? Json(asked.plane.first)
                                                            : Json(asked.plane.second)},
                 {"value", shownParameter(source.id, source.value)},
                 {"unit", influence(source.id).unit}};
        if (source.id == InfluenceId::cyclic)
            one["pitch"] = source.shape;
        if (source.id == InfluenceId::reversalSpike)
            one["width"] = source.shape;
        sources.push_back(std::move(one));
    }
    if (asked.vibration.amplitude != 0)
        sources.push_back({{"id", "vibration"},
                           {"axis", nullptr},
                           {"value", asked.vibration.amplitude * micrometres},
                           {"unit", "µm"},
                           {"frequency", asked.vibration.frequency}});
    truth["sources"] = std::move(sources);
    truth["noise"] = noiseJson(asked.noise);
    return printed(truth);
}

QByteArray truthJson(const PositioningSynthesis &asked) {
    constexpr double micro = 1e6;
    Json truth = truthHead("positioning");
    truth["axis"] = asked.axis;
    truth["runs"] = asked.runs;
    Json sources = Json::array();
    const auto add = [&](const char *id, double value, const char *unit) {
        if (value != 0)
            sources.push_back({{"id", id}, {"axis", asked.axis}, {"value", value}, {"unit", unit}});
    };
    add("scale", asked.scale * micro, "µm/m");
    add("cyclic", asked.cyclic * micrometres, "µm");
    if (asked.cyclic != 0)
        sources.back()["pitch"] = asked.pitch;
    add("backlash", asked.backlash * micrometres, "µm");
    add("reversal", asked.reversal * micrometres, "µm");
    add("drift", asked.drift * micrometres, "µm");
    add("temperature", asked.temperature - referenceTemperature, "°C above 20");
    if (asked.temperature != referenceTemperature)
        sources.back()["expansion"] = asked.expansion;
    truth["sources"] = std::move(sources);
    truth["noise"] = noiseJson(asked.noise);
    return printed(truth);
}

QByteArray truthJson(const DriftSynthesis &asked) {
    constexpr double minute = 60;
    constexpr double hour = 3600;
    Json truth = truthHead("drift");
    truth["hours"] = asked.length / hour;
    truth["step"] = asked.step;
    Json sources = Json::array();
    sources.push_back({{"id", "temperature"},
                       {"axis", nullptr},
                       {"value", asked.swing},
                       {"unit", "°C"},
                       {"hours", asked.period / hour}});
    for (const DriftChannelSynthesis &channel : asked.channels) {
        sources.push_back({{"id", "response"},
                           {"axis", channel.name},
                           {"value", channel.perDegree * micrometres},
                           {"unit", "µm/°C"},
                           {"timeConstant", channel.tau / minute}});
        if (channel.slope != 0)
            sources.push_back({{"id", "straight"},
                               {"axis", channel.name},
                               {"value", channel.slope * micrometres * hour},
                               {"unit", "µm/h"}});
    }
    truth["sources"] = std::move(sources);
    truth["noise"] = noiseJson(asked.noise);
    return printed(truth);
}

} // namespace palmer
