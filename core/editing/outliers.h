// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <vector>

namespace palmer {

/// A possible outlier: far from the other readings at its target and direction.
struct OutlierHint {
    ReadingPlace place;
    double distance = 0; ///< from the median of the other readings there, mm (rotary: degrees)

    bool operator==(const OutlierHint &) const = default;
};

/// Hints at typing errors and interrupted beams; they change neither data nor results. The rule is our own,
/// not a standard's: d_ij = x_ij − median of the other readings of target and direction; a hint if abs(d_ij)
/// > 6·1.4826·median of all abs(d) of the test. Medians, so that a reading does not hide itself. Needs at
/// least 3 readings there and 10 in all; none if most readings agree exactly, which leaves no scale. In the
/// order of runs and targets.
[[nodiscard]] std::vector<OutlierHint> outlierHints(const PositioningMeasurement &measurement);

} // namespace palmer
