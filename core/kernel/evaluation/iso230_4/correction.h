// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/correctionto20.h"
#include "kernel/measurement/circular.h"

#include <optional>

namespace palmer::iso230_4 {

/// Returns C = R·[α_i·(T_i − 20) − α_m·(T_m − 20)] in mm, added to F and D; R nominal radius in mm, i
/// instrument, m machine (evaluation/correctionto20.h). Null unless the conditions say "applied here" and all
/// inputs are stated.
[[nodiscard]] std::optional<double> correctionTo20(const CircularMeasurement &measurement);

/// Returns whether F and D hold at 20 °C, over the nominal radius.
[[nodiscard]] At20 lengthsAt20(const CircularMeasurement &measurement);

} // namespace palmer::iso230_4
