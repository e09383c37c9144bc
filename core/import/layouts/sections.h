// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tables/numbercell.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// A line of a text, and its number from 1.
struct TextLine {
    std::string_view text;
    std::size_t number = 1;
};

/// All lines of a text, also empty ones; they end with CR, LF or both. The text must outlive them.
[[nodiscard]] std::vector<TextLine> linesOf(std::string_view text);

/// A line "Key : value" of an instrument's text file; without a colon the key is empty.
struct SectionLine {
    std::size_t line = 1;
    std::string_view key;
    std::string_view value;
};

/// The content below "NAME::" alone on a line, up to the next such line.
struct Section {
    std::string_view name;
    std::size_t line = 1;
    std::vector<SectionLine> lines;

    /// The trimmed value of the first line with that key (case-insensitive); null if there is none.
    [[nodiscard]] std::optional<std::string_view> value(std::string_view key) const;
};

/// The sections of a text, which must outlive them.
[[nodiscard]] std::vector<Section> sectionsOf(std::string_view text);

/// The section of that name; null if there is none.
[[nodiscard]] const Section *findSection(const std::vector<Section> &sections, std::string_view name);

/// The value of a key in the section of that name; empty if there is none.
[[nodiscard]] std::string_view valueIn(const std::vector<Section> &sections, std::string_view name,
                                       std::string_view key);

/// True if a text contains a word, also within another, in any case of ASCII letters.
[[nodiscard]] bool containsWord(std::string_view text, std::string_view word);

/// The decimal mark of a single number: instruments write no thousands separators, so a comma is a decimal
/// comma, as in the regional settings of many countries.
[[nodiscard]] inline DecimalMark decimalMarkIn(std::string_view number) {
    return number.find(',') != std::string_view::npos ? DecimalMark::comma : DecimalMark::point;
}

/// The number that a text is, with decimal point or comma; null for any other text.
[[nodiscard]] std::optional<double> numberIn(std::string_view text);

/// The numbers of a line, separated by blanks; decimal point or comma. Null if it contains anything else.
[[nodiscard]] std::optional<std::vector<double>> numbersIn(std::string_view text);

} // namespace palmer
