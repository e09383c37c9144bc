// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/templatefile.h"

#include "document/copyfields.h"
#include "document/edits.h"
#include "document/fieldpath.h"
#include "document/fileversion.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/place.h"
#include "document/readdocument.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace palmer {
namespace {

using nlohmann::json;

constexpr const char *templateFormat = "palmer template";

[[noreturn]] void refuse(Text text, std::vector<Argument> arguments = {}, std::string place = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments), {}}, std::move(place));
}

/// A possible part of a template: its key, and its place in a test file.
struct TemplatePart {
    const char *key = nullptr;
    const char *place = nullptr;
};
constexpr auto templateParts = std::to_array<TemplatePart>({{"machine", "machine"},
                                                            {"instrument", "instruments[0]"},
                                                            {"laboratory", "report.laboratory"},
                                                            {"limits", "tests[0]"},
                                                            {"conditions", "tests[0].conditions"}});

/// Returns the keys of Declarations.
std::vector<std::string_view> declaredKeys() {
    FieldKeys keys(declared);
    const Conditions unstated;
    fields(keys, unstated);
    return keys.take();
}

/// Returns the non-empty conditions of a written test that belong to a template.
json declaredIn(const json &conditions) {
    json result = json::object();
    const auto keys = declaredKeys();
    const json nothing = json::parse(R"({"kind": "notStated", "text": ""})");
    for (const auto &[key, value] : conditions.items()) {
        // NOLINTNEXTLINE(readability-container-size-empty): no JSON text is empty()
        const bool saysSomething = value != "" && value != nothing;
        if (std::ranges::find(keys, key) != keys.end() && !value.is_null() && saysSomething)
            result[key] = value;
    }
    return result;
}

Kind kindIn(const json &file) {
    const auto entry = file.find("kind");
    const auto *const word = entry == file.end() ? nullptr : entry->get_ptr<const std::string *>();
    std::string known;
    for (const Kind kind : allKinds) {
        if (!traitsOf(kind).isJudged)
            continue;
        if (word && *word == fileWord(kind))
            return kind;
        known += (known.empty() ? "" : " · ") + std::string(fileWord(kind));
    }
    refuse(REPORT_TEXT("report", "expected one of the words: %1"), {known}, "kind");
}

/// Returns a test of that kind without readings, to contain limits or conditions.
Test bearer(Kind kind, Motion motion = Motion::linear) {
    Test test = testOf(kind);
    if (auto *positioning = std::get_if<PositioningMeasurement>(&test.measurement))
        positioning->axis.motion = motion;
    test.edition = defaultEdition(kind).word;
    if (auto *radius = partOr<double *>(nullptr, test.measurement, [](auto &m) -> decltype(&m.nominalRadius) {
            return &m.nominalRadius;
        }))
        *radius = 1;
    return test;
}

json writtenBearer(Kind kind) {
    Document document;
    document.tests = {std::make_shared<const Test>(bearer(kind))};
    return fileOf(document)["tests"][0];
}

/// Returns the test file with the part given by the template.
json testFile(const json &file, const TemplatePart &part) {
    json around{{"format", fileFormat}};
    if (file.contains("version"))
        around["version"] = file["version"];
    const std::string_view key = part.key;
    if (key == "limits") {
        json test = writtenBearer(kindIn(file));
        if (file.contains("motion"))
            test["axis"]["motion"] = file["motion"]; // refused by the reader where the kind has no axis
        test["limits"] = file["limits"];
        if (file.contains("decisionRule"))
            test["decisionRule"] = file["decisionRule"];
        around["tests"] = json::array({test});
        return around;
    }
    if (key == "conditions")
        around["tests"] = json::array({writtenBearer(Kind::positioning)});
    setAt(around, stepsOf(part.place), file[part.key], part.place);
    return around;
}

/// Converts the place of an error in the test file to the place in the template.
std::string placeInTemplate(const std::string &place, const TemplatePart &part) {
    if (!place.starts_with(part.place))
        return place;
    std::string rest = place.substr(std::string_view(part.place).size());
    const bool isTest = std::string_view(part.key) == "limits";
    if (isTest && rest.starts_with(".axis"))
        return "motion";
    if (isTest)
        return rest.empty() ? part.key : rest.substr(1);
    return part.key + rest;
}

const TemplatePart &partIn(const json &file) {
    const TemplatePart *part = nullptr;
    for (const TemplatePart &candidate : templateParts) {
        if (!file.contains(candidate.key))
            continue;
        if (part)
            refuse(REPORT_TEXT(
                "report", "expected one of machine, instrument, laboratory, limits and conditions, not two"));
        part = &candidate;
    }
    if (!part)
        refuse(REPORT_TEXT("report", "the key “%1” is missing"),
               {std::string("machine · instrument · laboratory · limits · conditions")});
    return *part;
}

void requireKnownKeys(const json &file, const TemplatePart &part) {
    const bool isLimits = std::string_view(part.key) == "limits";
    for (const auto &[key, value] : file.items()) {
        const bool known = key == "format" || key == "version" || key == "name" || key == part.key ||
                           (isLimits && (key == "kind" || key == "motion" || key == "decisionRule"));
        if (!known)
            refuse(REPORT_TEXT("report", "this key is unknown"), {}, excerpt(key));
    }
    const auto conditions = file.find("conditions");
    if (conditions == file.end() || !conditions->is_object())
        return;
    const auto keys = declaredKeys();
    for (const auto &[key, value] : conditions->items()) {
        if (std::ranges::find(keys, key) == keys.end())
            refuse(REPORT_TEXT("report", "this key is unknown"), {}, "conditions." + excerpt(key));
    }
}

/// Extracts the part from a document.
decltype(Template::content) contentOf(Document document, const TemplatePart &part) {
    const std::string_view key = part.key;
    if (key == "machine")
        return std::move(document.machine);
    if (key == "instrument")
        return std::move(document.instruments.at(0));
    if (key == "laboratory")
        return std::move(document.report.laboratory);
    const Test &test = *document.tests.at(0);
    if (key == "conditions")
        return declarationsOf(test);
    return LimitSet{kindOf(test), test.limits, test.decisionRule, motionOf(test)};
}

} // namespace

Template readTemplate(const QByteArray &bytes) {
    const json file = parseJson({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (!file.is_object() || !file.contains("format") || file["format"] != templateFormat)
        throw Error(Error::Kind::format, {REPORT_TEXT("report", "this is no template of Palmer"), {}, {}});
    const TemplatePart &part = partIn(file);
    requireKnownKeys(file, part);
    Template result;
    if (const auto name = file.find("name"); name != file.end()) {
        if (!name->is_string())
            refuse(REPORT_TEXT("report", "expected a text, in quotation marks"), {}, "name");
        result.name = name->get<std::string>();
    }
    try {
        result.content =
            contentOf(readDocument(QByteArray::fromStdString(compactJson(testFile(file, part)))), part);
    } catch (const Error &error) {
        throw Error(error.kind, error.message, placeInTemplate(error.place, part));
    }
    return result;
}

QByteArray writeTemplate(const Template &content) {
    Document document;
    const char *key = templateParts[content.content.index()].key;
    if (const auto *machine = std::get_if<Machine>(&content.content)) {
        document.machine = *machine;
    } else if (const auto *instrument = std::get_if<Instrument>(&content.content)) {
        document.instruments = {*instrument};
    } else if (const auto *laboratory = std::get_if<Laboratory>(&content.content)) {
        document.report.laboratory = *laboratory;
    } else if (const auto *declarations = std::get_if<Declarations>(&content.content)) {
        Test test = bearer(Kind::positioning);
        *conditionsOf(test) = declarations->conditions;
        document.tests = {std::make_shared<const Test>(std::move(test))};
    } else {
        const auto &set = std::get<LimitSet>(content.content);
        Test test = bearer(set.kind, set.motion);
        test.limits = set.limits;
        test.decisionRule = set.decisionRule;
        document.tests = {std::make_shared<const Test>(std::move(test))};
    }
    const json file = fileOf(document);
    json result{{"format", templateFormat}, {"version", file["version"]}, {"name", content.name}};
    if (const auto *set = std::get_if<LimitSet>(&content.content)) {
        const json &test = file["tests"][0];
        result["kind"] = fileWord(set->kind);
        if (set->motion != Motion::linear)
            result["motion"] = fileWord(set->motion);
        result["limits"] = test["limits"];
        result["decisionRule"] = test["decisionRule"];
    } else {
        const std::string_view word = key;
        result[key] = word == "machine"      ? file["machine"]
                      : word == "instrument" ? file["instruments"][0]
                      : word == "conditions" ? declaredIn(file["tests"][0]["conditions"])
                                             : file["report"]["laboratory"];
    }
    return QByteArray::fromStdString(printJson(result));
}

Declarations declarationsOf(const Test &test) {
    Declarations result;
    if (const Conditions *conditions = conditionsOf(test))
        copyFields(result.conditions, *conditions, declared);
    return result;
}

bool applyDeclarations(Test &test, const Declarations &declarations) {
    Conditions *conditions = conditionsOf(test);
    if (!conditions)
        return false;
    copyFields(*conditions, declarations.conditions, declared, Copied::whatIsStated);
    return true;
}

LimitSet limitSetOf(const Test &test) {
    LimitSet set;
    set.kind = kindOf(test);
    set.motion = motionOf(test);
    set.decisionRule = test.decisionRule;
    set.limits = test.limits;
    for (auto &[id, limit] : set.limits) {
        if (limit.value && !limit.edition)
            limit.edition = test.edition;
    }
    return set;
}

bool fits(const LimitSet &set, const Test &test) {
    return kindOf(test) == set.kind && motionOf(test) == set.motion;
}

bool applyLimitSet(Test &test, const LimitSet &set) {
    if (!fits(set, test))
        return false;
    test.limits = set.limits;
    test.decisionRule = set.decisionRule;
    return true;
}

} // namespace palmer
