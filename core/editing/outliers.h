// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/measurement/readingplace.h"

#include <vector>

namespace palmer {

/// A reading worth a second look: far from the others at its target and direction.
struct OutlierHint {
    ReadingPlace place;
    double distance = 0; ///< from the median of the other readings there, mm (rotary: degrees)

    bool operator==(const OutlierHint &) const = default;
};

/// Hints at typing errors and interrupted beams; nothing is removed for them, and no result knows them. Ours,
/// of no standard: d_ij = x_ij − median of the other readings of target and direction; a hint
/// where abs(d_ij) > 6·1.4826·median of all abs(d) of the test: medians, so that the reading in question does
/// not hide itself. At least 3 readings there and 10 in all; none where most readings agree exactly, for then
/// there is no scale. In the order of runs and targets.
[[nodiscard]] std::vector<OutlierHint> outlierHints(const PositioningMeasurement &measurement);

} // namespace palmer
