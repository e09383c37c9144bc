// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/words/quantity.h"

namespace palmer {

// Number of decimals for the values of a test, in the unit shown.

/// Returns the decimals of a number, at most 9: 5.4/1000 mm is 5.4 µm, whatever the last bits say.
[[nodiscard]] int decimalsOf(double value, Quantity quantity);

/// At least `least`; more if a stated value has more. A non-terminating mean keeps one digit beyond.
[[nodiscard]] int statedDecimals(double value, Quantity quantity, int least);

/// Removes digits beyond the 15 that a double holds: 0.30000000000000004 becomes 0.3. Used for stated numbers
/// in a report; readings and files keep theirs.
[[nodiscard]] double certain(double value);

/// Returns the common decimals of target positions: as stated, at most 6.
[[nodiscard]] int positionDecimals(const PositioningMeasurement &measurement);

/// Returns the common decimals of the readings as deviations: as entered, at most 4, for angles 2.
[[nodiscard]] int readingDecimals(const PositioningMeasurement &measurement);

/// For statistics per target: one more than the readings, within the same bounds.
[[nodiscard]] int statisticDecimals(const PositioningMeasurement &measurement);

/// For a feed in mm/min: whole numbers, below 100 three significant digits.
[[nodiscard]] int feedDecimals(double feed);

/// Quantities of the positions and deviations of an axis.
[[nodiscard]] inline Quantity positionQuantity(const Axis &axis) {
    return axis.motion == Motion::linear ? Quantity::position : Quantity::angle;
}
[[nodiscard]] inline Quantity deviationQuantity(const Axis &axis) {
    return axis.motion == Motion::linear ? Quantity::deviation : Quantity::angularDeviation;
}

} // namespace palmer
