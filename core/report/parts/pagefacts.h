// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

// What the parts of a report have in common on the page.

inline constexpr double textWidth = 175; ///< mm, of a page
inline constexpr double figureGap = 5;   ///< mm between a figure and what stands beside it
inline constexpr int temperatureDecimals = 1;
inline constexpr int expansionDecimals = 1; ///< of α

} // namespace palmer
