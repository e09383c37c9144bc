// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/parameter.h"

#include <algorithm>

namespace palmer {

/// How a U covers: its factor and the probability that goes with it.
struct Coverage {
    double factor = 2;
    double probability = 0.95; ///< of k = 2
};

/// Returns the coverage of a parameter's expandedUncertainty; for a simulated one U/u and the probability of
/// its interval. Null without U.
[[nodiscard]] inline std::optional<Coverage> coverageOfU(const Parameter &parameter) {
    if (!parameter.expandedUncertainty)
        return {};
    if (parameter.decidedBy != UncertaintyMethod::monteCarlo || !parameter.simulated)
        return Coverage{};
    const double u = parameter.simulated->u;
    return Coverage{u > 0 ? std::max(1.0, *parameter.expandedUncertainty / u) : Coverage{}.factor,
                    coverageProbability};
}

} // namespace palmer
