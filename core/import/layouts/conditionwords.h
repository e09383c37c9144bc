// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace palmer {

/// A condition that is the same for all readings of a test.
enum class Condition : std::uint8_t { machine, serialNumber, operatorName, date, feed };

/// The condition named by a label or the heading of a column, without its unit; null for any other words.
[[nodiscard]] std::optional<Condition> conditionNamed(std::string_view label);

} // namespace palmer
