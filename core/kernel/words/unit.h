// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

enum class UnitKind { length, angle, time, temperature };

/// A unit used in files: number · multiplier / divisor is in the base unit (mm, degrees, s, °C).
struct Unit {
    const char *word = nullptr; ///< keyword in options: "um"
    const char *sign = nullptr; ///< as shown to people: "µm"
    UnitKind kind = UnitKind::length;
    double multiplier = 1;
    double divisor = 1;

    /// Powers of ten shift the decimal point of the number as written: 2.1 µm is 0.0021 mm, to the last bit.
    [[nodiscard]] double toBase(double value) const;
};

/// Returns the unit with this word, or null.
[[nodiscard]] const Unit *unitOf(std::string_view word);

/// Returns the unit with this sign ("µm"), or null.
[[nodiscard]] const Unit *unitOfSign(std::string_view sign);

} // namespace palmer
