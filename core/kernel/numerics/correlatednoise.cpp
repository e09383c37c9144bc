// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/correlatednoise.h"

#include "kernel/numerics/studentt.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace palmer {

namespace {

using Vector = Eigen::VectorXd;
using Spectra = Eigen::MatrixXcd; ///< frequencies × columns

constexpr int steps = 16;      ///< φ = 1 − 2^(−k/2), k = 0 … 15: up to 0.994
constexpr int flicker = steps; ///< index of the shape 1/ω
/// A coloured part adds two parameters: twice the chance gain of each, plus a half for the choice.
constexpr double leastGain = 3;

/// `cosine`: of the angle, which many shapes share.
double shape(int step, double angle, double cosine) {
    static const auto correlations = [] {
        std::array<double, steps> result{};
        for (int k = 0; k < steps; ++k)
            result[std::size_t(k)] = 1 - std::exp2(-k / 2.0);
        return result;
    }();
    if (step == flicker)
        return 1 / std::max(angle, 1e-3);
    const double phi = correlations[std::size_t(step)];
    return (1 - phi) * (1 - phi) / (1 + phi * phi - 2 * phi * cosine);
}

double shape(int step, double angle) {
    return shape(step, angle, std::cos(angle));
}

/// Returns the next length suited to a fast Fourier transform.
Eigen::Index smoothLength(std::size_t least) {
    for (std::size_t n = std::max<std::size_t>(least, 2);; ++n) {
        std::size_t rest = n;
        for (const std::size_t factor : {2U, 3U, 5U})
            while (rest % factor == 0)
                rest /= factor;
        if (rest == 1 && n % 2 == 0)
            return static_cast<Eigen::Index>(n);
    }
}

/// Parameters of the model for one φ.
struct Model {
    double white = 0;
    double coloured = 0;
    double loss = std::numeric_limits<double>::infinity();
};

} // namespace

/// Periodogram of the residuals and the part of each frequency left by the fit, over all records, in bands.
struct CorrelatedNoise::Spectrum {
    Spectrum(const Eigen::MatrixXd &basis, const Vector &residual, std::span<const Record> records) {
        std::size_t longest = 0;
        for (const Record &record : records)
            longest = std::max(longest, record.size);
        length = smoothLength(longest);
        const Eigen::Index frequencies = length / 2 + 1;
        multiplicity = Vector::Constant(frequencies, 2);
        multiplicity[0] = multiplicity[frequencies - 1] = 1;
        power = Vector::Zero(frequencies);
        left = Vector::Zero(frequencies);
        Eigen::FFT<double> fft;
        fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
        Vector padded(length);
        Eigen::VectorXcd transformed;
        const auto transform = [&](const auto &column, const Record &record) {
            padded.setZero();
            padded.head(Eigen::Index(record.size)) =
                column.segment(Eigen::Index(record.begin), Eigen::Index(record.size));
            fft.fwd(transformed, padded);
        };
        const auto n = double(length);
        for (const Record &record : records) {
            transform(residual, record);
            power += transformed.cwiseAbs2() / n;
            Spectra spectra(frequencies, basis.cols());
            for (Eigen::Index j = 0; j < basis.cols(); ++j) {
                transform(basis.col(j), record);
                spectra.col(j) = transformed;
            }
            left += (double(record.used) - spectra.cwiseAbs2().rowwise().sum().array()).matrix() / n;
            columns.push_back(std::move(spectra));
        }
        power = power.cwiseProduct(multiplicity) / 2;
        left = left.cwiseProduct(multiplicity).cwiseMax(0) / 2;
        cosines = Vector::NullaryExpr(frequencies, [this](Eigen::Index f) { return std::cos(angle(f)); });
        for (Eigen::Index from = 0; from < frequencies;) {
            bands.push_back(from);
            from += std::max<Eigen::Index>(2, from * 35 / 100);
        }
        bands.push_back(frequencies);
    }

    [[nodiscard]] double angle(Eigen::Index frequency) const {
        return 2 * std::numbers::pi * double(frequency) / double(length);
    }
    [[nodiscard]] Vector shapeOf(int step) const {
        Vector result(power.size());
        for (Eigen::Index f = 0; f < result.size(); ++f)
            result[f] = shape(step, angle(f), cosines[f]);
        return result;
    }
    /// Returns the sum over each band.
    [[nodiscard]] Vector banded(const Vector &values) const {
        Vector result(Eigen::Index(bands.size()) - 1);
        for (Eigen::Index b = 0; b < result.size(); ++b) {
            const auto i = static_cast<std::size_t>(b);
            result[b] = values.segment(bands[i], bands[i + 1] - bands[i]).sum();
        }
        return result;
    }
    /// Returns the weighted Fourier sum of the columns.
    [[nodiscard]] Eigen::MatrixXd weightedGram(const Vector &weights) const {
        const Eigen::Index rank = columns.empty() ? 0 : columns.front().cols();
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rank, rank);
        const Vector root = (weights.cwiseProduct(multiplicity) / double(length)).cwiseSqrt();
        for (const Spectra &spectra : columns) {
            for (const Eigen::MatrixXd &part : {Eigen::MatrixXd(root.asDiagonal() * spectra.real()),
                                                Eigen::MatrixXd(root.asDiagonal() * spectra.imag())})
                result.noalias() += part.transpose() * part;
        }
        return result;
    }

    Eigen::Index length = 0;
    Vector multiplicity;
    Vector power; ///< I, halved at the frequencies that have no partner
    Vector left;  ///< h, counted in complex numbers
    Vector cosines;
    std::vector<Spectra> columns;
    std::vector<Eigen::Index> bands;
};

namespace {

/// White and coloured for one φ by weighted least squares of I/h on its shape, iterating the weights.
Model fitModel(const Vector &power, const Vector &left, const Vector &bandShape, bool coloured) {
    Model model;
    const double total = left.sum();
    model.white = power.sum() / total;
    constexpr int turns = 12;
    constexpr double deepest = -0.95; // relative to white: S stays positive
    if (coloured) {
        const Eigen::Index half = power.size() / 2;
        const Eigen::Index rest = power.size() - half;
        model.white = power.tail(rest).sum() / left.tail(rest).sum();
        for (int turn = 0; turn < turns; ++turn) {
            const Vector s = (model.white + model.coloured * bandShape.array()).matrix();
            const Vector w = left.cwiseQuotient(s.cwiseAbs2());
            const Vector v = power.cwiseQuotient(s.cwiseAbs2());
            const double a11 = w.sum();
            const double a12 = w.dot(bandShape);
            const double a22 = (w.array() * bandShape.array().square()).sum();
            const double b1 = v.sum();
            const double b2 = v.dot(bandShape);
            const double determinant = a11 * a22 - a12 * a12;
            double white = (b1 * a22 - b2 * a12) / determinant;
            double colour = (a11 * b2 - a12 * b1) / determinant;
            if (!(colour > deepest * white)) {
                const Vector together = (1 + deepest * bandShape.array()).matrix();
                white = v.dot(together) / w.dot(together.cwiseAbs2());
                colour = deepest * white;
            }
            if (white <= 0) {
                white = 0;
                colour = b2 / a22;
            }
            model.white = std::max(white, 1e-12 * model.white);
            model.coloured = colour;
        }
    }
    const Vector s = (model.white + model.coloured * bandShape.array()).matrix();
    if (s.minCoeff() > 0)
        model.loss = (left.array() * s.array().log() + power.array() / s.array()).sum();
    return model;
}

} // namespace

CorrelatedNoise::CorrelatedNoise(const Eigen::MatrixXd &basis, const Vector &residual,
                                 std::span<const Record> records) {
    const Spectrum spectrum(basis, residual, records);
    m_covariance = Eigen::MatrixXd::Zero(basis.cols(), basis.cols());
    if (spectrum.power.sum() > 0 && spectrum.left.sum() > 0) {
        choose(spectrum);
        judge(spectrum);
        deriveCovariance(spectrum);
    }
}

void CorrelatedNoise::choose(const Spectrum &spectrum) {
    Vector power = spectrum.banded(spectrum.power);
    Vector left = spectrum.banded(spectrum.left);
    // Bands removed entirely by the fit carry no information.
    const double least = 1e-3;
    for (Eigen::Index b = 0; b < left.size(); ++b) {
        if (left[b] < least)
            left[b] = power[b] = 0;
    }
    double best = 0;
    double ofWhite = 0;
    double ofSlowest = 0;
    for (int step = 0; step <= flicker; ++step) {
        Vector bandShape = spectrum.banded(spectrum.shapeOf(step).cwiseProduct(spectrum.left));
        for (Eigen::Index b = 0; b < left.size(); ++b)
            bandShape[b] = left[b] > 0 ? bandShape[b] / left[b] : 0;
        const Model model = fitModel(power, left, bandShape, step > 0);
        if (step == 0)
            ofWhite = model.loss;
        if (step == steps - 1)
            ofSlowest = model.loss;
        if (step == flicker) {
            m_judgement.slow = m_correlation > 0 && ofSlowest < best + leastGain;
            constexpr double alike = 6; // first-order noise loses at least this much as 1/ω
            m_judgement.flicker =
                ofWhite - model.loss > 2 * leastGain && (m_correlation == 0 || model.loss < best + alike);
            break;
        }
        const double needed = step > 0 && m_correlation == 0 ? leastGain : 0;
        if (step > 0 && !(model.loss < best - needed))
            continue;
        best = model.loss;
        m_white = model.white;
        m_coloured = model.coloured;
        m_correlation = step;
    }
}

void CorrelatedNoise::judge(const Spectrum &spectrum) {
    constexpr double least = 0.5; // complex numbers left in a band, or at a frequency
    Vector s = Vector::Constant(spectrum.power.size(), m_white);
    if (m_correlation > 0)
        s += m_coloured * spectrum.shapeOf(m_correlation);
    const Vector ratio = spectrum.power.cwiseQuotient(s.cwiseMax(1e-300));
    const Vector banded = spectrum.banded(ratio);
    const Vector left = spectrum.banded(spectrum.left);
    double deviance = 0;
    double freedom = m_correlation > 0 ? -3 : -1;
    for (Eigen::Index b = 0; b < left.size(); ++b) {
        if (left[b] < least || !(banded[b] > 0))
            continue;
        const double r = banded[b] / left[b];
        deviance += 2 * left[b] * (r - 1 - std::log(r));
        freedom += 1 + 1 / (6 * left[b]); // expectation of a band
    }
    m_judgement.bands = chiSquareExceeded(deviance, freedom);
    double count = 0;
    for (Eigen::Index f = 1; f < ratio.size(); ++f) {
        if (spectrum.left[f] < least)
            continue;
        ++count;
        // The chance grows with what is left: with `least`, χ² of one degree of freedom, it is smallest.
        if (std::erfc(std::sqrt(ratio[f])) > m_judgement.line)
            continue;
        const double chance = chiSquareExceeded(2 * ratio[f], 2 * spectrum.left[f]);
        if (chance < m_judgement.line) {
            m_judgement.line = chance;
            m_judgement.frequency = double(f) / double(spectrum.length);
        }
    }
    m_judgement.line = std::min(1.0, m_judgement.line * count);
    constexpr double mostOfRecord = 1.0 / 16;
    m_judgement.slow |= std::exp2(m_correlation / 2.0) > mostOfRecord * double(spectrum.length);
}

double CorrelatedNoise::fastest() const {
    return m_white + m_coloured * shape(m_correlation, std::numbers::pi);
}

Vector CorrelatedNoise::whitened(const Vector &residual, std::span<const Record> records) const {
    Vector result = Vector::Zero(residual.size());
    Eigen::FFT<double> fft;
    for (const Record &record : records) {
        const Eigen::Index length = smoothLength(record.size);
        const auto begin = Eigen::Index(record.begin);
        const auto size = Eigen::Index(record.size);
        Eigen::VectorXcd values = Eigen::VectorXcd::Zero(length);
        values.head(size) = residual.segment(begin, size).cast<std::complex<double>>();
        Eigen::VectorXcd waves;
        fft.fwd(waves, values);
        for (Eigen::Index f = 0; f < length; ++f) {
            const double angle = 2 * std::numbers::pi * double(f) / double(length);
            const double s = m_white + (m_correlation > 0 ? m_coloured * shape(m_correlation, angle) : 0);
            waves[f] = s > 0 ? waves[f] / std::sqrt(s) : 0;
        }
        fft.inv(values, waves);
        result.segment(begin, size) = values.head(size).real();
    }
    return result;
}

void CorrelatedNoise::deriveCovariance(const Spectrum &spectrum) {
    const Eigen::Index rank = m_covariance.rows();
    const Vector ones = Vector::Ones(spectrum.power.size());
    std::vector<Vector> derivatives{ones};
    m_derivatives = {Eigen::MatrixXd::Identity(rank, rank)};
    Vector s = Vector::Constant(ones.size(), m_white);
    if (m_correlation > 0 && m_coloured != 0) {
        const Vector colour = spectrum.shapeOf(m_correlation);
        s += m_coloured * colour;
        derivatives.push_back(colour);
        m_derivatives.push_back(spectrum.weightedGram(colour));
        const int low = std::max(1, m_correlation - 1);
        const int high = std::min(steps - 1, m_correlation + 1);
        const double by = m_coloured / (high - low);
        const Vector above = spectrum.shapeOf(high);
        const Vector below = spectrum.shapeOf(low);
        derivatives.emplace_back(by * (above - below));
        m_derivatives.emplace_back(by * (spectrum.weightedGram(above) - spectrum.weightedGram(below)));
    }
    m_covariance = m_white * m_derivatives[0];
    if (m_derivatives.size() > 1)
        m_covariance += m_coloured * m_derivatives[1];
    const auto count = static_cast<Eigen::Index>(derivatives.size());
    Eigen::MatrixXd information(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            information(i, j) = (spectrum.left.array() * derivatives[std::size_t(i)].array() *
                                 derivatives[std::size_t(j)].array() / s.array().square())
                                    .sum();
    }
    m_ofParameters = information.completeOrthogonalDecomposition().pseudoInverse();
}

double CorrelatedNoise::standardUncertainty(const Vector &weights) const {
    return std::sqrt(std::max(0.0, weights.dot(m_covariance * weights)));
}

double CorrelatedNoise::degreesOfFreedom(const Vector &weights) const {
    const double square = weights.dot(m_covariance * weights);
    if (!(square > 0))
        return 1;
    Vector gradient(m_ofParameters.rows());
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
        gradient[i] = weights.dot(m_derivatives[std::size_t(i)] * weights);
    const double variance = gradient.dot(m_ofParameters * gradient);
    return variance > 0 ? std::max(1.0, 2 * square * square / variance) : 1;
}

double CorrelatedNoise::variance(double highest) const {
    constexpr int places = 32;
    double sum = 0;
    for (int i = 0; i < places; ++i)
        sum += m_white + m_coloured * shape(m_correlation, 2 * std::numbers::pi * std::min(highest, 0.5) *
                                                               (i + 0.5) / places);
    return sum / places;
}

double CorrelatedNoise::readingsPerIndependent() const {
    const double all = variance(0.5);
    return all > 0 ? (m_white + m_coloured) / all : 1;
}

} // namespace palmer
