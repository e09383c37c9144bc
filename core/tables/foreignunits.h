// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// Whether a text is the spelling of a unit that numbers are not converted from: "ppm", "mA", "°F". `µ` is
/// `u` in it. What may as well be another word counts in brackets only.
[[nodiscard]] bool isForeignUnit(std::string_view text, bool inBrackets);

} // namespace palmer
