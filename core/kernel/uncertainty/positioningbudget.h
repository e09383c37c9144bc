// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/uncertainty/contribution.h"

#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// U/R of a quantity of which only the full width R of its range is known: 2/√12 = 0.577, rounded to 0.6 as
/// in public drafts of ISO 230-2:2006 Annex A.
inline constexpr double rectangularFactor = 0.6;

/// Suggested R(α) of a machine, µm/(m·°C): it gives the 2 µm/(m·°C) that the standard calls the typical
/// minimum of U(α).
inline constexpr double typicalExpansionRange = 3.4;

/// The contributions to the uncertainty of a positioning test, as public drafts of ISO 230-2:2006 Annex A
/// name them.
struct PositioningBudget {
    std::vector<Contribution> contributions;
    std::optional<double> length; ///< L, mm (rotary: the measurement travel in degrees, unused)

    double fixedDevice = 0; ///< part of the device's U that does not grow with the length, mm or degrees

    [[nodiscard]] const Contribution *find(std::string_view id) const;
    /// S: root of the sum of squares of all contributions except environmental variation; mm, rotary:
    /// degrees. Null if one of them is unknown.
    [[nodiscard]] std::optional<double> systematic() const;
    /// U_EVE, mm, rotary: degrees.
    [[nodiscard]] std::optional<double> environmental() const;
    [[nodiscard]] bool isComplete() const { return systematic() && environmental(); }

    bool operator==(const PositioningBudget &) const = default;
};

inline constexpr const char *environmentalVariationId = "environmentalVariation";
inline constexpr const char *misalignmentId = "misalignment";
inline constexpr const char *deviceId = "device";

/// Returns the budget of a measurement. L: as stated, otherwise the measurement travel.
/// `environmentalVariation`: E_VE from a drift test, mm or degrees, used if none is entered. Null means
/// unknown, 0 is a statement: a product with a stated 0 is 0. θ: the mean of start or of end temperatures
/// over all sensors, whichever is farther from 20 °C. Rotary axes: device and environmental variation only,
/// in arc seconds; a part per metre is refused. A negative or infinite input is a defect and not used.
[[nodiscard]] PositioningBudget positioningBudget(const PositioningMeasurement &measurement,
                                                  std::optional<double> environmentalVariation);

} // namespace palmer
