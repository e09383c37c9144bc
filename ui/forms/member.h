// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/edits.h"
#include "language/language.h"

#include <functional>
#include <type_traits>
#include <utility>

namespace palmer::ui {

/// Input from which a field gets its value.
struct FormSource {
    const Document &document;
    const Test *test = nullptr; ///< null outside of tests
    const Language &language;
};

/// A member of the document shown and changed by a field.
template <class T>
struct Member {
    std::function<T(const FormSource &)> read;
    std::function<void(Document &, std::size_t test, const T &)> write;
};

/// A member of the document: `access(document)` returns a reference to it.
template <class Access>
[[nodiscard]] auto ofDocument(Access access) {
    using T = std::remove_cvref_t<decltype(access(std::declval<Document &>()))>;
    return Member<T>{[access](const FormSource &source) { return access(source.document); },
                     [access](Document &document, std::size_t, const T &value) { access(document) = value; }};
}

/// A member of a test: `access(test)` returns a pointer to it, null if the test has none.
template <class Access>
[[nodiscard]] auto ofTest(Access access) {
    using T = std::remove_cvref_t<decltype(*access(std::declval<Test &>()))>;
    return Member<T>{[access](const FormSource &source) {
                         const auto *member = source.test ? access(*source.test) : nullptr;
                         return member ? *member : T();
                     },
                     [access](Document &document, std::size_t index, const T &value) {
                         editTest(document, index, [&](Test &test) {
                             if (auto *member = access(test))
                                 *member = value;
                         });
                     }};
}

/// Returns whole.*first.*second…; an integer selects an element by index.
template <class T>
[[nodiscard]] T &reach(T &whole) {
    return whole;
}
template <class T, class... Rest>
[[nodiscard]] auto &reach(T &whole, std::size_t element, Rest... rest) {
    return reach(whole[element], rest...);
}
template <class T, class Part, class... Rest>
[[nodiscard]] auto &reach(T &whole, Part part, Rest... rest) {
    return reach(whole.*part, rest...);
}

/// A member of the measurement of one kind of test, or of a part of it.
template <class Measurement, auto... members>
[[nodiscard]] auto ofMeasurement() {
    return ofTest([](auto &test) {
        auto *measurement = std::get_if<Measurement>(&test.measurement);
        return measurement ? &reach(*measurement, members...) : nullptr;
    });
}

/// The same member as another type: `there` converts stored to displayed values, `back` the reverse.
template <class Shown, class Kept>
[[nodiscard]] Member<Shown> converted(Member<Kept> member, std::function<Shown(const Kept &)> there,
                                      std::function<Kept(const Shown &)> back) {
    return {[read = member.read, there](const FormSource &source) { return there(read(source)); },
            [write = member.write, back](Document &document, std::size_t test, const Shown &value) {
                write(document, test, back(value));
            }};
}

/// An enumeration value by its index in a list of choices.
template <class Enumeration>
[[nodiscard]] Member<int> choiceOf(Member<Enumeration> member, std::vector<Enumeration> values) {
    return converted<int, Enumeration>(
        std::move(member),
        [values](const Enumeration &value) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (values[i] == value)
                    return static_cast<int>(i);
            }
            return -1;
        },
        [values](const int &index) { return values.at(static_cast<std::size_t>(index)); });
}

} // namespace palmer::ui
