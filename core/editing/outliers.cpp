// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/outliers.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double spreadsOfOutliers = 6;
constexpr double normalOfMedian = 1.4826; ///< factor from median absolute deviation to standard deviation
constexpr std::size_t leastAtTarget = 3;
constexpr std::size_t leastInAll = 10;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Distances of the readings of one target and direction from the median of the others.
void addDistances(std::vector<OutlierHint> &distances, const std::vector<OutlierHint> &readings) {
    if (readings.size() < leastAtTarget)
        return;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        std::vector<double> others;
        for (std::size_t other = 0; other < readings.size(); ++other) {
            if (other != k)
                others.push_back(readings[other].distance);
        }
        distances.push_back({readings[k].place, readings[k].distance - median(std::move(others))});
    }
}

} // namespace

std::vector<OutlierHint> outlierHints(const PositioningMeasurement &measurement) {
    std::vector<OutlierHint> distances;
    for (std::size_t i = 0; i < measurement.targets.size(); ++i) {
        for (const Direction approach : {Direction::positive, Direction::negative}) {
            std::vector<OutlierHint> readings;
            for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
                const Run &run = measurement.runs[j];
                if (run.approach == approach && i < run.deviations.size() && run.deviations[i])
                    readings.push_back({{j, i}, *run.deviations[i]});
            }
            addDistances(distances, readings);
        }
    }
    if (distances.size() < leastInAll)
        return {};
    std::vector<double> sizes;
    sizes.reserve(distances.size());
    for (const OutlierHint &hint : distances)
        sizes.push_back(std::abs(hint.distance));
    const double bound = spreadsOfOutliers * normalOfMedian * median(std::move(sizes));
    if (!(bound > 1e-12))
        return {};
    std::erase_if(distances, [bound](const OutlierHint &hint) { return std::abs(hint.distance) <= bound; });
    std::ranges::sort(distances,
                      [](const OutlierHint &a, const OutlierHint &b) { return a.place < b.place; });
    return distances;
}

} // namespace palmer
