// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <vector>

namespace palmer {

/// Returns the overlap of the limits of two directions as bands: from the larger lower to the smaller upper
/// limit, with corners where the limits cross. Both bands are straight between their points.
[[nodiscard]] std::vector<std::vector<BandPoint>> bandOverlap(const std::vector<BandPoint> &a,
                                                              const std::vector<BandPoint> &b);

} // namespace palmer
