// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include "tables/folded.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

class SignOfColumns : ColumnStep {
public:
    explicit SignOfColumns(ColumnSearch &search)
        : ColumnStep(search) {}

    void takeHints() {
        bool up = false;
        bool down = false;
        for (const std::size_t c : m_result.values) {
            const auto direction = words(c).direction ? words(c).direction : words(c).hint;
            up |= direction == Direction::positive;
            down |= direction == Direction::negative;
        }
        const bool paired = up && down;
        bool allSigns = true;
        bool allClear = true;
        for (const std::size_t c : m_result.values) {
            ImportColumn &column = m_result.columns[c];
            column.number = words(c).number.value_or(0);
            column.direction = words(c).direction;
            if (!column.direction && words(c).namesSense) {
                column.direction = words(c).hint;
                m_result.hasSenses = true;
            } else if (!column.direction && paired && words(c).hint) {
                column.direction = words(c).hint;
                m_result.hasHints = true;
                allClear = allClear && isClear(c);
            }
            // "Dev + 1" next to "Dev - 1": signs, not dashes between words.
            allSigns = allSigns && !words(c).comesFrom &&
                       folded(m_heads[c].heading).find_first_of("+-") != std::string::npos;
        }
        m_result.hasHints = (m_result.hasHints && !allSigns && !allClear) || m_result.hasSenses;
    }

    [[nodiscard]] bool isClear(std::size_t column) const {
        const HeadingWords &heading = words(column);
        return heading.isClearHint(std::ranges::any_of(m_result.values, [&](std::size_t c) {
            return words(c).direction && words(c).direction != heading.hint;
        }));
    }

    /// Finds deviation = actual − target or the opposite from the numbers, if positions are given too.
    void proveSign() {
        if (m_search.positions.empty() || m_search.positions.size() != m_result.values.size() ||
            !m_result.target)
            return;
        double same = 0;
        double opposite = 0;
        double size = 0;
        for (std::size_t k = 0; k < m_search.positions.size(); ++k) {
            const Unit *unit = m_heads[m_result.values[k]].unit;
            const Unit *base = m_heads[m_search.positions[k]].unit;
            if (!unit || !base)
                return;
            for (const TableBlock &block : m.body.blocks) {
                for (const std::uint32_t row : block.rows) {
                    const auto t = m.numberAt(row, *m_result.target);
                    const auto a = m.numberAt(row, m_search.positions[k]);
                    const auto d = m.numberAt(row, m_result.values[k]);
                    if (!t || !a || !d)
                        continue;
                    const double difference = base->toBase(*a) - base->toBase(*t);
                    same = std::max(same, std::abs(unit->toBase(*d) - difference));
                    opposite = std::max(opposite, std::abs(unit->toBase(*d) + difference));
                    size = std::max(size, std::abs(difference));
                }
            }
        }
        constexpr double part = 0.05; // of the largest difference; allows for the decimals of the positions
        if (same < part * size)
            m_result.sign = "actualMinusTarget";
        else if (opposite < part * size)
            m_result.sign = "targetMinusActual";
        else
            ask({REPORT_TEXT(
                "report", "Columns: the deviations are not the differences of actual and target positions; "
                          "the deviations are read.")});
    }
};

} // namespace

void takeDirectionsOfHeadings(ColumnSearch &search) {
    SignOfColumns(search).takeHints();
}

void proveSign(ColumnSearch &search) {
    SignOfColumns(search).proveSign();
}

} // namespace palmer
