// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palmer {

/// Indices of the points that are enough to draw a line: the first, least, greatest and last in each of
/// `parts` equal steps of x from `from` to `to`, in order, so that extremes stay exact; the parts outside
/// count as one step on either side. `x` and `y` take an index.
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

/// True if the figure needs no thinning: none of its curves, limits or marks exceed what paper resolves.
[[nodiscard]] bool isOrdinary(const CurveFigure &figure);

/// The figure reduced to what paper and screens resolve over the range of its x axis: too many points of
/// curves and limits to the first, least, greatest and last of each step, too many marks to one per cell and
/// the least and greatest of each step. Points that dimensions refer to are kept, and so is the order.
[[nodiscard]] CurveFigure thinned(const CurveFigure &figure);

} // namespace palmer
