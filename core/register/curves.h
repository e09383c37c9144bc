// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/registeredtest.h"

#include <optional>
#include <vector>

namespace palmer {

/// Which means of two curves are compared.
enum class CurveOf { both, up, down };

/// A value at a position, mm or degrees.
struct PlacedValue {
    double position = 0;
    std::optional<double> value; ///< null: no mean at this target

    bool operator==(const PlacedValue &) const = default;
};

/// Returns the mean deviations of a test; for both directions where both have a mean.
[[nodiscard]] std::vector<PlacedValue> meansOf(const std::vector<CurvePoint> &curve, CurveOf of);

/// Difference between two curves.
struct CurveDifference {
    double from = 0; ///< common travel
    double to = 0;
    std::vector<PlacedValue> values;    ///< at the targets of both
    std::optional<PlacedValue> largest; ///< by magnitude
};

/// Returns a − b on the common travel, at the targets of both, each interpolated linearly between
/// neighbouring targets: not beyond its ends, not across a target without mean. Null without common travel.
[[nodiscard]] std::optional<CurveDifference> differenceOf(const std::vector<PlacedValue> &a,
                                                          const std::vector<PlacedValue> &b);

} // namespace palmer
