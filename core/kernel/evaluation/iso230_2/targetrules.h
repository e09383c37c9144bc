// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

/// Required number and positions of targets (ISO 230-2, 4.2, 4.3.2 to 4.3.4; practice for rotary axes), used
/// for judging and for planning. Tolerances are ours.
namespace palmer::iso230_2 {

inline constexpr double fewestTargets = 5;       ///< of a linear axis
inline constexpr double targetsOfAMetre = 5;     ///< of a short linear axis or a zone
inline constexpr double longestInterval = 250;   ///< mm, mean distance between targets of a long axis
inline constexpr double targetsOfATurn = 8;      ///< of a rotary axis
inline constexpr double quarterTurn = 90;        ///< degrees
inline constexpr double quarterTolerance = 1e-3; ///< degrees
inline constexpr double fewestFurther = 3;       ///< targets besides the quarter turns (1988)
inline constexpr double randomShare = 0.3;       ///< of the interval: bound of r if the period is unknown

/// Targets for a rotary travel in degrees: 3 up to 90°, 5 up to 180°, 8 up to a turn.
[[nodiscard]] constexpr double targetsWithinATurn(double travel) {
    return travel <= 90 ? 3 : travel <= 180 ? 5 : targetsOfATurn;
}

/// True if the position is that quarter turn, in any turn.
[[nodiscard]] bool isAtQuarter(double position, double quarter);

/// Returns the number of targets that are not quarter turns.
[[nodiscard]] double furtherTargets(std::span<const double> targets);

/// Returns the mean step between neighbours; 0 for fewer than two targets.
[[nodiscard]] double meanStep(std::span<const double> targets);

/// True if every step is within two periods of the mean step; period unknown: within 60 % of it (1988).
[[nodiscard]] bool spacedAsOf1988(std::span<const double> targets, std::optional<double> period);

/// True if all targets have the same phase of the pitch, within 1 % of it; false for fewer than two.
[[nodiscard]] bool samePhase(std::span<const double> targets, double pitch);

/// True if all steps are whole multiples of the period, within 1 % of it; false for fewer than two targets.
[[nodiscard]] bool stepsOfWholePeriods(std::span<const double> targets, double period);

/// True if all steps equal the mean step within 1 %; false for fewer than three targets.
[[nodiscard]] bool evenlySpaced(std::span<const double> targets);

/// Returns the range (highest − lowest) of P_i − (i − 1)·p over all targets; 0 without targets.
[[nodiscard]] double spreadAbout(std::span<const double> targets, double interval);

/// Returns the largest random part: one period, or ± 30 % of the interval if it is unknown (2006).
[[nodiscard]] double boundOf2006(double interval, std::optional<double> period);

/// True if random parts within the bound can produce this spread.
[[nodiscard]] bool staysWithin(double spread, double bound, double interval);

} // namespace palmer::iso230_2
