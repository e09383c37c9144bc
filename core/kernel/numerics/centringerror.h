// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <cmath>
#include <span>
#include <vector>

namespace palmer {

/// Distances r_i from a fixed pivot to a point commanded to the angles θ_i of a circle.
struct CommandedArc {
    std::span<const double> angles;         ///< θ, degrees, any number of turns
    std::span<const double> distances;      ///< r, mm
    std::span<const Point> directions = {}; ///< u(θ) of all angles, if already known
};

struct CentringErrorOptions {
    double tolerance = 1e-15; ///< Stop if |Δe| ≤ tolerance·R.
    int maxIterations = 50;
};

/// Position e of the pivot relative to the centre of the commanded circle, one e for all arcs of a test:
///     minimise Σ_k (1/N_k)·Σ_i (r_ki − |R_k·u(θ_ki) − e|)²,   u(θ) = (cos θ, sin θ)
/// over e and one radius R_k per arc; all arcs have equal weight.
/// Method: Gauss–Newton from e = 0, R_k = mean r; with m = |R·u − e| the derivatives are ∂m/∂R = (R − e·u)/m
/// and ∂m/∂e = (e − R·u)/m, and every R_k is eliminated from the normal equations. Only e is meant to be
/// used. An arc without points is ignored.
struct CentringError {
    enum class Status {
        converged,
        notConverged, ///< maxIterations reached; e is from the last step.
        undetermined, ///< Too few distinct angles to separate e from the radii.
        notFinite,    ///< An angle or a distance is not a finite number.
    };

    Status status = Status::undetermined;
    Point e;                   ///< mm
    std::vector<double> radii; ///< R_k, mm
    int iterations = 0;

    /// True if e could be computed.
    [[nodiscard]] bool valid() const { return status == Status::converged || status == Status::notConverged; }

    bool operator==(const CentringError &) const = default;
};

[[nodiscard]] CentringError centringError(std::span<const CommandedArc> arcs,
                                          const CentringErrorOptions &options = {});

/// Returns the points P on the rays u(θ) from the centre of the commanded circle at the distances r from e,
///     ρ(θ) = e·u + √(r² − (e × u)²),   P = ρ·u.
/// Exact, whereas removing the first harmonic from r leaves an ellipse of |e|²/(2R). Coordinates in mm about
/// the centre of the commanded circle. For a ray farther from e than r (r < |e × u|), which no circle reading
/// produces, the result is the foot of the perpendicular, ρ = e·u.
[[nodiscard]] Points rebuildPoints(const CommandedArc &arc, Point e);
/// Returns ρ of one of these points.
[[nodiscard]] inline double rebuiltRadius(double r, Point u, Point e) {
    const double across = e.x * u.y - e.y * u.x;
    const double square = (r - across) * (r + across); // r² − (e × u)² without cancellation
    return e.x * u.x + e.y * u.y + std::sqrt(square > 0 ? square : 0);
}

} // namespace palmer
