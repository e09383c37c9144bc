// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/statistics.h"

#include <optional>
#include <string_view>

namespace palmer {

/// The quantity of a target that a TargetTerm names: "mean+", "mean-", "mean", "reversal", "s+", "s-",
/// "range+", "range-", "R+", "R-", "R", of VDI/DGQ 3441 "U" (the size of the reversal) and "Ps"
/// (c·(s↑ + s↓)), besides "lower+", "upper+", "lower-", "upper-" (x̄ ∓ c·s). `c`: factor
/// of s of the edition. mm, rotary: degrees. Null where it is undefined or the id names nothing.
[[nodiscard]] std::optional<double> targetValue(std::string_view id, const TargetStatistics &target,
                                                double c);

} // namespace palmer
