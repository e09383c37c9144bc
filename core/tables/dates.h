// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// Converts an unambiguous date to YYYY-MM-DD: ISO order, day and month separated by points, a month by name,
/// a day above 12. Null for "03/04/2024" and anything that is not a date.
[[nodiscard]] std::optional<std::string> isoDate(std::string_view text);

/// "20240305", alone or before a time, where no other order of its digits is a date; null for anything else.
[[nodiscard]] std::optional<std::string> compactDate(std::string_view text);

/// True for "03/04/2024" and "03/04/24": day and month may be in either order.
[[nodiscard]] bool hasTwoReadings(std::string_view date);

/// The first time of day in a text, HH:MM: "14:30", "2026-02-13 14:30:05", "2:30 pm", "14h30".
[[nodiscard]] std::optional<std::string> timeOfDay(std::string_view text);

/// True if a cell is exactly a date: "2024-03-05", "05.03.2024", "3/5/2024".
[[nodiscard]] bool isDate(std::string_view cell);

/// Days since 1970 of a cell that begins with a date in ISO order, also with slashes; null for any other.
[[nodiscard]] std::optional<long> dayOf(std::string_view cell);

} // namespace palmer
