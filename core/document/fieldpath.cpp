// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fieldpath.h"

#include "document/documenterror.h"
#include "document/fileunit.h"
#include "document/json.h"
#include "document/writedocument.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace palmer {

namespace {

using nlohmann::json;

} // namespace

void refusePath(std::string_view path) {
    throw Error(
        Error::Kind::content,
        {REPORT_TEXT("report", "“%1” is no path of a test file, as machine.name or tests[0].limits.A.value"),
         {std::string(path)},
         {}});
}

std::vector<FieldStep> stepsOf(std::string_view path) {
    std::vector<FieldStep> steps;
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

void setAt(json &place, std::span<const FieldStep> steps, const json &value, std::string_view path) {
    if (steps.empty()) {
        place = value;
        return;
    }
    const FieldStep &step = steps.front();
    if (place.is_null())
        place = step.index ? json::array() : json::object();
    if (step.index ? !place.is_array() || *step.index > place.size() : !place.is_object())
        refusePath(path);
    if (step.index && *step.index == place.size())
        place.push_back(nullptr);
    setAt(step.index ? place[*step.index] : place[step.key], steps.subspan(1), value, path);
}

json fileOf(const Document &document) {
    const QByteArray bytes = writeDocument(document);
    return parseJson(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

std::vector<json> meaningsOf(std::string_view value) {
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

unsigned demandsIn(unsigned ofStruct, unsigned own) {
    return fileUnitOf(own) == FileUnit::none ? own | ofStruct : own;
}

} // namespace palmer
