// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/simulation/randomdraws.h"

#include <span>

namespace palmer {

/// Independent errors of each reading of a path.
struct PointErrors {
    double noise = 0;      ///< standard deviation, normal, mm
    double resolution = 0; ///< step, uniform over ± half of it, mm
};

/// Returns the number of counters for `points` points: two words per point, eight points on four counters.
[[nodiscard]] std::uint32_t placesOfPoints(std::size_t points);

/// Draws the errors of the points of a path, mm, with counters from `place` on. Uses wide registers if the
/// processor has them; results are identical on all.
void drawPointErrors(const RandomDraws &draws, long long trial, std::uint32_t place,
                     const PointErrors &errors, std::span<double> into);
/// Uses only the registers every processor has.
void drawPointErrorsNarrow(const RandomDraws &draws, long long trial, std::uint32_t place,
                           const PointErrors &errors, std::span<double> into);

} // namespace palmer
