// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string_view>

namespace palmer {

/// Text in GB18030, of which GBK is a part, decoded with the system's table. U+FFFD stands where a character
/// is none. Null if the system has no such table.
[[nodiscard]] std::optional<QString> decodedGb18030(std::string_view bytes);

} // namespace palmer
