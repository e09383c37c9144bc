// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "kernel/simulation/randomdraws.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "kernel/uncertainty/simulation.h"

#include <span>
#include <stop_token>
#include <vector>

namespace palmer {

struct TestEvaluation;

/// The trials of a positioning test: measurement errors added to the readings, then the evaluation, four
/// trials at once.
class PositioningTrials {
public:
    /// `evaluation`: its parameters with a value are simulated. Precondition: the budget is complete.
    PositioningTrials(const PositioningMeasurement &measurement, const TestEvaluation &evaluation,
                      const PositioningBudget &budget, long long seed);

    /// Returns id and evaluated value of each parameter.
    [[nodiscard]] const std::vector<SimulatedParameter> &parameters() const { return m_parameters; }
    /// Returns the number of trials processed in one run(): a multiple of four.
    [[nodiscard]] static int chunk() { return 500; }

    /// Working memory of one thread.
    struct Buffers {
        std::vector<Lanes> readings;
        std::vector<TargetStatisticsOf<Lanes>> targets;
        std::vector<double> numbers; ///< random numbers, four per reading
    };
    [[nodiscard]] Buffers buffers() const;

    /// Computes the parameters of the trials first … first + chunk() − 1: all values of the first parameter,
    /// then of the second, and so on.
    void run(long long first, Buffers &buffers, std::span<double> values, const std::stop_token &stop) const;

    /// Returns the measurement of one trial: evaluating it gives the results of that trial.
    [[nodiscard]] PositioningMeasurement perturbed(long long trial) const;

private:
    /// A reading, in chronological order.
    struct Reading {
        std::size_t run = 0;
        std::size_t target = 0;
        std::size_t place = 0; ///< index in the table: ↑ first, then ↓
        double value = 0;      ///< NaN: none
        double distance = 0;   ///< ℓ_i, mm
        double time = 0;       ///< −½ at the first reading … ½ at the last
    };
    /// Errors common to all readings of four trials.
    struct Common {
        Lanes perLength; ///< error per unit length
        Lanes drift;     ///< change from the first to the last reading
    };

    void addReadings(const PositioningMeasurement &measurement);
    [[nodiscard]] Common common(long long first) const;
    /// Calls put(reading, error) for all readings of the four trials from `first`; `numbers` of its buffers.
    template <class Put>
    void eachError(long long first, std::vector<double> &numbers, Put put) const;

    const PositioningMeasurement &m_measurement;
    RandomDraws m_draws;
    std::vector<SimulatedParameter> m_parameters;
    std::vector<decltype(ParameterFormula::four)> m_formulas;
    std::vector<Reading> m_readings;
    std::vector<double> m_corrections; ///< by index in the table; empty: none
    std::size_t m_positive = 0;        ///< readings ↑ in the table
    std::size_t m_targets = 0;
    DeviationMethod m_method = DeviationMethod::calculation;
    double m_c = 2;
    double m_length = 0;
    bool m_normalDevice = true;
    double m_device = 0; ///< standard deviation or half-width at L, mm, rotary: degrees
    std::array<double, 4>
        m_thermal{};           ///< half-widths at L: temperature and expansion, machine and instrument
    double m_misalignment = 0; ///< full width at L
    double m_drift = 0;        ///< E_VE
    bool m_linearDrift = false;
};

} // namespace palmer
