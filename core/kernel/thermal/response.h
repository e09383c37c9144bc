// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/thermal/variation.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// A channel of a drift test with one of its temperatures; NaN: no value.
struct ThermalRecord {
    std::span<const double> times; ///< s, ascending
    std::span<const double> deviations;
    std::span<const double> temperatures;
    double resolution = 0; ///< of the temperatures, °C; 0: not stated
    bool settled = false;  ///< in balance at the first temperature
};

/// Whether the data carry a response, and if not, why.
enum class ResponseState {
    found,
    noEqualSteps,     ///< steps differ by more than 1 %
    gapInTemperature, ///< longer than three steps
    tooFewValues,     ///< fewer than 3 degrees of freedom
    notProven,        ///< the deviations are explained as well without it
    straightDrift,    ///< the response is not to be told from a straight drift
    noisyTemperature  ///< too noisy for its own response
};

/// An interval; null: open on that side.
struct Range {
    std::optional<double> low;
    std::optional<double> high;

    bool operator==(const Range &) const = default;
};

/// The response of a channel to a temperature: x = a + b·t + k·y, τ·dy/dt = θ − y, y(0) = θ(0), plus
/// c·e^(−t/τ) unless settled. Intervals of 95 % from the squares S(τ) and noise that may be correlated.
/// Deviations in their own unit, times in s.
struct ThermalResponse {
    ResponseState state = ResponseState::found;
    double k = 0; ///< per °C
    Range kRange;
    double tau = 0;   ///< s
    Range tauRange;   ///< no low: from 0; no high: not bounded by the record, and |k| is a lower bound
    double slope = 0; ///< b, per s
    Range slopeRange;
    double residual = 0;          ///< s of the residuals
    double squares = 0;           ///< S at the minimum
    std::size_t count = 0;        ///< values fitted
    std::vector<double> times;    ///< of the rows below
    std::vector<double> fitted;   ///< x of the model
    std::vector<double> response; ///< k·y, from 0 at the first row
    std::vector<double> rest;     ///< x − k·y; NaN: no deviation

    /// Returns the range that the channel may go through in a duration (s) while the temperature is held to
    /// ± `hold` °C: 2·hold·|k|·(1 − e^(−T/τ)) at most, plus E_VE(T) of the rest. With a bound that is open,
    /// the fitted values are taken.
    [[nodiscard]] double variationWhenHeld(double hold, double duration) const;

    /// Returns the end of warming up in s from the first row: the last time with |y − y_end| > 0.1 of the
    /// range of y. Null unless θ is steady over the last 3τ (5 % of its range) and the straight drift is
    /// small against the response.
    [[nodiscard]] std::optional<double> warmUp(std::span<const double> temperatures) const;
};

/// Fits one channel to one temperature, the best of `ofTemperatures` tried. Values are only valid in the
/// state `found`.
[[nodiscard]] ThermalResponse thermalResponse(const ThermalRecord &given, int ofTemperatures = 1);

} // namespace palmer
