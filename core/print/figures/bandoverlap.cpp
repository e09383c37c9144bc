// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/bandoverlap.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// The band at x, which must be in its range; `segment` caches the last segment, so x must not decrease.
BandPoint at(const std::vector<BandPoint> &band, double x, std::size_t &segment) {
    while (segment + 2 < band.size() && band[segment + 1].x < x)
        ++segment;
    const BandPoint &from = band[segment];
    const BandPoint &to = band[segment + 1];
    const double t = (x - from.x) / (to.x - from.x);
    return {x, from.lower + t * (to.lower - from.lower), from.upper + t * (to.upper - from.upper)};
}

/// Adds the x at which the difference of two lines changes sign between `from` and `to`.
void addCrossing(std::vector<double> &places, double from, double to, double differenceFrom,
                 double differenceTo) {
    if ((differenceFrom < 0) != (differenceTo < 0)) {
        const double t = differenceFrom / (differenceFrom - differenceTo);
        places.push_back(from + t * (to - from));
    }
}

/// Ascending x common to both bands: between two of them neither band has a corner, nor do they cross.
std::vector<double> cornersAndCrossings(const std::vector<BandPoint> &a, const std::vector<BandPoint> &b) {
    const double first = std::max(a.front().x, b.front().x);
    const double last = std::min(a.back().x, b.back().x);
    std::vector<double> corners;
    for (const auto *band : {&a, &b}) {
        for (const BandPoint &point : *band) {
            if (point.x >= first && point.x <= last)
                corners.push_back(point.x);
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

    std::vector<double> places;
    std::size_t segmentA = 0;
    std::size_t segmentB = 0;
    BandPoint previousA;
    BandPoint previousB;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const BandPoint here = at(a, corners[i], segmentA);
        const BandPoint there = at(b, corners[i], segmentB);
        if (i > 0) {
            const std::array differences{
                std::pair{previousA.upper - previousB.upper, here.upper - there.upper},
                std::pair{previousA.lower - previousB.lower, here.lower - there.lower},
                std::pair{previousA.upper - previousB.lower, here.upper - there.lower},
                std::pair{previousB.upper - previousA.lower, there.upper - here.lower},
            };
            for (const auto &[from, to] : differences)
                addCrossing(places, corners[i - 1], corners[i], from, to);
        }
        places.push_back(corners[i]);
        previousA = here;
        previousB = there;
    }
    std::sort(places.begin(), places.end());
    return places;
}

} // namespace

std::vector<std::vector<BandPoint>> bandOverlap(const std::vector<BandPoint> &a,
                                                const std::vector<BandPoint> &b) {
    std::vector<std::vector<BandPoint>> overlaps;
    if (a.size() < 2 || b.size() < 2)
        return overlaps;
    std::size_t segmentA = 0;
    std::size_t segmentB = 0;
    bool open = false;
    for (const double x : cornersAndCrossings(a, b)) {
        const BandPoint here = at(a, x, segmentA);
        const BandPoint there = at(b, x, segmentB);
        const double lower = std::max(here.lower, there.lower);
        const double upper = std::min(here.upper, there.upper);
        // At the crossing that opens or closes an overlap its height is zero except for rounding.
        const double slack = 1e-9 * std::max(here.upper - here.lower, there.upper - there.lower);
        if (upper < lower - slack) {
            open = false;
            continue;
        }
        if (!open)
            overlaps.emplace_back();
        open = true;
        overlaps.back().push_back({x, std::min(lower, upper), std::max(lower, upper)});
    }
    std::erase_if(overlaps, [](const auto &overlap) { return overlap.size() < 2; });
    return overlaps;
}

} // namespace palmer
