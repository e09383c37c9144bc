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

/// How something is entered, where that is all there is to say of it.
struct FieldForm {
    /// A section of the form of conditions.
    enum class Section { none, room, air, load, positions, circle, points };

    std::optional<Quantity> quantity = {}; ///< of a linear axis; see quantityOf
    std::span<const Text> words = {};      ///< to choose from, as its enumeration counts; empty: says nothing
    Section section = Section::none;       ///< where the form shows it; none: it has a place of its own there
    int columns = 0;                       ///< of twelve
};

/// Something that a test file can state: what window, report and help call it, and a sentence that says what
/// to enter.
struct StatedThing {
    std::string_view key; ///< in the file, and of the findings that miss it
    Text name;
    Text meaning = {}; ///< none where the name says it all
    FieldForm form = {};
};

/// In the order of the help.
[[nodiscard]] std::span<const StatedThing> statedThings();

/// Null: none has that key.
[[nodiscard]] const StatedThing *statedThing(std::string_view key);

/// The quantity of the thing, which is a number, in a test of that motion: an angle where a linear axis has
/// a position.
[[nodiscard]] Quantity quantityOf(const StatedThing &thing, Motion motion);

/// What the words to choose from call a value of its enumeration; empty where that states nothing.
[[nodiscard]] Text statedWord(std::string_view key, std::size_t value);
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] Text statedWord(std::string_view key, Enumeration value) {
    return statedWord(key, static_cast<std::size_t>(value));
}

} // namespace palmer
