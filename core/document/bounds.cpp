// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/bounds.h"

#include "document/documenterror.h"
#include "document/fields.h"
#include "document/place.h"
#include "document/refuse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

std::size_t lengthOf(const std::string &utf8) {
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void requireLength(const std::string &text, const Place &place, unsigned demands) {
    const std::size_t most = (demands & longText) != 0 ? mostOfText : mostOfLine;
    if ((demands & base64) != 0 || text.size() <= most)
        return;
    if (const std::size_t length = lengthOf(text); length > most)
        refuseAt(place, REPORT_TEXT("report", "this text has %1 characters; expected no more than %2"),
                 {countOf(length), countOf(most)});
}

struct Bounds {
    unsigned demand = nothing;
    double least = 0;
    double most = 0;
    Text expected; ///< %1: the maximum, %2: the minimum
};
constexpr std::array<Bounds, 3> allBounds{{
    {reading, -mostOfReading, mostOfReading,
     REPORT_TEXT("report", "expected a reading between −%1 and %1 mm (rotary axis: degrees)")},
    {celsius, leastTemperature, std::numeric_limits<double>::infinity(),
     REPORT_TEXT("report", "expected a temperature of %2 or more")},
    {coefficient, -mostOfExpansion, mostOfExpansion,
     REPORT_TEXT("report", "expected a coefficient of expansion between −%1 and %1 µm/(m·°C)")},
}};

/// Values that a statement can have.
struct Possible {
    unsigned demand = nothing;
    bool (*holds)(double) = nullptr;
    Text expected;
};
constexpr std::array allPossible{
    Possible{positive, [](double value) { return value > 0; },
             REPORT_TEXT("report", "expected a number greater than 0")},
    Possible{notNegative, [](double value) { return value >= 0; },
             REPORT_TEXT("report", "expected a number that is not negative")},
    Possible{percentage, [](double value) { return value >= 0 && value <= 100; },
             REPORT_TEXT("report", "expected a percentage from 0 to 100")},
    Possible{coefficient, [](double value) { return value == 0 || std::abs(value) >= leastOfExpansion; },
             REPORT_TEXT("report", "expected 0 or a coefficient in µm/(m·°C), such as 11.5 for steel")},
};

/// Returns the violated bounds, or null if the value is within all of them.
const Bounds *brokenBounds(double value, unsigned demands) {
    const auto broken = std::ranges::find_if(allBounds, [&](const Bounds &bounds) {
        return (demands & bounds.demand) != 0 && !(bounds.least <= value && value <= bounds.most);
    });
    return broken == allBounds.end() ? nullptr : &*broken;
}

bool isWithin(const std::optional<double> &value, unsigned demands) {
    return !value || !brokenBounds(*value, demands);
}

/// Visits the fields of a struct; the functions for values are members because they call each other.
class BoundsVisitor {
public:
    explicit BoundsVisitor(const Place &place)
        : m_place(place) {}

    template <class T>
    void operator()(const char *key, const T &member, unsigned demands = nothing) {
        check(member, Place(m_place, key), demands);
    }
    void object(const char *key, const auto &members) {
        const Place place(m_place, key);
        BoundsVisitor visitor(place);
        members(visitor);
    }
    void extensions(const char *, const std::string &) {}

    template <class T>
    static void check(const T &value, const Place &place, unsigned demands) {
        if constexpr (std::is_class_v<T>) {
            BoundsVisitor visitor(place);
            fields(visitor, value);
        } else if constexpr (std::is_same_v<T, double>) {
            if (const auto message = beyondBounds(value, demands))
                refuseAt(place, message->text, message->arguments);
        }
    }

private:
    static void check(const std::string &text, const Place &place, unsigned demands) {
        requireLength(text, place, demands);
    }
    static void check(const Point3 &, const Place &, unsigned) {}
    static void check(const Permitted &, const Place &, unsigned) {}
    static void check(const TestPointer &test, const Place &place, unsigned demands) {
        check(*test, place, demands);
    }
    template <class T>
    static void check(const std::optional<T> &value, const Place &place, unsigned demands) {
        if (value)
            check(*value, place, demands);
    }
    template <class T>
    static void check(const std::vector<T> &values, const Place &place, unsigned demands) {
        // Readings within bounds need no Place: there may be millions of them.
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
            if (std::ranges::all_of(values, [&](const T &value) { return isWithin(value, demands); }))
                return;
        }
        for (std::size_t i = 0; i < values.size(); ++i)
            check(values[i], Place(place, i), demands);
    }
    template <class T>
    static void check(const std::map<std::string, T> &values, const Place &place, unsigned demands) {
        for (const auto &[key, value] : values)
            check(value, Place(place, key), demands);
    }

    const Place &m_place;
};

} // namespace

std::size_t lengthOf(QStringView text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](QChar c) { return !c.isLowSurrogate(); }));
}

std::optional<Message> beyondBounds(double value, unsigned demands) {
    const Bounds *broken = brokenBounds(value, demands);
    return broken ? std::optional(Message{broken->expected,
                                          {Number{broken->most, Quantity::count, 0},
                                           Number{broken->least, Quantity::temperature}},
                                          {}})
                  : std::nullopt;
}

std::optional<Text> expectedInstead(double value, unsigned demands) {
    const auto broken = std::ranges::find_if(allPossible, [&](const Possible &possible) {
        return (demands & possible.demand) != 0 && !possible.holds(value);
    });
    return broken == allPossible.end() ? std::nullopt : std::optional(broken->expected);
}

void requireBounds(const Document &document) {
    BoundsVisitor::check(document, Place(), nothing);
}

} // namespace palmer
