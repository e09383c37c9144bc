// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include <algorithm>
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
    explicit HeadingRoles(ColumnSearch &search)
        : ColumnStep(search) {}

    void takeHeadings() {
        m_result.columns = m.columnsAs({});
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const TableColumn &head = m_heads[c];
            const bool saysWay =
                head.kind == ColumnKind::directions || head.kind == ColumnKind::senses; // of rotation
            if (saysWay && !m_result.direction) {
                role(c) = ColumnRole::direction;
                m_result.direction = c;
            } else if (isNumeric(c)) {
                role(c) = roleOf(c);
            }
        }
    }

private:
    [[nodiscard]] static bool saysReading(const TableColumn &head) {
        return head.meaning == Meaning::deviation || head.meaning == Meaning::actual ||
               head.meaning == Meaning::reading || head.meaning == Meaning::run ||
               head.meaning == Meaning::direction || head.words.direction;
    }

    [[nodiscard]] ColumnRole roleOf(std::size_t c) const {
        const TableColumn &head = m_heads[c];
        if (head.unit && head.unit->kind == UnitKind::temperature)
            return ColumnRole::temperature;
        if (head.unit && head.unit->kind == UnitKind::time && !saysReading(head))
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

} // namespace

void takeRolesOfHeadings(ColumnSearch &search) {
    HeadingRoles(search).takeHeadings();
}

} // namespace palmer
