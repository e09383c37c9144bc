// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/fieldpath.h"
#include "document/fileversion.h"
#include "document/impossiblevalues.h"
#include "document/instruments.h"
#include "document/json.h"
#include "document/readdocument.h"
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

/// Fields stored in mm or degrees but shown in µm or arc seconds: without tests[0], * is any key or index.
constexpr std::array<std::string_view, 6> shownFinely{
    "limits.*.value",   "instruments.*.resolution",  "runs.*.deviations.*",
    "excluded.*.value", "arcs.*.radialDeviations.*", "deviations.*"};

bool isShownFinely(std::span<const FieldStep> steps) {
    return std::ranges::any_of(shownFinely, [&](std::string_view pattern) {
        return std::ranges::equal(stepsOf(pattern), steps, [](const FieldStep &part, const FieldStep &step) {
            return part.key == "*" || (!step.index && part.key == step.key);
        });
    });
}

/// Returns the quantities of the numbers at a path, one per number set; empty if no unit is required.
std::vector<Quantity> finelyShownAt(const Document &document, std::span<const FieldStep> steps) {
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

/// Units suggested in a message: the one shown in the window and the one of the file.
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

/// Returns the unit by its import keyword or its sign; both micro signs are accepted.
const Unit *unitTyped(std::string word) {
    constexpr std::string_view greek = "μ";
    if (word.starts_with(greek))
        word.replace(0, greek.size(), "µ");
    const Unit *unit = unitOf(word);
    return unit ? unit : unitOfSign(word);
}

/// Returns "20 um" in mm or "5 arcsec" in degrees where such units are required; null if the value is to be
/// read as it is. Throws Error for a number without a unit or with one of another kind.
std::optional<double> inBaseUnit(const Document &document, std::span<const FieldStep> steps,
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

/// Throws Error for the first impossible value of `changed` that `before` does not have.
void requirePossible(const Document &before, const Document &changed) {
    for (std::size_t i = 0; i < changed.tests.size(); ++i) {
        const auto known =
            i < before.tests.size() ? impossibleValues(*before.tests[i]) : std::vector<ImpossibleValue>();
        for (const ImpossibleValue &impossible : impossibleValues(*changed.tests[i])) {
            const bool isNew = std::ranges::none_of(known, [&](const ImpossibleValue &other) {
                return other.place == impossible.place && other.value == impossible.value;
            });
            if (isNew)
                throw Error(Error::Kind::content, {impossible.expected},
                            "tests[" + std::to_string(i) + "]." + impossible.place);
        }
    }
}

/// Returns a file with every key of the format: a test of each kind, and additions of the latest version.
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
    file["version"] = fileVersion; // has all keys
    const std::vector<FieldStep> steps = stepsOf(path);
    const bool ofFile = file.contains(steps.front().key);
    const std::optional<double> converted = inBaseUnit(document, steps, value);
    std::optional<Error> refused;
    for (const json &meaning : converted ? std::vector<json>{*converted} : meaningsOf(value)) {
        json changed = file;
        if (ofFile) {
            setAt(changed, steps, meaning, path);
        } else {
            for (json &test : changed["tests"])
                setAt(test, steps, meaning, path);
        }
        try {
            Document result = readDocument(QByteArray::fromStdString(compactJson(changed)));
            requirePossible(document, result);
            return result;
        } catch (const Error &error) {
            if (!refused)
                refused = error;
        }
    }
    throw Error(*refused);
}

} // namespace palmer
