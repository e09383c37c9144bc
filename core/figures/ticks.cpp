// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/ticks.h"

#include "kernel/numerics/poweroften.h"

#include <array>
#include <cmath>

namespace palmer {

namespace {

/// Accepts a step that only a rounding error makes too small.
constexpr double tolerance = 1 + 1e-9;

double decimalStep(double least, bool quarters) {
    const double decade = powerOfTen(static_cast<int>(std::floor(std::log10(least))));
    for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
        if (factor == 2.5 && !quarters)
            continue;
        if (factor * decade * tolerance >= least)
            return factor * decade;
    }
    return 10 * decade;
}

double angleStep(double least) {
    if (least <= 5 * tolerance)
        return decimalStep(least, false);
    for (const double step : {10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0}) {
        if (step * tolerance >= least)
            return step;
    }
    return 360 * decimalStep(least / 360, false);
}

int decimalsOf(double step) {
    int decimals = 0;
    for (double scaled = step; decimals < 12 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
         scaled *= 10)
        ++decimals;
    return decimals;
}

} // namespace

double roundStep(double span, double most, TickSteps steps) {
    const double least = span / most;
    return steps == TickSteps::angles ? angleStep(least) : decimalStep(least, steps == TickSteps::lengths);
}

void setRange(FigureAxis &axis, double from, double to, double mostParts, TickSteps steps,
              const Language &language) {
    axis.from = from;
    axis.to = to;
    axis.step = roundStep(to - from, mostParts, steps);
    axis.ticks.clear();
    const int decimals = decimalsOf(axis.step);
    const double slack = 1e-9 * axis.step;
    const double first = std::ceil((from - slack) / axis.step);
    const double last = std::floor((to + slack) / axis.step);
    for (int i = 0; first + i <= last; ++i) {
        const double k = first + i;
        const double value = k == 0 ? 0.0 : k * axis.step;
        axis.ticks.push_back({value, language.number(value, Quantity::number, decimals)});
    }
}

double scaleEnd(double size) {
    if (!(size > 0) || !std::isfinite(size))
        return 1;
    constexpr std::array steps{1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    const double power = powerOfTen(static_cast<int>(std::floor(std::log10(size))));
    for (const double step : steps) {
        if (step * power >= size)
            return step * power;
    }
    return steps.back() * power;
}

} // namespace palmer
