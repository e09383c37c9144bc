// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/choices.h"
#include "import/remark.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// Reads the numbers in the rows of an instrument's file. Instruments write no thousands separators and as
/// many decimals everywhere: "1,234" among decimal points is asked for, and "1." among "1.5" was cut off.
class DataNumbers {
public:
    DataNumbers(std::string_view text, Choices &choices);

    /// The number that a word is; null for any other.
    std::optional<double> one(std::string_view word, std::size_t line);
    /// The numbers of a line, separated by blanks; null if it contains anything else.
    std::optional<std::vector<double>> in(std::string_view text, std::size_t line);
    /// Asks for the decimal mark if it is in doubt.
    void remark(Remarks &remarks);

private:
    struct Marked {
        std::size_t count = 0;     ///< numbers with that decimal mark
        std::size_t ambiguous = 0; ///< line of the first whose mark may part thousands; 0: none
    };

    Choices &m_choices;
    bool m_hasDecimals = false;
    std::array<Marked, 2> m_marked; ///< with a point, with a comma
};

} // namespace palmer
