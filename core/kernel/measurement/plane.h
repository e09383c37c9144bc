// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/circular.h"

#include <optional>
#include <string_view>

namespace palmer {

/// Returns the plane named by a word such as "XY" or "yz" (letters of two different axes), otherwise null.
[[nodiscard]] inline std::optional<Plane> planeOf(std::string_view word) {
    const auto capital = [](char letter) {
        return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    };
    const auto isLetter = [](char letter) { return letter >= 'A' && letter <= 'Z'; };
    if (word.size() != 2)
        return std::nullopt;
    const char first = capital(word[0]);
    const char second = capital(word[1]);
    if (first == second || !isLetter(first) || !isLetter(second))
        return std::nullopt;
    return Plane{std::string(1, first), std::string(1, second)};
}

} // namespace palmer
