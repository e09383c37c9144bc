// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/conditions.h"

#include <optional>

/// Whether lengths hold at 20 °C: the same rule for axes and circles. Rotary axes are none of its business.
namespace palmer {

/// α_M·(θ_M − 20) − α_D·(θ_D − 20) in parts of one: machine against instrument; α in µm/(m·°C), θ the mean of
/// start and end in °C. A coefficient of 0 needs no temperature. Null where anything else is missing.
[[nodiscard]] std::optional<double> differentialExpansion(const Conditions &conditions);

/// The results hold at 20 °C: corrected by the instrument, or here, which needs all of the above.
[[nodiscard]] bool isCorrectedTo20(const Conditions &conditions);

struct MeanTemperature {
    SensorMeasures of = SensorMeasures::machine;
    double value = 0; ///< °C
};

/// What was away from 20 °C by more than `margin` (°C; 0.05 is what does not round to 20.0), in the mean of
/// the starts and ends that are known: the machine, else the instrument unless its α is 0. Null: neither, or
/// unknown.
[[nodiscard]] std::optional<MeanTemperature> awayFrom20(const Conditions &conditions, double margin = 0.05);

/// Lengths of `length` mm are wrong: a correction here that was asked for and is impossible, or a temperature
/// away from 20 °C without correction, unless the differential expansion is known and below 0.05 µm over the
/// length.
[[nodiscard]] bool isWrongAwayFrom20(const Conditions &conditions, double length);

} // namespace palmer
