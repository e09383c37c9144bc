// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/trend/notbefore.h"

#include <algorithm>
#include <limits>

namespace palmer {

double trendHorizon(const TrendLine &line) {
    return line.first + 2 * (line.last - line.first);
}

NotBefore notBefore(const TrendLine &line, const TrendLimits &limits, double reserve) {
    if (!limits.upper && !limits.lower)
        return {};
    /// Returns how far the bounds are inside the limits.
    const auto room = [&](double time) {
        const double away = line.oneSided * line.uncertaintyAt(time);
        double least = std::numeric_limits<double>::infinity();
        if (limits.upper)
            least = std::min(least, *limits.upper - reserve - (line.at(time) + away));
        if (limits.lower)
            least = std::min(least, line.at(time) - away - (*limits.lower + reserve));
        return least;
    };
    if (room(line.last) <= 0)
        return {NotBefore::State::already, line.last};
    double inside = line.last;
    double outside = trendHorizon(line);
    if (room(outside) > 0)
        return {NotBefore::State::beyond, 0};
    constexpr double second = 1e-8; // in years, about a third of a second
    while (outside - inside > second) {
        const double middle = (inside + outside) / 2;
        (room(middle) > 0 ? inside : outside) = middle;
    }
    return {NotBefore::State::date, inside};
}

} // namespace palmer
