// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// Returns the paths of the readings in a test of any kind, with * for an index: "runs.*.deviations.*".
[[nodiscard]] const std::vector<std::string> &readingPaths();

/// True for the key of a list of readings: "deviations".
[[nodiscard]] bool isListOfReadings(std::string_view key);

} // namespace palmer
