// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include <algorithm>
#include <cmath>

namespace palmer {

std::vector<double> ColumnStep::valuesOf(std::size_t column) const {
    constexpr std::size_t enough = 5000;
    return m.valuesOf(column, enough);
}

bool ColumnStep::followsTarget(std::size_t column) const {
    const std::vector<double> targets = valuesOf(*m_result.target);
    const std::vector<double> values = valuesOf(column);
    if (targets.size() != values.size() || targets.size() < 2)
        return false;
    const auto [low, high] = std::ranges::minmax(targets);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::abs(values[i] - targets[i]) > 0.1 * (high - low))
            return false;
    }
    return high > low;
}

void ColumnStep::ask(Message message) {
    if (!m_search.isDoubtful)
        m_search.question = std::move(message);
    m_search.isDoubtful = true;
}

void ColumnStep::assume(Message message) {
    if (!m_search.question)
        m_search.question = std::move(message);
}

} // namespace palmer
