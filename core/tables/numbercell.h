// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace palmer {

/// The character between the whole and the decimals of a number.
enum class DecimalMark { point, comma };

/// What stands in a cell of a table.
enum class CellKind : std::uint8_t {
    empty,   ///< nothing but blanks
    number,  ///< a finite number
    missing, ///< a word or sign for "no reading": nan, n/a, a dash, #N/A …
    grouped, ///< a number with thousands separators, or with the other decimal mark: refused, never guessed
    broken,  ///< made of the characters of a number, but none: "4,,7", "1e999"
    text,    ///< anything else
};

struct CellValue {
    CellKind kind = CellKind::empty;
    double value = 0; ///< of a number, else 0
};

/// What a cell says. Blanks around it do not count. Sign, digits with at most one decimal mark, exponent;
/// U+2212 and the dashes word processors put in its place are a minus. Everything else is no number: in
/// particular "32.56" with the comma as mark is `grouped`, not 3256, and "inf" is `broken`.
[[nodiscard]] CellValue readCell(std::string_view cell, DecimalMark mark);

/// A number at the beginning of a text, as in readCell; `size` bytes long, 0 if there is none.
struct LeadingNumber {
    double value = 0;
    std::size_t size = 0;
};
[[nodiscard]] LeadingNumber leadingNumber(std::string_view text, DecimalMark mark);

/// Without blanks (also no-break ones) at both ends.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

/// Whether both say the same but for the case of ASCII letters.
[[nodiscard]] bool sameWord(std::string_view a, std::string_view b);

} // namespace palmer
