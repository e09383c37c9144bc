// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/fieldpath.h"
#include "document/fields.h"
#include "document/fileunit.h"
#include "document/fileversion.h"
#include "document/impossiblevalues.h"
#include "document/instruments.h"
#include "document/json.h"
#include "document/readdocument.h"
#include "kernel/measurement/testfacts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace palmer {

namespace {

using nlohmann::json;

/// A number that a path leads to in a test.
struct NumberPlace {
    FileUnit unit = FileUnit::none;
    Motion motion = Motion::linear;

    /// True if the window shows it in another unit than the file: a bare number may be meant in either.
    [[nodiscard]] bool isShownFinely() const {
        const Quantity quantity = quantityOf(unit, motion);
        return quantity == Quantity::deviation || quantity == Quantity::angularDeviation;
    }
};

using Steps = std::span<const FieldStep>;

/// Follows a path through the fields of a struct to the unit of the number at its end; the functions for
/// values are members because they call each other. What the file does not have yet is a default value.
class NumberFinder {
public:
    NumberFinder(Steps steps, unsigned inherited)
        : m_steps(steps)
        , m_inherited(inherited) {}

    template <class T>
    void operator()(const char *key, const T &member, unsigned demands = nothing) {
        if (leadsTo(key))
            m_found = at(member, m_steps.subspan(1), demandsIn(m_inherited, demands));
    }
    void object(const char *key, const auto &members) {
        if (!leadsTo(key))
            return;
        NumberFinder finder(m_steps.subspan(1), nothing);
        members(finder);
        m_found = finder.m_found;
    }
    void extensions(const char * /*key*/, const std::string & /*text*/) {}

    template <class T>
    static std::optional<FileUnit> at(const T &value, Steps steps, unsigned demands) {
        if constexpr (std::is_same_v<T, double>) {
            return steps.empty() ? std::optional(fileUnitOf(demands)) : std::nullopt;
        } else if constexpr (std::is_class_v<T>) {
            NumberFinder finder(steps, demands);
            fields(finder, value);
            return finder.m_found;
        } else {
            return std::nullopt;
        }
    }

private:
    static std::optional<FileUnit> at(const std::string &, Steps, unsigned) { return {}; }
    static std::optional<FileUnit> at(const Permitted &, Steps, unsigned) { return {}; }
    static std::optional<FileUnit> at(const TestPointer &, Steps, unsigned) { return {}; }
    static std::optional<FileUnit> at(const Point3 &, Steps steps, unsigned demands) {
        return steps.size() == 1 && steps.front().index ? std::optional(fileUnitOf(demands)) : std::nullopt;
    }
    template <class T>
    static std::optional<FileUnit> at(const std::optional<T> &value, Steps steps, unsigned demands) {
        return at(value ? *value : T(), steps, demands);
    }
    template <class T>
    static std::optional<FileUnit> at(const std::vector<T> &values, Steps steps, unsigned demands) {
        if (steps.empty() || !steps.front().index)
            return {};
        const std::size_t i = *steps.front().index;
        return at(i < values.size() ? values[i] : T(), steps.subspan(1), demands);
    }
    template <class T>
    static std::optional<FileUnit> at(const std::map<std::string, T> &values, Steps steps, unsigned demands) {
        if (steps.empty() || steps.front().index)
            return {};
        const auto found = values.find(steps.front().key);
        return at(found == values.end() ? T() : found->second, steps.subspan(1), demands);
    }

    [[nodiscard]] bool leadsTo(std::string_view key) const {
        return !m_steps.empty() && !m_steps.front().index && m_steps.front().key == key;
    }

    Steps m_steps;
    unsigned m_inherited;
    std::optional<FileUnit> m_found;
};

/// Returns the motion that decides whether a number outside the tests is a length or an angle.
Motion motionAt(const Document &document, Steps steps) {
    const bool isOfInstrument = steps.size() > 1 && steps.front().key == "instruments" && steps[1].index &&
                                *steps[1].index < document.instruments.size();
    return isOfInstrument && resolutionQuantity(document, document.instruments[*steps[1].index]) ==
                                 Quantity::angularDeviation
               ? Motion::rotary
               : Motion::linear;
}

/// Returns the numbers that a path sets, one per test for a path of every test; empty if it sets none.
std::vector<NumberPlace> numbersAt(const Document &document, Steps steps, bool ofFile) {
    std::vector<NumberPlace> result;
    const auto add = [&](const std::optional<FileUnit> &unit, Motion motion) {
        if (unit)
            result.push_back({*unit, motion});
    };
    const std::vector<TestPointer> &tests = document.tests;
    if (!ofFile) {
        for (const TestPointer &test : tests)
            add(NumberFinder::at(*test, steps, nothing), motionOf(*test));
    } else if (steps.front().key != "tests") {
        add(NumberFinder::at(document, steps, nothing), motionAt(document, steps));
    } else if (steps.size() > 2 && steps[1].index && *steps[1].index < tests.size()) {
        const Test &test = *tests[*steps[1].index];
        add(NumberFinder::at(test, steps.subspan(2), nothing), motionOf(test));
    }
    return result;
}

/// A value that begins as a number: "20", "2,5 mm".
struct TypedNumber {
    double number = 0;
    std::string digits;
    std::string unit; ///< without blanks around it; empty: none
};
std::optional<TypedNumber> typedNumber(std::string_view value) {
    std::string text(value);
    std::ranges::replace(text, ',', '.');
    double number = 0;
    const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number))
        return {};
    const auto length = static_cast<std::size_t>(behind - text.data());
    std::string unit(value.substr(length));
    unit.erase(0, unit.find_first_not_of(' '));
    unit.erase(unit.find_last_not_of(' ') + 1);
    return TypedNumber{number, std::string(value.substr(0, length)), std::move(unit)};
}

/// Throws Error for a number that needs a unit, or has one that does not fit.
[[noreturn]] void refuseUnit(std::string_view value, const TypedNumber &typed, const NumberPlace &place) {
    const std::string ofFile = wordOf(place.unit, place.motion);
    if (!place.isShownFinely())
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "the unit of “%1” does not fit here; expected %2"),
                     {std::string(value), ofFile},
                     {}});
    const char *shown = ofFile == "mm" ? "um" : "arcsec";
    throw Error(Error::Kind::content,
                {typed.unit.empty()
                     ? REPORT_TEXT("report", "%1 of what? Write %2 or %3")
                     : REPORT_TEXT("report", "the unit of “%1” does not fit here; write %2 or %3"),
                 {std::string(value), typed.digits + shown, typed.digits + ofFile},
                 {}});
}

/// Returns "20 um" or "2 m/min" in the unit of the file; null if the value is to be read as it is. Throws
/// Error for a number without the unit it needs, or with one that does not fit.
std::optional<double> inUnitOfFile(const Document &document, Steps steps, bool ofFile,
                                   std::string_view value) {
    const std::optional<TypedNumber> typed = typedNumber(value);
    if (!typed)
        return {};
    std::optional<double> result;
    for (const NumberPlace &place : numbersAt(document, steps, ofFile)) {
        if (place.unit == FileUnit::none || (typed->unit.empty() && !place.isShownFinely()))
            continue;
        if (typed->unit.empty() && typed->number == 0) {
            result = 0;
            continue;
        }
        result = inFileUnit(typed->number, typed->unit, place.unit, place.motion);
        if (!result)
            refuseUnit(value, *typed, place);
    }
    return result && std::isfinite(*result) ? result : std::nullopt;
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
    for (const Kind kind : allKinds) {
        Test test = testOf(kind);
        test.id = std::to_string(document.tests.size());
        test.role = TestRole::asFound;
        document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    }
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
    const std::optional<double> converted = inUnitOfFile(document, steps, ofFile, value);
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
