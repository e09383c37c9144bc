// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/correctionto20.h"
#include "kernel/measurement/positioning.h"

#include <optional>
#include <vector>

/// Correction to 20 °C of linear axes by the nominal differential expansion (NDE).
namespace palmer::iso230_2 {

/// What is added to the deviations of each target, in mm, when the conditions say "applied here":
/// −ℓ_i·(α_M·(θ_M − 20) − α_D·(θ_D − 20)), ℓ_i = P_i − P_ref in mm (evaluation/correctionto20.h). Null where
/// nothing is asked for, for rotary axes, and where θ or α is missing.
[[nodiscard]] std::optional<std::vector<double>> correctionsTo20(const PositioningMeasurement &measurement);

/// Whether the lengths of a linear axis hold at 20 °C, over its measurement travel; of a rotary one they do.
[[nodiscard]] At20 lengthsAt20(const PositioningMeasurement &measurement);

} // namespace palmer::iso230_2
