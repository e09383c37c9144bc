// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/simulation/randomdraws.h"

#include <span>

namespace palmer {

/// What every reading of a path gets of its own.
struct PointErrors {
    double noise = 0;      ///< standard deviation, normal, mm
    double resolution = 0; ///< step, uniform over ± half of it, mm
};

/// Places of random numbers that so many points take: two words a point, eight points on four places.
[[nodiscard]] std::uint32_t placesOfPoints(std::size_t points);

/// Draws the errors of the points of a path, mm, from the places from `place` on. Wide registers are used
/// where the processor has them; the numbers are the same on all.
void drawPointErrors(const RandomDraws &draws, long long trial, std::uint32_t place,
                     const PointErrors &errors, std::span<double> into);
/// With the registers every processor has.
void drawPointErrorsNarrow(const RandomDraws &draws, long long trial, std::uint32_t place,
                           const PointErrors &errors, std::span<double> into);

} // namespace palmer
