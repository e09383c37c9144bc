// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/fileversion.h"
#include "document/instruments.h"
#include "document/json.h"
#include "document/readdocument.h"
#include "document/writedocument.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/unit.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
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

/// Fields that a file has in mm or degrees and the window shows in µm or arc seconds: without tests[0], * is
/// any key or index.
constexpr std::array<std::string_view, 6> shownFinely{
    "limits.*.value",   "instruments.*.resolution",  "runs.*.deviations.*",
    "excluded.*.value", "arcs.*.radialDeviations.*", "deviations.*"};

bool isShownFinely(std::span<const Step> steps) {
    return std::ranges::any_of(shownFinely, [&](std::string_view pattern) {
        return std::ranges::equal(stepsOf(pattern), steps, [](const Step &part, const Step &step) {
            return part.key == "*" || (!step.index && part.key == step.key);
        });
    });
}

/// What the numbers at a path are, one of each that is set; none where a unit is not asked for.
std::vector<Quantity> finelyShownAt(const Document &document, std::span<const Step> steps) {
    const std::vector<TestPointer> &tests = document.tests;
    std::vector<Quantity> result;
    if (steps.front().key == "instruments" && isShownFinely(steps)) {
        const std::size_t k = steps[1].index.value_or(document.instruments.size());
        result.push_back(k < document.instruments.size()
                             ? resolutionQuantity(document, document.instruments[k])
                             : Quantity::deviation);
    } else if (steps.front().key == "tests" && steps.size() > 2 && isShownFinely(steps.subspan(2))) {
        if (const std::size_t k = steps[1].index.value_or(tests.size()); k < tests.size())
            result.push_back(deviationQuantity(*tests[k]));
    } else if (isShownFinely(steps)) {
        for (const TestPointer &test : tests)
            result.push_back(deviationQuantity(*test));
    }
    return result;
}

/// The units that a message offers: that of the window, that of the file.
struct Offered {
    Quantity quantity = Quantity::deviation;
    UnitKind kind = UnitKind::length;
    const char *shown = nullptr;
    const char *ofFile = nullptr;
};
constexpr std::array offeredUnits{
    Offered{Quantity::deviation, UnitKind::length, "um", "mm"},
    Offered{Quantity::angularDeviation, UnitKind::angle, "arcsec", "deg"},
};

/// The unit as a choice of the import or as people read it; both signs of micro are one.
const Unit *unitTyped(std::string word) {
    constexpr std::string_view greek = "μ";
    if (word.starts_with(greek))
        word.replace(0, greek.size(), "µ");
    const Unit *unit = unitOf(word);
    return unit ? unit : unitOfSign(word);
}

/// "20 um" in mm, "5 arcsec" in degrees, where such units are asked for. Nothing: the value is to be read as
/// it is. Throws Error for a number that does not say its unit, or one of another kind.
std::optional<double> inBaseUnit(const Document &document, std::span<const Step> steps,
                                 std::string_view value) {
    const std::vector<Quantity> quantities = finelyShownAt(document, steps);
    std::string text(value);
    std::ranges::replace(text, ',', '.');
    double number = 0;
    const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (quantities.empty() || error != std::errc() || !std::isfinite(number))
        return {};
    const auto length = static_cast<std::size_t>(behind - text.data());
    std::string word(value.substr(length));
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    if (word.empty() && number == 0)
        return 0;
    const Unit *unit = unitTyped(word);
    for (const Quantity quantity : quantities) {
        const auto offered = std::ranges::find(offeredUnits, quantity, &Offered::quantity);
        if (offered == offeredUnits.end() || (unit && unit->kind == offered->kind))
            continue;
        const std::string digits(value.substr(0, length));
        throw Error(Error::Kind::content,
                    {word.empty()
                         ? REPORT_TEXT("report", "%1 of what? Write %2 or %3")
                         : REPORT_TEXT("report", "the unit of “%1” does not fit here; write %2 or %3"),
                     {std::string(value), digits + offered->shown, digits + offered->ofFile},
                     {}});
    }
    const double base = unit ? unit->toBase(number) : number;
    return std::isfinite(base) ? std::optional(base) : std::nullopt;
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
    const std::optional<double> converted = inBaseUnit(document, steps, value);
    std::optional<Error> refused;
    for (const json &meaning : converted ? std::vector<json>{*converted} : meanings(value)) {
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
