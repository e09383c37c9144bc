// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/bounds.h"

#include "document/documenterror.h"
#include "document/fields.h"
#include "document/place.h"
#include "document/refuse.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

std::size_t lengthOf(const std::string &utf8) {
    return static_cast<std::size_t>(std::count_if(
        utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void demandLength(const std::string &text, const Place &place, unsigned demands) {
    const std::size_t most = (demands & longText) != 0 ? mostOfText : mostOfLine;
    if ((demands & base64) != 0 || text.size() <= most)
        return;
    if (const std::size_t length = lengthOf(text); length > most)
        refuseAt(place, REPORT_TEXT("report", "this text has %1 characters; expected no more than %2"),
                 {countOf(length), countOf(most)});
}

bool isReading(double value) {
    return std::abs(value) <= mostOfReading;
}

bool isReading(const std::optional<double> &value) {
    return !value || isReading(*value);
}

void demandReading(double value, const Place &place, unsigned demands) {
    if ((demands & reading) != 0 && !isReading(value))
        refuseAt(place,
                 REPORT_TEXT("report", "expected a reading between −%1 and %1 mm (rotary axis: degrees)"),
                 {Number{mostOfReading, Quantity::count, 0}});
}

/// Visits the fields of a struct; the functions for values are members, for they call each other.
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
            demandReading(value, place, demands);
        }
    }

private:
    static void check(const std::string &text, const Place &place, unsigned demands) {
        demandLength(text, place, demands);
    }
    static void check(const Point3 &, const Place &, unsigned) {}
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
        // Of millions of readings that keep to the bounds none needs its place.
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
            if (std::ranges::all_of(values, [](const T &value) { return isReading(value); }))
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

void demandBounds(const Document &document) {
    BoundsVisitor::check(document, Place(), nothing);
}

} // namespace palmer
