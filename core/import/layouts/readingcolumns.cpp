// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"

#include "document/place.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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
    using ColumnStep::ColumnStep;

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
        ask(REPORT_TEXT("report", "Columns: nothing says what they hold, and their numbers are of different "
                                  "size (about %1 to %2); give each its role."),
            Number{least, Quantity::number}, Number{largest, Quantity::number});
        m_search.hasProposal = false;
    }

    /// No heading names the readings: takes the remaining columns as runs.
    void takeUnnamed() {
        bool named = false;
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const bool unknown =
                isOneOf(m_heads[c].meaning, {Meaning::unknown, Meaning::x, Meaning::y, Meaning::axis});
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
            ask(REPORT_TEXT("report", "Columns: the headings do not say which hold readings; “%1” and those "
                                      "like it are read as runs."),
                excerpt(m_heads[m_result.values.front()].heading));
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
        ask(REPORT_TEXT("report",
                        "Columns: some hold positions and some deviations; the deviations are read."));
    }

    /// Asks for columns headed as readings that contain words: "(1.2)", "1.2 µm".
    void askForWords() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const Meaning meaning = m_heads[c].meaning;
            const bool isNamed = words(c).direction ||
                                 isOneOf(meaning, {Meaning::deviation, Meaning::actual, Meaning::reading});
            const ColumnKind kind = m_heads[c].kind;
            const bool holdsWords =
                kind == ColumnKind::words || kind == ColumnKind::clock || kind == ColumnKind::dates;
            if (holdsWords && isNamed && meaning != Meaning::direction)
                ask(REPORT_TEXT("report",
                                "Columns: “%1” is headed as readings, but holds words; it is not read."),
                    excerpt(m_heads[c].heading));
            // The readings after it would be read at the targets before it.
            const bool hasNone = kind == ColumnKind::words || kind == ColumnKind::empty;
            const bool isBeforeReadings = m_result.target && c > *m_result.target &&
                                          !m_result.values.empty() && c < m_result.values.back();
            if (meaning == Meaning::target && hasNone && isBeforeReadings)
                ask(REPORT_TEXT(
                        "report",
                        "Columns: “%1” is headed as target positions, but holds none; it is not read."),
                    excerpt(m_heads[c].heading));
        }
    }

    /// Asks for a column of numbers without a heading among others that have one.
    void askForUntitled() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (m_heads[c].isSpread && m_result.columns[c].hasReadings())
                assume(REPORT_TEXT("report",
                                   "Columns: “%1” is read as the heading of the columns without one "
                                   "behind it, too."),
                       excerpt(m_heads[c].heading));
            if (isNumeric(c) && role(c) == ColumnRole::ignored && m_heads[c].heading.empty() &&
                !isCounter(m, c))
                ask(REPORT_TEXT("report", "Columns: column %1 has numbers and no heading; it is not read."),
                    counted(c + 1));
        }
    }
};

class KindsOfReadings : ColumnStep {
public:
    using ColumnStep::ColumnStep;

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
        if (isEither && m.choices.isChosen("columns"))
            return;
        if (isEither) {
            m.stateFound = resolveState(m);
            return setAside([this](std::size_t c) { return words(c).state == m.stateFound; });
        }
        const auto stated = std::ranges::find_if(
            m_result.values, [&](std::size_t c) { return words(c).state != TestRole::notStated; });
        if (stated != m_result.values.end())
            m.stateFound = statedState(m, words(*stated).state, m_heads[*stated].heading);
    }

    /// "1A" next to "1R" is not an axis A.
    [[nodiscard]] bool isLetterHint(std::size_t c) const {
        return words(c).hint && (words(c).axis == 'A' || words(c).axis == 'B');
    }

    /// "Reading 1 (mm)", "Encoder (mm)" beside "Error 1 (µm)": what follows the targets is a position.
    void takePositions() {
        const auto isDeviation = [this](std::size_t c) { return role(c) == ColumnRole::deviation; };
        if (std::ranges::none_of(m_result.values, isDeviation))
            return;
        for (const std::size_t c : m_result.values) {
            if (role(c) == ColumnRole::run && followsTarget(c))
                role(c) = ColumnRole::actual;
        }
    }

    void keepOneRole() {
        takePositions();
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
            ask(REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                      "“%1” are read, the others are not."),
                excerpt(m_heads[*std::ranges::find_if(m_result.values, [&](std::size_t c) {
                            return sortOf(c) == kept;
                        })].heading));
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
        ask(REPORT_TEXT("report", "Columns: the readings have different units; those in %1 are read."),
            excerpt(m_result.unit.words()));
        setAside([&](std::size_t c) { return m_heads[c].said() == m_result.unit; });
    }

    /// Runs of one kind have the same words; an unknown word makes another kind.
    void keepOneStem() {
        const auto stemOf = [&](std::size_t c) {
            const std::size_t letters = words(c).hint ? 1 : 0; // "1A" next to "1R"
            // Readings of another day are another test; so may be "Fwd A" and "Fwd B".
            const bool isLettered = words(c).direction && words(c).axis >= 'A' && words(c).axis <= 'C';
            return words(c).group + (words(c).unknownWords > letters ? words(c).stem : std::string()) +
                   (isLettered ? std::string(1, words(c).axis) : std::string()) +
                   isoDate(m_heads[c].heading).value_or(std::string());
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
            ask(REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                      "“%1” are read, the others are not."),
                excerpt(kept));
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
                    ask(REPORT_TEXT("report",
                                    "Columns: “%1” names no direction as the others do; it is not read."),
                        excerpt(m_heads[c].heading));
            }
            setAside(isDirected);
        }
        // A column without number among numbered runs: "Run 1", "Run 2", "Deviation".
        const auto isNumbered = [&](std::size_t c) { return words(c).number.has_value(); };
        const auto numbered = std::ranges::count_if(m_result.values, isNumbered);
        if (numbered > 1 && static_cast<std::size_t>(numbered) < m_result.values.size()) {
            ask(REPORT_TEXT("report",
                            "Columns: some readings name no run as the others do; they are not read."));
            setAside(isNumbered);
        }
    }

    /// A column with a number or direction and the unit of readings is very likely a run.
    void askForRuns() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const bool isOfAxis =
                m.axisFound.empty() || words(c).axis == 0 || words(c).axis == m.axisFound[0];
            const bool isOther = isOneOf(
                m_heads[c].meaning, {Meaning::statistic, Meaning::other, Meaning::index, Meaning::target});
            const bool isOfState = words(c).state == TestRole::notStated || words(c).state == m.stateFound;
            if (isNumeric(c) && role(c) == ColumnRole::ignored && isOfAxis && isOfState && !isOther &&
                (m_heads[c].said() == m_result.unit || !m_heads[c].unit) &&
                (words(c).number || words(c).direction || words(c).hint))
                ask(REPORT_TEXT("report", "Columns: “%1” may be a run like the others; it is not read."),
                    excerpt(m_heads[c].heading));
        }
    }
};

class SignOfColumns : ColumnStep {
public:
    using ColumnStep::ColumnStep;

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
            ask(REPORT_TEXT("report",
                            "Columns: the deviations are not the differences of actual and target positions; "
                            "the deviations are read."));
    }
};

} // namespace

void findReadings(ColumnSearch &search) {
    ReadingColumns(search).findValues();
}

void keepReadingsOfOneKind(ColumnSearch &search) {
    KindsOfReadings(search).keep();
}

void takeDirectionsOfHeadings(ColumnSearch &search) {
    SignOfColumns(search).takeHints();
}

void proveSign(ColumnSearch &search) {
    SignOfColumns(search).proveSign();
}

} // namespace palmer
