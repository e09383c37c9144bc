// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palmer {

/// Places of a line that are enough to draw it: in each of `parts` equal steps of x from `from` to `to` the
/// first, the least, the greatest and the last, in their order, so that extremes stay exact; what lies
/// outside is a step on either side. `x` and `y` take an index.
[[nodiscard]] std::vector<std::size_t> thinnedPlaces(std::size_t count, double from, double to,
                                                     std::size_t parts, auto &&x, auto &&y) {
    std::vector<std::size_t> kept;
    const auto steps = static_cast<double>(parts);
    const auto stepOf = [&](std::size_t i) {
        return to > from ? std::clamp(std::floor((x(i) - from) / (to - from) * steps), -1.0, steps) : 0.0;
    };
    for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
        std::size_t least = begin;
        std::size_t greatest = begin;
        const double step = stepOf(begin);
        for (end = begin + 1; end < count && stepOf(end) == step; ++end) {
            least = y(end) < y(least) ? end : least;
            greatest = y(end) < y(greatest) ? greatest : end;
        }
        std::array places{begin, least, greatest, end - 1};
        std::ranges::sort(places);
        kept.insert(kept.end(), places.begin(), std::unique(places.begin(), places.end()));
    }
    return kept;
}

/// Whether a figure is drawn as it is: none of its curves, limits or marks are more than paper resolves.
[[nodiscard]] bool isOrdinary(const CurveFigure &figure);

/// The figure as far as paper and screens resolve it, over the range its axis of x shows: of curves and
/// limits that are too many the first, least, greatest and last of each step, of marks one a place with the
/// least and the greatest of each step. What dimensions point to stays; so does the order.
[[nodiscard]] CurveFigure thinned(const CurveFigure &figure);

} // namespace palmer
