// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readdocument.h"

#include "document/bounds.h"
#include "document/copyfields.h"
#include "document/fileversion.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/place.h"
#include "document/refuse.h"
#include "document/refusedreadings.h"
#include "document/windowthread.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"

#include <QStringDecoder>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string_view>

namespace palmer {

namespace {

using nlohmann::json;

// Returns the value if the text is all digits, otherwise −1.
int digits(std::string_view text) {
    int value = -1;
    if (std::all_of(text.begin(), text.end(), isDigit))
        std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

bool isDate(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-')
        return false;
    const int year = digits(text.substr(0, 4));
    const int month = digits(text.substr(5, 2));
    const int day = digits(text.substr(8, 2));
    return year > 0 && month > 0 && day > 0 &&
           std::chrono::year_month_day(std::chrono::year(year),
                                       std::chrono::month(static_cast<unsigned>(month)),
                                       std::chrono::day(static_cast<unsigned>(day)))
               .ok();
}

bool isTimeOfDay(std::string_view text) {
    if (text.size() != 5 || text[2] != ':')
        return false;
    const int hours = digits(text.substr(0, 2));
    const int minutes = digits(text.substr(3, 2));
    return hours >= 0 && hours < 24 && minutes >= 0 && minutes < 60;
}

bool isBase64(std::string_view text) {
    if (text.size() % 4 != 0)
        return false;
    for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding)
        text.remove_suffix(1);
    return std::all_of(text.begin(), text.end(), [](char c) {
        return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '/';
    });
}

void require(bool holds, const Place &place, const Text &otherwise) {
    if (!holds)
        refuseAt(place, otherwise);
}

/// Refuses keys that are neither fields of the struct nor in `others`.
void requireKnown(FieldKeys &fieldKeys, const json &object, const Place &place,
                  std::initializer_list<std::string_view> others) {
    auto keys = fieldKeys.take();
    keys.insert(keys.end(), others);
    for (const auto &[key, value] : object.get_ref<const json::object_t &>())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            refuseAt(Place(place, key),
                     REPORT_TEXT("report", "this key is unknown; what others want to add goes "
                                           "into “extensions”"));
}

// ---- Checks beyond types -------------------------------------------------------------------------

void requireEqual(std::size_t found, std::size_t expected, const Place &place) {
    if (found != expected)
        refuseAt(place, REPORT_TEXT("report", "number of values found: %1; expected: %2"),
                 {countOf(found), countOf(expected)});
}

template <class T>
void check(const T &, const Place &) {} // most structs are valid if their fields are

void check(const Interval &interval, const Place &place) {
    require(interval.from < interval.to, place,
            REPORT_TEXT("report", "expected “from” to be less than “to”"));
}

void check(const TemperatureSeries &series, const Place &place) {
    requireEqual(series.temperatures.size(), series.times.size(), Place(place, "temperatures"));
}

void check(const Arc &arc, const Place &place) {
    requireEqual(arc.radialDeviations.size(), arc.angles.size(), Place(place, "radialDeviations"));
}

void check(const DriftMeasurement &measurement, const Place &place) {
    const std::size_t count = measurement.times.size();
    if (measurement.channels.empty())
        requireEqual(measurement.deviations.size(), count, Place(place, "deviations"));
    else
        require(measurement.deviations.empty(), Place(place, "deviations"),
                REPORT_TEXT("report", "expected nothing here, for “channels” has the readings"));
    const auto requireAll = [&](const char *key, const auto &series) {
        const Place atSeries(place, key);
        for (std::size_t i = 0; i < series.size(); ++i) {
            const Place at(atSeries, i);
            requireEqual(series[i].values.size(), count, Place(at, "values"));
        }
    };
    requireAll("channels", measurement.channels);
    requireAll("temperatures", measurement.temperatures);
    if (!measurement.channels.empty() && !std::ranges::is_sorted(measurement.times)) {
        const auto at = std::ranges::is_sorted_until(measurement.times);
        const Place atTimes(place, "times");
        refuseAt(Place(atTimes, static_cast<std::size_t>(at - measurement.times.begin())),
                 REPORT_TEXT("report", "expected times that ascend"));
    }
}

void check(const PositioningMeasurement &measurement, const Place &place) {
    const Place atTargets(place, "targets");
    const auto &targets = measurement.targets;
    for (std::size_t i = 1; i < targets.size(); ++i)
        if (!(targets[i - 1] < targets[i]))
            refuseAt(Place(atTargets, i), REPORT_TEXT("report", "expected targets that ascend strictly"));

    const Place atRuns(place, "runs");
    for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
        const Place atRun(atRuns, j);
        requireEqual(measurement.runs[j].deviations.size(), targets.size(), Place(atRun, "deviations"));
    }

    const Place atExcluded(place, "excluded");
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < measurement.excluded.size(); ++i) {
        const Place at(atExcluded, i);
        const ExcludedReading &excluded = measurement.excluded[i];
        const auto run = static_cast<std::size_t>(excluded.run) - 1;
        const auto target = static_cast<std::size_t>(excluded.target) - 1;
        if (run >= measurement.runs.size())
            refuseAt(Place(at, "run"), REPORT_TEXT("report", "expected the number of a run, from 1 to %1"),
                     {countOf(measurement.runs.size())});
        if (target >= targets.size())
            refuseAt(Place(at, "target"),
                     REPORT_TEXT("report", "expected the number of a target, from 1 to %1"),
                     {countOf(targets.size())});
        if (measurement.runs[run].deviations[target]) {
            const Place atRun(atRuns, run);
            const Place atDeviations(atRun, "deviations");
            refuseAt(Place(atDeviations, target),
                     REPORT_TEXT("report", "expected null, for this reading stands in “excluded”"));
        }
        require(seen.emplace(excluded.run, excluded.target).second, at,
                REPORT_TEXT("report", "this reading is excluded twice; expected it once"));
    }
}

void requireEdition(const std::string &word, const Place &place) {
    if (!findEdition(word))
        refuseAt(place,
                 REPORT_TEXT("report", "unknown edition “%1”; expected a designation such as ISO 230-2:1988"),
                 {excerpt(word)});
}

void check(const CircularMeasurement &measurement, const Place &place) {
    const Place atUncertainty(place, "uncertainty");
    if (measurement.uncertainty.method == UncertaintyMethod::budgetActual)
        refuseAt(Place(atUncertainty, "method"),
                 REPORT_TEXT("report", "the budget with the actual targets is for positioning tests"));
}

void check(const Limit &limit, const Place &place) {
    if (limit.edition)
        requireEdition(*limit.edition, Place(place, "edition"));
}

void check(const SheetRow &row, const Place &place) {
    const std::array own{std::pair{"permitted", row.permitted.high.has_value()},
                         std::pair{"measured", row.measured.has_value()},
                         std::pair{"uncertainty", row.uncertainty.has_value()},
                         std::pair{"unit", !row.unit.empty()}};
    for (const auto &[key, stated] : own)
        require(!row.from || !stated, Place(place, key),
                REPORT_TEXT("report", "expected nothing here, for “from” takes it from a test"));
}

void check(const ReportHead &report, const Place &place) {
    const Place atSheet(place, "sheet");
    std::set<std::string_view> numbers;
    for (std::size_t i = 0; i < report.sheet.size(); ++i) {
        const std::string &number = report.sheet[i].number;
        if (!number.empty() && !numbers.insert(number).second)
            refuseAt(Place(Place(atSheet, i), "number"),
                     REPORT_TEXT("report", "“%1” stands here twice; expected it once"), {excerpt(number)});
    }

    require(!report.languages.empty(), Place(place, "languages"),
            REPORT_TEXT("report", "expected at least one language"));
    const Place at(place, "editions");
    for (std::size_t i = 0; i < report.editions.size(); ++i)
        requireEdition(report.editions[i], Place(at, i));
    const auto left = std::ranges::find(report.leaveOut, ReportPart::diagnosis);
    if (left != report.leaveOut.end())
        refuseAt(Place(Place(place, "leaveOut"), static_cast<std::size_t>(left - report.leaveOut.begin())),
                 REPORT_TEXT("report", "the diagnosis is printed only where “include” asks for it; take the "
                                       "word out of this list"));
}

void requireParameter(Kind kind, const std::string &id, const Place &place) {
    if (!isParameter(kind, id))
        refuseAt(
            place,
            REPORT_TEXT("report", "unknown parameter “%1”; expected one of this kind of test, such as %2"),
            {excerpt(id), std::string(termsOf(defaultEdition(kind)).front()->id)});
}

void check(const Test &test, const Place &place) {
    const Kind kind = kindOf(test);
    std::visit([&](const auto &measurement) { check(measurement, place); }, test.measurement);
    if (!isJudged(test))
        return;

    requireEdition(test.edition, Place(place, "edition"));
    if (findEdition(test.edition)->kind != kind)
        refuseAt(Place(place, "edition"), REPORT_TEXT("report", "“%1” is not for this kind of test"),
                 {test.edition});

    const Place atLimits(place, "limits");
    for (const auto &[id, limit] : test.limits)
        requireParameter(kind, id, Place(atLimits, id));
    const Place atUncertainty(place, "uncertainty");
    const Place atExpanded(atUncertainty, "expanded");
    withUncertainty(test, [&](const auto &inputs) {
        for (const auto &[id, value] : inputs.expanded)
            requireParameter(kind, id, Place(atExpanded, id));
    });
    const Place atResults(place, "requiredResults");
    const auto *required = partOr<const std::vector<std::string> *>(
        nullptr, test.measurement,
        [](auto &m) -> decltype(&m.requiredResults) { return &m.requiredResults; });
    for (std::size_t i = 0; required && i < required->size(); ++i)
        requireParameter(kind, (*required)[i], Place(atResults, i));

    const Place atPoints(place, "agreedPoints");
    std::set<std::string_view> points;
    for (std::size_t i = 0; i < test.agreedPoints.size(); ++i) {
        const std::string &point = test.agreedPoints[i].point;
        const Place at(atPoints, i);
        if (!isAgreementPoint(kind, point))
            refuseAt(
                Place(at, "point"),
                REPORT_TEXT("report", "unknown point “%1”; expected one that this kind of test agrees on"),
                {excerpt(point)});
        if (!points.insert(point).second)
            refuseAt(Place(at, "point"), REPORT_TEXT("report", "“%1” stands here twice; expected it once"),
                     {point});
    }
}

// Ids are unique, and referenced ones exist.
void check(const Document &document, const Place &place) {
    const auto requireNew = [](std::set<std::string_view> &ids, const std::string &id, const Place &at) {
        if (!id.empty() && !ids.insert(id).second)
            refuseAt(Place(at, "id"), REPORT_TEXT("report", "“%1” stands here twice; expected it once"),
                     {excerpt(id)});
    };
    std::set<std::string_view> instruments;
    const Place atInstruments(place, "instruments");
    for (std::size_t i = 0; i < document.instruments.size(); ++i)
        requireNew(instruments, document.instruments[i].id, Place(atInstruments, i));

    std::set<std::string_view> tests;
    std::set<std::string_view> drifts;
    std::set<std::string_view> judged;
    const Place atTests(place, "tests");
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        const Test &test = *document.tests[i];
        requireNew(tests, test.id, Place(atTests, i));
        if (isDrift(test) && !test.id.empty())
            drifts.insert(test.id);
        if (isJudged(test) && !test.id.empty())
            judged.insert(test.id);
    }

    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        const Test &test = *document.tests[i];
        const Place atTest(atTests, i);
        const Place atNames(atTest, "instruments");
        for (std::size_t k = 0; k < test.instruments.size(); ++k)
            if (!instruments.contains(test.instruments[k]))
                refuseAt(Place(atNames, k),
                         REPORT_TEXT("report", "expected the id of an instrument of this file; “%1” is none"),
                         {excerpt(test.instruments[k])});
        if (const auto &compared = test.comparedWith;
            compared && (compared->test == test.id || !judged.contains(compared->test)))
            refuseAt(Place(Place(atTest, "comparedWith"), "test"),
                     REPORT_TEXT("report", "expected the id of another test of this file, no drift test; "
                                           "“%1” is none"),
                     {excerpt(compared->test)});
        const std::string *drift = driftTestOf(test);
        const Place atUncertainty(atTest, "uncertainty");
        if (drift && !drifts.contains(*drift))
            refuseAt(Place(atUncertainty, "driftTest"),
                     REPORT_TEXT("report", "expected the id of a drift test of this file; “%1” is none"),
                     {excerpt(*drift)});
    }
}

// ---- Reading
// ---------------------------------------------------------------------------------------------------

// Fills the fields of a struct from an object. The functions for values are members because they call each
// other.
class ObjectReader {
public:
    ObjectReader(const json &object, const Place &place)
        : m_object(object)
        , m_place(place) {}

    template <class T>
    void operator()(const char *key, T &member, unsigned demands = nothing) {
        const auto entry = m_object.find(key);
        const bool unsaid = entry != m_object.end() && (demands & latest) != 0 && entry->is_null();
        if (entry != m_object.end() && !unsaid)
            read(*entry, member, Place(m_place, key), demands);
        else if ((demands & obligatory) != 0)
            refuseAt(m_place, REPORT_TEXT("report", "the key “%1” is missing"), {std::string(key)});
    }

    void object(const char *key, const auto &members) {
        const auto entry = m_object.find(key);
        if (entry == m_object.end())
            return;
        const Place place(m_place, key);
        requireObject(*entry, place);
        FieldKeys keys;
        members(keys);
        requireKnown(keys, *entry, place, {});
        ObjectReader reader(*entry, place);
        members(reader);
    }

    void extensions(const char *key, std::string &text) {
        const auto entry = m_object.find(key);
        if (entry == m_object.end())
            return;
        requireObject(*entry, Place(m_place, key));
        text = compactJson(*entry);
    }

    template <class Struct>
    requires std::is_class_v<Struct>
    static void read(const json &value, Struct &member, const Place &place, unsigned = nothing) {
        readStruct(value, member, place, {});
    }

    template <class Struct>
    static void readStruct(const json &value, Struct &member, const Place &place,
                           std::initializer_list<std::string_view> otherKeys) {
        requireObject(value, place);
        FieldKeys keys;
        fields(keys, member);
        requireKnown(keys, value, place, otherKeys);
        ObjectReader reader(value, place);
        fields(reader, member);
        check(member, place);
    }

    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    static void read(const json &value, Enumeration &member, const Place &place, unsigned = nothing) {
        const auto *const text = value.get_ptr<const std::string *>();
        if (!text)
            refuseAt(place, REPORT_TEXT("report", "expected one of the words: %1"), {words<Enumeration>()});
        const auto row = std::ranges::find_if(fileWords<Enumeration>,
                                              [text](const auto &known) { return *text == known.word; });
        if (row == fileWords<Enumeration>.end())
            refuseAt(place, REPORT_TEXT("report", "unknown word “%1”; expected one of: %2"),
                     {excerpt(*text), words<Enumeration>()});
        member = row->value;
    }

private:
    template <class Enumeration>
    static std::string words() {
        std::string result;
        for (const auto &row : fileWords<Enumeration>) {
            if (isOffered(row.value))
                result += (result.empty() ? "" : " · ") + std::string(row.word);
        }
        return result;
    }

    /// True if error messages list this word: not if it is refused.
    template <class Enumeration>
    static bool isOffered(Enumeration value) {
        if constexpr (std::is_same_v<Enumeration, ReportPart>)
            return value != ReportPart::diagnosis; // see check() of ReportHead
        else
            return true;
    }

    static void requireObject(const json &value, const Place &place) {
        require(value.is_object(), place, REPORT_TEXT("report", "expected an object, in braces"));
    }

    static void requireArray(const json &value, const Place &place) {
        require(value.is_array(), place, REPORT_TEXT("report", "expected a list, in square brackets"));
    }

    static void read(const json &value, double &member, const Place &place, unsigned demands = nothing) {
        require(value.is_number(), place, REPORT_TEXT("report", "expected a number"));
        member = value.get<double>();
        requireSign(member, place, demands);
    }

    static void requireSign(double value, const Place &place, unsigned demands) {
        if (const auto expected =
                (demands & questioned) == 0 ? expectedInstead(value, demands) : std::nullopt)
            refuseAt(place, *expected);
        require((demands & trialCount) == 0 || (value >= 1 && value <= double(mostTrialsStated)), place,
                REPORT_TEXT("report", "expected a whole number from 1 to 1 000 000 000"));
    }

    // 5.0 is also an integer, as in JSON Schema.
    template <class Integer>
    static void readWhole(const json &value, Integer &member, const Place &place, unsigned demands) {
        constexpr auto least = std::numeric_limits<Integer>::min();
        constexpr auto most = std::numeric_limits<Integer>::max();
        bool fits = false;
        if (value.is_number_unsigned()) {
            fits = value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most);
        } else if (value.is_number_integer()) {
            const auto whole = value.get<std::int64_t>();
            fits = whole >= least && whole <= most;
        } else if (value.is_number_float()) {
            const double number = value.get<double>();
            // −least is a power of two, exact in a double; most is not.
            fits = std::trunc(number) == number && number >= static_cast<double>(least) &&
                   number < -static_cast<double>(least);
        }
        require(fits, place, REPORT_TEXT("report", "expected a whole number"));
        member = value.get<Integer>();
        requireSign(static_cast<double>(member), place, demands);
    }

    static void read(const json &value, int &member, const Place &place, unsigned demands = nothing) {
        readWhole(value, member, place, demands);
    }

    static void read(const json &value, long long &member, const Place &place, unsigned demands = nothing) {
        readWhole(value, member, place, demands);
    }

    static void read(const json &value, bool &member, const Place &place, unsigned = nothing) {
        require(value.is_boolean(), place, REPORT_TEXT("report", "expected true or false"));
        member = value.get<bool>();
    }

    static void read(const json &value, std::string &member, const Place &place, unsigned demands = nothing) {
        const auto *const text = value.get_ptr<const std::string *>();
        if (!text)
            refuseAt(place, REPORT_TEXT("report", "expected a text, in quotation marks"));
        require((demands & date) == 0 || isDate(*text), place,
                REPORT_TEXT("report", "expected a date that exists, written YYYY-MM-DD"));
        require((demands & timeOfDay) == 0 || isTimeOfDay(*text), place,
                REPORT_TEXT("report", "expected a time of day, written HH:MM"));
        require((demands & base64) == 0 || isBase64(*text), place,
                REPORT_TEXT("report", "expected bytes in base64"));
        const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
        require((demands & countryCode) == 0 || text->empty() ||
                    (text->size() == 2 && std::ranges::all_of(*text, isCapital)),
                place,
                REPORT_TEXT("report", "expected a country as two capital letters (ISO 3166-1), as FR"));
        member = *text;
    }

    template <class T>
    static void read(const json &value, std::optional<T> &member, const Place &place,
                     unsigned demands = nothing) {
        member.reset();
        if (value.is_null())
            return;
        requireTypeOrNull<T>(value, place);
        read(value, member.emplace(), place, demands);
    }

    /// The message says that null is allowed, too.
    template <class T>
    static void requireTypeOrNull(const json &value, const Place &place) {
        if constexpr (std::is_same_v<T, bool>)
            require(value.is_boolean(), place, REPORT_TEXT("report", "expected true, false or null"));
        else if constexpr (std::is_same_v<T, double>)
            require(value.is_number(), place, REPORT_TEXT("report", "expected a number or null"));
        else if constexpr (std::is_integral_v<T>)
            require(value.is_number(), place, REPORT_TEXT("report", "expected a whole number or null"));
        else if constexpr (std::is_same_v<T, std::string>)
            require(value.is_string(), place,
                    REPORT_TEXT("report", "expected a text, in quotation marks, or null"));
        else if constexpr (std::is_class_v<T>)
            require(value.is_object(), place,
                    REPORT_TEXT("report", "expected an object, in braces, or null"));
        else if (!value.is_string())
            refuseAt(place, REPORT_TEXT("report", "expected null or one of the words: %1"), {words<T>()});
    }

    template <class T>
    static void read(const json &value, std::vector<T> &member, const Place &place, unsigned = nothing) {
        requireArray(value, place);
        const auto &entries = value.get_ref<const json::array_t &>();
        member.clear();
        member.reserve(entries.size());
        for (std::size_t i = 0; i < entries.size(); ++i)
            read(entries[i], member.emplace_back(), Place(place, i));
        if constexpr (std::is_enum_v<T>)
            for (std::size_t i = 0; i < member.size(); ++i)
                if (std::find(member.begin(), member.begin() + static_cast<std::ptrdiff_t>(i), member[i]) !=
                    member.begin() + static_cast<std::ptrdiff_t>(i))
                    refuseAt(Place(place, i),
                             REPORT_TEXT("report", "“%1” stands here twice; expected it once"),
                             {std::string(fileWord(member[i]))});
    }

    static void read(const json &value, Point3 &member, const Place &place, unsigned = nothing) {
        requireArray(value, place);
        requireEqual(value.size(), member.size(), place);
        for (std::size_t i = 0; i < member.size(); ++i)
            read(value[i], member[i], Place(place, i));
    }

    /// A number, or the smallest and the largest value.
    static void read(const json &value, Permitted &member, const Place &place, unsigned = nothing) {
        const auto number = [&](const json &one, const Place &at) {
            require(one.is_number(), at, REPORT_TEXT("report", "expected a number"));
            return one.get<double>();
        };
        if (!value.is_array()) {
            require(value.is_number(), place,
                    REPORT_TEXT("report", "expected a number, a list of the least and the largest value, or "
                                          "null"));
            member = {std::nullopt, number(value, place)};
            requireSign(*member.high, place, notNegative);
            return;
        }
        requireEqual(value.size(), 2, place);
        member = {number(value[0], Place(place, std::size_t{0})),
                  number(value[1], Place(place, std::size_t{1}))};
        require(*member.low <= *member.high, place,
                REPORT_TEXT("report", "expected the least value before the largest"));
    }

    template <class T>
    static void read(const json &value, std::map<std::string, T> &member, const Place &place,
                     unsigned demands = nothing) {
        requireObject(value, place);
        member.clear();
        for (const auto &[key, entry] : value.get_ref<const json::object_t &>())
            read(entry, member[key], Place(place, key), demands);
    }

    static void read(const json &value, TestPointer &member, const Place &place, unsigned = nothing) {
        requireObject(value, place);
        const auto kindWord = value.find("kind");
        if (kindWord == value.end())
            refuseAt(place, REPORT_TEXT("report", "the key “%1” is missing"), {std::string("kind")});
        Kind kind{};
        read(*kindWord, kind, Place(place, "kind"));
        Test test = testOf(kind);
        readStruct(value, test, place, {"kind"});
        readRefusedReadings(test);
        member = std::make_shared<const Test>(std::move(test));
    }

    const json &m_object;
    const Place &m_place;
};

void requireFormat(const json &file) {
    const auto format = file.is_object() ? file.find("format") : file.end();
    if (!file.is_object() || format == file.end() || *format != fileFormat)
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this is not a test file of Palmer; expected %1"),
                     {std::string(R"("format": ")") + fileFormat + '"'},
                     {}});
}

void migrate(json &file) {
    const Place root;
    const Place place(root, "version");
    const auto version = file.find("version");
    if (version == file.end())
        refuseAt(root, REPORT_TEXT("report", "the key “%1” is missing"), {std::string("version")});
    const double number = version->is_number() ? version->get<double>() : 0;
    require(number >= 1 && std::trunc(number) == number, place,
            REPORT_TEXT("report", "expected a whole number from 1 on"));
    if (number > static_cast<double>(fileVersion))
        throw Error(
            Error::Kind::newerVersion,
            {REPORT_TEXT("report", "the file was written by a newer version of Palmer (format %1); this one "
                                   "reads up to format %2: install a newer Palmer"),
             {Number{number, Quantity::count, 0},
              Number{static_cast<double>(fileVersion), Quantity::count, 0}},
             {}},
            place.text());
    for (const Migration step :
         std::span<const Migration>(migrations).subspan(static_cast<std::size_t>(number) - 1))
        step(file);
}

/// Frees lists at once; the library would first move each value to a stack.
void release(json &value) {
    if (auto *const object = value.get_ptr<json::object_t *>()) {
        for (auto &[key, entry] : *object)
            release(entry);
    } else if (auto *const array = value.get_ptr<json::array_t *>()) {
        for (json &entry : *array)
            if (entry.is_structured())
                release(entry);
        array->clear();
    }
}

/// Editors may save the text as UTF-16 or UTF-32, with or without a byte order mark; the content is the same.
QByteArray inUtf8(const QByteArray &bytes) {
    const auto encoding = QStringConverter::encodingForData(bytes, u'{');
    if (!encoding || *encoding == QStringConverter::Utf8)
        return bytes;
    QStringDecoder decoder(*encoding);
    const QString text = decoder.decode(bytes);
    if (decoder.hasError())
        throw Error(Error::Kind::syntax,
                    {REPORT_TEXT("report", "there are characters in it that are none of UTF-16 or UTF-32; "
                                           "expected a test file in UTF-8")});
    return text.toUtf8();
}

} // namespace

void stateAgreements(json &file) {
    const auto report = file.find("report");
    if (report != file.end() && report->is_object() && report->contains("leaveOut") &&
        (*report)["leaveOut"].is_array()) {
        auto &words = (*report)["leaveOut"].get_ref<json::array_t &>();
        const auto diagnosis = std::ranges::find(words, json(fileWord(ReportPart::diagnosis)));
        if (diagnosis != words.end()) // only once: a duplicate word is refused
            words.erase(diagnosis);
    }
    const auto tests = file.find("tests");
    if (tests == file.end() || !tests->is_array())
        return; // the reader reports the error
    for (json &test : *tests) {
        const auto points = test.is_object() ? test.find("agreedPoints") : test.end();
        if (!test.is_object() || points == test.end() || !points->is_array())
            continue;
        for (json &point : *points) {
            if (point.is_object() && !point.contains("state"))
                point["state"] = fileWord(AgreementState::notAgreed);
        }
    }
}

Document readUnbounded(const QByteArray &bytes) {
    const QByteArray text = inUtf8(bytes);
    json file = parseJson({text.constData(), static_cast<std::size_t>(text.size())});
    requireFormat(file);
    migrate(file);
    Document document;
    ObjectReader::readStruct(file, document, {}, {"format", "version"});
    release(file);
    return document;
}

Document readDocument(const QByteArray &bytes) {
    Document document = readUnbounded(bytes);
    requireBackground(document);
    requireBounds(document);
    return document;
}

} // namespace palmer
