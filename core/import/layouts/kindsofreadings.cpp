// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include "document/place.h"

#include <algorithm>
#include <array>
#include <map>

namespace palmer {

namespace {

class KindsOfReadings : ColumnStep {
public:
    explicit KindsOfReadings(ColumnSearch &search)
        : ColumnStep(search) {}

    void keep() {
        chooseAxis();
        chooseState();
        keepOneRole();
        keepOneUnit();
        keepOneStem();
        keepDirected();
        askForRuns();
    }

private:
    void setAside(const std::function<bool(std::size_t)> &keeps) {
        std::erase_if(m_result.values, [&](std::size_t c) {
            const bool goes = !keeps(c);
            if (goes)
                role(c) = ColumnRole::ignored;
            return goes;
        });
    }

    void chooseAxis() {
        if (m.choices.isChosen("columns"))
            return;
        std::vector<std::string> axes;
        for (const std::size_t c : m_result.values) {
            const std::string axis(1, words(c).axis);
            if (words(c).axis != 0 && m_heads[c].meaning != Meaning::statistic && !isLetterHint(c) &&
                std::ranges::find(axes, axis) == axes.end())
                axes.push_back(axis);
        }
        if (axes.size() < 2)
            return;
        const std::string axis = resolveAxis(m, axes);
        setAside([&](std::size_t c) { return words(c).axis == axis[0]; });
        for (const std::size_t c : m_search.targets) {
            if (words(c).axis == axis[0]) {
                role(*m_result.target) = ColumnRole::ignored;
                m_result.target = c;
                role(c) = ColumnRole::target;
            }
        }
    }

    /// Readings before and after an adjustment are two tests.
    void chooseState() {
        const auto has = [this](TestRole state) {
            return std::ranges::any_of(m_result.values,
                                       [&](std::size_t c) { return words(c).state == state; });
        };
        const bool isEither = has(TestRole::asFound) && has(TestRole::asLeft);
        if (isEither && !m.choices.isChosen("columns")) {
            m.stateFound = resolveState(m);
            setAside([this](std::size_t c) { return words(c).state == m.stateFound; });
        } else if (has(TestRole::asFound) || has(TestRole::asLeft)) {
            m.stateFound = has(TestRole::asLeft) ? TestRole::asLeft : TestRole::asFound;
        }
    }

    /// "1A" next to "1R" is not an axis A.
    [[nodiscard]] bool isLetterHint(std::size_t c) const {
        return words(c).hint && (words(c).axis == 'A' || words(c).axis == 'B');
    }

    void keepOneRole() {
        std::array<std::size_t, 3> counts{};
        const auto sortOf = [&](std::size_t c) {
            return role(c) == ColumnRole::deviation ? 0U : role(c) == ColumnRole::actual ? 1U : 2U;
        };
        for (const std::size_t c : m_result.values)
            ++counts[sortOf(c)];
        const auto roles = std::ranges::count_if(counts, [](std::size_t count) { return count > 0; });
        std::size_t kept = 0;
        if (counts[0] == 0)
            kept = counts[1] >= counts[2] ? 1 : 2;
        else if (counts[2] > counts[0])
            kept = 2;
        if (roles < 2) {
            takeContent(kept);
            return;
        }
        // Deviations and the positions they are computed from are equivalent; the deviations are read.
        if (kept != 0 || counts[2] > 0)
            ask({REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                       "“%1” are read, the others are not."),
                 {excerpt(m_heads[*std::ranges::find_if(m_result.values, [&](std::size_t c) {
                              return sortOf(c) == kept;
                          })].heading)}});
        if (kept == 0) {
            std::ranges::copy_if(m_result.values, std::back_inserter(m_search.positions),
                                 [&](std::size_t c) { return role(c) == ColumnRole::actual; });
        }
        // Positions belonging to the deviations keep their role, as they prove the sign.
        std::erase_if(m_result.values, [&](std::size_t c) {
            const bool goes = sortOf(c) != kept;
            if (goes && !(kept == 0 && role(c) == ColumnRole::actual))
                role(c) = ColumnRole::ignored;
            return goes;
        });
        takeContent(kept);
    }

    void takeContent(std::size_t kept) {
        m_result.content = kept == 0 ? "deviations" : kept == 1 ? "positions" : "";
    }

    void keepOneUnit() {
        std::map<std::string, std::size_t> counts;
        for (const std::size_t c : m_result.values) {
            if (const SaidUnit said = m_heads[c].said(); said.isSaid())
                ++counts[said.words()];
        }
        if (counts.empty())
            return;
        for (const std::size_t c : m_result.values) {
            const SaidUnit said = m_heads[c].said();
            if (said.isSaid() &&
                (!m_result.unit.isSaid() || counts[said.words()] > counts[m_result.unit.words()]))
                m_result.unit = said;
        }
        if (counts.size() < 2)
            return;
        ask({REPORT_TEXT("report", "Columns: the readings have different units; those in %1 are read."),
             {excerpt(m_result.unit.words())}});
        setAside([&](std::size_t c) { return m_heads[c].said() == m_result.unit; });
    }

    /// Runs of one kind have the same words; an unknown word makes another kind.
    void keepOneStem() {
        const auto stemOf = [&](std::size_t c) {
            const std::size_t letters = words(c).hint ? 1 : 0; // "1A" next to "1R"
            return words(c).group + (words(c).unknownWords > letters ? words(c).stem : std::string());
        };
        std::map<std::string, std::size_t> counts;
        for (const std::size_t c : m_result.values)
            ++counts[stemOf(c)];
        if (counts.size() < 2)
            return;
        std::string kept;
        if (!counts.contains(kept)) {
            for (const std::size_t c : m_result.values) {
                if (kept.empty() || counts[stemOf(c)] > counts[kept])
                    kept = stemOf(c);
            }
            ask({REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                       "“%1” are read, the others are not."),
                 {excerpt(kept)}});
        }
        setAside([&](std::size_t c) { return stemOf(c) == kept; });
    }

    /// Among columns with a direction, one without is not a run, unless a column of directions gives it.
    void keepDirected() {
        const auto isDirected = [&](std::size_t c) { return words(c).direction || words(c).hint; };
        const auto directed = std::ranges::count_if(m_result.values, isDirected);
        if (directed > 0 && static_cast<std::size_t>(directed) < m_result.values.size()) {
            for (const std::size_t c : m_result.values) {
                if (!isDirected(c))
                    ask({REPORT_TEXT("report",
                                     "Columns: “%1” names no direction as the others do; it is not read."),
                         {excerpt(m_heads[c].heading)}});
            }
            setAside(isDirected);
        }
        // A column without number among numbered runs: "Run 1", "Run 2", "Deviation".
        const auto isNumbered = [&](std::size_t c) { return words(c).number.has_value(); };
        const auto numbered = std::ranges::count_if(m_result.values, isNumbered);
        if (numbered > 1 && static_cast<std::size_t>(numbered) < m_result.values.size()) {
            ask({REPORT_TEXT("report",
                             "Columns: some readings name no run as the others do; they are not read.")});
            setAside(isNumbered);
        }
    }

    /// A column with a number or direction and the unit of readings is very likely a run.
    void askForRuns() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const bool isOfAxis =
                m.axisFound.empty() || words(c).axis == 0 || words(c).axis == m.axisFound[0];
            const Meaning meaning = m_heads[c].meaning;
            const bool isOther = meaning == Meaning::statistic || meaning == Meaning::other ||
                                 meaning == Meaning::index || meaning == Meaning::target;
            const bool isOfState = words(c).state == TestRole::notStated || words(c).state == m.stateFound;
            if (isNumeric(c) && role(c) == ColumnRole::ignored && isOfAxis && isOfState && !isOther &&
                (m_heads[c].said() == m_result.unit || !m_heads[c].unit) &&
                (words(c).number || words(c).direction || words(c).hint))
                ask({REPORT_TEXT("report", "Columns: “%1” may be a run like the others; it is not read."),
                     {excerpt(m_heads[c].heading)}});
        }
    }
};

} // namespace

void keepReadingsOfOneKind(ColumnSearch &search) {
    KindsOfReadings(search).keep();
}

} // namespace palmer
