// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/statistics.h"

#include <optional>
#include <string_view>

namespace palmer {

/// Returns the quantity of a target named by a TargetTerm: "mean+", "mean-", "mean", "reversal", "s+", "s-",
/// "range+", "range-", "R+", "R-", "R", for VDI/DGQ 3441 "U" (magnitude of the reversal) and "Ps" (c·(s↑ +
/// s↓)), also "lower+", "upper+", "lower-", "upper-" (x̄ ∓ c·s). `c`: factor of s of the edition. mm, rotary:
/// degrees. Null if undefined or the id is unknown.
[[nodiscard]] std::optional<double> targetValue(std::string_view id, const TargetStatistics &target,
                                                double c);

} // namespace palmer
