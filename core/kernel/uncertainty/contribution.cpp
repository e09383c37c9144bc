// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/contribution.h"

#include <algorithm>
#include <limits>

namespace palmer {

namespace {

constexpr double smallShare = 0.05; ///< of the sum of squares: below it the largest does not stand out

/// Returns the sort key of a contribution in the order of sizes.
double rank(const Contribution *contribution) {
    if (!contribution->expanded)
        return std::numeric_limits<double>::infinity();
    return contribution->applies ? *contribution->expanded : -1;
}

} // namespace

std::vector<const Contribution *> bySize(const std::vector<Contribution> &contributions) {
    std::vector<const Contribution *> result;
    result.reserve(contributions.size());
    for (const Contribution &contribution : contributions)
        result.push_back(&contribution);
    std::ranges::stable_sort(result,
                             [](const Contribution *a, const Contribution *b) { return rank(a) > rank(b); });
    return result;
}

double shareOf(const Contribution &contribution, const std::vector<Contribution> &contributions) {
    double squares = 0;
    for (const Contribution &one : contributions)
        squares += one.expanded.value_or(0) * one.expanded.value_or(0);
    const double size = contribution.expanded.value_or(0);
    return squares > 0 ? size * size / squares : 0;
}

const Contribution *toImproveFirst(const std::vector<Contribution> &contributions) {
    const auto ordered = bySize(contributions);
    const auto known = [](const Contribution *contribution) { return contribution->expanded.has_value(); };
    const auto largest = std::ranges::find_if(ordered, known);
    if (largest == ordered.end() || shareOf(**largest, contributions) < smallShare)
        return nullptr;
    return *largest;
}

} // namespace palmer
