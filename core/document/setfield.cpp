// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/fileversion.h"
#include "document/json.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

namespace {

using nlohmann::json;

/// A key, or the index of an element.
struct Step {
    std::string key;
    std::optional<std::size_t> index = {};
};

[[noreturn]] void refusePath(std::string_view path) {
    throw Error(
        Error::Kind::content,
        {REPORT_TEXT("report", "“%1” is no path of a test file, as machine.name or tests[0].limits.A.value"),
         {std::string(path)},
         {}});
}

/// "tests[0].limits" → tests, 0, limits.
std::vector<Step> stepsOf(std::string_view path) {
    std::vector<Step> steps;
    std::string_view rest = path;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
        if (end > 0)
            steps.push_back({std::string(rest.substr(0, end))});
        else if (rest.front() == '.' || steps.empty())
            refusePath(path);
        rest.remove_prefix(end);
        while (rest.starts_with('[')) {
            std::size_t index = 0;
            const auto [behind, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), index);
            if (error != std::errc() || behind == rest.data() + rest.size() || *behind != ']')
                refusePath(path);
            steps.push_back({{}, index});
            rest.remove_prefix(static_cast<std::size_t>(behind + 1 - rest.data()));
        }
        if (rest.empty())
            return steps;
        if (rest.size() == 1 || rest.front() != '.')
            refusePath(path);
        rest.remove_prefix(1);
    }
    refusePath(path);
}

void set(json &place, std::span<const Step> steps, const json &value, std::string_view path) {
    if (steps.empty()) {
        place = value;
        return;
    }
    const Step &step = steps.front();
    if (place.is_null())
        place = step.index ? json::array() : json::object();
    if (step.index ? !place.is_array() || *step.index > place.size() : !place.is_object())
        refusePath(path);
    if (step.index && *step.index == place.size())
        place.push_back(nullptr);
    set(step.index ? place[*step.index] : place[step.key], steps.subspan(1), value, path);
}

/// What the words may mean, the first that the field takes is it.
std::vector<json> meanings(std::string_view value) {
    std::vector<json> result;
    if (json literal = json::parse(value, nullptr, false); !literal.is_discarded() && !literal.is_string())
        result.push_back(std::move(literal));
    std::string number(value);
    std::ranges::replace(number, ',', '.');
    if (json literal = json::parse(number, nullptr, false); number != value && literal.is_number())
        result.push_back(std::move(literal));
    result.emplace_back(std::string(value));
    return result;
}

json fileOf(const Document &document) {
    const QByteArray bytes = writeDocument(document);
    return parseJson(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

/// A file with every key of the format: a test of each kind, and what the latest version added.
json fileOfAllKinds() {
    Document document;
    const auto add = [&document](auto measurement) {
        Test test;
        test.id = std::to_string(document.tests.size());
        test.role = TestRole::asFound;
        test.measurement = std::move(measurement);
        document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    };
    add(PositioningMeasurement());
    add(CircularMeasurement());
    add(DriftMeasurement());
    return fileOf(document);
}

} // namespace

bool beginsAsField(std::string_view path) {
    static const json all = fileOfAllKinds();
    const std::string key(path.substr(0, path.find_first_of(".[")));
    return all.contains(key) ||
           std::ranges::any_of(all["tests"], [&](const json &test) { return test.contains(key); });
}

Document withField(const Document &document, std::string_view path, std::string_view value) {
    json file = fileOf(document);
    for (auto version = file["version"].get<std::size_t>(); version <= migrations.size(); ++version)
        migrations.at(version - 1)(file);
    file["version"] = fileVersion; // knows all keys
    const std::vector<Step> steps = stepsOf(path);
    const bool ofFile = file.contains(steps.front().key);
    std::optional<Error> refused;
    for (const json &meaning : meanings(value)) {
        json changed = file;
        if (ofFile) {
            set(changed, steps, meaning, path);
        } else {
            for (json &test : changed["tests"])
                set(test, steps, meaning, path);
        }
        try {
            return readDocument(QByteArray::fromStdString(compactJson(changed)));
        } catch (const Error &error) {
            if (!refused)
                refused = error;
        }
    }
    throw Error(*refused);
}

} // namespace palmer
