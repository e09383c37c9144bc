// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/copyfields.h"
#include "document/fieldpath.h"
#include "document/fields.h"
#include "document/fileunit.h"
#include "document/fileversion.h"
#include "document/impossiblevalues.h"
#include "document/instruments.h"
#include "document/json.h"
#include "document/readdocument.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"

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

using OptionalPlace = std::optional<NumberPlace>;

/// Returns the number that a path of a test sets; null if it sets none.
OptionalPlace numberOf(const Test &test, Steps steps) {
    const std::optional<FileUnit> unit = NumberFinder::at(test, steps, nothing);
    return unit ? OptionalPlace({*unit, motionOf(test)}) : std::nullopt;
}

/// The same for a path of the file.
OptionalPlace numberOf(const Document &document, Steps steps) {
    if (steps.front().key == "tests") {
        const bool isOfTest = steps.size() > 2 && steps[1].index && *steps[1].index < document.tests.size();
        return isOfTest ? numberOf(*document.tests[*steps[1].index], steps.subspan(2)) : std::nullopt;
    }
    const std::optional<FileUnit> unit = NumberFinder::at(document, steps, nothing);
    return unit ? OptionalPlace({*unit, motionAt(document, steps)}) : std::nullopt;
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

[[noreturn]] void refuseGrouped(const std::string &path, std::string_view value) {
    throw Error(Error::Kind::content, {REPORT_TEXT("report", "%1 cannot be %2: the comma may stand before "
                                                             "thousands or before decimals; write it "
                                                             "without"),
                                       {path, std::string(value)}});
}

/// Returns "20 um" or "2 m/min" in the unit of the file; null if the value is to be read as it is. Throws
/// Error for a number without the unit it needs, or with one that does not fit.
std::optional<double> inUnitOfFile(const OptionalPlace &place, const std::string &path,
                                   std::string_view value) {
    const std::optional<TypedNumber> typed = typedNumber(value);
    if (!place || !typed || place->unit == FileUnit::none)
        return {};
    if (mayBeGrouped(typed->digits))
        refuseGrouped(path, value);
    if (typed->unit.empty() && !place->isShownFinely())
        return {};
    if (typed->unit.empty() && typed->number == 0)
        return 0;
    const std::optional<double> result = inFileUnit(typed->number, typed->unit, place->unit, place->motion);
    if (!result)
        refuseUnit(value, *typed, *place);
    return std::isfinite(*result) ? result : std::nullopt;
}

/// The values that a text may mean in a document or test, numbers in the unit of the file.
template <class Root>
class Meanings {
public:
    Meanings(const Root &root, const std::string &path)
        : m_root(root)
        , m_path(path) {}

    [[nodiscard]] std::vector<json> of(const std::vector<FieldStep> &steps, std::string_view value) const {
        if (const auto number = inUnitOfFile(numberOf(m_root, steps), m_path, value))
            return {*number};
        std::vector<json> result = meaningsOf(value);
        if (mayBeGrouped(value)) // "100,000" is a text, or nothing
            result.erase(result.begin(), result.end() - 1);
        for (json &meaning : result) {
            if (meaning.is_structured())
                convert(meaning, steps);
        }
        return result;
    }

private:
    /// The rule of a single value holds at each end of an object or list.
    void convert(json &value, std::vector<FieldStep> steps) const {
        if (value.is_structured()) {
            std::size_t index = 0;
            for (const auto &[key, member] : value.items()) {
                steps.push_back(value.is_array() ? FieldStep{{}, index++} : FieldStep{key});
                convert(member, steps);
                steps.pop_back();
            }
        } else if (value.is_number() || value.is_string()) {
            const auto *const text = value.get_ptr<const std::string *>();
            if (const auto number =
                    inUnitOfFile(numberOf(m_root, steps), m_path, text ? *text : value.dump()))
                value = *number;
        }
    }

    const Root &m_root;
    const std::string &m_path;
};

/// True if the field is one of that test: a limit not where its parameter is one of another kind.
bool hasField(const Test &test, Steps steps) {
    FieldKeys keys;
    fields(keys, test);
    const auto known = keys.take();
    if (std::ranges::find(known, steps.front().key) == known.end())
        return false;
    const auto knows = [&](Kind kind) { return isParameter(kind, steps[1].key); };
    return steps.front().key != "limits" || steps.size() < 2 || knows(kindOf(test)) ||
           std::ranges::none_of(allKinds, knows);
}

/// A value for a place in the file.
struct PlacedMeanings {
    std::string place; ///< "", "tests[0]."
    std::vector<json> meanings;
    bool isNumber = false; ///< that the field takes
};

/// Returns what a path without a test sets in each test that it fits: the field is one of the kind, the unit
/// one of the motion. Throws Error if it fits none.
std::vector<PlacedMeanings> meaningsForTests(const Document &document, const std::vector<FieldStep> &steps,
                                             const std::string &path, std::string_view value) {
    std::vector<PlacedMeanings> result;
    std::optional<Error> refused;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        const Test &test = *document.tests[i];
        if (!hasField(test, steps))
            continue;
        try {
            result.push_back({"tests[" + std::to_string(i) + "].", Meanings(test, path).of(steps, value),
                              numberOf(test, steps).has_value()});
        } catch (const Error &error) {
            if (!refused)
                refused = error;
        }
    }
    if (result.empty() && refused)
        throw Error(*refused);
    if (result.empty())
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "no test of the file has the field “%1”"), {path}});
    return result;
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
    const std::string name(path);
    const bool ofFile = file.contains(steps.front().key);
    if (steps.front().key == "tests" && steps.size() < 3) // its numbers would be taken without their units
        refusePath(path);
    std::vector<PlacedMeanings> placed;
    if (ofFile)
        placed.push_back(
            {"", Meanings(document, name).of(steps, value), numberOf(document, steps).has_value()});
    else
        placed = meaningsForTests(document, steps, name, value);
    std::size_t most = 0;
    for (const PlacedMeanings &one : placed)
        most = std::max(most, one.meanings.size());
    const auto &asked = placed.front();
    // Says what is wrong with "2014" as a word, not that it is a number.
    const bool isWord = !asked.isNumber && !asked.meanings.front().is_structured();
    std::optional<Error> refused;
    for (std::size_t i = 0; i < most; ++i) {
        json changed = file;
        for (const PlacedMeanings &one : placed)
            setAt(changed, stepsOf(one.place + name), one.meanings[std::min(i, one.meanings.size() - 1)],
                  path);
        try {
            Document result = readDocument(QByteArray::fromStdString(compactJson(changed)));
            requirePossible(document, result);
            return result;
        } catch (const Error &error) {
            if (!refused || isWord)
                refused = error;
        }
    }
    if (mayBeGrouped(value))
        refuseGrouped(name, value);
    throw Error(*refused);
}

bool mayBeGrouped(std::string_view number) {
    number.remove_prefix(number.starts_with('+') || number.starts_with('-') ? 1 : 0);
    constexpr std::size_t group = 3;
    const std::size_t head = number.find(',');
    if (head == std::string_view::npos || head == 0 || head > group || number.front() == '0' ||
        (number.size() - head) % (group + 1) != 0)
        return false;
    for (std::size_t i = 0; i < number.size(); ++i) {
        const bool isMark = i >= head && (i - head) % (group + 1) == 0;
        if (isMark ? number[i] != ',' : !isDigit(number[i]))
            return false;
    }
    return true;
}

} // namespace palmer
