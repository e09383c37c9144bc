// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace palmer {

/// Lower case without accents: "Écart Rückwärts" → "ecart ruckwarts".
[[nodiscard]] std::string folded(std::string_view text);

} // namespace palmer
