// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/positioning.h"

#include <algorithm>

namespace palmer {

std::vector<std::size_t> targetsWithoutReading(const PositioningMeasurement &measurement) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < measurement.targets.size(); ++i) {
        if (std::ranges::none_of(measurement.runs, [i](const Run &run) {
                return i < run.deviations.size() && run.deviations[i].has_value();
            }))
            result.push_back(i);
    }
    return result;
}

double measurementTravel(const PositioningMeasurement &measurement) {
    return measurement.targets.empty() ? 0 : measurement.targets.back() - measurement.targets.front();
}

} // namespace palmer
