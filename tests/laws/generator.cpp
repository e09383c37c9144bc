// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace palmer::laws {

namespace {

/// Made by code, or tied to other fields of the file.
const std::set<std::string> made{
    "kind",       "id",         "instruments",  "targets",      "runs",          "excluded", "arcs",
    "times",      "deviations", "zone",         "logo",         "mark",          "data",     "series",
    "extensions", "limits",     "expanded",     "driftTest",    "imports",       "editions", "languages",
    "format",     "version",    "tests",        "agreedPoints", "nominalRadius", "trials",   "seed",
    "method",     "plane",      "comparedWith", "channels",     "temperatures"};

/// Exempt from the law of silence: what is measured and what is asked, and what only shapes the report.
/// `motion` and `source` say what was measured, `role` which tests the verdict rests on.
const std::set<std::string> exempt{"targets",      "runs",
                                   "arcs",         "excluded",
                                   "zone",         "limits",
                                   "decisionRule", "requiredResults",
                                   "edition",      "kind",
                                   "id",           "nominalRadius",
                                   "times",        "deviations",
                                   "motion",       "source",
                                   "report",       "imports",
                                   "extensions",   "standardDeviation",
                                   "centring",     "referenceCircle",
                                   "plane",        "role",
                                   "comparedWith", "channels",
                                   "temperatures", "settled"};

/// How large numbers are, by key; the schema has no such facts.
struct Size {
    const char *key;
    double least;
    double most;
};
constexpr std::array sizes{Size{"start", 17, 24},
                           Size{"end", 17, 24},
                           Size{"machine", 0, 14},
                           Size{"instrument", 0, 14},
                           Size{"travel", 100, 3000},
                           Size{"feed", 100, 20000},
                           Size{"airPressure", 950, 1040},
                           Size{"airHumidity", 10, 90},
                           Size{"gradientPerHour", 0, 3},
                           Size{"gradientHoursBefore", 0, 20},
                           Size{"fixed", 0, 2},
                           Size{"perMetre", 0, 3},
                           Size{"coverageFactor", 1, 3},
                           Size{"guardFactor", 0, 1.5},
                           Size{"period", 1, 40},
                           Size{"interval", 10, 200},
                           Size{"approachDistance", 0, 20},
                           Size{"dwell", 0, 10},
                           Size{"faces", 1, 12},
                           Size{"resolution", 0.00001, 0.001},
                           Size{"length", 100, 2000},
                           Size{"year", 1980, 2026},
                           Size{"calibrated", 0, 1},
                           Size{"permitted", 0.005, 0.03},
                           Size{"measured", -0.02, 0.03},
                           Size{"uncertainty", 0, 0.004}};

/// Whether a place lies in the test of a rotary axis.
bool isOfRotary(const Json &file, const Path &path) {
    const Json &test = file["tests"][std::stoul(path.at(1))];
    return test.contains("axis") && test["axis"].value("motion", "linear") == "rotary";
}

double rounded(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return std::round(value * scale) / scale;
}

} // namespace

std::string joined(const Path &path) {
    std::string result;
    for (const std::string &key : path)
        result += (result.empty() ? "" : ".") + key;
    return result;
}

const std::array<Generator::Maker, 3> Generator::makers{
    Maker{"positioning", 0.6, &Generator::positioning},
    Maker{"circular", 0.35, &Generator::circular},
    Maker{"drift", 0.05, &Generator::drift},
};

Generator::Generator(Json schema, std::uint64_t seed)
    : m_schema(std::move(schema))
    , m_random(seed) {
    for (const Json &kind : m_schema.at("/properties/tests/items/properties/kind/enum"_json_pointer)) {
        const auto word = kind.get<std::string>();
        if (std::ranges::find(makers, word, &Maker::kind) == makers.end())
            throw std::logic_error("no file with a test of this kind is made: " + word);
    }
}

const Json &Generator::resolved(const Json &schema) const {
    const auto found = schema.find("$ref");
    if (found == schema.end())
        return schema;
    return resolved(m_schema.at(Json::json_pointer(found->get<std::string>().substr(1))));
}

Json Generator::text(std::size_t most) {
    static constexpr std::array ends{"",    " é",   " Ω",        " (a)",          " & co",
                                     " %1", " <b>", "\x1b[31m!", "\u202e\u2066 ", "\tx\u0085"};
    const std::string body = "Text" + std::to_string(1000 + m_texts++) + anyOf(ends);
    return body.substr(0, most);
}

double Generator::number(const std::string &key) {
    const auto size = std::ranges::find_if(sizes, [&](const Size &s) { return key == s.key; });
    const double value = size == sizes.end() ? between(0, 10) : between(size->least, size->most);
    return rounded(value, std::abs(value) < 0.01 ? 6 : 1 + below(3));
}

Json Generator::value(const Json &given, const std::string &key) {
    const Json &schema = resolved(given);
    if (const auto words = schema.find("enum"); words != schema.end())
        return anyOf(*words);
    if (const auto only = schema.find("const"); only != schema.end())
        return *only;
    if (const auto some = schema.find("anyOf"); some != schema.end())
        return value(anyOf(*some), key);
    const Json &types = schema.contains("type") ? schema.at("type") : Json("null");
    const std::string type = types.is_array() ? types.at(0).get<std::string>() : types.get<std::string>();
    if (type == "boolean")
        return chance(0.7);
    if (type == "integer")
        return static_cast<int>(number(key)) + 1;
    if (type == "number") {
        const double made = number(key);
        return schema.contains("exclusiveMinimum") && made <= 0 ? Json(0.5) : Json(made);
    }
    if (type == "string") {
        if (schema.contains("pattern")) {
            const std::string pattern = schema.at("pattern");
            if (pattern.find("[0-9]{4}") != std::string::npos)
                return "20" + std::to_string(20 + below(7)) + "-0" + std::to_string(1 + below(9)) + "-1" +
                       std::to_string(below(10));
            if (pattern.find("[A-Z]{2}") != std::string::npos)
                return chance(0.5) ? "FR" : "DE";
            return "1" + std::to_string(below(10)) + ":3" + std::to_string(below(10));
        }
        return text(schema.value("maxLength", 4096));
    }
    if (type == "array") {
        Json list = Json::array();
        const int least = schema.value("minItems", 0);
        const int count = least > 0 ? least : below(4);
        for (int i = 0; i < count; ++i) {
            Json one = value(schema.at("items"), key);
            if (schema.value("uniqueItems", false) && std::ranges::find(list, one) != list.end())
                continue;
            list.push_back(std::move(one));
        }
        return list;
    }
    if (type == "object")
        return object(schema);
    return nullptr;
}

Json Generator::object(const Json &schema) {
    Json result = Json::object();
    if (!schema.contains("properties"))
        return result;
    for (const auto &[key, property] : schema.at("properties").items()) {
        const Json needed = schema.value("required", Json::array());
        const bool required = std::ranges::find(needed, Json(key)) != needed.end();
        if (made.contains(key) || (!required && chance(0.25)))
            continue;
        const Json &own = resolved(property);
        const bool nullable = own.contains("type") && own.at("type").is_array();
        if (nullable && !required && chance(0.1)) {
            result[key] = nullptr;
            continue;
        }
        result[key] = value(property, key);
    }
    if (result.contains("from") && result.contains("to") && !(result["from"] < result["to"]))
        result["to"] = result["from"].get<double>() + 700;
    return result;
}

Json Generator::agreedPoints(const Json &schema) {
    Json list = Json::array();
    const Json &item = resolved(schema).at("items");
    for (const Json &point : item.at("properties").at("point").at("enum")) {
        if (chance(0.4))
            continue;
        Json one =
            Json::object({{"point", point}, {"state", value(item.at("properties").at("state"), "state")}});
        if (chance(0.6))
            one["text"] = text(4096);
        if ((point == "gradient" || point == "feed") && chance(0.7))
            one["value"] = number(point == "feed" ? "feed" : "gradientPerHour");
        list.push_back(std::move(one));
    }
    return list;
}

Json Generator::limits(const Json &schema, double scale) {
    Json result = Json::object();
    const double stated = std::array{0.0, 0.15, 0.5}[static_cast<std::size_t>(below(3))];
    for (const Json &id : resolved(resolved(schema).at("propertyNames")).at("enum")) {
        if (!chance(stated))
            continue;
        Json limit{{"value", rounded(scale * between(0.2, 4), 4)}};
        if (id == "Fmin")
            limit["value"] = -limit["value"].get<double>();
        if (chance(0.1))
            limit["edition"] = value(m_schema.at("$defs").at("edition"), "edition");
        if (chance(0.3))
            limit["source"] = text(4096);
        result[id.get<std::string>()] = std::move(limit);
    }
    return result;
}

void Generator::measureAxis(Json &test) {
    const bool rotary = test.contains("axis") && test["axis"].value("motion", "linear") == "rotary";
    const double length = rotary ? 270 : chance(0.2) ? between(2100, 2900) : between(5, 1500);
    const int count = 1 + below(8);
    Json targets = Json::array();
    for (int i = 0; i < count; ++i)
        targets.push_back(rounded(length * i / count + between(0, 0.4) * length / count, below(4)));
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    test["targets"] = targets;
    const double unit = rotary ? 0.0003 : 0.001;
    const int n = std::array{1, 2, 5}[static_cast<std::size_t>(below(3))];
    const int directions = 1 + below(3); // 1 up, 2 down, 3 both
    const bool alternating = chance(0.7);
    Json runs = Json::array();
    const auto add = [&](const char *approach) {
        Json deviations = Json::array();
        for (std::size_t i = 0; i < targets.size(); ++i)
            deviations.push_back(chance(0.02) ? Json(nullptr) : Json(rounded(unit * between(-5, 5), 5)));
        runs.push_back({{"approach", approach}, {"deviations", std::move(deviations)}});
    };
    for (int pass = 0; pass < (alternating ? n : 1); ++pass) {
        for (const auto &[bit, approach] : {std::pair{1, "positive"}, std::pair{2, "negative"}}) {
            for (int k = 0; k < (alternating ? 1 : n) && (directions & bit) != 0; ++k)
                add(approach);
        }
    }
    test["runs"] = std::move(runs);
    if (chance(0.2))
        test["zone"] = {{"from", -1}, {"to", rotary ? 360 : 1999}};
}

void Generator::measurePaths(Json &test) {
    test["nominalRadius"] = rounded(between(50, 200), 2);
    const int senses = 1 + below(3);
    const double extent = chance(0.7) ? 360 : between(60, 300);
    const int repeats = chance(0.2) ? 2 : 1;
    Json arcs = Json::array();
    for (int k = 0; k < repeats; ++k) {
        for (const auto &[bit, sense] : {std::pair{1, "counterclockwise"}, std::pair{2, "clockwise"}}) {
            if ((senses & bit) == 0)
                continue;
            constexpr int points = 36;
            Json angles = Json::array();
            Json radial = Json::array();
            for (int i = 0; i <= points; ++i) {
                const double angle = extent * i / points;
                angles.push_back(bit == 1 ? angle : -angle);
                radial.push_back(rounded(0.004 * std::cos(angle / 57) + 0.001 * between(-1, 1), 5));
            }
            Json arc{{"sense", sense}, {"angles", angles}, {"radialDeviations", radial}};
            if (chance(0.3))
                arc["cutOff"] = text(4096);
            arcs.push_back(std::move(arc));
        }
    }
    test["arcs"] = std::move(arcs);
}

Json Generator::positioning() {
    const Json &schema = m_schema.at("$defs").at("positioningTest");
    Json test = object(schema);
    test["edition"] = value(schema.at("properties").at("edition"), "edition");
    // Ends farther apart than the travel: one of them is wrong, and to take the wrong one away is no silence.
    const Json axis = test.value("axis", Json::object());
    if (axis.value("range", Json()).is_object() && axis.value("travel", Json()).is_number()) {
        const double length = axis["range"]["to"].get<double>() - axis["range"]["from"].get<double>();
        test["axis"]["travel"] = std::max(axis["travel"].get<double>(), length);
    }
    measureAxis(test);
    test["limits"] = limits(schema.at("properties").at("limits"), 0.01);
    if (chance(0.7))
        test["agreedPoints"] = agreedPoints(schema.at("properties").at("agreedPoints"));
    // Simulations take long, and their numbers are tested elsewhere.
    test["uncertainty"]["method"] =
        std::array{"none", "budget", "direct"}[static_cast<std::size_t>(below(3))];
    if (chance(0.5))
        test["uncertainty"]["expanded"] = {{"A", 1.25}, {"R", 0.8}, {"E", 1.5}};
    return test;
}

Json Generator::circular() {
    const Json &schema = m_schema.at("$defs").at("circularTest");
    Json test = object(schema);
    test["edition"] = value(schema.at("properties").at("edition"), "edition");
    test["plane"] = {{"first", "X"}, {"second", "Y"}};
    measurePaths(test);
    test["limits"] = limits(schema.at("properties").at("limits"), 0.005);
    if (chance(0.7))
        test["agreedPoints"] = agreedPoints(schema.at("properties").at("agreedPoints"));
    test["uncertainty"]["method"] =
        std::array{"none", "budget", "direct"}[static_cast<std::size_t>(below(3))];
    if (chance(0.5))
        test["uncertainty"]["expanded"] = {{"G", 0.5}, {"F", 0.7}};
    return test;
}

Json Generator::drift() {
    Json test = object(m_schema.at("$defs").at("driftTest"));
    test["times"] = {0, 60, 120.5};
    if (chance(0.5)) {
        test["deviations"] = {0.0, 0.0004, 0.0011};
        return test;
    }
    test["channels"] =
        Json::array({{{"name", text(40)}, {"values", {0.0, nullptr, 0.0011}}},
                     {{"name", "Y"}, {"quantity", "deviation"}, {"values", {0.0, 0.0002, -0.0004}}}});
    test["temperatures"] = Json::array({{{"measures", text(40)},
                                         {"resolution", rounded(between(0.01, 0.2), 2)},
                                         {"values", {20.1, 20.4, nullptr}}}});
    return test;
}

Json Generator::anyTest() {
    double place = between(0, 1);
    auto maker = makers.begin();
    for (; maker + 1 != makers.end() && place >= maker->share; ++maker)
        place -= maker->share;
    Json test = (this->*maker->make)();
    test["kind"] = maker->kind;
    return test;
}

/// Rows of the acceptance sheet: a third permits a range, a third names a parameter of a test, some of them
/// tests that are not there.
void Generator::checkSheet(Json &report) {
    const Json rows = report.value("sheet", Json());
    if (!rows.is_array() || rows.empty())
        report.erase("decisionRule"); // a rule for nothing
    for (std::size_t i = 0; rows.is_array() && i < rows.size(); ++i) {
        Json &row = report["sheet"][i];
        if (row.contains("permitted") && row["permitted"].is_number() && chance(0.3))
            row["permitted"] = {-number("permitted"), number("permitted")};
        if (row.value("notApplicable", Json()).is_string() && chance(0.8))
            row.erase("notApplicable");
        if (!row.contains("from") || !row["from"].is_object())
            continue;
        for (const char *key : {"permitted", "measured", "uncertainty", "unit"})
            row.erase(key);
        if (chance(0.8))
            row["from"] = {{"test", "t1"}, {"parameter", chance(0.6) ? "A" : "G"}};
    }
}

Json Generator::file() {
    m_texts = 0;
    const Json &root = m_schema.at("properties");
    Json file{{"format", root.at("format").at("const")}, {"version", root.at("version").at("const")}};
    file["report"] = value(root.at("report"), "report");
    checkSheet(file["report"]);
    file["machine"] = value(root.at("machine"), "machine");
    file["tests"] = Json::array();
    const int count = chance(0.7) ? 1 : 2 + below(2);
    for (int i = 0; i < count; ++i) {
        Json test = anyTest();
        test["id"] = "t" + std::to_string(i + 1);
        file["tests"].push_back(std::move(test));
    }
    for (int i = 1; i < count; ++i) {
        if (!file["tests"][0].contains("edition") || !file["tests"][i].contains("edition") || chance(0.5))
            continue;
        file["tests"][i]["comparedWith"] = {{"test", "t1"}, {"setUpUntouched", chance(0.3)}};
        if (chance(0.5))
            file["tests"][i]["comparedWith"]["tolerance"] = rounded(0.001 + between(0, 0.01), 4);
    }
    if (chance(0.8)) {
        Json instrument = value(m_schema.at("$defs").at("instrument"), "instrument");
        instrument["id"] = "laser";
        file["instruments"] = Json::array({std::move(instrument)});
        for (Json &test : file["tests"]) {
            if (chance(0.8))
                test["instruments"] = Json::array({"laser"});
        }
    }
    return file;
}

const Json *Generator::schemaAt(const Path &path, const Json &file) const {
    const Json *schema = &m_schema;
    const Json *at = &file;
    for (const std::string &key : path) {
        schema = &resolved(*schema);
        if (at->is_array()) {
            at = &at->at(std::stoul(key));
            if (schema == nullptr || !schema->contains("items"))
                return nullptr;
            schema = &schema->at("items");
            if (at->is_object() && at->contains("kind") && schema->contains("allOf"))
                schema = &m_schema.at("$defs").at(at->at("kind").get<std::string>() + "Test");
            continue;
        }
        if (!schema->contains("properties") || !schema->at("properties").contains(key))
            return nullptr;
        schema = &schema->at("properties").at(key);
        at = &at->at(key);
    }
    return &resolved(*schema);
}

std::vector<Path> Generator::statements(const Json &file) const {
    std::vector<Path> result;
    const auto walk = [&](const auto &self, const Json &at, const Path &path) -> void {
        if (at.is_object()) {
            for (const auto &[key, below] : at.items()) {
                const bool shapesOnly =
                    path.empty() && (key == "format" || key == "version" || key == "report");
                // A rotary axis has no part per metre: while one is stated, there is no budget.
                const bool refused = key == "perMetre" && isOfRotary(file, path);
                if (shapesOnly || refused || exempt.contains(key))
                    continue;
                Path inner = path;
                inner.push_back(key);
                if (key != "tests")
                    result.push_back(inner);
                self(self, below, inner);
            }
        } else if (at.is_array()) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                Path inner = path;
                inner.push_back(std::to_string(i));
                if (at[i].is_object())
                    self(self, at[i], inner);
            }
        }
    };
    walk(walk, file, {});
    return result;
}

bool Generator::mayBeNull(const Path &path, const Json &file) const {
    const Json *schema = schemaAt(path, file);
    if (!schema)
        return false;
    if (const auto words = schema->find("enum"); words != schema->end())
        return std::ranges::find(*words, Json(nullptr)) != words->end();
    if (const auto some = schema->find("anyOf"); some != schema->end())
        return std::ranges::any_of(*some, [](const Json &one) { return one.value("type", "") == "null"; });
    const auto type = schema->find("type");
    return type != schema->end() && type->is_array() && std::ranges::find(*type, Json("null")) != type->end();
}

} // namespace palmer::laws
