// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/conditions.h"

#include <optional>

/// Validity of lengths at 20 °C, by the same rule for axes and circles. Not for rotary axes.
namespace palmer {

/// Returns α_M·(θ_M − 20) − α_D·(θ_D − 20), dimensionless: machine against instrument; α in µm/(m·°C), θ from
/// meanTemperature. A coefficient of 0 needs no temperature. Null if anything else is missing.
[[nodiscard]] std::optional<double> differentialExpansion(const Conditions &conditions);

/// True if the results are corrected to 20 °C: by the instrument, or here, which needs all of the above.
[[nodiscard]] bool isCorrectedTo20(const Conditions &conditions);

struct OtherTemperature {
    SensorMeasures of = SensorMeasures::machine;
    double value = 0; ///< °C
};

/// Returns what was away from 20 °C at any stated temperature, by more than rounds to 20.0: the machine,
/// otherwise the instrument unless its α is 0. Null: neither, or unknown.
[[nodiscard]] std::optional<OtherTemperature> awayFrom20(const Conditions &conditions);

/// open: not corrected, and a temperature needed to show that they hold is not stated.
enum class At20 { hold, open, wrong };

/// Returns whether lengths of `length` mm hold: yes if corrected, if machine and instrument were at 20 °C at
/// start and end, or if the differential expansion is known and below 0.05 µm at every temperature. Otherwise
/// wrong if a temperature is away from 20 °C, or if a correction to be made here is impossible.
[[nodiscard]] At20 lengthsAt20(const Conditions &conditions, double length);

} // namespace palmer
