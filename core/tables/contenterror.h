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

/// Throws Error(content) with that sentence and place.
template <class... Arguments>
[[noreturn]] void refuseContentAt(std::string place, Text text, Arguments... arguments) {
    throw Error(Error::Kind::content, messageOf(text, std::move(arguments)...), std::move(place));
}
template <class... Arguments>
[[noreturn]] void refuseContent(Text text, Arguments... arguments) {
    refuseContentAt({}, text, std::move(arguments)...);
}

} // namespace palmer
