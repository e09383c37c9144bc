// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace palmer {

enum class UnitKind { length, angle, time, temperature };

/// A unit that files use: a number in it times `multiplier` by `divisor` is in the base unit (mm, degrees, s,
/// °C).
struct Unit {
    const char *word = nullptr; ///< as among the choices: "um"
    const char *sign = nullptr; ///< as people read it: "µm"
    UnitKind kind = UnitKind::length;
    double multiplier = 1;
    double divisor = 1;

    /// Powers of ten move the decimal mark of the number as it is written: 2.1 µm is 0.0021 mm, to the last
    /// bit.
    [[nodiscard]] double toBase(double value) const;
};

/// The unit of that word, or null.
[[nodiscard]] const Unit *unitOf(std::string_view word);

/// The unit that people read so: "µm"; null if there is none.
[[nodiscard]] const Unit *unitOfSign(std::string_view sign);

} // namespace palmer
