// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"

#include <optional>
#include <span>
#include <string_view>

namespace palmer {

/// The readings that determine one end of a result: their number at its target in each direction, and the
/// ruling direction, if only one rules.
struct RulingReadings {
    int positive = 0;
    int negative = 0;
    std::optional<Direction> approach; ///< null: both together

    bool operator==(const RulingReadings &) const = default;
};

/// Both ends of a result; a result with a single end has two equal ones.
struct Rulers {
    RulingReadings upper;
    RulingReadings lower;
    bool sameTarget = false;
};

/// How the contributions combine to the U of a parameter of ISO 230-2 (propagation after the GUM; the annex
/// of the standard was not read):
///     U² = (systematic ? S² : 0) + ofEnvironment·U_EVE²,
/// S² is the sum of the squares of all contributions except environmental variation. Derived: a mean of n
/// readings has 1/√n of the uncertainty of one, s has 1/√(n − 1), both are uncorrelated, and each uses the n
/// of its own target and direction.
struct Coefficients {
    const char *id = nullptr;
    bool systematic = false;
    /// c: factor of s. Infinite if a mean has no reading or an s fewer than two.
    double (*ofEnvironment)(const Rulers &rulers, double c) = nullptr;
};

/// Returns the row of a parameter; null for an unknown id.
[[nodiscard]] const Coefficients *coefficients(std::string_view id);

/// Returns U from S and U_EVE (both k = 2, same unit). Null if s is needed and n < 2, or without a reading.
[[nodiscard]] std::optional<double> combined(const Coefficients &row, double systematic, double environmental,
                                             const Rulers &rulers, double c);

} // namespace palmer
