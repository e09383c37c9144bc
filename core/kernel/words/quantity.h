// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// What a number is, hence its base unit and the unit it is shown in. In the kernel all lengths and linear
/// deviations are mm, all angles and angular deviations degrees; units exist only where numbers come in or
/// out.
enum class Quantity {
    number,           ///< without unit
    count,            ///< a whole number
    position,         ///< mm, shown in mm
    angle,            ///< °, shown in °
    deviation,        ///< mm, shown in µm
    angularDeviation, ///< °, shown in arc seconds
    micrometres,      ///< µm, as certificates write uncertainties
    arcSeconds,       ///< arc seconds, likewise
    temperature,      ///< °C
    gradient,         ///< °C/h
    expansion,        ///< µm/(m·°C)
    feed,             ///< mm/min
    angularFeed,      ///< °/min
    time,             ///< s
    pressure,         ///< hPa
    percent,          ///< %
};

} // namespace palmer
