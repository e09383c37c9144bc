// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/influencefit.h"

#include <span>
#include <vector>

namespace palmer {

/// Returns how much of a curve v a cyclic error with a given pitch would explain: the part of Σ v² within the
/// columns sin(2πx/p)·x/R and cos(2πx/p)·x/R, x being the position along the axis. `along` is x/R, `curve` is
/// v·x/R, `squares` is (x/R)², all of equal length and 0 in omitted rows. `periods` is R/p.
[[nodiscard]] double explainedByPitch(std::span<const double> along, std::span<const double> curve,
                                      std::span<const double> squares, double periods);

/// What cyclic errors of one axis would explain of the residual of a fit, for all pitches from twice the
/// largest step between readings to the diameter.
class PitchScan {
public:
    PitchScan(const PathRows &rows, const InfluenceFit &fit, PlaneAxis axis);

    /// Returns R/p of a pitch of the scan.
    [[nodiscard]] double periods(std::size_t place) const { return (double(place) + 4) * spacing; }
    /// Returns the part explained by each pitch, by Fourier transforms of the readings over the position,
    /// good for choosing one. What the fit explains already is not regarded, which matters for the longest
    /// pitches.
    [[nodiscard]] std::vector<double> explained() const;
    /// Returns the pitch next to `pitch` that explains most, or a usual one that explains at most `bound`
    /// less.
    [[nodiscard]] double refined(double pitch, std::span<const double> usual, double bound) const;

private:
    static constexpr double spacing = 1.0 / 8; ///< in R/p; independent ones are 1/2 apart

    double m_step = 0; ///< rad
    double m_radius = 0;
    std::vector<double> m_along;
    std::vector<double> m_curve;
    std::vector<double> m_squares;
};

} // namespace palmer
