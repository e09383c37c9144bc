// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/simulation.h"

#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <cmath>

namespace palmer {

static_assert(fewestDecidingTrials >= 1e4 / (1 - coverageProbability) &&
              fewestDecidingTrials - trialsPerBlock < 1e4 / (1 - coverageProbability));

double numericalTolerance(double size) {
    if (!(size > 0))
        return 0;
    const double secondDigit = powerOfTen(static_cast<int>(std::floor(std::log10(size))) - 1);
    return secondDigit / 2;
}

double SimulatedParameter::tolerance() const {
    return numericalTolerance(u);
}

bool SimulatedParameter::largeShift() const {
    return std::abs(shift()) > expanded() / 3;
}

const SimulatedParameter *Simulation::find(std::string_view id) const {
    const auto found = std::ranges::find(parameters, id, &SimulatedParameter::id);
    return found == parameters.end() ? nullptr : &*found;
}

} // namespace palmer
