// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/correctionto20.h"
#include "kernel/measurement/positioning.h"

#include <optional>
#include <vector>

/// Correction of linear axes to 20 °C by nominal differential expansion (NDE).
namespace palmer::iso230_2 {

/// Returns the correction added to the deviations of each target, in mm, if the conditions say "applied
/// here": −ℓ_i·(α_M·(θ_M − 20) − α_D·(θ_D − 20)), ℓ_i = P_i − P_ref in mm (evaluation/correctionto20.h). Null
/// if not requested, for rotary axes, and if θ or α is missing.
[[nodiscard]] std::optional<std::vector<double>> correctionsTo20(const PositioningMeasurement &measurement);

/// Returns whether lengths hold at 20 °C over the measurement travel; for a rotary axis they do.
[[nodiscard]] At20 lengthsAt20(const PositioningMeasurement &measurement);

} // namespace palmer::iso230_2
