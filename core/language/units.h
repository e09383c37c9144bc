// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/quantity.h"

#include <string_view>

namespace palmer {

enum class LengthDisplay {
    micrometres, ///< deviations in µm, positions in mm
    millimetres, ///< both in mm
    inches,      ///< deviations in µin, positions in inches
};
enum class AngleDisplay {
    arcSeconds, ///< angular deviations in arc seconds, positions in degrees
    degrees,    ///< both in degrees
};

/// Units in which a user reads and types numbers. A setting of the window: data stay in mm and degrees, and
/// reports are printed with the default.
struct DisplayUnits {
    LengthDisplay lengths = LengthDisplay::micrometres;
    AngleDisplay angles = AngleDisplay::arcSeconds;

    bool operator==(const DisplayUnits &) const = default;
};

/// How a quantity is shown: value in its base unit · 10^shift · factor, with `decimals` more decimals than in
/// the default unit.
struct ShownUnit {
    const char *sign = ""; ///< UTF-8; empty: no unit
    int shift = 0;
    double factor = 1;
    int decimals = 0;
    int finest = -1; ///< decimals beyond which there is only rounding error of the conversion
};

[[nodiscard]] ShownUnit shownUnit(Quantity quantity, const DisplayUnits &units = {});

/// Returns the number of shown units in one base unit.
[[nodiscard]] double unitScale(Quantity quantity, const DisplayUnits &units = {});

/// Returns the value in the base unit of a decimal number ("-4.8": point, hyphen, no grouping) in the unit
/// shown: "5.4" µm is the double of 0.0054. NaN for anything else, and outside the range of double.
[[nodiscard]] double fromShown(std::string_view decimal, Quantity quantity, const DisplayUnits &units = {});

} // namespace palmer
