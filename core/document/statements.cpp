// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/statements.h"

#include "document/evaluateddocument.h"
#include "document/fieldpath.h"
#include "document/fileversion.h"
#include "document/json.h"
#include "document/readdocument.h"
#include "kernel/measurement/testfacts.h"
#include "language/visibletext.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace palmer {

namespace {

using nlohmann::json;

constexpr std::array ofTheFile{"machine", "instruments"};

void removeReadings(PositioningMeasurement &measurement) {
    measurement.targets.clear();
    for (Run &run : measurement.runs)
        run.deviations.clear();
}

void removeReadings(CircularMeasurement &measurement) {
    for (Arc &arc : measurement.arcs) {
        arc.angles.clear();
        arc.radialDeviations.clear();
    }
}

void removeReadings(DriftMeasurement &measurement) {
    measurement.times.clear();
    measurement.deviations.clear();
    for (DriftChannel &channel : measurement.channels)
        channel.values.clear();
    for (DriftTemperature &temperature : measurement.temperatures)
        temperature.values.clear();
}

/// Replaces the reference to a drift test, which the reader will not have, by its range.
void copyDriftRange(const Document &document, Test &test) {
    const std::string *id = driftTestOf(test);
    const auto found = id ? driftVariation(document, *id, test) : std::nullopt;
    constexpr double micrometres = 1000;
    constexpr double arcSeconds = 3600;
    const double unit = motionOf(test) == Motion::linear ? micrometres : arcSeconds;
    test.comparedWith.reset(); // likewise
    withUncertainty(test, [&](auto &inputs) {
        inputs.driftTest.reset();
        if (found && !inputs.environmentalVariation)
            inputs.environmentalVariation = found->value * unit;
    });
}

Document withoutReadings(const Document &document, std::size_t index) {
    Test test = *document.tests[index];
    std::visit([](auto &measurement) { removeReadings(measurement); }, test.measurement);
    copyDriftRange(document, test);
    for (ImportedFile &file : test.imports)
        file.data.reset();
    Document result;
    result.machine = document.machine;
    const std::vector<std::string> named = std::exchange(test.instruments, {});
    std::ranges::copy_if(
        document.instruments, std::back_inserter(result.instruments),
        [&](const Instrument &one) { return std::ranges::find(named, one.id) != named.end(); });
    result.tests.push_back(std::make_shared<const Test>(std::move(test)));
    return result;
}

/// Returns a document that states nothing, with a test of the same kind.
Document silent(const Test &test) {
    Document result;
    Test blank;
    std::visit([&](const auto &measurement) { blank.measurement = std::decay_t<decltype(measurement)>(); },
               test.measurement);
    result.tests.push_back(std::make_shared<const Test>(std::move(blank)));
    return result;
}

json meaningOf(const std::string &value) {
    json literal = json::parse(value, nullptr, false);
    return literal.is_string() ? literal : meaningsOf(value).front();
}

/// Returns the text itself if it is unambiguous, otherwise as a JSON literal.
std::string valueOf(const std::string &text) {
    const QString shown = QString::fromStdString(text);
    const bool isPlain =
        meaningOf(text) == json(text) && cellText(shown) == shown && shown.trimmed() == shown;
    return isPlain ? text : withJsonEscapes(json(text).dump());
}

/// True if all keys can be part of a path.
bool hasKeys(const json &object) {
    const auto isKey = [](const std::string &key) {
        return !key.empty() && key.find_first_of(".[") == std::string::npos;
    };
    const auto &members = object.get_ref<const json::object_t &>();
    return std::ranges::all_of(members, [&](const auto &member) { return isKey(member.first); });
}

bool areScalars(const json &list) {
    return std::ranges::none_of(list, [](const json &element) { return element.is_structured(); });
}

/// Walks through a file and collects what differs from a file that states nothing.
class Collector {
public:
    void collect(const json &value, const json &unsaid, const std::string &path) {
        if (value == unsaid || value.is_null() || value == json(""))
            return;
        if (value.is_object() && path != "extensions" && hasKeys(value))
            return members(value, unsaid, path);
        if (value.is_array() && !areScalars(value))
            return elements(value, path);
        if (value.is_number_float())
            m_statements.push_back({path, {}, value.get<double>()});
        else if (value.is_string())
            m_statements.push_back({path, valueOf(value.get<std::string>())});
        else if (!value.empty())
            m_statements.push_back({path, withJsonEscapes(compactJson(value))});
    }

    [[nodiscard]] std::vector<Statement> take() { return std::move(m_statements); }

private:
    void members(const json &object, const json &unsaid, const std::string &path) {
        const std::string before = path.empty() ? std::string() : path + '.';
        for (const auto &[key, member] : object.items())
            collect(member, unsaid.is_object() ? unsaid.value(key, json()) : json(), before + key);
    }

    /// An element that states nothing still counts.
    void elements(const json &list, const std::string &path) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string place = path + '[' + std::to_string(i) + ']';
            const std::size_t before = m_statements.size();
            collect(list[i], json(), place);
            if (m_statements.size() == before)
                m_statements.push_back({place, "{}"});
        }
    }

    std::vector<Statement> m_statements;
};

bool isOfTheFile(const std::string &key) {
    return std::ranges::find(ofTheFile, key) != ofTheFile.end();
}

} // namespace

std::vector<Statement> statementsOf(const Document &document, std::size_t index) {
    const Document bare = withoutReadings(document, index);
    const json file = fileOf(bare);
    json unsaid = fileOf(silent(*document.tests[index]));
    json test = file["tests"][0];
    json &nothing = unsaid["tests"][0];
    test.erase("id"); // identifies it in its file
    Collector collector;
    // read first
    for (const char *key : {"title", "kind", "edition", "date", "time"}) {
        collector.collect(test.value(key, json()), json(), key);
        test.erase(key);
    }
    if (nothing.contains("conditions"))
        nothing["conditions"].erase("correctionTo20");
    collector.collect(test, nothing, {});
    for (const char *key : ofTheFile)
        collector.collect(file[key], unsaid[key], key);
    return collector.take();
}

Document documentOf(std::span<const Statement> statements) {
    json file{{"format", fileFormat}, {"version", fileVersion}, {"tests", {json::object()}}};
    json &test = file["tests"][0];
    for (const Statement &statement : statements) {
        const std::vector<FieldStep> steps = stepsOf(statement.path);
        const json value = statement.number ? json(*statement.number) : meaningOf(statement.value);
        setAt(isOfTheFile(steps.front().key) ? file : test, steps, value, statement.path);
    }
    if (const auto instruments = file.find("instruments");
        instruments != file.end() && instruments->is_array()) {
        for (const json &instrument : *instruments)
            test["instruments"].push_back(instrument.is_object() ? instrument.value("id", json()) : json());
    }
    return readDocument(QByteArray::fromStdString(compactJson(file)));
}

} // namespace palmer
