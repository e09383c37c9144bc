// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/refusedreadings.h"

#include "document/json.h"

#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using nlohmann::json;

constexpr auto refusedKey = "refusedReadings";

std::optional<int> wholeNumber(const json &entry, const char *name) {
    const auto found = entry.find(name);
    if (found == entry.end() || !found->is_number_integer() || *found < 1 || *found > 10'000'000)
        return std::nullopt;
    return found->get<int>();
}

std::optional<RefusedReading> refusedReading(const json &entry, const PositioningMeasurement &measurement) {
    if (!entry.is_object() || entry.size() != 3)
        return std::nullopt;
    const auto run = wholeNumber(entry, "run");
    const auto target = wholeNumber(entry, "target");
    const auto text = entry.find("text");
    if (!run || !target || text == entry.end() || !text->is_string())
        return std::nullopt;
    const auto r = static_cast<std::size_t>(*run - 1);
    const auto t = static_cast<std::size_t>(*target - 1);
    if (r >= measurement.runs.size() || t >= measurement.runs[r].deviations.size() ||
        measurement.runs[r].deviations[t])
        return std::nullopt;
    return RefusedReading{*run, *target, text->get<std::string>()};
}

} // namespace

void readRefusedReadings(Test &test) {
    auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!measurement || test.extensions.find(refusedKey) == std::string::npos)
        return;
    json extensions = parseJson(test.extensions);
    const auto entries = extensions.find(refusedKey);
    if (entries == extensions.end() || !entries->is_array())
        return;
    std::vector<RefusedReading> refused;
    for (const json &entry : *entries) {
        auto reading = refusedReading(entry, *measurement);
        if (!reading)
            return;
        refused.push_back(std::move(*reading));
    }
    measurement->refused = std::move(refused);
    extensions.erase(entries);
    test.extensions = compactJson(extensions);
}

void addRefusedReadings(const Test &test, json &extensions) {
    const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    if (!measurement || measurement->refused.empty())
        return;
    json &entries = extensions[refusedKey] = json::array();
    for (const RefusedReading &reading : measurement->refused)
        entries.push_back({{"run", reading.run}, {"target", reading.target}, {"text", reading.text}});
}

} // namespace palmer
