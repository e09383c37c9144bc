// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace palmer {

/// A stretch of rows that follow each other in time at equal steps; rows of zeros are readings left out.
struct Record {
    std::size_t begin = 0;
    std::size_t size = 0;
    std::size_t used = 0; ///< rows that count
};

/// What the residuals of a linear fit say about its noise, and so about the uncertainty of every estimate.
/// Neighbouring readings of a circle are not independent; a standard uncertainty that takes them so is too
/// small by the root of how many of them are worth one.
///
/// Model: stationary noise, the same in all records and independent between them, with the spectrum
///     S(ω) = white + coloured·(1 − φ)²/|1 − φ·e^(−iω)|²
/// (white noise and one whose neighbours are correlated by φ; coloured may be negative, S not).
/// Method: the periodogram I of the residuals has at each frequency the expectation h·S with h = what the fit
/// has left of that frequency. white, coloured and φ minimise Σ h·log S + I/S over bands of frequencies; φ
/// from a fixed list, and only where it explains more than chance would.
/// With a fit of orthonormal columns B: cov(Bᵀ·noise) = white·1 + coloured·K, K the Fourier sum of the
/// columns weighted with the spectrum.
/// Validity: records long against the correlation: where the neighbours of a whole arc are alike, noise
/// cannot be told from signal by anyone.
class CorrelatedNoise {
public:
    /// `basis`: rows × rank, orthonormal; `residual`: what is left of the fit; zeros in rows left out.
    CorrelatedNoise(const Eigen::MatrixXd &basis, const Eigen::VectorXd &residual,
                    std::span<const Record> records);

    /// Covariance of the coefficients of the basis.
    [[nodiscard]] const Eigen::MatrixXd &covariance() const { return m_covariance; }
    /// Standard uncertainty of the estimate Σ weights·t, t the coefficients of the basis.
    [[nodiscard]] double standardUncertainty(const Eigen::VectorXd &weights) const;
    /// How well that is known, as degrees of freedom (JCGM 100, G.4); at least 1.
    [[nodiscard]] double degreesOfFreedom(const Eigen::VectorXd &weights) const;
    /// Mean of S over the frequencies from 0 to `highest` (cycles a row): variance of a reading as an
    /// estimate sees it whose weights vary that fast.
    [[nodiscard]] double variance(double highest) const;
    /// How many readings are worth one to a slowly varying estimate: S(0) by the variance of a reading.
    [[nodiscard]] double readingsPerIndependent() const;

private:
    struct Spectrum;
    void choose(const Spectrum &spectrum);
    void deriveCovariance(const Spectrum &spectrum);

    double m_white = 0;
    double m_coloured = 0;
    int m_correlation = 0; ///< index of φ
    Eigen::MatrixXd m_covariance;
    Eigen::MatrixXd m_ofParameters;             ///< covariance of white, coloured and φ
    std::vector<Eigen::MatrixXd> m_derivatives; ///< of m_covariance by each of them
};

} // namespace palmer
