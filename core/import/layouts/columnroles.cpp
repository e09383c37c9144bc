// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"
#include "import/layouts/passes.h"

#include "document/place.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

/// True for run numbers, 1, 1, 2, 2 … in any order. Readings are hardly ever small repeated integers.
bool areRunNumbers(const std::vector<double> &values) {
    std::size_t changes = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] < 0 || values[i] > 1e4 || values[i] != std::floor(values[i]))
            return false;
        changes += i > 0 && values[i] != values[i - 1] ? 1 : 0;
    }
    return !values.empty() && changes <= values.size();
}

class HeadingRoles : ColumnStep {
public:
    using ColumnStep::ColumnStep;

    void takeHeadings() {
        m_result.columns = m.columnsAs({});
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const TableColumn &head = m_heads[c];
            const bool saysWay =
                m.body.saysDirections(head) || head.kind == ColumnKind::senses; // of rotation
            if (saysWay && !m_result.direction) {
                role(c) = ColumnRole::direction;
                m_result.direction = c;
            } else if (isNumeric(c)) {
                role(c) = roleOf(c);
            }
        }
    }

private:
    [[nodiscard]] ColumnRole roleOf(std::size_t c) const {
        const TableColumn &head = m_heads[c];
        const bool saysReading = head.words.direction ||
                                 isOneOf(head.meaning, {Meaning::deviation, Meaning::actual, Meaning::reading,
                                                        Meaning::run, Meaning::direction});
        if (head.isIn(UnitKind::temperature))
            return ColumnRole::temperature;
        if (head.isIn(UnitKind::time) && !saysReading)
            return ColumnRole::time; // otherwise "(sec)" may be of arc, and is asked
        switch (head.meaning) {
        case Meaning::statistic:
            return ColumnRole::statistic;
        case Meaning::temperature:
            return ColumnRole::temperature;
        case Meaning::time:
            return ColumnRole::time;
        case Meaning::radius:
            return head.words.words > 1 ? ColumnRole::radius : ColumnRole::statistic; // R: repeatability
        case Meaning::nominal:
            return ColumnRole::nominal;
        case Meaning::deviation:
            return ColumnRole::deviation;
        case Meaning::actual:
            return ColumnRole::actual;
        case Meaning::reading:
            return ColumnRole::run;
        case Meaning::run:
            return roleOfRun(c);
        case Meaning::direction:
            return head.words.direction || head.words.number || head.words.hint ? ColumnRole::run
                                                                                : ColumnRole::direction;
        case Meaning::place:
            return head.words.direction ? ColumnRole::run : ColumnRole::ignored;
        case Meaning::unknown:
        case Meaning::index:
        case Meaning::axis:
        case Meaning::x:
        case Meaning::y:
            return isRunHeading(head.words) ? ColumnRole::run : ColumnRole::ignored;
        case Meaning::angle: // "Measured angle"
            return head.words.isActual && !head.words.isTarget ? ColumnRole::actual : ColumnRole::ignored;
        case Meaning::target:
        case Meaning::other:
        case Meaning::process:
            break;
        }
        return ColumnRole::ignored;
    }

    /// "↑ 3", "2", "X+": a direction or a number without unknown words.
    [[nodiscard]] static bool isRunHeading(const HeadingWords &heading) {
        const bool known = heading.unknownWords == 0 || (heading.hint && heading.unknownWords <= 1);
        return known &&
               (heading.direction || heading.number || (heading.hint && heading.meaning == Meaning::unknown));
    }

    [[nodiscard]] ColumnRole roleOfRun(std::size_t c) const {
        const HeadingWords &heading = words(c);
        if (!heading.number && !heading.direction && !m_heads[c].unit && areRunNumbers(valuesOf(c)))
            return ColumnRole::number;
        return ColumnRole::run;
    }
};

class TargetColumn : ColumnStep {
public:
    using ColumnStep::ColumnStep;

    void findTarget() {
        placeBareList();
        if (m_search.targets.empty())
            findTargetByHeading();
        if (m_search.targets.empty())
            return;
        m_result.target = m_search.targets.front();
        role(m_search.targets.front()) = ColumnRole::target;
        findPositions();
    }

    /// Finds further target columns in another order, each before the readings it belongs to.
    void findOwnTargets() {
        if (!m_result.target || m_result.values.size() < 2)
            return;
        const std::vector<double> first = valuesOf(*m_result.target);
        for (std::size_t c = *m_result.target + 1; c < m_result.values.back(); ++c) {
            const bool isPlace = m_heads[c].meaning == Meaning::target || isCalledAsTarget(c) ||
                                 m_heads[c].meaning == Meaning::place;
            if (!isNumeric(c) || role(c) != ColumnRole::ignored || !isPlace || hasForeignAxis(c))
                continue;
            const std::vector<double> values = valuesOf(c);
            // A list goes there and back.
            const bool isList = m_result.direction || m_result.number;
            if (values == first || !(isList || (values.size() > 1 && isStrictlyMonotone(values))))
                continue;
            role(c) = ColumnRole::target;
            if (m_heads[c].meaning != Meaning::target && !isCalledAsTarget(c))
                assume(REPORT_TEXT("report",
                                   "Columns: the readings behind “%1” are taken to stand at its positions."),
                       excerpt(m_heads[c].heading));
        }
    }

private:
    [[nodiscard]] bool isCalledAsTarget(std::size_t c) const {
        return !m_heads[c].heading.empty() && m_heads[c].heading == m_heads[*m_result.target].heading;
    }
    [[nodiscard]] bool hasForeignAxis(std::size_t c) const {
        return !m.axisFound.empty() && words(c).axis != 0 && words(c).axis != m.axisFound[0];
    }

    /// A list without headings: the reading is the last number of a line, the target the one with the largest
    /// range, and a column constant from line to line the run number.
    void placeBareList() {
        std::vector<std::size_t> columns = m.body.numberColumns();
        const bool isBare =
            std::ranges::all_of(m_heads, [](const TableColumn &head) { return head.heading.empty(); });
        if (!isBare || !m_result.direction || columns.size() < 3)
            return;
        role(columns.back()) = ColumnRole::run;
        columns.pop_back();
        const auto rangeOf = [&](std::size_t c) {
            const std::vector<double> values = valuesOf(c);
            if (values.empty())
                return -1.0;
            const auto [low, high] = std::ranges::minmax(values);
            return high - low;
        };
        std::size_t target = columns.front();
        for (const std::size_t c : columns)
            target = rangeOf(c) >= rangeOf(target) ? c : target;
        m_search.targets = {target};
        for (const std::size_t c : columns) {
            const std::vector<double> values = valuesOf(c);
            std::size_t same = 0;
            for (std::size_t i = 1; i < values.size(); ++i)
                same += values[i] == values[i - 1] ? 1 : 0;
            if (c != target && 2 * same > values.size() && !isCounter(m, c))
                role(c) = ColumnRole::number;
        }
    }

    void findTargetByHeading() {
        const std::array<std::function<bool(std::size_t)>, 6> sorts{
            [&](std::size_t c) { return m_heads[c].meaning == Meaning::target; },
            [&](std::size_t c) {
                return m_heads[c].meaning == Meaning::place && !words(c).direction && !words(c).number;
            },
            [&](std::size_t c) {
                return (m_heads[c].meaning == Meaning::angle && !words(c).isActual) ||
                       m_heads[c].meaning == Meaning::place;
            },
            [&](std::size_t c) { return isCalledByAxis(c); },
            [&](std::size_t c) { return m_heads[c].meaning == Meaning::index && !isCounter(m, c); },
            [&](std::size_t c) { return isUnnamed(c); }};
        for (const auto &sort : sorts) {
            for (std::size_t c = 0; c < m_heads.size(); ++c) {
                if (isNumeric(c) && role(c) != ColumnRole::number && !hasOtherAxis(c) && sort(c))
                    m_search.targets.push_back(c);
            }
            if (!m_search.targets.empty())
                break;
        }
        dropCounter();
    }

    void findPositions() {
        // "Position" next to "Target" is the actual position if it follows the target.
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (c != m_search.targets.front() && isNumeric(c) && role(c) == ColumnRole::ignored &&
                m_heads[c].meaning == Meaning::place)
                role(c) = followsTarget(c)  ? ColumnRole::actual
                          : words(c).number ? ColumnRole::run
                                            : ColumnRole::ignored;
        }
    }

    /// True if the user chose another axis, which has its own targets.
    [[nodiscard]] bool hasOtherAxis(std::size_t c) const {
        const std::string_view chosen = m.choices.chosen("axis");
        return chosen.size() == 1 && words(c).axis != 0 && words(c).axis != chosen[0] && isTwoAxes();
    }
    [[nodiscard]] bool isTwoAxes() const {
        char first = 0;
        for (const TableColumn &head : m_heads) {
            if (head.kind != ColumnKind::numbers || head.words.axis == 0 ||
                head.meaning == Meaning::statistic)
                continue;
            if (first != 0 && head.words.axis != first)
                return true;
            first = head.words.axis;
        }
        return false;
    }

    [[nodiscard]] bool isCalledByAxis(std::size_t c) const {
        const HeadingWords &heading = words(c);
        return heading.axis != 0 && heading.words == 1 && m_heads[c].meaning != Meaning::statistic;
    }

    [[nodiscard]] bool isUnnamed(std::size_t c) const {
        return m_heads[c].meaning == Meaning::unknown && !words(c).direction && !words(c).number;
    }

    /// Drops a first column that counts, next to an axis.
    void dropCounter() {
        if (m_search.targets.size() < 2 || m_heads[m_search.targets.front()].meaning == Meaning::target ||
            !isCounter(m, m_search.targets.front()))
            return;
        const bool named = !m_heads[m_search.targets.front()].heading.empty();
        if (m_search.targets.size() > 2 ? isAxisLike(m_search.targets[1], m_search.targets[2]) : named)
            m_search.targets.erase(m_search.targets.begin());
    }

    /// True if a column is strictly monotonic over a longer range than the values next to it.
    [[nodiscard]] bool isAxisLike(std::size_t column, std::size_t beside) const {
        const std::vector<double> values = valuesOf(column);
        const std::vector<double> others = valuesOf(beside);
        if (values.size() < 2 || !isStrictlyMonotone(values) || others.empty())
            return false;
        const auto [low, high] = std::ranges::minmax(others);
        const double length = std::abs(values.back() - values.front());
        return length > 2 * std::max(std::abs(low), std::abs(high)) ||
               (high - low > 0 && std::abs(values.back() - others.back()) < 0.1 * length);
    }
};

} // namespace

void takeRolesOfHeadings(ColumnSearch &search) {
    HeadingRoles(search).takeHeadings();
}

void findTargetColumn(ColumnSearch &search) {
    TargetColumn(search).findTarget();
}

void findOwnTargets(ColumnSearch &search) {
    TargetColumn(search).findOwnTargets();
}

} // namespace palmer
