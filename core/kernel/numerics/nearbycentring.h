// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/centringerror.h"

#include <optional>
#include <span>
#include <vector>

namespace palmer {

/// The centring error of distances that are a little apart from those of a reference, in one step: with the
/// second derivatives of the sum of squares at the reference it is linear in the changes of the distances,
/// two sums for all arcs. The error of the step is of second order; and an error of e moves all rebuilt
/// points alike but for the part e/R of it, so that circles about them do not feel it.
class NearbyCentring {
public:
    /// `arcs` with their directions; `reference`: their valid centring error.
    NearbyCentring(std::span<const CommandedArc> arcs, const CentringError &reference);

    /// `distances` of the same arcs. Null where circles could feel the error of e by more than 1e-14·R: the
    /// plain way tells then.
    [[nodiscard]] std::optional<Point>
    centringError(std::span<const std::span<const double>> distances) const;

private:
    struct Set {
        std::vector<double> distances; ///< of the reference
        std::vector<double> x;         ///< change of e by a change of 1
        std::vector<double> y;
    };
    std::vector<Set> m_sets;
    Point m_error;
    double m_radius = 0;    ///< the least
    double m_stiffness = 1; ///< how much more than for a full circle e follows the distances
};

} // namespace palmer
