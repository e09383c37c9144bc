// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/words/quantity.h"
#include "kernel/words/text.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

namespace palmer {

/// How a value is entered, if that needs no further explanation.
struct FieldForm {
    std::optional<Quantity> quantity = {}; ///< for a linear axis; see quantityOf
    std::span<const Text> words = {};      ///< options in the order of the enumeration; empty: states nothing
};

/// Something a test file can state: its name in window, report and help, and a sentence about what to enter.
struct StatedThing {
    std::string_view key; ///< in the file, and in findings about its absence
    Text name;
    Text meaning = {}; ///< empty if the name is sufficient
    FieldForm form = {};
};

/// Returns the things in the order of the help.
[[nodiscard]] std::span<const StatedThing> statedThings();

/// Returns the thing with this key, or null.
[[nodiscard]] const StatedThing *statedThing(std::string_view key);

/// Returns the quantity of a numeric thing in a test with that motion: an angle instead of a position.
[[nodiscard]] Quantity quantityOf(const StatedThing &thing, Motion motion);

/// Returns the name of an enumeration value among the options; empty if it states nothing.
[[nodiscard]] Text statedWord(std::string_view key, std::size_t value);
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] Text statedWord(std::string_view key, Enumeration value) {
    return statedWord(key, static_cast<std::size_t>(value));
}

} // namespace palmer
