#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

enum class UnitKind { length, angle, time, temperature };

/// A unit that files use: a number in it times `multiplier` by `divisor` is in the base unit (mm, degrees, s,
/// °C). Two factors, so that 5.4 µm is 0.0054 mm to the last bit.
struct Unit {
    const char *word; ///< as among the choices: "um"
    const char *sign; ///< as people read it: "µm"
    UnitKind kind = UnitKind::length;
    double multiplier = 1;
    double divisor = 1;

    [[nodiscard]] double toBase(double value) const { return value * multiplier / divisor; }
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
