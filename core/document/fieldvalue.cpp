// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fieldvalue.h"

#include "document/copyfields.h"

#include <functional>
#include <type_traits>
#include <utility>

namespace palmer {

namespace {

template <class T>
constexpr bool isOptionalWord = false;
template <class T>
constexpr bool isOptionalWord<std::optional<T>> = std::is_enum_v<T>;

template <class T>
concept HasConditions = Like<T, PositioningConditions> || Like<T, CircularConditions>;

/// Finds a field by its key and reads it, or writes it if it is writable.
class FieldFinder {
public:
    FieldFinder(std::string_view key, FieldValue value)
        : m_key(key)
        , m_value(std::move(value)) {}

    template <class T>
    void operator()(std::string_view key, T &member, unsigned demands = nothing) {
        using Member = std::remove_const_t<T>;
        if constexpr (HasConditions<T>) {
            fields(*this, member);
        } else if (key == m_key) {
            m_demands = demands;
            if constexpr (std::is_enum_v<Member>)
                exchange<std::size_t>(
                    member, [](Member word) { return static_cast<std::size_t>(word); },
                    [](std::size_t place) { return static_cast<Member>(place); });
            else if constexpr (isOptionalWord<Member>)
                exchange<std::size_t>(
                    member, [](Member word) { return word ? static_cast<std::size_t>(*word) + 1 : 0; },
                    [](std::size_t place) {
                        return place > 0 ? Member(static_cast<typename Member::value_type>(place - 1))
                                         : Member();
                    });
            else if constexpr (std::is_constructible_v<FieldValue, std::in_place_type_t<Member>>)
                exchange<Member>(member, std::identity(), std::identity());
        }
    }
    void object(const char * /*key*/, const auto & /*members*/) {}
    void extensions(const char * /*key*/, const std::string & /*member*/) {}

    [[nodiscard]] FieldValue take() { return std::move(m_value); }
    [[nodiscard]] unsigned demands() const { return m_demands; }

private:
    template <class Shown, class T>
    void exchange(T &member, auto there, auto back) {
        if constexpr (std::is_const_v<T>)
            m_value = FieldValue(std::in_place_type<Shown>, there(member));
        else if (const Shown *value = std::get_if<Shown>(&m_value))
            member = back(*value);
    }

    std::string_view m_key;
    FieldValue m_value;
    unsigned m_demands = nothing;
};

} // namespace

FieldValue fieldValue(const Test &test, std::string_view key) {
    FieldFinder finder(key, {});
    fields(finder, test);
    return finder.take();
}

unsigned fieldDemands(const Test &test, std::string_view key) {
    FieldFinder finder(key, {});
    fields(finder, test);
    return finder.demands();
}

void setFieldValue(Test &test, std::string_view key, const FieldValue &value) {
    FieldFinder finder(key, value);
    fields(finder, test);
}

std::vector<std::string_view> conditionKeys(const Test &test) {
    FieldKeys keys;
    std::visit(
        [&](const auto &measurement) {
            if constexpr (requires { measurement.conditions; })
                fields(keys, measurement.conditions);
        },
        test.measurement);
    return keys.take();
}

} // namespace palmer
