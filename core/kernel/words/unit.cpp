// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/words/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace palmer {

namespace {

constexpr std::array units{
    Unit{"mm", "mm", UnitKind::length, 1, 1},
    Unit{"um", "µm", UnitKind::length, 1, 1000},
    Unit{"nm", "nm", UnitKind::length, 1, 1e6},
    Unit{"cm", "cm", UnitKind::length, 10, 1},
    Unit{"m", "m", UnitKind::length, 1000, 1},
    Unit{"in", "in", UnitKind::length, 25.4, 1},
    Unit{"uin", "µin", UnitKind::length, 25.4, 1e6},
    Unit{"deg", "°", UnitKind::angle, 1, 1},
    Unit{"mdeg", "mdeg", UnitKind::angle, 1, 1000},
    Unit{"arcmin", "′", UnitKind::angle, 1, 60},
    Unit{"arcsec", "″", UnitKind::angle, 1, 3600},
    Unit{"gon", "gon", UnitKind::angle, 9, 10},
    Unit{"rad", "rad", UnitKind::angle, 180, std::numbers::pi},
    Unit{"mrad", "mrad", UnitKind::angle, 180, 1000 * std::numbers::pi},
    Unit{"urad", "µrad", UnitKind::angle, 180, 1e6 * std::numbers::pi},
    Unit{"s", "s", UnitKind::time, 1, 1},
    Unit{"min", "min", UnitKind::time, 60, 1},
    Unit{"h", "h", UnitKind::time, 3600, 1},
    Unit{"ms", "ms", UnitKind::time, 1, 1000},
    Unit{"C", "°C", UnitKind::temperature, 1, 1},
    Unit{"F", "°F", UnitKind::temperature, 5, 9},
    Unit{"K", "K", UnitKind::temperature, 1, 1},
};

/// Divides by a power of ten with a single rounding, by shifting the decimal point: the shortest decimal that
/// reads back as `value` has at most nine decimals in tables; longer ones are simply divided.
double shifted(double value, double powerOfTen) {
    constexpr double largestWhole = 9007199254740992.0; // 2^53: exact below
    double scale = 1;
    for (int decimals = 0; decimals < 10; ++decimals, scale *= 10) {
        const double size = std::abs(value * scale);
        if (size >= largestWhole)
            break;
        // A tie never reads back as `value`, however it is rounded; calling round() took a third of the time.
        // NOLINTNEXTLINE(bugprone-incorrect-roundings)
        const auto rounded = static_cast<std::int64_t>(std::min(size, largestWhole / 4) + 0.5);
        const double whole = size < largestWhole / 4 ? static_cast<double>(rounded) : std::round(size);
        if (whole / scale == std::abs(value))
            return std::copysign(whole / (scale * powerOfTen), value); // both exact
    }
    return value / powerOfTen;
}

/// 0 °C in the other units of temperature.
double zeroOf(const Unit &unit) {
    constexpr double fahrenheit = 32;
    constexpr double kelvin = 273.15;
    const std::string_view name = unit.word;
    return name == "F" ? fahrenheit : name == "K" ? kelvin : 0;
}

} // namespace

double Unit::toBase(double value) const {
    constexpr double finest = 1e6; // of a thermometer: 293.65 K are 20.5 °C
    if (const double zero = kind == UnitKind::temperature ? zeroOf(*this) : 0; zero > 0)
        return std::round((value - zero) * multiplier / divisor * finest) / finest;
    const auto whole = static_cast<std::int64_t>(divisor);
    if (multiplier == 1 && whole >= 10 && whole % 10 == 0 && static_cast<double>(whole) == divisor)
        return shifted(value, divisor);
    return value * multiplier / divisor;
}

const Unit *unitOf(std::string_view word) {
    for (const Unit &unit : units) {
        if (unit.word == word)
            return &unit;
    }
    return nullptr;
}

const Unit *unitOfSign(std::string_view sign) {
    for (const Unit &unit : units) {
        if (unit.sign == sign)
            return &unit;
    }
    return nullptr;
}

} // namespace palmer
