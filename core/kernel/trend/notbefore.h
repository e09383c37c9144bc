// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/trend/trendline.h"

#include <optional>

namespace palmer {

/// The limits of a trend, in the unit of its values; null: none on that side.
struct TrendLimits {
    std::optional<double> upper;
    std::optional<double> lower;
};

/// The earliest time at which a line may reach its limit.
struct NotBefore {
    enum class State {
        noLimit,
        beyond,  ///< not within twice the observed span; no statement about later times
        already, ///< the bound is at the limit by the last value
        date
    };
    State state = State::noLimit;
    double time = 0; ///< years; for `date` and `already`

    bool operator==(const NotBefore &) const = default;
};

/// Returns the end of the forecast: first + 2·(last − first), years.
[[nodiscard]] double trendHorizon(const TrendLine &line);

/// Returns the first time, from the last value on, at which line + t(0.95)·u(line) reaches the upper limit or
/// line − t(0.95)·u(line) the lower one: one-sided 95 %, for the level, not for the next value. `reserve`: g
/// ≥ 0, by which the limit is tightened where conformity has to be proven. The bound is convex in time, so it
/// is below the limit at all earlier times.
[[nodiscard]] NotBefore notBefore(const TrendLine &line, const TrendLimits &limits, double reserve = 0);

} // namespace palmer
