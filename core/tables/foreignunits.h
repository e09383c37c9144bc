// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// True if a text is a unit without conversion: "ppm", "mA", "°F". `µ` is written `u` in it. Ambiguous words
/// count only in brackets.
[[nodiscard]] bool isForeignUnit(std::string_view text, bool inBrackets);

} // namespace palmer
