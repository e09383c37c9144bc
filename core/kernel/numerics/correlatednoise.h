// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace palmer {

/// Rows consecutive in time at equal steps; rows of zeros are omitted readings.
struct Record {
    std::size_t begin = 0;
    std::size_t size = 0;
    std::size_t used = 0; ///< rows not omitted
};

/// Noise estimated from the residuals of a linear fit, and from it the uncertainty of every estimate.
/// Neighbouring readings of a circle are correlated; a standard uncertainty that assumes independence is too
/// small by the square root of the number of readings worth one independent reading.
///
/// Model: stationary noise, equal in all records and independent between them, with the spectrum
///     S(ω) = white + coloured·(1 − φ)²/|1 − φ·e^(−iω)|²
/// (white noise plus noise with correlation φ between neighbours; coloured may be negative, S may not).
/// Method: at each frequency the periodogram I of the residuals has the expectation h·S, with h the part of
/// the frequency left by the fit. white, coloured and φ minimise Σ h·log S + I/S over bands of frequencies; φ
/// is taken from a fixed list, and only if it explains more than chance would. For a fit with orthonormal
/// columns B: cov(Bᵀ·noise) = white·1 + coloured·K, K the Fourier sum of the columns weighted with the
/// spectrum.
/// Validity: records long compared with the correlation; if the readings of a whole arc are correlated, noise
/// cannot be separated from signal.
class CorrelatedNoise {
public:
    /// `basis`: rows × rank, orthonormal; `residual`: residual of the fit; zeros in omitted rows.
    CorrelatedNoise(const Eigen::MatrixXd &basis, const Eigen::VectorXd &residual,
                    std::span<const Record> records);

    /// Returns the covariance of the coefficients of the basis.
    [[nodiscard]] const Eigen::MatrixXd &covariance() const { return m_covariance; }
    /// Returns the standard uncertainty of the estimate Σ weights·t, t being the coefficients of the basis.
    [[nodiscard]] double standardUncertainty(const Eigen::VectorXd &weights) const;
    /// Returns the degrees of freedom of that uncertainty (JCGM 100, G.4); at least 1.
    [[nodiscard]] double degreesOfFreedom(const Eigen::VectorXd &weights) const;
    /// Returns the mean of S over the frequencies from 0 to `highest` (cycles per row): the variance of a
    /// reading in an estimate whose weights vary that fast.
    [[nodiscard]] double variance(double highest) const;
    /// Returns the readings worth one independent reading in a slowly varying estimate: S(0) / variance.
    [[nodiscard]] double readingsPerIndependent() const;
    /// Returns S of the fastest waves.
    [[nodiscard]] double fastest() const;
    /// Returns the residual divided by the root of S at each frequency: white, variance 1, if the model
    /// fits.
    [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd &residual,
                                           std::span<const Record> records) const;

    /// How well the model describes the periodogram. Probabilities are those of a model that fits.
    struct Judgement {
        double bands = 1;     ///< that the bands deviate as much: deviance of I/(h·S), χ²
        double line = 1;      ///< that any frequency stands out as much: I/S against a gamma distribution
        double frequency = 0; ///< of that line, cycles per row
        bool flicker = false; ///< a spectrum ~ 1/ω explains the bands about as well: no plateau is seen
        bool slow = false;    ///< the correlation is longer than a sixteenth of a record
    };
    [[nodiscard]] const Judgement &judgement() const { return m_judgement; }

private:
    struct Spectrum;
    void choose(const Spectrum &spectrum);
    void judge(const Spectrum &spectrum);
    void deriveCovariance(const Spectrum &spectrum);

    double m_white = 0;
    double m_coloured = 0;
    int m_correlation = 0; ///< index of φ
    Judgement m_judgement;
    Eigen::MatrixXd m_covariance;
    Eigen::MatrixXd m_ofParameters;             ///< covariance of white, coloured and φ
    std::vector<Eigen::MatrixXd> m_derivatives; ///< of m_covariance with respect to each of them
};

} // namespace palmer
