// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/writedocument.h"

#include "document/fields.h"
#include "document/fileversion.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/refusedreadings.h"
#include "document/windowthread.h"
#include "kernel/measurement/testfacts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <vector>

namespace palmer {

namespace {

using nlohmann::json;

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::same_as<T, std::string>;

template <class T>
constexpr bool isScalar = Scalar<T>;
template <class T>
constexpr bool isScalar<std::optional<T>> = Scalar<T>;

/// Collects the members of an object, which refer to the struct; the functions for values are members because
/// they call each other.
class ObjectWriter {
public:
    template <class T>
    void operator()(std::string_view key, const T &member, unsigned demands = nothing) {
        if ((demands & (added | latest | leftOut)) != 0 && member == T{})
            return; // older programs then read as much as they can
        m_members.push_back({key, isSmall(member), [&member](JsonPrinter &printer, const Place &place) {
                                 print(printer, member, place);
                             }});
    }

    void object(const char *key, const auto &members) {
        ObjectWriter inner;
        members(inner);
        m_members.push_back({key, false, [inner = inner.sorted()](JsonPrinter &printer, const Place &place) {
                                 printer.object(inner, place);
                             }});
    }

    void extensions(const char *key, const std::string &text) {
        json value = parseJson(text);
        if (m_test)
            addRefusedReadings(*m_test, value);
        m_members.push_back(jsonMember(key, std::move(value)));
    }

    void word(std::string_view key, const char *value) {
        m_members.push_back(
            {key, true, [value](JsonPrinter &printer, const Place &) { printer.text(value); }});
    }

    [[nodiscard]] std::vector<JsonMember> sorted() {
        std::ranges::sort(m_members, {}, &JsonMember::key);
        return std::move(m_members);
    }

private:
    template <Scalar T>
    static bool isSmall(const T &) {
        return true;
    }
    template <class T>
    static bool isSmall(const std::optional<T> &value) {
        return !value || isSmall(*value);
    }
    template <class T>
    static bool isSmall(const std::vector<T> &values) {
        return values.empty() || (isScalar<T> && JsonPrinter::isSmallList(values.size()));
    }
    static bool isSmall(const Point3 &) { return true; }
    static bool isSmall(const Permitted &) { return true; }
    template <class T>
    static bool isSmall(const std::map<std::string, T> &values) {
        return values.empty();
    }
    template <class Struct>
    static bool isSmall(const Struct &) {
        return false;
    }

    static void print(JsonPrinter &printer, const std::string &value, const Place &) { printer.text(value); }
    static void print(JsonPrinter &printer, bool value, const Place &) {
        printer.word(value ? "true" : "false");
    }
    static void print(JsonPrinter &printer, double value, const Place &place) {
        printer.number(value, place);
    }
    static void print(JsonPrinter &printer, std::integral auto value, const Place &) { printer.whole(value); }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    static void print(JsonPrinter &printer, Enumeration value, const Place &) {
        printer.text(fileWord(value));
    }
    template <class T>
    static void print(JsonPrinter &printer, const std::optional<T> &value, const Place &place) {
        if (value)
            print(printer, *value, place);
        else
            printer.word("null");
    }
    template <class T>
    static void print(JsonPrinter &printer, const std::vector<T> &values, const Place &place) {
        printList<T>(printer, values, place);
    }
    static void print(JsonPrinter &printer, const Point3 &values, const Place &place) {
        printList<Point3::value_type>(printer, values, place);
    }
    static void print(JsonPrinter &printer, const Permitted &value, const Place &place) {
        if (value.low)
            printList<double>(printer, std::array{*value.low, value.high.value_or(0)}, place);
        else
            print(printer, value.high, place);
    }
    template <class T>
    static void print(JsonPrinter &printer, const std::map<std::string, T> &values, const Place &place) {
        ObjectWriter writer;
        for (const auto &[key, value] : values)
            writer(key.c_str(), value);
        printer.object(writer.sorted(), place);
    }
    static void print(JsonPrinter &printer, const TestPointer &test, const Place &place) {
        ObjectWriter writer;
        writer.m_test = test.get();
        fields(writer, *test);
        writer.word("kind", fileWord(kindOf(*test)));
        printer.object(writer.sorted(), place);
    }
    template <class Struct>
    requires std::is_class_v<Struct>
    static void print(JsonPrinter &printer, const Struct &value, const Place &place) {
        ObjectWriter writer;
        fields(writer, value);
        printer.object(writer.sorted(), place);
    }

    template <class T>
    static void printList(JsonPrinter &printer, const auto &values, const Place &place) {
        const auto element = [&](JsonPrinter &to, std::size_t i) { print(to, values[i], Place(place, i)); };
        if constexpr (isScalar<T>)
            printer.listOfScalars(values.size(), element);
        else
            printer.list(values.size(), [&](std::size_t i) { element(printer, i); });
    }

    std::vector<JsonMember> m_members;
    const Test *m_test = nullptr; ///< the test whose members these are, or null
};

/// The oldest version that has all fields with a value.
class NeededVersion {
public:
    template <class T>
    void operator()(std::string_view, const T &member, unsigned demands = nothing) {
        if ((demands & (added | latest)) != 0)
            need(!(member == T{}), (demands & latest) != 0 ? 3 : 2);
        else
            look(member);
    }
    void object(const char *, const auto &members) { members(*this); }
    void extensions(const char *, const std::string &) {}
    [[nodiscard]] long long version() const { return m_version; }

private:
    void need(bool used, long long version) {
        m_version = std::max(m_version, used ? version : firstVersion);
    }

    template <class T>
    void look(const T &value) {
        if constexpr (std::is_enum_v<T>)
            need(true, sinceVersion(value));
        else if constexpr (std::same_as<T, TestPointer>) {
            look(kindOf(*value));
            fields(*this, *value);
        } else if constexpr (std::is_class_v<T> && !isScalar<T>)
            fields(*this, value);
    }
    template <class T>
    void look(const std::optional<T> &value) {
        if (value)
            look(*value);
    }
    template <class T>
    void look(const std::vector<T> &values) {
        if constexpr (!isScalar<T> || std::is_enum_v<T>) {
            for (const T &value : values)
                look(value);
        }
    }
    template <class T>
    void look(const std::map<std::string, T> &values) {
        for (const auto &[key, value] : values)
            look(value);
    }
    void look(const Point3 &) {}
    void look(const Permitted &) {}

    long long m_version = firstVersion;
};

} // namespace

QByteArray writeDocument(const Document &document) {
    requireBackground(document);
    ObjectWriter file;
    fields(file, document);
    file.word("format", fileFormat);
    NeededVersion needed;
    fields(needed, document);
    const long long version = needed.version();
    file("version", version);
    JsonPrinter printer(JsonPrinter::Form::lines);
    std::size_t readings = 0;
    for (const TestPointer &test : document.tests)
        readings += readingsOf(*test);
    constexpr std::size_t isLong = 100'000;
    constexpr std::size_t charactersOfReading = 24; // most are shorter; unused memory costs nothing
    if (readings > isLong)
        printer.expect(readings * charactersOfReading);
    printer.object(file.sorted(), {});
    QByteArray text = printer.take();
    text += '\n';
    return text;
}

} // namespace palmer
