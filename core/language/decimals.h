// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/words/quantity.h"

namespace palmer {

// How many digits after the point numbers of a test are shown with, in the unit they are shown in.

/// Digits after the point that a number has, at most 9: 5.4/1000 mm is 5.4 µm, whatever the last bits say.
[[nodiscard]] int decimalsOf(double value, Quantity quantity);

/// At least so many; more where a statement has more. A mean that has no end of its own keeps one digit
/// beyond.
[[nodiscard]] int statedDecimals(double value, Quantity quantity, int least);

/// The number without what no decimal of 15 digits has: 0.30000000000000004 is 0.3. What a report says of a
/// stated number; readings and files keep theirs.
[[nodiscard]] double certain(double value);

/// The common decimals of target positions: as stated, at most 6.
[[nodiscard]] int positionDecimals(const PositioningMeasurement &measurement);

/// The common decimals of the readings as deviations: as they were entered, at most 4, of angles 2.
[[nodiscard]] int readingDecimals(const PositioningMeasurement &measurement);

/// Statistics per target: one more than the readings, within the same bounds.
[[nodiscard]] int statisticDecimals(const PositioningMeasurement &measurement);

/// Of a feed in mm/min: whole numbers, and below 100 three digits in all.
[[nodiscard]] int feedDecimals(double feed);

/// Quantities of the positions and deviations of an axis.
[[nodiscard]] inline Quantity positionQuantity(const Axis &axis) {
    return axis.motion == Motion::linear ? Quantity::position : Quantity::angle;
}
[[nodiscard]] inline Quantity deviationQuantity(const Axis &axis) {
    return axis.motion == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
}

} // namespace palmer
