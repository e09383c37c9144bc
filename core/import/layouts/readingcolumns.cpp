// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include "document/place.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

/// Codes of directions: +1 and −1, or two of 0, 1, 2.
bool areDirectionCodes(const std::vector<double> &values) {
    return !values.empty() && std::ranges::all_of(values, [](double value) {
        return value == -1 || value == 0 || value == 1 || value == 2;
    });
}

class ReadingColumns : ColumnStep {
public:
    explicit ReadingColumns(ColumnSearch &search)
        : ColumnStep(search) {}

    void findValues() {
        findCodes();
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (role(c) == ColumnRole::number && !m_result.number)
                m_result.number = c;
            if (m_result.columns[c].hasReadings())
                m_result.values.push_back(c);
        }
        dropRowCounter();
        if (m_result.values.empty())
            takeUnnamed();
        else
            askForUntitled();
        askForWords();
    }

private:
    /// Finds a column of numbers headed "direction".
    void findCodes() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (role(c) != ColumnRole::direction || !isNumeric(c))
                continue;
            const bool codes = !m_result.direction && areDirectionCodes(valuesOf(c));
            role(c) = codes ? ColumnRole::direction : ColumnRole::ignored;
            if (codes)
                m_result.direction = c;
        }
    }

    /// "Messung 1, 2, 3 …" in lines of different targets counts lines, not runs.
    void dropRowCounter() {
        if (!m_result.number || !m_result.target)
            return;
        const auto areDistinct = [](std::vector<double> values) {
            std::ranges::sort(values);
            return values.size() > 2 && std::ranges::adjacent_find(values) == values.end();
        };
        if (!areDistinct(valuesOf(*m_result.number)) || !areDistinct(valuesOf(*m_result.target)))
            return;
        role(*m_result.number) = ColumnRole::ignored;
        m_result.number.reset();
    }

    /// Unheaded columns whose midpoints differ by over a hundred times their spread are hardly runs of one
    /// test.
    void askForSizes() {
        constexpr double most = 100;
        double spread = 0;
        std::vector<double> middles;
        for (const std::size_t c : m_result.values) {
            const std::vector<double> values = valuesOf(c);
            if (values.empty())
                continue;
            const auto [low, high] = std::ranges::minmax(values);
            spread = std::max(spread, high - low);
            middles.push_back((low + high) / 2);
        }
        if (middles.size() < 2)
            return;
        const auto [least, largest] = std::ranges::minmax(middles);
        const bool isApart = largest - least > most * spread ||
                             std::max(std::abs(least), std::abs(largest)) >
                                 most * std::max(std::min(std::abs(least), std::abs(largest)), spread / most);
        if (!isApart || largest - least < spread)
            return;
        ask({REPORT_TEXT("report", "Columns: nothing says what they hold, and their numbers are of different "
                                   "size (about %1 to %2); give each its role."),
             {Number{least, Quantity::number}, Number{largest, Quantity::number}}});
        m_search.hasProposal = false;
    }

    /// No heading names the readings: takes the remaining columns as runs.
    void takeUnnamed() {
        bool named = false;
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const Meaning meaning = m_heads[c].meaning;
            const bool unknown = meaning == Meaning::unknown || meaning == Meaning::x ||
                                 meaning == Meaning::y || meaning == Meaning::axis;
            if (!isNumeric(c) || role(c) != ColumnRole::ignored || !unknown || isDroppedCounter(c))
                continue;
            role(c) = ColumnRole::run;
            m_result.values.push_back(c);
            named |= !m_heads[c].heading.empty() && words(c).axis == 0;
        }
        // If nothing but a run number could be a reading, it is one.
        if (m_result.values.empty() && m_result.number) {
            m_result.values.push_back(*m_result.number);
            role(*m_result.number) = ColumnRole::run;
            m_result.number.reset();
        }
        if (!m_result.values.empty() && named)
            ask({REPORT_TEXT("report", "Columns: the headings do not say which hold readings; “%1” and those "
                                       "like it are read as runs."),
                 {excerpt(m_heads[m_result.values.front()].heading)}});
        if (m_heads.size() > 2 && !named) {
            separatePositions();
            askForSizes();
        }
    }

    [[nodiscard]] bool isDroppedCounter(std::size_t c) const {
        return m_result.target && c < *m_result.target && isCounter(m, c);
    }

    /// Without headings: columns that follow the targets are positions, and do not belong to the other runs.
    void separatePositions() {
        if (!m_result.target)
            return;
        std::vector<std::size_t> positions;
        std::ranges::copy_if(m_result.values, std::back_inserter(positions),
                             [&](std::size_t c) { return followsTarget(c); });
        if (positions.empty() || positions.size() == m_result.values.size())
            return;
        for (const std::size_t c : m_result.values)
            role(c) = ColumnRole::deviation;
        for (const std::size_t c : positions)
            role(c) = ColumnRole::actual;
        ask({REPORT_TEXT("report",
                         "Columns: some hold positions and some deviations; the deviations are read.")});
    }

    /// Asks for columns headed as readings that contain words: "(1.2)", "1.2 µm".
    void askForWords() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const Meaning meaning = m_heads[c].meaning;
            const bool isNamed = words(c).direction || meaning == Meaning::deviation ||
                                 meaning == Meaning::actual || meaning == Meaning::reading;
            const bool holdsWords = m_heads[c].kind == ColumnKind::words ||
                                    m_heads[c].kind == ColumnKind::clock ||
                                    m_heads[c].kind == ColumnKind::dates;
            if (holdsWords && isNamed && meaning != Meaning::direction)
                ask({REPORT_TEXT("report",
                                 "Columns: “%1” is headed as readings, but holds words; it is not read."),
                     {excerpt(m_heads[c].heading)}});
            // The readings after it would be read at the targets before it.
            const bool hasNone = m_heads[c].kind == ColumnKind::words || m_heads[c].kind == ColumnKind::empty;
            const bool isBeforeReadings = m_result.target && c > *m_result.target &&
                                          !m_result.values.empty() && c < m_result.values.back();
            if (meaning == Meaning::target && hasNone && isBeforeReadings)
                ask({REPORT_TEXT(
                         "report",
                         "Columns: “%1” is headed as target positions, but holds none; it is not read."),
                     {excerpt(m_heads[c].heading)}});
        }
    }

    /// Asks for a column of numbers without a heading among others that have one.
    void askForUntitled() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (m_heads[c].isSpread && m_result.columns[c].hasReadings())
                assume(
                    {REPORT_TEXT("report", "Columns: “%1” is read as the heading of the columns without one "
                                           "behind it, too."),
                     {excerpt(m_heads[c].heading)}});
            if (isNumeric(c) && role(c) == ColumnRole::ignored && m_heads[c].heading.empty() &&
                !isCounter(m, c))
                ask({REPORT_TEXT("report", "Columns: column %1 has numbers and no heading; it is not read."),
                     {counted(c + 1)}});
        }
    }
};

} // namespace

void findReadings(ColumnSearch &search) {
    ReadingColumns(search).findValues();
}

} // namespace palmer
