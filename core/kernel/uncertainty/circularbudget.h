// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/circular.h"
#include "kernel/uncertainty/contribution.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// The contributions to the uncertainty of a circular test (ISO 230-4:2005, 4.6; combination by the GUM).
struct CircularBudget {
    std::vector<Contribution> contributions; ///< mm

    [[nodiscard]] const Contribution *find(std::string_view id) const;

    bool operator==(const CircularBudget &) const = default;
};

/// What a result of a circular test takes up, besides displacement, resolution, repeatability and drift.
struct CircularContributions {
    bool length = false;   ///< reference length and correction to 20 °C
    bool centring = false; ///< position of the set-up
    bool noise = false;    ///< point noise of the mean of all points
};

/// Of a quantity; F about the set-up centre has its centring too.
[[nodiscard]] CircularContributions contributionsOf(OfCircle what, Centring centring);

/// Whether a contribution (its id) is one of those.
[[nodiscard]] bool takesUp(const CircularContributions &uses, std::string_view contribution);

/// The budget of a measurement. `environmentalVariation`: E_VE from a drift test, mm, where none is typed in;
/// `repeatability`: the largest standard deviation of a result over repeated circles, mm, likewise;
/// `points`: N that are evaluated of all paths. The standard uncertainty of the correction is
///     u²(C) = R²·[α_i²u²(T_i) + (T_i − 20)²u²(α_i) + α_m²u²(T_m) + (T_m − 20)²u²(α_m)];
/// with one sensor for both temperatures their errors are one: (α_i − α_m)²u²(T) in place of two terms. A
/// null is unknown, a 0 a statement; negative and infinite inputs: no number, a defect.
[[nodiscard]] CircularBudget circularBudget(const CircularMeasurement &measurement,
                                            std::optional<double> environmentalVariation,
                                            std::optional<double> repeatability, std::size_t points);

/// U (k = 2) of a result in mm: √(Σ U²) of what it takes up. `repeatability`: of this result, standard
/// deviation over repeated circles, mm; null: as the budget says. Null where a contribution is unknown.
[[nodiscard]] std::optional<double> combined(const CircularBudget &budget, const CircularContributions &uses,
                                             std::optional<double> repeatability);

inline constexpr const char *displacementId = "displacement";
inline constexpr const char *resolutionId = "resolution";
inline constexpr const char *repeatabilityId = "repeatability";
inline constexpr const char *driftId = "environmentalVariation";
inline constexpr const char *referenceLengthId = "referenceLength";
inline constexpr const char *correctionId = "correction";
inline constexpr const char *centringId = "centring";
inline constexpr const char *pointNoiseId = "pointNoise";

} // namespace palmer
