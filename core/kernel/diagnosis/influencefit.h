// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/pathrows.h"
#include "kernel/numerics/columnfit.h"

#include <vector>

namespace palmer {

constexpr double leastAmplitude = 2e-5; ///< mm: no circular test instrument resolves less

/// The columns of a diagnosis fitted to its rows, with the noise derived from the residual.
struct InfluenceFit {
    InfluenceFit(const PathRows &rows, std::vector<FitTerm> fitted);
    /// `columns`: the fit of these terms, if it is made already.
    InfluenceFit(const PathRows &rows, std::vector<FitTerm> fitted, ColumnFit columns);

    [[nodiscard]] double factor(std::size_t term) const { return fit.coefficient(Eigen::Index(term)); }
    /// Standard uncertainty of Σ weights·factors, one weight per term.
    [[nodiscard]] double u(const Eigen::VectorXd &weights) const;
    [[nodiscard]] double degreesOfFreedom(const Eigen::VectorXd &weights) const;
    /// Returns the standard uncertainty of one factor.
    [[nodiscard]] double u(std::size_t term) const;
    /// True if the hidden part is below 1e-6 and the uncertainty at most ten times that of the column alone.
    [[nodiscard]] bool isSeparable(std::size_t term) const;
    /// Adds to all uncertainties that of the angles (rad), which turns the whole path.
    void turnBy(const PathRows &rows, double uncertainty);

    std::vector<FitTerm> terms;
    ColumnFit fit;
    CorrelatedNoise noise;
    double residual = 0; ///< standard deviation, mm

private:
    [[nodiscard]] Eigen::VectorXd basisWeights(const Eigen::VectorXd &weights) const;

    Eigen::VectorXd m_turned; ///< change of the coefficients of the basis by u of the angles; may be empty
};

/// An influence found by the search.
struct FoundInfluence {
    InfluenceId id = InfluenceId::cyclic;
    PlaneAxis axis = PlaneAxis::none;
    double significance = 1;           ///< probability that noise looks as much like it anywhere searched
    std::vector<FitTerm> alternatives; ///< periodic deviations that explain the readings as well
};

/// Searches the residual of `fit` for reversal spikes, cyclic errors and a drift, one at a time, the most
/// conspicuous first, and adds the significant ones to the fit: probability below 1/1000 from noise alone,
/// and at least 0.02 µm. Pitches are searched on both axes, from twice the largest step between readings to
/// the diameter; a width or a pitch at the end of its range is no result. What hides in the noise that it
/// makes itself is accepted only if the residual without it is noise. Returns those found. `onlyDrift`:
/// nothing that depends on where the reversals are.
[[nodiscard]] std::vector<FoundInfluence>
searchInfluences(const PathRows &rows, const DiagnosisOptions &options, InfluenceFit &fit, bool onlyDrift);

/// Columns of a spike (width fixed or to be found), a cyclic error, a drift.
[[nodiscard]] std::vector<FitTerm> spikeTerms(PlaneAxis axis, double width, bool fixed);
[[nodiscard]] std::vector<FitTerm> cyclicTerms(PlaneAxis axis, double pitch);
[[nodiscard]] std::vector<FitTerm> driftTerms(const DiagnosisOptions &options, bool bothSenses);

} // namespace palmer
