// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/axis.h"

#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// mm or degrees.
enum class ChannelQuantity { deviation, angularDeviation };

/// The values of one sensor at the times of a drift test; null: no value.
struct DriftChannel {
    std::string name; ///< that of the axis it belongs to, if any
    ChannelQuantity quantity = ChannelQuantity::deviation;
    std::vector<std::optional<double>> values;

    bool operator==(const DriftChannel &) const = default;
};

struct DriftTemperature {
    std::string measures; ///< "spindle", "air"
    std::optional<double> resolution;
    std::vector<std::optional<double>> values;

    bool operator==(const DriftTemperature &) const = default;
};

/// A drift test: deviations at rest over time; times in s, ascending. One channel as `deviations`, mm
/// (rotary: degrees), several as `channels`; all as long as `times`.
struct DriftMeasurement {
    Axis axis; ///< name and motion only
    std::vector<double> times;
    std::vector<double> deviations;
    std::vector<DriftChannel> channels;
    std::vector<DriftTemperature> temperatures;
    bool settled = false; ///< stated: in balance with its temperatures at the first time

    bool operator==(const DriftMeasurement &) const = default;
};

} // namespace palmer
