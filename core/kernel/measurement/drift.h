// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"

#include <vector>

namespace palmer {

/// A drift test: deviation at rest over time; times in s, deviations in mm (rotary: degrees), same length.
struct DriftMeasurement {
    Axis axis; ///< name and motion only
    std::vector<double> times;
    std::vector<double> deviations;

    bool operator==(const DriftMeasurement &) const = default;
};

} // namespace palmer
