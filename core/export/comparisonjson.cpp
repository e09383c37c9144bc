// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/comparisonjson.h"

#include "document/json.h"
#include "document/jsonformats.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"
#include "report/parts/comparedtests.h"

#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

template <class Enumeration>
Json wordOrNull(std::optional<Enumeration> value) {
    return value ? Json(fileWord(*value)) : Json(nullptr);
}

Json sideOf(const PlacedTest &placed, const QString &file) {
    const Test &test = placed.test();
    return {{"file", file.toStdString()},
            {"test", placed.index + 1},
            {"id", test.id},
            {"title", test.title},
            {"date", test.date ? Json(*test.date) : Json(nullptr)},
            {"edition", test.edition},
            {"role", fileWord(test.role)}};
}

Json listOf(const std::vector<std::optional<double>> &values) {
    Json list = Json::array();
    for (const std::optional<double> &value : values)
        list.push_back(numberOrNull(value));
    return list;
}

} // namespace

Json comparisonKeys(const TestComparison &comparison, const PlacedTest &before, const PlacedTest &after,
                    const ComparisonOptions &options, const Language &language) {
    Json parameters = Json::array();
    for (const ComparedParameter &p : comparison.parameters)
        parameters.push_back({{"id", comparedId(p)},
                              {"name", language.text(p.term.name).toStdString()},
                              {"before", p.before},
                              {"after", p.after},
                              {"difference", p.difference},
                              {"expandedUncertainty", numberOrNull(p.uncertainty)},
                              {"errorsAlone", numberOrNull(p.errorsAlone)},
                              {"repeatabilityAlone", numberOrNull(p.repeatabilityAlone)},
                              {"shift", numberOrNull(p.shift)},
                              {"En", numberOrNull(p.enRatio)},
                              {"word", wordOrNull(p.word)}});
    Json curves = Json::array();
    for (const ComparedCurve &curve : comparison.curves)
        curves.push_back({{"approach", wordOrNull(curve.direction)},
                          {"difference", listOf(curve.values)},
                          {"band", listOf(curve.band)}});
    Json sources = Json::array();
    for (const ComparedSource &one : comparedSources(before, after))
        sources.push_back(
            {{"id", influence(one.id).word},
             {"name", language.sentence(one.name).toStdString()},
             {"before", shownParameter(one.id, one.before)},
             {"after", shownParameter(one.id, one.after)},
             {"difference", shownParameter(one.id, one.after) - shownParameter(one.id, one.before)},
             {"expandedUncertainty", numberOrNull(shownParameter(one.id, one.uncertainty))},
             {"unit", influence(one.id).unit}});
    Json paths = Json::array();
    for (const ComparedPath &path : comparedPaths(before, after)) {
        Json angles = Json::array();
        Json differences = Json::array();
        for (const auto &[angle, difference] : path.points) {
            angles.push_back(angle);
            differences.push_back(difference);
        }
        paths.push_back({{"sense", fileWord(path.sense)},
                         {"angles", std::move(angles)},
                         {"difference", std::move(differences)}});
    }
    Json conditions = Json::array();
    for (const DifferingCondition &row : compareConditions(before, after, language).differing)
        conditions.push_back(
            {{"name", row.name.toStdString()},
             {"before", row.before.isEmpty() ? Json(nullptr) : Json(row.before.toStdString())},
             {"after", row.after.isEmpty() ? Json(nullptr) : Json(row.after.toStdString())}});
    Json shared = Json::array();
    for (const SharedError error : comparison.shared)
        shared.push_back(fileWord(error));
    return {{"laboratories", options.role == ComparisonRole::laboratories},
            {"setUpUntouched", options.setUpUntouched},
            {"edition", comparison.edition ? Json(comparison.edition->word) : Json(nullptr)},
            {"unit", resultUnit(comparison.quantity)},
            {"refusal", wordOrNull(comparison.refusal)},
            {"noWord", wordOrNull(comparison.noWord)},
            {"word", wordOrNull(wordOfAll(comparison))},
            {"tolerance", numberOrNull(options.tolerance)},
            {"commonTargets", comparison.commonTargets},
            {"cycles", comparison.cycles},
            {"simulated", comparison.simulated},
            {"trials", comparison.trials},
            {"pooled", comparison.pooled},
            {"shared", std::move(shared)},
            {"parameters", std::move(parameters)},
            {"targets", comparison.targets},
            {"interpolated", comparison.interpolated},
            {"curves", std::move(curves)},
            {"sources", std::move(sources)},
            {"paths", std::move(paths)},
            {"conditions", std::move(conditions)}};
}

QByteArray comparisonJson(const TestComparison &comparison, const PlacedTest &before,
                          const QString &fileBefore, const PlacedTest &after, const QString &fileAfter,
                          const ComparisonOptions &options, const Language &language, JsonForm form) {
    const Axis *axis = axisOf(after.test());
    Json file = jsonHead("comparison");
    file.update({{"program", "Palmer " PALMER_VERSION},
                 {"before", sideOf(before, fileBefore)},
                 {"after", sideOf(after, fileAfter)},
                 {"axis", axis ? Json(axesOf(after.test())) : Json(nullptr)},
                 {"plane", axis ? Json(nullptr) : Json(axesOf(after.test()))}});
    file.update(comparisonKeys(comparison, before, after, options, language));
    return QByteArray::fromStdString(form == JsonForm::pretty ? printJson(file) : compactJson(file) + '\n');
}

} // namespace palmer
