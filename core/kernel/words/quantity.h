// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// Kind of a number, which determines its base unit and the unit shown. In the kernel all lengths and linear
/// deviations are in mm, all angles and angular deviations in degrees; units matter only on input and output.
enum class Quantity {
    number,           ///< without unit
    count,            ///< a whole number
    position,         ///< mm, shown in mm
    angle,            ///< °, shown in °
    deviation,        ///< mm, shown in µm
    angularDeviation, ///< °, shown in arc seconds
    micrometres,      ///< µm, as certificates write uncertainties
    arcSeconds,       ///< arc seconds, as certificates write uncertainties
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
