// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How many targets are asked for (ISO 230-2, 4.3.2 and 4.3.3; of rotary axes practice), for those who judge
/// them and those who plan them.
namespace palmer::iso230_2 {

inline constexpr double fewestTargets = 5;     ///< of a linear axis
inline constexpr double targetsOfAMetre = 5;   ///< of a short linear axis or a zone
inline constexpr double longestInterval = 250; ///< mm, of a long axis: mean distance of its targets
inline constexpr double targetsOfATurn = 8;    ///< of a rotary axis

/// On a rotary travel of degrees: 3 up to 90°, 5 up to 180°, 8 up to a turn.
[[nodiscard]] constexpr double targetsWithinATurn(double travel) {
    return travel <= 90 ? 3 : travel <= 180 ? 5 : targetsOfATurn;
}

} // namespace palmer::iso230_2
