// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace palmer {

inline constexpr double fullTurn = 360;                  ///< degrees
inline constexpr double degree = std::numbers::pi / 180; ///< in radians

} // namespace palmer
