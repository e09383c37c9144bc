// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/comparison/comparetests.h"
#include "kernel/simulation/randomdraws.h"
#include "kernel/uncertainty/positioningbudget.h"

#include <array>
#include <span>
#include <vector>

namespace palmer {

/// One of two tests to be simulated together: the same targets, directions and number of cycles.
struct TrialsOfTest {
    Readings readings; ///< of the cycles compared, with corrections
    const PositioningMeasurement *measurement = nullptr;
    PositioningBudget budget;
    std::array<double, 2> awayFrom20{}; ///< sign of θ − 20 of machine and instrument
};

/// The draws of a trial.
struct DrawnParts {
    bool errors = true;
    bool residuals = true;
};

/// The trials of a comparison: errors and residuals of two tests, through the evaluation, four at once.
class ComparisonTrials {
public:
    /// `formulas`: of the parameters compared.
    ComparisonTrials(const TrialsOfTest &before, const TrialsOfTest &after, const Edition &edition,
                     DeviationMethod method, std::vector<decltype(ParameterFormula::four)> formulas,
                     std::span<const SharedError> shared, int cycles, bool pooled);

    /// Values of a trial: the differences of the parameters, then of the means ↑, ↓ and of both at each
    /// target (NaN where there is none), these less the mean of the ↑ and ↓.
    [[nodiscard]] std::size_t values() const { return m_formulas.size() + 3 * m_targets; }

    /// Returns differences of `trials` (a multiple of four): value by value, all trials of the first, … The
    /// same for any number of threads. `values`: how many of the first are kept.
    [[nodiscard]] std::vector<double> run(long long trials, DrawnParts parts, std::size_t values,
                                          int threads) const;

private:
    struct Side {
        const TrialsOfTest *of = nullptr;
        std::vector<double> means;     ///< by place in the table: of its target and direction
        std::vector<double> residuals; ///< likewise, scaled; NaN: none
        double length = 0;
        double device = 0;
        bool normalDevice = true;
        std::array<double, 4> thermal{};
        double misalignment = 0;
        double drift = 0;             ///< E_VE of a linear drift
        std::vector<double> distance; ///< by target
        std::vector<double> time;     ///< by place, −½ … ½
        std::vector<double> drawn;    ///< residual by direction, drawn cycle and target
    };
    struct Buffers {
        std::vector<Lanes> readings;
        std::array<std::vector<TargetStatisticsOf<Lanes>>, 2> targets;
    };

    using Drawn = std::array<std::size_t, Lanes::count>;

    [[nodiscard]] Side sideOf(const TrialsOfTest &test) const;
    void addTable(Side &side, const std::vector<double> &table) const;
    [[nodiscard]] std::vector<double> timesOf(std::size_t positive, std::size_t count) const;
    [[nodiscard]] std::size_t pool() const; ///< number of cycles to draw from
    [[nodiscard]] double residual(std::size_t side, std::size_t place, std::size_t drawn) const;
    [[nodiscard]] std::vector<double> drawnOf(std::size_t side) const;
    [[nodiscard]] std::array<Lanes, 2> errorsOf(long long first, int which) const;
    void addResiduals(std::size_t side, std::size_t cycle, const Drawn &drawn,
                      std::vector<Lanes> &readings) const;
    void perturb(long long first, int which, DrawnParts parts, std::vector<Lanes> &readings) const;
    void runFour(long long first, DrawnParts parts, Buffers &buffers, std::span<double> differences) const;
    [[nodiscard]] bool isShared(SharedError error) const;

    const Edition &m_edition;
    DeviationMethod m_method;
    std::vector<decltype(ParameterFormula::four)> m_formulas;
    std::vector<SharedError> m_shared;
    int m_cycles;
    bool m_pooled;
    std::size_t m_targets;
    std::array<bool, 2> m_directions{};
    std::array<Side, 2> m_sides;
    RandomDraws m_draws{1};
};

} // namespace palmer
