// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "kernel/uncertainty/contribution.h"

#include <optional>
#include <string_view>
#include <vector>

namespace palmer {

/// U/R of a quantity of which nothing but the full width R of its range is known: 2/√12 = 0.577, rounded to
/// 0.6 by ISO 230-2:2006 Annex A.
inline constexpr double rectangularFactor = 0.6;

/// What is offered for R(α) of a machine, µm/(m·°C): it gives the 2 µm/(m·°C) that the standard calls the
/// typical minimum of U(α).
inline constexpr double typicalExpansionRange = 3.4;

/// The contributions to the uncertainty of a positioning test, after the model of ISO 230-2:2006 Annex A.
struct PositioningBudget {
    std::vector<Contribution> contributions;
    std::optional<double> length; ///< L, mm (rotary: the measurement travel in degrees, which nothing needs)

    double fixedDevice = 0; ///< part of the device's U that does not grow with the length, mm or degrees

    [[nodiscard]] const Contribution *find(std::string_view id) const;
    /// S: root of the sum of the squares of all but the environmental variation; mm, rotary: degrees. Null
    /// where one of them is unknown.
    [[nodiscard]] std::optional<double> systematic() const;
    /// U_EVE, mm, rotary: degrees.
    [[nodiscard]] std::optional<double> environmental() const;
    [[nodiscard]] bool isComplete() const { return systematic() && environmental(); }

    bool operator==(const PositioningBudget &) const = default;
};

inline constexpr const char *environmentalVariationId = "environmentalVariation";
inline constexpr const char *misalignmentId = "misalignment";
inline constexpr const char *deviceId = "device";

/// The budget of a measurement. L: as stated, else the measurement travel. `environmentalVariation`: E_VE
/// from a drift test, mm or degrees, where none is typed in. A null is unknown, a 0 a statement: what is
/// multiplied with a stated 0 is 0 whatever the rest. θ: the mean of start or that of end over all sensors,
/// the one farther from 20 °C. Rotary axes: device and environmental variation alone, in arc seconds; a part
/// per metre is refused. Negative and infinite inputs: no number, a defect.
[[nodiscard]] PositioningBudget positioningBudget(const PositioningMeasurement &measurement,
                                                  std::optional<double> environmentalVariation);

} // namespace palmer
