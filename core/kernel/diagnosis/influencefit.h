// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/pathrows.h"
#include "kernel/numerics/columnfit.h"

#include <vector>

namespace palmer {

/// The columns of a diagnosis fitted to its rows, and what that says about the noise.
struct InfluenceFit {
    InfluenceFit(const PathRows &rows, std::vector<FitTerm> fitted);

    [[nodiscard]] double factor(std::size_t term) const { return fit.coefficient(Eigen::Index(term)); }
    /// Standard uncertainty of Σ weights·factors, `weights` one a term.
    [[nodiscard]] double u(const Eigen::VectorXd &weights) const;
    [[nodiscard]] double degreesOfFreedom(const Eigen::VectorXd &weights) const;
    /// Of one factor.
    [[nodiscard]] double u(std::size_t term) const;
    /// Part that cannot be told below 1e-6, and at most ten times as uncertain as alone.
    [[nodiscard]] bool isSeparable(std::size_t term) const;

    std::vector<FitTerm> terms;
    ColumnFit fit;
    CorrelatedNoise noise;
    double residual = 0; ///< standard deviation, mm

private:
    [[nodiscard]] Eigen::VectorXd basisWeights(const Eigen::VectorXd &weights) const;
};

/// A source looked for and found, or not.
struct FoundInfluence {
    InfluenceId id = InfluenceId::cyclic;
    PlaneAxis axis = PlaneAxis::none;
    double significance = 1; ///< probability that noise looks as much like it anywhere it was looked for
};

/// Looks in the residual of `fit` for reversal spikes, cyclic errors and a drift, one after the other, the
/// most conspicuous first, and fits what is significant with all the rest: less than one in a thousand by
/// noise alone and at least 0.02 µm.
[[nodiscard]] std::vector<FoundInfluence>
searchInfluences(const PathRows &rows, const DiagnosisOptions &options, InfluenceFit &fit);

/// Columns of a spike (its width to be found too, or given), a cyclic error, a drift.
[[nodiscard]] std::vector<FitTerm> spikeTerms(PlaneAxis axis, double width, bool fixed);
[[nodiscard]] std::vector<FitTerm> cyclicTerms(PlaneAxis axis, double pitch);
[[nodiscard]] std::vector<FitTerm> driftTerms(const DiagnosisOptions &options, bool bothSenses);

} // namespace palmer
