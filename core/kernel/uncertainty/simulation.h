// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

inline constexpr double coverageProbability = 0.9545; ///< of the intervals of a simulation

/// How often the values of a simulation fell into equal intervals from `from` on; mm, rotary: degrees.
/// What lies outside is counted at the ends.
struct Histogram {
    double from = 0;
    double width = 0; ///< of one interval; 0: all values are alike
    std::vector<long long> counts;

    bool operator==(const Histogram &) const = default;
};

/// What a simulation says of one parameter Y. All in mm, rotary: degrees.
struct SimulatedParameter {
    std::string id;   ///< as parameterId
    double value = 0; ///< evaluated from the readings as they are
    double mean = 0;  ///< of Y over the trials
    double u = 0;     ///< standard deviation of Y
    double low = 0;   ///< the shortest interval that holds 95.45 % of the values of Y
    double high = 0;
    Histogram histogram;
    std::optional<double> expandedError = {}; ///< s_U, of `expanded`; null: fewer than two blocks of trials

    /// U: half of the shortest 95.45 % interval.
    [[nodiscard]] double expanded() const { return (high - low) / 2; }
    /// Mean of Y − evaluated value.
    [[nodiscard]] double shift() const { return mean - value; }
    /// U + 2 s_U: what a guard band is made of, our safety rule; U alone where s_U is not known.
    [[nodiscard]] double guarded() const { return expanded() + 2 * expandedError.value_or(0); }
    /// Numerical tolerance of u: half a unit of its second significant digit (JCGM 101, 7.9.2); 0 for u = 0.
    [[nodiscard]] double tolerance() const;
    /// |shift| > U/3: the errors of measurement move the result, the interval says too little.
    [[nodiscard]] bool largeShift() const;

    bool operator==(const SimulatedParameter &) const = default;
};

/// Trials a simulation is made of: blocks of 10⁴ as in JCGM 101, 7.9.4.
inline constexpr long long trialsPerBlock = 10'000;
/// Fewer never decide. JCGM 101, 7.2 asks for 10⁴/(1 − p) = 219 781 with p = 0.9545; in whole blocks 22.
inline constexpr long long fewestDecidingTrials = 22 * trialsPerBlock;

/// Half a unit of the second significant digit of `size`; 0 for 0.
[[nodiscard]] double numericalTolerance(double size);

/// Result of a Monte Carlo simulation (JCGM 101) of one test under one edition.
struct Simulation {
    std::string edition; ///< word of the edition it was evaluated under
    long long trials = 0;
    long long seed = 1;
    /// 2s of mean, u, U and both ends is below the tolerance of u for every parameter that varies.
    bool stable = true;
    bool adaptive = true; ///< the number of trials was not given
    std::vector<SimulatedParameter> parameters;

    /// Enough trials for the interval to be trusted.
    [[nodiscard]] bool mayDecide() const { return trials >= fewestDecidingTrials; }

    /// What it says of the parameter of this id; null for none.
    [[nodiscard]] const SimulatedParameter *find(std::string_view id) const;

    bool operator==(const Simulation &) const = default;
};

} // namespace palmer
