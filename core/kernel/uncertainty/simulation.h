#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

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

    /// U (k = 2): half of the shortest 95.45 % interval about the mean.
    [[nodiscard]] double expanded() const { return (high - low) / 2; }
    /// Mean of Y − evaluated value.
    [[nodiscard]] double shift() const { return mean - value; }
    /// |shift| > U/3: the errors of measurement move the result, the interval says too little.
    [[nodiscard]] bool largeShift() const;

    bool operator==(const SimulatedParameter &) const = default;
};

/// Result of a Monte Carlo simulation (JCGM 101) of one test under one edition.
struct Simulation {
    std::string edition; ///< word of the edition it was evaluated under
    long long trials = 0;
    long long seed = 1;
    bool stable = true; ///< adaptive: two significant digits of u, U and mean are; false: stopped before
    std::vector<SimulatedParameter> parameters;

    /// What it says of the parameter of this id; null for none.
    [[nodiscard]] const SimulatedParameter *find(std::string_view id) const;

    bool operator==(const Simulation &) const = default;
};

} // namespace palmer
