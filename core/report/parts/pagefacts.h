// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

// Page dimensions and decimals shared by the parts of a report.

inline constexpr double textWidth = 175; ///< mm
inline constexpr double figureGap = 5;   ///< mm between a figure and the column next to it
inline constexpr int temperatureDecimals = 1;
inline constexpr int expansionDecimals = 1; ///< of α

} // namespace palmer
