// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

inline constexpr double fullTurn = 360; ///< degrees

} // namespace palmer
