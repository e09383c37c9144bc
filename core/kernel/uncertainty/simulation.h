// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

inline constexpr double coverageProbability = 0.9545; ///< of the intervals of a simulation

/// Counts of simulated values in intervals of equal width starting at `from`; mm, rotary: degrees. Values
/// outside are counted in the end intervals.
struct Histogram {
    double from = 0;
    double width = 0; ///< of one interval; 0: all values are equal
    std::vector<long long> counts;

    bool operator==(const Histogram &) const = default;
};

/// Result of a simulation for one parameter Y. All in mm, rotary: degrees.
struct SimulatedParameter {
    std::string id;   ///< as parameterId
    double value = 0; ///< evaluated from the readings as they are
    double mean = 0;  ///< of Y over the trials
    double u = 0;     ///< standard deviation of Y
    double low = 0;   ///< start of the shortest interval that contains 95.45 % of the values of Y
    double high = 0;
    Histogram histogram;
    std::optional<double> expandedError = {}; ///< s_U, of `expanded`; null: fewer than two blocks of trials

    /// U: half of the shortest 95.45 % interval.
    [[nodiscard]] double expanded() const { return (high - low) / 2; }
    /// Mean of Y − evaluated value.
    [[nodiscard]] double shift() const { return mean - value; }
    /// U + 2 s_U, used for guard bands (our safety rule); U alone if s_U is unknown.
    [[nodiscard]] double guarded() const { return expanded() + 2 * expandedError.value_or(0); }
    /// Numerical tolerance of u: half a unit of its second significant digit (JCGM 101, 7.9.2); 0 for u = 0.
    [[nodiscard]] double tolerance() const;
    /// |shift| > U/3: measurement errors move the result, and the interval alone is not enough.
    [[nodiscard]] bool largeShift() const;

    bool operator==(const SimulatedParameter &) const = default;
};

/// Trials per block: 10⁴ as in JCGM 101, 7.9.4.
inline constexpr long long trialsPerBlock = 10'000;
/// Fewest deciding trials. JCGM 101, 7.2 asks for 10⁴/(1 − p) = 219 781 with p = 0.9545; 22 whole blocks.
inline constexpr long long fewestDecidingTrials = 22 * trialsPerBlock;

/// Returns half a unit of the second significant digit of `size`; 0 for 0.
[[nodiscard]] double numericalTolerance(double size);

/// Result of a Monte Carlo simulation (JCGM 101) of one test under one edition.
struct Simulation {
    std::string edition; ///< word of the edition used for the evaluation
    long long trials = 0;
    long long seed = 1;
    /// True if 2s of mean, u, U and both ends is below the tolerance of u for every parameter that varies.
    bool stable = true;
    bool adaptive = true; ///< the number of trials was not given
    std::vector<SimulatedParameter> parameters;

    /// True if there are enough trials to trust the interval.
    [[nodiscard]] bool mayDecide() const { return trials >= fewestDecidingTrials; }

    /// Returns the result for a parameter id, or null.
    [[nodiscard]] const SimulatedParameter *find(std::string_view id) const;

    bool operator==(const Simulation &) const = default;
};

} // namespace palmer
