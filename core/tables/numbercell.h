// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace palmer {

/// The decimal separator of a number.
enum class DecimalMark { point, comma };

/// Kind of content of a table cell.
enum class CellKind : std::uint8_t {
    empty,   ///< only blanks
    number,  ///< a finite number
    missing, ///< a word or sign for "no reading": nan, n/a, a dash, #N/A …
    grouped, ///< a number with thousands separators or the other decimal mark: refused, never guessed
    broken,  ///< consists of characters of a number, but is none: "4,,7", "1e999"
    text,    ///< anything else
};

struct CellValue {
    CellKind kind = CellKind::empty;
    double value = 0; ///< of a number, otherwise 0
};

/// Reads a cell, ignoring blanks around it. Sign, digits with at most one decimal mark, exponent; U+2212 and
/// the dashes that word processors use instead are a minus; blanks and apostrophes may part thousands
/// ("1 234.5"), and so may the other mark in a number that has both ("1,234.5"). Anything
/// else is not a number: "32.56" with a comma as mark is `grouped`, not 3256, and "inf" is `broken`.
[[nodiscard]] CellValue readCell(std::string_view cell, DecimalMark mark);

/// A number at the beginning of a text, as in readCell; `size` in bytes, 0 if there is none.
struct LeadingNumber {
    double value = 0;
    std::size_t size = 0;
};
[[nodiscard]] LeadingNumber leadingNumber(std::string_view text, DecimalMark mark);

/// Removes blanks (including no-break ones) at both ends.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

/// The text with its ASCII letters in lower or upper case.
[[nodiscard]] std::string lowerCase(std::string_view text);
[[nodiscard]] std::string upperCase(std::string_view text);

/// True if both are equal ignoring the case of ASCII letters.
[[nodiscard]] bool sameWord(std::string_view a, std::string_view b);

} // namespace palmer
