// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

namespace palmer::iso230_4 {

/// A contouring feed agreed for one diameter, and the test diameter. Feed in mm/min, diameters in mm.
struct ContouringFeed {
    double specifiedDiameter = 0; ///< d2
    double specifiedFeed = 0;     ///< V2
    double diameter = 0;          ///< d1
};

/// Returns V1 = V2·√(d1/d2) in mm/min, the feed with the same centripetal acceleration on another diameter
/// (ISO 230-4:2005, annex C). Null unless all three numbers and the result are finite and above zero.
[[nodiscard]] inline std::optional<double> contouringFeed(const ContouringFeed &specified) {
    for (const double number : {specified.specifiedDiameter, specified.specifiedFeed, specified.diameter}) {
        if (!std::isfinite(number) || number <= 0)
            return std::nullopt;
    }
    // Separate roots: the quotient of the diameters may exceed the range of double.
    const double feed =
        specified.specifiedFeed * (std::sqrt(specified.diameter) / std::sqrt(specified.specifiedDiameter));
    return std::isfinite(feed) && feed > 0 ? std::optional(feed) : std::nullopt;
}

} // namespace palmer::iso230_4
