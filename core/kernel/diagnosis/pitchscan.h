// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influencefit.h"

#include <span>
#include <vector>

namespace palmer {

/// The part of the residual of a fit that cyclic errors of one axis would explain, for all pitches from
/// twice the largest step between readings to the diameter.
class PitchScan {
public:
    PitchScan(const PathRows &rows, const InfluenceFit &fit, PlaneAxis axis);

    /// Returns R/p of a pitch of the scan.
    [[nodiscard]] static double periods(std::size_t place) { return (double(place) + 4) * spacing; }
    /// Returns the part explained by each pitch, by Fourier transforms of the readings over the position,
    /// good for choosing one. What the fit explains already is not regarded, which matters for the longest
    /// pitches.
    [[nodiscard]] std::vector<double> explained() const;
    /// Returns the part of the residual that a pitch explains beyond what is fitted already.
    [[nodiscard]] double explainedBy(double pitch) const;
    /// Returns the pitch next to `pitch` that explains most (of long pitches any), or a usual one next to it
    /// that explains at most `bound` less.
    [[nodiscard]] double refined(double pitch, std::span<const double> usual, double bound) const;

private:
    static constexpr double spacing = 1.0 / 8; ///< in R/p; independent ones are 1/2 apart

    const ColumnFit &m_fit;
    double m_step = 0; ///< rad
    double m_radius = 0;
    std::vector<double> m_along;
    std::vector<double> m_curve;
    std::vector<double> m_squares;
};

} // namespace palmer
