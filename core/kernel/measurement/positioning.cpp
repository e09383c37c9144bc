// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/positioning.h"

namespace palmer {

double measurementTravel(const PositioningMeasurement &measurement) {
    return measurement.targets.empty() ? 0 : measurement.targets.back() - measurement.targets.front();
}

} // namespace palmer
