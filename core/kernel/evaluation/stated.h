// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <string>
#include <type_traits>

/// Checks that a test states what all reports must state. `Case` has test, surroundings and common().
namespace palmer::stated {

/// True for a text that is not blank, a word that states something, or a value.
template <class T>
bool isStated(const T &value) {
    if constexpr (std::is_enum_v<T>)
        return value != T::notStated;
    else if constexpr (std::is_convertible_v<T, std::string_view>)
        return !isBlank(value);
    else
        return value.has_value();
}

template <auto member, class Case>
bool ofMachine(const Case &test) {
    return test.surroundings.machine && isStated(test.surroundings.machine->*member);
}

template <auto member, class Case>
bool ofMeasurement(const Case &test) {
    return isStated(test.measurement.*member);
}

/// Rule of the conditions that all kinds of tests have.
template <auto member, class Case>
bool common(const Case &test) {
    return isStated(test.common().*member);
}

/// The same for the conditions of one kind.
template <auto member, class Case>
bool condition(const Case &test) {
    return isStated(test.conditions().*member);
}

/// True if every named instrument states it; without instruments the row "instruments" reports it.
template <auto member, class Case>
bool ofInstruments(const Case &test) {
    return std::ranges::all_of(test.surroundings.instruments,
                               [](const Instrument *i) { return isStated(i->*member); });
}

template <class Case>
bool date(const Case &test) {
    return test.test.date.has_value();
}

template <class Case>
bool instruments(const Case &test) {
    return !test.surroundings.instruments.empty();
}

template <class Case>
bool warmUp(const Case &test) {
    return test.common().warmUp.kind != WarmUpKind::notStated;
}

} // namespace palmer::stated
