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

template <auto text, class Case>
bool ofMachine(const Case &test) {
    return test.surroundings.machine && !isBlank(test.surroundings.machine->*text);
}

/// True for a non-empty text or a non-null value of the conditions.
template <auto member, class Case>
bool common(const Case &test) {
    const auto &value = test.common().*member;
    if constexpr (std::is_convertible_v<decltype(value), std::string_view>)
        return !isBlank(value);
    else
        return value.has_value();
}

template <class Case>
bool date(const Case &test) {
    return test.test.date.has_value();
}

template <class Case>
bool instruments(const Case &test) {
    return !test.surroundings.instruments.empty();
}

/// True if every named instrument has one; without instruments the row "instruments" reports it.
template <class Case>
bool instrumentSerial(const Case &test) {
    return std::ranges::none_of(test.surroundings.instruments,
                                [](const Instrument *i) { return isBlank(i->serialNumber); });
}

template <class Case>
bool certificate(const Case &test) {
    return std::ranges::none_of(test.surroundings.instruments,
                                [](const Instrument *i) { return isBlank(i->certificate); });
}

template <class Case>
bool calibrationDate(const Case &test) {
    return std::ranges::all_of(test.surroundings.instruments,
                               [](const Instrument *i) { return i->calibrationDate.has_value(); });
}

template <class Case>
bool calibrationDue(const Case &test) {
    return std::ranges::all_of(test.surroundings.instruments,
                               [](const Instrument *i) { return i->calibrationDue.has_value(); });
}

template <class Case>
bool warmUp(const Case &test) {
    return test.common().warmUp.kind != WarmUpKind::notStated;
}

} // namespace palmer::stated
