// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/centringerror.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// Centring error of distances close to those of a reference, in one step: with the second derivatives of the
/// sum of squares at the reference it is linear in the changes of the distances, two sums for all arcs. The
/// error of the step is of second order, and an error of e moves all rebuilt points together except for its
/// part e/R, so that circles fitted to them are not affected.
class NearbyCentring {
public:
    /// `arcs` with their directions; `reference`: their centring error, which must be valid.
    NearbyCentring(std::span<const CommandedArc> arcs, const CentringError &reference);

    /// `distances` of the same arcs. Null if the error of e could affect circles by more than 1e-14·R: use
    /// centringError() then.
    [[nodiscard]] std::optional<Point>
    centringError(std::span<const std::span<const double>> distances) const;

private:
    struct Set {
        std::vector<double> distances; ///< of the reference
        std::vector<double> x;         ///< change of e per unit change
        std::vector<double> y;
    };
    std::vector<Set> m_sets;
    Point m_error;
    double m_radius = 0;    ///< smallest radius
    double m_stiffness = 1; ///< response of e to the distances relative to a full circle
};

} // namespace palmer
