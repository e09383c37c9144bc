// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/trend/trendline.h"

#include <optional>

namespace palmer {

/// The limits that a line may reach, in the unit of its values; null: none on that side.
struct TrendLimits {
    std::optional<double> upper;
    std::optional<double> lower;
};

/// When a line may reach its limit at the earliest.
struct NotBefore {
    enum class State {
        noLimit,
        beyond,  ///< not within twice the observed span; nothing is said of later
        already, ///< the bound is at the limit at the last value
        date
    };
    State state = State::noLimit;
    double time = 0; ///< years; of `date` and `already`

    bool operator==(const NotBefore &) const = default;
};

/// Up to here something is said: first + 2·(last − first), years.
[[nodiscard]] double trendHorizon(const TrendLine &line);

/// The first time from the last value on at which line + t(0.95)·u(line) reaches the upper limit, or
/// line − t(0.95)·u(line) the lower one: one-sided 95 %, for the level, not for the next value. `reserve`: g,
/// what the limit is nearer by where conformity has to be proven, ≥ 0. The bound is convex in time, so it is
/// below the limit all the time before.
[[nodiscard]] NotBefore notBefore(const TrendLine &line, const TrendLimits &limits, double reserve = 0);

} // namespace palmer
