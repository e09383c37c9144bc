// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"
#include "kernel/words/quantity.h"

#include <optional>
#include <string_view>

namespace palmer {

/// Unit of a number in the test file. The first four are angles for a rotary axis.
enum class FileUnit : unsigned {
    none,
    position,         ///< mm, degrees
    deviation,        ///< mm shown in µm; degrees shown in arc seconds
    uncertainty,      ///< µm, arc seconds
    feed,             ///< mm/min, °/min
    length,           ///< mm for every axis
    linearDeviation,  ///< mm shown in µm, for every axis
    angle,            ///< degrees
    angularDeviation, ///< degrees shown in arc seconds
    perMetre,         ///< µm/m
    temperature,      ///< °C
    temperatureRange, ///< °C, of a difference: 2 K are 2 °C
    gradient,         ///< °C/h
    expansion,        ///< µm/(m·°C)
    seconds,
    minutes,
    hours,
    pressure, ///< hPa
    percent,
};

/// Place of the unit among the bits of a field's demands.
inline constexpr unsigned firstBitOfFileUnit = 24;

[[nodiscard]] constexpr FileUnit fileUnitOf(unsigned demands) {
    return static_cast<FileUnit>(demands >> firstBitOfFileUnit);
}

/// Returns the quantity that shows such a number; `number` for units that have none.
[[nodiscard]] Quantity quantityOf(FileUnit unit, Motion motion);

/// Returns the unit as it can be typed: "mm", "um", "°C"; empty for `none`.
[[nodiscard]] const char *wordOf(FileUnit unit, Motion motion);

/// Converts a number typed with a unit ("um", "µm", "m/min", "°C") into the unit of the file. Null if the
/// unit does not fit or is unknown.
[[nodiscard]] std::optional<double> inFileUnit(double number, std::string_view typed, FileUnit unit,
                                               Motion motion);

} // namespace palmer
