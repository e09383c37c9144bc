// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/surroundings.h"
#include "kernel/evaluation/testevaluation.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace palmer {

struct SimulationOptions {
    std::optional<long long> trials = {}; ///< null: until the second digit of u is stable
    long long seed = 1;
    int threads = 0; ///< 0: the number of processors
};

/// Trials done, and their total if known.
struct SimulationProgress {
    long long trials = 0;
    std::optional<long long> of;
};

/// Returns the options requested by the inputs of a test.
[[nodiscard]] SimulationOptions simulationOptions(const Test &test);

/// Propagates distributions by Monte Carlo (JCGM 101) through the evaluation of a test under an edition of
/// its kind: each trial adds measurement errors to the readings and evaluates them like the originals,
/// maxima, minima and circles included. For every parameter with a value: mean, u, the shortest 95.45 %
/// interval, shift, histogram.
///
/// Positioning: x_ij + ℓ_i·(ε_device + ε_θM·α_M + ε_αM·(θ_M − 20) − ε_θD·α_D − ε_αD·(θ_D − 20)) − c·ℓ_i/L +
/// d_ij, ℓ_i the distance from the first target; sizes and ranges as in the budget. ε_device normal from a
/// certificate (its fixed part also grows with ℓ_i/L), uniform from a range; all others uniform, one draw per
/// trial; c in [0, R_MIS²/2L]; d_ij uniform over ±E_VE/2, one draw per reading, or a slope over the
/// chronological order of the readings whose change from first to last is uniform over ±E_VE, so that no
/// reading leaves ±E_VE/2.
///
/// Circular: each point gets noise (normal) and resolution (uniform); each path a drift, uniform over
/// ±E_VE/2; displacement one draw for its zero, common to all points, and one for its scale, full over the
/// range of the deviations; reference length, correction to 20 °C and repeatability (normal) one draw per
/// trial, added to the results that include them; centring a random direction of the set-up error.
///
/// Adaptive: blocks of 10⁴ trials, at least 22 and at most 1 000, until twice the standard deviation of the
/// block averages of mean, u, both ends of the interval and U is each below half a unit of the second
/// significant digit of u, for every parameter that varies (7.9.4). Results come from all trials together,
/// never from block averages, except s_U. The random numbers of a trial depend only on seed and trial number,
/// the sums only on the order of the trials: any number of threads gives the same results, to the last bit.
///
/// Null if an input is missing or impossible (the evaluation has a finding), or if stopped, which takes at
/// most the time of one circle fit. `progress` is called on the calling thread.
[[nodiscard]] std::optional<Simulation>
simulate(const Test &test, const Surroundings &surroundings, const Edition &edition,
         const SimulationOptions &options, const std::stop_token &stop = {},
         const std::function<void(const SimulationProgress &)> &progress = {});

} // namespace palmer
