// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/quantity.h"
#include "kernel/words/text.h"

#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace palmer {

/// A number inside a sentence, in the base unit of its quantity. `decimals` refers to the unit shown;
/// negative: the shortest form that reads back as the same number.
struct Number {
    double value = 0;
    Quantity quantity = Quantity::number;
    int decimals = -1;

    bool operator==(const Number &) const = default;
};

/// A count inside a sentence.
[[nodiscard]] constexpr Number wholeNumber(std::integral auto count) {
    return {static_cast<double>(count), Quantity::count, 0};
}

/// A date inside a sentence: YYYY-MM-DD.
struct Date {
    std::string iso;

    bool operator==(const Date &) const = default;
};

/// The designation of a standard after a preposition: "ISO 230-2:2006", in French with its article.
struct Designation {
    std::string word;

    bool operator==(const Designation &) const = default;
};

/// A number, a catalogue word, a name that is the same in every language (UTF-8), a date, or a standard.
using Argument = std::variant<Number, Text, std::string, Date, Designation>;

/// The one carrier of sentences: findings, remarks and errors hold one; Language::sentence makes the text.
/// `%1` … `%9` in the text are replaced by the arguments, `%n` by `count`, which also selects the plural.
struct Message {
    Text text;
    std::vector<Argument> arguments = {};
    std::optional<int> count = std::nullopt;

    bool operator==(const Message &) const = default;
};

} // namespace palmer
