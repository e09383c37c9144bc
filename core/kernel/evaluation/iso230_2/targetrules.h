// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

/// How many targets are asked for and where (ISO 230-2, 4.2, 4.3.2 to 4.3.4; of rotary axes practice), for
/// those who judge them and those who plan them. Tolerances are ours.
namespace palmer::iso230_2 {

inline constexpr double fewestTargets = 5;       ///< of a linear axis
inline constexpr double targetsOfAMetre = 5;     ///< of a short linear axis or a zone
inline constexpr double longestInterval = 250;   ///< mm, of a long axis: mean distance of its targets
inline constexpr double targetsOfATurn = 8;      ///< of a rotary axis
inline constexpr double quarterTurn = 90;        ///< degrees
inline constexpr double quarterTolerance = 1e-3; ///< degrees
inline constexpr double fewestFurther = 3;       ///< targets beside the quarter turns (1988)
inline constexpr double randomShare = 0.3;       ///< of the interval: bound of r where the period is unknown

/// On a rotary travel of degrees: 3 up to 90°, 5 up to 180°, 8 up to a turn.
[[nodiscard]] constexpr double targetsWithinATurn(double travel) {
    return travel <= 90 ? 3 : travel <= 180 ? 5 : targetsOfATurn;
}

/// The position is that quarter turn, in any turn.
[[nodiscard]] bool isAtQuarter(double position, double quarter);

/// Targets that are no quarter turn.
[[nodiscard]] double furtherTargets(std::span<const double> targets);

/// Mean step between neighbours; 0 of fewer than two.
[[nodiscard]] double meanStep(std::span<const double> targets);

/// Every step is within two periods of the mean step; period unknown: within 60 % of it (1988).
[[nodiscard]] bool spacedAsOf1988(std::span<const double> targets, std::optional<double> period);

/// All targets lie at the same place of the pitch, within 1 % of it; false of fewer than two.
[[nodiscard]] bool samePhase(std::span<const double> targets, double pitch);

/// All steps are whole multiples of the period, within 1 % of it; false of fewer than two targets.
[[nodiscard]] bool stepsOfWholePeriods(std::span<const double> targets, double period);

/// All steps are the mean step within 1 %; false of fewer than three targets.
[[nodiscard]] bool evenlySpaced(std::span<const double> targets);

/// P_i − (i − 1)·p over all targets: highest − lowest; 0 of none.
[[nodiscard]] double spreadAbout(std::span<const double> targets, double interval);

/// Largest random part: one period, or ± 30 % of the interval where it is unknown (2006).
[[nodiscard]] double boundOf2006(double interval, std::optional<double> period);

/// A spread no random part within that bound exceeds.
[[nodiscard]] bool staysWithin(double spread, double bound, double interval);

} // namespace palmer::iso230_2
