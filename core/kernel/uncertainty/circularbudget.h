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

/// Contributions to a circular result, besides displacement, resolution, repeatability and drift.
struct CircularContributions {
    bool length = false;   ///< reference length and correction to 20 °C
    bool centring = false; ///< position of the set-up
    bool noise = false;    ///< point noise of the mean of all points
};

/// Returns the contributions for a result; F about the set-up centre includes the centring.
[[nodiscard]] CircularContributions contributionsOf(OfCircle what, Centring centring);

/// True if the contribution with this id is one of `uses`.
[[nodiscard]] bool takesUp(const CircularContributions &uses, std::string_view contribution);

/// Returns the budget of a measurement. `environmentalVariation`: E_VE from a drift test, mm, used if none is
/// entered; `repeatability`: largest standard deviation of a result over repeated circles, mm, likewise;
/// `points`: N, evaluated points of all paths. The standard uncertainty of the correction is
///     u²(C) = R²·[α_i²u²(T_i) + (T_i − 20)²u²(α_i) + α_m²u²(T_m) + (T_m − 20)²u²(α_m)];
/// with one sensor for both temperatures the errors are identical: (α_i − α_m)²u²(T) replaces two terms. Null
/// means unknown, 0 is a statement; a negative or infinite input is not used and reported as a defect.
[[nodiscard]] CircularBudget circularBudget(const CircularMeasurement &measurement,
                                            std::optional<double> environmentalVariation,
                                            std::optional<double> repeatability, std::size_t points);

/// Returns U (k = 2) of a result in mm: √(Σ U²) of its contributions. `repeatability`: standard deviation of
/// this result over repeated circles, mm; null: as in the budget. Null if a contribution is unknown.
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
