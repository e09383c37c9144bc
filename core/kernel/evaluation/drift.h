// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/statistics.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// Steady progression of the deviations from approach to approach (ours; ISO 230-2:2006, 3.3 asks to look).
/// ḡ_j = mean over all targets and directions of x_ij − x̄_i of that direction, mm; slope by least squares
/// over j; change = slope·(n − 1), mm; t of the slope with n − 2 degrees of freedom.
struct DriftStatistic {
    std::vector<double> means; ///< ḡ_j, mm
    double change = 0;         ///< D, mm
    double t = 0;              ///< infinite if the means lie exactly on a line
    double critical = 0;       ///< t(0.975; n − 2)

    /// True if |t| > t(0.975): the progression is not due to chance.
    [[nodiscard]] bool significant() const;

    bool operator==(const DriftStatistic &) const = default;
};

/// Null for fewer than 3 runs per direction.
[[nodiscard]] std::optional<DriftStatistic> driftStatistic(const ReadingsView &readings,
                                                           std::span<const TargetStatistics> statistics);

} // namespace palmer
