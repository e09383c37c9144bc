// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/readingsaside.h"

#include <algorithm>
#include <utility>

namespace palmer {

namespace {

std::pair<int, int> placeOf(const ExcludedReading *reading) {
    return {reading->run, reading->target};
}

} // namespace

ReadingsAside::ReadingsAside(const PositioningMeasurement &measurement) {
    m_inOrder.reserve(measurement.excluded.size());
    for (const ExcludedReading &reading : measurement.excluded)
        m_inOrder.push_back(&reading);
    std::ranges::stable_sort(m_inOrder, {}, placeOf);
}

const ExcludedReading *ReadingsAside::at(std::size_t run, std::size_t target) const {
    const std::pair place(static_cast<int>(run) + 1, static_cast<int>(target) + 1);
    const auto found = std::ranges::lower_bound(m_inOrder, place, {}, placeOf);
    return found != m_inOrder.end() && placeOf(*found) == place ? *found : nullptr;
}

} // namespace palmer
