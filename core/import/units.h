#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

enum class UnitKind { length, angle, time, temperature };

/// A unit that files use: a number in it times `multiplier` by `divisor` is in the base unit (mm, degrees, s,
/// °C).
struct Unit {
    const char *word; ///< as among the choices: "um"
    const char *sign; ///< as people read it: "µm"
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

/// The unit a heading or comment names: "Dev (µm)", "P [mm]", "unité : µm", "Temp °C"; µ, μ, Âµ and u are
/// one. Single letters count in brackets only. Null if there is none.
[[nodiscard]] const Unit *unitIn(std::string_view text);

/// The text without a unit in brackets: "Dev (µm)" → "Dev".
[[nodiscard]] std::string withoutUnit(std::string_view text);

} // namespace palmer
