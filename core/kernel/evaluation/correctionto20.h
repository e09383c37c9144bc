// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/conditions.h"

#include <optional>

/// Whether lengths hold at 20 °C: the same rule for axes and circles. Rotary axes are none of its business.
namespace palmer {

/// α_M·(θ_M − 20) − α_D·(θ_D − 20) in parts of one: machine against instrument; α in µm/(m·°C), θ as
/// meanTemperature. A coefficient of 0 needs no temperature. Null where anything else is missing.
[[nodiscard]] std::optional<double> differentialExpansion(const Conditions &conditions);

/// The results hold at 20 °C: corrected by the instrument, or here, which needs all of the above.
[[nodiscard]] bool isCorrectedTo20(const Conditions &conditions);

struct OtherTemperature {
    SensorMeasures of = SensorMeasures::machine;
    double value = 0; ///< °C
};

/// What was away from 20 °C in any of the temperatures that are stated, rounded to 0.1 °C: the machine, else
/// the instrument unless its α is 0. Null: neither, or unknown.
[[nodiscard]] std::optional<OtherTemperature> awayFrom20(const Conditions &conditions);

/// open: not corrected, and a temperature that would show that they hold is not stated.
enum class At20 { hold, open, wrong };

/// Whether lengths of `length` mm hold: they do if they are corrected, if machine and instrument were at 20
/// °C at start and end, and if the differential expansion is known and below 0.05 µm at every temperature.
/// Otherwise they are wrong if a temperature is away from 20 °C, or if a correction was to be made here and
/// is impossible.
[[nodiscard]] At20 lengthsAt20(const Conditions &conditions, double length);

} // namespace palmer
