// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/contouringfeed.h"

#include <cmath>

namespace palmer::iso230_4 {

std::optional<double> contouringFeed(const ContouringFeed &specified) {
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
