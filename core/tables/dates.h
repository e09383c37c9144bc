// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// YYYY-MM-DD of a date that can be read in one way only: ISO order, day and month parted by points, a month
/// by its name, a day above 12. Nothing for "03/04/2024", or what is no date.
[[nodiscard]] std::optional<std::string> isoDate(std::string_view text);

/// Whether a cell is a date, and nothing but one: "2024-03-05", "05.03.2024", "3/5/2024".
[[nodiscard]] bool isDate(std::string_view cell);

/// Days since 1970 of a cell that begins with a date in ISO order, also with slashes; nothing for any other.
[[nodiscard]] std::optional<long> dayOf(std::string_view cell);

} // namespace palmer
