// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pitchscan.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace palmer {

namespace {

/// Returns the part of Σ v² within two columns, by their products with v and with each other.
double withinColumns(double s, double c, double ss, double sc, double cc) {
    const double determinant = ss * cc - sc * sc;
    return determinant > 1e-9 * ss * cc ? (s * s * cc - 2 * s * c * sc + c * c * ss) / determinant : 0;
}

/// Returns Σ values·exp(−2πi·k·spacing·along) for k = 0 …, values shared out to the two nearest places of a
/// grid.
std::vector<std::complex<double>> transformed(const std::vector<double> &along,
                                              const std::vector<double> &values, double spacing,
                                              std::size_t size) {
    const double perUnit = spacing * double(size);
    std::vector<double> grid(size);
    for (std::size_t i = 0; i < along.size(); ++i) {
        const double place = along[i] * perUnit + double(size) / 2;
        const auto below = static_cast<std::size_t>(place);
        const double part = place - double(below);
        grid[below] += (1 - part) * values[i];
        grid[below + 1] += part * values[i];
    }
    std::vector<std::complex<double>> waves;
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    fft.fwd(waves, grid);
    for (std::size_t k = 1; k < waves.size(); k += 2)
        waves[k] = -waves[k]; // the grid begins half its length before the centre
    return waves;
}

} // namespace

PitchScan::PitchScan(const PathRows &rows, const InfluenceFit &fit, PlaneAxis axis)
    : m_fit(fit.fit)
    , m_step(rows.step())
    , m_along(rows.positions().size())
    , m_curve(m_along.size())
    , m_squares(m_along.size()) {
    for (std::size_t i = 0; i < m_along.size(); ++i) {
        if (!rows.counts(Eigen::Index(i)))
            continue;
        const PathPosition &p = rows.positions()[i];
        m_radius = p.radius;
        m_along[i] = axis == PlaneAxis::first ? p.cosine : p.sine;
        m_curve[i] = fit.fit.residual[Eigen::Index(i)] * m_along[i];
        m_squares[i] = m_along[i] * m_along[i];
    }
}

std::vector<double> PitchScan::explained() const {
    const double most = 1 / (2 * m_step); // R/p, two of the largest steps a period
    const auto count = static_cast<std::size_t>(std::max(0.0, most / spacing - 4));
    // Four places of the grid to the shortest wave, which is that of the squares.
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(64, std::size_t(8 * most / spacing)));
    const auto curve = transformed(m_along, m_curve, spacing, size);
    const auto squares = transformed(m_along, m_squares, spacing, size);
    std::vector<double> result(count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::complex<double> one = curve[k + 4];
        const std::complex<double> two = squares[2 * (k + 4)];
        const double all = squares[0].real();
        result[k] = withinColumns(-one.imag(), one.real(), (all - two.real()) / 2, -two.imag() / 2,
                                  (all + two.real()) / 2);
    }
    return result;
}

double PitchScan::explainedBy(double pitch) const {
    Eigen::MatrixX2d columns(Eigen::Index(m_along.size()), 2);
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
        const double along = m_along[std::size_t(i)];
        const double angle = 2 * std::numbers::pi * m_radius / pitch * along;
        columns.row(i) << std::sin(angle) * along, std::cos(angle) * along;
    }
    const Eigen::MatrixX2d fitted = m_fit.basis.transpose() * columns;
    const Eigen::Vector2d along = columns.transpose() * m_fit.residual;
    const Eigen::Matrix2d rest = columns.transpose() * columns - fitted.transpose() * fitted;
    return withinColumns(along[0], along[1], rest(0, 0), rest(0, 1), rest(1, 1));
}

double PitchScan::refined(double pitch, std::span<const double> usual, double bound) const {
    double best = pitch;
    double most = explainedBy(pitch);
    const auto look = [&](double periods) {
        if (const double part = explainedBy(m_radius / periods); part > most) {
            most = part;
            best = m_radius / periods;
        }
    };
    constexpr double few = 5; // long pitches resemble what is fitted: their scan is no good
    for (double periods = 1; periods < few && m_radius / pitch < few; periods += 2 * spacing)
        look(periods);
    constexpr int halvings = 6;
    for (int halved = 0; halved < halvings; ++halved) {
        const double step = std::ldexp(spacing, -halved);
        const double periods = m_radius / best;
        look(periods - step);
        look(periods + step);
    }
    for (const double one : usual) {
        if (std::abs(m_radius / one - m_radius / best) < spacing && explainedBy(one) >= most - bound)
            return one;
    }
    return best;
}

} // namespace palmer
