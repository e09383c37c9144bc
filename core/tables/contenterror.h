// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"

#include <cstddef>
#include <string>
#include <utility>

namespace palmer {

/// The sentence of a text with its arguments.
template <class... Arguments>
[[nodiscard]] Message messageOf(Text text, Arguments... arguments) {
    return {text, {Argument(std::move(arguments))...}};
}

/// A count inside a sentence.
[[nodiscard]] Number counted(auto number) {
    return {static_cast<double>(number), Quantity::count};
}

/// The place of a line, from 1, for an Error.
[[nodiscard]] inline std::string placeOfLine(std::size_t line) {
    return std::to_string(line) + ":1";
}

/// Throws Error with that sentence and place.
template <class... Arguments>
[[noreturn]] void refuseAsAt(Error::Kind kind, std::string place, Text text, Arguments... arguments) {
    throw Error(kind, messageOf(text, std::move(arguments)...), std::move(place));
}
template <class... Arguments>
[[noreturn]] void refuseAs(Error::Kind kind, Text text, Arguments... arguments) {
    refuseAsAt(kind, {}, text, std::move(arguments)...);
}
template <class... Arguments>
[[noreturn]] void refuseContentAt(std::string place, Text text, Arguments... arguments) {
    refuseAsAt(Error::Kind::content, std::move(place), text, std::move(arguments)...);
}
template <class... Arguments>
[[noreturn]] void refuseContent(Text text, Arguments... arguments) {
    refuseContentAt({}, text, std::move(arguments)...);
}

// Sentences that readers of several formats refuse with.
[[noreturn]] inline void refuseTableSize(std::string place = {}) {
    refuseAsAt(Error::Kind::tooLarge, std::move(place),
               REPORT_TEXT("report", "more rows or cells than a table of readings can have"));
}
[[noreturn]] inline void refuseReadings(std::string place = {}) {
    refuseAsAt(Error::Kind::tooLarge, std::move(place),
               REPORT_TEXT("report", "more than 10 000 000 readings or points"));
}
[[noreturn]] inline void refuseWithoutReadings(std::string place = {}) {
    refuseContentAt(
        std::move(place),
        REPORT_TEXT("report", "there are no readings in it; expected target positions and deviations"));
}
[[noreturn]] inline void refuseWithoutNumbers() {
    refuseContent(REPORT_TEXT("report", "there is no table of numbers in it; expected target positions and "
                                        "readings, points of a circle, or values over time"));
}

} // namespace palmer
