// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/risingindices.h"

#include <algorithm>
#include <iterator>

namespace palmer {

RisingIndices RisingIndices::upTo(std::size_t size) {
    RisingIndices result;
    if (size > 0)
        result.m_stretches.push_back({0, size, 0});
    return result;
}

void RisingIndices::add(std::size_t index) {
    if (!empty() && back() + 1 == index)
        ++m_stretches.back().size;
    else
        m_stretches.push_back({index, 1, size()});
}

std::size_t RisingIndices::size() const {
    return empty() ? 0 : m_stretches.back().place + m_stretches.back().size;
}

std::size_t RisingIndices::back() const {
    return m_stretches.back().first + m_stretches.back().size - 1;
}

std::size_t RisingIndices::operator[](std::size_t place) const {
    const auto behind = std::ranges::upper_bound(m_stretches, place, {}, &Stretch::place);
    const Stretch &stretch = *std::prev(behind);
    return stretch.first + (place - stretch.place);
}

std::optional<std::size_t> RisingIndices::placeOf(std::size_t index) const {
    const auto behind = std::ranges::upper_bound(m_stretches, index, {}, &Stretch::first);
    if (behind == m_stretches.begin())
        return std::nullopt;
    const Stretch &stretch = *std::prev(behind);
    const std::size_t along = index - stretch.first;
    return along < stretch.size ? std::optional(stretch.place + along) : std::nullopt;
}

} // namespace palmer
