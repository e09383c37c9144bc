#pragma once

#include "import/units.h"
#include "kernel/measurement/circular.h"

#include <optional>
#include <string>
#include <string_view>

namespace palmer {

/// What the heading of a column says about its numbers.
enum class Meaning {
    unknown,
    index,     ///< number of the target or point
    target,    ///< target position
    actual,    ///< actual position
    deviation, ///< deviation from the target, radial deviation
    direction, ///< of approach, or sense of contouring
    run,
    angle,
    radius,
    x,
    y,
    time,
    temperature,
    statistic, ///< mean, standard deviation …: computed here, not read
};

/// The direction a word or sign stands for: + − ↑ ↓ up down fwd bwd aller retour …; nothing for any other.
[[nodiscard]] std::optional<Direction> directionOf(std::string_view word);

/// The direction a heading names: "↑ 3", "Run 2 fwd", "1A", "R5". `shortSigns`: whether single letters count
/// (A and R, F and B, H and R).
[[nodiscard]] std::optional<Direction> directionInHeading(std::string_view heading, bool shortSigns);

/// The sense of contouring a word or heading names: ccw, cw, G2, G3, horaire, antihoraire.
[[nodiscard]] std::optional<Sense> senseIn(std::string_view text);

[[nodiscard]] Meaning meaningOf(std::string_view heading);

/// Seconds of the day of "10:25", "10:25:30,5", also behind a date; nothing for any other text.
[[nodiscard]] std::optional<double> clockTime(std::string_view text);

} // namespace palmer
