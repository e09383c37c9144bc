// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/units.h"

#include "kernel/numerics/poweroften.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace palmer {

namespace {

constexpr double millimetresPerInch = 25.4;
constexpr double microinchesPerInch = 1e6;
constexpr double micrometresPerMillimetre = 1000;
constexpr double secondsPerDegree = 3600;
constexpr double grid = 1e9; ///< per mm or degree: conversions are exact to a millionth of a micrometre

} // namespace

ShownUnit shownUnit(Quantity quantity, const DisplayUnits &units) {
    const bool inches = units.lengths == LengthDisplay::inches;
    switch (quantity) {
    case Quantity::number:
    case Quantity::count:
        return {};
    case Quantity::position:
        if (inches)
            return {"in", 0, 1 / millimetresPerInch, 2, 6};
        return {"mm"};
    case Quantity::angle:
        return {"°"};
    case Quantity::deviation:
        if (inches)
            return {"µin", 0, microinchesPerInch / millimetresPerInch, -1, 2};
        if (units.lengths == LengthDisplay::millimetres)
            return {"mm", 0, 1, 3};
        return {"µm", 3};
    case Quantity::angularDeviation:
        if (units.angles == AngleDisplay::degrees)
            return {"°", 0, 1, 4};
        return {"″", 0, secondsPerDegree};
    case Quantity::micrometres: // shown with deviations, hence in their unit
        if (inches)
            return {"µin", 0, microinchesPerInch / millimetresPerInch / micrometresPerMillimetre, -1, 2};
        if (units.lengths == LengthDisplay::millimetres)
            return {"mm", -3, 1, 3};
        return {"µm"};
    case Quantity::arcSeconds:
        if (units.angles == AngleDisplay::degrees)
            return {"°", 0, 1 / secondsPerDegree, 4, 8};
        return {"″"};
    case Quantity::temperature:
        return {"°C"};
    case Quantity::gradient:
        return {"°C/h"};
    case Quantity::expansion:
        return {"µm/(m·°C)"};
    case Quantity::feed:
        if (inches)
            return {"in/min", 0, 1 / millimetresPerInch, 2, 4};
        return {"mm/min"};
    case Quantity::angularFeed:
        return {"°/min"};
    case Quantity::time:
        return {"s"};
    case Quantity::pressure:
        return {"hPa"};
    case Quantity::percent:
        return {"%"};
    }
    return {};
}

double unitScale(Quantity quantity, const DisplayUnits &units) {
    const ShownUnit unit = shownUnit(quantity, units);
    return powerOfTen(unit.shift) * unit.factor;
}

double fromShown(std::string_view decimal, Quantity quantity, const DisplayUnits &units) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const ShownUnit unit = shownUnit(quantity, units);
    // The decimal point is shifted in the digits, so that no bit is lost.
    const std::string shifted = std::string(decimal) + 'e' + std::to_string(-unit.shift);
    double value = 0;
    const auto [end, error] = std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
    if (error != std::errc() || end != shifted.data() + shifted.size() || decimal.empty())
        return none;
    value /= unit.factor;
    return unit.finest < 0 ? value : std::round(value * grid) / grid;
}

} // namespace palmer
