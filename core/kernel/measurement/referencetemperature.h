// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// The temperature at which lengths are stated, °C.
inline constexpr double referenceTemperature = 20;

} // namespace palmer
