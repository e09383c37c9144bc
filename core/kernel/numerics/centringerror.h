// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <cmath>
#include <span>
#include <vector>

namespace palmer {

/// The distances r_i from a fixed pivot to a point that was sent to the angles θ_i of a circle.
struct CommandedArc {
    std::span<const double> angles;         ///< θ, degrees, any number of turns
    std::span<const double> distances;      ///< r, mm
    std::span<const Point> directions = {}; ///< u(θ) of all angles, where they are known already
};

struct CentringErrorOptions {
    double tolerance = 1e-15; ///< Stop when |Δe| ≤ tolerance·R.
    int maxIterations = 50;
};

/// The position e of the pivot relative to the centre of the commanded circle, one e for all arcs of a test:
///     minimise Σ_k (1/N_k)·Σ_i (r_ki − |R_k·u(θ_ki) − e|)²,   u(θ) = (cos θ, sin θ)
/// over e and one radius R_k per arc; each arc counts alike. Method: Gauss–Newton from e = 0, R_k = mean r;
/// with m = |R·u − e| the derivatives are ∂m/∂R = (R − e·u)/m and ∂m/∂e = (e − R·u)/m, and every R_k is
/// eliminated from the normal equations. Only e is meant to be used. An arc without points does not count.
struct CentringError {
    enum class Status {
        converged,
        notConverged, ///< maxIterations reached; e is that of the last step.
        undetermined, ///< Too few different angles to tell e from the radii.
        notFinite,    ///< An angle or a distance is not a finite number.
    };

    Status status = Status::undetermined;
    Point e;                   ///< mm
    std::vector<double> radii; ///< R_k, mm
    int iterations = 0;

    /// Whether there is an e.
    [[nodiscard]] bool valid() const { return status == Status::converged || status == Status::notConverged; }

    bool operator==(const CentringError &) const = default;
};

[[nodiscard]] CentringError centringError(std::span<const CommandedArc> arcs,
                                          const CentringErrorOptions &options = {});

/// The points P on the rays u(θ) from the centre of the commanded circle that are at the distances r from e,
///     ρ(θ) = e·u + √(r² − (e × u)²),   P = ρ·u:
/// exact, where removing the first harmonic from r leaves an ellipse of |e|²/(2R). Coordinates about the
/// centre of the commanded circle, mm. A ray that passes e farther off than r (r < |e × u|) gives the foot
/// of the perpendicular, ρ = e·u: no reading of a circle does so.
[[nodiscard]] Points rebuildPoints(const CommandedArc &arc, Point e);
/// ρ of one of them.
[[nodiscard]] inline double rebuiltRadius(double r, Point u, Point e) {
    const double across = e.x * u.y - e.y * u.x;
    const double square = (r - across) * (r + across); // r² − (e × u)², without its cancellation
    return e.x * u.x + e.y * u.y + std::sqrt(square > 0 ? square : 0);
}

} // namespace palmer
