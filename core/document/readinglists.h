// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

/// True for the key of a list of readings: "deviations".
[[nodiscard]] bool isListOfReadings(std::string_view key);

} // namespace palmer
